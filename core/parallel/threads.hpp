#pragma once
#include <omp.h>

#include <type_traits>

namespace brunt {

/// Points below which a team of threads costs more than it saves.
inline constexpr int kPointsWorthThreads = 1000;

/// Runs work() on all threads where that is worth a team, else on this one alone. What is shared
/// stands in it behind `#pragma omp for`.
template <class Work>
void on_threads(bool is_worth, const Work& work) {
  // A team of one is not free: libgomp ends it with a call to the system, as long as 100 elements.
  if (!omp_in_parallel() && (!is_worth || omp_get_max_threads() == 1)) {
    work();
    return;
  }
#pragma omp parallel if (is_worth)
  work();
}

/// Calls f(i) for i < n, on all threads where there are more than worth_threads of them. f changes
/// nothing but what is i's; numbers that it captures by value stay in registers.
template <class Index, class F>
void for_each(Index n, std::type_identity_t<Index> worth_threads, const F& f) {
  on_threads(n > worth_threads, [&f, n] {
    const F own = f;
#pragma omp for schedule(static)
    for (Index i = 0; i < n; ++i) own(i);
  });
}

}  // namespace brunt
// Tested by tests/unit/core/threads_test.cpp.
