// A particle of radius r and modulus M on a face of stiffness s = M/h: its own
// spring is M 2r, that of the face s (2r)^2, both in series; on a rigid face its own alone. It is
// held three radii behind a rigid face, six behind an open one, and no deeper than the body is.
#include "contact/evaluate/particle_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

ContactParticle particle() {
  ContactParticle one;
  static constexpr ParticleMatter kMatter{2e9, 40, 0};
  one.radius = 0.5, one.matter = &kMatter;
  return one;
}

ContactFace<3> face() {
  ContactFace<3> one;
  one.stiffness = 3e9, one.depth = 10, one.capacity = 1;
  return one;
}

TEST(ParticleLaw, SpringsOfBothSidesAreInSeries) {
  PairOptions options;
  options.stiffness = 0.25, options.damping = 0.1;
  const ParticleLaw law = law_of(particle(), face(), options, {});
  EXPECT_DOUBLE_EQ(law.stiffness, 0.25 * (2e9 * 3e9) / (2e9 + 3e9));
  EXPECT_DOUBLE_EQ(law.own, 0.25 * 2e9);
  EXPECT_EQ(law.zeta, 0.1);
  EXPECT_EQ(law.laws.friction, nullptr);
  ContactFace<3> rigid = face();
  rigid.stiffness = 0;
  EXPECT_DOUBLE_EQ(law_of(particle(), rigid, options, {}).stiffness, 0.25 * 2e9);
}

TEST(ParticleLaw, SectionIsASquareOrAnEdge) {
  ContactParticle one = particle();
  one.radius = 0.75;
  EXPECT_EQ(section_of<3>(one), 2.25);
  EXPECT_EQ(section_of<2>(one), 1.5);
}

TEST(ParticleLaw, HoldsNoDeeperThanTheBody) {
  ContactFace<3> one = face();
  EXPECT_EQ(held_behind(particle(), one), 1.5);
  one.open = true;
  EXPECT_EQ(held_behind(particle(), one), 3);
  one.depth = 1;
  EXPECT_EQ(held_behind(particle(), one), 1);
  one.stiffness = 0;
  EXPECT_EQ(held_behind(particle(), one), 3);
  one.open = false;
  EXPECT_EQ(held_behind(particle(), one), 1.5);
  one.half_thickness = 0.2;  // in front of it the other side is 0.4 behind: just not as deep
  EXPECT_NEAR(held_behind(particle(), one), 0.9, 1e-6);
  EXPECT_LT(held_behind(particle(), one), 0.9);
}

// 25/2 m c^2 of a particle at five times its speed of sound, m c^2 = M (2 r)^3, is what the barrier
// holds at the middle of plates that are no thicker than 2 5^(1/2) r; thicker ones stop it there.
TEST(ParticleLaw, BarrierStopsFiveSpeedsOfSoundBeforeTheMiddle) {
  PairOptions options;
  options.stiffness = 0.5;
  const ContactParticle one = particle();
  const ParticleLaw law = law_of(one, face(), options, {});
  const Real energy = 12.5 * 2e9;
  for (const Real radii : {0.1, 0.5, 1.0, std::sqrt(5.0), 3.0, kInfinity}) {
    ContactFace<3> plate = face();
    plate.half_thickness = radii * one.radius;
    const ParticleSpring barrier{0, barrier_of(law, one, plate), one.radius};
    const Real stopped = std::min(radii, std::sqrt(5.0)) * one.radius;
    EXPECT_NEAR(barrier.energy(one.radius + stopped), energy, 1e-12 * energy) << radii;
  }
}

// Laws one after another are those that each has by itself, whatever came before.
TEST(ParticleLaw, LawsInARowAreThoseOfEach) {
  ContactOptions options;
  options.fallback.stiffness = 0.3, options.fallback.damping = 0.2;
  const PairTable pairs(options, std::vector<Surface<3>*>{}, {"a", "b", "c"});
  ParticleLaws<3> laws(pairs);
  for (unsigned i = 0; i < 1000; ++i) {
    // Each change comes alone, too, and nothing changes now and then.
    const unsigned bits = i * 2654435761U >> 20U;
    ContactParticle one = particle();
    ContactFace<3> other = face();
    one.body = bits & 1U, other.body = bits >> 1U & 1U;
    if ((bits >> 2U & 1U) != 0) one.radius = 0.25;
    ParticleMatter matter = *one.matter;
    if ((bits >> 3U & 1U) != 0) matter.modulus = 1e9;
    if ((bits >> 4U & 1U) != 0) matter.conductivity = 0;
    one.matter = &matter;
    if ((bits >> 5U & 1U) != 0) other.stiffness = (bits >> 6U & 1U) != 0 ? 0 : 1e9;
    if ((bits >> 7U & 1U) != 0) other.compliance = 1;
    if ((bits >> 8U & 1U) != 0) other.capacity = 0;
    const ParticleLaw& law = laws.of(one, other);
    const ParticleLaw alone =
        law_of(one, other, pairs.of(one.body, other.body), pairs.resting(one.body, other.body));
    EXPECT_EQ(law.stiffness, alone.stiffness);
    EXPECT_EQ(law.own, alone.own);
    EXPECT_EQ(law.zeta, alone.zeta);
    EXPECT_EQ(law.layer_zeta, alone.layer_zeta);
    EXPECT_EQ(law.laws.heat, alone.laws.heat);
    EXPECT_EQ(law.laws.friction, alone.laws.friction);
    EXPECT_EQ(laws.lag(0.1 * (bits & 3U)), lag_factor(0.1 * (bits & 3U)));
  }
}

TEST(ParticleLaw, HeatPassesWhereBothSidesTakeIt) {
  PairOptions options;
  EXPECT_EQ(heat_between(particle(), face(), options), nullptr);
  options.heat.emplace<1>();
  EXPECT_EQ(heat_between(particle(), face(), options), &options.heat);
  ContactFace<3> cold = face();
  cold.capacity = 0;
  EXPECT_EQ(heat_between(particle(), cold, options), nullptr);
}

}  // namespace
}  // namespace brunt
