#pragma once
/// What keeps elements of materials that flow from being crushed to nothing or turned inside out at
/// a corner. Where strength has gone, with heat above all, stresses resist a change of volume
/// alone: an element between a wall and what follows it thins without end, as exp(-rate t), and its
/// corners pass each other.
#include "fe/element_step.hpp"

namespace brunt {

/// Of n places in an element F is the gradient of x over the positions of time 0. The energy is
///   W = V0 k/(2 n) sum ln^2(|F^-1|^2 h^2) where |F^-1| h > 1, else none:
/// 1/|F^-1| is the least height over that at time 0, and h the least that is free. The stress in
/// the direction of that height is 2 k ln(..), the stiffness there about 4 k: it does not grow as
/// heights fall, so that steps follow heights alone. docs/theory/elements.md (E11).
struct ShapeGuard {
  static constexpr Real kHeight = 0.02;     ///< h [1]
  static constexpr Real kStiffness = 0.02;  ///< k over the bulk modulus [1]
  /// det F about which places that are inside out begin to feel what turns them back.
  static constexpr Real kFlat = 0.003;
  /// Part of its height, or of h where that is less, that a place may lose in a step: what comes
  /// faster would be through the energy before its steepness bounds the step.
  static constexpr Real kClosing = 0.05;
  /// The stiffness bounds steps of places up to so many h already, two of whose steps end below h
  /// at the soonest: met with the longer step before it, it would throw what comes slowly back
  /// much faster, again and again.
  static constexpr Real kNear = 1.1;
  /// So much farther from flat than where the guard may begin to act an element is not looked at:
  /// no step takes it from there to where it acts, or back.
  static constexpr Real kOpen = 3;
};

/// Adds the guard's forces to the corner forces of element e, their work to hourglass_work and
/// their stiffness to the stable step.
/// lane  of the four elements whose forces [N] on their nodes `force` has
template <int Dim, class V>
void guard_shape(ElementBlock<Dim>& block, std::size_t e, const ElementStep<Dim>& step, int lane,
                 V (&force)[Shape<Dim>::kCorners][Dim]);

/// Square of the largest least singular value of dx/dxi at which the guard may act [m^2], in an
/// element with positions x at time 0: |F^-1| <= |dx0/dxi| |(dx/dxi)^-1|.
template <int Dim>
Real guard_reach(CornerPlaces<Dim> x);

/// Slopes of the modes at the places where the guard looks, [place][mode][j]: at the corners,
/// between which det(dx/dxi) is linear in 2D, and at the Gauss points of a hexahedron, which warps
/// such that it has volume at its corners alone.
template <int Dim>
struct GuardPlaces {
  static constexpr int kCount = Dim == 3 ? 2 * Shape<3>::kCorners : Shape<2>::kCorners;
  std::array<std::array<std::array<Real, Dim>, Shape<Dim>::kModes - 1>, kCount> slope{};
  constexpr GuardPlaces() {
    for (int p = 0; p < kCount; ++p) {
      std::array<Real, Dim> at = gauss_place<Dim>(p % Shape<Dim>::kCorners);
      for (int j = 0; j < Dim && p < Shape<Dim>::kCorners; ++j) at[j] = Shape<Dim>::kSign[p][j];
      const auto of_modes = Shape<Dim>::mode_slopes(at);
      for (int m = 0; m < Shape<Dim>::kModes - 1; ++m) slope[p][m] = of_modes[m];
    }
  }
};
template <int Dim>
inline constexpr GuardPlaces<Dim> kGuardPlaces;

/// The determinant and |cof a|^2 of dx/dxi = a: |a^-1| is the root of this over that.
template <int Dim, class V>
struct Flatness {
  V J = broadcast<V>(0), square = broadcast<V>(0);

  BRUNT_INLINE explicit Flatness(const V (&a)[Dim][Dim]) {
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) {
        V cofactor;
        if constexpr (Dim == 2) {
          cofactor = (i == j ? 1.0 : -1.0) * a[1 - i][1 - j];
        } else {
          const int p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
          cofactor = a[p][r] * a[q][s] - a[p][s] * a[q][r];
        }
        if (i == 0) J += a[0][j] * cofactor;
        square += cofactor * cofactor;
      }
    }
  }
  /// True where |a^-1|^2 needed < 1.
  BRUNT_INLINE MaskOf<V> is_open(V needed) const { return (J > 0) & (J * J > needed * square); }
};

