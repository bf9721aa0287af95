#include "fe/shape_guard.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {
namespace {

/// Plain arrays: what Eigen vectorises depends on the instruction set. Of V = Pack: of four places.
template <int Dim, class V = Real>
using Square = std::array<std::array<V, Dim>, Dim>;
template <int Dim>
using Places = std::array<Vec<Dim>, Shape<Dim>::kCorners>;

template <int Dim>
inline constexpr int kPlaces = GuardPlaces<Dim>::kCount;

/// Slopes of shape functions at the places, [place][corner][j].
template <int Dim>
using SlopeTable =
    std::array<std::array<std::array<Real, Dim>, Shape<Dim>::kCorners>, kPlaces<Dim>>;
template <int Dim>
constexpr SlopeTable<Dim> make_slopes() {
  constexpr int n = Shape<Dim>::kCorners;
  SlopeTable<Dim> table{};
  for (int p = 0; p < kPlaces<Dim>; ++p) {
    const auto& slope = kGuardPlaces<Dim>.slope[p];
    for (int I = 0; I < n; ++I) {
      std::array<Real, Dim> corner{};
      for (int j = 0; j < Dim; ++j) corner[j] = Shape<Dim>::kSign[I][j];
      const auto value = Shape<Dim>::mode_values(corner);
      for (int j = 0; j < Dim; ++j) {
        for (int m = 0; m < Shape<Dim>::kModes - 1; ++m) {
          table[p][I][j] += value[m] * slope[m][j] / n;
        }
      }
    }
  }
  return table;
}
template <int Dim>
constexpr SlopeTable<Dim> kSlopes = make_slopes<Dim>();

/// The same, [corner][j][place].
template <int Dim>
struct SlopeRows {
  alignas(32) Real row[Shape<Dim>::kCorners][Dim][kPlaces<Dim>];
  constexpr SlopeRows() : row{} {
    for (int p = 0; p < kPlaces<Dim>; ++p) {
      for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
        for (int j = 0; j < Dim; ++j) row[I][j][p] = kSlopes<Dim>[p][I][j];
      }
    }
  }
};
template <int Dim>
constexpr SlopeRows<Dim> kSlopeRows;

/// dx/dxi at a place, or with V = Pack at four from there on, [i][j].
template <int Dim, class V = Real>
Square<Dim, V> jacobian_at(const Places<Dim>& x, int place) {
  Square<Dim, V> a{};
  for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
    for (int j = 0; j < Dim; ++j) {
      const V slope = load_as<V>(kSlopeRows<Dim>.row[I][j] + place);
      for (int i = 0; i < Dim; ++i) a[i][j] = a[i][j] + x[I][i] * slope;
    }
  }
  return a;
}

template <class V, std::size_t Dim>
std::array<std::array<V, Dim>, Dim> product(const std::array<std::array<V, Dim>, Dim>& a,
                                            const std::array<std::array<V, Dim>, Dim>& b) {
  std::array<std::array<V, Dim>, Dim> c{};
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) {
      for (std::size_t k = 0; k < Dim; ++k) c[i][j] = c[i][j] + a[i][k] * b[k][j];
    }
  }
  return c;
}
template <std::size_t Dim>
std::array<std::array<Real, Dim>, Dim> transpose(const std::array<std::array<Real, Dim>, Dim>& a) {
  std::array<std::array<Real, Dim>, Dim> t;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) t[j][i] = a[i][j];
  }
  return t;
}
/// a : b
template <class V, std::size_t Dim>
V double_dot(const std::array<std::array<V, Dim>, Dim>& a,
             const std::array<std::array<V, Dim>, Dim>& b) {
  V sum{};
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) sum = sum + a[i][j] * b[i][j];
  }
  return sum;
}
/// d det/da.
template <class V>
Square<2, V> cofactors_of(const Square<2, V>& a) {
  return {{{a[1][1], -a[1][0]}, {-a[0][1], a[0][0]}}};
}
template <class V>
Square<3, V> cofactors_of(const Square<3, V>& a) {
  Square<3, V> c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
      c[i][j] = a[p][r] * a[q][s] - a[p][s] * a[q][r];
    }
  }
  return c;
}
template <class V, std::size_t Dim>
V determinant(const std::array<std::array<V, Dim>, Dim>& a,
              const std::array<std::array<V, Dim>, Dim>& cofactors) {
  V sum{};
  for (std::size_t j = 0; j < Dim; ++j) sum = sum + a[0][j] * cofactors[0][j];
  return sum;
}
/// Half of d|cof F|^2/dF: F in 2D, tr(C) F - F C in 3D with C = F^T F.
Square<2> cofactor_slope(const Square<2>& F) { return F; }
Square<3> cofactor_slope(const Square<3>& F) {
  const Square<3> FC = product(F, product(transpose(F), F));
  const Real trace = double_dot(F, F);
  Square<3> slope;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) slope[i][j] = trace * F[i][j] - FC[i][j];
  }
  return slope;
}

