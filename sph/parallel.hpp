#pragma once
#include <cstddef>

#include "core/parallel/threads.hpp"

namespace brunt {

/// Calls f(i) for i < n, on all threads where n is worth it. f touches nothing but what is i's.
template <class F>
void for_each(std::size_t n, const F& f) {
  constexpr std::size_t worth_threads = 255;
  for_each(n, worth_threads, f);
}

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
