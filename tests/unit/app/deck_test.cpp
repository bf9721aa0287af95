// load_deck: values in SI, messages with places, overrides, library, and the echo that reads back.
#include "app/deck/deck.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/support/source_path.hpp"

namespace brunt {
namespace {

const std::string kTaylor = R"yaml(title: Taylor bar at $speed
geometry: 3d
parameters: {speed: 190 m/s, size: 0.4 mm}
time: {end: 80 us}
materials:
  copper: {library: copper-ofhc, strength: {johnson-cook: {C: 0}}}
bodies:
  bar:
    method: fe
    material: copper
    shape: {cylinder: {radius: 3.81 mm, length: 25.4 mm, base: [0, 0, 0], axis: z}}
    size: $size
    velocity: [0, 0, -$speed]
    spin: {axis: [0, 3, 4], rate: 3000 rpm}
    element: {hourglass: {viscous: 0.1}}
  cloud:
    method: sph
    material: copper
    shape:
      box: {min: [0, 0, 30 mm], max: [1 mm, 1 mm, 31 mm]}
      rotate: {axis: x, angle: 30 deg}
      translate: [1 mm, 0, 0]
    size: = $size/2
    kernel: wendland-c2
  anvil:
    rigid: true
    shape: {plane: {origin: [0, 0, 0], normal: z, extent: 40 mm}}
    motion: {velocity: [0, 0, 1 mm/s]}
contact:
  default: {stiffness: 0.4}
  pairs: {foot: {between: [bar, anvil], damping: 0.3}}
boundaries:
  - {body: bar, where: {side: max-z}, fix: [y, x, x]}
  - body: bar
    where: {plane: {axis: z, at: 0}}
    velocity: [free, 0, "= -$speed*exp(-t)"]
    force: [0, {table: [[0 s, 0], [1 ms, 3 kN]], over: time}, 2 N]
    to: 5 us
measures:
  length: {extent: {body: bar, axis: z}, reference: 17.3 mm}
  hot: {max: {body: bar, field: temperature}, reference: 400 degC}
  ratio: {expression: "= $length / $length"}
stop: {
at_rest : {
body: bar, below: 1 m/s, for: 5 us
}
}
output: {every: 2 us, fields: [stress, velocity]}
)yaml";

std::string problems_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    load_deck_text(text, "deck", overrides);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "";
}

void expect_problem(const std::string& problems, const std::string& line) {
  EXPECT_NE(("\n" + problems).find("\n" + line), std::string::npos)
      << "wanted: " << line << "\ngot:\n"
      << problems;
}

TEST(Deck, HoldsValuesInSi) {
  const LoadedDeck loaded = load_deck_text(kTaylor, "deck");
  const Deck& deck = loaded.deck;
  EXPECT_EQ(deck.title, "Taylor bar at 190 m/s");
  EXPECT_EQ(deck.time.end, 80e-6);
  const auto& copper = deck.materials[0].value;
  EXPECT_EQ(copper.density, 8960);
  EXPECT_EQ(std::get<JohnsonCook>(copper.strength).A, 90e6);
  EXPECT_EQ(std::get<JohnsonCook>(copper.strength).C, 0);
  EXPECT_EQ(std::get<MieGruneisen>(copper.eos).c0, 3940);
  // K = E/(3(1 - 2 nu)), G = E/(2(1 + nu)) of 124 GPa and 0.34.
  EXPECT_DOUBLE_EQ(copper.bulk_modulus(), 124e9 / 0.96);
  EXPECT_DOUBLE_EQ(copper.shear_modulus(), 124e9 / 2.68);
  const auto& bar = deck.bodies[0].value;
  EXPECT_EQ(std::get<Cylinder>(bar.shape.kind).radius, 3.81e-3);
  EXPECT_EQ(bar.size, (std::vector<Real>{0.4e-3, 0.4e-3, 0.4e-3}));
  EXPECT_EQ(bar.velocity, (std::vector<Real>{0, 0, -190}));
  EXPECT_EQ(bar.spin->axis, (std::vector<Real>{0, 0.6, 0.8}));
  EXPECT_DOUBLE_EQ(bar.spin->rate, 100 * kPi);
  EXPECT_EQ(std::get<ViscousHourglass>(bar.element.hourglass).coefficient, 0.1);
  const auto& cloud = deck.bodies[1].value;
  EXPECT_DOUBLE_EQ(cloud.shape.rotate->angle, kPi / 6);
  EXPECT_EQ(cloud.sph.kernel, KernelKind::wendland_c2);
  EXPECT_DOUBLE_EQ(cloud.size->front(), 0.2e-3);
  EXPECT_EQ(deck.measures[1].value.reference, 673.15);
}

