#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "core/types.hpp"

namespace brunt {

/// Sum of any doubles that does not depend on their order: docs/theory/ledger.md (L6), a
/// fixed-point number of 68 digits of 32 bits, each in a 64-bit word so that 2^10 additions need no
/// carry. Adding the words of two sums is exact too, so a reduction over threads or ranks keeps
/// every bit. Kulisch, Computer Arithmetic and Validity, 2008; a number lies over two words, as in
/// Neal, Fast exact summation using small and large superaccumulators, 2015.
class ExactSum {
 public:
  void add(Real value) {  ///< NaN and infinity poison the sum
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t exponent = bits >> 52 & kMaxExponent;
    if (exponent - 1 < kMaxExponent - 1) {
      add_scaled(bits, 1ULL << 52 | (bits & kFraction), exponent - 1);
    } else if (exponent == kMaxExponent) {
      poisoned_ = true;
    } else if ((bits & kFraction) != 0) {
      add_scaled(bits, bits & kFraction, 0);
    }
  }
  /// Adds many values: the same sum, several of them at once.
  void add(std::span<const Real> values);
  void add(const ExactSum& other) { combine(other, 1); }
  void subtract(const ExactSum& other) { combine(other, -1); }
  Real value() const;  ///< the exact sum rounded once, to nearest

 private:
  __extension__ using Wide = unsigned __int128;
  static constexpr int kDigits = 68;
  static constexpr std::uint64_t kMask = 0xffffffffULL;
  static constexpr std::uint64_t kMaxExponent = 0x7ff, kFraction = 0xfffffffffffffULL;
  static constexpr std::uint32_t kMostPending = 1U << 10;
  /// Adds mantissa 2^(shift - 1074), with the sign of `bits`: its lowest bit is bit `shift`.
  void add_scaled(std::uint64_t bits, std::uint64_t mantissa, std::uint64_t shift) {
    const std::uint64_t first = shift / 32, within = shift % 32;
    const auto low = static_cast<std::int64_t>(mantissa << within & kMask);
    const auto high = static_cast<std::int64_t>(mantissa >> (32 - within));  // below 2^52
    const std::int64_t sign = static_cast<std::int64_t>(bits) >> 63;         // 0 or -1
    digit_[first] += (low ^ sign) - sign;
    digit_[first + 1] += (high ^ sign) - sign;
    if (++pending_ >= kMostPending) carry();
  }
  void add_tile(const Real* values, std::size_t n);
  void combine(const ExactSum& other, std::int64_t sign);
  void carry();
  std::array<std::int64_t, kDigits> digit_{};
  std::uint32_t pending_ = 0;  ///< additions since the last carry
  bool poisoned_ = false;
};

/// N exact sums of entities that come one after another, a tile of them at a time.
template <std::size_t N>
class ExactColumns {
 public:
  /// The values of one more entity, in the order of the sums.
  void add(const std::array<Real, N>& values) {
    for (std::size_t c = 0; c < N; ++c) value_[c][n_] = values[c];
    if (++n_ == kTile) flush();
  }
  /// The sum so far.
  const ExactSum& sum(std::size_t column) {
    flush();
    return sum_[column];
  }

 private:
  static constexpr std::size_t kTile = 128;
  void flush() {
    for (std::size_t c = 0; c < N; ++c) sum_[c].add(std::span<const Real>(value_[c].data(), n_));
    n_ = 0;
  }
  std::array<ExactSum, N> sum_;
  std::array<std::array<Real, kTile>, N> value_;
  std::size_t n_ = 0;
};

}  // namespace brunt
