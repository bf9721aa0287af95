// Which particles planes of symmetry reflect (app/setup/mirrors.hpp): those of pieces that end at
// them, on the side where they lie. Lattices of 1 mm end 0.5 mm before a plane, hexagonal ones
// 0.25 mm.
#include "app/setup/mirrors.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "app/scene/place.hpp"
#include "app/setup/planes.hpp"
#include "app/setup/scene_builder.hpp"

namespace brunt {
namespace {

LoadedDeck deck_of(const std::string& body, const std::string& symmetry) {
  return load_deck_text(R"(
geometry: plane-strain
time: {end: 1 us}
materials: {al: {density: 2700 kg/m^3, elastic: {E: 70 GPa, nu: 0.3}}}
bodies:
  a: {method: sph, material: al, size: 1 mm, )" +
                            body + "}\nsymmetry: " + symmetry + "\n",
                        "mirrors.yaml");
}

/// The sums of the planes across x and y.
std::array<std::vector<Mirrors<2>::Sum>, 2> sums_on_planes(const std::string& body,
                                                           const std::string& symmetry) {
  const LoadedDeck loaded = deck_of(body, symmetry);
  const auto scene = build_scene<2>(loaded);
  const auto& points = scene->solids.front()->points();
  std::vector<Label> sums(1u + *std::max_element(points.piece.begin(), points.piece.end()));
  std::iota(sums.begin(), sums.end(), Label{0});
  const auto mirrors = mirrors_of(loaded, *scene, points, {1e-3}, sums);
  return {mirrors.plane[0].sums, mirrors.plane[1].sums};
}

std::string message_of(const std::string& body, const std::string& symmetry) {
  try {
    build_scene<2>(deck_of(body, symmetry));
  } catch (const DeckError& error) {
    return error.problems().front().message;
  }
  return "";
}

using Sums = std::vector<Mirrors<2>::Sum>;
const std::string kBox = "shape: {box: {min: [0, -3 mm], max: [4 mm, 0]}}";

TEST(MirrorsOfDeck, TellsTheSidesOfBodies) {
  EXPECT_EQ(sums_on_planes(kBox, "{x: 0, y: 0}"), (std::array<Sums, 2>{Sums{{0, 1}}, {{0, -1}}}));
  EXPECT_EQ(sums_on_planes(kBox, "{x: 4 mm}")[0], (Sums{{0, -1}}));
  EXPECT_EQ(sums_on_planes("lattice: hexagonal, " + kBox, "{x: 0}")[0], (Sums{{0, 1}}));
}

TEST(MirrorsOfDeck, LeavesOutWhatDoesNotTouch) {
  EXPECT_EQ(sums_on_planes(kBox, "{x: -0.5 mm, y: 2 mm}"), (std::array<Sums, 2>{}));
  const auto wall = sums_on_planes(
      "shape: {brick-wall: {bricks: [2, 2], brick: [4 mm, 2 mm], origin: [0, 0], course: x, bond: "
      "stack}}",
      "{x: 0}");
  EXPECT_EQ(wall[0].size(), 2u);  // of four bricks
}

TEST(MirrorsOfDeck, RefusesBodiesOnBothSidesAndOnThePlane) {
  EXPECT_EQ(message_of(kBox, "{x: 1 mm}"),
            "'a' lies on both sides of the plane: take the half of it away");
  EXPECT_EQ(message_of(kBox, "{x: 0.5 mm}").substr(0, 33), "particles of 'a' lie on the plane");
}

/// What check says of the planes, one after another.
std::vector<std::string> warnings_of(const std::string& body, const std::string& symmetry) {
  const LoadedDeck loaded = deck_of(body, symmetry);
  const auto scene = build_scene<2>(loaded);
  std::vector<std::string> said;
  warn_of_planes(loaded, *scene, boxes_of_bodies(*scene),
                 [&](const std::string& path, const std::string& what) {
                   said.push_back(path + ": " + what);
                 });
  return said;
}

TEST(MirrorsOfDeck, TellsOfPlanesThatHoldNothingOrNearlySo) {
  EXPECT_TRUE(warnings_of(kBox, "{x: 0, y: 0}").empty());
  EXPECT_EQ(
      warnings_of(kBox, "{x: 3}"),
      std::vector<std::string>{"symmetry.x: holds nothing: no body ends at this plane at time "
                               "0, and what comes to it goes through"});
  const auto near = warnings_of(kBox, "{x: -0.4 mm}");
  ASSERT_EQ(near.size(), 2u);
  EXPECT_EQ(near[0], "symmetry.x: 'a' ends 900 um from the plane and is not held by it");
  const auto off = warnings_of(kBox, "{x: 0.2 mm}");
  ASSERT_EQ(off.size(), 1u);
  EXPECT_EQ(off[0].substr(0, 66),
            "symmetry.x: the outer particles of 'a' stand 0.3 spacings from the");
}

// On the plane the images weigh as much as the particles: what changes its sign is 0 there, and
// what does not has the value of a lattice that goes on, exactly for what is even in x.
TEST(MirrorsOfDeck, PlacesBesideAPlaneSeeImages) {
  const LoadedDeck loaded = deck_of(kBox, "{x: 0}");
  const auto scene = build_scene<2>(loaded);
  const BodyView view = scene->view(0, {});
  ASSERT_TRUE(view.mirrors[0].has_value());
  const Place place = find_place(view, {0, -1.5e-3});
  std::vector<Real> odd, even, ones;
  for (std::size_t i = 0; i < view.position.size() / 3; ++i) {
    odd.push_back(view.position[3 * i]), even.push_back(view.position[3 * i + 1]);
    ones.push_back(1);
  }
  EXPECT_NEAR(value_at(place, odd, false, odd_axes("velocity.x")), 0, 1e-18);
  EXPECT_NEAR(value_at(place, odd, false, odd_axes("stress.xy")), 0, 1e-18);
  EXPECT_NEAR(value_at(place, even, false, odd_axes("velocity.y")), -1.5e-3, 1e-15);
  EXPECT_NEAR(value_at(place, ones, false, odd_axes("stress.xx")), 1, 1e-12);
  EXPECT_EQ(odd_axes("velocity.magnitude"), 0u);
}

}  // namespace
}  // namespace brunt
