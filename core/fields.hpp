#pragma once
/// The fields that bodies and contacts show in frames, pictures, measures and probes: the one place
/// that says their names, units and meanings. docs/columns.md is printed from it.
#include <array>
#include <string_view>

namespace brunt {

struct FieldInfo {
  const char* name;
  int components;  ///< 1, 3 or 6; of a key 4
  const char* unit;
  const char* meaning;
};

/// Of bodies, in the order of docs/deck.md: what `output.fields`, measures and probes may name.
inline constexpr std::array kFields{
    FieldInfo{"displacement", 3, "m", "position less that at time 0"},
    FieldInfo{"velocity", 3, "m/s", "at the end of the step"},
    FieldInfo{"acceleration", 3, "m/s^2", "at the end of the step"},
    FieldInfo{"force", 3, "N", "sum of all forces on the node or particle"},
    FieldInfo{"temperature", 1, "K",
              "of nodes and particles where the body conducts, of elements where it heats without"},
    FieldInfo{"stress", 6, "Pa", "Cauchy stress, tension positive"},
    FieldInfo{"pressure", 1, "Pa", "minus the mean stress, compression positive"},
    FieldInfo{"von_mises", 1, "Pa", "equivalent stress sqrt(3/2 s:s), s the deviator"},
    FieldInfo{"eps_p", 1, "1", "equivalent plastic strain, of materials that yield"},
    FieldInfo{"strain_rate", 1, "1/s", "equivalent plastic strain rate, of materials that yield"},
    FieldInfo{"plastic_volume", 1, "1", "volumetric plastic strain, of laws that have any"},
    FieldInfo{"opening", 1, "1", "volumetric strain beyond the tension that a law can bear"},
    FieldInfo{"damage", 1, "1", "share of the stress that is lost, of materials that fail"},
    FieldInfo{"porosity", 1, "1", "share of pores in the volume, of concrete with a cap"},
    FieldInfo{"tensile_strength", 1, "Pa", "tension that is left to bear, of concrete"},
    FieldInfo{"density", 1, "kg/m^3", "of the present volume"},
    FieldInfo{"piece", 1, "1", "number of the piece of its body, of bodies of several"},
    FieldInfo{"id", 1, "1", "number of the node, element or particle, the same on any ranks"}};

/// Of bodies of particles, in frames alone.
inline constexpr FieldInfo kRadiusField{"radius", 1, "m", "of a particle: half the spacing"};

/// Of bodies, in frames alone, and there only where `output.fields` names it: results of a run, its
/// measures and its probes do not know how many ranks it has.
inline constexpr FieldInfo kOwnerField{
    "rank", 1, "1",
    "number of the rank that has the node, element or particle, where it is asked for"};

/// Of the common planes and particle contacts of a frame.
inline constexpr std::array kContactFields{
    FieldInfo{"normal", 3, "1",
              "unit normal of the common plane, from the first to the second body"},
    FieldInfo{"pressure", 1, "Pa", "normal force over the area of the contact"},
    FieldInfo{"penetration", 1, "m", "depth of the overlap"},
    FieldInfo{"bonded", 1, "1", "1 where a bond, a tie or an unbroken joint holds, else 0"},
    FieldInfo{"max_closure", 1, "m",
              "largest closure of a joint since time 0, of those with a largest one; else 0"},
    FieldInfo{"force", 3, "N", "of the contact on the second body, friction included"},
    FieldInfo{"body_a", 1, "1", "number of the first body, in the order of the deck from 0"},
    FieldInfo{"body_b", 1, "1", "number of the second body"}};

/// What files of several ranks have besides, to join their pieces.
inline constexpr std::array kRankFields{
    FieldInfo{"vtkGhostType", 1, "1", "of points: 1 where another piece has the original"},
    FieldInfo{"key", 4, "1", "of contacts: kind, numbers of both sides, number of the plane"}};

/// The description of a field of bodies, or of contacts where no body has it; null: unknown.
constexpr const FieldInfo* field_info(std::string_view name) {
  for (const FieldInfo& info : kFields) {
    if (name == info.name) return &info;
  }
  for (const FieldInfo& info : kContactFields) {
    if (name == info.name) return &info;
  }
  return nullptr;
}

}  // namespace brunt
// Tested by tests/cli/columns.sh.
