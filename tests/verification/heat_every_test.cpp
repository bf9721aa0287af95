// Conduction at every N-th step (`time.heat_every`): rates of heat that stay for a window of Delta
// = N dt are Euler's method with that step. A mode that fades as exp(-lambda t) is multiplied by 1
// - lambda Delta a window, so that it fades as lambda (1 + lambda Delta/2): too fast by the part
// lambda Delta/2. Of a field this is -(Delta t/2) d2T/dt2.
// Copper, h = 10 um: a step of sound is 1.3 ns, one of heat 0.375 h^2/alpha = 0.33 us.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kDiffusivity = 386.0 / (8960 * 383);
constexpr Real kSize = 10e-6, kLength = 20 * kSize;

std::string every(int n) { return "time.heat_every=" + std::to_string(n); }

/// A bar of 20 x WIDTH x WIDTH elements or particles that nothing holds: it steps as sound asks.
std::string bar(const std::string& method, int width) {
  const std::string w = std::to_string(10 * width) + " um";
  return "geometry: 3d\nheat: conduct\ntime: {end: 1 ms, max_step: 1 ns}\nambient: 300 K\n"
         "materials: {copper: {density: 8960, elastic: {E: 124 GPa, nu: 0.34}, "
         "thermal: {cp: 383, k: 386}}}\nbodies: {bar: {method: " +
         method + ", material: copper, size: 10 um, shape: {box: {min: [0, 0, 0], max: [200 um, " +
         w + ", " + w + "]}}}}\n";
}

/// A cosine of 100 K along the bar, and what is left of it after so many steps.
struct Fading {
  Real amplitude = 0;       // [1] of the cosine
  Real time = 0, step = 0;  // [s]
  Real heat_step = 0;       // [s] longest stable one
};

Fading fade(const std::string& text, int heat_every, std::int64_t steps) {
  const auto cosine = [](const Scene<3>& scene, const Points<3>& points, std::size_t i) {
    return std::cos(kPi * (points.x_start[i][0] + scene.origin[0]) / kLength);
  };
  SceneHooks hooks;
  hooks.built = [&](Scene<3>& scene) {
    auto& points = scene.solids[0]->points();
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      points.temperature[i] = points.start_temperature[i] = 300 + 100 * cosine(scene, points, i);
    }
  };
  Fading fading;
  hooks.step_done = [&](Scene<3>& scene, const Clock& clock) {
    if (clock.step() != steps) return;
    const auto& points = scene.solids[0]->points();
    Real sum = 0, weight = 0;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const Real shape = cosine(scene, points, i);
      sum += points.capacity[i] * shape * (points.temperature[i] - 300);
      weight += points.capacity[i] * shape * shape;
    }
    fading = {sum / weight / 100, clock.time(), clock.dt(), heat_every * scene.heat_step().step};
  };
  const auto run = simulate_text(
      text, {every(heat_every), "time.end=" + std::to_string(steps + 2) + " ns"}, {}, hooks);
  EXPECT_EQ(run.failure, "");
  EXPECT_GT(fading.step, 0) << run.steps;
  return fading;
}

// The cosine is a mode of the elements too, lambda = 4 alpha/h^2 sin^2(pi h/(2 L)): what is left is
// known to rounding, 1e-16 of 300 K in each of 6400 steps of 100 K at worst.
TEST(HeatEvery, AModeOfElementsFadesByEulersFactor) {
  constexpr int kSteps = 6400;
  const Real half = std::sin(kPi * kSize / (2 * kLength));
  const Real lambda = 4 * kDiffusivity / (kSize * kSize) * half * half;
  for (const int n : {1, 4, 16, 32, 64}) {
    const Fading left = fade(bar("fe", 1), n, kSteps);
    const Real window = n * left.time / kSteps;
    EXPECT_NEAR(left.amplitude, std::pow(1 - lambda * window, kSteps / n), 1e-11) << n;
    const Real too_fast = -std::log(left.amplitude) / (lambda * left.time) - 1;
    // the next term is (lambda Delta)^2/3
    EXPECT_NEAR(too_fast, lambda * window / 2, lambda * window * lambda * window / 2);
    // No mode is faster than 2/heat_step (Gershgorin): at a tenth of it, all err by less than that.
    EXPECT_LT(too_fast, window / left.heat_step);
    if (n == 32) {  // lambda = pi^2 alpha/(20 h)^2 has errors of 4.6e-4 there
      EXPECT_LT(window, 0.1 * left.heat_step);
      EXPECT_LT(too_fast, 1e-3);
    }
    std::printf("N = %2d: Delta %.3g ns, fades %.4f %% too fast\n", n, 1e9 * window,
                100 * too_fast);
  }
}

