#include "core/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/simd.hpp"

namespace brunt {

namespace {
constexpr int kBias = 1074;  // the least significant bit of digit 0 is 2^-1074

/// Values that are summed at once.
constexpr std::size_t kTileOfSum = 128;
/// Below so many it is not worth the trouble.
constexpr std::size_t kWorthTile = 16;
/// Above the largest exponent of the values that are cut: 128 = 2^7 of them stay in one binade.
constexpr int kRoom = 7;
/// What one cut takes of a value, in bits: 2^7 times 2^45 units of it still are a double.
constexpr int kCutBits = 52 - kRoom;
/// Exponents of values from here on are cut without overflow or underflow.
constexpr int kLeastCut = -900, kMostCut = 1000;

/// The largest bits of a tile without their signs, in the order of magnitudes; NaN is above all.
std::int64_t most_bits(const Real* values, std::size_t n) {
  constexpr long long m = 0x7fffffffffffffffLL;
  PackMask most{0, 0, 0, 0};
  for (std::size_t i = 0; i < n; i += kLanes) {
    const PackMask bits = reinterpret_cast<PackMask>(load(values + i)) & PackMask{m, m, m, m};
    most = bits > most ? bits : most;
  }
  return std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
}

/// 1.5 2^exponent, of a normal double.
Real cutter_of(int exponent) {
  return std::bit_cast<Real>(static_cast<std::uint64_t>(exponent + 1023) << 52 | 1ULL << 51);
}

/// What two cuts take of values, summed, and whether they leave something.
struct TileCut {
  Pack high{0, 0, 0, 0}, low{0, 0, 0, 0};
  PackMask left{0, 0, 0, 0};
};

/// Takes the leading bits of four values, as multiples of one unit; what is left is exact.
BRUNT_INLINE Pack cut(Pack& rest, Pack cutter) {
  const Pack leading = (rest + cutter) - cutter;
  rest = rest - leading;
  return leading;
}

BRUNT_INLINE void cut_twice(Pack& value, Pack first, Pack second, TileCut& to) {
  to.high += cut(value, first);
  to.low += cut(value, second);
  to.left |= value != Pack{0, 0, 0, 0};
}

/// Two cuts of values that are all below 2^exponent; n is a multiple of the lanes. rest  what the
/// cuts leave, or null
TileCut cut_tile(const Real* values, std::size_t n, int exponent, Real* rest) {
  const Pack first = broadcast<Pack>(cutter_of(exponent + kRoom));
  const Pack second = broadcast<Pack>(cutter_of(exponent + kRoom - kCutBits - 1));
  TileCut even, odd;  // two chains of sums
  std::size_t i = 0;
  const auto take = [&](TileCut& to) {
    Pack value = load(values + i);
    cut_twice(value, first, second, to);
    if (rest != nullptr) store(rest + i, value);
    i += kLanes;
  };
  while (i + kLanes < n) take(even), take(odd);
  if (i < n) take(even);
  even.high += odd.high, even.low += odd.low, even.left |= odd.left;
  return even;
}
}  // namespace

/// Leading bits of values as multiples of one unit, which add up without rounding; what they leave
/// is cut again, 46 bits lower: docs/theory/ledger.md (L9). Rump, Ogita & Oishi, Accurate
/// floating-point summation I, 2008, sec. 3.
void ExactSum::add_tile(const Real* values, std::size_t n) {
  alignas(32) std::array<Real, kTileOfSum> rest;
  const std::size_t padded = (n + kLanes - 1) / kLanes * kLanes;
  if (padded != n) {
    std::fill(std::copy_n(values, n, rest.begin()),
              rest.begin() + static_cast<std::ptrdiff_t>(padded), 0.0);
    values = rest.data();
  }
  std::int64_t most = most_bits(values, padded);
  while (most != 0) {
    const int exponent = static_cast<int>(most >> 52) - 1023 + 1;  // all are below 2^exponent
    if (exponent < kLeastCut || exponent > kMostCut) {
      for (std::size_t i = 0; i < padded; ++i) add(values[i]);
      return;
    }
    const TileCut sums = cut_tile(values, padded, exponent, nullptr);
    add((sums.high[0] + sums.high[1]) + (sums.high[2] + sums.high[3]));
    add((sums.low[0] + sums.low[1]) + (sums.low[2] + sums.low[3]));
    if (!any(sums.left)) return;
    // Seldom: what is left is far below the largest.
    cut_tile(values, padded, exponent, rest.data());
    values = rest.data();
    most = most_bits(values, padded);
  }
}

void ExactSum::add(std::span<const Real> values) {
  while (values.size() >= kWorthTile) {
    const std::size_t n = std::min(values.size(), kTileOfSum);
    add_tile(values.data(), n);
    values = values.subspan(n);
  }
  for (const Real value : values) add(value);
}

void ExactSum::combine(const ExactSum& other, std::int64_t sign) {
  poisoned_ = poisoned_ || other.poisoned_;
  if (other.pending_ == 0) return;  // nothing was added to it
  if (pending_ + other.pending_ >= kMostPending) carry();
  for (std::size_t i = 0; i < digit_.size(); ++i) digit_[i] += sign * other.digit_[i];
  pending_ += other.pending_ + 1;
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
  if (pending_ == 0) return 0.0;
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