TEST(Deck, PairsInheritFromDefault) {
  const Deck deck = load_deck_text(kTaylor, "deck").deck;
  const PairOptions& foot = deck.contact.pairs[0].value.options;
  EXPECT_EQ(foot.stiffness, 0.4);
  EXPECT_EQ(foot.damping, 0.3);
  EXPECT_EQ(deck.contact.fallback.damping, PairOptions{}.damping);
}

// Friction is a number, a table or a law: what a pair gives takes the place of the default's.
TEST(Deck, FrictionIsANumberATableOrALaw) {
  const std::string law = "contact.default.friction={static: 0.3, kinetic: 0.2, decay: 2 s/m}";
  const auto foot = [&](const std::string& set) {
    const LoadedDeck loaded = load_deck_text(kTaylor, "deck", {law, set});
    EXPECT_EQ(load_deck_text(loaded.resolved, "resolved").resolved, loaded.resolved);
    return loaded.deck.contact.pairs[0].value.options;
  };
  const PairOptions inherited = foot("heat=off");
  EXPECT_EQ(inherited.coulomb.coefficient({}), 0.3);
  EXPECT_DOUBLE_EQ(inherited.coulomb.coefficient({.speed = 0.5}), 0.2 + 0.1 * std::exp(-1));
  const PairOptions number = foot("contact.pairs.foot.friction=0.5");
  EXPECT_FALSE(number.coulomb.decaying);
  EXPECT_EQ(number.coulomb.coefficient({.speed = 3}), 0.5);
  const PairOptions table =
      foot("contact.pairs.foot.friction={table: [[0, 0.4], [1 MPa, 0.2]], over: pressure}");
  EXPECT_FALSE(table.coulomb.decaying);
  EXPECT_DOUBLE_EQ(table.coulomb.coefficient({.pressure = 0.5e6, .speed = 3}), 0.3);
  const PairOptions own = foot("contact.pairs.foot.friction={static: 0.1, kinetic: 0.1, decay: 0}");
  EXPECT_EQ(own.coulomb.coefficient({.speed = 3}), 0.1);
  const PairOptions hot = foot(
      "contact.pairs.foot.friction={table: [[0 degC, 0.4], [100 degC, 0.2]], over: temperature}");
  EXPECT_DOUBLE_EQ(hot.coulomb.coefficient({.temperature = 273.15 + 50}), 0.3);
  const PairOptions expression =
      foot("contact.pairs.foot.friction='= 0.1 + T/1000 + yield/1e9 + p/1e6 + v'");
  EXPECT_TRUE(expression.needs_material());
  EXPECT_DOUBLE_EQ(expression.coulomb.coefficient(
                       {.temperature = 300, .flow_stress = 1e8, .pressure = 2e6, .speed = 0.5}),
                   0.1 + 0.3 + 0.1 + 2 + 0.5);
  EXPECT_FALSE(foot("contact.pairs.foot.friction='= 0.1 + v'").needs_material());
  EXPECT_TRUE(foot("contact.pairs.foot.shear_limit=true").needs_material());
}

