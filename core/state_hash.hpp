#pragma once
#include <bit>

#include "core/types.hpp"

namespace brunt {

/// Spreads every bit over all (the finaliser of splitmix64; Steele, Lea and Flood, 2014).
inline std::uint64_t scrambled(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31);
}

/// Hash of the state of one entity: of its values, in their order, and of whose they are. Values
/// are scrambled each for itself and summed, so that a processor works on several at once. The
/// hashes of entities are summed modulo 2^64: no order, rank or thread is in the result.
class EntityHash {
 public:
  explicit EntityHash(GlobalId id) : key_(scrambled(id + kStep)) {}
  void add(std::uint64_t bits) {
    key_ += kStep;
    sum_ += scrambled(bits ^ key_);
  }
  void add(Real value) { add(std::bit_cast<std::uint64_t>(value)); }
  std::uint64_t value() const { return scrambled(sum_ ^ key_); }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL;  // 2^64 over the golden ratio
  std::uint64_t key_, sum_ = 0;
};

}  // namespace brunt
// Tested by tests/unit/core/state_test.cpp.
