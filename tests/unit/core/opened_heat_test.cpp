/// Heat of compression of what opens. d ln T = -Gamma d ln V holds for a volume that bears its
/// pressure; what opens without resistance does no work on it, and its temperature stays. Of a
/// point of damage d at V/V0 = J the volume that bears is
///   J_b = (1 - d) min(J, J_t) + d min(J, J_0),
/// J_t and J_0 where the law has minus the cut-off, and no pressure, at the point's energy E:
///   Mie-Grueneisen, K (1/J - 1) + gamma0 E = p:  J_p = 1/(1 + (p - gamma0 E)/K), and
///   T = T0 exp(gamma0 (1 - J_b)), whatever the path;
///   polynomial, p = C1 mu + C4 (1 + mu) E, whose Gamma = J dp/dE is C4: mu_0 = -C4 E/(C1 + C4 E),
///   T = T0 J_b^-C4.
/// Where plastic flow has its own volume and opening, J_b = J/(J_p J_o).
/// Tolerance: rounding of some 300 steps, each of 1e-16 of T.
#include <gtest/gtest.h>

#include <cmath>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

constexpr Real kDensity = 2703, kHeat = 896, kStart = 300, kCapacity = kDensity * kHeat;
constexpr Real kGamma = 1.97, kTolerance = 1e-11 * kStart;
constexpr MieGruneisen kAluminium{5240, 1.40, kGamma};

Material metal_of(const EosLaw& eos, const DamageChoice& law, const StrengthLaw& strength) {
  Material made;
  made.density = kDensity, made.shear = 26e9;
  made.thermal = true, made.specific_heat = SpecificHeat(kHeat);
  made.strength = make_strength(strength, {made.shear, kCapacity, 0.9});
  made.eos = make_eos(eos, {kDensity, 70e9});
  made.bulk = made.eos->bulk_modulus();
  made.damage = make_damage(law, {made.shear});
  return made;
}

/// A point that is taken to volume ratios.
struct Point {
  Material material;
  OneTile points;
  explicit Point(Material given)
      : material(std::move(given)), points(material.initial_state(kTile, kStart, true)) {
    points.tile.adiabatic = true;
  }
  void take_to(Real ratio) {
    const Real third = std::log(ratio / points.tile.ratio[0]) / 3;
    for (int c = 0; c < 3; ++c) std::fill_n(points.tile.strain[c], kTile, third);
    std::fill_n(points.tile.ratio, kTile, ratio);
    material.update(points.at_first(), 1e-9);
    std::fill_n(points.tile.ratio_old, kTile, ratio);
  }
  Real T() const { return points.state.temperature[7]; }
  Real p() const { return points.state.pressure[7]; }
  Real E() const { return points.state.energy[7]; }
  Real damage() const { return points.state.damage[7]; }
};

/// V/V0 of Mie and Grueneisen in tension.
Real ratio_at(const Point& point, Real pressure) {
  return 1 / (1 + (pressure - kGamma * point.E()) / point.material.bulk);
}

TEST(OpenedHeat, WhatHasFailedAndIsOpenKeepsItsTemperature) {
  Point point(metal_of(kAluminium, MeanTensionDamage{5e8, 0}, NoStrength{}));
  Real ratio = 1;
  while (point.damage() < 1) {
    EXPECT_NEAR(point.T(), kStart * std::exp(kGamma * (1 - ratio)), kTolerance);
    point.take_to(ratio += 5e-4);
  }
  // Parted, it springs back to no stress, and so to the temperature that it has there.
  const Real open = ratio_at(point, 0);
  EXPECT_GT(point.E(), 0);
  for (; ratio < 2; ratio += 0.01) {
    point.take_to(ratio);
    EXPECT_EQ(point.p(), 0);
    EXPECT_NEAR(point.T(), kStart * std::exp(kGamma * (1 - open)), kTolerance);
  }
  // It closes: pressure and heating begin together, in the middle of a step or not.
  for (; ratio > 0.9; ratio -= 0.011) {
    point.take_to(ratio);
    EXPECT_NEAR(point.T(), kStart * std::exp(kGamma * (1 - std::min(ratio, ratio_at(point, 0)))),
                kTolerance);
  }
  EXPECT_GT(point.p(), 1e9);
  EXPECT_NEAR(point.points.state.compression_heat[7], kCapacity * (point.T() - kStart),
              kCapacity * kTolerance);
}