/// J where it is not small, never below 0, and the root that it takes.
template <class V>
struct PositivePart {
  V root, value;
  explicit PositivePart(V J)
      : root(vsqrt(J * J + 4 * ShapeGuard::kFlat * ShapeGuard::kFlat)), value(0.5 * (J + root)) {}
};

/// 1/|F^-1| where dx/dxi = a.  inverse_start: A^-1
template <int Dim, class V>
V height_of(const Square<Dim, V>& inverse_start, const Square<Dim, V>& a) {
  const Square<Dim, V> F = product(a, inverse_start), cof = cofactors_of(F);
  const PositivePart<V> positive(determinant(F, cof));
  return positive.value / vsqrt(double_dot(cof, cof));
}

/// What one place with dx/dxi = a adds, over V0 k/places: slopes by a [1/m] and a bound of its
/// stiffness [1/m^2], where it is near already.
template <int Dim>
struct PlaceGuard {
  Square<Dim> slope{};
  Real stiffness = 0;

  /// inverse_start: A^-1
  PlaceGuard(const Square<Dim>& inverse_start, const Square<Dim>& a) {
    const Square<Dim> F = product(a, inverse_start), cof = cofactors_of(F);
    const Real square = double_dot(cof, cof);
    const PositivePart<Real> positive(determinant(F, cof));
    const Real height = positive.value / std::sqrt(square);
    if (!(height < ShapeGuard::kNear * ShapeGuard::kHeight)) return;
    const Real excess = std::max(0.0, 2 * std::log(ShapeGuard::kHeight / height));
    const Square<Dim> of_cof = cofactor_slope(F);
    Square<Dim> by_F;
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t j = 0; j < Dim; ++j) {
        by_F[i][j] = 2 * (of_cof[i][j] / square - cof[i][j] / positive.root);
      }
    }
    slope = product(by_F, transpose(inverse_start));
    stiffness = double_dot(slope, slope) * (1 + excess);
    for (auto& row : slope) {
      for (Real& component : row) component *= excess;
    }
  }
};

/// A^-1; zero, so that nothing acts, where dx/dxi is as good as flat at time 0.
template <int Dim, class V>
Square<Dim, V> inverse_of(const Square<Dim, V>& A) {
  constexpr Real kFlatCorner = 0.05;  // sine of the angle
  const Square<Dim, V> cof = cofactors_of(A);
  const V J = determinant(A, cof);
  V box = broadcast<V>(1.0);
  for (std::size_t j = 0; j < Dim; ++j) {
    V square{};
    for (std::size_t i = 0; i < Dim; ++i) square = square + A[i][j] * A[i][j];
    box = box * vsqrt(square);
  }
  const auto is_corner = J > kFlatCorner * box;
  Square<Dim, V> inverse;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) {
      inverse[i][j] = select(is_corner, cof[j][i] / J, broadcast<V>(0.0));
    }
  }
  return inverse;
}

/// 1/|F^-1| at all places of an element, at the end of a step and at its start.
template <int Dim>
struct Heights {
  alignas(32) Real now[kPlaces<Dim>], old[kPlaces<Dim>];

  Heights(const Places<Dim>& x_start, const Places<Dim>& x_now, const Places<Dim>& x_old) {
    for (int place = 0; place < kPlaces<Dim>; place += kLanes) {
      const auto inverse = inverse_of<Dim>(jacobian_at<Dim, Pack>(x_start, place));
      store(now + place, height_of<Dim>(inverse, jacobian_at<Dim, Pack>(x_now, place)));
      store(old + place, height_of<Dim>(inverse, jacobian_at<Dim, Pack>(x_old, place)));
    }
  }
  /// The part of its height, or of the least that is free, that a place has lost at the most.
  Real closing() const {
    Real most = 0;
    for (int p = 0; p < kPlaces<Dim>; ++p) {
      most = std::max(most, (old[p] - now[p]) / std::max(now[p], ShapeGuard::kHeight));
    }
    return most;
  }
  /// True where the energy may not be 0, or the next step may find it so.
  bool may_act(int p) const {
    constexpr Real near = ShapeGuard::kNear * ShapeGuard::kHeight;
    return now[p] < near || old[p] < near;
  }
};

