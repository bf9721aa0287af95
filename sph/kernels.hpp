#pragma once
/// Smoothing kernels of support 2 h:
///   W(r) = alpha / h^Dim f(q),  q = r/h;   grad_i W = alpha / h^(Dim+2) (f'(q)/q) (x_i - x_j).
/// docs/theory/sph.md (S1)
/// Written on V = Real, Pack or SinglePack, for q in [0, 2], without branches and without pow.
/// slope_over_q is f'/q, out of q and 1/q where the kernel divides by it.
#include "core/simd_single.hpp"
#include "sph/options.hpp"

namespace brunt {

/// Where a kernel divides by q however small it is, 1/q is taken at this q below it: the force of a
/// pair stays finite and vanishes with the distance.
inline constexpr Real kSmallestRatio = 1e-12;

/// Monaghan & Lattanzio 1985.
struct CubicKernel {
  static constexpr Real kStepFactor = 1.81;                       ///< undamped stable step in h/c
  static constexpr bool kDivides = true, kDividesAtRest = false;  // beyond q = 1 alone
  template <int Dim>
  static constexpr Real kAlpha = Dim == 2 ? 10.0 / (7.0 * kPi) : 1.0 / kPi;

  template <class V>
  static BRUNT_INLINE V value(V q) {
    const V rest = 2.0 - q;
    return select(q < 1.0, 1.0 + q * q * (0.75 * q - 1.5), 0.25 * rest * rest * rest);
  }
  template <class V>
  static BRUNT_INLINE V slope_over_q(V q, V inverse_q) {
    const V rest = 2.0 - q;
    return select(q < 1.0, 2.25 * q - 3.0, -0.75 * rest * rest * inverse_q);
  }
};

/// Johnson, Stryk & Beissel 1996.
struct QuadraticKernel {
  static constexpr Real kStepFactor = 2.05;
  static constexpr bool kDivides = true, kDividesAtRest = true;
  template <int Dim>
  static constexpr Real kAlpha = Dim == 2 ? 2.0 / kPi : 5.0 / (4.0 * kPi);

  template <class V>
  static BRUNT_INLINE V value(V q) {
    const V rest = 2.0 - q;
    return 0.1875 * rest * rest;
  }
  template <class V>
  static BRUNT_INLINE V slope_over_q(V q, V inverse_q) {
    return (0.375 * q - 0.75) * inverse_q;
  }
};

/// Yang, Peng & Liu 2014: f'' >= 0 everywhere, so that particles never pair under compression.
struct HyperbolicKernel {
  static constexpr Real kStepFactor = 1.80;
  static constexpr bool kDivides = true, kDividesAtRest = true;
  template <int Dim>
  static constexpr Real kAlpha = Dim == 2 ? 1.0 / (3.0 * kPi) : 15.0 / (62.0 * kPi);

  template <class V>
  static BRUNT_INLINE V value(V q) {
    const V rest = 2.0 - q;
    return select(q < 1.0, q * (q * q - 6.0) + 6.0, rest * rest * rest);
  }
  template <class V>
  static BRUNT_INLINE V slope_over_q(V q, V inverse_q) {
    const V rest = 2.0 - q;
    const V slope = select(q < 1.0, 3.0 * q * q - 6.0, -3.0 * rest * rest);
    return slope * inverse_q;
  }
};

/// Wendland 1995, twice differentiable.
struct WendlandC2Kernel {
  static constexpr Real kStepFactor = 1.73;
  static constexpr bool kDivides = false, kDividesAtRest = false;
  template <int Dim>
  static constexpr Real kAlpha = Dim == 2 ? 7.0 / (4.0 * kPi) : 21.0 / (16.0 * kPi);

  template <class V>
  static BRUNT_INLINE V value(V q) {
    const V rest = 1.0 - 0.5 * q, square = rest * rest;
    return square * square * (1.0 + 2.0 * q);
  }
  template <class V>
  static BRUNT_INLINE V slope_over_q(V q, V) {
    const V rest = 1.0 - 0.5 * q;
    return -5.0 * (rest * rest * rest);
  }
};

/// Wendland 1995, four times differentiable.
struct WendlandC4Kernel {
  static constexpr Real kStepFactor = 1.51;
  static constexpr bool kDivides = false, kDividesAtRest = false;
  template <int Dim>
  static constexpr Real kAlpha = Dim == 2 ? 9.0 / (4.0 * kPi) : 495.0 / (256.0 * kPi);

  template <class V>
  static BRUNT_INLINE V value(V q) {
    const V rest = 1.0 - 0.5 * q, cube = rest * rest * rest;
    return cube * cube * (1.0 + q * (3.0 + number_of<V>(35.0 / 12.0) * q));
  }
  template <class V>
  static BRUNT_INLINE V slope_over_q(V q, V) {
    const V rest = 1.0 - 0.5 * q, square = rest * rest;
    return number_of<V>(-14.0 / 3.0) * (1.0 + 2.5 * q) * (square * square * rest);
  }
};

/// Calls f with an object of the kernel's type.
template <class F>
decltype(auto) with_kernel(KernelKind kind, F&& f) {
  switch (kind) {
    case KernelKind::quadratic:
      return f(QuadraticKernel{});
    case KernelKind::hyperbolic:
      return f(HyperbolicKernel{});
    case KernelKind::wendland_c2:
      return f(WendlandC2Kernel{});
    case KernelKind::wendland_c4:
      return f(WendlandC4Kernel{});
    default:
      return f(CubicKernel{});
  }
}

}  // namespace brunt
