// A feature misses where the build needs it and the processor has it not, and nowhere else. That no
// instruction of the build runs before is a matter of how the program starts: this test runs at
// all.
#include "core/parallel/instruction_set.hpp"

#include <gtest/gtest.h>

#include <iterator>

namespace brunt {
namespace {

TEST(InstructionSet, WhatIsNeededAndNotThereIsMissing) {
  const CpuFeature features[] = {{"avx", true, true},
                                 {"avx2", true, false},
                                 {"fma", false, false},
                                 {"bmi2", false, true},
                                 {"avx512f", true, false}};
  EXPECT_EQ(missing_features(features, std::size(features)), 0b10010u);
  EXPECT_EQ(missing_features(features, 1), 0u);
  EXPECT_EQ(missing_features(features, 0), 0u);
}

TEST(InstructionSet, NothingMissesHere) {
  end_where_features_miss(0);  // a rank that lacks something never comes back
}

TEST(InstructionSetDeath, SaysWhatMissesAndWhatToDo) {
#ifdef __x86_64__
  EXPECT_EXIT(end_where_features_miss(1U << 8 | 1U << 9), ::testing::ExitedWithCode(4),
              "^brunt: this machine.* lacks avx2 fma, .*-DBRUNT_ARCH=baseline.*\n$");
#endif
}

}  // namespace
}  // namespace brunt
