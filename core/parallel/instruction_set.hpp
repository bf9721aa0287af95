#pragma once
#include <cstddef>
#include <cstdint>

/// Code that runs on every processor, whatever the rest is built for.
#ifdef __x86_64__
#define BRUNT_ON_ANY_CPU __attribute__((target("arch=x86-64")))
#else
#define BRUNT_ON_ANY_CPU
#endif

namespace brunt {

/// Instructions that a processor may have, by the compiler's name for them.
struct CpuFeature {
  const char* name;
  bool needed;   ///< by this build
  bool present;  ///< on this machine
};

/// One bit for each of n features, 32 at most, that is needed and not there.
std::uint32_t missing_features(const CpuFeature* features, std::size_t n);

/// Ends all ranks with status 4 and one message where any of them lacks a feature; missing is that
/// of this rank. Before main a processor that lacks some comes here by itself: its rank joins the
/// others, who do when they have started MPI. Collective.
void end_where_features_miss(std::uint32_t missing);

}  // namespace brunt
