#pragma once
/// In what numbers the sums over pairs of particles are formed; the state is in double in any case.
#include <type_traits>

#include "core/simd_single.hpp"

namespace brunt {

/// Four or eight pairs at a time, in SI units, by the same records. Sums have eight lanes in any
/// case: of packs of four each second one goes to the same lanes, so that the bits are the same.
template <class V>
struct RealPairs {
  using Number = Real;
  using Pack = V;
  using Stored = RealPairs<brunt::Pack>;  ///< whose records are read
  static constexpr int kLanes = lanes_of<V>;
  static constexpr int kTurns =
      2 * brunt::kLanes / kLanes;        ///< packs that share the lanes of a sum
  static constexpr Real kSupport = 4.0;  ///< (r/h)^2 below which a pair interacts
};
using DoublePairs = RealPairs<Pack>;
/// Where the processor has registers for them (core/wide_lanes.hpp).
using WidePairs = RealPairs<Wide>;

/// Eight pairs at a time. Lengths are in a unit near the spacing, so that no power of them leaves
/// the range of a float, and positions in whole steps of it, whose differences are exact.
struct SinglePairs {
  using Number = float;
  using Pack = SinglePack;
  using Stored = SinglePairs;
  static constexpr int kLanes = kSingleLanes;
  static constexpr int kTurns = 1;
  /// Rounding takes in no pair that a list, made in double, may lack: a gradient is 1e-10 there.
  static constexpr Real kSupport = 3.9999;
  /// Steps in a unit of length: an arm of up to four units is exact as a float, and what is nearer
  /// than 512 units is told apart from what is beyond.
  static constexpr Real kSteps = 1 << 22;
  /// [units] The longest smoothing length: lists reach 2.35 of it, well within the 512.
  static constexpr Real kLongest = 120;
  /// The most that spacings may differ: 2.5 smoothing lengths of them, over half a spacing, are
  /// 100.
  static constexpr Real kMostSpacings = 20;
};

template <class P>
inline constexpr bool kIsSingle = std::is_same_v<P, SinglePairs>;

/// True where there are registers for all sums of a pass at once: pairs need not be kept from one
/// sum to the next.
template <class P>
inline constexpr bool kSumsAtOnce = std::is_same_v<P, WidePairs>;

/// The unit of length [m] of sums in single precision, a power of two near a spacing: scaling by it
/// changes no bits.
struct SingleUnit {
  Real length = 1;   ///< [m]
  Real inverse = 1;  ///< [1/m]

  SingleUnit() = default;
  explicit SingleUnit(Real spacing)
      : length(std::exp2(std::floor(std::log2(spacing)))), inverse(1 / length) {}
  /// A coordinate in whole steps, modulo 2^32.
  std::int32_t steps(Real x) const {
    const auto whole = std::floor(x * (inverse * SinglePairs::kSteps) + 0.5);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(whole)));
  }
};

}  // namespace brunt
// Tested by tests/unit/sph/pair_precision_test.cpp.
