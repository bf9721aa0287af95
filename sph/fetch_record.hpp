#pragma once
/// Asks for a record before its turn comes: a pass over pairs takes long enough for it to arrive.
/// No value depends on it; GCC drops calls of functions that do nothing else, unless they are put
/// in line.
#include <cstddef>

#include "core/simd.hpp"

namespace brunt {

/// first, last  [byte] of the record that will be read or written, in whole lines of the cache
template <class Record>
BRUNT_INLINE void fetch_record(const Record& record, std::size_t first = 0,
                               std::size_t last = sizeof(Record)) {
  constexpr std::size_t kLine = 64;  // bytes
  const char* at = reinterpret_cast<const char*>(&record);
  for (std::size_t k = first; k < last; k += kLine) __builtin_prefetch(at + k, 1);
}

/// How many records a loop that does little for each asks ahead.
inline constexpr std::size_t kFetchAhead = 16;

/// Asks for the line of the cache in which a number lies that will be read.
BRUNT_INLINE void fetch_line(const Real& number) { __builtin_prefetch(&number); }

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
