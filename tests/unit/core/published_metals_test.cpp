/// The radial return with the constants of published metals (Johnson & Cook 1983; Lesuer 2000 for
/// Ti-6Al-4V, Borvik et al. 2001 for Weldox 460 E), over the states that a run may come to: trial
/// stresses that lead to increments from 1e-10 to 1e-2, rates about rate_ref, where the law has a
/// corner, temperatures from T_ref to near melting, points that begin to yield and such that
/// yielded in the last step at about this rate or at any other.
///
/// - The stress is the flow stress of the new state to 1e-9 of it, or of a tenth of the trial
///   stress: see radial_return_test.cpp.
/// - The rate of the last step, from which the return begins, changes it by no more. Armco iron is
///   left out of that: as its exponent m is 0.55, heat near T_ref can leave two stresses that fit.
#include <gtest/gtest.h>

#include <random>

#include "core/materials/johnson_cook.hpp"
#include "core/materials/radial_return.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

struct Metal {
  const char* name;
  Real A, B, n, C, m, T_melt, rate_ref, shear, heat_capacity;
};
constexpr Metal kMetals[] = {
    {"OFHC copper", 90e6, 292e6, .31, .025, 1.09, 1356, 1, 46e9, 8960 * 383.},
    {"Armco iron", 175e6, 380e6, .32, .06, .55, 1811, 1, 80e9, 7890 * 452.},
    {"4340 steel", 792e6, 510e6, .26, .014, 1.03, 1793, 1, 77e9, 7830 * 477.},
    {"2024 aluminium", 265e6, 426e6, .34, .015, 1.0, 775, 1, 27e9, 2770 * 875.},
    {"tungsten", 1506e6, 177e6, .12, .016, 1.0, 1723, 1, 150e9, 17000 * 134.},
    {"Ti-6Al-4V", 862e6, 331e6, .34, .012, .8, 1878, 1, 43e9, 4428 * 580.},
    {"cartridge brass", 112e6, 505e6, .42, .009, 1.68, 1189, 1, 40e9, 8520 * 385.},
    {"depleted uranium", 1079e6, 1120e6, .25, .007, 1, 1473, 1, 58e9, 18600 * 117.},
    {"Weldox 460 E", 490e6, 383e6, .45, .0123, .94, 1800, 5e-4, 77e9, 7850 * 452.},
};
constexpr Real kT_ref = 298, kTaylorQuinney = 0.9;

JohnsonCook law_of(const Metal& metal) {
  JohnsonCook law;
  law.A = metal.A, law.B = metal.B, law.n = metal.n, law.C = metal.C, law.m = metal.m;
  law.T_melt = metal.T_melt, law.rate_ref = metal.rate_ref, law.T_ref = kT_ref;
  return law;
}

/// A point in shear before a step.
struct Before {
  Real eps_p = 0, temperature = kT_ref, q = 0, q_trial = 0, dt = 0, rate = 0;
};

Before any_point(const Metal& metal, std::mt19937_64& random) {
  const auto uniform = [&](Real a, Real b) {
    return std::uniform_real_distribution<Real>(a, b)(random);
  };
  const auto decades = [&](Real a, Real b) { return std::exp(uniform(std::log(a), std::log(b))); };
  const auto one_of = [&](unsigned n) { return random() % n == 0; };
  const JohnsonCook law = law_of(metal);
  Before at;
  at.dt = decades(1e-10, 1e-6);
  at.eps_p = one_of(6) ? 0 : decades(1e-6, 2);
  if (!one_of(3)) at.temperature += decades(1e-3, 0.95 * (metal.T_melt - kT_ref));
  Real increment = decades(1e-10, 1e-2);
  if (one_of(4)) increment = metal.rate_ref * at.dt * decades(0.5, 2);
  const Real rate = increment / at.dt;
  const Real yield = law.flow_stress(at.eps_p, 0.0, at.temperature);
  const Real hotter = at.temperature + kTaylorQuinney / metal.heat_capacity * yield * increment;
  const Real flow = law.flow_stress(at.eps_p + increment, rate, hotter);
  at.q_trial = flow + 3 * metal.shear * increment;
  at.q = one_of(3) ? yield * uniform(0, 1) : flow * uniform(0.9, 1);
  const Real parts[] = {0, 1, uniform(0.9, 1.1), decades(1e-6, 1e6), 1 + 1e-3 * uniform(-1, 1)};
  at.rate = rate * parts[random() % std::size(parts)];
  return at;
}

/// The increment of eps_p in a step [1]. distance: of the stress from the new flow stress [1], out
Real increment_after(const Metal& metal, const Before& at, Real& distance) {
  static OneTile one(full_state(kT_ref));
  one.tile.adiabatic = true;
  MaterialState& state = one.state;
  for (std::size_t k = 0; k < kTile; ++k) {
    for (auto& component : state.deviator) component[k] = 0;
    state.deviator[xy][k] = at.q / std::sqrt(3.0);
    one.tile.strain[xy][k] = (at.q_trial - at.q) / std::sqrt(3.0) / (2 * metal.shear);
    state.eps_p[k] = at.eps_p, state.temperature[k] = at.temperature;
    state.strain_rate[k] = at.rate;
  }
  const JohnsonCook law = law_of(metal);
  const RadialReturn<JohnsonCook> strength(law, {metal.shear, metal.heat_capacity, kTaylorQuinney});
  strength.update(one.at_first(), at.dt);
  const Real flow = law.flow_stress(state.eps_p[0], state.strain_rate[0], state.temperature[0]);
  const Real scale = std::max(flow, at.q_trial / 10);
  distance = state.strain_rate[0] > 0 ? std::fabs(equivalent_stress(state, 0) - flow) / scale : 0;
  return state.strain_rate[0] * at.dt;
}

TEST(PublishedMetals, EndOnTheYieldSurfaceWhereverTheReturnBegins) {
  for (const Metal& metal : kMetals) {
    std::mt19937_64 random(5);
    Real worst = 0, worst_apart = 0;
    int yielded = 0;
    for (int k = 0; k < 20000; ++k) {
      Before at = any_point(metal, random);
      Real distance = 0, other = 0;
      const Real d = increment_after(metal, at, distance);
      yielded += d > 0;
      at.rate = 0;
      const Real apart = d - increment_after(metal, at, other);
      worst = std::max({worst, distance, other});
      const Real q = at.q_trial - 3 * metal.shear * d;
      worst_apart = std::max(worst_apart, 3 * metal.shear * std::fabs(apart) / q);
    }
    EXPECT_LT(worst, 1e-9) << metal.name;
    if (metal.m > 0.6) {
      EXPECT_LT(worst_apart, 1e-9) << metal.name;
    }
    EXPECT_GT(yielded, 15000) << metal.name;
  }
}

}  // namespace
}  // namespace brunt
