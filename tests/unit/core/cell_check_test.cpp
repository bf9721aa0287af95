// What a mesh must not have is found, and named by its cell; what it may have is not.
#include "core/geometry/cell_check.hpp"

#include <gtest/gtest.h>

#include "core/elements/hex8.hpp"
#include "core/elements/quad4.hpp"

namespace brunt {
namespace {

/// nx x 1 x 1 unit cubes along x, or nx squares.
template <class Element>
CellMesh row(int nx) {
  constexpr int around = Element::kDim == 2 ? 2 : 4;
  CellMesh mesh;
  mesh.type = &kElementType<Element>;
  for (int i = 0; i <= nx; ++i) {
    mesh.nodes.emplace_back(i, 0, 0), mesh.nodes.emplace_back(i, 1, 0);
    if (around == 4) mesh.nodes.emplace_back(i, 1, 1), mesh.nodes.emplace_back(i, 0, 1);
  }
  for (int i = 0; i < nx; ++i) {
    const int a = around * i, b = a + around;
    if (around == 2) {
      mesh.corner.insert(mesh.corner.end(), {a, b, b + 1, a + 1});
    } else {
      mesh.corner.insert(mesh.corner.end(), {a, b, b + 1, a + 1, a + 3, b + 3, b + 2, a + 2});
    }
  }
  return mesh;
}

TEST(CellCheck, FindsNothingInASoundRow) {
  for (const CellMesh& mesh : {row<Quad4>(3), row<Hex8>(3)}) {
    const CellFindings findings = check_cells(mesh);
    EXPECT_TRUE(findings.sound());
    EXPECT_TRUE(findings.hinges.empty());
    EXPECT_EQ(findings.n_components, 1);
    EXPECT_DOUBLE_EQ(shortest_edge(mesh), 1);
    EXPECT_TRUE(coincident_nodes(mesh.nodes).empty());
    EXPECT_EQ(outer_faces(mesh).size(), mesh.type->dim == 2 ? 8u : 14u);
  }
}

TEST(CellCheck, FindsCollapsedFoldedAndInvertedCells) {
  CellMesh mesh = row<Hex8>(3);
  mesh.corner[8 + 1] = mesh.corner[8 + 2];
  EXPECT_EQ(check_cells(mesh).collapsed, std::vector<int>{1});
  for (int corner = 0; corner < 8; ++corner) {  // pushed through the middle of the cell
    CellMesh folded = row<Hex8>(1);
    Vec3& x =
        folded.nodes[static_cast<std::size_t>(folded.corner[static_cast<std::size_t>(corner)])];
    x = Vec3::Constant(0.5) - 0.6 * (x - Vec3::Constant(0.5));
    EXPECT_EQ(check_cells(folded).inverted, std::vector<int>{0}) << corner;
  }
  CellMesh turned = row<Hex8>(2);
  for (std::size_t c = 0; c < 4; ++c) std::swap(turned.corner[8 + c], turned.corner[12 + c]);
  EXPECT_EQ(check_cells(turned).inverted, std::vector<int>{1});
  CellMesh flat = row<Quad4>(2);
  flat.nodes[5] = Vec3(2, 0, 0);  // on its neighbour
  EXPECT_EQ(check_cells(flat).inverted, std::vector<int>{1});
  CellMesh clockwise = row<Quad4>(2);
  std::swap(clockwise.corner[0], clockwise.corner[2]);
  EXPECT_EQ(check_cells(clockwise).inverted, std::vector<int>{0});
}

TEST(CellCheck, FindsCellsThatAreThereTwiceAndFacesOfThree) {
  CellMesh mesh = row<Hex8>(2);
  const std::vector<int> again(mesh.corner.begin(), mesh.corner.begin() + 8);
  mesh.corner.insert(mesh.corner.end(), again.begin(), again.end());
  using Pair = std::array<int, 2>;
  EXPECT_EQ(check_cells(mesh).repeated, (std::vector<Pair>{{0, 2}}));
  CellMesh three = row<Quad4>(2);  // a third square on the side between the two
  three.nodes.emplace_back(1.5, -1, 0), three.nodes.emplace_back(0.4, -1, 0);
  three.nodes.emplace_back(0, 0.5, 0), three.nodes.emplace_back(0.2, 0.9, 0);
  three.corner.insert(three.corner.end(), {3, 2, 8, 9});
  three.nodes[8] = Vec3(2, -1, 0), three.nodes[9] = Vec3(3, 1, 0);
  using Three = std::array<int, 3>;
  EXPECT_EQ(check_cells(three).crowded, (std::vector<Three>{{0, 1, 2}}));
}

TEST(CellCheck, FindsHingesAndWhatIsApart) {
  CellMesh mesh = row<Quad4>(2);
  mesh.nodes.emplace_back(3, 1, 0), mesh.nodes.emplace_back(3, 2, 0),
      mesh.nodes.emplace_back(2, 2, 0);
  mesh.corner.insert(mesh.corner.end(), {5, 6, 7, 8});  // at the corner (2, 1) alone
  CellFindings findings = check_cells(mesh);
  EXPECT_TRUE(findings.sound());
  EXPECT_EQ(findings.hinges, std::vector<int>{5});
  EXPECT_EQ(findings.n_components, 1);
  mesh.nodes.emplace_back(2, 1, 0);
  mesh.corner[8] = 9;
  findings = check_cells(mesh);
  EXPECT_TRUE(findings.hinges.empty());
  EXPECT_EQ(findings.component, (std::vector<int>{0, 0, 1}));
  using Pair = std::array<int, 2>;
  EXPECT_EQ(coincident_nodes(mesh.nodes), (std::vector<Pair>{{5, 9}}));
}

TEST(CellCheck, OuterFacesLookOutwards) {
  const CellMesh mesh = row<Hex8>(2);
  const Vec3 middle(1, 0.5, 0.5);
  Real volume = 0;
  for (const auto& [a, b, c, d] : outer_faces(mesh)) {
    const auto at = [&](int i) { return mesh.nodes[static_cast<std::size_t>(i)]; };
    const Vec3 area = 0.5 * (at(c) - at(a)).cross(at(d) - at(b));
    const Vec3 center = 0.25 * (at(a) + at(b) + at(c) + at(d));
    EXPECT_GT(area.dot(center - middle), 0);
    volume += area.dot(center) / 3;
  }
  EXPECT_DOUBLE_EQ(volume, 2);
}

}  // namespace
}  // namespace brunt
