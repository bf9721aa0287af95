// What is held deep: corners of bricks that are shifted along each other overlap as slivers, deeper
// than the limit at which faces let go, and stay (docs/decisions/043-held-faces-stay.md). Lists of
// any skin hold all pairs that an evaluation may look at.
#include <gtest/gtest.h>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

TEST(Skin, HasNoPartInWhatIsHeldDeep) {
  const auto wall = [](const char* skin) {
    return simulate_shipped(
        "brick-wall-3d",
        {"parameters.size=320 mm", "parameters.bar_size=320 mm", "time.end=0.45 ms",
         "output.history=0.05 ms", "output.state_hash=true", std::string("contact.skin=") + skin});
  };
  const Simulation run = wall("1 m");
  ASSERT_GT(run.hashes.size(), 8U);
  EXPECT_EQ(wall("0 m").hashes, run.hashes);
  EXPECT_EQ(wall("auto").hashes, run.hashes);
}

}  // namespace
}  // namespace brunt::test
