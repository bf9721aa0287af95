// A particle of radius r at height d over a flat surface overlaps it by r - d along the normal,
// whatever the triangulation: exactly one contact. Outside a convex edge or corner it overlaps by
// r minus the distance to it; in a concave corner it touches each wall.
#include "contact/geometry/particle_face.hpp"

#include <gtest/gtest.h>

#include <random>

namespace brunt {
namespace {

/// Faces with named nodes; hits of a particle with those that may matter.
struct Skin {
  std::vector<Vec3> node;
  std::vector<std::vector<LocalIndex>> faces;
  std::vector<FacePlane<3>> planes;

  void add(const std::vector<LocalIndex>& corners) {
    faces.push_back(corners);
    FacePlane<3> plane;
    plane.n_corners = static_cast<int>(corners.size());
    plane.corner[3].setZero();
    for (std::size_t c = 0; c < corners.size(); ++c) {
      plane.corner[c] = node[static_cast<std::size_t>(corners[c])];
    }
    refresh(plane);
    planes.push_back(plane);
  }

  std::vector<ParticleHit<3>> hits(const Vec3& x, Real r) const {
    std::vector<ParticleHit<3>> all;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      ParticleHit<3> hit;
      hit.plane = &planes[f];
      hit.node.fill(-1);
      std::copy(faces[f].begin(), faces[f].end(), hit.node.begin());
      hit.limit = 4 * r;
      hit.nearest = nearest_point<3>(planes[f], x);
      if (hit.nearest.distance < 5 * r) all.push_back(hit);
    }
    choose_hits<3>(x, r, all);
    std::erase_if(all, [](const auto& hit) { return !hit.kept; });
    return all;
  }
};

Skin random_sheet(std::uint64_t seed, bool quads) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<Real> shift(-0.35, 0.35);
  constexpr LocalIndex n = 6;
  Skin skin;
  for (LocalIndex j = 0; j <= n; ++j) {
    for (LocalIndex i = 0; i <= n; ++i)
      skin.node.push_back({i + shift(random), j + shift(random), 0});
  }
  for (LocalIndex j = 0; j < n; ++j) {
    for (LocalIndex i = 0; i < n; ++i) {
      const LocalIndex a = j * (n + 1) + i, b = a + n + 1;
      if (quads) {
        skin.add({a, a + 1, b + 1, b});
      } else if (random() % 2) {
        skin.add({a, a + 1, b + 1}), skin.add({a, b + 1, b});
      } else {
        skin.add({a, a + 1, b}), skin.add({a + 1, b + 1, b});
      }
    }
  }
  return skin;
}

Skin cube() {
  Skin skin;
  for (LocalIndex k = 0; k < 8; ++k)
    skin.node.push_back({Real(k & 1), Real(k >> 1 & 1), Real(k >> 2)});
  for (const auto& quad : std::vector<std::vector<LocalIndex>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    skin.add(quad);
  }
  return skin;
}

Real distance_to_cube(const Vec3& x) {
  return (x - x.cwiseMax(Vec3::Zero()).cwiseMin(Vec3::Ones())).norm();
}

TEST(ParticleFace, FlatSheetPushesAlike) {
  const Real r = 0.5, height = 0.3;
  for (const bool quads : {false, true}) {
    const Skin skin = random_sheet(quads ? 7 : 5, quads);
    std::mt19937_64 random(2);
    std::uniform_real_distribution<Real> place(1, 5);
    for (int trial = 0; trial < 4000; ++trial) {
      Vec3 x(place(random), place(random), height);
      // Every fourth stands exactly over a node, or over the middle of two.
      const std::size_t a = random() % skin.node.size(), b = random() % skin.node.size();
      if (trial % 4 == 0) x = 0.5 * (skin.node[a] + skin.node[b]) + height * Vec3::UnitZ();
      if (x.head<2>().minCoeff() < 1 || x.head<2>().maxCoeff() > 5) continue;
      for (const Real z : {height, -0.2}) {
        x[2] = z;
        Vec3 push = Vec3::Zero();
        for (const auto& hit : skin.hits(x, r)) push += hit.share * hit.overlap * hit.direction;
        EXPECT_NEAR(push[2], r - z, 1e-12 * r);
        EXPECT_LT(push.head<2>().norm(), 1e-12 * r);
      }
    }
  }
}

