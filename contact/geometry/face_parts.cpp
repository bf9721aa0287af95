#include "contact/geometry/face_parts.hpp"

#include <algorithm>

#include "contact/geometry/gradient_number.hpp"

namespace brunt {

namespace {
using Number = GradientNumber<12>;
using Vector = std::array<Number, 3>;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// 0 up to x = low, 1 from high on, without a kink.
Number smooth_step(const Number& x, Real low, Real high) {
  if (x.value <= low) return Number(0.0);
  if (x.value >= high) return Number(1.0);
  const Number s = (x - Number(low)) * Number(1 / (high - low));
  return s * s * (Number(3.0) - Number(2.0) * s);
}
}  // namespace

WholePart whole_part(const FacePlane<3>& face) {
  std::array<Vector, 4> x;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      x[c][k] = variable<Number>(face.corner[c][static_cast<Eigen::Index>(k)],
                                 static_cast<int>(3 * c + k));
    }
  }
  const Vector twice = cross(x[2] - x[0], x[3] - x[1]);
  const Number size = root_of(dot(twice, twice)), area = Number(0.5) * size;
  const Number high = dot((x[0] - x[1]) - (x[3] - x[2]), twice) * Number(0.25) / size;
  const Number warp = high.value < 0 ? Number(0.0) - high : high;
  const Number width = root_of(area.value < face.area_start ? area : Number(face.area_start));
  Number part = Number(1.0) - smooth_step(warp / width, kWarpFrom, kWarpTo);
  for (std::size_t c = 0; c < 4; ++c) {
    const auto &at = x[c], &next = x[(c + 1) % 4], &after = x[(c + 2) % 4];
    const Number turn = dot(cross(next - at, after - next), twice) / (size * area);
    part = part * smooth_step(turn, kConvexLimit, kConvexFrom);
  }
  WholePart whole;
  whole.value = part.value;
  for (std::size_t c = 0; c < 4; ++c) {
    whole.slope[c] = Vec3(part.slope[3 * c], part.slope[3 * c + 1], part.slope[3 * c + 2]);
  }
  return whole;
}

FaceParts::FaceParts(const FacePlane<3>& face, bool both) : whole_(face) {
  part_.slope.fill(Vec3::Zero());
  const bool shared = both && face.between;
  if (face.simple && !shared) return;
  halves_ = split(face);
  first_ = shared ? 0 : 1, last_ = 3;
  if (shared) {
    part_ = whole_part(face);
  } else {
    part_.value = 0;
  }
}

}  // namespace brunt
