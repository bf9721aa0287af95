#pragma once
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "contact/law/heat_options.hpp"
#include "core/search/search.hpp"

namespace brunt {

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

/// The state on which friction may depend where two bodies slide, in the order of the names of its
/// expressions: T, yield, p, v.
struct Sliding {
  Real temperature = 0;          ///< [K] mean of the surfaces of both sides
  Real flow_stress = kInfinity;  ///< [Pa] of the softer side; infinite where neither yields
  Real pressure = 0;             ///< [Pa]
  Real speed = 0;                ///< [m/s] of slip
};

/// What bodies that overlap at time 0 feel of it.
enum class InitialOverlap : int { track, press };

/// What a pair of bodies may be given; a key not given comes from `default`.
struct PairOptions {
  bool ignore = false;
  Real stiffness = 0.5;             ///< phi: fraction of the springs of both sides in series
  Real damping = 0.1;               ///< zeta: fraction of critical
  std::optional<Varying> friction;  ///< coefficient [1]; none: 0
  std::optional<DecayingFriction> decaying{};  ///< instead of `friction`
  bool shear_limit = false;  ///< friction is never above flow stress / sqrt(3) of the softer side

  Real cohesion = 0;  ///< [Pa] shear strength without pressure of faces that touch at time 0
  Real tension = 0;   ///< [Pa] tensile strength of faces that touch at time 0
  InitialOverlap initial_overlap = InitialOverlap::track;
  /// Pressure, in weights of the body that rests, as far as which a soft layer lets it come to
  /// rest.
  Real resting_layer = 3;

  ContactHeat heat{};
  FrictionHeat friction_heat{};
  bool bonded = false;  ///< particles of both bodies share one SPH sum

  bool bonds() const { return cohesion > 0 || tension > 0; }

  bool passes_heat() const { return heat.index() != 0; }
  bool has_friction() const {
    if (bonds()) return true;
    if (decaying) return decaying->at_rest > 0;
    return friction && !(friction->is_constant() && friction->constant == 0);
  }
  /// True where friction depends on the temperature or the flow stress of what slides.
  bool needs_material() const {
    if (shear_limit && has_friction()) return true;
    if (!friction || decaying) return false;
    if (friction->over == Varying::Over::sliding)
      return friction->depends[0] || friction->depends[1];
    return friction->over == Varying::Over::temperature;
  }
  /// Coefficient of friction [1]. That of an expression may be anything: the caller looks at it.
  Real coefficient(const Sliding& at) const {
    if (decaying) return decaying->coefficient(at.speed);
    if (!friction) return 0;
    switch (friction->over) {
      case Varying::Over::nothing:
        return friction->constant;
      case Varying::Over::sliding:
        return friction->evaluate({at.temperature, at.flow_stress, at.pressure, at.speed});
      case Varying::Over::temperature:
        return friction->at(at.temperature);
      case Varying::Over::pressure:
        return friction->at(at.pressure);
      default:
        return friction->at(at.speed);
    }
  }
};

inline void describe(Schema& s, PairOptions& pair) {
  static constexpr const char* kLater[] = {"tied", "joint"};
  static constexpr const char* kInitialOverlap[] = {"track", "press"};
  static constexpr Varying::Over kFrictionOver[] = {
      Varying::Over::temperature, Varying::Over::slip_speed, Varying::Over::pressure,
      Varying::Over::sliding};
  s.flag({"ignore", "these bodies do not touch each other"}, pair.ignore);
  s.flag({"bonded", "particles of both bodies share one SPH sum, as those of one body"},
         pair.bonded);
  s.varying_or_law({"friction",
                    "coefficient of Coulomb friction; or a table; or an expression of T [K], mean "
                    "of both surfaces, yield [Pa], flow stress of the softer one, p [Pa] and v "
                    "[m/s], pressure and slip speed; or static, kinetic and decay"},
                   pair.friction, pair.decaying, {"1", at_least(0), between(0, 2)}, kFrictionOver);
  s.flag({"shear_limit", "friction is never above flow stress / sqrt(3) of the softer side"},
         pair.shear_limit);
  s.real({"stiffness", "fraction of the springs of both sides in series"}, pair.stiffness,
         {"1", positive(), between(0.01, 10)});
  s.real({"damping", "fraction of critical damping"}, pair.damping, {"1", between(0, 2)});
  s.real({"cohesion",
          "shear strength without pressure of faces that touch at time 0, until they slip or open"},
         pair.cohesion, {"Pa", at_least(0), between(0, 1e9)});
  s.real({"tension", "tensile strength of faces that touch at time 0, until they open"},
         pair.tension, {"Pa", at_least(0), between(0, 1e9)});
  s.choice({"initial_overlap",
            "bodies that overlap at time 0 feel it once they have opened (track) or at once "
            "(press)"},
           pair.initial_overlap, kInitialOverlap);
  s.real({"resting_layer",
          "pressure, in weights of the body that rests, up to which contact under gravity is soft "
          "and damped, so that bodies come to rest; none where it is 0, or damping is"},
         pair.resting_layer, {"1", at_least(0), between(0, 1000)});
  s.one_of({"heat", "whether heat passes between them where they touch"}, pair.heat);
  s.object({"friction_heat", "what becomes of the heat of friction"}, pair.friction_heat);
  s.later(kLater);
  s.require(!pair.ignore || !pair.bonded, "bonded", "stands beside ignore: keep one of them");
}

/// In scenes with more pairs of bodies than this, those of 45 bodies, history.csv has columns of
/// the pairs that the deck names alone: others would be half a million in 1,000 bodies.
inline constexpr std::size_t kMostReportedPairs = 1000;

/// Contact as the scene hands it to the manager: options resolved for each pair of body labels.
struct ContactOptions {
  std::vector<Real> gravity;                             ///< [m/s^2] as of the deck; empty: none
  PairOptions fallback;                                  ///< `default`
  std::map<std::pair<Label, Label>, PairOptions> pairs;  ///< keys with first <= second
  std::map<std::pair<Label, Label>, std::string> pair_names;
  std::set<std::pair<Label, Label>> turned;  ///< those whose name puts the second body first
  SearchMode search = SearchMode::grid;
  std::optional<Real> skin;  ///< [m]; none: tuned on counted work
  Real safety = 1;           ///< fraction of its step limits that a step is
};

}  // namespace brunt
