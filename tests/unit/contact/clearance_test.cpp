// What proves a face out of a particle's reach may never be wrong: of faces and particles at
// random, moved at random, all that is left out must still be beyond its radius and what speed
// step limits look ahead in some component, and before the face. And it must prove something: a
// particle three radii beside a face at rest, half a radius before it, is left out.
#include "contact/search/clearance.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

constexpr Real kRadius = 0.5;  // [m]

/// A unit square in the plane z = 0, or four corners about it, and one particle.
struct Beside {
  ContactScene<3> scene;
  std::vector<Surface<3>*> surfaces;
  std::unique_ptr<Entities<3>> entities;

  Beside(const std::vector<Vec3>& corners, const Vec3& x, bool open) {
    scene.add_face(scene.add_group(), corners, 1e9, 1, 1).open = open;
    scene.add_particle(scene.add_group(), x, kRadius, 1e9, 1);
    for (auto& group : scene.groups) surfaces.push_back(&group.surface);
    const PairTable pairs(scene.options, surfaces, {"face", "particle"});
    entities =
        std::make_unique<Entities<3>>(surfaces, pairs, Section{}, ContactRanks{}, RigidSprings{});
    entities->refresh_planes();
  }
  Clearance clearance() const { return clearance_of(*entities, entities->particles[0], 0); }
  const Vec3& particle() const {
    return entities->nodes.x[static_cast<std::size_t>(entities->particles[0].node)];
  }
  /// [m] of the particle's centre from the face's box, in the widest component.
  Real apart() const {
    Real widest = -kInfinity;
    for (std::size_t c = 0; c < 3; ++c) {
      const Real x = particle()[static_cast<Eigen::Index>(c)];
      widest = std::max({widest, entities->boxes[0].lo[c] - x, x - entities->boxes[0].hi[c]});
    }
    return widest;
  }
  Real before() const {
    return entities->planes[0].normal.dot(particle() - entities->planes[0].center);
  }
};

std::vector<Vec3> square() { return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}; }

TEST(Clearance, LeavesOutNothingThatMayTouchAfterAnyMotion) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> noise(-1, 1);
  const auto anything = [&](Real size) -> Vec3 {
    return size * Vec3(noise(random), noise(random), noise(random));
  };
  int left_out = 0, kept = 0;
  for (int i = 0; i < 20000; ++i) {
    auto corners = square();
    for (auto& corner : corners) corner += anything(0.2);
    Beside beside(corners, Vec3(0.5, 0.5, 0.5) + anything(2.5), false);
    const Clearance clearance = beside.clearance();
    auto& entities = *beside.entities;
    const FacePlane<3> built = entities.planes[0];
    Vec3 least = Vec3::Constant(kInfinity), most = -least;
    const Real size = 0.3 * std::fabs(noise(random));
    for (auto& x : entities.nodes.x) {
      const Vec3 u = anything(size);
      least = least.cwiseMin(u), most = most.cwiseMax(u);
      x += u;
    }
    entities.refresh_planes();
    const FacePlane<3>& now = entities.planes[0];
    const Real moved = (most - least).maxCoeff(), ahead = 0.2 * std::fabs(noise(random));
    const ClearanceLoss loss{moved + ahead,
                             std::sqrt(3.0) * moved + std::max(now.warp - built.warp, 0.0),
                             (now.normal - built.normal).norm()};
    if (!loss.leaves(clearance)) {
      ++kept;
      continue;
    }
    ++left_out;
    EXPECT_GT(beside.apart(), kRadius + ahead);
    EXPECT_GT(beside.before(), now.warp);
  }
  EXPECT_GT(left_out, 1000);
  EXPECT_GT(kept, 1000);
}

// At rest nothing is lost. The box ends at x = 1: at x = 2.5 its sphere is 1 m apart, and its
// centre 0.25 m before the plane.
TEST(Clearance, LeavesOutWhatLiesBeside) {
  const Clearance clearance = Beside(square(), Vec3(2.5, 0.5, 0.25), false).clearance();
  EXPECT_TRUE((ClearanceLoss{0.999, 0.249, 0}).leaves(clearance));
  EXPECT_FALSE((ClearanceLoss{1, 0.249, 0}).leaves(clearance));
  EXPECT_FALSE((ClearanceLoss{0.999, 0.25, 0}).leaves(clearance));
  // The centres are sqrt(2^2 + 0.25^2) = 2.0156 m from each other, an eighth of which is 0.252 m.
  EXPECT_FALSE((ClearanceLoss{0.999, 0, 0.125}).leaves(clearance));
}

