// What contacts remember, by their keys: a memory names its values once, and checkpoints, other
// ranks and the hash of the state see them through that.
#include "contact/contacts/keyed_memory.hpp"

#include <gtest/gtest.h>

#include "contact/contacts/first_touch.hpp"
#include "contact/contacts/friction.hpp"
#include "contact/contacts/lost.hpp"

namespace brunt {
namespace {

struct Scratch {
  ContactKey key;
  Real depth = 0;  // tells states apart
  int turns = 0;   // does not
  static constexpr const char* kTable = "contact.scratch";
  template <class Visitor, class Memory>
  static void visit(Visitor& visitor, Memory& one) {
    visitor.carry(one.depth, one.turns);
    visitor.hash(one.depth);
  }
};

constexpr auto kFaces = ContactKind::face_face, kOnFace = ContactKind::particle_face;

KeyedMemory<Scratch> scratches() {
  KeyedMemory<Scratch> all;
  all.add({{kFaces, 0, 1, 2}, 0.5, -3});
  all.add({{kFaces, 1, 1, 2}, 0.25, 4});  // a second plane between the same faces
  all.add({{kFaces, 0, 1, 7}, 0.75, 5});
  all.add({{kFaces, 0, 3, 4}, 1.5, 6});
  all.add({{kOnFace, 0, 1, 2}, 2.5, 7});  // the particle 1 has nothing to do with the face 1
  return all;
}

/// What a checkpoint of some contacts gives back to their face or particle.
template <class Memory>
std::vector<Memory> again(const KeyedMemory<Memory>& all, ContactKind kind, GlobalId first) {
  std::vector<StateTable> written;
  all.save(written);
  const StateTables tables(std::move(written));
  std::vector<Memory> read;
  load_memories(kind, first, tables, read);
  return read;
}

TEST(KeyedMemory, ComesBackInTheOrderOfKeys) {
  const auto faces = again(scratches(), kFaces, 1);
  ASSERT_EQ(faces.size(), 3u);
  EXPECT_EQ(faces[1].key, (ContactKey{kFaces, 1, 1, 2}));
  EXPECT_EQ(faces[1].depth, 0.25);
  EXPECT_EQ(faces[0].turns, -3);
  EXPECT_EQ(faces[2].key.second, 7u);
  const auto particle = again(scratches(), kOnFace, 1);
  ASSERT_EQ(particle.size(), 1u);
  EXPECT_EQ(particle[0].depth, 2.5);
  EXPECT_TRUE(again(scratches(), kOnFace, 3).empty());
}

TEST(KeyedMemory, IsFoundByItsKey) {
  auto all = scratches();
  ASSERT_NE(all.find({kFaces, 0, 3, 4}), nullptr);
  EXPECT_EQ(all.find({kFaces, 0, 3, 4})->depth, 1.5);
  EXPECT_EQ(all.find({kFaces, 1, 3, 4}), nullptr);
  all.add_if_new({{kFaces, 0, 3, 4}, 9, 9});
  EXPECT_EQ(all.find({kFaces, 0, 3, 4})->depth, 1.5);
  all.add_if_new({{kFaces, 0, 2, 4}, 9, 9});
  EXPECT_EQ(all.find({kFaces, 0, 2, 4})->depth, 9);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(),
                             [](const auto& a, const auto& b) { return a.key < b.key; }));
}

TEST(KeyedMemory, HashesWhatTellsStatesApart) {
  const Scratch one{{kFaces, 0, 1, 2}, 0.5, 1};
  Scratch other = one;
  other.turns = 2;
  EXPECT_EQ(hash_of(other), hash_of(one));
  other.depth = 0.6;
  EXPECT_NE(hash_of(other), hash_of(one));
  other = one;
  other.key.second = 3;
  EXPECT_NE(hash_of(other), hash_of(one));
}

// Each memory of contact, with no value as its default leaves it.
TEST(KeyedMemory, CarriesFirstTouches) {
  KeyedMemory<FirstTouch> all;
  all.add({touch_key(8, 2, 3), 1e-3, true, true, -1, true, 5});
  const auto read = again(all, kOnFace, 8);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].key, touch_key(8, 2, 3));
  EXPECT_EQ(read[0].overlap, 1e-3);
  EXPECT_TRUE(read[0].bonded && read[0].slips && read[0].held);
  EXPECT_EQ(read[0].side, -1);
  EXPECT_EQ(read[0].entry, 5u);
  EXPECT_EQ(hash_of(read[0]), all.hash());
  FirstTouch other = read[0];
  other.side = 1;
  EXPECT_NE(hash_of(other), all.hash());
}

TEST(KeyedMemory, CarriesFriction) {
  Friction<2> friction;
  friction.key = {kFaces, 1, 4, 9};
  friction.body = 2, friction.piece = 3;
  friction.normal = {0, 1}, friction.point = {0.1, 0.2};
  friction.traction = {1e6, 0}, friction.drag = {2e5, 0};
  friction.area = 1e-4, friction.stiffness = 1e12, friction.n_nodes = 4;
  friction.slips = true, friction.heat_share = 0.9, friction.heat = 0.7;
  for (std::size_t k = 0; k < friction.force.size(); ++k) {
    friction.force[k] = Vec<2>(1.0 + static_cast<Real>(k), 2);
    friction.heat_shares[k] = 0.1 * static_cast<Real>(k);
  }
  KeyedMemory<Friction<2>> all;
  all.add(friction);
  const auto read = again(all, kFaces, 4);
  ASSERT_EQ(read.size(), 1u);
  const auto& one = read[0];
  EXPECT_EQ(one.key, friction.key);
  EXPECT_TRUE(one.body == 2 && one.piece == 3 && one.n_nodes == 4 && one.slips);
  EXPECT_EQ(one.normal, friction.normal);
  EXPECT_EQ(one.point, friction.point);
  EXPECT_EQ(one.resultant(), friction.resultant());
  EXPECT_EQ(one.energy(), friction.energy());
  EXPECT_TRUE(one.heat_share == 0.9 && one.heat == 0.7);
  EXPECT_EQ(one.force, friction.force);
  EXPECT_EQ(one.heat_shares, friction.heat_shares);
}

TEST(KeyedMemory, CarriesLostContacts) {
  KeyedMemory<LostContact<3>> all;
  all.add({{kOnFace, kLetGo, 4, 9}, 1, 2, 3e-6, 4e-3, {1, 2, 3}});
  const auto read = again(all, kOnFace, 4);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].key, (ContactKey{kOnFace, kLetGo, 4, 9}));
  EXPECT_TRUE(read[0].lower_body == 1 && read[0].upper_body == 2);
  EXPECT_TRUE(read[0].time == 3e-6 && read[0].depth == 4e-3);
  EXPECT_EQ(read[0].point, Vec3(1, 2, 3));
}

}  // namespace
}  // namespace brunt