TEST(Deck, WrongFrictionIsToldAtItsPlace) {
  const auto wrong = [](const std::string& friction, const std::string& message) {
    expect_problem(problems_of(kTaylor, {"contact.default.friction=" + friction}),
                   "--set #1: contact.default.friction" + message);
  };
  wrong("{static: 0.3, kinetic: 0.2}", ".decay: is missing");
  wrong("{static: 0.3, kinetik: 0.2, decay: 1 s/m}", ": unknown key 'kinetik'; did you mean");
  wrong("{static: 0.3, kinetic: 0.2, decay: 1 m/s}", ".decay: expects");
  wrong("{static: -0.1, kinetic: -0.2, decay: 1 s/m}", ".static: must be at least 0");
  wrong("{static: 0.2, kinetic: 0.3, decay: 1 s/m}", ".kinetic: must not be above static");
  wrong("{static: 0.2, over: pressure}", ": unknown key 'static'");
  wrong("[1, 2]", ": expects");
  wrong("'= 0.1*T + x'", ": '= 0.1*T + x': 'x' is not known in an expression of T, yield, p, v");
  wrong("'= 0.1*(T'", ": '= 0.1*(T': Missing parenthesis");
  wrong("'= -0.1*v'", ": '= -0.1*v': is -0.1 at T = 300 K");
  wrong("'= sqrt(-p)'", ": '= sqrt(-p)': is nan at T = 300 K");
  wrong("'= 0.3*x'", ": cannot depend on t, x, y or z");
  wrong("{table: [[0, 0.3], [1, 0.2]], over: time}",
        ".over: expects one of temperature | slip_speed");
}

TEST(Deck, BoundariesVaryOverTime) {
  const Deck deck = load_deck_text(kTaylor, "deck").deck;
  EXPECT_EQ(deck.boundaries[0].name, "0");
  EXPECT_EQ(deck.boundaries[0].value.of<PrescribedMotion>().fix,
            (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(std::get<deck::WhereSide>(deck.boundaries[0].value.where).side, deck::Side::max_z);
  const auto& second = deck.boundaries[1].value;
  const auto& velocity = *second.of<PrescribedMotion>().velocity;
  EXPECT_FALSE(velocity[0].has_value());
  EXPECT_TRUE(velocity[1]->is_constant());
  EXPECT_DOUBLE_EQ(velocity[2]->evaluate({1, 0, 0, 0}), -190 * std::exp(-1));
  const Varying& force = *(*second.of<AppliedForce>().force)[1];
  EXPECT_EQ(force.at(-1), 0);
  EXPECT_DOUBLE_EQ(force.at(0.5e-3), 1500);  // half of 3 kN at half of 1 ms
  EXPECT_EQ(force.at(1), 3000);
  EXPECT_EQ(second.to, 5e-6);
}

TEST(Deck, EchoReadsBackToTheSame) {
  const LoadedDeck first = load_deck_text(kTaylor, "deck");
  const LoadedDeck second = load_deck_text(first.resolved, "resolved");
  EXPECT_EQ(first.resolved, second.resolved);
  EXPECT_EQ(first.hash, second.hash);
  EXPECT_EQ(second.deck.bodies[0].value.spin->axis, first.deck.bodies[0].value.spin->axis);
  const auto speed = [](const LoadedDeck& loaded) {
    const auto& velocity = *loaded.deck.boundaries[1].value.of<PrescribedMotion>().velocity;
    return velocity[2]->evaluate({0.3, 0, 0, 0});
  };
  EXPECT_EQ(speed(second), speed(first));
  EXPECT_TRUE(second.warnings.empty());
}

TEST(Deck, ShippedDecksLoadAndReadBack) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(test::source_path("decks"))) {
    if (entry.path().extension() != ".yaml") continue;
    const LoadedDeck deck = load_deck(entry.path().string());
    EXPECT_EQ(load_deck_text(deck.resolved, "resolved").resolved, deck.resolved) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 3);
}

