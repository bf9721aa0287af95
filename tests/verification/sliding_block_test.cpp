// Coulomb's block on a level and on inclines, turned so
// that the surface is level and the weight leans: it slips if and only if tan(a) > mu, 16.70 deg of
// mu = 0.3; slides with g (sin a - mu cos a); stops after v^2/(2 mu g); and all that it loses is
// heat. Elements and particles, in the plane and in space, on one rigid face and on a plate of
// elements as soft as the block, which its faces cross at other places than their edges.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kGravity = 9.81, kMu = 0.3, kSpeed = 1, kDensity = 1000;
constexpr Real kStep = 1e-4;  // [s] shorter than any bound

const char* const kDeck = R"(
title: a block slides on a plate
parameters: {angle: 0 deg, speed: 1 m/s, g: 9.81 m/s^2, end: 0.5 s}
time: {end: $end, max_step: 0.1 ms}
heat: conduct
ambient: 300 K
materials:
  rubber:
    density: 1000 kg/m^3
    elastic: {E: 10 MPa, nu: 0.3}
    thermal: {cp: 1500 J/kg/K, k: 0.2 W/m/K}
contact: {default: {friction: 0.3}}
output: {history: 1 ms}
)";
const char* const kInPlane = R"(
geometry: plane-strain
gravity: [= $g * sin($angle), = -$g * cos($angle)]
bodies:
  block:
    material: rubber
    shape: {box: {min: [-50 mm, 0], max: [50 mm, 40 mm]}}
    size: 20 mm
    velocity: [$speed, 0]
)";
const char* const kInSpace = R"(
geometry: 3d
gravity: [= $g * sin($angle), 0, = -$g * cos($angle)]
bodies:
  block:
    material: rubber
    shape: {box: {min: [-50 mm, -50 mm, 0], max: [50 mm, 50 mm, 40 mm]}}
    size: 20 mm
    velocity: [$speed, 0, 0]
)";
const char* const kFaces[2] = {R"(
  plate: {rigid: true, shape: {plane: {origin: [0, 0], normal: y, extent: 2 m}}}
)",
                               R"(
  plate: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 2 m}}}
)"};
const char* const kPlates[2] = {R"(
  plate:
    material: rubber
    shape: {box: {min: [-70 mm, -20 mm], max: [500 mm, 0]}}
    size: [30 mm, 20 mm]
boundaries: {floor: {body: plate, where: {side: min-y}, fix: [x, y]}}
)",
                                R"(
  plate:
    material: rubber
    shape: {box: {min: [-70 mm, -70 mm, -20 mm], max: [500 mm, 70 mm, 0]}}
    size: [30 mm, 30 mm, 20 mm]
boundaries: {floor: {body: plate, where: {side: min-z}, fix: [x, y, z]}}
)"};

/// A run in 2 or 3 dimensions, on a rigid face or on a plate of elements.
struct Slide {
  int dim;
  bool meshed;
  Real degrees;
  Simulation run;

  Slide(int d, bool elements, Real angle, std::vector<std::string> overrides)
      : dim(d), meshed(elements), degrees(angle) {
    overrides.push_back("parameters.angle=" + std::to_string(angle) + " deg");
    const int k = d - 2;
    const std::string plate = elements ? kPlates[k] : kFaces[k];
    run = simulate_text(kDeck + std::string(d == 2 ? kInPlane : kInSpace) + plate, overrides);
  }
  Real angle() const { return degrees * kPi / 180; }
  Real mass() const { return kDensity * 0.1 * 0.04 * (dim == 2 ? 1 : 0.1); }  // [kg]
  /// Of a body's centre since time 0 [m].
  Real way(const std::string& body, const char* axis) const {
    const std::string column = "body." + body + ".position." + axis;
    return run.last(column) - run.first(column);
  }
  Real along() const { return way("block", "x"); }
  /// What the weight did [J]. No force acts at time 0 itself, so that in the first step, in which
  /// the block moves by v dt, it did half of it.
  Real work_of_weight() const {
    const char* up = dim == 2 ? "y" : "z";
    const Real s = std::sin(angle()), c = std::cos(angle());
    Real work = mass() * (s * (along() - 0.5 * kSpeed * kStep) - c * way("block", up));
    if (meshed)
      work += run.last("body.plate.mass") * (s * way("plate", "x") - c * way("plate", up));
    return kGravity * work;
  }
};

std::string name_of(int dim, bool meshed) {
  return std::to_string(dim) + "D on " + (meshed ? "elements" : "a rigid face");
}

