#include "core/geometry/placement.hpp"

#include <cmath>
#include <stdexcept>

namespace brunt {

Frame3 frame_along(const std::vector<Real>& origin, const std::vector<Real>& axis) {
  Frame3 frame;
  frame.origin = to_vector<3>(origin);
  Vec3 w = to_vector<3>(axis);
  if (!(w.norm() > 0)) throw std::invalid_argument("the axis has no length");
  w.normalize();
  // Along a coordinate axis the frame is a rotation of the coordinate axes, without rounding.
  int smallest = 0;
  for (int c = 1; c < 3; ++c) {
    if (std::fabs(w[c]) < std::fabs(w[smallest])) smallest = c;
  }
  Vec3 u = Vec3::Unit(smallest);
  if (std::fabs(w[2]) == 1) u = Vec3::UnitX();
  u -= u.dot(w) * w;
  u.normalize();
  frame.columns.col(0) = u;
  frame.columns.col(1) = w.cross(u);
  frame.columns.col(2) = w;
  return frame;
}

template <int Dim>
Vec<Dim> placed(const BodyShape& shape, const Vec<Dim>& x) {
  Vec<Dim> y = x;
  if (shape.rotate) {
    const Vec3 axis = Dim == 2 ? Vec3::UnitZ() : to_vector<3>(shape.rotate->axis).normalized();
    Vec3 arm = Vec3::Zero();
    const Vec<Dim> about = to_vector<Dim>(shape.rotate->about);
    arm.template head<Dim>() = x - about;
    y = about +
        (Eigen::AngleAxis<Real>(shape.rotate->angle, axis) * arm).eval().template head<Dim>();
  }
  return y + to_vector<Dim>(shape.translate);
}

template Vec<2> placed<2>(const BodyShape&, const Vec<2>&);
template Vec<3> placed<3>(const BodyShape&, const Vec<3>&);

}  // namespace brunt