/// Adds to an element's corner forces what a place gives by `slope`, times `scale`.
template <int Dim, class V>
void add_forces(int place, const Square<Dim>& slope, Real scale, int lane,
                V (&node)[Shape<Dim>::kCorners][Dim]) {
  for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
    for (int i = 0; i < Dim; ++i) {
      Real sum = 0;
      for (int j = 0; j < Dim; ++j) sum += slope[i][j] * kSlopes<Dim>[place][I][j];
      node[I][i][lane] -= scale * sum;
    }
  }
}
}  // namespace

template <int Dim, class V>
void guard_shape(ElementBlock<Dim>& block, std::size_t e, const ElementStep<Dim>& step, int lane,
                 V (&force)[Shape<Dim>::kCorners][Dim]) {
  constexpr int n = Shape<Dim>::kCorners;
  Places<Dim> start, now, old;
  for (int I = 0; I < n; ++I) {
    const LocalIndex node = block.corner[e * n + slot_of(I)];
    start[I] = step.x_start[node], now[I] = step.x[node];
    old[I] = now[I] - step.dt * step.v[node];
  }
  const Real scale =
      ShapeGuard::kStiffness * block.material->bulk * block.element_volume[e] / kPlaces<Dim>;
  Real work = 0, stiffness = 0;
  const Heights<Dim> height(start, now, old);
  for (int place = 0; place < kPlaces<Dim>; ++place) {
    if (!height.may_act(place)) continue;
    const Square<Dim> inverse = inverse_of<Dim>(jacobian_at<Dim>(start, place));
    const Square<Dim> a = jacobian_at<Dim>(now, place), a_old = jacobian_at<Dim>(old, place);
    const PlaceGuard<Dim> at(inverse, a), before(inverse, a_old);
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t j = 0; j < Dim; ++j) {
        work += 0.5 * (before.slope[i][j] + at.slope[i][j]) * (a[i][j] - a_old[i][j]);
      }
    }
    stiffness += at.stiffness;
    add_forces<Dim>(place, at.slope, scale, lane, force);
  }
  block.hourglass_work[e] += scale * work;
  // dx/dxi moves by at most sqrt(Dim + 1)/2 of what the corners do, which have equal masses.
  const Real omega_square = 0.25 * (Dim + 1) * scale * stiffness * n / block.mass[e];
  Real& bound = block.stable_step[e];
  if (stiffness > 0) bound /= std::sqrt(1 + 0.25 * omega_square * bound * bound);
  const Real closing = height.closing();
  if (closing > 0) bound = std::min(bound, ShapeGuard::kClosing * step.dt / closing);
}

template <int Dim>
Real guard_reach(CornerPlaces<Dim> x) {
  Real sum =
      0;  // of the squares of the longest edges: of columns of dx/dxi, which lie between them
  for (int j = 0; j < Dim; ++j) {
    Real longest = 0;
    for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
      if (Shape<Dim>::kSign[I][j] > 0) continue;
      Real square = 0;
      for (int i = 0; i < Dim; ++i) {
        const Real along = x[Shape<Dim>::beside(I, j)][i] - x[I][i];
        square += along * along;
      }
      longest = std::max(longest, 0.25 * square);
    }
    sum += longest;
  }
  return ShapeGuard::kHeight * ShapeGuard::kHeight * sum;
}

template void guard_shape(ElementBlock<2>&, std::size_t, const ElementStep<2>&, int,
                          Pack (&)[Shape<2>::kCorners][2]);
template void guard_shape(ElementBlock<3>&, std::size_t, const ElementStep<3>&, int,
                          Pack (&)[Shape<3>::kCorners][3]);
template void guard_shape(ElementBlock<2>&, std::size_t, const ElementStep<2>&, int,
                          Wide (&)[Shape<2>::kCorners][2]);
template void guard_shape(ElementBlock<3>&, std::size_t, const ElementStep<3>&, int,
                          Wide (&)[Shape<3>::kCorners][3]);
template Real guard_reach<2>(CornerPlaces<2>);
template Real guard_reach<3>(CornerPlaces<3>);

}  // namespace brunt
