/// Drucker & Prager against the formula as printed and against closed forms of its plastic flow:
/// uniaxial strain, triaxial compression, simple shear, the apex, energy.
#include "core/materials/drucker_prager.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

static_assert(PressureLaw<DruckerPrager> && !FlowLaw<DruckerPrager>);

constexpr Real kBulk = 10e9, kShear = 6e9, kDensity = 2000, kDegree = kPi / 180;

DruckerPrager rock(Real dilation = 10, Real cohesion = 1e6) {
  DruckerPrager law;
  law.cohesion = cohesion;
  law.friction_angle = 30 * kDegree, law.dilation_angle = dilation * kDegree;
  law.prepare();
  return law;
}

Material made_of(const DruckerPrager& law, const EosLaw& eos = LinearEos{}) {
  Material made;
  made.density = kDensity, made.shear = kShear, made.bulk = kBulk;
  made.thermal = true, made.specific_heat = SpecificHeat(800);
  made.strength = make_strength(law, {kShear, kDensity * 800, 1});
  made.eos = make_eos(eos, EosInputs{kDensity, kBulk});
  return made;
}

Real at(const DruckerPrager& law, Real p) {
  return law.flow_stress(PressureState<Real>{{0, 0, 300}, p, 1});
}

/// All points of a tile at once, with a volume that follows the strain exactly.
struct Path {
  Material material;
  OneTile points;
  Real ratio = 1, time = 0;

  explicit Path(Material made)
      : material(std::move(made)), points(material.initial_state(kTile, 300, true)) {
    points.tile.adiabatic = true;
  }
  /// Strains by exx, eyy, ezz and exy, the volume by the exponential of their sum.
  void step(Real exx, Real eyy, Real ezz, Real exy = 0, Real dt = 1e-6) {
    const Real next = ratio * std::exp(exx + eyy + ezz);
    for (std::size_t i = 0; i < kTile; ++i) {
      auto& strain = points.tile.strain;
      strain[xx][i] = exx, strain[yy][i] = eyy, strain[zz][i] = ezz, strain[xy][i] = exy;
      points.tile.ratio_old[i] = ratio, points.tile.ratio[i] = next;
    }
    material.update(points.at_first(), dt);
    ratio = next;
  }
  Real stress(std::size_t c) const {
    return points.state.deviator[c][5] - (c < 3 ? points.state.pressure[5] : 0);
  }
  Real p() const { return points.state.pressure[5]; }
  Real q() const { return equivalent_stress(points.state, 5); }
  Real plastic_volume() const { return points.state.plastic_volume[5]; }
  Real opening() const { return points.state.opening[5]; }
};

TEST(DruckerPrager, IsThePrintedFormula) {
  // Compression: with sigma_1 = sigma_3 N + 2 c sqrt(N), N = tan^2(45 + phi/2), of Mohr and Coulomb
  for (const Real phi : {5.0, 30.0, 50.0}) {
    DruckerPrager law = rock(0);
    law.friction_angle = phi * kDegree;
    law.prepare();
    const Real N = std::pow(std::tan((45 + phi / 2) * kDegree), 2);
    for (const Real side : {0.0, 1e6, 30e6}) {
      const Real axial = side * N + 2 * law.cohesion * std::sqrt(N);
      EXPECT_NEAR(at(law, (axial + 2 * side) / 3) / (axial - side), 1, 1e-12);
    }
    law.fit = DruckerPrager::Fit::extension;
    law.prepare();  // two of the stresses are the large one
    const Real axial = 30e6 * N + 2 * law.cohesion * std::sqrt(N);
    EXPECT_NEAR(at(law, (2 * axial + 30e6) / 3) / (axial - 30e6), 1, 1e-12);
    law.fit = DruckerPrager::Fit::plane_strain;
    law.prepare();  // Drucker & Prager 1952, eq. 16: alpha I1 + sqrt(J2) = k
    const Real t = std::tan(phi * kDegree), root = std::sqrt(9 + 12 * t * t);
    const Real k = 3 * law.cohesion / root, alpha = t / root;
    EXPECT_NEAR(at(law, 7e6) / (std::sqrt(3.0) * (k + alpha * 21e6)), 1, 1e-12);
  }
  EXPECT_EQ(at(rock(), -1e9), 0);
  DruckerPrager clay = rock(0);
  clay.friction_angle = 0;
  clay.prepare();  // Tresca's 2 c, whatever the pressure, and no limit of tension
  EXPECT_DOUBLE_EQ(at(clay, -1e9), 2e6);
  EXPECT_EQ(clay.tension_limit(), kInfinity);
  // c cot(phi), the apex of the pyramid
  EXPECT_NEAR(rock().tension_limit() / (1e6 / std::tan(30 * kDegree)), 1, 1e-12);
}

