#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "core/types.hpp"

namespace brunt {

/// Sum of any doubles that does not depend on their order: a fixed-point number of 68 digits of
/// 32 bits, each in a 64-bit word so that 2^30 additions need no carry. Adding the words of two
/// sums is exact too, so a reduction over threads or ranks keeps every bit.
/// Kulisch, Computer Arithmetic and Validity, 2008.
class ExactSum {
 public:
  void add(Real value) {  ///< NaN and infinity poison the sum
    const auto bits = std::bit_cast<std::uint64_t>(value);
    int exponent = static_cast<int>((bits >> 52) & 0x7ff);
    std::uint64_t mantissa = bits & 0xfffffffffffffULL;
    if ((bits << 1) == 0) return;  // most of what is summed before anything has happened
    if (exponent == 0x7ff) {
      poisoned_ = true;
      return;
    }
    if (exponent == 0) {
      exponent = 1;
    } else {
      mantissa |= 1ULL << 52;
    }
    // value = mantissa 2^(exponent - 1075): its lowest bit is bit (exponent - 1) of the accumulator
    const int shift = exponent - 1;
    const auto first = static_cast<std::size_t>(shift / 32);
    const auto wide = static_cast<Wide>(mantissa) << (shift % 32);
    const std::int64_t sign = bits >> 63 ? -1 : 1;
    digit_[first] += sign * static_cast<std::int64_t>(wide & kMask);
    digit_[first + 1] += sign * static_cast<std::int64_t>((wide >> 32) & kMask);
    digit_[first + 2] += sign * static_cast<std::int64_t>(wide >> 64);
    if (++pending_ == 1U << 29) carry();
  }
  void add(const ExactSum& other) { combine(other, 1); }
  void subtract(const ExactSum& other) { combine(other, -1); }
  Real value() const;  ///< the exact sum rounded once, to nearest

 private:
  __extension__ using Wide = unsigned __int128;
  static constexpr int kDigits = 68;
  static constexpr std::int64_t kMask = 0xffffffffLL;
  void combine(const ExactSum& other, std::int64_t sign);
  void carry();
  std::array<std::int64_t, kDigits> digit_{};
  std::uint32_t pending_ = 0;  ///< additions since the last carry
  bool poisoned_ = false;
};

}  // namespace brunt