TEST(Deck, TheLibraryMakesMaterials) {
  const std::string head = "time: {end: 1 s}\nmaterials:\n";
  const std::string tail =
      "bodies:\n  b: {material: m, size: 1 mm, shape: {sphere: {radius: 5 mm}}}\n";
  for (const char* name : {"al-6082-t6", "al-6061-t6", "al-2024-t351", "copper-ofhc", "armco-iron",
                           "steel-4340", "steel-42crmo4", "steel-1045", "ti6al4v", "tungsten-alloy",
                           "tungsten-carbide", "steel", "brick", "rubber", "rubber-gray"}) {
    EXPECT_EQ(problems_of(head + "  m: {library: " + name + "}\n" + tail), "") << name;
  }
  const LoadedDeck brick = load_deck_text(head + "  m: {library: brick}\n" + tail, "deck");
  ASSERT_EQ(brick.warnings.size(), 1u);
  EXPECT_NE(brick.warnings[0].message.find("low confidence"), std::string::npos);
}

TEST(Deck, OverridesAreCheckedAndPlaced) {
  EXPECT_EQ(load_deck_text(kTaylor, "deck", {"bodies.bar.velocity=[0, 0, -200 m/s]"})
                .deck.bodies[0]
                .value.velocity[2],
            -200);
  EXPECT_EQ(
      load_deck_text(kTaylor, "deck", {"parameters.speed=1 km/s"}).deck.bodies[0].value.velocity[2],
      -1000);
  EXPECT_EQ(load_deck_text(kTaylor, "deck", {"bodies.bar.velocity.0=5 m/s"})
                .deck.bodies[0]
                .value.velocity[0],
            5);
  EXPECT_FALSE(load_deck_text(kTaylor, "deck", {"stop=null"}).deck.stop.at_rest);
  EXPECT_EQ(load_deck_text(kTaylor, "deck", {"materials.copper.library=steel-4340"})
                .deck.materials[0]
                .value.density,
            7830);
  EXPECT_EQ(load_deck_text(kTaylor, "deck", {"materials.copper.density=9000"})
                .deck.materials[0]
                .value.density,
            9000);
  expect_problem(problems_of(kTaylor, {"heat=off", "time.safty=1"}),
                 "--set #2: time: unknown key 'safty'; did you mean 'safety'?");
}

TEST(Deck, HashIsThatOfTheResolvedDeck) {
  const std::string hash = load_deck_text(kTaylor, "deck").hash;
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(load_deck_text(kTaylor + "# a comment\n", "deck").hash, hash);
  EXPECT_NE(load_deck_text(kTaylor, "deck", {"time.end=81 us"}).hash, hash);
}

TEST(Deck, SynonymsOfWords) {
  for (const char* word : {"heat=off", "heat=false"}) {
    EXPECT_EQ(load_deck_text(kTaylor, "deck", {word}).deck.heat, deck::Heat::off);
  }
}

TEST(Deck, MeasuresKnowParameters) {
  // `length` is a measure of the deck, which counts before the parameter.
  const auto loaded = load_deck_text(
      kTaylor, "deck",
      {"parameters.length=7 m", "measures.twice={expression: \"= $size + 2 * $length / $speed\"}"});
  const auto& measure = loaded.deck.measures.back();
  EXPECT_EQ(std::get<deck::ExpressionMeasure>(measure.value.kind).formula,
            "= (4e-04) + 2 * $length / (190)");
}

TEST(Deck, ChecksAcrossTheDeck) {
  const std::string problems = problems_of(
      kTaylor, {"bodies.bar.material=coper", "contact.pairs.again={between: [anvil, bar]}",
                "measures.length.extent.body=baar", "measures.wrong={expression: \"= $nothing\"}",
                "measures.late={extent: {body: bar, axis: x}, at: 1 s}"});
  expect_problem(problems,
                 "--set #1: bodies.bar.material: there is no material 'coper'; did you "
                 "mean 'copper'?");
  expect_problem(problems, "--set #2: contact.pairs.again.between: another pair names the same");
  expect_problem(problems, "--set #3: measures.length.extent.body: there is no body 'baar'");
  expect_problem(problems, "--set #4: measures.wrong.expression: there is no measure 'nothing'");
  expect_problem(problems, "--set #5: measures.late.at: is after time.end");
}

