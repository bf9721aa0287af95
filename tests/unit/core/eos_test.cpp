/// Equations of state.
/// Linear: p = K (V0/V - 1), K_t = K V0/V.
/// Mie-Grueneisen: the jump conditions of a shock into matter at rest, with u_p the particle speed:
///   U_s = c0 + s u_p,  V/V0 = 1 - u_p/U_s,  p = rho0 U_s u_p,  E = 1/2 rho0 u_p^2 per volume V0.
/// One update from V0 to V takes the energy by the mean of old (0) and new pressure, which is the
/// Rankine-Hugoniot relation, so that the state must come out to round-off.
/// Symmetric plates at 1000 m/s (u_p = 500 m/s):
///   Cu 8930, 3940, 1.489: U_s = 4684.5 m/s, p = 20.92 GPa, rho = 9997 kg/m^3
///   Al 2703, 5240, 1.40:  U_s = 5940 m/s,   p = 8.03 GPa,  rho = 2951 kg/m^3
#include <gtest/gtest.h>

#include "core/materials/eos_linear.hpp"
#include "core/materials/mie_gruneisen.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

constexpr Real kNoWork[kTile] = {};

/// Takes point 0 (and all others) to V/V0 = ratio.
void compress(const EquationOfState& eos, OneTile& points, Real ratio) {
  std::fill_n(points.tile.ratio, kTile, ratio);
  eos.update(points.at_first(), kNoWork);
  std::fill_n(points.tile.ratio_old, kTile, ratio);
}

TEST(LinearEos, IsThePrintedFormula) {
  const LinearEquation eos(140e9);
  OneTile points(full_state(298));
  compress(eos, points, 0.8);
  EXPECT_DOUBLE_EQ(points.state.pressure[0], 140e9 * 0.25);
  EXPECT_DOUBLE_EQ(points.state.bulk[0], 140e9 * 1.25);
  compress(eos, points, 1.25);
  EXPECT_DOUBLE_EQ(points.state.pressure[31], -140e9 * 0.2);
  EXPECT_FALSE(eos.needs_energy());
}

struct Shock {
  MieGruneisen law;
  Real density, speed, pressure, compressed;  // [kg/m^3], U_s [m/s], [Pa], [kg/m^3]
};
const Shock kCopper{{3940, 1.489, 1.96}, 8930, 4684.5, 20.92e9, 9997};
const Shock kAluminium{{5240, 1.40, 1.97}, 2703, 5940, 8.03e9, 2951};

TEST(MieGruneisen, ReachesTheHugoniotState) {
  for (const Shock& shock : {kCopper, kAluminium}) {
    const MieGruneisenEquation eos(shock.law, shock.density);
    constexpr Real u = 500;
    const Real speed = shock.law.c0 + shock.law.s * u, ratio = 1 - u / speed;
    EXPECT_NEAR(speed, shock.speed, 0.05);
    OneTile points(full_state(298));
    compress(eos, points, ratio);
    const Real p = points.state.pressure[0], e = points.state.energy[0];
    EXPECT_NEAR(p / (shock.density * speed * u), 1, 1e-14);
    EXPECT_NEAR(e / (0.5 * shock.density * u * u), 1, 1e-13);  // of p * eta: one cancellation in V
    EXPECT_NEAR(p, shock.pressure, 0.005e9);                   // the digits of the source
    EXPECT_NEAR(shock.density / ratio, shock.compressed, 0.5);
  }
}

// The tangent is dp/d(ln rho) along an isentrope; two small steps to both sides give it to h^2.
TEST(MieGruneisen, TangentIsThatOfTheIsentrope) {
  const MieGruneisenEquation eos(kCopper.law, kCopper.density);
  for (const Real ratio : {0.75, 0.9, 0.999}) {
    constexpr Real h = 1e-5;
    OneTile shocked(full_state(298));
    compress(eos, shocked, ratio);
    OneTile up = shocked, down = shocked;
    compress(eos, up, ratio * (1 - h));
    compress(eos, down, ratio * (1 + h));
    const Real slope = (up.state.pressure[0] - down.state.pressure[0]) / (2 * h);
    EXPECT_NEAR(shocked.state.bulk[0] / slope, 1, 1e-6);
  }
  EXPECT_DOUBLE_EQ(eos.bulk_modulus(), 8930.0 * 3940 * 3940);
}

TEST(MieGruneisen, IsSmoothThroughTheReferenceStateAndElasticInTension) {
  const MieGruneisenEquation eos(kCopper.law, kCopper.density);
  const Real K = eos.bulk_modulus();
  OneTile points(full_state(298));
  compress(eos, points, 1.0);
  EXPECT_EQ(points.state.pressure[0], 0.0);
  EXPECT_DOUBLE_EQ(points.state.bulk[0], K);
  compress(eos, points, 1.01);
  const Real e = points.state.energy[0];
  EXPECT_NEAR(points.state.pressure[0], K * (1 / 1.01 - 1) + 1.96 * e, 1e-12 * K);
  EXPECT_NEAR(e / (-0.5 * points.state.pressure[0] * 0.01), 1, 1e-13);
  EXPECT_NEAR(points.state.bulk[0] / (K / 1.01), 1, 1e-14);
}

TEST(MieGruneisen, WorkFromElsewhereHeats) {
  const MieGruneisenEquation eos(kCopper.law, kCopper.density);
  OneTile points(full_state(298));
  std::fill_n(points.tile.viscous_work, kTile, 2e8);
  const std::vector<Real> work(kTile, 1e8);
  eos.update(points.at_first(), work.data());
  EXPECT_DOUBLE_EQ(points.state.energy[0], 3e8);
  EXPECT_DOUBLE_EQ(points.state.pressure[0], 1.96 * 3e8);
}

// An isentropic cycle by small steps gives back its energy; the trapezoidal work leaves h^2.
TEST(MieGruneisen, ReleaseGivesBackTheWork) {
  const MieGruneisenEquation eos(kCopper.law, kCopper.density);
  OneTile points(full_state(298));
  constexpr int steps = 200;
  for (int i = 1; i <= steps; ++i) compress(eos, points, 1 - 0.1 * i / steps);
  const Real stored = points.state.energy[0];
  for (int i = steps - 1; i >= 0; --i) compress(eos, points, 1 - 0.1 * i / steps);
  EXPECT_GT(stored, 5e8);
  EXPECT_NEAR(points.state.energy[0] / stored, 0, 1e-12);  // the path back is the path there
  EXPECT_NEAR(points.state.pressure[0] / eos.bulk_modulus(), 0, 1e-13);
}

TEST(MieGruneisen, IsHeldWhereTheHugoniotEnds) {
  const MieGruneisenEquation eos(kCopper.law, kCopper.density);
  EXPECT_NEAR(1 - eos.densest_ratio(), 0.95 / 1.489, 1e-15);
  for (const Real ratio : {0.33, 0.1, 1e-9, -0.5}) {
    OneTile points(full_state(298));
    compress(eos, points, ratio);
    EXPECT_EQ(eos.cold_pressure(ratio).pressure, eos.cold_pressure(eos.densest_ratio()).pressure);
    EXPECT_TRUE(std::isfinite(points.state.pressure[0])) << ratio;
    EXPECT_GT(points.state.bulk[0], 0) << ratio;
  }
}

}  // namespace
}  // namespace brunt