/// True for those of several elements with modes c that are open at all places, as their linear
/// modes A and the sizes of the others show. These change dx/dxi by at most t, the root of the
/// squares of its columns; the least singular value is at least that of A, J/|cof A|, less t; and
/// |a^-1| at most the root of Dim over it.
template <int Dim, class V>
BRUNT_INLINE MaskOf<V> are_open_by_size(const Modal<Dim, V>& c, V needed) {
  V A[Dim][Dim], size[Shape<Dim>::kHourglass], sum = broadcast<V>(0), t_square = broadcast<V>(0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) A[i][j] = c.m[j][i];
  }
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    V square = broadcast<V>(0);
    for (int i = 0; i < Dim; ++i) square += c.m[Dim + a][i] * c.m[Dim + a][i];
    size[a] = vsqrt(square);
    sum += size[a];
  }
  for (int j = 0; j < Dim; ++j) {
    // In 3D mode Dim + j does not depend on direction j; all others do, and the one in 2D.
    const V column = Dim == 3 ? sum - size[j] : sum;
    t_square += column * column;
  }
  const Flatness<Dim, V> linear(A);
  const V least = vsqrt(t_square) + vsqrt(static_cast<Real>(Dim) * needed);
  constexpr Real kRounding = 1 + 1e-9;
  return linear.J > kRounding * (least * vsqrt(linear.square));
}

/// Square of the most that |dv/dxi| may be anywhere in an element with these modes of v: each of
/// its columns is a sum of four modes, two in 2D, with factors of at most 1.
template <int Dim, class V>
BRUNT_INLINE V steepest_square(const Modal<Dim, V>& v) {
  constexpr Real kColumns = Dim == 3 ? 3 : 2;  // in which a mode that is not linear may be
  V linear = broadcast<V>(0), others = broadcast<V>(0);
  for (int m = 0; m < Shape<Dim>::kModes - 1; ++m) {
    V& sum = m < Dim ? linear : others;
    for (int i = 0; i < Dim; ++i) sum += v.m[m][i] * v.m[m][i];
  }
  return (Dim == 3 ? 4.0 : 2.0) * (linear + kColumns * others);
}

/// True for those of elements e, e + 1, ... that the guard leaves alone: everywhere kOpen times
/// farther from flat than where it may begin to act, and with heights that lose no more in a stable
/// step than they may: of its height a place loses no more than |dv/dxi| |(dx/dxi)^-1| in a second.
template <int Dim, class V>
__attribute__((noinline)) MaskOf<V> are_open(const ElementBlock<Dim>& block, std::size_t e,
                                             const ElementStep<Dim>& step) {
  constexpr Real kRounding = 1.1;  // heights of the guard have a root in them
  const LocalIndex* corner = block.corner.data() + e * Shape<Dim>::kCorners;
  V node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(corner, step.v, node);
  const V lost = (kRounding / ShapeGuard::kClosing) * load_as<V>(block.stable_step.data() + e);
  const V closing = lost * lost * steepest_square(modes_of<Dim>(node));
  gather<Dim>(corner, step.x, node);
  const Modal<Dim, V> c = modes_of<Dim>(node);
  const V reach = load_as<V>(block.guard_reach.data() + e);
  const V needed = vmax(ShapeGuard::kOpen * ShapeGuard::kOpen * reach, closing);
  auto open = are_open_by_size<Dim>(c, needed);
  if (!any(~open)) return open;
  open = broadcast<V>(0) < broadcast<V>(1);
  for (const auto& slope : kGuardPlaces<Dim>.slope) {
    V a[Dim][Dim];
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) {
        a[i][j] = c.m[j][i];
        for (int m = Dim; m < Shape<Dim>::kModes - 1; ++m) a[i][j] += slope[m][j] * c.m[m][i];
      }
    }
    open = open & Flatness<Dim, V>(a).is_open(needed);
  }
  return open;
}

/// Guards those of several elements that it may act on. square: the sum of the squares of the
/// hourglass modes of the positions; node: forces on the corners.
/// With s half of the least height of the linear modes and t the most that the others change dx/dxi
/// by, its least singular value is at least s - t: for most, that is enough. Others are looked at
/// place by place.
template <int Dim, class V>
BRUNT_INLINE void guard_shapes(ElementBlock<Dim>& block, std::size_t e, const OperatorNorm<V>& norm,
                               V square, const ElementStep<Dim>& step,
                               V (&node)[Shape<Dim>::kCorners][Dim]) {
  if (block.guard_reach.empty()) return;
  constexpr Real kHeightSquare = Dim == 3 ? 0.5 : 1.0;  // times the largest eigenvalue
  constexpr Real kOtherModes = Dim == 3 ? 9 : 2;        // t^2 over the sum of their squares
  const V reach = load_as<V>(block.guard_reach.data() + e);
  const auto safe = 8.0 * norm.largest * (kOtherModes * square + reach) < kHeightSquare;
  if (!any(~safe)) return;
  const auto open = are_open<Dim, V>(block, e, step);
  if (!any(~(safe | open))) return;
  for (int lane = 0; lane < lanes_of<V>; ++lane) {
    if (lane_of(safe | open, lane)) continue;
    guard_shape(block, e + slot_of(lane), step, lane, node);
  }
}

}  // namespace brunt
