/// Damage: the principal stress, each law against its printed formula, and what a point does that
/// fails: no tension and no shear is left, pressure comes back where what has opened closes, and a
/// crack takes the same energy whatever the size of the element.
#include "core/materials/damage_laws.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

constexpr Real kSteelDensity = 7850, kSteelShear = 80e9, kSteelBulk = 160e9;

Material made_of(const StrengthLaw& strength, const EosLaw& eos, const DamageChoice& law) {
  Material made;
  made.density = kSteelDensity, made.shear = kSteelShear;
  made.thermal = true, made.specific_heat = SpecificHeat(450);
  made.strength = make_strength(strength, {kSteelShear, kSteelDensity * 450, 0.9});
  made.eos = make_eos(eos, {kSteelDensity, kSteelBulk});
  made.bulk = made.eos->bulk_modulus();
  made.damage = make_damage(law, {kSteelShear});
  return made;
}

Varying hardening(Real modulus) {
  Varying constant;
  constant.constant = modulus;
  return constant;
}

TEST(Damage, LargestPrincipalStressIsThatOfAnEigenvalueSolver) {
  std::mt19937 generator(7);
  std::normal_distribution<Real> normal(0, 1e8);
  for (int n = 0; n < 2000; ++n) {
    Mat3 s;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) s(i, j) = s(j, i) = normal(generator);
    }
    // Now and then two values alike, or one of three: where formulas break.
    if (n % 5 == 0) s = Vec3(1e8, 1e8 * (1 + 1e-9 * (n % 3)), -3e8).asDiagonal();
    if (n % 5 == 1) s = Vec3(-1e8, -1e8, 2e8).asDiagonal();
    s -= s.trace() / 3 * Mat3::Identity();
    const Real exact = Eigen::SelfAdjointEigenSolver<Mat3>(s).eigenvalues()[2];
    const std::array<Real, 6> six{s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2)};
    EXPECT_NEAR(largest_principal(six), exact, 1e-7 * std::fabs(exact)) << n;
  }
  EXPECT_EQ(largest_principal(std::array<Real, 6>{}), 0.0);
}

// 4340 steel of Johnson & Cook 1985: D = 0.05, 3.44, -2.12, 0.002, 0.61. At a triaxiality of 1/3,
// 100/s and T* = 0.5: (0.05 + 3.44 exp(-2.12/3)) (1 + 0.002 ln 100) (1 + 0.61/2) = 1.7468 * 1.00921
// * 1.305.
TEST(Damage, JohnsonCookIsAsPrinted) {
  JohnsonCookDamage law;
  law.D1 = 0.05, law.D2 = 3.44, law.D3 = -2.12, law.D4 = 0.002, law.D5 = 0.61;
  law.T_ref = 300, law.T_melt = 1800;
  const DamagePoint<Real> at{0.1, 0.01, 100, 1050, -200e6, 600e6, 0};
  const Real tension = 0.05 + 3.44 * std::exp(-2.12 / 3);
  const Real strain = tension * (1 + 0.002 * std::log(100.0)) * (1 + 0.61 * 0.5);
  EXPECT_NEAR(law.strain_to_fail(at), strain, 1e-12 * strain);
  EXPECT_NEAR(strain, 2.30, 0.02);  // by hand
  EXPECT_NEAR(law.index(at, 0.25), 0.25 + 0.01 / strain, 1e-14);
}

TEST(Damage, OtherLawsAreAsPrinted) {
  const DamagePoint<Real> at{0.3, 0.02, 0, 300, -50e6, 100e6, 120e6};
  EXPECT_NEAR((StrainDamage{1.5, 0}.index(at, 0.1)), 0.2, 1e-15);
  EXPECT_NEAR((CockcroftLatham{300e6, 0}.index(at, 0.1)), 0.1 + 0.02 * 0.4, 1e-15);
  EXPECT_NEAR((PrincipalStressDamage{240e6, 0}.index(at, 0.1)), 0.5, 1e-15);
  EXPECT_NEAR((MeanTensionDamage{100e6, 0}.index(at, 0.1)), 0.5, 1e-15);
  const DamagePoint<Real> pressed{0.3, 0.02, 0, 300, 50e6, 100e6, -20e6};
  EXPECT_EQ((CockcroftLatham{300e6, 0}.index(pressed, 0.1)), 0.1);
}

/// Strains the tile by so much more along x and across, V/V0 with it.
void strain(OneTile& points, const Material& material, Real along, Real across, Real dt) {
  std::copy_n(points.tile.ratio, kTile, points.tile.ratio_old);
  for (int i = 0; i < kTile; ++i) {
    points.tile.strain[xx][i] = along;
    points.tile.strain[yy][i] = points.tile.strain[zz][i] = across;
    points.tile.ratio[i] *= 1 + along + 2 * across;
  }
  material.update(points.at_first(), dt);
}

Real axial(const OneTile& points) {
  return points.state.deviator[xx][3] - points.state.pressure[3];
}