// After yield dq = 2 G de - 3 G dl, dp = K (de + D dl) and dq = B dp, all constant:
// dl/de = (2 G - B K)/(3 G + B K D). Strains are 1e-4, and so is what finite strain adds to them.
TEST(DruckerPrager, UniaxialStrainFollowsTheClosedForm) {
  for (const Real psi : {0.0, 10.0, 30.0}) {
    DruckerPrager law = rock(psi, 1e4);
    law.friction_angle = 20 * kDegree, law.dilation_angle = std::min(psi, 20.0) * kDegree;
    law.prepare();
    const Real A = at(law, 0), B = (at(law, 1e6) - A) / 1e6, D = law.dilation();
    Path path(made_of(law));
    const Real end = 1e-4;
    for (int i = 0; i < 100; ++i) path.step(-end / 100, 0, 0);
    const Real yield = A / (2 * kShear - B * kBulk);
    ASSERT_LT(yield, 0.5 * end);
    const Real flow = (2 * kShear - B * kBulk) / (3 * kShear + B * kBulk * D) * (end - yield);
    EXPECT_NEAR(path.points.state.eps_p[5] / flow, 1, 1e-3) << psi;
    EXPECT_NEAR(path.p() / (kBulk * (end + D * flow)), 1, 1e-3) << psi;
    EXPECT_NEAR(path.q() / (A + B * path.p()), 1, 1e-9) << psi;
    EXPECT_NEAR((path.plastic_volume() - 1) / flow, D, 1e-3) << psi;
  }
}

/// Pushes along x while y and z are held at a stress, until nothing changes.
void push(Path& path, Real side, int steps) {
  for (int i = 0; i < steps; ++i) {
    const Real back = (path.stress(yy) + side) / (2 * (kBulk + kShear / 3));
    path.step(-1e-7, -back, -back);
  }
}