// Heat that the bodies keep against what is lost of motion and weight, less what their elements and
// springs hold and damp by their own books: the book of friction takes no part. Rounding of a few
// thousand steps; the page's 1e-10.
void expect_heat(const Slide& slide) {
  const auto& run = slide.run;
  const Real start = 0.5 * slide.mass() * kSpeed * kSpeed, weight = slide.work_of_weight();
  Real left = start - run.last("energy.kinetic") + weight;
  for (const char* store : {"internal", "hourglass", "viscosity", "artificial_stress",
                            "contact.spring", "contact.damping", "contact.pairs", "integration"}) {
    left -= run.last(std::string("energy.") + store);
  }
  EXPECT_NEAR(run.last("heat.stored"), left, 1e-10 * (start + std::fabs(weight)));
  EXPECT_NEAR(run.last("body.block.heat") + run.last("body.plate.heat"), left,
              1e-10 * (start + std::fabs(weight)));
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-3 * run.largest_energy());
}

// The way to rest is v^2/(2 mu g) but for the first half step, dt/2 v, 3e-4 of it, and what the
// block sinks on its springs and leans on them at the end, 10 um, 1e-4: the page's 0.1 %. Heat is
// mu m g s, of which 7e-4 go to dampers and viscosity (3e-3 with assumed-strain control, which
// rings higher).
TEST(SlidingBlock, StopsAndHeatsByWhatItLost) {
  for (const int dim : {2, 3}) {
    for (const bool meshed : {false, true}) {
      SCOPED_TRACE(name_of(dim, meshed));
      const Slide slide(
          dim, meshed, 0,
          {"contact.default.damping=0.5", "bodies.block.element.hourglass={stiffness: 0.05}"});
      ASSERT_EQ(slide.run.failure, "");
      const Real stop = kSpeed * kSpeed / (2 * kMu * kGravity);
      EXPECT_NEAR(slide.along(), stop, 1e-3 * stop);
      EXPECT_LT(std::fabs(slide.run.last("body.block.velocity.x")), 1e-3 * kSpeed);
      expect_heat(slide);
      const Real heat = kMu * slide.mass() * kGravity * slide.along();
      EXPECT_NEAR(slide.run.last("heat.stored"), heat, 1e-3 * heat);
    }
  }
}

// 1 m/s keeps it sliding while its weight comes on to its springs; the first half step is dt/t of
// the acceleration, 3e-4.
TEST(SlidingBlock, SlidesAsCoulombSays) {
  for (const int dim : {2, 3}) {
    for (const bool meshed : {false, true}) {
      for (const Real degrees : {20.0, 30.0}) {
        SCOPED_TRACE(name_of(dim, meshed));
        const Slide slide(dim, meshed, degrees, {"parameters.end=0.3 s"});
        ASSERT_EQ(slide.run.failure, "");
        const Real t = 0.3, a = slide.angle();
        const Real wanted = kGravity * (std::sin(a) - kMu * std::cos(a));
        EXPECT_NEAR(2 * (slide.along() - kSpeed * t) / (t * t), wanted, 1e-3 * wanted) << degrees;
        expect_heat(slide);
      }
    }
  }
}

// From rest, damped until 0.2 s, and looked at from 0.22 s on, the row of that number. At 16.6 deg
// it then stays to rounding. At 16.8 deg it slides: mu g cos a is 157 times the difference that
// moves it, and faces that lean take or add 4e-5 of that on springs as stiff as elements, 0.6 %. On
// its layer, d = 2.5 rho g H^2/M deep, friction shifts the pressure by e = mu H/2, so that the face
// leans by 12 e d/w^2 = 2e-5 and the common plane by half of it: 0.5 % more. In all 1.3 %.
TEST(SlidingBlock, SlipsIfAndOnlyIfItsInclineIsSteeper) {
  for (const int dim : {2, 3}) {
    for (const bool meshed : {false, true}) {
      for (const char* method : {"fe", "sph"}) {
        SCOPED_TRACE(name_of(dim, meshed) + ", " + method);
        const auto run = [&](Real degrees) {
          return Slide(dim, meshed, degrees,
                       {std::string("bodies.block.method=") + method, "parameters.speed=0 m/s",
                        "parameters.end=0.4 s", "damping={rate: 200 1/s, until: 0.2 s}",
                        "contact.default.damping=0.5"});
        };
        const auto held = run(16.6), slipping = run(16.8);
        ASSERT_EQ(held.run.failure + slipping.run.failure, "");
        const auto x = held.run.column("body.block.position.x");
        EXPECT_NEAR(x.back(), x[220], 1e-10);
        EXPECT_LT(held.run.last("energy.kinetic"), 1e-18);
        const auto v = slipping.run.column("body.block.velocity.x"),
                   time = slipping.run.column("time");
        const Real a = slipping.angle(), wanted = kGravity * (std::sin(a) - kMu * std::cos(a));
        const Real taken = (v.back() - v[220]) / (time.back() - time[220]);
        EXPECT_NEAR(taken, wanted, 1.3e-2 * wanted);
      }
    }
  }
}

}  // namespace
}  // namespace brunt::test
