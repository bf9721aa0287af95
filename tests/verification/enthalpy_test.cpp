// Heat where cp varies with temperature: h(T) = int cp dT.
//   Two insulated bodies in contact end where  m1 (h1(T) - h1(T1)) + m2 (h2(T) - h2(T2)) = 0.
//   Plastic work heats a body that does not conduct to  rho (h(T) - h(T0)) = plastic heat/volume.
//   A melt at Ti freezes on a mould at T0, half-spaces in perfect contact (Schwarz 1931; Carslaw &
//   Jaeger 1959, 11.2), e = sqrt(k rho cp), one alpha for solid and melt. The front is at x = 2 l
//   sqrt(alpha t), the contact at Ts:
//     e_mould (Ts - T0) = e (Tm - Ts)/erf l
//     cp exp(-l^2)/sqrt(pi) ((Tm - Ts)/erf l - (Ti - Tm)/erfc l) = L l
//   of decks/freezing-slab: l = 0.26698, Ts = 839.11 K.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const Field& temperatures(const BodyView& view) {
  return *std::find_if(view.point_fields.begin(), view.point_fields.end(),
                       [](const Field& field) { return field.name == "temperature"; });
}

void expect_balance(const Simulation& run, Real tolerance = 1e-12) {
  ASSERT_EQ(run.failure, "");
  for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), tolerance);
}

/// Place [m] where the temperature passes T along x, linear between points.
Real front(const BodyView& view, Real T) {
  const auto& field = temperatures(view);
  std::vector<std::pair<Real, Real>> line;
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    if (view.position[3 * i + 1] == 0) line.emplace_back(view.position[3 * i], field.values[i]);
  }
  std::sort(line.begin(), line.end());
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto& [x0, T0] = line[i - 1];
    const auto& [x1, T1] = line[i];
    if (T0 < T && T1 >= T) return x0 + (T - T0) / (T1 - T0) * (x1 - x0);
  }
  return -1;
}

constexpr Real kFront = 0.26698, kDiffusivity = 200.0 / (2700 * 900);

// The closed form freezes at 933 K, the deck over 10 K about it, in elements of 0.2 mm that freeze
// one after another: the front may be off by a tenth of an element or so, and temperatures by the
// part of the 10 K that an element more or less makes. Measured: fronts 0.7 and 0.1 %, 0.6 K.
TEST(Enthalpy, AMeltFreezesAsDeepAsNeumannSays) {
  for (const auto* end : {"0.2 s", "0.5 s"}) {
    const auto run = simulate_shipped("freezing-slab", {std::string("time.end=") + end});
    expect_balance(run);
    const Real t = std::stod(end);
    const Real exact = 2 * kFront * std::sqrt(kDiffusivity * t);
    const Real found = front(run.bodies.at("melt"), 933);
    std::printf("front after %s: %.4f mm, Neumann %.4f mm\n", end, 1e3 * found, 1e3 * exact);
    EXPECT_NEAR(found, exact, 0.01 * exact);
    EXPECT_NEAR(run.measures.at("contact"), 839.11, 1);
    if (t < 0.5) continue;
    EXPECT_NEAR(run.measures.at("in_mould"), 600.26, 1);
    EXPECT_NEAR(run.measures.at("in_solid"), 894.78, 1);
    EXPECT_NEAR(run.measures.at("in_melt"), 974.34, 1);
  }
}

// The same bits whatever does not change the deck, with a table on both sides of the contact.
TEST(Enthalpy, BitsOfAFreezingMelt) {
  const std::vector<std::string> deck{
      "time.end=20 ms",
      "materials.steel.thermal.cp={table: [[300 K, 475], [800 K, 640]], over: "
      "temperature}"};
  const auto once = simulate_shipped("freezing-slab", deck);
  expect_balance(once);
  for (const RunVariation& variation :
       {RunVariation{2, false, 0}, RunVariation{0, true, 0}, RunVariation{0, false, 40}}) {
    const auto again = simulate_shipped("freezing-slab", deck, variation);
    EXPECT_EQ(again.hashes, once.hashes);
  }
}

// cp of the hot body: 900 J/kg/K, and 10 kJ/kg more between 400 and 420 K; of the cold one 300 to
// 600 J/kg/K from 300 to 500 K. m1 = 2700 V, m2 = 7850 V. From 450 K and 300 K:
//   2700 (h1(T) - h1(450)) + 7850 (300 (T - 300) + 0.75 (T - 300)^2) = 0, below 400 K
//   h1(T) - h1(450) = 900 (T - 450) - 10 000
Real equilibrium() {
  Real low = 300, high = 400;
  for (int i = 0; i < 200; ++i) {
    const Real T = 0.5 * (low + high);
    const Real cold = 7850 * (300 * (T - 300) + 0.75 * (T - 300) * (T - 300));
    (2700 * (900 * (T - 450) - 10000) + cold > 0 ? high : low) = T;
  }
  return low;
}

