#include "core/exact_sum.hpp"

#include <bit>
#include <cmath>

namespace brunt {

namespace {
constexpr int kBias = 1074;  // the least significant bit of digit 0 is 2^-1074
}  // namespace

void ExactSum::combine(const ExactSum& other, std::int64_t sign) {
  if (pending_ + other.pending_ >= kMostPending) carry();
  for (std::size_t i = 0; i < digit_.size(); ++i) digit_[i] += sign * other.digit_[i];
  pending_ += other.pending_ + 1;
  poisoned_ = poisoned_ || other.poisoned_;
}

void ExactSum::carry() {
  for (std::size_t i = 0; i + 1 < digit_.size(); ++i) {
    const std::int64_t high = digit_[i] >> 32;  // floor, so that the low part is in [0, 2^32)
    digit_[i] &= static_cast<std::int64_t>(kMask);
    digit_[i + 1] += high;
  }
  pending_ = 1;
}

Real ExactSum::value() const {
  if (poisoned_) return std::numeric_limits<Real>::quiet_NaN();
  ExactSum sum = *this;
  sum.carry();
  const bool negative = sum.digit_.back() < 0;
  if (negative) {
    for (auto& digit : sum.digit_) digit = -digit;
    sum.carry();
  }
  int top = kDigits - 1;
  while (top >= 0 && sum.digit_[top] == 0) --top;
  if (top < 0) return 0.0;
  // 64 leading bits and a sticky bit hold all that one rounding to 53 bits needs
  Wide lead = 0;
  for (int i = top; i > top - 3; --i) {
    lead = (lead << 32) | static_cast<std::uint64_t>(i >= 0 ? sum.digit_[i] : 0);
  }
  bool sticky = false;
  for (int i = top - 3; i >= 0; --i) sticky = sticky || sum.digit_[i];
  int exponent = 32 * (top - 2) - kBias;
  while (lead >> 64) {
    sticky = sticky || (lead & 1);
    lead >>= 1;
    ++exponent;
  }
  auto high = static_cast<std::uint64_t>(lead);
  int drop = 11 - std::countl_zero(high);
  if (exponent + drop < -kBias) drop = -kBias - exponent;  // below 2^-1022 fewer bits remain
  if (drop > 0) {
    const std::uint64_t rest = high & ((1ULL << drop) - 1);
    const std::uint64_t half = 1ULL << (drop - 1);
    high >>= drop;
    exponent += drop;
    if (rest > half || (rest == half && (sticky || (high & 1)))) ++high;
  }
  const Real magnitude = std::ldexp(static_cast<Real>(high), exponent);
  return negative ? -magnitude : magnitude;
}

}  // namespace brunt
