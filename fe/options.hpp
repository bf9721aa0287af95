#pragma once
#include <variant>

#include "core/types.hpp"

namespace brunt {

enum class Integration : int { one_point, q1p0, full };

/// Flanagan-Belytschko 1981 hourglass control of one-point elements.
struct ViscousHourglass {
  static constexpr const char* deck_name = "viscous";
  static constexpr const char* deck_help = "resists hourglass rates; for materials that yield";
  Real coefficient = 0.1;
};
struct StiffnessHourglass {
  static constexpr const char* deck_name = "stiffness";
  static constexpr const char* deck_help = "resists hourglass amplitudes; for elastic materials";
  Real coefficient = 0.05;
};
/// What the material asks for: viscous 0.1 where it yields, else stiffness 0.05.
struct AutomaticHourglass {
  static constexpr const char* deck_name = "auto";
  static constexpr const char* deck_help = "viscous 0.1 where the material yields, else stiffness 0.05";
};
using Hourglass = std::variant<AutomaticHourglass, ViscousHourglass, StiffnessHourglass>;

struct BulkViscosity {
  Real linear = 0.06;
  Real quadratic = 1.44;
};

/// The key `element` of a deforming FE body.
struct ElementOptions {
  Integration integration = Integration::one_point;
  Hourglass hourglass;
  BulkViscosity bulk_viscosity;
};

}  // namespace brunt