TEST(Deck, MessagesAsTheDesignHasThem) {
  const std::string problems = problems_of(
      "time: {end: 1 s}\nmaterials:\n  al:\n    density: 2700 kg\n    elastic: {E: 70 GPa, nu: "
      "0.3}\n"
      "    thermal: {cp: 900, taylor_quiney: 0.9}\nbodies:\n  b:\n    material: al\n    size: 1\n"
      "    shape: {sphere: {radius: 1 mm}}\n    velocity: [1, 2, 3 mm/s]\n    spin: {rate: 3 Hz, "
      "axis: z}\n");
  expect_problem(problems,
                 "deck:4:14: materials.al.density: expects a density (kg/m^3), got "
                 "'2700 kg'");
  expect_problem(problems,
                 "deck:6:24: materials.al.thermal: unknown key 'taylor_quiney'; did you "
                 "mean 'taylor_quinney'?");
  expect_problem(problems, "deck:12:19: bodies.b.velocity: '2' has no unit and '3 mm/s' has one");
  expect_problem(problems,
                 "deck:13:18: bodies.b.spin.rate: expects a rate of spin (rad/s), got "
                 "'3 Hz'");
}

TEST(Deck, ImplausibleValuesAreWarnings) {
  const LoadedDeck loaded = load_deck_text(kTaylor, "deck", {"bodies.bar.size=0.4"});
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_EQ(loaded.warnings[0].path, "bodies.bar.size");
}

// 0 s/m is 0 in any unit: friction that does not decay, and nothing that was mistyped.
TEST(Deck, ZeroIsNoImplausibleValue) {
  const LoadedDeck loaded = load_deck_text(
      kTaylor, "deck", {"contact.default.friction={static: 0.3, kinetic: 0.2, decay: 0 s/m}"});
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST(Deck, TwoDimensionsHaveTwoComponents) {
  const std::string deck =
      "geometry: plane-strain\ntime: {end: 1 ms}\n"
      "materials: {m: {density: 1000, elastic: {K: 1 GPa, G: 0.5 GPa}}}\n"
      "bodies:\n  b:\n    material: m\n    cells: [4, 4]\n    shape: {box: {min: [0, 0], max: [1, "
      "1]}}\n    velocity: [1, 2]\ngravity: [0, -9.81]\ndepth: 10 mm\n";
  EXPECT_EQ(problems_of(deck), "");
  EXPECT_EQ(load_deck_text(deck, "deck").deck.depth, 0.01);
  expect_problem(problems_of(deck, {"gravity=[0, 0, 1]"}),
                 "--set #1: gravity: expects a list of 2 components");
  expect_problem(problems_of(kTaylor, {"depth=1"}), "--set #1: depth: this key is only for");
}

TEST(Deck, TablesFromFiles) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("brunt_deck_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "curve.csv") << "time,force\n0, 0\n2,5\n";
  std::ofstream(folder / "bad.csv") << "0,0\n0,5\n";
  std::ofstream(folder / "deck.yaml") << kTaylor;
  const std::string path = (folder / "deck.yaml").string();
  const auto loaded =
      load_deck(path, {"boundaries.1.force.2={file: " + (folder / "curve.csv").string() +
                       ", over: time, unit: [ms, kN]}"});
  EXPECT_DOUBLE_EQ((*loaded.deck.boundaries[1].value.of<AppliedForce>().force)[2]->at(1e-3), 2500);
  EXPECT_THROW(load_deck(path, {"boundaries.1.force.2={file: " + (folder / "bad.csv").string() +
                                ", over: time}"}),
               DeckError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace brunt
