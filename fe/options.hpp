#pragma once
#include <optional>
#include <variant>

#include "core/schema.hpp"
#include "core/types.hpp"
#include "fe/elements/catalog.hpp"

namespace brunt {

/// automatic: q1p0 where the material flows at constant volume, as metals do, and nothing is said
/// of hourglass modes; else one point.
enum class Integration : int { one_point, q1p0, full, automatic };

/// Flanagan & Belytschko 1981 hourglass control of one-point elements: viscous or by stiffness.
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
/// Belytschko & Bindeman 1991, 1993: the strains of bending, at their elastic stiffness.
struct AssumedStrainHourglass {
  static constexpr const char* deck_name = "assumed_strain";
  static constexpr const char* deck_help =
      "bends right with few elements through a thickness; for elastic materials";
  Real coefficient = 1;
};
/// What suits the material: viscous 0.1 where it yields or flows, else assumed strain 1.
struct AutomaticHourglass {
  static constexpr const char* deck_name = "auto";
  static constexpr const char* deck_help =
      "viscous 0.1 where the material yields or is a fluid, else assumed_strain 1";
};
using Hourglass =
    std::variant<AutomaticHourglass, ViscousHourglass, StiffnessHourglass, AssumedStrainHourglass>;

struct BulkViscosity {
  Real linear = 0.06;
  Real quadratic = 1.44;
};

/// What becomes of nodes about which no element is left; sph: and of what the elements were.
enum class ErodeTo : int { points, nothing, sph };

/// An element goes where one of these holds.
struct ErodeWhen {
  bool damage = false;         ///< its material has failed: it carries nothing any more
  std::optional<Real> strain;  ///< [1] its equivalent plastic strain is at least that
  std::optional<Real> step;    ///< [s] its stable step is below that
  bool inverted = false;       ///< it, or a part of it, has no volume
  bool operator==(const ErodeWhen&) const = default;
};

/// The key `erode` of a deforming FE body.
struct Erosion {
  ErodeWhen when;
  ErodeTo to = ErodeTo::points;
  bool operator==(const Erosion&) const = default;
};

/// The key `element` of a deforming FE body, and `erode` beside it.
struct ElementOptions {
  int type = 0;  ///< its place in the catalogue of its geometry
  Integration integration = Integration::one_point;
  Hourglass hourglass;
  BulkViscosity bulk_viscosity;
  std::optional<Erosion> erosion;  ///< none: a failed element stays
  Real least_step = 0;             ///< [s] elements get mass up to this stable step; 0: none does
};

/// The integration that `options` stand for in a material that flows at constant volume, or not.
inline Integration resolved(const ElementOptions& options, bool flows) {
  if (options.integration != Integration::automatic) return options.integration;
  if (options.type != 0) return Integration::one_point;
  const bool free = std::holds_alternative<AutomaticHourglass>(options.hourglass);
  return flows && free ? Integration::q1p0 : Integration::one_point;
}

inline void describe(Schema&, AutomaticHourglass&) {}
inline void describe(Schema& s, ViscousHourglass& hourglass) {
  s.value(hourglass.coefficient, {"1", at_least(0), between(0, 0.2)}, "viscous coefficient");
}
inline void describe(Schema& s, StiffnessHourglass& hourglass) {
  s.value(hourglass.coefficient, {"1", at_least(0), between(0, 0.2)}, "stiffness coefficient");
}
inline void describe(Schema& s, AssumedStrainHourglass& hourglass) {
  s.value(hourglass.coefficient, {"1", at_least(0), between(0, 1)},
          "of the elastic stiffness of bending");
}
inline void describe(Schema& s, BulkViscosity& viscosity) {
  s.real({"linear", "linear coefficient of the artificial bulk viscosity"}, viscosity.linear,
         {"1", at_least(0), between(0, 1)});
  s.real({"quadratic", "quadratic coefficient, in compression only"}, viscosity.quadratic,
         {"1", at_least(0), between(0, 10)});
}
inline void describe(Schema& s, ErodeWhen& when) {
  s.flag({"damage", "where the material has failed and carries nothing any more"}, when.damage);
  s.real({"strain", "from this equivalent plastic strain on"}, when.strain,
         {"1", positive(), between(0.05, 10)});
  s.real({"step", "where its stable step is shorter"}, when.step,
         {"s", positive(), between(1e-12, 1e-5)});
  s.flag({"inverted", "where it, or a part of it, has no volume any more; else the run ends"},
         when.inverted);
  s.require(when.damage || when.strain || when.step || when.inverted, "",
            "needs one of damage, strain, step or inverted: what makes elements go");
}
inline void describe(Schema& s, Erosion& erosion) {
  static constexpr const char* kTo[] = {"points", "nothing", "sph"};
  s.any_of({"when", "what makes elements go: [damage, strain: 1.5, step: 1 ns, inverted]",
            Need::required},
           erosion.when);
  s.choice({"to",
            "what becomes of nodes that no element holds any more: points with their mass that "
            "still touch other bodies, or nothing; sph: those points, which carry on as particles "
            "what the elements were"},
           erosion.to, kTo);
}
inline void describe(Schema& s, ElementOptions& element) {
  s.section(s.geometry() == Geometry::three_d, "only for geometry: 3d", [&](Schema& solid) {
    solid.choice({"type", "kind of element: hexahedra, or what each of them is cut into"},
                 element.type, ElementCatalog<3>::names);
  });
  s.section(element.type == 0, "only for type: hex8", [&](Schema& box) {
    static constexpr const char* kIntegrations[] = {"one-point", "q1p0", "full", "auto"};
    box.choice({"integration",
                "points of integration: one, selectively reduced, or full; auto: q1p0 where the "
                "material flows as metals do and hourglass is left out, else one-point"},
               element.integration, kIntegrations);
    box.one_of({"hourglass", "what resists hourglass modes of one-point elements"},
               element.hourglass);
  });
  s.object({"bulk_viscosity", "artificial viscosity that spreads shocks"}, element.bulk_viscosity);
}

}  // namespace brunt
