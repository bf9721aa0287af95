// Measures on a small body by hand.
#include "app/watch/measures.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace brunt {
namespace {

/// Two particles of masses 1 and 3 at x = 0 and 2, radius 0.5, in one row.
BodyView particles() {
  BodyView view;
  view.body = "dust";
  view.position = {0, 0, 0, 2, 0, 0};
  view.point_mass = {1, 3};
  view.point_radius = {0.5, 0.5};
  view.point_fields = {{"velocity", 3, {3, 4, 0, 0, 0, 1}},
                       {"stress", 6, {1, 2, 3, 4, 5, 6, 0, 0, 0, 0, 0, 0}},
                       {"temperature", 1, {300, 400}}};
  return view;
}

struct Measures : testing::Test {
  BodyView view = particles();
  std::map<std::string, BodyView> start{{"dust", particles()}};
  std::vector<std::string> columns{"time", "force"};
  std::vector<std::vector<Real>> rows{{0, 0}, {1, 2}, {2, 2}, {4, 0}};
  MeasureSource source{[this](const std::string&) -> const BodyView& { return view; }, &start,
                       &columns, &rows};

  Real value(deck::MeasureKind kind, const std::vector<MeasureValue>& before = {}) {
    return evaluate_measure({std::move(kind), {}, {}, {}}, source, before);
  }
};

TEST_F(Measures, ReadBodies) {
  EXPECT_EQ(value(deck::ExtentMeasure{"dust", deck::Axis::x}), 3);  // radii count
  EXPECT_EQ(value(deck::MaxMeasure{"dust", "velocity.magnitude", {}}), 5);
  EXPECT_EQ(value(deck::MinMeasure{"dust", "velocity.x", {}}), 0);
  EXPECT_EQ(value(deck::MeanMeasure{"dust", "temperature", {}}), 375);
  EXPECT_EQ(value(deck::MaxMeasure{"dust", "stress.xz", {}}), 6);
  EXPECT_EQ(value(deck::PointMeasure{"dust", "temperature", {1.9, 0}}), 400);
  EXPECT_EQ(unit_of(deck::Measure{deck::SpeedMeasure{"dust"}, {}, {}, {}}), std::string("m/s"));
  view.point_fields[0].values = {3, 0, 4, 3, 0, 4};
  EXPECT_DOUBLE_EQ(value(deck::SpeedMeasure{"dust"}), 5);
  view.point_fields[0].values = {0, 0, 0, 0, 0, 0};
  EXPECT_EQ(value(deck::SpeedMeasure{"dust"}), 0);
  EXPECT_EQ(value(deck::RestitutionMeasure{"dust"}), 0);
}

TEST(MeasureReads, NameTheBodyAndItsField) {
  const auto reads = [](deck::MeasureKind kind) { return reads_of({std::move(kind), {}, {}, {}}); };
  const auto stress = reads(deck::MaxMeasure{"dust", "stress.xz", {}});
  EXPECT_EQ(stress->body, "dust");
  EXPECT_EQ(*stress->fields.names, std::vector<std::string>{"stress"});
  EXPECT_FALSE(stress->at_start);
  const auto bounce = reads(deck::RestitutionMeasure{"dust"});
  EXPECT_TRUE(bounce->fields.has("velocity") && bounce->at_start);
  EXPECT_FALSE(bounce->fields.has("stress"));
  EXPECT_TRUE(reads(deck::SpeedMeasure{"dust"})->fields.has("velocity"));
  EXPECT_TRUE(reads(deck::ExtentMeasure{"dust", deck::Axis::x})->fields.names->empty());
  EXPECT_TRUE(reads(deck::PointMeasure{"dust", "temperature", {0, 0}})->at_start);
  EXPECT_FALSE(reads(deck::HistoryMeasure{"force", deck::Reduce::max, {}, {}}).has_value());
  EXPECT_TRUE(WantedFields{}.has("anything"));
}

TEST_F(Measures, ReduceHistory) {
  EXPECT_EQ(value(deck::HistoryMeasure{"force", deck::Reduce::max, {}, {}}), 2);
  EXPECT_EQ(value(deck::HistoryMeasure{"force", deck::Reduce::mean, 1.0, 2.0}), 2);
  EXPECT_EQ(value(deck::HistoryMeasure{"force", deck::Reduce::integral, {}, {}}), 1 + 2 + 2);
  EXPECT_EQ(value(deck::HistoryMeasure{"force", deck::Reduce::last, {}, {}}), 0);
  EXPECT_THROW(value(deck::HistoryMeasure{"farce", deck::Reduce::last, {}, {}}),
               std::invalid_argument);
}

TEST_F(Measures, CombineMeasures) {
  const std::vector<MeasureValue> before{{"a", 6, "m", {}, {}}, {"b", 3, "m", {}, {}}};
  EXPECT_EQ(value(deck::ExpressionMeasure{"= $a / $b"}, before), 2);
  EXPECT_THROW(value(deck::ExpressionMeasure{"= $a / $c"}, before), std::invalid_argument);
  EXPECT_THROW(value(deck::MaxMeasure{"dust", "porosity", {}}), std::invalid_argument);
  EXPECT_THROW(value(deck::MaxMeasure{"dust", "velocity.w", {}}), std::invalid_argument);
}

}  // namespace
}  // namespace brunt
