// Fluids without strength.
// Sod's tube (J. Comput. Phys. 27, 1978): gas of gamma = 1.4, on the left rho = 1, p = 1, on the
// right 0.125 and 0.1, in units of 1 kg/m^3, 1e5 Pa, 1 m. With the exact solution of the Riemann
// problem (Toro, Riemann Solvers, 3rd ed. 2009, ch. 4): p* = 0.30313, u* = 0.92745, rho* = 0.42632
// to the left of the contact and 0.26557 to its right, the shock at 1.75216. The gases are two
// bodies that press each other.
// A column of water that is stopped (Joukowsky 1898): p = rho c u where u is far below c. Tait's
// water at 10 m/s: the jump conditions p = rho0 U u, V/V0 = 1 - u/U with p(V) solved here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

struct GasState {
  Real rho, u, p;
};
constexpr Real kGamma = 1.4;

/// Sod's problem at x/t = s.
GasState sod(Real s) {
  const GasState left{1, 0, 1}, right{0.125, 0, 0.1};
  const Real cl = std::sqrt(kGamma * left.p / left.rho);
  const auto expanded = [&](Real p) {
    return 2 * cl / (kGamma - 1) * (1 - std::pow(p / left.p, (kGamma - 1) / (2 * kGamma)));
  };
  const auto shocked = [&](Real p) {
    const Real a = 2 / ((kGamma + 1) * right.rho), b = (kGamma - 1) / (kGamma + 1) * right.p;
    return (p - right.p) * std::sqrt(a / (p + b));
  };
  Real low = right.p, high = left.p;
  for (int i = 0; i < 100; ++i) {
    const Real middle = 0.5 * (low + high);
    (expanded(middle) > shocked(middle) ? low : high) = middle;
  }
  const Real p = low, u = shocked(p);
  const Real rho_left = left.rho * std::pow(p / left.p, 1 / kGamma);
  const Real q = (kGamma - 1) / (kGamma + 1), times = p / right.p;
  const Real rho_right = right.rho * (times + q) / (q * times + 1);
  const Real shock = u / (1 - right.rho / rho_right);
  const Real tail = u - std::sqrt(kGamma * p / rho_left);
  if (s < -cl) return left;
  if (s < tail) {
    const Real c = 2 / (kGamma + 1) * (cl - 0.5 * (kGamma - 1) * s);
    const Real density = left.rho * std::pow(c / cl, 2 / (kGamma - 1));
    return {density, 2 / (kGamma + 1) * (cl + s), std::pow(density, kGamma)};
  }
  if (s < u) return {rho_left, u, p};
  if (s < shock) return {rho_right, u, p};
  return right;
}

