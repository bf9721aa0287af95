// Central differences of a bar of hexes (h = 1, c = 1000, rho = 1000) whose
// end rests on a rigid face by a spring of phi M/h are stable up to 0.998, 0.972, 0.910, 0.786,
// 0.625 h/c at phi = 0.1, 0.5, 1, 2, 4 (law_test derives them). Here the contact manager itself is
// at the end: 1e5 steps at 0.98 of the limit keep a small disturbance small; at 1.02 it grows as
// (1.08 + sqrt(1.08^2 - 1))^n = 1.49^n until the contact opens.
#include <gtest/gtest.h>

#include "contact/law/springs.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

constexpr int kLayers = 12;
constexpr Real kModulus = 1e9, kDensity = 1000, kSide = 1;  // h/c = 1 ms

/// Layers of four points, joined by the springs of a bar with nu = 0, pressed on a rigid floor.
struct Bar {
  ContactScene<3> scene;
  Real penetration;  // [m] at rest

  Bar(Real phi, Real pressure) : penetration(pressure * kSide / (phi * kModulus)) {
    scene.options.fallback.stiffness = phi;
    scene.options.fallback.damping = 0;
    const auto square = [](Real z, Real s) {
      return std::vector<Vec3>{{-s, -s, z}, {s, -s, z}, {s, s, z}, {-s, s, z}};
    };
    scene.add_face(scene.add_group(), square(0, 4 * kSide), 0, 0, 0);
    auto& bar = scene.add_group();
    const Real strain = pressure / kModulus, mass = kDensity * kSide * kSide * kSide / 4;
    for (int k = 0; k < kLayers; ++k) {
      auto corners = square(-penetration + kSide * k * (1 - strain), 0.5 * kSide);
      if (k == 0) {
        std::reverse(corners.begin(), corners.end());  // looks down
        scene.add_face(bar, corners, kModulus / kSide, kSide, mass / 2);
        continue;
      }
      std::reverse(corners.begin(), corners.end());
      for (const auto& x : corners) scene.add_point(bar, x, k + 1 < kLayers ? mass : mass / 2);
    }
    push_ = pressure * kSide * kSide / 4;
    scene.start();
  }

  void step(Real dt) {
    scene.step(dt, [this] {
      auto& p = scene.groups[1].points;
      const Real stiffness = kModulus * kSide / 4;  // [N/m] of a quarter of an element
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        if (i + 4 >= p.x.size()) {
          p.f[i][2] -= push_;
          continue;
        }
        const Real pull = stiffness * (p.x[i + 4][2] - p.x[i][2] - kSide);
        p.f[i][2] += pull;
        p.f[i + 4][2] -= pull;
      }
    });
  }

  /// How far the end is from its place at rest, over the penetration there.
  Real disturbance() const {
    return std::fabs(scene.groups[1].points.x[0][2] + penetration) / penetration;
  }

 private:
  Real push_;
};

/// Largest disturbance over the steps, or the first one beyond one half.
Real largest_disturbance(Real phi, Real factor, int steps) {
  Bar bar(phi, 1e6);
  for (std::size_t i = 0; i < 4; ++i) {
    bar.scene.groups[1].points.v[i][2] = 1e-3 * bar.penetration / 1e-3;
  }
  const Real dt = factor * surface_step_ratio(phi, 0) * 1e-3;
  Real largest = 0;
  for (int n = 0; n < steps && largest < 0.5; ++n) {
    bar.step(dt);
    largest = std::max(largest, bar.disturbance());
  }
  return largest;
}

TEST(ContactStability, HoldsBelowTheLimitAndDivergesAboveIt) {
  for (const Real phi : {0.1, 0.5, 1.0, 2.0, 4.0}) {
    EXPECT_LT(largest_disturbance(phi, 0.98, 100000), 0.05) << phi;
    EXPECT_GE(largest_disturbance(phi, 1.02, 2000), 0.5) << phi;
  }
}

// Particles look some steps ahead for what is near, and allow no longer one. A step is `safety`
// of its step limit: however small that is, the next may be twice as long.
TEST(Stability, StepsMayGrowWhateverTheSafety) {
  for (const Real safety : {0.9, 0.5, 0.24, 0.01}) {
    ContactScene<3> scene;
    scene.options.safety = safety;
    scene.add_face(scene.add_group(), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0, 0, 0);
    scene.add_particle(scene.add_group(), {0.5, 0.5, 0.6}, 0.5, kModulus, 1);
    auto& contact = scene.start();
    constexpr Real kTiny = 1e-9;  // [s] of 1e-4 s, what its spring would allow
    contact.add_forces(kTiny);
    EXPECT_GE(safety * contact.stable_step().step, 2 * kTiny * (1 - 1e-15)) << safety;
    EXPECT_LE(safety * contact.stable_step().step, 4 * kTiny) << safety;
  }
}

}  // namespace
}  // namespace brunt
