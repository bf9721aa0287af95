// Errors, fronts, fits, tables, files and the chart of runs made up by hand:
// length = 10 + 0.5 h^2 at sizes 1, 2, 4, which cost 16, 4 and 1 s.
#include "app/trade/results.hpp"

#include <gtest/gtest.h>

#include "app/trade/chart.hpp"
#include "app/trade/report.hpp"

namespace brunt {
namespace {

class TradeResults : public testing::Test {
 protected:
  TradeResults() {
    for (const double size : {4.0, 2.0, 1.0}) {
      Variant variant;
      variant.label = "size " + std::to_string(static_cast<int>(size));
      variant.choices = {static_cast<int>(variants_.size())};
      Named<deck::Body> body;
      body.name = "bar";
      body.value.size = std::vector<Real>(3, size);
      variant.loaded.deck.bodies.push_back(body);
      variant.loaded.deck.title = "a <bar> & more";
      variants_.push_back(variant);
      VariantRuns runs;
      runs.done = true;
      const auto cells = static_cast<std::int64_t>(64 / (size * size * size));
      runs.summary.elements = cells;
      runs.summary.points = 2 * cells;
      runs.summary.steps = static_cast<std::int64_t>(100 / size);
      runs.summary.measures = {{"length", 10 + 0.5 * size * size, "m", 11.0, 0.0, 10.0},
                               {"still", 1e-3 * size, "m/s", {}, {}, 0.0}};
      runs.summary.energy.created = 0.01;
      runs.summary.energy.sources = {{"bar.artificial_stress", 0.02}, {"contact.pairs", 0.03}};
      runs.summary.energy.taken = {{"artificial_stress", 0.05}};
      runs.processor = repeated({16 / (size * size)});
      runs.memory = repeated({1e6});
      study_.runs.push_back(runs);
    }
    varies_.resize(1);
    varies_[0].label = "size";
  }
  Trade trade(std::optional<Against> against = std::nullopt) const {
    return evaluate_trade(variants_, varies_, study_, against);
  }
  std::vector<Variant> variants_;
  std::vector<Vary> varies_;
  StudyResult study_;
};

TEST_F(TradeResults, ErrorsAreSignedAndRelativeOrOfTheUnit) {
  EXPECT_DOUBLE_EQ(signed_error(9, -10).error, 1.9);
  EXPECT_TRUE(signed_error(9, -10).relative);
  EXPECT_DOUBLE_EQ(signed_error(-0.5, 0).error, -0.5);
  EXPECT_FALSE(signed_error(-0.5, 0).relative);
  const Trade all = trade();
  const auto& length = all.rows[0].measures[0];
  EXPECT_DOUBLE_EQ(length.exact->error, 0.8);                  // 18 to 10
  EXPECT_DOUBLE_EQ(length.finest->error, (18 - 10.5) / 10.5);  // size 1
  EXPECT_DOUBLE_EQ(length.reference->error, 7.0 / 11);
  EXPECT_EQ(*all.finest, 2u);
}

TEST_F(TradeResults, WhatIsCheaperAndNoWorseIsOnTheFront) {
  study_.runs[1].processor = repeated({20});  // size 2 costs more than size 1
  const Trade all = trade();
  EXPECT_EQ(all.fronts[0].against, Against::exact);
  EXPECT_FALSE(all.fronts[0].dominated_by[0]);
  EXPECT_EQ(all.fronts[0].dominated_by[1], 2u);
  EXPECT_FALSE(all.fronts[0].dominated_by[2]);
  // Of all measures only relative errors count, and the largest.
  EXPECT_EQ(all.fronts.back().measure, "all");
  EXPECT_DOUBLE_EQ(all.fronts.back().errors[0]->error, 0.8);
}

TEST_F(TradeResults, TheFinestIsNoneOfItsOwnFront) {
  const Trade all = trade(Against::finest);
  EXPECT_EQ(all.fronts[0].errors[2]->error, 0);
  EXPECT_FALSE(all.fronts[0].dominated_by[1]);  // not by the finest
  EXPECT_NE(trade_text(all).find("the finest"), std::string::npos);
}

TEST_F(TradeResults, FitsAlongTheSize) {
  const Trade all = trade();
  ASSERT_EQ(all.fits.size(), 2u);
  const Convergence& fit = all.fits[0].convergence;
  EXPECT_TRUE(fit.asymptotic);
  EXPECT_NEAR(*fit.order, 2, 1e-9);
  EXPECT_NEAR(*fit.limit, 10, 1e-9);
  // 1.25 |f2 - f1|/(r - 1), at first order: that is all that three sizes vouch for.
  EXPECT_NEAR(fit.bound, 1.25 * 1.5, 1e-9);
}

TEST_F(TradeResults, SharesAreWhatWasTakenLessWhatWasGiven) {
  const Trade all = trade();
  EXPECT_DOUBLE_EQ(all.rows[0].artificial_stress, 0.05 - 0.02);
  EXPECT_DOUBLE_EQ(all.rows[0].contact_pairs, -0.03);
}

TEST_F(TradeResults, ARunThatBrokeIsARowWithoutNumbers) {
  study_.runs[2].done = false;
  study_.runs[2].problem = "volume of element 3";
  const Trade all = trade();
  EXPECT_EQ(*all.finest, 1u);
  EXPECT_NE(trade_text(all).find("volume of element 3"), std::string::npos);
  EXPECT_NE(trade_json(all).find("\"problem\": \"volume of element 3\""), std::string::npos);
}

TEST_F(TradeResults, FilesHoldEveryDigit) {
  study_.runs[0].summary.measures[0].value = 1.0 / 3;
  const Trade all = trade();
  EXPECT_NE(trade_csv(all).find("size 4,length,m,0.3333333333333333,"), std::string::npos);
  EXPECT_NE(trade_json(all).find("\"value\": 0.3333333333333333"), std::string::npos);
}

TEST_F(TradeResults, ChartHasAPanelAMeasureAndAMarkARun) {
  const Drawing chart = trade_chart(trade());
  // Three panels; two marks in the legend and three in each panel.
  EXPECT_EQ(chart.marks.size(), 2u + 3 * 3);
  for (const auto& mark : chart.marks) {
    EXPECT_GE(mark.x, 0);
    EXPECT_LE(mark.x, chart.width);
    EXPECT_GE(mark.y, 0);
    EXPECT_LE(mark.y, chart.height);
  }
  const auto svg = to_svg(chart);
  EXPECT_NE(svg.find("a &lt;bar&gt; &amp; more"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST_F(TradeResults, TicksAreRound) {
  EXPECT_EQ(log_ticks(0.9, 11), (std::vector<Real>{1, 2, 5, 10}));
  EXPECT_EQ(log_ticks(0.5, 2000).size(), 4u);  // 1, 10, 100, 1000
}

}  // namespace
}  // namespace brunt
