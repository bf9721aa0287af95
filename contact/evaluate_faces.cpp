#include <algorithm>
#include <cmath>

#include "contact/evaluate.hpp"

namespace brunt {

namespace {
/// Names the corners that share the force and returns their mean velocity [m/s].
template <int Dim>
Vec<Dim> add_corners(const ContactNodes<Dim>& nodes, const ContactFace<Dim>& face,
                     const std::array<Real, Facet<Dim>::kNodes>& weight, Real sign,
                     ContactRecord<Dim>& record) {
  Vec<Dim> velocity = Vec<Dim>::Zero();
  for (int c = 0; c < face.n_nodes; ++c) {
    const auto k = static_cast<std::size_t>(c);
    record.add(face.node[k], sign * weight[k]);
    velocity += weight[k] * nodes.v[static_cast<std::size_t>(face.node[k])];
  }
  return velocity;
}

template <int Dim>
ContactRecord<Dim> record_of(const Entities<Dim>& entities, const FaceCandidate& candidate,
                             const CommonPlane<Dim>& plane) {
  const auto& lower = entities.faces[static_cast<std::size_t>(candidate.lower)];
  const auto& upper = entities.faces[static_cast<std::size_t>(candidate.upper)];
  ContactRecord<Dim> record;
  record.first = lower.id, record.second = upper.id;
  record.lower_body = lower.body, record.upper_body = upper.body;
  record.normal = plane.normal;
  record.point = plane.point;
  record.area = plane.area;
  record.penetration = plane.penetration;
  const Vec<Dim> v_lower = add_corners(entities.nodes, lower, plane.lower_weight, -1, record);
  const Vec<Dim> v_upper = add_corners(entities.nodes, upper, plane.upper_weight, 1, record);
  const Real closing = (v_lower - v_upper).dot(plane.normal);
  record.spring = candidate.stiffness * plane.volume;
  record.damping = std::max(candidate.damping * plane.ramp * plane.area * closing, -record.spring);
  return record;
}
/// What a new contact takes over from those that its faces had, on the upper side [Pa].
template <int Dim>
Vec<Dim> inherited(const FaceTraction<Dim>& lower, const FaceTraction<Dim>& upper) {
  const Real area = lower.area + upper.area;
  if (!(area > 0)) return Vec<Dim>::Zero();
  return (upper.force - lower.force) / area;
}

template <int Dim>
void add_friction(const Entities<Dim>& entities, const FaceCandidate& candidate,
                  const CommonPlane<Dim>& plane, const Section& section, Real dt,
                  FrictionHistory<Dim>& history, typename Records<Dim>::Part& part) {
  const auto l = static_cast<std::size_t>(candidate.lower);
  const auto u = static_cast<std::size_t>(candidate.upper);
  auto& record = part.face_on_face.back();
  const int n_lower = entities.faces[l].n_nodes;
  const bool torques = section.geometry != Geometry::axisymmetric;
  FrictionStep<Dim> step;
  step.options = candidate.rubs;
  step.lower = {0, n_lower, torques && !entities.faces[l].rigid()};
  step.upper = {n_lower, record.n_nodes, torques && !entities.faces[u].rigid()};
  step.point = plane.middle;
  std::copy_n(plane.lower_at_middle.begin(), n_lower, step.weight.begin());
  std::copy_n(plane.upper_at_middle.begin(), record.n_nodes - n_lower,
              step.weight.begin() + n_lower);
  step.area = plane.ramp * plane.area;
  step.pressed = plane.area;
  step.stiffness = candidate.stiffness;
  step.damping = candidate.damping;
  step.dt = dt;
  step.before = history.of_faces(key_of(record));
  if (step.before == nullptr) {
    step.inherited = inherited(entities.tractions[l], entities.tractions[u]);
  }
  record.friction = static_cast<std::int32_t>(part.frictions.size());
  part.frictions.push_back(friction_of(entities.nodes, record, step));
  warm_faces(entities, candidate, step, part);
}
}  // namespace

template <int Dim>
void evaluate_faces(const Entities<Dim>& entities, std::span<const FaceCandidate> candidates,
                    const Section& section, const EvaluationStep& step,
                    FrictionHistory<Dim>* history, typename Records<Dim>::Part& part) {
  std::array<CommonPlane<Dim>, 4> planes;
  for (const auto& candidate : candidates) {
    const auto lower = static_cast<std::size_t>(candidate.lower);
    const auto upper = static_cast<std::size_t>(candidate.upper);
    if (!entities.reaches[lower].meets(entities.reaches[upper])) continue;
    const int n = common_planes<Dim>(entities.planes[lower], entities.planes[upper], section,
                                     planes, PlaneNeeds{candidate.rubs != nullptr, 0});
    const PartEnds ends{part.face_on_face.size(), part.face_heat.size()};
    for (int i = 0; i < n; ++i) {
      const auto& plane = planes[static_cast<std::size_t>(i)];
      if (plane.penetration > candidate.limit) continue;
      part.face_on_face.push_back(record_of(entities, candidate, plane));
      part.face_on_face.back().ordinal = plane.ordinal;
      if (candidate.rubs == nullptr || history == nullptr) continue;
      add_friction(entities, candidate, plane, section, step.dt, *history, part);
    }
    if (candidate.heat == nullptr) continue;
    add_face_heat<Dim>(entities, candidate, section, ends, part);
  }
}

template void evaluate_faces<2>(const Entities<2>&, std::span<const FaceCandidate>, const Section&,
                                const EvaluationStep&, FrictionHistory<2>*, Records<2>::Part&);
template void evaluate_faces<3>(const Entities<3>&, std::span<const FaceCandidate>, const Section&,
                                const EvaluationStep&, FrictionHistory<3>*, Records<3>::Part&);

}  // namespace brunt
