#pragma once
/// What tests of printed equations of state share.
#include <gtest/gtest.h>

#include <cmath>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {

inline constexpr Real kNoDeviatoricWork[kTile] = {};

/// A tile of a material that is no more than its equation of state, at rest.
struct EosTile {
  OneTile points;
  std::unique_ptr<EquationOfState> eos;

  EosTile(const EosLaw& law, Real density)
      : points(full_state(298)), eos(make_eos(law, {density, 0})) {
    points.state.pressure.assign(kTile, eos->initial_pressure());
    points.state.energy.assign(kTile, eos->initial_energy());
    points.state.bulk.assign(kTile, eos->bulk_modulus());
  }
  /// Takes all points to V/V0 = ratio in one step, with work from elsewhere [J/m^3].
  void go(Real ratio, Real work = 0) {
    std::fill_n(points.tile.ratio, kTile, ratio);
    std::fill_n(points.tile.viscous_work, kTile, work);
    eos->update(points.at_first(), kNoDeviatoricWork);
    std::fill_n(points.tile.ratio_old, kTile, ratio);
  }
  /// To V/V0 in so many steps of the same ratio.
  void go_slowly(Real ratio, int steps) {
    const Real from = points.tile.ratio_old[0];
    for (int i = 1; i <= steps; ++i)
      go(from * std::pow(ratio / from, static_cast<Real>(i) / steps));
  }
  Real pressure() const { return points.state.pressure[5]; }
  Real energy() const { return points.state.energy[5]; }
  Real bulk() const { return points.state.bulk[5]; }
};

/// Expects rho c^2 to be the slope of the isentrope, dp/d(ln rho), by two small steps.
inline void expect_isentropic_tangent(const EosLaw& law, Real density, Real ratio) {
  constexpr Real h = 1e-5;
  EosTile at(law, density), up(law, density), down(law, density);
  for (EosTile* tile : {&at, &up, &down}) tile->go_slowly(ratio, 50);
  up.go(ratio * (1 - h)), down.go(ratio * (1 + h));
  const Real slope = (up.pressure() - down.pressure()) / (2 * h);
  EXPECT_NEAR(at.bulk() / slope, 1, 1e-7) << ratio;  // h^2, and rounding over h
}

/// Expects what the energy gains in one step to be the work of the mean pressure and from
/// elsewhere.
inline void expect_energy_closes(const EosLaw& law, Real density, Real ratio, Real work) {
  EosTile tile(law, density);
  const Real p = tile.pressure(), e = tile.energy();
  tile.go(ratio, work);
  const Real gained = work - 0.5 * (p + tile.pressure()) * (ratio - 1);
  EXPECT_NEAR(tile.energy() - e, gained, 1e-13 * (std::fabs(e) + std::fabs(gained)));
}

}  // namespace brunt
