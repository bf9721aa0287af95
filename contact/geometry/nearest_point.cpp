#include "contact/geometry/particle_face.hpp"

#include <cmath>

#include "contact/geometry/named_feature.hpp"
#include "contact/geometry/nearest_quads.hpp"
#include "contact/geometry/nearest_triangle.hpp"
#include "core/wide_lanes.hpp"

namespace brunt {

namespace {
/// Of a face without area: infinitely far.
void set_nowhere(NearestPoint<3>& nearest) {
  nearest.point.setZero(), nearest.normal.setZero();
  nearest.smooth = false;
}

Vec3 vector(const Place<Real>& p) { return {p.x, p.y, p.z}; }

/// nearest  out; fresh, as with all below
void find_on_triangle(const FacePlane<3>& face, const Vec3& x, NearestPoint<3>& nearest) {
  const auto& at = face.corner;
  const Place<Real> t[3] = {place(at[0]), place(at[1]), place(at[2])};
  const auto found = nearest_on(t, place(x));
  if (!(found.squared_distance < kInfinity)) return set_nowhere(nearest);
  nearest.distance = std::sqrt(found.squared_distance);
  nearest.point = vector(found.point);
  nearest.normal = vector(found.normal).normalized();
  nearest.weight = {found.weight.x, found.weight.y, found.weight.z, 0};
  const auto& w = found.weight;
  const unsigned zeros = (w.x == 0 ? 1U : 0U) | (w.y == 0 ? 2U : 0U) | (w.z == 0 ? 4U : 0U);
  const NamedFeature named = name_feature(zeros, {0, 1, 2});
  nearest.feature = named.feature;
  nearest.smooth = named.smooth;
  nearest.corner = {named.first, named.second};
}

void find_on_edge(const FacePlane<2>& face, const Vec<2>& x, NearestPoint<2>& nearest) {
  const Vec<2> edge = face.corner[1] - face.corner[0];
  const Real along = edge.dot(x - face.corner[0]) / edge.squaredNorm();
  const Real w = along <= 0 ? 0.0 : (along >= 1 ? 1.0 : along);
  nearest.weight = {1 - w, w};
  nearest.point = w == 1 ? face.corner[1] : Vec<2>(face.corner[0] + w * edge);
  nearest.distance = (x - nearest.point).norm();
  nearest.normal = face.normal;
  nearest.smooth = w != 0 && w != 1;
  if (!nearest.smooth) {
    nearest.feature = Feature::vertex;
    nearest.corner = {w == 0 ? 0 : 1, w == 0 ? 0 : 1};
  }
}
}  // namespace

template <int Dim>
NearestPoint<Dim> nearest_point(const FacePlane<Dim>& face, const Vec<Dim>& x) {
  NearestPoint<Dim> nearest;  // filled where the caller wants it
  if constexpr (Dim == 2) {
    find_on_edge(face, x, nearest);
  } else if (face.n_corners == 3) {
    find_on_triangle(face, x, nearest);
  } else {
    const NearQuery<3> query{&face, x};
    nearest_on_quads<Pack>(&query, 1, &nearest);
  }
  return nearest;
}

template <int Dim>
void nearest_points(std::span<const NearQuery<Dim>> of, NearestPoint<Dim>* nearest) {
  std::size_t i = 0;
  while (i < of.size()) {
    std::size_t quads = 0;
    if constexpr (Dim == 3) {
      while (i + quads < of.size() && of[i + quads].face->n_corners == 4) ++quads;
      const auto find = wide_lanes() ? nearest_on_quads<Wide> : nearest_on_quads<Pack>;
      if (quads > 0) find(&of[i], quads, nearest + i);
    }
    i += quads;
    if (i == of.size()) return;
    nearest[i] = nearest_point<Dim>(*of[i].face, of[i].x);
    ++i;
  }
}

template NearestPoint<2> nearest_point<2>(const FacePlane<2>&, const Vec<2>&);
template NearestPoint<3> nearest_point<3>(const FacePlane<3>&, const Vec<3>&);
template void nearest_points<2>(std::span<const NearQuery<2>>, NearestPoint<2>*);
template void nearest_points<3>(std::span<const NearQuery<3>>, NearestPoint<3>*);

}  // namespace brunt
// Tested by tests/unit/contact/particle_face_test.cpp.
