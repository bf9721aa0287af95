#include "contact/geometry/overlap_push.hpp"

#include <cmath>

#include "contact/geometry/overlap_gradient.hpp"
#include "core/simd.hpp"

namespace brunt {

namespace {
/// A smooth step over 0 .. 1 and its slope.
struct Step {
  explicit Step(Real at) {
    const Real s = std::clamp(at, 0.0, 1.0);
    value = s * s * (3 - 2 * s);
    slope = 6 * s * (1 - s);
  }
  Real value, slope;
};

/// v: 1 up to rho = 1, then 1/(1 + (rho - 1)^2): the energy of sides that are deep over a low
/// height a falls as a^3, whatever their depth, so that no edge feels a step where it comes in
/// beside them. A second fade from 5 to 10 ends them, and one by the depth and from 3 to 5, before
/// they are let go as too deep.
struct Fading {
  Real value = 1, by_rho = 0, by_depth = 0;
};
/// depth  mean one over that at which the faces let go
Fading fades(Real rho, Real depth) {
  constexpr Real kLast = 5, kLow = 3, kLowest = 5, kDeep = 0.4, kTooDeep = 0.8;
  const Real u = std::max(rho - 1, 0.0), v = 1 / (1 + u * u);
  const Step last(rho / kLast - 1), low((rho - kLow) / (kLowest - kLow)),
      deep((depth - kDeep) / (kTooDeep - kDeep));
  const Real w = 1 - last.value, z = 1 - low.value * deep.value;
  return {v * w * z,
          -2 * u * v * v * w * z - v * last.slope / kLast * z -
              v * w * low.slope / (kLowest - kLow) * deep.value,
          -v * w * low.value * deep.slope / (kTooDeep - kDeep)};
}

/// How far two borders oppose each other, by kappa: its square, and wholly within 14 degrees, since
/// what the rest of an angle would leave of an overlap that is deep is no less than what its faces
/// hold.
struct Opposing {
  explicit Opposing(Real kappa) {
    constexpr Real kNearly = 0.9, kWhole = 0.97;
    const Step whole((kappa - kNearly) / (kWhole - kNearly));
    const Real rest = 1 - kappa * kappa;
    value = kappa * kappa + rest * whole.value;
    slope = 2 * kappa * (1 - whole.value) + rest * whole.slope / (kWhole - kNearly);
  }
  Real value, slope;
};

/// How much of the force between two borders the potential has, for what they ask.
/// steep  kappa^2 rho
Real share_between(Real steep, Real filled) {
  constexpr Real kShallow = 0.005, kSteep = 0.05;
  const Real deep = std::clamp((steep - kShallow) / (kSteep - kShallow), 0.0, 1.0);
  return deep * filled * filled * (3 - 2 * filled);
}

/// Adds the gradient by a face's normal, d = (dU/dn) / k, at its corners: n = D/|D|.
BRUNT_INLINE void add_turn(const FacePlane<3>& face, const Vec3& d, std::array<Vec3, 4>& gradient) {
  const auto& x = face.corner;
  const Vec3 w = (d - face.normal.dot(d) * face.normal) / (2 * face.area);
  if (face.n_corners == 3) {  // D = (x1 - x0) x (x2 - x0)
    const Vec3 of_1 = (x[2] - x[0]).cross(w), of_2 = w.cross(x[1] - x[0]);
    gradient[0] -= of_1 + of_2;
    gradient[1] += of_1;
    gradient[2] += of_2;
    return;
  }
  const Vec3 of_02 = (x[3] - x[1]).cross(w);  // D = (x2 - x0) x (x3 - x1)
  const Vec3 of_13 = w.cross(x[2] - x[0]);
  gradient[0] -= of_02, gradient[2] += of_02;
  gradient[1] -= of_13, gradient[3] += of_13;
}

void add_turn(const FacePlane<2>& face, const Vec<2>& d, std::array<Vec<2>, 2>& gradient) {
  const Vec<2> w = (d - face.normal.dot(d) * face.normal) / face.area;
  const Vec<2> of_1(-w[1], w[0]);  // D = (e_y, -e_x), e = x1 - x0
  gradient[0] -= of_1;
  gradient[1] += of_1;
}

/// What the outline does where the plane turns: a corner at height h moves by -h dn in it.
template <int Dim>
BRUNT_INLINE Vec<Dim> turn_of_outline(
    const FacePlane<Dim>& face, const CommonPlane<Dim>& plane,
    const std::array<Vec<Dim>, CommonPlane<Dim>::kCorners>& by_place) {
  Vec<Dim> sum = Vec<Dim>::Zero();
  for (int i = 0; i < face.n_corners; ++i) {
    const auto k = slot_of(i);
    sum -= plane.normal.dot(face.corner[k] - plane.origin) * by_place[k];
  }
  return sum;
}
}  // namespace

template <int Dim>
void BorderFade<Dim>::add(int lower, int upper, Real facing, const Room& room) {
  if (!(facing > 0)) return;
  constexpr Real kNothing = 1e-12;  // less is a rest of rounding, by which nothing is divided
  const Opposing opposing(facing);
  const Real rho = room.size > 0 ? room.volume / room.size : kInfinity;
  const Real depth = room.volume / (room.area * room.limit);
  const Fading fading = fades(rho, depth);
  const Real value = 1 - opposing.value * (1 - fading.value);
  if (value < kNothing) {
    factor = 0;
    return;
  }
  share = std::max(share, share_between(facing * facing * std::min(rho, 1.0), room.filled));
  if (fading.value < 1) {
    // Where nothing is left of v nothing can be divided by the room, which may be none.
    const bool ends = fading.value == 0;
    const Real slope = ends ? 0.0 : opposing.value * fading.by_rho / (value * room.size);
    const Real deeper = opposing.value * fading.by_depth / (value * room.area * room.limit);
    by_volume += slope + deeper;
    by_area -= deeper * room.volume / room.area;
    pair[slot_of(n++)] = {lower, upper, ends ? 0.0 : -slope * rho,
                          -opposing.slope * (1 - fading.value) / value};
  }
  factor *= value;
}

template <int Dim>
void finish(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, Real opening, Real share,
            OverlapGradient<Dim>& gradient, CommonPlane<Dim>& plane) {
  const Real c = plane.half_cosine();
  const Vec<Dim> outlines = gradient.by_normal + turn_of_outline(lower, plane, gradient.lower) +
                            turn_of_outline(upper, plane, gradient.upper);
  // By n = (n_l - n_u) / 2c, and by c itself in what of G is no distance of the faces.
  const Vec<Dim> by_plane = outlines / (2 * c) + 0.5 * gradient.push * opening * plane.normal;
  const Vec<Dim> by_lower = gradient.push * (lower.center - plane.origin) - gradient.push_moment +
                            by_plane - plane.energy_by_facing * upper.normal;
  const Vec<Dim> by_upper = gradient.push * (upper.center - plane.origin) - gradient.push_moment -
                            by_plane - plane.energy_by_facing * lower.normal;

  auto &of_lower = gradient.lower, &of_upper = gradient.upper;
  add_turn(lower, by_lower, of_lower);
  add_turn(upper, by_upper, of_upper);
  const Vec<Dim> place = 0.5 * gradient.by_place * plane.normal;
  const Vec<Dim> lower_centre = (gradient.push * lower.normal + place) / lower.n_corners;
  const Vec<Dim> upper_centre = (gradient.push * upper.normal + place) / upper.n_corners;
  const auto beside = [&](const Vec<Dim>& by_corner, Real weight) {
    return Vec<Dim>(share * (-by_corner - weight * plane.volume * plane.normal));
  };
  plane.share = share;
  for (int i = 0; i < lower.n_corners; ++i) {
    const auto k = slot_of(i);
    plane.lower_push[k] = beside(of_lower[k] + lower_centre, -plane.lower_weight[k]);
  }
  for (int i = 0; i < upper.n_corners; ++i) {
    const auto k = slot_of(i);
    plane.upper_push[k] = beside(of_upper[k] + upper_centre, plane.upper_weight[k]);
  }
}

template struct BorderFade<2>;
template struct BorderFade<3>;
template void finish<2>(const FacePlane<2>&, const FacePlane<2>&, Real, Real, OverlapGradient<2>&,
                        CommonPlane<2>&);
template void finish<3>(const FacePlane<3>&, const FacePlane<3>&, Real, Real, OverlapGradient<3>&,
                        CommonPlane<3>&);

}  // namespace brunt
