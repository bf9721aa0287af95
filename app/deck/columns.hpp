#pragma once
/// The columns of history.csv: the one place that says their names, units and meanings. Rows are
/// filled in their order by app/watch, measures read units here, and docs/columns.md is printed
/// from it.
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace brunt::deck {

/// In a pattern NAME is the deck's name of a body, pair, boundary, probe or section, AXIS one of x,
/// y, z, and FIELD a field of core/fields.hpp or a component of one.
struct ColumnInfo {
  const char* pattern;
  const char* unit;  ///< "": that of the field
  const char* meaning;
  bool whole = false;  ///< a whole number
};

inline constexpr std::array kHistoryColumns{
    ColumnInfo{"time", "s", "time at the end of the step"},
    ColumnInfo{"step", "1", "number of the step", true},
    ColumnInfo{"dt", "s", "time step"},
    ColumnInfo{"dt_body", "1", "number of the body that bounded the step, in deck order from 0",
               true},

    ColumnInfo{"energy.kinetic", "J", "kinetic energy of the scheme, by velocities of half steps"},
    ColumnInfo{"energy.internal", "J",
               "work of stresses that has not become heat, on thermal expansion left out"},
    ColumnInfo{"energy.plastic_heat", "J", "plastic work that has become heat"},
    ColumnInfo{"energy.hourglass", "J", "work of hourglass control and of the guard of shapes"},
    ColumnInfo{"energy.viscosity", "J", "work of artificial viscosity"},
    ColumnInfo{"energy.artificial_stress", "J", "work of the artificial stress of particles"},
    ColumnInfo{"energy.contact.spring", "J", "what contact springs and sticking friction hold"},
    ColumnInfo{"energy.contact.damping", "J", "dissipated by contact dampers"},
    ColumnInfo{"energy.contact.friction", "J", "heat of friction"},
    ColumnInfo{"energy.contact.pairs", "J",
               "work of contact forces that no spring holds and nothing dissipates"},
    ColumnInfo{"energy.boundary", "J", "minus the work of supports, motions and loads"},
    ColumnInfo{"energy.damping", "J", "dissipated by `damping`"},
    ColumnInfo{
        "energy.eroded", "J",
        "of eroded elements: work of stresses that was not heat, kinetic energy that went, and "
        "what springs of contact held on their faces"},
    ColumnInfo{"energy.expansion", "J", "minus the work of pressures on what heat has made expand"},
    ColumnInfo{"energy.integration", "J",
               "what changes of the time step and turning rigid bodies leave in kinetic energy"},
    ColumnInfo{"energy.total", "J", "sum of the columns above"},
    ColumnInfo{"energy.drift", "1", "change of the total since time 0, over the largest energy"},
    ColumnInfo{"energy.created", "J", "energy that no physics put in: artificial or numerical"},

    ColumnInfo{"momentum.AXIS", "kg m/s", "linear momentum of the scene"},

    ColumnInfo{"body.NAME.mass", "kg", "mass"},
    ColumnInfo{"body.NAME.position.AXIS", "m", "centre of mass"},
    ColumnInfo{"body.NAME.velocity.AXIS", "m/s", "velocity of the centre of mass"},
    ColumnInfo{"body.NAME.kinetic", "J", "kinetic energy"},
    ColumnInfo{"body.NAME.internal", "J", "work of stresses that has not become heat"},
    ColumnInfo{"body.NAME.hourglass", "J", "its share of `energy.hourglass`"},
    ColumnInfo{"body.NAME.heat", "J", "heat taken up since time 0"},
    ColumnInfo{"body.NAME.eroded", "1", "elements that have eroded, of a body with `erode`", true},
    ColumnInfo{"body.NAME.eroded_mass", "kg", "mass of these elements, at time 0"},
    ColumnInfo{"body.NAME.rotation.AXIS", "rad",
               "of a rigid body of one piece: axis times angle since time 0"},
    ColumnInfo{"body.NAME.spin.AXIS", "rad/s", "of a rigid body of one piece: angular velocity"},
    ColumnInfo{"body.NAME.force.AXIS", "N",
               "on a rigid body, of all that acts but its supports and its motion"},
    ColumnInfo{"body.NAME.torque.AXIS", "N m", "of the same, about the centre of mass"},

    ColumnInfo{"contact.NAME.force.AXIS", "N", "on the first body of the pair"},
    ColumnInfo{"contact.NAME.torque.AXIS", "N m",
               "on the first body, about the origin; none of axisymmetric scenes"},
    ColumnInfo{"contact.NAME.area", "m^2", "area under pressure"},
    ColumnInfo{"contact.NAME.heat_rate", "W", "heat across into the first body, less friction's"},
    ColumnInfo{"contact.NAME.friction_heat", "W", "heat of friction over the last step"},
    ColumnInfo{"contact.NAME.max_penetration", "m", "largest depth of an overlap"},
    ColumnInfo{"contact.NAME.planes", "1", "contacts that carry force", true},
    ColumnInfo{"contact.NAME.temperature.max", "K",
               "hottest of both sides, where something conducts; 0 without contact"},
    ColumnInfo{"contact.NAME.temperature.mean", "K", "mean of both sides over the area"},

    ColumnInfo{"boundary.NAME.reaction.AXIS", "N", "force of the support on what it holds"},
    ColumnInfo{"boundary.NAME.torque.AXIS", "N m", "of the reaction, about the origin"},
    ColumnInfo{"boundary.NAME.force.AXIS", "N", "resultant of the boundary's forces"},
    ColumnInfo{"boundary.NAME.heat_rate", "W", "heat that the boundary lets in"},

    ColumnInfo{"probe.NAME.FIELD", "", "the field at the probe"},

    ColumnInfo{"section.NAME.force.AXIS", "N",
               "of the material beyond the plane on that before it: tension positive"},
    ColumnInfo{"section.NAME.moment.AXIS", "N m", "of the same, about the origin"},

    ColumnInfo{"heat.stored", "J", "heat taken up by bodies that conduct, since time 0"},
    ColumnInfo{"heat.plastic", "J", "of that from plastic work"},
    ColumnInfo{"heat.compression", "J", "of that from compression and shocks"},
    ColumnInfo{"heat.friction", "J", "of that from friction"},
    ColumnInfo{"heat.boundary", "J", "of that through boundaries"},
    ColumnInfo{"heat.drift", "1", "stored heat less its sources, over the largest heat"},

    ColumnInfo{"state_hash", "1",
               "hash of the whole state, equal where runs are bit for bit: of the first row, of "
               "those of frames, of that of the end, and with `output: {state_hash: true}` of all; "
               "else 0"}};

constexpr const ColumnInfo& column_of_pattern(std::string_view pattern) {
  for (const ColumnInfo& info : kHistoryColumns) {
    if (pattern == info.pattern) return info;
  }
  throw std::logic_error("no column of history.csv has this pattern");
}

/// A pattern of the table; one that is not there does not compile.
struct ColumnPattern {
  const ColumnInfo* info;
  // NOLINTNEXTLINE(google-explicit-constructor): reads as the text that it checks
  consteval ColumnPattern(const char* pattern) : info(&column_of_pattern(pattern)) {}
};

/// The column of that name, by its pattern; null: history.csv has none such.
const ColumnInfo* column_info(std::string_view column);
/// SI unit of a column; "any" where that is not known.
const char* unit_of_column(std::string_view column);

}  // namespace brunt::deck
