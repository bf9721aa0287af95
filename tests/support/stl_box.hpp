#pragma once
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <utility>

#include "core/types.hpp"
#include "tests/support/own_file.hpp"

namespace brunt::test {

/// Writes a box of twelve triangles, in millimetres, among the test's files; its path.
/// outward  its triangles run counter-clockwise seen from outside
inline std::string write_stl_box(const std::string& name, const Vec3& least, const Vec3& most,
                                 bool outward = true) {
  const auto corner = [&](int k) {
    return Vec3((k & 1) != 0 ? most[0] : least[0], (k & 2) != 0 ? most[1] : least[1],
                (k & 4) != 0 ? most[2] : least[2]);
  };
  const std::array<int, 4> sides[] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::string path = own_file(name + ".stl");
  std::ofstream file(path);
  file << "solid " << name << "\n";
  for (const auto& side : sides) {
    for (auto three : {std::array{0, 1, 2}, {0, 2, 3}}) {
      if (!outward) std::swap(three[0], three[2]);
      file << "facet normal 0 0 0\nouter loop\n";
      for (const int i : three) {
        file << "vertex " << corner(side[static_cast<std::size_t>(i)]).transpose() << "\n";
      }
      file << "endloop\nendfacet\n";
    }
  }
  file << "endsolid " << name << "\n";
  return path;
}

}  // namespace brunt::test