// Uniaxial strain: sigma_xx = M eps, M = K + 4G/3 = 267 GPa, fails at 1 GPa, that is at 0.375 %.
TEST(Damage, WithoutAnEnergyAPointFailsInOneStep) {
  const Material brittle = made_of(NoStrength{}, LinearEos{}, PrincipalStressDamage{1e9, 0});
  OneTile points(brittle.initial_state(kTile, 298, false));
  for (int n = 0; n < 37; ++n) strain(points, brittle, 1e-4, 0, 1e-7);
  EXPECT_EQ(points.state.damage[3], 0.0);
  EXPECT_NEAR(axial(points) / (0.0037 * (kSteelBulk + 4 * kSteelShear / 3)), 1, 0.01);
  strain(points, brittle, 1e-4, 0, 1e-7);
  EXPECT_EQ(points.state.damage[3], 1.0);
  EXPECT_EQ(axial(points), 0.0);
  // What has opened closes without resistance, then presses as a liquid does.
  for (int n = 0; n < 37; ++n) strain(points, brittle, -1e-4, 0, 1e-7);
  EXPECT_EQ(axial(points), 0.0);
  for (int n = 0; n < 11; ++n) strain(points, brittle, -1e-4, 0, 1e-7);
  EXPECT_NEAR(axial(points) / (-kSteelBulk * 1e-3), 1, 0.02);
  EXPECT_EQ(points.state.deviator[xx][3], 0.0);
}

/// Work [J/m^2] that opens a crack through elements of a size [m], by the nominal stress.
Real work_of_crack(const Material& material, Real length, Real across) {
  OneTile points(material.initial_state(kTile, 298, true));
  std::fill(points.state.length.begin(), points.state.length.end(), length);
  const Real step = 2e-6 * 0.01 / length;
  Real work = 0, before = 0;
  for (int n = 0; n < 200000 && points.state.damage[3] < 1; ++n) {
    const Real ratio = points.tile.ratio[3];
    const Real one = points.state.deviator[yy][3] - points.state.pressure[3];
    strain(points, material, step, across * step, 1e-7);
    const Real two = points.state.deviator[yy][3] - points.state.pressure[3], now = axial(points);
    const Real mean = 0.5 * (ratio + points.tile.ratio[3]);
    work += mean * (0.5 * (before + now) + across * (one + two)) * step * length;
    before = now;
  }
  EXPECT_EQ(points.state.damage[3], 1.0);
  return work;
}

// Brittle, ductile with hardening, and under a law of plastic strain: 20 kJ/m^2 whatever the size.
// What a ductile point takes before it begins to fail is work that no crack takes: subtracted, as
// 1/2 (Y0 + Y1) eps L.
TEST(Damage, ACrackTakesItsEnergyWhateverTheSizeOfElements) {
  const Real energy = 20e3;
  const Material brittle = made_of(NoStrength{}, LinearEos{}, PrincipalStressDamage{1e9, energy});
  for (const Real length : {1e-3, 2e-3, 4e-3}) {
    EXPECT_NEAR(work_of_crack(brittle, length, 0), energy, 0.01 * energy) << length;
  }
  const Real yield = 500e6, hard = 1e9, fails = 0.1;
  const Material ductile =
      made_of(J2{yield, hardening(hard)}, LinearEos{}, StrainDamage{fails, energy});
  for (const Real length : {1e-4, 2e-4, 4e-4}) {
    const Real before = (yield + 0.5 * hard * fails) * fails * length;
    EXPECT_NEAR(work_of_crack(ductile, length, -0.5), before + energy, 0.02 * energy) << length;
  }
}

// Plastic heat is 0.9 of what the material that is left does, not of what an intact one would.
TEST(Damage, OnlyWhatCarriesHeats) {
  const Material soft = made_of(J2{500e6, {}}, LinearEos{}, StrainDamage{0.01, 5e3});
  OneTile points(soft.initial_state(kTile, 298, true));
  points.tile.adiabatic = true;
  std::fill(points.state.length.begin(), points.state.length.end(), 1e-3);
  Real work = 0, before = 0;
  for (int n = 0; n < 4000; ++n) {
    strain(points, soft, 1e-5, -0.5e-5, 1e-7);
    const Real now = std::sqrt(1.5) * 1.2247448713915890 * points.state.deviator[xx][3];
    work += 0.5 * (before + now) * 1e-5;
    before = now;
  }
  ASSERT_EQ(points.state.damage[3], 1.0);
  const Real elastic =
      500e6 * 500e6 / (6 * kSteelShear);  // it held that, and no plastic flow took it
  EXPECT_NEAR(points.state.heat[3], 0.9 * (work - elastic), 0.005 * work);
  EXPECT_NEAR(points.state.temperature[3], 298 + points.state.heat[3] / (kSteelDensity * 450),
              1e-9);
}

// The energy of an equation of state that has one is what the nominal stresses did.
TEST(Damage, EnergyIsTheWorkOfWhatIsLeft) {
  const Material metal =
      made_of(J2{500e6, {}}, MieGruneisen{4500, 1.5, 1.7}, MeanTensionDamage{2e9, 1e4});
  OneTile points(metal.initial_state(kTile, 298, true));
  std::fill(points.state.length.begin(), points.state.length.end(), 1e-3);
  Real work = 0, old[4] = {0, 0, 0, 1};
  for (int n = 0; n < 4000; ++n) {
    strain(points, metal, n < 3000 ? 1e-5 : -1e-5, 0, 1e-7);
    const Real now[4] = {points.state.deviator[xx][3], points.state.pressure[3],
                         n < 3000 ? 1e-5 : -1e-5, points.tile.ratio[3]};
    work += 0.5 * (old[3] * old[0] + now[3] * now[0]) * now[2] -
            0.5 * (old[1] + now[1]) * (now[3] - old[3]);
    std::copy_n(now, 4, old);
  }
  ASSERT_EQ(points.state.damage[3], 1.0);
  EXPECT_NEAR(points.state.energy[3], work, 1e-6 * std::fabs(work));
}

}  // namespace
}  // namespace brunt