// sigma_1 = sigma_3 N + 2 c sqrt(N) of Mohr and Coulomb, which the cone touches in compression, and
// the loosening 2 sin(psi)/(1 - sin(psi)) per axial strain, to what a step adds to the sides: 1e-7
// of the modulus is 1e-3 of the strength.
TEST(DruckerPrager, TriaxialStrengthAndDilationAreThoseOfMohrAndCoulomb) {
  for (const Real psi : {0.0, 10.0, 30.0}) {
    for (const Real side : {0.0, 1e6, 5e6, 20e6}) {
      Path path(made_of(rock(psi)));
      for (int i = 0; i < 1000; ++i)
        path.step(-side / 3e3 / kBulk, -side / 3e3 / kBulk, -side / 3e3 / kBulk);
      push(path, side, 60'000);
      EXPECT_NEAR(-path.stress(yy), side, 1e-6 * kBulk);
      const Real N = 3, strength = -path.stress(yy) * N + 2e6 * std::sqrt(N);
      EXPECT_NEAR(-path.stress(xx) / strength, 1, 1e-9) << side << " " << psi;
      const Real volume = path.ratio;
      push(path, side, 10'000);
      const Real loosening = std::log(path.ratio / volume) / 1e-3;
      const Real s = std::sin(psi * kDegree);
      EXPECT_NEAR(loosening, 2 * s / (1 - s), 2e-3) << side << " " << psi;
    }
  }
}

// Simple shear by dg at a held volume: d = dg/sqrt(3), and all its dilation becomes pressure.
TEST(DruckerPrager, ShearInAHeldVolumeRaisesThePressure) {
  Path path(made_of(rock(10)));
  path.step(-1e-3, -1e-3, -1e-3);
  const Real before = path.p();
  for (int i = 0; i < 6000; ++i) path.step(0, 0, 0, 1e-6);
  const Material& made = path.material;
  const Real d = path.points.state.eps_p[5], D = rock(10).dilation();
  EXPECT_GT(path.p(), 1.1 * before);
  // p = K (J_p/J - 1), J_p the product of 1 + D d_i: e^(D d) to 1e-6
  EXPECT_NEAR(path.p() / (kBulk * (std::exp(D * d) / path.ratio - 1)), 1, 1e-4);
  // q rises by 3 G dg/sqrt(3) - 3 G d: what flows is the shear that is not elastic
  EXPECT_NEAR((2 * 6000e-6 / std::sqrt(3.0) - path.q() / (3 * made.shear)) / d, 1, 1e-3);
}

TEST(DruckerPrager, OpensAtTheApexAndClosesAgain) {
  for (const Real cohesion : {0.0, 1e6}) {
    Path path(made_of(rock(10, cohesion)));
    const Real apex = cohesion / std::tan(30 * kDegree);
    path.step(1e-4, 0, 0);  // with shear, of which nothing remains at the apex
    for (int i = 0; i < 100; ++i) path.step(1e-3, 1e-3, 1e-3);
    EXPECT_NEAR(path.p(), -apex, 1e-9 * kBulk);
    EXPECT_NEAR(path.q(), 0, 1e-9 * kBulk);
    const Real dilated = path.plastic_volume(), opened = path.opening();
    EXPECT_NEAR(opened * dilated * (1 / (1 - apex / kBulk)) / path.ratio, 1, 1e-12);
    EXPECT_NEAR(path.points.state.heat[5], apex * 0.3, 0.1 * apex);  // tension times opening
    for (int i = 0; i < 99; ++i) path.step(-1e-3, -1e-3, -1e-3);
    EXPECT_NEAR(path.p(), 0, 1e-9 * kBulk);  // what is open does not resist
    EXPECT_GT(path.opening(), 1);
    EXPECT_EQ(path.plastic_volume(), dilated);
    path.step(-2e-3, -2e-3, -2e-3);
    EXPECT_EQ(path.opening(), 1);
    EXPECT_NEAR(path.p() / (kBulk * (dilated / path.ratio - 1)), 1, 1e-9);
  }
}

TEST(DruckerPrager, ATensileCutoffBelowTheApexOpensTooAndLeavesShearStrength) {
  DruckerPrager law = rock(0);
  Material made = made_of(law);
  made.tensile_cutoff = 0.2e6;
  StrengthInputs inputs{kShear, kDensity * 800, 1};
  inputs.tensile_cutoff = made.tensile_cutoff;
  made.strength = make_strength(law, inputs);
  Path path(std::move(made));
  for (int i = 0; i < 100; ++i) path.step(1e-5, 1e-5, 1e-5, 1e-4);
  EXPECT_NEAR(path.p(), -0.2e6, 1e-9 * kBulk);
  EXPECT_NEAR(path.q() / at(law, -0.2e6), 1, 1e-9);
}

/// A path that shears, squeezes and pulls, of steps up to a strain; each step is handed over.
template <class Visit>
void wander(Path& path, Real strain, int steps, int seed, Visit&& visit) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::uniform_real_distribution<Real> digit(-1, 1);
  for (int i = 0; i < steps; ++i) {
    const Real size = strain * std::pow(10, -3 * std::abs(digit(random)));
    Real e[4];
    for (Real& one : e) one = size * digit(random);
    if (std::abs(std::log(path.ratio) + e[0] + e[1] + e[2]) > 0.2) {
      for (int c = 0; c < 3; ++c) e[c] = -e[c];
    }
    visit(e);
  }
}

// The yield surface of the new state: with the linear equation of state the pressure of the return
// is that of the new volume to rounding, which is 1e-16 of the modulus; the solver leaves 1e-10 of
// the increment of plastic strain, 3 G of which is at most the stress that the step adds.
TEST(DruckerPrager, StaysOnOrBelowItsConeWhateverTheStep) {
  for (const Real strain : {1e-5, 1e-3, 0.3}) {
    for (const Real psi : {0.0, 10.0, 30.0}) {
      for (const Real cohesion : {0.0, 1e6}) {
        const DruckerPrager law = rock(psi, cohesion);
        Path path(made_of(law));
        Real heat = 0, volume = 1;
        wander(path, strain, 400, 3, [&](const Real(&e)[4]) {
          path.step(e[0], e[1], e[2], e[3]);
          const auto& state = path.points.state;
          const Real flow = at(law, path.p());
          const Real added =
              3 * kShear * (std::abs(e[0]) + std::abs(e[1]) + std::abs(e[2]) + 2 * std::abs(e[3]));
          EXPECT_LE(path.q(), flow + 1e-9 * (flow + added) + 1e-14 * kBulk);
          EXPECT_GE(path.p(), -law.tension_limit() - 1e-14 * kBulk);
          // Plastic work makes no energy; where flow is associated and nothing coheres it is 0.
          EXPECT_GE(state.heat[5], heat - 1e-9 * added * added / kShear);
          EXPECT_GE(state.plastic_volume[5], volume);
          EXPECT_GE(state.opening[5], 1);
          EXPECT_TRUE(std::isfinite(path.q() + path.p() + state.temperature[5]));
          heat = state.heat[5], volume = state.plastic_volume[5];
        });
        EXPECT_EQ(path.points.state.eps_p[5] > 0, strain > 1e-4 || cohesion == 0);
      }
    }
  }
}

// E takes what stresses do on strains: -p on all of the volume, whatever part of it is plastic.
// The trapezoidal mean of both ends is how it is booked, so that nothing but rounding is left.
TEST(DruckerPrager, InternalEnergyIsTheWorkOfAllStresses) {
  Path path(made_of(rock(10), MieGruneisen{2300, 1.5, 1.2}));
  const auto& state = path.points.state;
  Real work = 0, largest = 0;
  wander(path, 1e-3, 1000, 5, [&](const Real(&e)[4]) {
    Real before[4] = {}, old_ratio = path.ratio;
    const Real p = path.p();
    for (std::size_t c : {xx, yy, zz, xy}) before[c] = state.deviator[c][5];
    path.step(e[0], e[1], e[2], e[3]);
    for (std::size_t c : {xx, yy, zz, xy}) {
      const Real both = old_ratio * before[c] + path.ratio * state.deviator[c][5];
      work += (c < 3 ? 0.5 : 1.0) * both * e[c];
    }
    work -= 0.5 * (p + path.p()) * (path.ratio - old_ratio);
    largest = std::max(largest, std::abs(work));
  });
  EXPECT_GT(state.plastic_volume[5], 1.0001);
  EXPECT_NEAR(state.energy[5], work, 1e-4 * largest);
}

TEST(DruckerPrager, FourPointsAtOnceHaveTheBitsOfOne) {
  const DruckerPrager law = rock();
  const StrengthInputs inputs{kShear, kDensity * 800, 0.9};
  const PressureReturn<DruckerPrager, Pack> wide(law, inputs);
  const PressureReturn<DruckerPrager, Real> narrow(law, inputs);
  std::mt19937_64 random(9);
  std::uniform_real_distribution<Real> digit(-1, 1);
  OneTile a(made_of(law).initial_state(kTile, 300, true));
  for (std::size_t i = 0; i < kTile; ++i) {
    for (auto& component : a.tile.strain) component[i] = 1e-3 * digit(random);
    a.state.pressure[i] = 5e6 * digit(random), a.state.opening[i] = i % 3 == 0 ? 1.001 : 1;
  }
  OneTile b = a;
  wide.update(a.at_first(), 1e-6);
  narrow.update(b.at_first(), 1e-6);
  for (std::size_t i = 0; i < kTile; ++i) {
    for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(a.state.deviator[c][i], b.state.deviator[c][i]);
    EXPECT_EQ(a.state.pressure[i], b.state.pressure[i]);
    EXPECT_EQ(a.state.plastic_volume[i], b.state.plastic_volume[i]);
    EXPECT_EQ(a.state.opening[i], b.state.opening[i]);
    EXPECT_EQ(a.state.heat[i], b.state.heat[i]);
  }
}

}  // namespace
}  // namespace brunt
