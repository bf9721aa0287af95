#pragma once
#include <array>
#include <cstdint>

#include "core/types.hpp"

namespace brunt {

/// Sum of any doubles that does not depend on their order: a fixed-point number of 68 digits of
/// 32 bits, each in a 64-bit word so that 2^30 additions need no carry. Adding the words of two
/// sums is exact too, so a reduction over threads or ranks keeps every bit.
/// Kulisch, Computer Arithmetic and Validity, 2008.
class ExactSum {
 public:
  void add(Real value);  ///< NaN and infinity poison the sum
  void add(const ExactSum& other);
  Real value() const;  ///< the exact sum rounded once, to nearest

 private:
  static constexpr int kDigits = 68;
  void carry();
  std::array<std::int64_t, kDigits> digit_{};
  std::uint32_t pending_ = 0;  ///< additions since the last carry
  bool poisoned_ = false;
};

}  // namespace brunt
