#include "core/wide_lanes.hpp"

#include <cstdlib>
#include <string_view>

namespace brunt {

namespace {
bool found_wide() {
#if defined(BRUNT_WIDE_KERNELS) && defined(__x86_64__)
  const char* wanted = std::getenv("BRUNT_LANES");
  if (wanted != nullptr && std::string_view(wanted) == "4") return false;
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0;
#else
  return false;
#endif
}
}  // namespace

bool wide_lanes() {
  static const bool wide = found_wide();
  return wide;
}

}  // namespace brunt