// Particles have the same mode but for their ends. What windows change is (N - 1) dt lambda^2 t/2
// of the cosine, to lambda Delta (0.2 %) and to what ends make of it: 1 % of lambda at 20
// particles, twice that of its square.
TEST(HeatEvery, WhatItChangesIsOfFirstOrderWithParticles) {
  constexpr int kSteps = 1280;
  const std::string text = bar("sph", 4);
  const Fading once = fade(text, 1, kSteps);
  const Real lambda = -std::log(once.amplitude) / once.time;
  Real last = 0;
  for (const int n : {16, 32, 64}) {
    const Fading kept = fade(text, n, kSteps);
    const Real change = once.amplitude - kept.amplitude;
    const Real expected = (n - 1) * once.step * lambda * lambda * once.time / 2 * once.amplitude;
    EXPECT_NEAR(change, expected, 0.03 * expected) << n;
    if (last > 0) {
      EXPECT_NEAR(change / last, (n - 1) / (0.5 * n - 1), 0.02) << n;
    }
    last = change;
    std::printf("N = %2d: %.4f K of 100 K, expected %.4f K\n", n, 100 * change, 100 * expected);
  }
}

// Contact brings both surfaces to T_s in the first step, and conduction learns of
// it a window later, T(t - Delta). With eta = x/(2 sqrt(alpha t)), T = T_0 + (T_s - T_0) erfc(eta),
//   dT = -Delta dT/dt - (Delta t/2) d2T/dt2
//      = -(T_s - T_0) Delta/(t sqrt(pi)) (eta/4 + eta^3/2) exp(-eta^2)
// at most 0.280/sqrt(pi) = 0.158 Delta/t of T_s - T_0, at eta = 1.09; N windows against one step
// have (N - 1) dt for Delta. Of the largest error 10 % are left to elements of 0.1 mm: 2 sqrt(alpha
// t) is 1.4 mm in aluminium and 0.49 mm in steel.
TEST(HeatEvery, HalfSpacesErrAsTheClosedFormSays) {
  constexpr Real kTime = 0.005, kStep = 2e-6, kZero = 273.15;
  const auto effusivity = [](Real k, Real rho, Real cp) { return std::sqrt(k * rho * cp); };
  const Real hot = effusivity(237, 2700, 900), cold = effusivity(44.5, 7850, 475);
  const Real between = (hot * 500 + cold * 20) / (hot + cold);
  const auto run = [&](int n) {
    return simulate_shipped("half-spaces", {every(n), "time.max_step=2 us", "time.end=5 ms",
                                            "parameters.width=0.1 mm"});
  };
  const auto temperatures = [](const BodyView& body) {
    return std::find_if(body.point_fields.begin(), body.point_fields.end(),
                        [](const Field& field) { return field.name == "temperature"; })
        ->values;
  };
  const auto once = run(1);
  for (const int n : {2, 4, 8, 16}) {
    const auto kept = run(n);
    EXPECT_EQ(kept.steps, once.steps);  // max_step rules: windows do not shorten it
    EXPECT_NEAR(kept.measures.at("contact") - kZero, between, 0.005 * 480);
    EXPECT_LT(std::fabs(kept.last("heat.drift")), 1e-12);
    for (const auto& [name, start, diffusivity] : {std::tuple("hot", 500.0, 237.0 / 2700 / 900),
                                                   std::tuple("cold", 20.0, 44.5 / 7850 / 475)}) {
      const Real scale = (start - between) * (n - 1) * kStep / kTime / std::sqrt(kPi);
      const BodyView& body = kept.bodies.at(name);
      const auto now = temperatures(body), before = temperatures(once.bodies.at(name));
      Real largest = 0, worst = 0;
      for (std::size_t i = 0; i < now.size(); ++i) {
        const Real eta = std::fabs(body.position[3 * i]) / (2 * std::sqrt(diffusivity * kTime));
        const Real expected = scale * eta * (0.25 + 0.5 * eta * eta) * std::exp(-eta * eta);
        largest = std::max(largest, std::fabs(now[i] - before[i]));
        worst = std::max(worst, std::fabs(now[i] - before[i] - expected));
      }
      std::printf("N = %2d, %s: %.5f K, off its closed form by %.5f K\n", n, name, largest, worst);
      EXPECT_NEAR(largest, 0.280 * std::fabs(scale), 0.1 * 0.280 * std::fabs(scale));
      EXPECT_LT(worst, 0.1 * 0.280 * std::fabs(scale));
    }
  }
}

