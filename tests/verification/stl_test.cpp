// Bodies from STL files: an L of three cubes of 1 mm, 28 triangles. Its mass is that of 3 mm^3, its
// centre the mean of the cubes' centres, (5/6, 5/6, 1/2) mm, whether particles fill it (their mass
// is scaled to the volume of the triangles, and a lattice of 8 layers a cube is even in each) or
// its surface is that of a rigid body, of which every triangle counts.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/support/own_file.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

enum class Fault { none, open, folded };

/// Writes the L, less the last of its triangles where it is open, or with the two of its first side
/// upside down where it is folded; the name of the file.
std::string write_letter(const std::string& name, Fault fault = Fault::none) {
  const Vec<2> outline[] = {{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}};
  std::vector<std::array<Vec3, 3>> triangles;
  const auto at = [&](int i, Real z) { return Vec3(outline[i][0], outline[i][1], z); };
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    triangles.push_back({at(i, 0), at(j, 0), at(j, 1)});
    triangles.push_back({at(i, 0), at(j, 1), at(i, 1)});
    if (i == 0 || j == 0) continue;
    triangles.push_back({at(0, 0), at(j, 0), at(i, 0)});
    triangles.push_back({at(0, 1), at(i, 1), at(j, 1)});
  }
  if (fault == Fault::open) triangles.pop_back();
  if (fault == Fault::folded) {
    for (const std::size_t i : {0, 1}) std::swap(triangles[i][1], triangles[i][2]);
  }
  const std::string path = test::own_file(name);
  std::ofstream file(path);
  file << "solid letter\n";
  for (const auto& triangle : triangles) {
    file << "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& x : triangle) file << "vertex " << x.transpose() << "\n";
    file << "endloop\nendfacet\n";
  }
  file << "endsolid letter\n";
  return path;
}

std::string deck(const std::string& path, const std::string& method) {
  return "time: {end: 1 us}\nmaterials:\n"
         "  steel: {density: 8000 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}\nbodies:\n"
         "  letter: {material: steel, file: " +
         path + ", scale: 1 mm, rotate: {axis: z, angle: 90 deg}, translate: [5 mm, 0, 0], " +
         method + "}\n";
}

TEST(Stl, ParticlesAndRigidBodiesHaveItsMassAndCentre) {
  const std::string path = write_letter("letter.stl");
  for (const std::string method : {"method: sph, size: 0.125 mm", "rigid: true"}) {
    const auto run = simulate_text(deck(path, method));
    ASSERT_EQ(run.failure, "") << method;
    const Real mass = 8000 * 3e-9;
    EXPECT_NEAR(run.first("body.letter.mass"), mass, 1e-13 * mass) << method;
    // Turned by 90 degrees: (x, y) becomes (-y, x).
    EXPECT_NEAR(run.first("body.letter.position.x"), 5e-3 - 5.0 / 6 * 1e-3, 1e-15) << method;
    EXPECT_NEAR(run.first("body.letter.position.y"), 5.0 / 6 * 1e-3, 1e-15) << method;
    EXPECT_NEAR(run.first("body.letter.position.z"), 0.5e-3, 1e-15) << method;
  }
}

TEST(Stl, AnOpenSurfaceIsRefusedWithItsPlace) {
  const std::string path = write_letter("open.stl", Fault::open);
  try {
    simulate_text(deck(path, "method: sph, size: 0.125 mm"));
    FAIL() << "an open surface was filled";
  } catch (const DeckError& error) {
    ASSERT_EQ(error.problems().size(), 1u);
    EXPECT_EQ(error.problems().front().path, "bodies.letter.file");
    EXPECT_EQ(error.problems().front().place.line, 5);
    EXPECT_NE(error.problems().front().message.find("the surface is open"), std::string::npos);
  }
}

/// The side x = 1 mm, y 1 .. 2 mm of which both triangles are upside down meets four others at its
/// four edges: a rigid body, whose surface may be open, is refused there as well as a filled one.
TEST(Stl, AFoldedSurfaceIsRefusedWithItsPlace) {
  const std::string path = write_letter("folded.stl", Fault::folded);
  for (const std::string method : {"method: sph, size: 0.125 mm", "rigid: true"}) {
    try {
      simulate_text(deck(path, method));
      ADD_FAILURE() << "a folded surface was taken: " << method;
    } catch (const DeckError& error) {
      ASSERT_EQ(error.problems().size(), 1u) << method;
      const auto& problem = error.problems().front();
      EXPECT_EQ(problem.path, "bodies.letter.file") << method;
      EXPECT_EQ(problem.place.line, 5) << method;
      EXPECT_NE(problem.message.find("at 4 edges neighbouring triangles face opposite ways, the "
                                     "first from (0.001, 0.001, 0)"),
                std::string::npos)
          << problem.message;
    }
  }
}

/// An L without one of its triangles is open, and not folded.
TEST(Stl, AnOpenSurfaceMayBeRigid) {
  const std::string path = write_letter("open_rigid.stl", Fault::open);
  EXPECT_EQ(simulate_text(deck(path, "rigid: true")).failure, "");
}

}  // namespace
}  // namespace brunt::test
