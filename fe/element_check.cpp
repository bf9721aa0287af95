#include "fe/element_check.hpp"

#include <cmath>

namespace brunt {

namespace {
/// "element 12", or "element 12, Gauss point 3" of several.
template <int Dim>
std::string entity_text(const ElementBlock<Dim>& block, LocalIndex e, int g) {
  std::string text = "element " + std::to_string(block.id[e]);
  if (g >= 0) text += ", Gauss point " + std::to_string(g + 1);
  return text;
}

/// Corners that are no finite number: none has a volume, and the corner is what can be named.
template <int Dim>
std::optional<PhysicsFailure> lost_corner(const ElementBlock<Dim>& block, LocalIndex e,
                                          const Points<Dim>& points, const std::string& advice) {
  for (const LocalIndex node : block.corners_of(e)) {
    if (std::isfinite(points.x[node].sum())) continue;
    return PhysicsFailure{0,
                          "",
                          entity_text(block, e, -1),
                          "corner without a finite position, id",
                          static_cast<Real>(points.id[node]),
                          "a force on it was no number in one of the last steps; " + advice};
  }
  return std::nullopt;
}
}  // namespace

template <int Dim>
std::string distortion_advice(const ElementBlock<Dim>& block) {
  std::string text = "the element is crushed, sheared or turned inside out: try ";
  ElementOptions q1p0;
  q1p0.integration = Integration::q1p0;
  const bool has_q1p0 = block.formulation->material_points(q1p0) > 1;
  if (has_q1p0 && block.options.integration != Integration::q1p0)
    text += "`element: {integration: q1p0}`, ";
  text += "finer or coarser elements there";
  if (!block.material->yields()) text += ", a `strength`, since this material never yields";
  return text + ", or `method: sph` where the material shall flow so far";
}

namespace {
/// What is infinite or no number wherever a stress of a material point is.
template <int Dim>
Real sum_of_stresses(const ElementBlock<Dim>& block, LocalIndex e, int g) {
  const std::size_t k = block.point(e, g);
  Real sum = block.viscous_pressure[e] + block.state.pressure[k];
  for (const auto& component : block.state.deviator) sum += component[k];
  return sum;
}
}  // namespace

template <int Dim>
bool has_finite_stress(const ElementBlock<Dim>& block, LocalIndex e) {
  for (int g = 0; g < block.gauss; ++g) {
    if (!std::isfinite(sum_of_stresses(block, e, g))) return false;
  }
  return true;
}

template <int Dim>
std::optional<PhysicsFailure> element_failure(const ElementBlock<Dim>& block, LocalIndex e,
                                              const Points<Dim>& points,
                                              const Thickness& thickness) {
  const auto x = corner_positions(block, e, points);
  const Formulation<Dim>& kind = *block.formulation;
  Real least = block.gauss == 1 ? kind.step_volume(x, thickness) : kind.volume(x, false, thickness);
  int where = -1;
  if (block.gauss > 1) {
    const PartVolumes parts = kind.part_volumes(x, thickness);
    for (int g = 0; g < block.gauss; ++g) {
      const Real part = parts.part[g];
      if (where < 0 || !(part >= least)) least = part, where = g;
    }
  }
  if (!std::isfinite(least)) return lost_corner(block, e, points, distortion_advice(block));
  if (!(least > 0)) {
    return PhysicsFailure{0,        "",    entity_text(block, e, where),
                          "volume", least, distortion_advice(block)};
  }
  for (int g = 0; g < block.gauss; ++g) {
    const Real sum = sum_of_stresses(block, e, g);
    if (std::isfinite(sum)) continue;
    return PhysicsFailure{
        0,
        "",
        entity_text(block, e, block.gauss > 1 ? g : -1),
        "stress",
        sum,
        "the step was too long for what the material did: try a smaller time.safety"};
  }
  return std::nullopt;
}

template bool has_finite_stress(const ElementBlock<2>&, LocalIndex);
template bool has_finite_stress(const ElementBlock<3>&, LocalIndex);
template std::string distortion_advice(const ElementBlock<2>&);
template std::string distortion_advice(const ElementBlock<3>&);
template std::optional<PhysicsFailure> element_failure(const ElementBlock<2>&, LocalIndex,
                                                       const Points<2>&, const Thickness&);
template std::optional<PhysicsFailure> element_failure(const ElementBlock<3>&, LocalIndex,
                                                       const Points<3>&, const Thickness&);

}  // namespace brunt
// Tested by tests/unit/fe/finite_elements_test.cpp.