// A window as long as the step limit allows, from temperatures without any order, in a fluid that
// takes ten times as much from surface points as their neighbours do, 1e6 W/m^2/K against k/(0.375
// h) or so: no point ever leaves the extremes of body and fluid. A step limit of C/(N G + H) would
// let it.
TEST(HeatEvery, WindowsMakeNoNewExtremes) {
  for (const char* method : {"fe", "sph"}) {
    SceneHooks hooks;
    hooks.built = [](Scene<3>& scene) {
      auto& points = scene.solids[0]->points();
      std::mt19937_64 random(5);
      for (std::size_t i = 0; i < points.x.size(); ++i) {
        points.temperature[i] = points.start_temperature[i] = random() % 2 == 0 ? 300 : 400;
      }
    };
    Real lowest = kInfinity, highest = -kInfinity, after = 0;
    hooks.step_done = [&](Scene<3>& scene, const Clock&) {
      after = -kInfinity;
      for (const Real T : scene.solids[0]->points().temperature) {
        lowest = std::min(lowest, T), highest = std::max(highest, T), after = std::max(after, T);
      }
    };
    const std::string text =
        std::string(
            "geometry: 3d\ntime: {end: 1 s, safety: 1}\nmaterials: {steel: {density: 7850, "
            "elastic: {E: 200 GPa, nu: 0.3}, thermal: {cp: 475, k: 44.5}}}\nbodies: {cube: "
            "{method: ") +
        method +
        ", material: steel, size: 1 mm, shape: {box: {min: [0, 0, 0], max: [6 mm, 6 mm, 6 mm]}}}}\n"
        "boundaries:\n  still: {body: cube, where: all, fix: [x, y, z]}\n  fluid: {body: cube, "
        "where: {side: max-x}, convection: {h: 1e6, T: 250 K}}\n";
    const auto once = simulate_text(text);
    const auto run = simulate_text(text, {every(5)}, {}, hooks);
    ASSERT_EQ(run.failure, "");
    EXPECT_GE(lowest, 250 - 1e-9) << method;
    EXPECT_LE(highest, 400 + 1e-9) << method;
    EXPECT_LT(after, 350);  // it has cooled
    EXPECT_NEAR(static_cast<Real>(run.steps), 5.0 * static_cast<Real>(once.steps), 5);
    EXPECT_LT(std::fabs(run.last("heat.drift")), 1e-12);
  }
}

// Latent heat, held bodies and contact. Fronts and temperatures as exact as with every step
// (tests/verification/enthalpy_test.cpp): windows are as long as steps were.
TEST(HeatEvery, AMeltFreezesAsBefore) {
  const auto run = simulate_shipped("freezing-slab", {every(4)});
  ASSERT_EQ(run.failure, "");
  for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
  EXPECT_NEAR(run.measures.at("contact"), 839.11, 1);
  EXPECT_NEAR(run.measures.at("in_mould"), 600.26, 1);
  EXPECT_NEAR(run.measures.at("in_solid"), 894.78, 1);
  EXPECT_NEAR(run.measures.at("in_melt"), 974.34, 1);
}

