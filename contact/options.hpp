#pragma once
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/schema.hpp"
#include "core/search/search.hpp"

namespace brunt {

/// The deck's `heat` of a pair: whether heat passes from body to body where they touch.
struct NoContactHeat {
  static constexpr const char* deck_name = "none";
  static constexpr const char* deck_help = "no heat passes";
};
struct PerfectContactHeat {
  static constexpr const char* deck_name = "perfect";
  static constexpr const char* deck_help = "both sides have the same temperature";
};
struct ContactConductance {
  static constexpr const char* deck_name = "conductance";
  static constexpr const char* deck_help = "heat passes by the difference of temperatures";
  Real per_area = 0;  ///< [W/m^2/K]
};
inline void describe(Schema&, NoContactHeat&) {}
inline void describe(Schema&, PerfectContactHeat&) {}
inline void describe(Schema& s, ContactConductance& heat) {
  s.value(heat.per_area, {"W/m^2/K", at_least(0), between(1, 1e8)},
          "heat through a square metre for a degree of difference");
}

/// Friction that falls from its value at rest to that of fast sliding.
///   mu = kinetic + (static - kinetic) exp(-decay |v|)
struct DecayingFriction {
  Real at_rest = 0;  ///< [1] `static`
  Real kinetic = 0;  ///< [1]
  Real decay = 0;    ///< [s/m]

  Real coefficient(Real speed) const {
    return kinetic + (at_rest - kinetic) * std::exp(-decay * speed);
  }
};

inline void describe(Schema& s, DecayingFriction& law) {
  constexpr Quantity kCoefficient{"1", at_least(0), between(0, 2)};
  s.real({"static", "coefficient at rest", Need::required}, law.at_rest, kCoefficient);
  s.real({"kinetic", "coefficient of fast sliding", Need::required}, law.kinetic, kCoefficient);
  s.real({"decay", "mu = kinetic + (static - kinetic) exp(-decay |v|)", Need::required}, law.decay,
         {"s/m", at_least(0), between(1e-4, 1e4)});
  s.require(law.kinetic <= law.at_rest, "kinetic",
            "must not be above static; friction that rises with speed is a table over slip_speed");
}

/// What a pair of bodies may be given; a key not given comes from `default`.
struct PairOptions {
  bool ignore = false;
  Real stiffness = 0.5;             ///< phi: fraction of the springs of both sides in series
  Real damping = 0.1;               ///< zeta: fraction of critical
  std::optional<Varying> friction;  ///< coefficient, constant or over speed or pressure; none: 0
  std::optional<DecayingFriction> decaying{};  ///< instead of `friction`

  std::variant<NoContactHeat, PerfectContactHeat, ContactConductance> heat{};
  bool bonded = false;  ///< particles of both bodies share one SPH sum

  bool passes_heat() const { return heat.index() != 0; }
  /// [W/m^2/K] through the contact, infinite where it is perfect.
  Real conductance() const {
    const auto* given = std::get_if<ContactConductance>(&heat);
    return given != nullptr ? given->per_area : passes_heat() ? kInfinity : 0.0;
  }
  bool rubs() const {
    if (decaying) return decaying->at_rest > 0;
    return friction && !(friction->is_constant() && friction->constant == 0);
  }
  /// Coefficient of friction at a slip speed [m/s] and a pressure [Pa].
  Real coefficient(Real speed, Real pressure) const {
    if (decaying) return decaying->coefficient(speed);
    if (!friction) return 0;
    if (friction->is_constant()) return friction->constant;
    return friction->at(friction->over == Varying::Over::pressure ? pressure : speed);
  }
};

inline void describe(Schema& s, PairOptions& pair) {
  static constexpr const char* kLater[] = {"tied",    "shear_limit", "cohesion",
                                           "tension", "joint",       "friction_heat"};
  static constexpr Varying::Over kFrictionOver[] = {Varying::Over::slip_speed,
                                                    Varying::Over::pressure};
  s.flag({"ignore", "these bodies do not touch each other"}, pair.ignore);
  s.flag({"bonded", "particles of both bodies share one SPH sum, as those of one body"},
         pair.bonded);
  s.varying_or_law({"friction",
                    "coefficient of Coulomb friction; or a table over slip_speed or pressure; or "
                    "static, kinetic and decay"},
                   pair.friction, pair.decaying, {"1", at_least(0), between(0, 2)}, kFrictionOver);
  s.real({"stiffness", "fraction of the springs of both sides in series"}, pair.stiffness,
         {"1", positive(), between(0.01, 10)});
  s.real({"damping", "fraction of critical damping"}, pair.damping, {"1", between(0, 2)});
  s.one_of({"heat", "whether heat passes between them where they touch"}, pair.heat);
  s.later(kLater);
  s.require(!pair.ignore || !pair.bonded, "bonded", "stands beside ignore: keep one of them");
}

/// Contact as the scene hands it to the manager: options resolved for each pair of body labels.
struct ContactOptions {
  PairOptions fallback;                                  ///< `default`
  std::map<std::pair<Label, Label>, PairOptions> pairs;  ///< keys with first <= second
  std::map<std::pair<Label, Label>, std::string> pair_names;
  SearchMode search = SearchMode::grid;
  std::optional<Real> skin;  ///< [m]; none: tuned on counted work
};

}  // namespace brunt
