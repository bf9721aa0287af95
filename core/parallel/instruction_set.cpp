#include "core/parallel/instruction_set.hpp"

#include <mpi.h>

#include <cstdio>
#include <cstdlib>

#include "core/parallel/communicator.hpp"

// Nothing here may be of the library: its inline functions are built for the newer processor.
namespace brunt {

namespace {
constexpr int kMachineFailed = 4;  // as in app/cli/run_arguments.hpp

#ifdef __x86_64__
// The text of a macro of the compiler's is "1" where the build may use what it stands for.
#define BRUNT_TEXT(macro) #macro
#define BRUNT_FEATURE(name, macro) \
  { name, BRUNT_TEXT(macro)[0] == '1', __builtin_cpu_supports(name) != 0 }
#define BRUNT_FEATURES                                                                  \
  BRUNT_FEATURE("sse3", __SSE3__), BRUNT_FEATURE("ssse3", __SSSE3__),                   \
      BRUNT_FEATURE("sse4.1", __SSE4_1__), BRUNT_FEATURE("sse4.2", __SSE4_2__),         \
      BRUNT_FEATURE("popcnt", __POPCNT__), BRUNT_FEATURE("bmi", __BMI__),               \
      BRUNT_FEATURE("bmi2", __BMI2__), BRUNT_FEATURE("avx", __AVX__),                   \
      BRUNT_FEATURE("avx2", __AVX2__), BRUNT_FEATURE("fma", __FMA__),                   \
      BRUNT_FEATURE("avx512f", __AVX512F__), BRUNT_FEATURE("avx512bw", __AVX512BW__),   \
      BRUNT_FEATURE("avx512cd", __AVX512CD__), BRUNT_FEATURE("avx512dq", __AVX512DQ__), \
      BRUNT_FEATURE("avx512vl", __AVX512VL__)

/// Before anything else of the program runs, constructors of its globals included.
[[gnu::constructor(101)]] BRUNT_ON_ANY_CPU void check_this_processor() {
  __builtin_cpu_init();
  const CpuFeature features[] = {BRUNT_FEATURES};
  const std::uint32_t missing = missing_features(features, sizeof(features) / sizeof(features[0]));
  if (missing == 0) return;
  if (launched_by_mpirun()) MPI_Init(nullptr, nullptr);
  end_where_features_miss(missing);
}
#endif
}  // namespace

BRUNT_ON_ANY_CPU std::uint32_t missing_features(const CpuFeature* features, std::size_t n) {
  std::uint32_t missing = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (features[i].needed && !features[i].present) missing |= std::uint32_t{1} << i;
  }
  return missing;
}

BRUNT_ON_ANY_CPU void end_where_features_miss(std::uint32_t missing) {
  int rank = 0, started = 0;
  MPI_Initialized(&started);
  if (started) {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Allreduce(MPI_IN_PLACE, &missing, 1, MPI_UINT32_T, MPI_BOR, MPI_COMM_WORLD);
  }
  if (missing == 0) return;
#ifdef __x86_64__
  const CpuFeature features[] = {BRUNT_FEATURES};
  if (rank == 0) {
    std::fputs("brunt: this machine's processor, or that of another rank, lacks", stderr);
    for (std::size_t i = 0; i < sizeof(features) / sizeof(features[0]); ++i) {
      if (missing >> i & 1) std::fprintf(stderr, " %s", features[i].name);
    }
    std::fputs(", for which this brunt is built (" BRUNT_ISA
               "); build it on that machine, or with cmake -DBRUNT_ARCH=baseline: the answer is "
               "the same bit for bit\n",
               stderr);
  }
#endif
  if (started) MPI_Finalize();
  std::_Exit(kMachineFailed);
}

}  // namespace brunt