TEST(ParticleFace, CubeDoesNotLeakAtEdgesAndCorners) {
  const Skin skin = cube();
  const Real r = 0.2;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> place(-0.2, 1.2);
  int at_edges = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec3 x(place(random), place(random), place(random));
    const Real distance = distance_to_cube(x);
    if (distance == 0) continue;
    const auto hits = skin.hits(x, r);
    ASSERT_EQ(hits.size(), distance < r ? 1u : 0u) << x.transpose();
    if (hits.empty()) continue;
    EXPECT_NEAR(hits[0].overlap, r - distance, 1e-14);
    EXPECT_NEAR((hits[0].nearest.point + distance * hits[0].direction - x).norm(), 0, 1e-14);
    at_edges += hits[0].nearest.feature == Feature::face ? 0 : 1;
  }
  EXPECT_GT(at_edges, 1000);
}

TEST(ParticleFace, CentreInsideIsHeldByTheNearestFace) {
  const Skin skin = cube();
  const auto hits = skin.hits(Vec3(0.9, 0.95, 0.6), 0.2);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_TRUE(hits[0].inside);
  EXPECT_NEAR(hits[0].overlap, 0.2 + 0.05, 1e-15);
  EXPECT_NEAR(hits[0].direction[1], 1, 1e-15);
}

TEST(ParticleFace, CornerOfTwoWallsTouchesBoth) {
  Skin skin;
  skin.node = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 3}, {0, 3, 3}};
  skin.add({0, 1, 2, 3});
  skin.add({0, 3, 5, 4});
  const auto hits = skin.hits(Vec3(0.3, 1.2, 0.4), 0.5);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].overlap * hits[0].share, 0.1, 1e-15);
  EXPECT_NEAR(hits[0].direction[2], 1, 1e-15);
  EXPECT_NEAR(hits[1].overlap * hits[1].share, 0.2, 1e-15);
  EXPECT_NEAR(hits[1].direction[0], 1, 1e-15);
}

TEST(ParticleFace, BricksSideBySideShareTheParticle) {
  // Two faces that share no node: over the joint each takes half; away from it the nearer takes
  // all.
  Skin skin;
  skin.node = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0},
               {0, 0, 0},  {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  skin.add({0, 1, 2, 3});
  skin.add({4, 5, 6, 7});
  const auto push = [&](Real x) {
    Vec3 sum = Vec3::Zero();
    for (const auto& hit : skin.hits(Vec3(x, 0.5, 0.3), 0.5)) {
      sum += hit.share * hit.overlap * hit.direction;
    }
    return sum;
  };
  EXPECT_NEAR(push(0)[2], 0.2, 1e-14);
  EXPECT_NEAR(push(0.45)[2], 0.2, 1e-14);
  for (Real x = -0.4; x < 0.4; x += 0.01) EXPECT_NEAR(push(x)[2], 0.2, 0.2 * 0.2) << x;
}

TEST(ParticleFace, WeightsFoldTheCentreOfAQuad) {
  const Skin skin = cube();
  const auto nearest = nearest_point<3>(skin.planes[1], Vec3(0.7, 0.2, 1.5));
  Vec3 point = Vec3::Zero();
  Real sum = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_GE(nearest.weight[c], 0);
    sum += nearest.weight[c];
    point += nearest.weight[c] * skin.planes[1].corner[c];
  }
  EXPECT_NEAR(sum, 1, 1e-15);
  EXPECT_LT((point - Vec3(0.7, 0.2, 1)).norm(), 1e-15);
}

/// Two quads that meet in an edge of 1 m along z at the origin, as the tip of a wedge of `angle`
/// [rad] about the x axis, which points out of it; their far corners are moved along their normals
/// by `warp` and back [m]. Moved so, the part of each beside the edge and its mean plane differ.
Skin warped_wedge(Real angle, Real warp_left, Real warp_right) {
  Skin skin;
  const Vec3 left(-std::cos(angle / 2), std::sin(angle / 2), 0), right(left[0], -left[1], 0);
  const Vec3 out_left(std::sin(angle / 2), std::cos(angle / 2), 0);
  const Vec3 out_right(out_left[0], -out_left[1], 0);
  const Vec3 low(0, 0, 0), high(0, 0, 1);
  skin.node = {low,
               high,
               low + left + warp_left * out_left,
               high + left + warp_left * out_left,
               low + right + warp_right * out_right,
               high + right + warp_right * out_right};
  skin.node[3] -= 2 * warp_left * out_left, skin.node[5] -= 2 * warp_right * out_right;
  skin.add({1, 0, 2, 3});
  skin.add({0, 1, 5, 4});
  return skin;
}

