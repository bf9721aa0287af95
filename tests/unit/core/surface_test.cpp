// What particles are made of stands once for each kind, wherever it comes in the row of particles.
#include "core/surface.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace brunt {
namespace {

TEST(Surface, ParticlesOfTheSameMatterShareIt) {
  const std::vector<ParticleMatter> kinds{{2e11, 0, 0}, {1e9, 40, 3e4}, {1e9, 0, 0}};
  Surface<3> surface;
  for (LocalIndex i = 0; i < 100; ++i) {
    surface.add_particle(i, 0.5 + i, kinds[slot_of(i * i % 3)], i % 7 == 0);
  }
  ASSERT_EQ(surface.particles.size(), 100U);
  EXPECT_EQ(surface.matters.size(), 2U);  // squares leave 0 or 1
  for (LocalIndex i = 0; i < 100; ++i) {
    const SurfaceParticle& one = surface.particles[slot_of(i)];
    EXPECT_EQ(one.point, i);
    EXPECT_EQ(one.radius, 0.5 + i);
    EXPECT_EQ(one.born, i % 7 == 0);
    EXPECT_EQ(surface.matters[one.matter], kinds[slot_of(i * i % 3)]);
  }
  EXPECT_EQ(surface.place_of(kinds[2]), 2U);
  EXPECT_EQ(surface.place_of(kinds[0]), 0U);
  EXPECT_EQ(surface.matters.size(), 3U);
}

}  // namespace
}  // namespace brunt
