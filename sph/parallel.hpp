#pragma once
#include <cstddef>

namespace brunt {

/// Calls f(i) for i < n, on all threads where n is worth it. f touches nothing but what is i's.
template <class F>
void for_each(std::size_t n, F f) {
  constexpr std::size_t worth_threads = 256;
#pragma omp parallel for schedule(static) if (n >= worth_threads)
  for (std::size_t i = 0; i < n; ++i) f(i);
}

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