std::string tube(int cells) {
  const std::string n = std::to_string(cells);
  return R"(
title: Sod's tube
geometry: plane-strain
time: {end: 0.63245553 ms, max_drift: 5 %}
materials:
  dense: {density: 1 kg/m^3, eos: {ideal-gas: {gamma: 1.4, pressure: 100 kPa}}}
  thin: {density: 0.125 kg/m^3, eos: {ideal-gas: {gamma: 1.4, pressure: 10 kPa}}}
bodies:
  left: {material: dense, shape: {box: {min: [-0.5, 0], max: [0, 10 mm]}}, cells: [)" +
         n + R"(, 1]}
  right: {material: thin, shape: {box: {min: [0, 0], max: [0.5, 10 mm]}}, cells: [)" +
         n + R"(, 1]}
boundaries:
  left: {body: left, where: all, fix: [y]}
  right: {body: right, where: all, fix: [y]}
  left_end: {body: left, where: {side: min-x}, fix: [x]}
  right_end: {body: right, where: {side: max-x}, fix: [x]}
output: {history: 0.1 ms}
)";
}

/// A cell of a strip of quadrilaterals: where it is, and values of a field.
struct StripCell {
  Real x, width, density, pressure;
};

std::vector<StripCell> strip(const BodyView& view) {
  const auto& density = field_named(view.cell_fields, "density")->values;
  const auto& pressure = field_named(view.cell_fields, "pressure")->values;
  std::vector<StripCell> cells;
  for (std::size_t e = 0; e < density.size(); ++e) {
    Real low = kInfinity, high = -kInfinity;
    for (std::size_t c = 0; c < 4; ++c) {
      const Real x = view.position[3 * static_cast<std::size_t>(view.connectivity[4 * e + c])];
      low = std::min(low, x), high = std::max(high, x);
    }
    cells.push_back({0.5 * (low + high), high - low, density[e], pressure[e]});
  }
  return cells;
}

struct TubeErrors {
  Real density = 0, pressure = 0;  ///< int |computed - exact| dx over that of the exact
};

TubeErrors errors_of(const Simulation& run) {
  constexpr Real t = 0.2;  // in units of sqrt(1e-5) s
  Real density = 0, pressure = 0;
  TubeErrors errors;
  for (const char* body : {"left", "right"}) {
    for (const StripCell& cell : strip(run.bodies.at(body))) {
      const GasState exact = sod(cell.x / t);
      errors.density += cell.width * std::fabs(cell.density - exact.rho);
      errors.pressure += cell.width * std::fabs(cell.pressure / 1e5 - exact.p);
      density += cell.width * exact.rho, pressure += cell.width * exact.p;
    }
  }
  errors.density /= density, errors.pressure /= pressure;
  return errors;
}

TEST(Fluid, SodsTubeConvergesToTheExactSolution) {
  EXPECT_NEAR(sod(0.9).p, 0.30313, 1e-5);
  EXPECT_NEAR(sod(0.9).u, 0.92745, 1e-5);
  EXPECT_NEAR(sod(0.9).rho, 0.42632, 1e-5);
  EXPECT_NEAR(sod(1.0).rho, 0.26557, 1e-5);
  const auto coarse = simulate_text(tube(100)), fine = simulate_text(tube(200));
  ASSERT_EQ(coarse.failure + fine.failure, "");
  const TubeErrors wide = errors_of(coarse), narrow = errors_of(fine);
  RecordProperty("density_100", std::to_string(wide.density));
  RecordProperty("density_200", std::to_string(narrow.density));
  // Shocks are smeared over cells: the first order of h.
  EXPECT_LT(narrow.density, 0.01);
  EXPECT_LT(narrow.pressure, 0.01);
  EXPECT_LT(narrow.density, 0.65 * wide.density);
  EXPECT_LT(narrow.pressure, 0.65 * wide.pressure);
}

constexpr Real kSpeed = 10, kWater = 1000, kSound = 1480, kExponent = 7.15;

/// The shock into water that moves at kSpeed and is stopped: U [m/s] against the water, and p [Pa].
std::pair<Real, Real> stopped_water() {
  const Real B = kWater * kSound * kSound / kExponent;
  Real low = kSound, high = 2 * kSound;
  for (int i = 0; i < 100; ++i) {
    const Real U = 0.5 * (low + high);
    const Real p = B * (std::pow(1 - kSpeed / U, -kExponent) - 1);
    (p > kWater * U * kSpeed ? low : high) = U;
  }
  return {low, kWater * low * kSpeed};
}

std::string column(const std::string& method) {
  return R"(
title: a column of water is stopped
geometry: plane-strain
time: {end: 0.4 ms}
materials:
  water: {density: 1000 kg/m^3, eos: {tait: {c0: 1480 m/s, gamma: 7.15}}}
bodies:
  column:
    method: )" +
         method + R"(
    material: water
    shape: {box: {min: [0, 0], max: [1 m, 20 mm]}}
    size: 5 mm
    velocity: [-10 m/s, 0]
boundaries:
  across: {body: column, where: all, fix: [y]}
  wall: {body: column, where: {side: min-x}, fix: [x]}
output: {history: 0.1 ms}
)";
}

TEST(Fluid, StoppedWaterHasThePressureOfTheWaterHammer) {
  const auto [speed, pressure] = stopped_water();
  EXPECT_NEAR(pressure / (kWater * kSound * kSpeed), 1, 0.03);  // Joukowsky
  const auto run = simulate_text(column("fe"));
  ASSERT_EQ(run.failure, "");
  // The front has gone (U - u) t from the wall; the plateau is what it has left well behind.
  const Real front = (speed - kSpeed) * 0.4e-3;
  Real mean = 0, crossed = 0;
  int count = 0;
  for (const StripCell& cell : strip(run.bodies.at("column"))) {
    if (cell.x > 0.2 * front && cell.x < 0.8 * front) mean += cell.pressure, ++count;
    if (cell.pressure > 0.5 * pressure) crossed = std::max(crossed, cell.x);
  }
  EXPECT_NEAR(mean / count / pressure, 1, 0.002);
  EXPECT_NEAR(crossed / front, 1, 0.01);
}

TEST(Fluid, ParticlesOfWaterStopLikeElements) {
  const auto [speed, pressure] = stopped_water();
  const auto run = simulate_text(column("sph"));
  ASSERT_EQ(run.failure, "");
  const BodyView& view = run.bodies.at("column");
  const auto& found = field_named(view.point_fields, "pressure")->values;
  const Real front = (speed - kSpeed) * 0.4e-3;
  Real mean = 0;
  int count = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Real x = view.position[3 * i], y = view.position[3 * i + 1];
    if (x < 0.2 * front || x > 0.8 * front || y < 7e-3 || y > 13e-3) continue;
    mean += found[i], ++count;
  }
  ASSERT_GT(count, 100);
  EXPECT_NEAR(mean / count / pressure, 1, 0.01);
}

}  // namespace
}  // namespace brunt::test
