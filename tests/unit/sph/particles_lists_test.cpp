// When neighbour lists are rebuilt, and that no pair is missed.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sample.hpp"

namespace brunt {
namespace {

using test::kDensity;
using test::kDp;

// What no velocity predicts: from one step to the next, supports put particles wherever they are
// asked to, one half of a block through the other or far away and back. update_state checks the
// lists after the motion, by itself: all steps are those of a block whose lists hold every pair
// there is, and so they are where the lists are built at every step besides.
TEST(SphParticlesLists, AreCheckedAfterTheMotion) {
  const auto material = test::elastic_material(kDensity, 200e9, 0.3);
  const auto run = [&](Real skin, bool always, Real xsph) {
    SphOptions options = test::all_pair_sums();
    options.xsph = xsph;
    auto points = test::lattice<2>({12, 12}, kDp, kDensity * kDp * kDp, 0.1);
    for (auto& v : points.v) v = Vec<2>(50, -30);
    for (std::size_t i = 0; i < points.v.size() / 2; ++i) points.v[i] *= -1;
    auto solid = test::particles<2>(std::move(points), kDp, *material, options);
    solid->set_skin(skin);
    std::vector<std::uint64_t> hashes;
    for (int k = 0; k < 12; ++k) {
      if (always) solid->rearrange();
      test::step<2>(*solid, 1e-10, [&](Points<2>& p) {
        const Real far = (k % 2 ? -1 : 1) * (k % 4 < 2 ? 1.5 : 40.0) * kDp;
        for (std::size_t i = 0; i < p.x.size() / 2; ++i) p.x[i] += far * Vec<2>(0.3, 1);
      });
      EntityHash hash(test::totals(*solid).state_hash);
      for (const auto& f : solid->points().f) hash.add(f[0]), hash.add(f[1]);
      hashes.push_back(hash.value());
    }
    EXPECT_TRUE(std::isfinite(solid->stable_step().step));
    return std::pair(hashes, solid->n_searches());
  };
  for (const Real xsph : {0.0, 0.5}) {
    const auto all = run(1000, false, xsph).first;  // a skin beyond the scene
    EXPECT_EQ(std::set<std::uint64_t>(all.begin(), all.end()).size(), all.size());
    for (const Real skin : {0.0, 0.05, 0.35}) {
      const auto [hashes, searches] = run(skin, false, xsph);
      EXPECT_EQ(hashes, all) << skin;
      EXPECT_GE(searches, 12) << skin;  // no list outlives a jump
      EXPECT_EQ(run(skin, true, xsph).first, all) << skin;
    }
  }
}

/// Pairs within the support, counted one by one.
template <int Dim>
std::int64_t pairs_of(const Points<Dim>& points, Real support) {
  std::int64_t n = 0;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    for (std::size_t j = 0; j < points.x.size(); ++j) {
      n += i != j && (points.x[i] - points.x[j]).norm() < support ? 1 : 0;
    }
  }
  return n;
}

/// The block turns a little, so that no distance is that of the support.
template <int Dim>
void expect_counted(std::array<int, Dim> cells) {
  const auto material = test::elastic_material(kDensity, 200e9, 0.3);
  SphOptions options = test::all_pair_sums();
  options.adaptive_h = false;
  auto points = test::lattice<Dim>(cells, kDp, kDensity * std::pow(kDp, Dim), 0.1);
  auto solid = test::particles<Dim>(std::move(points), kDp, *material, options);
  PairCount narrow;
  for (const Real skin : {0.0, 0.5}) {
    solid->set_skin(skin);
    test::step<Dim>(*solid, 1e-12, [](Points<Dim>& p) {
      for (auto& x : p.x) x[0] += 1e-3 * x[1];
    });
    const PairCount count = solid->pair_count();
    EXPECT_EQ(count.in_support, pairs_of(solid->points(), 2 * options.smoothing * kDp));
    EXPECT_GE(count.compared, count.in_support);
    EXPECT_EQ(count.hit_rate(),
              static_cast<Real>(count.in_support) / static_cast<Real>(count.compared));
    if (skin == 0) {
      narrow = count;
    } else {
      EXPECT_GT(count.compared, narrow.compared);  // a wider skin lets more in
    }
  }
  EXPECT_GT(narrow.in_support, 0);
}

TEST(SphParticlesLists, CountTheirPairs) {
  expect_counted<2>({13, 11});
  expect_counted<3>({9, 8, 7});
}

}  // namespace
}  // namespace brunt
