// Which columns become charts, and that a chart of many rows keeps its peaks.
#include "app/report/curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/report/page.hpp"

namespace brunt {
namespace {

TEST(Curves, VectorsAreShownByTheirLengthAndZerosAreLeftOut) {
  const History history{
      {"time", "dt", "energy.kinetic", "energy.drift", "energy.damping", "contact.a-b.force.x",
       "contact.a-b.force.y", "contact.a-b.torque.z", "body.a.velocity.x", "body.a.velocity.y"},
      {{0, 1, 5, 1e-9, 0, 0, 0, 7, 0, 0}, {1, 1, 4, 1e-9, 0, 3, -4, 7, 0, 0}}};
  const auto charts = charts_of(history);
  ASSERT_EQ(charts.size(), 3u);
  EXPECT_EQ(charts[0].title, "Energies");
  ASSERT_EQ(charts[0].curves.size(), 1u) << "drift is no energy, and damping is zero";
  EXPECT_EQ(charts[0].curves[0].name, "kinetic");
  EXPECT_EQ(charts[1].title, "Contact forces");
  ASSERT_EQ(charts[1].curves.size(), 1u);
  EXPECT_EQ(charts[1].curves[0].name, "a-b");
  EXPECT_EQ(charts[1].curves[0].values, (std::vector<Real>{0, 5}));
  EXPECT_EQ(charts[2].title, "Time step");
}

TEST(Curves, TheLargestEightStayOfMany) {
  History history{{"time"}, {{0}, {1}}};
  for (int b = 0; b < 20; ++b) {
    history.columns.push_back("body.b" + std::to_string(b) + ".velocity.x");
    history.rows[0].push_back(0), history.rows[1].push_back(b);
  }
  const auto charts = charts_of(history);
  ASSERT_EQ(charts.size(), 1u);
  ASSERT_EQ(charts[0].curves.size(), 8u);
  EXPECT_EQ(charts[0].curves.front().name, "b19");
  EXPECT_EQ(charts[0].curves.back().name, "b12");
}

// One row of 10,000 is a peak: its line reaches as high as the axis' room of 4 % allows.
TEST(Curves, AChartOfManyRowsKeepsAPeakOfOne) {
  CurveChart chart{"t", "N", {{"f", std::vector<Real>(10'000, 0.0)}}};
  chart.curves[0].values[4321] = 1;
  std::vector<Real> time(10'000);
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = 1e-6 * static_cast<Real>(i);
  const Drawing drawing = draw_chart(chart, time);
  Real top = kInfinity, axis_top = kInfinity, axis_foot = 0;
  std::size_t n = 0;
  for (const auto& line : drawing.lines) {
    if (line.width == 1.6) top = std::min({top, line.y0, line.y1}), ++n;
    if (line.width == 1.5 && line.x0 == line.x1) axis_top = line.y1, axis_foot = line.y0;
  }
  EXPECT_LE(n, 601u);
  EXPECT_NEAR((axis_foot - top) / (axis_foot - axis_top), 1 / 1.04, 1e-9);
}

TEST(Curves, TicksAreRoundAndWithinTheAxis) {
  EXPECT_EQ(linear_ticks(0, 10, 5), (std::vector<Real>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(linear_ticks(-1, 1, 4), (std::vector<Real>{-1, -0.5, 0, 0.5, 1}));
  EXPECT_TRUE(linear_ticks(1, 1, 4).empty());
  for (const Real tick : linear_ticks(3.7e-6, 8.1e-5, 6)) {
    EXPECT_GE(tick, 3.7e-6);
    EXPECT_LE(tick, 8.1e-5);
  }
}

// Section 10 of RFC 4648.
TEST(Base64, IsThatOfItsStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

}  // namespace
}  // namespace brunt
