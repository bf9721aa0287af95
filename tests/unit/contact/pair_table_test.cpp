// Which of the bodies in a scene may touch follows from what they show: faces or particles, rigid
// or not, one piece or more; and from what the deck ignores.
#include "contact/law/pair_table.hpp"

#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;
using Pairs = std::vector<std::pair<Label, Label>>;

/// 0 and 1 deformable, 2 and 3 rigid, 4 particles.
PairTable table(ContactScene<3>& scene) {
  add_sheet(scene, 1, 0, 1, 0, true, 1e6, 1);
  add_sheet(scene, 1, 0, 1, 1, true, 1e6, 1);
  add_sheet(scene, 1, 0, 1, 2, true, 0, 0);
  add_sheet(scene, 1, 0, 1, 3, true, 0, 0);
  scene.add_particle(scene.add_group(), Vec3::Zero(), 0.1, 1e6, 1);
  std::vector<Surface<3>*> surfaces;
  for (auto& group : scene.groups) surfaces.push_back(&group.surface);
  return PairTable(scene.options, surfaces, {"a", "b", "c", "d", "e"});
}

TEST(PairTable, RigidBodiesAndSinglePiecesDoNotTouchThemselves) {
  ContactScene<3> scene;
  const Pairs expected = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 4}, {3, 4}};
  const PairTable pairs = table(scene);
  EXPECT_EQ(pairs.pairs(), expected);
  EXPECT_EQ(pairs.name(0), "a-b");
  EXPECT_EQ(pairs.find(4, 3), 8u);
  EXPECT_EQ(pairs.find(2, 3), std::nullopt);
}

TEST(PairTable, OptionsOfTheDeckComeFirst) {
  ContactScene<3> scene;
  scene.options.fallback = {true, 0.5, 0.1, {}};
  scene.options.pairs[{1, 4}] = {false, 2.0, 0.3, {}};
  scene.options.pair_names[{1, 4}] = "shot";
  const PairTable pairs = table(scene);
  EXPECT_EQ(pairs.pairs(), (Pairs{{1, 4}}));
  EXPECT_EQ(pairs.name(0), "shot");
  EXPECT_EQ(pairs.of(4, 1).stiffness, 2.0);
  EXPECT_TRUE(pairs.of(0, 1).ignore);
  EXPECT_EQ(pairs.strongest(4).damping, 0.3);
  EXPECT_TRUE(pairs.strongest(0).ignore);
}

TEST(PairTable, StiffFacesAreWatchedAndParticlesBoundStepsAlways) {
  ContactScene<3> scene;
  scene.options.fallback = {false, 0.5, 0.1, {}};
  EXPECT_FALSE(table(scene).watched());
  EXPECT_EQ(table(scene).always(0), 0.5);
  scene.options.fallback.stiffness = 20;
  EXPECT_FALSE(table(scene).watched());
  EXPECT_EQ(table(scene).always(0), 20);
  scene.options.fallback.step_by_area = true;
  const PairTable pairs = table(scene);
  EXPECT_TRUE(pairs.watched());
  for (const auto& [a, b] : pairs.pairs()) {
    EXPECT_GE(std::min(pairs.always(a), pairs.always(b)), kFreeStiffness);
    EXPECT_EQ(pairs.strongest(a).stiffness, 20);
  }
  PairOptions& options = scene.options.fallback;
  options.tied = true;
  EXPECT_FALSE(table(scene).watched());
  options.tied = false;
  std::get<CohesiveBond>(options.bonds).tension = 1e6;
  EXPECT_FALSE(table(scene).watched());
}

TEST(PairTable, PiecesOfOneBodyTouch) {
  ContactScene<3> scene;
  add_sheet(scene, 1, 0, 1, 0.1, true, 1e6, 1);
  auto& group = scene.groups[0];
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(1, 0, 0)}) {
    scene.add_point(group, x, 1);
  }
  auto& facet = group.surface.facets.emplace_back();
  facet.node = {4, 5, 6, 7};
  scene.name(group, facet, 1e6, 1);
  facet.piece = 1;
  scene.start();
  scene.evaluate();
  // k d A = 1e6/4 x 0.1 between the pieces; the body as a whole feels nothing.
  Real up = 0;
  for (std::size_t i = 4; i < 8; ++i) up += group.points.f[i][2];
  EXPECT_NEAR(up, 2.5e4, 1e-8);
  EXPECT_NEAR(scene.force(0).norm(), 0, 1e-10);
  facet.piece = 0;
  ContactScene<3> alone;
  std::vector<Surface<3>*> surfaces = {&group.surface};
  EXPECT_TRUE(PairTable(alone.options, surfaces, {"a"}).pairs().empty());
}

}  // namespace
}  // namespace brunt
