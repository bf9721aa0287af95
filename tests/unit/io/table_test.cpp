// The table at the end of a sweep. Expected texts are written out by hand from the runs below.
#include "io/table.hpp"

#include <gtest/gtest.h>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "tests/support/own_file.hpp"

namespace brunt {
namespace {

TableRun run(const std::string& folder, const std::string& speed, Real length) {
  RunSummary s;
  s.version = "0.1.0";
  s.parameters = {{"speed", speed}, {"size", "1 mm"}};
  s.measures = {{"length", length, "m", 0.02, length / 0.02 - 1}};
  s.wall_seconds = 2.5;
  s.drift = 1e-12;
  s.phases = {{"contact", 0.5}};
  s.steps = 1234567;
  return {folder, s, ""};
}

std::vector<TableRun> two_runs_and_a_broken_one() {
  return {run("a", "100 m/s", 0.025), run("bb", "200 m/s", 1.0 / 3), {"c", {}, "no summary"}};
}

TEST(Table, ShowsWhatDiffersAndAllMeasures) {
  EXPECT_EQ(format_table(two_runs_and_a_broken_one(), {}),
            "run  speed    length [m]  wall_seconds [s]  drift  status\n"
            "a    100 m/s       0.025               2.5  1e-12  done\n"
            "bb   200 m/s    0.333333               2.5  1e-12  done\n"
            "c    -                 -                 -      -  no summary\n");
}

TEST(Table, WritesAllDigitsAsCsv) {
  EXPECT_EQ(format_table(two_runs_and_a_broken_one(), {{}, true}),
            "run,speed,length [m],wall_seconds [s],drift,status\n"
            "a,100 m/s,0.025,2.5,1e-12,done\n"
            "bb,200 m/s,0.3333333333333333,2.5,1e-12,done\n"
            "c,,,,,no summary\n");
}

TEST(Table, ShowsTheKeysAskedFor) {
  const std::vector<std::string> keys = {"size", "length.error", "phases.contact", "steps"};
  EXPECT_EQ(format_table({run("a", "1 m/s", 0.025)}, {keys, true}),
            "run,size,length.error,phases.contact [s],steps\n"
            "a,1 mm,0.25,0.5,1234567\n");
}

TEST(Table, ShowsTheLastRowOfAColumnOfTheHistory) {
  const auto folder = std::filesystem::path(test::own_file("table_history"));
  create_folder(folder);
  write_file_atomically(folder / "history.csv", "time,energy.kinetic,length\n0,1,2\n0.5,0.125,3\n");
  auto one = run(folder.string(), "1 m/s", 0.025);
  one.summary->cpu_seconds = 1.5;
  // A name that is a measure too is the measure; history.NAME says the column.
  EXPECT_EQ(
      format_table({one}, {{"energy.kinetic", "length", "history.length", "cpu_seconds"}, true}),
      "run,energy.kinetic,length [m],history.length,cpu_seconds [s]\n" + folder.string() +
          ",0.125,0.025,3,1.5\n");
  std::filesystem::remove_all(folder);
}

TEST(Table, RefusesAKeyThatNoRunHas) {
  try {
    format_table(two_runs_and_a_broken_one(), {{"sped"}, false});
    FAIL() << "accepted a key that is nowhere";
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find("--show: sped: "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(" speed "), std::string::npos) << error.what();
  }
}

TEST(Table, QuotesCsvAndAlignsUtf8) {
  auto a = run("a,b", "1 \"m\"", 0.02);
  auto b = run("b", "2 µm", 0.02);
  EXPECT_EQ(format_table({a, b}, {{"speed"}, true}),
            "run,speed\n\"a,b\",\"1 \"\"m\"\"\"\nb,2 µm\n");
  EXPECT_EQ(format_table({a, b}, {{"speed", "steps"}, false}),
            "run  speed    steps\n"
            "a,b  1 \"m\"  1234567\n"
            "b    2 µm   1234567\n");
}

TEST(Table, ReadsFoldersAndReportsBrokenOnes) {
  const auto root = std::filesystem::path(test::own_file("table_runs"));
  std::filesystem::remove_all(root);
  for (const char* name : {"good", "empty", "broken"}) create_folder(root / name);
  write_summary(root / "good", *run("", "1 m/s", 0.02).summary);
  write_file_atomically(root / "broken" / "summary.json", "{\"version\": ");
  const auto runs = read_runs({root / "good/", root / "empty", root / "broken", root / "gone"});
  std::filesystem::remove_all(root);
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0].folder, (root / "good").string());
  EXPECT_TRUE(runs[0].summary.has_value());
  EXPECT_EQ(runs[1].problem, "no summary");
  EXPECT_EQ(runs[2].problem, "broken summary");
  EXPECT_EQ(runs[3].problem, "no folder");
  EXPECT_NO_THROW(format_table({runs[1], runs[2]}, {{"anything"}, false}));
}

}  // namespace
}  // namespace brunt
