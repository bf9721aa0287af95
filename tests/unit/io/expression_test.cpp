// Expressions: dimensions follow by evaluating in other base units, whose factors are powers of
// two, so that values are exact and only functions such as sqrt round (DOUBLE_EQ: 4 units).
#include "io/deck/expression.hpp"
#include "io/deck/column_expression.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace brunt {
namespace {

class ExpressionTest : public ::testing::Test {
 protected:
  ExpressionTest() {
    add("size", "0.4 mm");
    add("gap", "5 mm");
    add("speed", "139 m/s");
    add("time", "2 s");
    add("angle", "30 deg");
    add("n", "3");
  }
  void add(const char* name, const char* text) {
    const QuantityValue read = units_.read(text);
    parameters_[name] = {read.value, read.dimension, read.has_unit};
  }
  void expect(const char* text, Real value, const char* unit) const {
    const ExpressionResult result = evaluate_expression(text, parameters_);
    EXPECT_EQ(result.problem, "") << text;
    EXPECT_DOUBLE_EQ(result.value, value) << text;
    EXPECT_EQ(result.dimension, units_.dimension_of(unit)) << text;
  }
  std::string problem(const char* text) const {
    return evaluate_expression(text, parameters_).problem;
  }
  Units units_;
  ParameterValues parameters_;
};

TEST_F(ExpressionTest, QuantitiesKeepTheirDimensions) {
  expect("= -$speed", -139, "m/s");
  expect("= 2*$size + 0.1*$gap", 1.3e-3, "m");
  expect("= $gap/$size", 12.5, "1");
  expect("= $speed/$time", 69.5, "m/s^2");
  expect("= sqrt($gap*$size)", std::sqrt(5e-3 * 0.4e-3), "m");
  expect("= max($size, $gap)", 5e-3, "m");
  expect("= $gap > $size ? $gap : $size", 5e-3, "m");
  expect("= sin($angle)", 0.5, "1");
  expect("= pi*$n", 3 * kPi, "1");
  expect("= 2^3", 8, "1");
}

TEST_F(ExpressionTest, MixedDimensionsCannotPass) {
  for (const char* text :
       {"= $size + 1", "= $size + $speed", "= max($size, 1)", "= sin($size)", "= $size - 0.0004",
        "= exp($gap/$time)", "= rint($gap)", "= sqrt($size)", "= $speed == 139 ? $size : 1"}) {
    EXPECT_NE(problem(text).find("dimension"), std::string::npos) << text << ": " << problem(text);
  }
}

TEST_F(ExpressionTest, WhatIsNoExpressionIsRefused) {
  for (const char* text : {"=", "= ", "= 2 +", "= $nobody", "= speed", "= $size = 3", "= 1/0",
                           "= sqrt(-1)", "= \"a\"", "= 1, 2", "= a(", "= ((((", "= {3}"}) {
    EXPECT_NE(problem(text), "") << text;
  }
  EXPECT_NE(problem("= speed").find("a parameter is written $speed"), std::string::npos);
}

TEST_F(ExpressionTest, NumbersWithoutUnitAreBare) {
  EXPECT_TRUE(evaluate_expression("= 2*$n", parameters_).bare);
  EXPECT_FALSE(evaluate_expression("= 2*$size", parameters_).bare);
}

TEST_F(ExpressionTest, FindsNamesAndVariables) {
  EXPECT_EQ(names_in("= $a + $b_2*$a + $$"), (std::vector<std::string>{"a", "b_2"}));
  EXPECT_TRUE(depends_on("= 3*t", kTimeAndPlace));
  EXPECT_TRUE(depends_on("=x", kTimeAndPlace));
  EXPECT_FALSE(depends_on("= exp(3) + $t + max(1, 2)", kTimeAndPlace));
  EXPECT_FALSE(depends_on("= 3*t", kSliding));
  EXPECT_EQ(arguments_in("= v*(yield + $p + exp(T))", kSliding),
            (std::array<bool, 4>{true, true, false, true}));
}

TEST_F(ExpressionTest, OfTimeAndPlaceFromManyThreads) {
  const CompiledExpression compiled =
      compile_expression("= $gap*t + x - y*z", parameters_, kTimeAndPlace);
  ASSERT_EQ(compiled.problem, "");
  EXPECT_EQ(compiled.text, "= (0.005)*t + x - y*z");
  const auto copy = compiled.evaluate;
  std::vector<int> wrong(4);
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&, k] {
      for (int i = 0; i < 2000; ++i) {
        const Real t = i + 1000 * k;
        const Real expected = 0.005 * t + 1 - 2 * 3.0;
        if (copy({t, 1, 2, 3}) != expected) ++wrong[static_cast<std::size_t>(k)];
      }
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4));
}

TEST_F(ExpressionTest, OfTheStateOfSliding) {
  const auto compiled = compile_expression("= $n*T - yield + p/v", parameters_, kSliding);
  ASSERT_EQ(compiled.problem, "");
  EXPECT_EQ(compiled.evaluate({2, 3, 8, 4}), parameters_.at("n").value * 2 - 3 + 2);
  EXPECT_NE(compile_expression("= t", parameters_, kSliding).problem.find("of T, yield, p, v"),
            std::string::npos);
}

TEST_F(ExpressionTest, FormulaOverMeasures) {
  const auto lookup = [](const std::string& name) -> std::optional<Real> {
    if (name == "a") return 3;
    if (name == "b") return 4;
    return std::nullopt;
  };
  EXPECT_EQ(evaluate_formula("= $a / $b", lookup), 0.75);
  EXPECT_THROW(evaluate_formula("= $c", lookup), std::invalid_argument);
  EXPECT_THROW(evaluate_formula("= $a +", lookup), std::invalid_argument);
}

TEST(ColumnExpression, TakesTheLongestColumn) {
  const std::vector<std::string> columns{"time",
                                         "step",
                                         "contact.a",
                                         "b.force.x",
                                         "contact.a-b.force.x",
                                         "body.a.velocity.x",
                                         "body.a.velocity.x.mean"};
  const std::vector<Real> row{0.5, 7, 100, 10, 3, -2, 40};
  const auto value = [&](const std::string& text) { return ColumnExpression(text, columns)(row); };
  EXPECT_EQ(value("= contact.a-b.force.x"), 3);
  EXPECT_EQ(value("= contact.a - b.force.x"), 90);
  EXPECT_EQ(value("= body.a.velocity.x.mean/2"), 20);
  EXPECT_EQ(value("= -body.a.velocity.x + step*time"), 5.5);
  EXPECT_EQ(value("= time > 1e-1 && body.a.velocity.x<0 && step == 7"), 1);
  EXPECT_EQ(value("= max(time, step) + pi*0 + 2.5"), 9.5);
  EXPECT_EQ(value("= 3"), 3);
}

TEST(ColumnExpression, SaysWhatItDoesNotKnow) {
  const std::vector<std::string> columns{"time", "body.a.velocity.x"};
  EXPECT_EQ(unknown_columns_in("= body.a.velocity.y > 0.5 && time > 1.5e-3 && b.x", columns),
            (std::vector<std::string>{"body.a.velocity.y", "b.x"}));
  for (const char* const wrong : {"= tim > 1", "= time >", "= time = 1", "= (time", "= time, time",
                                  "= body.a.velocity.xx > 0", "=", "= time > 'a'"}) {
    EXPECT_THROW(ColumnExpression(wrong, columns), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace brunt