TEST(OpenedHeat, OfWhatSoftensThePartThatCarriesCools) {
  for (const Real cutoff : {kInfinity, 5.5e8}) {
    // psi_0 = f^2/2K = 1.7 MJ/m^3 of the 10 MJ/m^3 of the crack
    Material material = metal_of(kAluminium, MeanTensionDamage{5e8, 1e7}, NoStrength{});
    material.tensile_cutoff = cutoff;
    Point point(std::move(material));
    int partly = 0;
    Real least = kStart;
    const auto follow = [&](Real ratio) {
      point.take_to(ratio);
      const Real d = point.damage();
      const Real intact = cutoff < kInfinity ? ratio_at(point, -cutoff) : ratio;
      const Real bears =
          (1 - d) * std::min(ratio, intact) + d * std::min(ratio, ratio_at(point, 0));
      ASSERT_NEAR(point.T(), kStart * std::exp(kGamma * (1 - bears)), kTolerance) << ratio;
      partly += d > 0 && d < 1 ? 1 : 0;
      least = std::min(least, point.T());
    };
    for (int i = 1; i <= 150; ++i) follow(1 + 3e-4 * i);
    for (int i = 150; i >= -50; --i) follow(1 + 3e-4 * i);
    EXPECT_GT(partly, 20);
    EXPECT_EQ(point.damage(), 1);
    EXPECT_GT(least, kStart - 8);
    EXPECT_GT(point.T(), kStart);
  }
}

TEST(OpenedHeat, OfAPrintedLawToo) {
  Polynomial law;
  law.C1 = 70e9, law.C4 = law.C5 = 1.7;
  Point point(metal_of(law, MeanTensionDamage{5e8, 0}, NoStrength{}));
  for (int i = 1; i <= 300; ++i) {
    const Real ratio = i <= 200 ? 1 + 2e-3 * i : 1.4 - 5e-3 * (i - 200);
    point.take_to(ratio);
    const Real of_energy = law.C4 * point.E(), rest = 1 - of_energy / (law.C1 + of_energy);
    const Real bears = point.damage() > 0 ? std::min(ratio, 1 / rest) : ratio;
    ASSERT_NEAR(point.T(), kStart * std::pow(bears, -law.C4), kTolerance) << ratio;
  }
  EXPECT_EQ(point.damage(), 1);
  EXPECT_GT(point.T(), kStart);  // it ends at V/V0 = 0.9
}

// Without shear nothing dilates: opened, the grains keep the temperature of the largest tension,
// and as heat what that tension did on the opening, p_t w of (M18), 0.9 of which stays.
TEST(OpenedHeat, OfGrainsThatPart) {
  DruckerPrager law;
  law.cohesion = 20e6, law.friction_angle = 30 * std::acos(-1.0) / 180;
  Point point(metal_of(kAluminium, NoDamage{}, law));
  const auto bears = [&] {
    return point.points.tile.ratio[0] /
           (point.points.state.plastic_volume[7] * point.points.state.opening[7]);
  };
  for (int i = 1; i <= 300; ++i) {
    point.take_to(i <= 200 ? 1 + 1e-3 * i : 1.2 - 3e-3 * (i - 200));
    const Real plastic = point.points.state.heat[7] / kCapacity;
    const Real reversible = kStart * (std::exp(kGamma * (1 - bears())) - 1);
    // What flow has heated is compressed with the rest, by gamma0 times a strain of 0.1 at most.
    ASSERT_NEAR(point.T() - kStart, reversible + plastic, 0.25 * plastic + kTolerance) << i;
    if (i == 200) {
      EXPECT_NEAR(bears(), 1, 1e-3);
      EXPECT_GT(point.points.state.opening[7], 1.19);
    }
  }
  EXPECT_GT(point.p(), 5e9);  // closed, and pressed to V/V0 = 0.9
}

}  // namespace
}  // namespace brunt
