#include <algorithm>

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
}  // namespace

template <int Dim>
void evaluate_faces(const Entities<Dim>& entities, std::span<const FaceCandidate> candidates,
                    const Section& section, std::vector<ContactRecord<Dim>>& records) {
  std::array<CommonPlane<Dim>, 4> planes;
  for (const auto& candidate : candidates) {
    const auto lower = static_cast<std::size_t>(candidate.lower);
    const auto upper = static_cast<std::size_t>(candidate.upper);
    if (!entities.reaches[lower].meets(entities.reaches[upper])) continue;
    const int n =
        common_planes<Dim>(entities.planes[lower], entities.planes[upper], section, planes);
    for (int i = 0; i < n; ++i) {
      const auto& plane = planes[static_cast<std::size_t>(i)];
      if (plane.penetration > candidate.limit) continue;
      records.push_back(record_of(entities, candidate, plane));
      records.back().ordinal = static_cast<std::uint32_t>(i);
    }
  }
}

template void evaluate_faces<2>(const Entities<2>&, std::span<const FaceCandidate>, const Section&,
                                std::vector<ContactRecord<2>>&);
template void evaluate_faces<3>(const Entities<3>&, std::span<const FaceCandidate>, const Section&,
                                std::vector<ContactRecord<3>>&);

}  // namespace brunt