// Everything at once: particles and hexes, contact, friction, plastic work. No rate within the
// bodies is faster than 2 G/C, so that none changes by more than N dt G/C, which is 4e-4 with 16
// steps; what passes the contact depends on both sides.
TEST(HeatEvery, AHotBlockKeepsItsHeatAndItsBits) {
  const std::vector<std::string> with{"time.end=20 us", every(16)};
  const auto once = simulate_shipped("hot-block", {"time.end=20 us", every(1)});
  const auto kept = simulate_shipped("hot-block", with);
  ASSERT_EQ(kept.failure, "");
  EXPECT_EQ(kept.steps, once.steps);
  for (const Real drift : kept.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
  EXPECT_NE(kept.hashes.back(), once.hashes.back());
  const Real heat = once.last("body.plate.heat");
  EXPECT_GT(heat, 0);
  EXPECT_NEAR(kept.last("body.plate.heat"), heat, 1e-3 * heat);
  EXPECT_NEAR(kept.last("heat.plastic"), once.last("heat.plastic"), 1e-9 * heat);
  for (const RunVariation& variation :
       {RunVariation{2, false, 0}, RunVariation{0, true, 0}, RunVariation{0, false, 50}}) {
    EXPECT_EQ(simulate_shipped("hot-block", with, variation).hashes, kept.hashes);
  }
}

// Plastic heat goes to nodes in the step that makes it: a bar that hits a wall has the same heat of
// its elements after each step as with conduction in each.
TEST(HeatEvery, PlasticHeatDoesNotWait) {
  for (const auto& [name, size] : {std::pair("taylor-bar", "parameters.size=0.9 mm"),
                                   std::pair("taylor-bar-sph", "parameters.spacing=0.8 mm")}) {
    std::vector<std::string> deck{"materials.copper.thermal={cp: 383 J/kg/K, k: 386 W/m/K}",
                                  "heat=conduct", "time.end=4 us", "output.history=40 ns", size};
    auto with = deck;
    with.push_back(every(64)), deck.push_back(every(1));
    const auto once = simulate_shipped(name, deck), kept = simulate_shipped(name, with);
    ASSERT_EQ(kept.failure, "");
    const auto a = once.column("heat.plastic"), b = kept.column("heat.plastic");
    const auto stored = kept.column("heat.stored"), shock = kept.column("heat.compression");
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_NEAR(b[k], a[k], 1e-3 * a.back());  // the flow stress sees another temperature
      EXPECT_NEAR(stored[k], b[k] + shock[k], 1e-12 * a.back());
    }
    EXPECT_GT(a.back(), 0);
  }
}

/// Steps of all windows of a run, by the step that begins them.
std::vector<std::pair<std::int64_t, int>> windows_of(const std::string& text,
                                                     const std::vector<std::string>& overrides,
                                                     Real* largest = nullptr) {
  std::vector<std::pair<std::int64_t, int>> windows;
  SceneHooks hooks;
  hooks.step_done = [&](Scene<3>& scene, const Clock& clock) {
    const auto step = clock.step() - 1;  // the one that is done
    if (windows.empty() || step == windows.back().first + windows.back().second) {
      windows.emplace_back(step, scene.heat_windows.steps());
    }
    if (largest != nullptr) *largest = scene.heat_windows.largest_part();
  };
  EXPECT_EQ(simulate_text(text, overrides, {}, hooks).failure, "");
  return windows;
}

// Where the deck does not say, a window is a hundredth of heat's step: C/G = 0.375 h^2/alpha of a
// corner, 0.33 us, so that steps of 0.5 ns are taken six at a time and of 0.1 ns sixteen, the most.
// Before, no window is longer than a 64th of the steps that were.
TEST(HeatEvery, WithoutANumberAWindowIsAHundredthOfHeatsStep) {
  for (const auto& [step, expected] : {std::pair(0.5, 6), {0.1, 16}}) {
    const std::string max_step = "time.max_step=" + std::to_string(step) + " ns";
    const std::string end = "time.end=" + std::to_string(1100 * step) + " ns";
    Real largest = 0;
    const auto windows = windows_of(bar("fe", 2), {max_step, end, "time.safety=0.5"}, &largest);
    EXPECT_EQ(windows[windows.size() - 2].second, expected) << step;
    for (const auto& [first, steps] : windows) EXPECT_LE(steps, 1 + first / 64);
    EXPECT_LT(largest, 0.01);
  }
}

// Particles have no conductance before their lists are made.
TEST(HeatEvery, ParticlesChooseTheirWindowsToo) {
  Real largest = 0;
  const auto windows =
      windows_of(bar("sph", 4), {"time.max_step=0.5 ns", "time.end=300 ns"}, &largest);
  EXPECT_GT(windows[windows.size() - 2].second, 1);
  EXPECT_LT(largest, 0.01);
}

// Bodies that do not move step as heat asks: no window is shorter than one of its steps.
TEST(HeatEvery, WhereHeatBoundsTheStepItIsConductedInEach) {
  const std::string held =
      "geometry: 3d\nheat: conduct\ntime: {end: 1 s}\nambient: 300 K\n"
      "materials: {copper: {density: 8960, elastic: {E: 124 GPa, nu: 0.34}, "
      "thermal: {cp: 383, k: 386}}}\nbodies: {plate: {material: copper, rigid: true, "
      "size: 1 mm, shape: {box: {min: [0, 0, 0], max: [4 mm, 2 mm, 2 mm]}}}}\n";
  const auto windows = windows_of(held, {});
  EXPECT_GT(windows.size(), 128U);
  for (const auto& [first, steps] : windows) EXPECT_EQ(steps, 1) << first;
}

