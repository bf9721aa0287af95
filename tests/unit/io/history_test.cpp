// Numbers of history.csv and the file itself. Expected texts follow from the definition of the
// shortest decimal that rounds to the same double; no tolerance anywhere: it is the same bits or
// not.
#include "io/history.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <random>

#include "core/errors.hpp"
#include "io/number.hpp"
#include "tests/unit/io/scratch_folder.hpp"

namespace brunt {
namespace {

TEST(Number, IsTheShortestText) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(shortest(-2.0), "-2");
  EXPECT_EQ(shortest(2e-6), "2e-06");
  EXPECT_EQ(shortest(5e-324), "5e-324");
  EXPECT_EQ(shortest(-std::nan("")), "nan");
  EXPECT_EQ(shortest(-kInfinity), "-inf");
}

TEST(Number, ReadsBackAsTheSameBits) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const Real value = std::bit_cast<Real>(random());
    if (std::isnan(value)) continue;
    const auto back = parse_real(shortest(value));
    ASSERT_TRUE(back.has_value());
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value));
  }
}

TEST(Number, ParsesOnlyWholeTexts) {
  EXPECT_FALSE(parse_real("").has_value());
  EXPECT_FALSE(parse_real("1 ").has_value());
  EXPECT_FALSE(parse_real("1.5x").has_value());
  EXPECT_EQ(parse_real("-1.5e3"), -1500.0);
}

TEST(Number, RoundsForPeople) {
  EXPECT_EQ(rounded(1.0 / 3, 4), "0.3333");
  EXPECT_EQ(rounded(12.5, 6), "12.5");
  EXPECT_EQ(rounded(1.23456789e-9, 3), "1.23e-09");
}

class HistoryTest : public test::ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    path_ = folder_ / "history.csv";
  }
  std::filesystem::path path_;
};

const std::vector<std::string> kColumns3 = {"time", "step", "state_hash"};

TEST_F(HistoryTest, WritesNamesAndRows) {
  HistoryWriter history(path_, kColumns3);
  history.write_row(std::vector<HistoryValue>{0.0, std::int64_t{0}, std::uint64_t{1}});
  history.write_row(
      std::vector<HistoryValue>{0.1, std::int64_t{1000000}, std::uint64_t{18446744073709551615u}});
  EXPECT_EQ(read_file(path_), "time,step,state_hash\n0,0,1\n0.1,1000000,18446744073709551615\n");
  EXPECT_THROW(history.write_row(std::vector<HistoryValue>{0.2}), std::invalid_argument);
}

TEST_F(HistoryTest, GoesOnAfterARestart) {
  {
    HistoryWriter history(path_, kColumns3);
    for (int i = 0; i < 4; ++i) {
      history.write_row(std::vector<HistoryValue>{0.1 * i, std::int64_t{i}, std::uint64_t{9}});
    }
  }
  std::ofstream(path_, std::ios::app) << "0.4,4";  // a row that a power cut left unfinished
  auto history = HistoryWriter::resume(path_, kColumns3, 0.1 * 2);
  history.write_row(std::vector<HistoryValue>{0.25, std::int64_t{3}, std::uint64_t{8}});
  EXPECT_EQ(read_file(path_), "time,step,state_hash\n0,0,9\n0.1,1,9\n0.2,2,9\n0.25,3,8\n");
  EXPECT_THROW(HistoryWriter::resume(path_, {"time", "dt"}, 1.0), MachineError);
}

TEST_F(HistoryTest, ReadsBack) {
  {
    HistoryWriter history(path_, {"time", "force.x"});
    history.write_row(std::vector<HistoryValue>{0.1, 1.0 / 3});
    history.write_row(std::vector<HistoryValue>{0.2, -kInfinity});
  }
  std::ofstream(path_, std::ios::app) << "0.3,5";
  const History history = read_history(path_);
  EXPECT_EQ(history.columns, (std::vector<std::string>{"time", "force.x"}));
  ASSERT_EQ(history.rows.size(), 2u);
  EXPECT_EQ(history.rows[0][1], 1.0 / 3);
  EXPECT_EQ(history.rows[1][1], -kInfinity);
  EXPECT_EQ(history.index("force.x"), 1);
  EXPECT_EQ(history.index("force.y"), -1);
}

TEST_F(HistoryTest, SaysWhichLineIsBroken) {
  write_file_atomically(path_, "time,a\n0,1\n0.1,x\n");
  try {
    read_history(path_);
    FAIL() << "accepted a row that is no number";
  } catch (const MachineError& error) {
    EXPECT_NE(std::string(error.what()).find("line 3: 'x'"), std::string::npos) << error.what();
  }
  write_file_atomically(path_, "time,a\n0\n");
  EXPECT_THROW(read_history(path_), MachineError);
}

}  // namespace
}  // namespace brunt
