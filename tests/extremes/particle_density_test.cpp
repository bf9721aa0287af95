// docs/theory/sph.md (S6), (S10).
// No motion gives a particle a density at or below zero: V(n+1)/V(n) = 1/det(I - G), and
// |G| < 1 by Frobenius makes I - G invertible with a positive determinant, for (I - G) x = 0 would
// need |G x| = |x|. In the case of a rod that breaks a plate, debris of six neighbours almost in a
// plane had corrections B of 600, and a step turned it inside out.
#include <gtest/gtest.h>

#include "app/deck/deck.hpp"
#include "sph/correction.hpp"
#include "tests/support/simulate.hpp"
#include "tests/support/source_path.hpp"

namespace brunt::test {
namespace {

TEST(ParticleDensity, NoStepTurnsAVolumeInsideOut) {
  for (const Real size : {0.01, 0.4, 0.9, 1.1, 30.0, 1e6}) {
    for (int one = 0; one < 9; ++one) {
      Pack gradient[3][3];
      for (int k = 0; k < 9; ++k) {
        gradient[k / 3][k % 3] = broadcast<Pack>(size * (k == one ? 1.0 : 0.3 * ((k * 7) % 5 - 2)));
      }
      const auto mid = mid_step<3>(gradient);
      EXPECT_GT(mid.volume_ratio[0], 1.0 / 27) << size << " " << one;
      EXPECT_LT(mid.volume_ratio[0], 8) << size << " " << one;  // 1/(1 - 1/2)^3
    }
  }
}

// Affine motion below the limit stays exact: uniform growth by g in each direction, G = 1 - 1/g.
TEST(ParticleDensity, SmallMotionIsExact) {
  Pack gradient[2][2] = {{broadcast<Pack>(0.1), broadcast<Pack>(0.0)},
                         {broadcast<Pack>(0.0), broadcast<Pack>(0.2)}};
  EXPECT_NEAR(mid_step<2>(gradient).volume_ratio[0], 1 / (0.9 * 0.8), 1e-15);
}

TEST(ParticleDensity, LongRodBreaksAPlateOfParticles) {
  const std::string path = source_path("tests/cases/rod-sph-plate.yaml");
  const auto run = simulate(load_deck(path));
  EXPECT_EQ(run.failure, "");
  const auto& plate = run.bodies.at("plate");
  int found = 0;
  for (const auto& field : plate.point_fields) {
    if (field.name != "density") continue;
    ++found;
    for (const Real density : field.values) EXPECT_GT(density, 0);
  }
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace brunt::test