// A conductivity that grows from nothing to that of copper as a body is heated: windows follow,
// and no step is lost. Chosen for the whole run at time 0, they bounded it (5,327 steps for 776).
TEST(HeatEvery, WindowsFollowAConductivityThatGrows) {
  const std::string heated =
      "geometry: 3d\nheat: conduct\ntime: {end: 10 ns}\nmaterials:\n  copper: {density: 8960, "
      "elastic: {E: 124 GPa, nu: 0.34}, thermal: {cp: 383, k: {table: [[300 K, 0], [320 K, 386], "
      "[2000 K, 386]], over: temperature}}}\nbodies:\n  cube: {material: copper, temperature: "
      "300 K, size: 0.1 um, shape: {box: {min: [0, 0, 0], max: [0.4 um, 0.4 um, 0.4 um]}}}\n"
      "boundaries: {hot: {body: cube, where: {side: min-z}, temperature: 400 K}}\n";
  const auto once = simulate_text(heated, {every(1)}), chosen = simulate_text(heated, {});
  ASSERT_EQ(chosen.failure, "");
  EXPECT_LE(chosen.steps, once.steps + 16);
  EXPECT_NEAR(chosen.last("body.cube.heat"), once.last("body.cube.heat"),
              1e-3 * once.last("body.cube.heat"));
}

// Two blocks that touch perfectly at time 0, 600 K and 300 K: nothing has flowed behind the contact
// when conduction is evaluated first. A window that is a 64th of the time errs by 0.158/64 of the
// jump where it errs most, and by a tenth of that in the heat that has passed.
TEST(HeatEvery, AJumpOfTheStartIsConductedInTime) {
  const std::string touching =
      "geometry: 3d\nheat: conduct\ntime: {end: 10 us}\nmaterials: {copper: {density: 8960, "
      "elastic: {E: 124 GPa, nu: 0.34}, strength: {j2: {yield: 100 MPa}}, thermal: {cp: 383, "
      "k: 386}}}\nbodies:\n  hot: {material: copper, temperature: 600 K, velocity: [0, 0, "
      "-0.5 m/s], size: 100 um, shape: {box: {min: [0, 0, 0], max: [400 um, 400 um, 400 um]}}}\n"
      "  cold: {material: copper, temperature: 300 K, size: 100 um, shape: {box: {min: [0, 0, "
      "-400 um], max: [400 um, 400 um, 0]}}}\nboundaries:\n  foot: {body: cold, where: {side: "
      "min-z}, fix: [x, y, z]}\n  head: {body: hot, where: {side: max-z}, velocity: [0, 0, "
      "-0.5 m/s]}\ncontact: {default: {heat: perfect}}\n";
  for (const char* end : {"time.end=1 us", "time.end=10 us", "time.end=40 us"}) {
    const auto once = simulate_text(touching, {every(1), end});
    const auto chosen = simulate_text(touching, {end});
    ASSERT_EQ(chosen.failure, "");
    EXPECT_NEAR(chosen.last("body.cold.heat") / once.last("body.cold.heat"), 1, 5e-4) << end;
    EXPECT_LT(std::fabs(chosen.last("heat.drift")), 1e-12);
  }
}

// Windows are state: a restart within one, and lists made anew in each step, have the same bits.
TEST(HeatEvery, WhatIsChosenIsOfTheDeckAlone) {
  const std::vector<std::string> deck{"time.end=20 us"};
  const auto chosen = simulate_shipped("hot-block", deck);
  EXPECT_NE(chosen.hashes.back(),
            simulate_shipped("hot-block", {"time.end=20 us", every(1)}).hashes.back());
  for (const RunVariation& variation :
       {RunVariation{2, false, 0}, RunVariation{0, true, 0}, RunVariation{0, false, 50},
        RunVariation{0, false, 517}, RunVariation{0, false, 523}}) {
    EXPECT_EQ(simulate_shipped("hot-block", deck, variation).hashes, chosen.hashes);
  }
}

}  // namespace
}  // namespace brunt::test
