// summary.json: what is written reads back the same (doubles to the bit, so no tolerance), keys are
// those a sweep relies on, and a file that is no summary is an error with its name.
#include "io/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "tests/support/own_file.hpp"

namespace brunt {
namespace {

RunSummary example() {
  RunSummary s;
  s.version = "0.1.0";
  s.deck_hash = "9f86d0";
  s.parameters = {{"speed", "190 m/s"}, {"mu", "0.3"}};
  s.overrides = {"time.end=1 us"};
  s.status = 3;
  s.reason = "element 12 of bar: volume = -1e-9";
  s.steps = 123456789012;
  s.wall_seconds = 1.0 / 3;
  s.cpu_seconds = 2.0 / 3;
  s.first_step = 17;
  s.planned_steps = 99;
  s.planned_memory = 1.5e8;
  s.points = 5;
  s.elements = 2;
  s.particles = 7;
  s.phases = {{"elements", 0.25}, {"contact", 0.125}};
  s.loop_seconds = 0.75;
  s.start_seconds = 0.125;
  s.ns_element_step = 95.5;
  s.ns_particle_step = std::nan("");
  s.peak_memory = 123456768;
  s.drift = -1.25e-13;
  s.state_hash = "16045690984833335023";
  s.step_margins = {{"bar", 1.25}, {"plate", 0.75}};
  s.process_speed = 10;
  s.distorts = "inertia";
  s.inertia = {{"bar", 0.25, 1.0 / 3}, {"all", 0, 0.5}};
  s.measures = {{"length", 0.0173, "m", 0.017, 0.0173 / 0.017 - 1}, {"bounce", 0.5, "", {}, {}}};
  s.measures[1].exact = 0.5;
  s.measures[1].time = 2e-6;
  s.measures[1].bound = 0.25;
  s.measures[1].order = 1.75;
  s.measures[1].convergence = "order 1.8";
  s.warnings = {{"coarse-body", "body 'a': \"one\" element"}};
  s.pairs = {600, 1500};
  s.contact_lists = 3;
  s.ranks = 4;
  s.threads = 2;
  s.instruction_set = "x86-64-v3";
  return s;
}

TEST(Summary, ReadsBackTheSame) {
  const RunSummary a = example();
  const RunSummary b = parse_summary(to_json(a), "summary.json");
  EXPECT_EQ(b.version, a.version);
  EXPECT_EQ(b.deck_hash, a.deck_hash);
  EXPECT_EQ(b.parameters, a.parameters);
  EXPECT_EQ(b.overrides, a.overrides);
  EXPECT_EQ(b.status, a.status);
  EXPECT_EQ(b.reason, a.reason);
  EXPECT_EQ(b.steps, a.steps);
  EXPECT_EQ(b.wall_seconds, a.wall_seconds);
  EXPECT_EQ(b.cpu_seconds, a.cpu_seconds);
  EXPECT_EQ(b.first_step, a.first_step);
  EXPECT_EQ(b.planned_steps, a.planned_steps);
  EXPECT_EQ(b.planned_memory, a.planned_memory);
  EXPECT_EQ(b.points, a.points);
  EXPECT_EQ(b.elements, a.elements);
  EXPECT_EQ(b.particles, a.particles);
  EXPECT_EQ(b.phases, a.phases);
  EXPECT_EQ(b.loop_seconds, a.loop_seconds);
  EXPECT_EQ(b.start_seconds, a.start_seconds);
  EXPECT_EQ(b.ns_element_step, a.ns_element_step);
  EXPECT_TRUE(std::isnan(b.ns_particle_step));
  EXPECT_EQ(b.peak_memory, a.peak_memory);
  EXPECT_EQ(b.drift, a.drift);
  EXPECT_EQ(b.state_hash, a.state_hash);
  EXPECT_EQ(b.step_margins, a.step_margins);
  EXPECT_EQ(b.process_speed, a.process_speed);
  EXPECT_EQ(b.distorts, a.distorts);
  ASSERT_EQ(b.inertia.size(), 2u);
  EXPECT_EQ(b.inertia[0].body, "bar");
  EXPECT_EQ(b.inertia[0].end, a.inertia[0].end);
  EXPECT_EQ(b.inertia[0].mean, a.inertia[0].mean);
  ASSERT_EQ(b.measures.size(), 2u);
  EXPECT_EQ(b.measures[0].name, "length");
  EXPECT_EQ(b.measures[0].value, a.measures[0].value);
  EXPECT_EQ(b.measures[0].unit, "m");
  EXPECT_EQ(b.measures[0].reference, a.measures[0].reference);
  EXPECT_EQ(b.measures[0].error, a.measures[0].error);
  EXPECT_EQ(b.measures[1].name, "bounce");
  EXPECT_FALSE(b.measures[1].reference.has_value());
  EXPECT_FALSE(b.measures[1].error.has_value());
  EXPECT_FALSE(b.measures[0].exact || b.measures[0].bound || b.measures[0].order);
  EXPECT_EQ(b.measures[1].exact, a.measures[1].exact);
  EXPECT_FALSE(b.measures[0].time);
  EXPECT_EQ(b.measures[1].time, a.measures[1].time);
  EXPECT_EQ(b.measures[1].bound, a.measures[1].bound);
  EXPECT_EQ(b.measures[1].order, a.measures[1].order);
  EXPECT_EQ(b.measures[1].convergence, a.measures[1].convergence);
  ASSERT_EQ(b.warnings.size(), 1u);
  EXPECT_EQ(b.warnings[0].id, a.warnings[0].id);
  EXPECT_EQ(b.warnings[0].text, a.warnings[0].text);
  EXPECT_EQ(b.pairs.in_support, 600);
  EXPECT_EQ(b.pairs.compared, 1500);
  EXPECT_EQ(b.pairs.hit_rate(), 0.4);
  EXPECT_EQ(b.contact_lists, 3);
  EXPECT_EQ(b.ranks, 4);
  EXPECT_EQ(b.threads, 2);
  EXPECT_EQ(b.instruction_set, a.instruction_set);
}

TEST(Summary, KeepsTheKeysThatSweepsRead) {
  const std::string text = to_json(example());
  for (const char* key : {"version",       "deck_hash",    "parameters",      "overrides",
                          "status",        "reason",       "steps",           "wall_seconds",
                          "start_seconds", "points",       "elements",        "particles",
                          "phases",        "loop_seconds", "ns_element_step", "ns_particle_step",
                          "peak_memory",   "drift",        "state_hash",      "measures",
                          "warnings",      "ranks",        "threads",         "instruction_set",
                          "value",         "unit",         "reference",       "error"}) {
    const std::string quoted = std::string(1, '"') + key + "\":";
    EXPECT_NE(text.find(quoted), std::string::npos) << key;
  }
}

TEST(Summary, SurvivesTextThatIsNotUtf8) {
  RunSummary s = example();
  s.reason = "bad \xff byte";
  EXPECT_NE(parse_summary(to_json(s), "x").reason.find("bad "), std::string::npos);
}

TEST(Summary, RefusesWhatIsNoSummary) {
  for (const char* text :
       {"", "{", "[]", "{\"version\": \"1\"}", "null", "{\"version\": 1, \"status\": 0}",
        "{\"version\": \"1\", \"status\": 0, \"measures\": [1]}",
        "{\"version\": \"1\", \"status\": 0, \"warnings\": [1]}"}) {
    try {
      parse_summary(text, "here.json");
      FAIL() << "accepted " << text;
    } catch (const MachineError& error) {
      EXPECT_NE(std::string(error.what()).find("here.json"), std::string::npos) << error.what();
    }
  }
}

TEST(Summary, ReadsOlderOnesWithFewerKeys) {
  const RunSummary s = parse_summary("{\"version\": \"0\", \"status\": 0}", "x");
  EXPECT_EQ(s.threads, 1);
  EXPECT_TRUE(s.measures.empty());
}

TEST(Summary, GoesThroughAFolder) {
  const auto folder = std::filesystem::path(test::own_file("summary_folder"));
  create_folder(folder);
  write_summary(folder, example());
  EXPECT_EQ(read_summary(folder).steps, example().steps);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(read_summary(folder), MachineError);
}

}  // namespace
}  // namespace brunt