class Insulated : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Insulated, EndsWhereTheEnthalpiesBalance) {
  const auto [hot, cold] = GetParam();
  const auto run = simulate_text(
      std::string("geometry: plane-strain\ntime: {end: 20 s}\nheat: conduct\n"
                  "materials:\n"
                  "  hot: {density: 2700, elastic: {E: 70 GPa, nu: 0.3}, thermal: {k: 237 W/m/K, "
                  "cp: {table: [[400 K, 900], [410 K, 1900], [420 K, 900]], over: temperature}}}\n"
                  "  cold: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}, thermal: {k: 44.5, "
                  "cp: {table: [[300 K, 300], [500 K, 600]], over: temperature}}}\n"
                  "bodies:\n  a: {material: hot, temperature: 450 K, size: 0.5 mm, shape: {box: "
                  "{min: [0, 0], max: [3 mm, 3 mm]}}, method: ") +
      hot +
      "}\n  b: {material: cold, temperature: 300 K, size: 0.5 mm, shape: {box: {min: [3 mm, 0], "
      "max: [6 mm, 3 mm]}}, method: " +
      cold +
      "}\nboundaries:\n  a: {body: a, where: all, fix: [x, y]}\n"
      "  b: {body: b, where: all, fix: [x, y]}\n"
      "contact: {default: {heat: {conductance: 1e5 W/m^2/K}}}\noutput: {history: 1 s}\n");
  expect_balance(run);
  // L^2/alpha = 36e-6/12e-6 = 3 s: after 20 s all is even to exp(-20 pi^2/3).
  for (const auto* body : {"a", "b"}) {
    for (const Real T : temperatures(run.bodies.at(body)).values) {
      EXPECT_NEAR(T, equilibrium(), 1e-6) << body;
    }
  }
  EXPECT_NEAR(run.last("body.a.heat") + run.last("body.b.heat"), 0,
              1e-12 * run.last("body.b.heat"));
}

INSTANTIATE_TEST_SUITE_P(Enthalpy, Insulated,
                         testing::Values(std::pair("fe", "fe"), std::pair("fe", "sph"),
                                         std::pair("sph", "fe"), std::pair("sph", "sph")),
                         [](const auto& info) {
                           return std::string(info.param.first) + "_" + info.param.second;
                         });

// What is brought to another temperature as a whole takes m1 (h1(T) - h1(T0)) + m2 (h2(T) - h2(T0))
// through its boundary, whatever the way there; per metre of depth and for 3 x 3 mm each from 300
// to 450 K
//   2700 9e-6 (900 150 + 10 000) + 7850 9e-6 (300 150 + 0.75 150^2)
TEST(Enthalpy, HeldBodiesTakeWhatTheirTablesSay) {
  const auto run = simulate_text(
      "geometry: plane-strain\ntime: {end: 2 s}\n"
      "materials:\n"
      "  hot: {density: 2700, elastic: {E: 70 GPa, nu: 0.3}, thermal: {k: 237 W/m/K, "
      "cp: {table: [[400 K, 900], [410 K, 1900], [420 K, 900]], over: temperature}}}\n"
      "  cold: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}, thermal: {k: 44.5, "
      "cp: {table: [[300 K, 300], [500 K, 600]], over: temperature}}}\n"
      "bodies:\n"
      "  a: {material: hot, temperature: 300 K, size: 0.5 mm, shape: {box: {min: [0, 0], max: [3 "
      "mm, 3 mm]}}}\n"
      "  b: {material: cold, temperature: 300 K, size: 0.5 mm, shape: {box: {min: [3 mm, 0], max: "
      "[6 mm, 3 mm]}}}\n"
      "boundaries:\n  a: {body: a, where: all, fix: [x, y], temperature: \"= 300 + 75*t\"}\n"
      "  b: {body: b, where: all, fix: [x, y], temperature: \"= 300 + 75*t\"}\n"
      "contact: {default: {ignore: true}}\noutput: {history: 0.1 s}\n");
  expect_balance(run);
  for (const auto* body : {"a", "b"}) {
    for (const Real T : temperatures(run.bodies.at(body)).values) EXPECT_NEAR(T, 450, 1e-10);
  }
  const Real heat = 9e-6 * (2700 * (900 * 150 + 10000.0) + 7850 * (300 * 150 + 0.75 * 150 * 150.0));
  EXPECT_NEAR(run.last("heat.boundary"), heat, 1e-10 * heat);
}

}  // namespace
}  // namespace brunt::test
