// What a pair says of heat: conductance by pressure, gaps, and where the heat of friction goes.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kMaterials = R"yaml(
materials:
  aluminium:
    density: 2700 kg/m^3
    elastic: {E: 70 GPa, nu: 0.33}
    thermal: {cp: 900 J/kg/K, k: 237 W/m/K}
  steel:
    density: 7850 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    thermal: {cp: 475 J/kg/K, k: 44.5 W/m/K}
)yaml";

// A hot plate is pressed 1 um into a cold one and held there. By Ohm's law of heat Q = h(p) A dT,
// h = 1000 + p/1 MPa * 100 W/m^2/K, p the force over the area that the same row tells. In 50 us the
// plates of rho cp h/2 > 1200 J/m^2/K lose less than 1e-4 of their 100 K; 1e-3 is that tenfold.
TEST(ContactHeat, ConductanceFollowsThePressure) {
  const auto run = simulate_text(std::string(R"yaml(
geometry: plane-strain
time: {end: 50 us}
heat: conduct
ambient: 300 K
bodies:
  cold: {material: steel, shape: {box: {min: [0, 0], max: [3 mm, 1 mm]}}, cells: [3, 1]}
  hot:
    material: aluminium
    shape: {box: {min: [0.5 mm, 1 mm], max: [2.5 mm, 2 mm]}}
    cells: [3, 1]
    temperature: 400 K
boundaries:
  still: {body: cold, where: all, fix: [x, y]}
  press:
    body: hot
    where: all
    velocity: [0, {table: [[0, -0.1 m/s], [10 us, -0.1 m/s], [10.001 us, 0]], over: time}]
contact:
  default:
    heat: {conductance: {table: [[0, 1000 W/m^2/K], [1 GPa, 101000 W/m^2/K]], over: pressure}}
output: {history: 1 us}
)yaml") + kMaterials);
  ASSERT_EQ(run.failure, "");
  const Real area = run.last("contact.cold-hot.area");
  const Real pressure = -run.last("contact.cold-hot.force.y") / area;
  EXPECT_NEAR(area, 2e-3, 1e-9);
  EXPECT_GT(pressure, 10e6);
  const Real expected = (1000 + pressure / 1e9 * 100000) * area * 100;
  EXPECT_NEAR(run.last("contact.cold-hot.heat_rate"), expected, 1e-3 * expected);
  EXPECT_NEAR(run.last("body.cold.heat"), -run.last("body.hot.heat"),
              1e-12 * run.last("body.cold.heat"));
  EXPECT_NEAR(run.last("contact.cold-hot.temperature.max"), 400, 0.1);
  EXPECT_NEAR(run.last("contact.cold-hot.temperature.mean"), 350, 0.1);
}

// The rod of rigid_heat_test.cpp with its halves 0.1 mm apart: the gap carries what the contact
// would, q = dT/(L/k1 + 1/h + L/k2), where the opening is within it, and nothing where it is not.
TEST(ContactHeat, PassesUpToItsGap) {
  const Real flux = 100 / (0.05 / 237 + 1e-4 + 0.05 / 44.5);
  const auto with = [](const std::string& gap) {
    return simulate_shipped("composite-rod",
                            {"contact.default.heat={conductance: 1e4 W/m^2/K, gap: " + gap + "}",
                             "bodies.steel.shape.translate=[0.1 mm, 0, 0]"});
  };
  const auto near = with("0.2 mm"), far = with("0.05 mm");
  ASSERT_EQ(near.failure, "");
  EXPECT_NEAR(near.last("contact.aluminium-steel.heat_rate"), -flux * 25e-6, 5e-3 * flux * 25e-6);
  EXPECT_EQ(near.last("contact.aluminium-steel.planes"), 0);
  EXPECT_EQ(far.last("contact.aluminium-steel.heat_rate"), 0);
}

// Particles 0.1 mm above hexes of a gap of 0.2 mm: each of the 16 lowest passes dp^2 dT / (1/h +
// (dp/2)/k) at once. Steps of 10 us take 1 % of 1/h more, dt/(rho cp dp) (backward Euler). The
// answer is that of any skin, and beyond the gap nothing passes.
TEST(ContactHeat, ParticlesPassItOverAGapToo) {
  const auto with = [](const std::string& more) {
    return simulate_text(std::string(R"yaml(
time: {end: 50 us, max_step: 10 us}
heat: conduct
ambient: 300 K
bodies:
  hot:
    method: sph
    smoothing: 1.2
    material: aluminium
    temperature: 400 K
    shape: {box: {min: [0, 0, 0.1 mm], max: [4 mm, 4 mm, 4.1 mm]}}
    size: 1 mm
  cold:
    material: steel
    shape: {box: {min: [-1 mm, -1 mm, -3 mm], max: [5 mm, 5 mm, 0]}}
    size: 1.5 mm
boundaries:
  hot_still: {body: hot, where: all, fix: [x, y, z]}
  cold_still: {body: cold, where: all, fix: [x, y, z]}
contact:
  default: {heat: {conductance: 1e4 W/m^2/K, gap: 0.2 mm}}
output: {history: 10 us}
)yaml") + kMaterials,
                         {more});
  };
  const auto run = with("contact.skin=auto");
  ASSERT_EQ(run.failure, "");
  const Real rate = 16e-6 * 100 / (1e-4 + 0.5e-3 / 237);
  EXPECT_NEAR(run.rows[1][run.index("contact.hot-cold.heat_rate")], -rate, 0.02 * rate);
  EXPECT_EQ(run.last("contact.hot-cold.planes"), 0);
  EXPECT_EQ(with("contact.skin=0").hashes, run.hashes);
  EXPECT_EQ(with("contact.skin=2 mm").hashes, run.hashes);
  const auto apart = with("contact.default.heat.gap=0.09 mm");
  EXPECT_EQ(apart.last("contact.hot-cold.heat_rate"), 0);
}

// Elastic particles rub on elastic hexes; no heat passes. Of what friction takes from the motion
// 80 % become heat, and a quarter of that is the first body's, as `between` names them.
TEST(FrictionHeat, GoesWhereThePairSays) {
  const auto run = simulate_shipped(
      "hot-block", {"time.end=30 us", "heat=conduct", "materials.aluminium.strength=null",
                    "contact={pairs: {rub: {between: [plate, block], friction: $mu, friction_heat: "
                    "{fraction: 0.8, split: 0.25}}}}",
                    "measures=null"});
  ASSERT_EQ(run.failure, "");
  const Real heat = run.last("energy.contact.friction");
  EXPECT_GT(heat, 0);
  EXPECT_NEAR(run.last("heat.friction"), 0.8 * heat, 1e-12 * heat);
  EXPECT_NEAR(run.last("body.plate.heat"), 0.2 * heat, 1e-12 * heat);
  EXPECT_NEAR(run.last("body.plate.heat") + run.last("body.block.heat"), 0.8 * heat, 1e-12 * heat);
  for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
  EXPECT_LT(run.worst_drift, 1e-10);
}

// Aluminium rubs on steel; both conduct and no heat passes. Without a `split` the heat of friction
// goes by effusivities, e1/(e1 + e2), e = sqrt(k rho cp): 23,998 and 12,881
// J/m^2/K/s^(1/2), 0.651 to aluminium. The block is pulled by 0.1 mm, pressed all the while or
// thrown so that it bounces off: then every contact ends in a step of its own, whose first half
// still slips. Of some thousand contacts and a hundred steps rounding leaves some 1e-14.
TEST(FrictionHeat, GoesByEffusivityOtherwise) {
  const Real e1 = std::sqrt(237.0 * 2700 * 900), e2 = std::sqrt(44.5 * 7850 * 475);
  const Real of_aluminium = e1 / (e1 + e2);
  EXPECT_NEAR(of_aluminium, 0.651, 5e-4);
  const auto expect_split = [&](const char* block, const char* plate, const char* names,
                                const char* at, bool thrown) {
    const auto run = simulate_text(
        std::string(R"yaml(
geometry: 3d
time: {end: 20 us}
heat: conduct
ambient: 300 K
bodies:
  block:
    material: aluminium
    shape: {box: {min: [0, 0, 0], max: [4 mm, 4 mm, 4 mm]}}
    size: 1 mm
    velocity: [5 m/s, 0, -2 m/s]
  plate:
    material: steel
    shape: {box: {min: [-2 mm, -2 mm, -3 mm], max: [8 mm, 6 mm, 0]}}
    size: 1 mm
boundaries:
  floor: {body: plate, where: {side: min-z}, fix: [x, y, z]}
  press: {body: block, where: {side: max-z}, velocity: [5 m/s, free, -2 m/s]}
contact: {default: {friction: 0.3}, pairs: {rub: {between: )yaml") +
            names + "}}}\n" + kMaterials,
        {std::string("bodies.block.method=") + block, std::string("bodies.plate.method=") + plate,
         std::string("bodies.block.shape.translate=") + at,
         thrown ? "boundaries.press=null" : "title=pressed"});
    SCOPED_TRACE(std::string(block) + " on " + plate + (thrown ? ", thrown" : ", pressed"));
    ASSERT_EQ(run.failure, "");
    EXPECT_EQ(run.last("contact.rub.planes") == 0, thrown);
    const Real heat = run.last("energy.contact.friction");
    EXPECT_GT(heat, thrown ? 1e-4 : 0.01);
    EXPECT_NEAR(run.last("heat.friction"), heat, 1e-12 * heat);
    EXPECT_NEAR(run.last("body.block.heat"), of_aluminium * heat, 1e-12 * heat);
    EXPECT_NEAR(run.last("body.plate.heat"), (1 - of_aluminium) * heat, 1e-12 * heat);
    EXPECT_LT(run.worst_drift, 1e-10);
  };
  const char* aside = "[0.05 mm, 0.3 mm, 0]";
  for (const bool thrown : {false, true}) {
    expect_split("fe", "fe", "[block, plate]", aside, thrown);
    expect_split("fe", "fe", "[plate, block]", aside, thrown);
    expect_split("sph", "fe", "[block, plate]", aside, thrown);
    expect_split("fe", "sph", "[block, plate]", aside, thrown);
    expect_split("sph", "sph", "[block, plate]", "[0.05 mm, 0, 0]", thrown);
  }
}

// A pair's force, torque and heat rate are those of the body that `between` names first: the hot
// block is thrown up and cools, whichever the deck's bodies begin with.
TEST(PairColumns, AreOfTheBodyNamedFirst) {
  const auto run = [](const char* between) {
    return simulate_shipped(
        "hot-block",
        {"time.end=5 us", "measures=null",
         std::string("contact={pairs: {hit: {friction: $mu, heat: perfect, between: ") + between +
             "}}}"});
  };
  const auto block = run("[block, plate]"), plate = run("[plate, block]");
  ASSERT_EQ(block.failure + plate.failure, "");
  EXPECT_GT(block.last("contact.hit.force.z"), 0);
  EXPECT_LT(block.last("contact.hit.force.x"), 0);
  EXPECT_LT(block.last("contact.hit.heat_rate"), 0);
  for (const char* column : {"force.x", "force.z", "torque.x", "torque.y", "heat_rate"}) {
    const std::string name = std::string("contact.hit.") + column;
    EXPECT_NE(block.last(name), 0) << column;
    EXPECT_EQ(plate.last(name), -block.last(name)) << column;
  }
  for (const char* column : {"area", "friction_heat", "temperature.max"}) {
    const std::string name = std::string("contact.hit.") + column;
    EXPECT_EQ(plate.last(name), block.last(name)) << column;
  }
}

// Half-spaces in perfect contact are at (e1 T1 + e2 T2)/(e1 + e2) = 332.34 degC there from the
// second step on, on both sides: 0.5 % of 480 K.
TEST(ContactTemperature, IsThatBetweenHalfSpaces) {
  const auto run = simulate_shipped("half-spaces", {"time.end=2 ms"});
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.last("contact.hot-cold.temperature.mean") - 273.15, 332.34, 2.4);
  EXPECT_NEAR(run.last("contact.hot-cold.temperature.max") - 273.15, 332.34, 2.4);
}

}  // namespace
}  // namespace brunt::test
