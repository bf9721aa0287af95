#pragma once
/// A material point of concrete on a path of strain, for tests: logarithmic strains, V/V0 by them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {

inline Material concrete_of(const StrengthLaw& law, Real density = 2440) {
  const OwnConstants constants = *own_constants(law);
  Material made;
  made.density = density, made.shear = constants.shear;
  made.strength = make_strength(law, {constants.shear, 0, 0});
  made.eos = make_eos(LinearEos{}, {density, constants.bulk});
  made.bulk = constants.bulk;
  return made;
}

struct ConcretePoint {
  const Material* material;
  OneTile points;
  Real logarithm = 0;  ///< [1] ln V/V0
  Real work = 0;       ///< [J/m^3 reference] of all stresses

  explicit ConcretePoint(const Material& of, Real length = 0.01)
      : material(&of), points(of.initial_state(kTile, 298, false)) {
    points.tile.count = kLanes;
    std::fill(points.state.length.begin(), points.state.length.end(), length);
  }
  /// One step of strains, components as SymmetricIndex.
  void strain(const std::array<Real, 6>& by, Real dt = 1e-6) {
    const Real before = logarithm;
    logarithm += by[xx] + by[yy] + by[zz];
    std::array<Real, 6> stress_before;
    for (std::size_t c = 0; c < 6; ++c) stress_before[c] = stress(c);
    for (int i = 0; i < kTile; ++i) {
      points.tile.ratio_old[i] = std::exp(before), points.tile.ratio[i] = std::exp(logarithm);
      for (std::size_t c = 0; c < 6; ++c) points.tile.strain[c][i] = by[c];
    }
    material->update(points.at_first(), dt);
    const Real ratio = std::exp(0.5 * (before + logarithm));
    for (std::size_t c = 0; c < 6; ++c) {
      work += ratio * (c < 3 ? 0.5 : 1.0) * (stress_before[c] + stress(c)) * by[c];
    }
  }
  void diagonal(Real x, Real y, Real z) {
    std::array<Real, 6> by{};
    by[xx] = x, by[yy] = y, by[zz] = z;
    strain(by);
  }
  /// Strains along x by so much, with the lateral strain that brings the lateral stress [Pa].
  void triaxial(Real along, Real lateral_stress);
  Real stress(std::size_t c) const {
    return points.state.deviator[c][1] - (c < 3 ? points.state.pressure[1] : 0.0);
  }
  Real pressure() const { return points.state.pressure[1]; }
  Real q() const { return equivalent_stress(points.state, 1); }
};

/// To within 100 Pa, unless the lateral stress jumps.
inline void ConcretePoint::triaxial(Real along, Real lateral_stress) {
  const auto missed = [&](Real lateral) {
    ConcretePoint trial = *this;
    trial.diagonal(along, lateral, lateral);
    return trial.stress(yy) - lateral_stress;
  };
  const Real size = std::fabs(along);
  Real lo = -0.5 * size, hi = 0.6 * size, at_lo = missed(lo), at_hi = missed(hi);
  if (!(at_lo < 0 && at_hi > 0)) {
    lo = -4 * size, hi = 12 * size;
    at_lo = missed(lo), at_hi = missed(hi);
  }
  Real best = std::fabs(at_lo) < std::fabs(at_hi) ? lo : hi;
  for (int n = 0; n < 40 && at_lo < 0 && at_hi > 0 && hi - lo > 1e-6 * size; ++n) {
    best = n % 3 == 2 ? 0.5 * (lo + hi) : (lo * at_hi - hi * at_lo) / (at_hi - at_lo);
    const Real value = missed(best);
    if (std::fabs(value) < 100) break;
    (value < 0 ? lo : hi) = best;
    (value < 0 ? at_lo : at_hi) = value;
  }
  diagonal(along, best, best);
}

/// Paths of random steps, of strains of 1e-6 to 0.05 (what one step of a hit element may bring),
/// end in a state that is a number, with a stress that its strength bears.
inline void expect_states_of_random_paths(const Material& material) {
  std::mt19937 random(5);
  std::uniform_real_distribution<Real> one(-1, 1), exponent(std::log(1e-6), std::log(0.05));
  for (int path = 0; path < 2000; ++path) {
    ConcretePoint point(material);
    const Real tension = point.points.state.tensile_strength[1];
    const Real size = std::exp(exponent(random));
    for (int n = 0; n < 20; ++n) {
      std::array<Real, 6> by;
      for (Real& strain : by) strain = size * one(random);
      const Real mean = (by[xx] + by[yy] + by[zz]) / 3;
      // Volumes of a third to three times stay those of a solid.
      if (std::fabs(point.logarithm + 3 * mean) > 1) {
        for (std::size_t c : {xx, yy, zz}) by[c] -= mean;
      }
      point.strain(by);
      ASSERT_TRUE(std::isfinite(point.pressure()) && std::isfinite(point.q())) << path << ' ' << n;
      ASSERT_GE(point.pressure(), -tension * (1 + 1e-9)) << path << ' ' << n;
      ASSERT_TRUE(std::isfinite(point.points.state.eps_p[1])) << path << ' ' << n;
      ASSERT_TRUE(std::isfinite(point.points.state.bulk[1])) << path << ' ' << n;
      for (const auto& own : point.points.state.own) {
        ASSERT_TRUE(std::isfinite(own[1])) << path << ' ' << n;
      }
    }
  }
}

}  // namespace brunt
