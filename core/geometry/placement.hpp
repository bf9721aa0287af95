#pragma once
#include "core/geometry/mesh.hpp"

namespace brunt {

/// Values as a vector; what is not given is 0.
template <int Dim>
Vec<Dim> to_vector(const std::vector<Real>& values) {
  Vec<Dim> v = Vec<Dim>::Zero();
  for (std::size_t c = 0; c < values.size() && c < Dim; ++c) v[static_cast<int>(c)] = values[c];
  return v;
}

/// A right-handed frame: an origin, and columns u, v, axis. Shapes are made in it, then placed.
struct Frame3 {
  Vec3 origin = Vec3::Zero();
  Mat3 columns = Mat3::Identity();
  Vec3 place(const Vec3& local) const { return origin + columns * local; }
  Vec3 local(const Vec3& place) const { return columns.transpose() * (place - origin); }
};
Frame3 frame_along(const std::vector<Real>& origin, const std::vector<Real>& axis);

/// Turns and moves a point as the deck says.
template <int Dim>
Vec<Dim> placed(const BodyShape& shape, const Vec<Dim>& x);

template <int Dim>
void place_all(const BodyShape& shape, std::vector<Vec<Dim>>& points) {
  for (auto& x : points) x = placed<Dim>(shape, x);
}

}  // namespace brunt