// Behind a face it may be held wherever it is; so it may on either side of an open one.
TEST(Clearance, KeepsWhatIsBehindAndSurfacesWithTwoSides) {
  EXPECT_FALSE(
      (ClearanceLoss{0, 0, 0}).leaves(Beside(square(), Vec3(2.5, 0.5, -0.25), false).clearance()));
  EXPECT_FALSE(
      (ClearanceLoss{0, 0, 0}).leaves(Beside(square(), Vec3(2.5, 0.5, 0.25), true).clearance()));
}

// A row is left out only where each of its faces is.
TEST(Clearance, OfARowIsTheLeastOfAll) {
  Clearance row{0, 3, 1, 2};
  row.take({1, 2, 4, 5});
  EXPECT_FALSE((ClearanceLoss{2.5, 0.5, 0}).leaves(row));  // the second is nearer
  EXPECT_FALSE((ClearanceLoss{1, 1.5, 0}).leaves(row));    // the first is less before
  EXPECT_FALSE((ClearanceLoss{1, 0, 0.25}).leaves(row));   // 0.25 x 5 m of the longest arm
  EXPECT_TRUE((ClearanceLoss{1, 0.5, 0.05}).leaves(row));
}

// Positions that are no numbers prove nothing.
TEST(Clearance, KeepsWhatIsNoNumber) {
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  const Clearance clearance = Beside(square(), Vec3(2.5, 0.5, 0.25), false).clearance();
  EXPECT_FALSE((ClearanceLoss{none, 0, 0}).leaves(clearance));
  EXPECT_FALSE((ClearanceLoss{0, none, 0}).leaves(clearance));
  EXPECT_FALSE((ClearanceLoss{0, 0, none}).leaves(clearance));
}

// Four side by side, in single precision, any part of a list keeps what one by one is kept, in the
// order of the list; what more it keeps is left out by less than a millionth.
TEST(Clearances, KeepAllThatEachOneKeeps) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<Real> number(0, 1);
  Clearances all;
  std::vector<Clearance> one(103);
  all.resize(one.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    one[i] = {static_cast<LocalIndex>(2 * i), static_cast<float>(number(random)),
              static_cast<float>(number(random)), static_cast<float>(number(random))};
    all.set(i, one[i]);
    EXPECT_EQ(all.entity(i), 2 * i);
  }
  for (int k = 0; k < 2000; ++k) {
    const auto first = static_cast<std::size_t>(number(random) * 103);
    const auto last = first + static_cast<std::size_t>(number(random) * (104.0 - Real(first)));
    const auto& on = one[static_cast<std::size_t>(number(random) * 103)];
    // Each second time just what one of them has: it is not left out.
    const Real turn = number(random);
    const ClearanceLoss loss =
        k % 2 == 0 ? ClearanceLoss{number(random), 0.5 * number(random), turn}
                   : ClearanceLoss{on.apart, std::max(0.0, on.before - turn * on.arm), turn};
    const ClearanceLoss more{loss.apart * (1 + 3e-6), loss.before * (1 + 3e-6),
                             loss.turn * (1 + 3e-6)};
    std::vector<LocalIndex> near(last - first + 4);
    near.resize(all.find_near(first, last, loss, near.data()));
    auto next = near.begin();
    for (std::size_t i = first; i < last; ++i) {
      const bool found = next != near.end() && *next == one[i].entity;
      if (found) ++next;
      EXPECT_TRUE(found || loss.leaves(one[i]));
      EXPECT_TRUE(!found || !more.leaves(one[i]));
    }
    EXPECT_EQ(next, near.end());
  }
}

// No bound at all, or one that is no number, leaves nothing out.
TEST(Clearances, KeepAllWhereNothingIsProved) {
  Clearances all;
  all.resize(7);
  for (std::size_t i = 0; i < 7; ++i) all.set(i, {static_cast<LocalIndex>(i), 1, 1, 1});
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  LocalIndex near[11];
  EXPECT_EQ(all.find_near(0, 7, ClearanceLoss{}, near), 7u);
  EXPECT_EQ(all.find_near(0, 7, ClearanceLoss{none, 0, 0}, near), 7u);
  EXPECT_EQ(all.find_near(0, 7, ClearanceLoss{0, 0, none}, near), 7u);
  EXPECT_EQ(all.find_near(2, 5, ClearanceLoss{0, 0, 0}, near), 0u);
  EXPECT_EQ(all.find_near(3, 3, ClearanceLoss{}, near), 0u);
}

}  // namespace
}  // namespace brunt
