// A body from a mesh file is the body of the same elements from a shape: a block of 4 x 4 x 4
// hexahedra that flies at 50 m/s and is held by one of its faces, chosen as a named set of the file
// and as a side of the shape. Coordinates come from the file's numbers or from divisions, and
// differ by rounding; so do the runs. Restarted in the middle, it keeps every bit.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/mesh_files.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

std::string block_deck(const std::string& body, const std::string& where) {
  return R"(
time: {end: 4 us}
materials:
  copper:
    density: 8960 kg/m^3
    elastic: {E: 124 GPa, nu: 0.34}
    strength: {j2: {yield: 90 MPa, hardening: 300 MPa}}
bodies:
  block: {material: copper, velocity: [0, 10 m/s, 50 m/s], )" +
         body + R"(}
boundaries:
  foot: {body: block, where: )" +
         where + R"(, fix: [x, y, z]}
output: {history: 1 us}
)";
}

const std::string kShape =
    "shape: {box: {min: [0, 0, 0], max: [4 mm, 4 mm, 4 mm]}}, cells: [4, 4, 4]";

void expect_same(const Simulation& a, const Simulation& b) {
  ASSERT_EQ(a.failure + b.failure, "");
  ASSERT_EQ(a.steps, b.steps);
  for (const char* column : {"energy.kinetic", "energy.internal", "body.block.velocity.z"}) {
    EXPECT_NEAR(a.last(column) / b.last(column), 1, 1e-9) << column;
  }
}

TEST(MeshFile, MakesTheBodyThatItsShapeMakes) {
  const BlockMesh block(4);
  const auto shape = simulate_text(block_deck(kShape, "{side: min-z}"));
  const std::string gmsh = write_file("block.msh", gmsh4_text(block, true));
  const std::string body = "scale: 1 mm, part: block, file: ";
  expect_same(simulate_text(block_deck(body + gmsh, "{set: foot}")), shape);
  const std::string abaqus = write_file("block.inp", abaqus_text(block));
  expect_same(simulate_text(block_deck(body + abaqus, "{set: base}")), shape);
  const std::string dyna = write_file("block.k", dyna_text(block));
  expect_same(simulate_text(block_deck(body + dyna, "{set: foot}")), shape);
}

TEST(MeshFile, GoesOnFromACheckpointBitForBit) {
  const std::string file = write_file("block.msh", gmsh2_text(BlockMesh(4), false));
  const std::string deck = block_deck("scale: 1 mm, file: " + file, "{set: foot}");
  const auto whole = simulate_text(deck);
  RunVariation split;
  split.split_at = 11;
  EXPECT_EQ(simulate_text(deck, {}, split).hashes, whole.hashes);
}

// A set that is not there is named, with those that are.
TEST(MeshFile, RefusesABoundaryOnAnUnknownSet) {
  const std::string file = write_file("block.msh", gmsh2_text(BlockMesh(1), false));
  try {
    simulate_text(block_deck("scale: 1 mm, file: " + file, "{set: feet}"));
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find("its sets are 'block', 'foot'"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace brunt::test
