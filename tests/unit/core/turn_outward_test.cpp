// Surfaces face away from what they bound, however a file has them. A box a x b x c that faces
// outwards has the volume abc by the divergence theorem, and minus that where it faces inwards; a
// hollow counts with the other sign.
#include "core/geometry/one_side.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brunt {
namespace {

using Faces = std::vector<std::array<int, 4>>;

struct Boxes {
  std::vector<Vec3> nodes;
  Faces faces;

  /// A box of quads, or of triangles.
  void add(const Vec3& low, const Vec3& size, bool outward, bool quads = true) {
    const int first = static_cast<int>(nodes.size());
    for (int k = 0; k < 8; ++k) {
      nodes.push_back(low + Vec3(k & 1, (k >> 1) & 1, k >> 2).cwiseProduct(size));
    }
    for (std::array<int, 4> face : Faces{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      for (int& node : face) node += first;
      if (!outward) std::swap(face[0], face[2]);
      const auto& [a, b, c, d] = face;
      if (quads) {
        faces.push_back(face);
      } else {
        faces.insert(faces.end(), {{a, b, c, -1}, {a, c, d, -1}});
      }
    }
  }
  /// Nodes at the same place become one.
  void merge() {
    for (auto& face : faces) {
      for (int& node : face) {
        if (node < 0) continue;
        node = static_cast<int>(std::find(nodes.begin(), nodes.end(), nodes[slot_of(node)]) -
                                nodes.begin());
      }
    }
  }
  Real volume() const {
    Real sum = 0;
    for (const auto& [a, b, c, d] : faces) {
      const auto at = [&](int node) { return nodes[slot_of(node)]; };
      sum += at(a).dot(at(b).cross(at(c))) / 6;
      if (d >= 0) sum += at(a).dot(at(c).cross(at(d))) / 6;
    }
    return sum;
  }
};

TEST(TurnOutward, EachShellByItself) {
  for (const bool quads : {true, false}) {
    Boxes boxes;
    boxes.add({0, 0, 0}, {1, 2, 3}, false, quads);
    boxes.add({4, 0, 0}, {1, 1, 1}, true, quads);
    boxes.add({-9, 5, 1}, {2, 1, 1}, false, quads);
    const auto result = turn_outward(boxes.nodes, boxes.faces);
    EXPECT_EQ(result.closed, 3U);
    EXPECT_EQ(result.turned, 2U);
    EXPECT_NEAR(boxes.volume(), 6 + 1 + 2, 1e-12);
    EXPECT_EQ(turn_outward(boxes.nodes, boxes.faces).turned, 0U);
  }
}

TEST(TurnOutward, HollowsFaceTheHollow) {
  for (const bool outward : {true, false}) {
    Boxes boxes;  // a wall about a hollow, in which there is a core
    boxes.add({0, 0, 0}, {5, 5, 5}, outward);
    boxes.add({1, 1, 1}, {3, 3, 3}, !outward);
    boxes.add({2, 2, 2}, {1, 1, 1}, outward);
    EXPECT_EQ(turn_outward(boxes.nodes, boxes.faces).turned, outward ? 0U : 3U);
    EXPECT_NEAR(boxes.volume(), 125 - 27 + 1, 1e-12);
  }
}

TEST(TurnOutward, ShellsThatOverlapAreNoHollows) {
  Boxes boxes;
  boxes.add({0, 0, 0}, {2, 2, 2}, true);
  boxes.add({1, 0.5, 0.5}, {2, 1, 1}, false);
  EXPECT_EQ(turn_outward(boxes.nodes, boxes.faces).turned, 1U);
  EXPECT_NEAR(boxes.volume(), 8 + 2, 1e-12);
}

TEST(TurnOutward, BoxesThatTouchAlongAnEdgeAreTwo) {
  for (const bool quads : {true, false}) {
    for (const bool large_outward : {true, false}) {
      for (const bool small_outward : {true, false}) {
        Boxes boxes;
        boxes.add({0, 0, 0}, {2, 2, 1}, large_outward, quads);
        boxes.add({2, 2, 0}, {1, 1, 1}, small_outward, quads);
        boxes.merge();
        const auto result = turn_outward(boxes.nodes, boxes.faces);
        EXPECT_EQ(result.closed, 2U);
        EXPECT_EQ(result.turned, (large_outward ? 0U : 1U) + (small_outward ? 0U : 1U));
        EXPECT_NEAR(boxes.volume(), 4 + 1, 1e-12);
      }
    }
  }
}

// An edge of the hollow on one of the wall, with nodes of its own elsewhere: a wedge in the corner.
TEST(TurnOutward, HollowsThatTouchTheWallAlongAnEdge) {
  for (const bool outward : {true, false}) {
    Boxes boxes;
    boxes.add({0, 0, 0}, {4, 4, 1}, outward);
    const int first = static_cast<int>(boxes.nodes.size());
    for (const Real z : {0.0, 1.0}) {  // touches the edge x = y = 0 alone
      for (const auto& [x, y] : {std::pair{1.0, 0.5}, {1.0, 1.0}, {0.5, 1.0}}) {
        boxes.nodes.emplace_back(x, y, 0.25 + 0.5 * z);
      }
    }
    const int low = 0, high = 4;  // nodes of the wall at x = y = 0
    Faces hollow{{low, first, first + 1, first + 2},
                 {high, first + 5, first + 4, first + 3},
                 {low, high, first + 3, first},
                 {first, first + 3, first + 4, first + 1},
                 {first + 1, first + 4, first + 5, first + 2},
                 {first + 2, first + 5, high, low}};
    if (!outward) {
      for (auto& face : hollow) std::swap(face[0], face[2]);
    }
    boxes.faces.insert(boxes.faces.end(), hollow.begin(), hollow.end());
    const Real before = boxes.volume();
    const auto result = turn_outward(boxes.nodes, boxes.faces);
    EXPECT_EQ(result.closed, 2U);
    EXPECT_EQ(result.turned, outward ? 0U : 2U);
    EXPECT_NEAR(boxes.volume(), std::fabs(before), 1e-12);
    EXPECT_LT(boxes.volume(), 16);
  }
}

TEST(TurnOutward, BoxesThatShareAFaceStay) {
  Boxes boxes;
  boxes.add({0, 0, 0}, {1, 1, 1}, true);
  boxes.add({1, 0, 0}, {1, 1, 1}, true);
  boxes.merge();
  EXPECT_EQ(turn_outward(boxes.nodes, boxes.faces).turned, 0U);
  EXPECT_NEAR(boxes.volume(), 2, 1e-12);
}

TEST(TurnOutward, OpenShellsAndSheetsStay) {
  Boxes boxes;
  boxes.add({0, 0, 0}, {1, 1, 1}, false);
  boxes.faces.pop_back();
  boxes.add({3, 0, 0}, {1, 1, 0}, false);
  const Faces before = boxes.faces;
  const auto result = turn_outward(boxes.nodes, boxes.faces);
  EXPECT_EQ(result.closed, 0U);
  EXPECT_EQ(result.turned, 0U);
  EXPECT_EQ(boxes.faces, before);
}

}  // namespace
}  // namespace brunt
