#include "core/wide_lanes.hpp"

#include <cstdlib>
#include <string_view>

namespace brunt {

namespace {
#if defined(BRUNT_WIDE_KERNELS)
constexpr bool kBuiltForWide = true;
bool has_wide_registers() {
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0;
}
#else
constexpr bool kBuiltForWide = false;  // two Packs then, which any processor of the build runs
bool has_wide_registers() { return true; }
#endif

bool wants_wide() {
  const char* wanted = std::getenv("BRUNT_LANES");
  return wanted == nullptr || std::string_view(wanted) != "4";
}
}  // namespace

bool can_run_wide() { return has_wide_registers(); }

bool wide_lanes() {
  static const bool wide = kBuiltForWide && can_run_wide() && wants_wide();
  return wide;
}

}  // namespace brunt
