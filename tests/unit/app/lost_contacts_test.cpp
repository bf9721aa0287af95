// What a user reads of contacts that did not hold: once for each pair of bodies while the run goes
// on, with where, when and how deep, and at the end how many there were.
#include "app/watch/lost_contacts.hpp"

#include <gtest/gtest.h>

#include "contact/contacts/deep.hpp"

namespace brunt {
namespace {

LostPair pair_with(const std::string& name, std::int64_t let_go, std::int64_t from_behind,
                   ContactKey key, std::int64_t crossed = 0) {
  LostPair pair;
  pair.name = name;
  pair.lost = {let_go, from_behind, crossed, 12.5e-6, 1.02e-3, {1e-3, -2e-3, 3e-3}, key};
  return pair;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(LostContactWarnings, TellOfEachPairOnce) {
  LostContactWarnings warnings(3);
  EXPECT_TRUE(warnings.take({}).empty());
  const auto first =
      warnings.take({pair_with("a-b", 1, 0, {ContactKind::face_face, kLetGo, 1, 2})});
  ASSERT_EQ(first.size(), 1u);
  EXPECT_TRUE(has(first[0], "a-b: faces came 1.02 mm into each other")) << first[0];
  EXPECT_TRUE(has(first[0], "t = 12.5 us, at (0.001, -0.002, 0.003) m")) << first[0];
  const auto second =
      warnings.take({pair_with("a-b", 5, 2, {ContactKind::face_face, kLetGo, 1, 2}),
                     pair_with("a-c", 0, 1, {ContactKind::face_face, kFromBehind, 1, 3})});
  ASSERT_EQ(second.size(), 1u);
  EXPECT_TRUE(has(second[0], "a-c: faces that had gone through each other")) << second[0];
  const auto all = warnings.all();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(has(all.at("a-b"), "5 contacts let go, 2 came back, and 0 faces went"))
      << all.at("a-b");
  EXPECT_TRUE(has(all.at("a-c"), "0 contacts let go, 1 came back, and 0 faces went"))
      << all.at("a-c");
}

TEST(LostContactWarnings, TellOfDeepContactsAndAgainOnceTheyLetGo) {
  LostContactWarnings warnings(3);
  LostPair pair = pair_with("a-b", 0, 0, {ContactKind::face_face, kDeep, 1, 2});
  const auto deep = warnings.take({pair});
  ASSERT_EQ(deep.size(), 1u);
  EXPECT_TRUE(has(deep[0], "they hold yet, but bodies overlap by most of an element")) << deep[0];
  EXPECT_TRUE(has(warnings.all().at("a-b"), "all contacts held")) << deep[0];
  EXPECT_TRUE(warnings.take({pair}).empty());
  pair = pair_with("a-b", 1, 0, {ContactKind::face_face, kLetGo, 1, 2});
  const auto gone = warnings.take({pair});
  ASSERT_EQ(gone.size(), 1u);
  EXPECT_TRUE(has(gone[0], "into each other and let go")) << gone[0];
  EXPECT_TRUE(warnings.take({pair}).empty());
}

TEST(LostContactWarnings, TellOfEdgesThatCross) {
  LostContactWarnings warnings(3);
  const auto reported =
      warnings.take({pair_with("a-b", 0, 0, {ContactKind::face_face, kCrossed, 1, 2}, 3)});
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_TRUE(has(reported[0], "a-b: faces came 1.02 mm through each other at t")) << reported[0];
  const auto all = warnings.all();
  EXPECT_TRUE(has(all.at("a-b"), "3 faces went through each other without a push"));
}

TEST(LostContactWarnings, NameParticlesAndAsManyCoordinatesAsThereAre) {
  LostContactWarnings warnings(2);
  const auto reported =
      warnings.take({pair_with("shot-wall", 1, 0, {ContactKind::particle_face, kLetGo, 1, 2})});
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_TRUE(has(reported[0], "shot-wall: a particle came 1.02 mm behind a face")) << reported[0];
  EXPECT_TRUE(has(reported[0], "at (0.001, -0.002) m")) << reported[0];
}

}  // namespace
}  // namespace brunt
