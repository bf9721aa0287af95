/// Where what is tied holds: places of time 0.
#include <algorithm>
#include <cmath>

#include "contact/evaluate/ties.hpp"
#include "contact/geometry/bilinear_weights.hpp"

namespace brunt {

namespace {
/// Faces with a gap of this part of their size touch at time 0: those of round bodies lie so far
/// off each other.
constexpr Real kTiedGap = 0.01;

/// Weights of a face's corners for a point of the common plane.
std::array<Real, 4> weights_at(const FacePlane<3>& face, const CommonPlane<3>& plane,
                               const Vec<2>& p, bool reverse) {
  std::array<Vec<2>, 4> corner;
  const auto n = slot_of(face.n_corners);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 arm = face.corner[reverse ? n - 1 - k : k] - plane.origin;
    corner[k] = Vec<2>(arm.dot(plane.axis_1), arm.dot(plane.axis_2));
  }
  std::array<Real, 4> weight{};
  if (n == 4) {
    weight = bilinear_weights(corner, p);
  } else {
    const Vec<2> a = corner[1] - corner[0], b = corner[2] - corner[0], r = p - corner[0];
    const Real twice = a[0] * b[1] - a[1] * b[0];
    weight[1] = (r[0] * b[1] - r[1] * b[0]) / twice;
    weight[2] = (a[0] * r[1] - a[1] * r[0]) / twice;
    weight[0] = 1 - weight[1] - weight[2];
  }
  if (reverse) std::reverse(weight.begin(), weight.begin() + static_cast<std::ptrdiff_t>(n));
  return weight;
}
std::array<Real, 4> weights_at(const FacePlane<2>& face, const CommonPlane<2>& plane,
                               const Vec<2>& p, bool) {
  const Real from = plane.axis_1.dot(face.corner[0] - plane.origin);
  const Real to = plane.axis_1.dot(face.corner[1] - plane.origin);
  const Real share = (p[0] - from) / (to - from);
  return {1 - share, share, 0, 0};
}

/// visit(p, area) of a rule of the second degree over the overlap.
template <class Visit>
void visit_places(const CommonPlane<3>& plane, const Section&, const Visit& visit) {
  const auto& polygon = plane.polygon;
  for (int i = 2; i < polygon.size; ++i) {
    const Vec<2>&a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const Vec<2> u = b - a, w = c - a;
    const Real area = 0.5 * (u[0] * w[1] - u[1] * w[0]);
    const Vec<2> sum = a + b + c;
    for (const auto* corner : {&a, &b, &c}) visit(Vec<2>(sum / 6 + *corner / 2), area / 3);
  }
}
template <class Visit>
void visit_places(const CommonPlane<2>& plane, const Section& section, const Visit& visit) {
  const Real from = plane.polygon[0][0], to = plane.polygon[1][0];
  const Real middle = 0.5 * (from + to), half = 0.5 * (to - from) / std::sqrt(3.0);
  for (const Real s : {middle - half, middle + half}) {
    const Real r = plane.origin[0] + s * plane.axis_1[0];
    visit(Vec<2>(s, 0), 0.5 * (to - from) * section.breadth(r));
  }
}
}  // namespace

template <int Dim>
void begin_face_ties(const Entities<Dim>& entities, const FaceCandidate& candidate,
                     const Section& section, typename Records<Dim>::Part& part) {
  const auto& options = *candidate.laws.holds;
  const auto& bond = std::get<CohesiveBond>(options.bonds);
  if (!options.tied && !bond.acts()) return;
  const auto l = slot_of(candidate.lower);
  const auto u = slot_of(candidate.upper);
  const auto &lower = entities.planes[l], &upper = entities.planes[u];
  const Real size = meeting_distance(lower, upper) / kMeets;
  Planes<Dim> planes;
  const int n = common_planes<Dim>(lower, upper, section, planes, {.whole = true});
  TiePoint tie;
  tie.key = {ContactKind::face_face, 0, entities.faces[l].id, entities.faces[u].id};
  for (int i = 0; i < n; ++i) {
    const auto& plane = planes[slot_of(i)];
    if (plane.deepest > candidate.normal.limit || -plane.penetration > kTiedGap * size) continue;
    visit_places(plane, section, [&](const Vec<2>& p, Real area) {
      tie.lower = weights_at(lower, plane, p, false);
      tie.upper = weights_at(upper, plane, p, true);
      Vec<Dim> r = Vec<Dim>::Zero();
      for (int k = 0; k < upper.n_corners; ++k) {
        r += tie.upper[slot_of(k)] * upper.corner[slot_of(k)];
      }
      for (int k = 0; k < lower.n_corners; ++k) {
        r -= tie.lower[slot_of(k)] * lower.corner[slot_of(k)];
      }
      tie.gap = r.dot(plane.normal);
      tie.area = area;
      part.face_ties.push_back(tie);
      ++tie.key.ordinal;
    });
  }
}

template <int Dim>
void begin_particle_ties(const Entities<Dim>& entities, const ContactParticle& particle,
                         PairFinder& pairs, Real area, typename Records<Dim>::Part& part) {
  const std::size_t first = part.particle_ties.size();
  for (const auto& hit : part.hits) {
    if (!hit.kept || !pairs.of(particle.body, hit.body).tied) continue;
    const bool nearest = std::none_of(part.hits.begin(), part.hits.end(), [&](const auto& other) {
      const bool before = &other < &hit ? other.nearest.distance <= hit.nearest.distance
                                        : other.nearest.distance < hit.nearest.distance;
      return other.kept && other.body == hit.body && before;
    });
    if (!nearest) continue;
    const auto& face = entities.faces[slot_of(hit.face)];
    const auto& x = entities.nodes.x[slot_of(particle.node)];
    TiePoint tie;
    tie.key = {ContactKind::particle_face, 0, particle.id, face.id};
    std::copy(hit.nearest.weight.begin(), hit.nearest.weight.end(), tie.lower.begin());
    tie.upper[0] = 1;
    tie.gap = entities.planes[slot_of(hit.face)].normal.dot(x - hit.nearest.point);
    tie.area = area;
    part.particle_ties.push_back(tie);
  }
  std::sort(part.particle_ties.begin() + static_cast<std::ptrdiff_t>(first),
            part.particle_ties.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
}

template void begin_face_ties<2>(const Entities<2>&, const FaceCandidate&, const Section&,
                                 Records<2>::Part&);
template void begin_face_ties<3>(const Entities<3>&, const FaceCandidate&, const Section&,
                                 Records<3>::Part&);
template void begin_particle_ties<2>(const Entities<2>&, const ContactParticle&, PairFinder&, Real,
                                     Records<2>::Part&);
template void begin_particle_ties<3>(const Entities<3>&, const ContactParticle&, PairFinder&, Real,
                                     Records<3>::Part&);

}  // namespace brunt
// Tested by tests/unit/contact/ties_test.cpp.
