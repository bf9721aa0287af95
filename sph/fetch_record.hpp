#pragma once
/// Asks for a record before its turn comes: a pass over pairs takes long enough for it to arrive.
/// No value depends on it.
#include <cstddef>

namespace brunt {

template <class Record>
inline void fetch_record(const Record& record) {
  constexpr std::size_t kLine = 64;  // bytes
  const char* at = reinterpret_cast<const char*>(&record);
  for (std::size_t k = 0; k < sizeof(Record); k += kLine) __builtin_prefetch(at + k, 1);
}

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