// Whatever the warp, a particle before the tip of a folded surface is outside: the faces are those
// four triangles each on which its nearest point is found. By mean planes it was up to its distance
// behind the surface, at the top of a barrier (random deck 7040: 366 J of 14 in a step).
TEST(ParticleFace, BeforeTheFoldOfWarpedFacesIsOutside) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<Real> part(0, 1), warp(-0.3, 0.3);
  const Real r = 0.2;
  int near_edge = 0, by_mean_planes = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Skin skin = warped_wedge(0.05 + part(random), warp(random), warp(random));
    const Vec3 along = Vec3::UnitZ();
    std::array<Vec3, 2> beside;  // normals of the triangles at the edge, out of the wedge
    bool turned = false;
    for (std::size_t f = 0; f < 2; ++f) {
      const Vec3 edge = f == 0 ? Vec3(-along) : along;
      beside[f] = edge.cross(skin.planes[f].center - Vec3(0, 0, 0.5)).normalized();
      turned = turned || beside[f].dot(skin.planes[f].normal) < 0.3;
    }
    if (turned || beside[0].cross(beside[1]).dot(along) > 0) continue;  // an edge, not a groove
    const Real share = part(random), height = 0.2 + 0.6 * part(random);
    const Vec3 arm = (share * beside[0] + (1 - share) * beside[1]).normalized();
    const Vec3 x = Vec3(0, 0, height) + 0.5 * r * arm;
    const bool nearer = std::any_of(skin.planes.begin(), skin.planes.end(), [&](const auto& plane) {
      return nearest_point<3>(plane, x).distance < 0.5 * r - 1e-12;
    });
    if (nearer) continue;  // the fold of a face
    const auto hits = skin.hits(x, r);
    ASSERT_EQ(hits.size(), 1u) << trial;
    EXPECT_FALSE(hits[0].inside) << trial;
    EXPECT_NEAR(hits[0].overlap, 0.5 * r, 1e-12);
    const Real mean = (skin.planes[0].normal + skin.planes[1].normal).dot(arm);
    ++near_edge;
    by_mean_planes += mean < 0 ? 1 : 0;
  }
  EXPECT_GT(near_edge, 5000);
  EXPECT_GT(by_mean_planes, 50);
}

TEST(ParticleFace, ParticleThatIsNowhereTouchesNothing) {
  const Skin skin = cube();
  std::vector<ParticleHit<3>> hits(1);
  const Vec3 nowhere = Vec3::Constant(std::nan(""));
  hits[0].plane = &skin.planes[0];
  hits[0].nearest = nearest_point<3>(skin.planes[0], nowhere);
  choose_hits<3>(nowhere, 0.1, hits);
  EXPECT_FALSE(hits[0].kept);
}

TEST(ParticleFace, EdgesInTwoDimensions) {
  // A corner of a body below and left: edges run so that the body lies to their left.
  std::array<FacePlane<2>, 2> plane;
  plane[0].corner = {Vec<2>(0, 0), Vec<2>(-2, 0)};
  plane[1].corner = {Vec<2>(0, -2), Vec<2>(0, 0)};
  const std::array<std::array<LocalIndex, 2>, 2> node = {{{0, 1}, {2, 0}}};
  const auto hits = [&](const Vec<2>& x) {
    std::vector<ParticleHit<2>> all;
    for (std::size_t f = 0; f < 2; ++f) {
      refresh(plane[f]);
      auto& hit = all.emplace_back();
      hit.plane = &plane[f], hit.node = node[f], hit.limit = 1;
      hit.nearest = nearest_point<2>(plane[f], x);
    }
    choose_hits<2>(x, 0.5, all);
    std::erase_if(all, [](const auto& hit) { return !hit.kept; });
    return all;
  };
  const auto outside = hits(Vec<2>(0.3, 0.2));
  ASSERT_EQ(outside.size(), 1u);
  EXPECT_NEAR(outside[0].overlap, 0.5 - std::hypot(0.3, 0.2), 1e-15);
  const auto over = hits(Vec<2>(-1, 0.4));
  ASSERT_EQ(over.size(), 1u);
  EXPECT_NEAR(over[0].overlap, 0.1, 1e-15);
  const auto inside = hits(Vec<2>(-0.3, -0.1));
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_NEAR(inside[0].overlap, 0.6, 1e-15);
}

TEST(ParticleFace, SpringHardensBehindTheSurface) {
  const ParticleSpring spring{2, 3, 0.5};
  EXPECT_EQ(spring.force(0.5), 1);
  EXPECT_EQ(spring.tangent(0.5), 2);
  EXPECT_NEAR(spring.force(1), 2 + 3 * 0.125 / 0.25, 1e-15);
  EXPECT_NEAR(spring.tangent(1), (spring.force(1 + 1e-6) - spring.force(1 - 1e-6)) / 2e-6, 1e-8);
}

}  // namespace
}  // namespace brunt
