// The words of progress.
#include "app/watch/progress.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(Progress, SaysTimeStepWhoseDriftAndWhatIsLeft) {
  // A quarter is done in 30 s: three times as long is left.
  EXPECT_EQ(progress_text({20e-6, 80e-6, 612, 32.84e-9, "bar: element", -2e-5, 30}),
            " 25.0 %  20 us of 80 us  step 612  dt 32.84 ns (bar: element)  drift 2e-05  "
            "1 min 30 s left");
}

TEST(Progress, PredictsNothingFromTheFirstInstants) {
  const std::string text = progress_text({1e-9, 80e-6, 1, 1e-9, "bar: element", 0, 30});
  EXPECT_EQ(text.find("left"), std::string::npos) << text;
}

TEST(Progress, DurationsAsOneSaysThem) {
  EXPECT_EQ(duration_text(0.4), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(7 * 3600 + 125), "7 h 02 min");
}

}  // namespace
}  // namespace brunt
