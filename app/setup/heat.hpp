#pragma once
/// Which bodies are heated, and how: what the deck's `heat` means for each of them.
#include "app/deck/deck.hpp"

namespace brunt {

enum class HeatMode {
  none,       ///< no temperature is kept, or only that of time 0 where it depends on the place
  adiabatic,  ///< its own work heats the point where it is done, and stays there
  conducts,   ///< nodes and particles have a temperature, heat flows between them
};

/// `off`: none. `adiabatic`: where the material is thermal, and yields or has an equation of state
/// with an energy. `conduct`: conduction where the material has k, else as adiabatic. `auto`:
/// conduction where the material has k and a boundary or a contact heats or cools the body, or its
/// temperature at time 0 depends on the place, else as adiabatic: within a body of one temperature
/// nothing else drives heat but its own work, which hardly moves in the time of an impact.
HeatMode heat_mode(const Deck& deck, const deck::Body& body, const std::string& name);

/// True where a body that conducts never moves: `fix` holds all components of all of it for ever.
bool is_held(const Deck& deck, const std::string& name);

/// Why a body cannot be heated as its deck says, "" where nothing is wrong.
std::string heat_problem(const deck::Body& body, const std::string& name);

/// True for a rigid body whose surface is held at the temperature of its motion.
bool is_heated_surface(const Deck& deck, const deck::Body& body);

/// True where a boundary prescribes temperatures or heat.
bool acts_on_heat(const deck::Boundary& boundary);

/// Which bodies of one method share a group: those that conduct are apart from the others, and
/// those of them that never move too, whose mechanics nobody computes. Rigid bodies that conduct
/// are finite elements of heat alone, and those that follow their forces are apart.
struct GroupKind {
  bool conducts = false, held = false;
  bool rigid = false;  ///< only its heat is computed; else it deforms
  bool free =
      false;  ///< it is rigid and follows its forces; else it is held or has a prescribed motion
  bool operator==(const GroupKind&) const = default;
};
GroupKind group_kind(const Deck& deck, const deck::Body& body, const std::string& name);
/// Whether no body deforms, follows its forces or conducts heat.
void check_anything_is_computed(const LoadedDeck& loaded, std::vector<DeckProblem>& problems);
inline constexpr GroupKind kGroupKinds[] = {{false, false}, {true, false}, {true, true}};
inline constexpr GroupKind kFreeConductors{true, true, true, true};
inline constexpr GroupKind kRigidConductors{true, true, true};

}  // namespace brunt
