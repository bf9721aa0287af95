// STL files, text and binary: the same tetrahedron of four corners and four triangles from both.
#include "io/stl.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include "tests/support/own_file.hpp"

namespace brunt {
namespace {

const std::vector<std::array<Vec3, 3>> kTetrahedron = {
    {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0)},
    {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0.1)},
    {Vec3(0, 0, 0), Vec3(0, 0, 0.1), Vec3(0, 1, 0)},
    {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0.1)}};

std::string write(const std::string& name, const std::string& bytes) {
  const std::string path = test::own_file(name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::string text_of(const std::vector<std::array<Vec3, 3>>& triangles) {
  std::ostringstream out;
  out << "solid part\n";
  for (const auto& triangle : triangles) {
    out << "  facet normal 0 0 0\n    outer loop\n";
    for (const Vec3& x : triangle) out << "      vertex " << x.transpose() << "\n";
    out << "    endloop\n  endfacet\n";
  }
  out << "endsolid part\n";
  return out.str();
}

/// header  of 80 characters at most
std::string binary_of(const std::vector<std::array<Vec3, 3>>& triangles, std::string header) {
  header.resize(80, ' ');
  const auto put = [&](const auto& value) {
    header.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& triangle : triangles) {
    for (int c = 0; c < 3; ++c) put(0.0F);
    for (const Vec3& x : triangle) {
      for (int c = 0; c < 3; ++c) put(static_cast<float>(x[c]));
    }
    put(static_cast<std::uint16_t>(0));
  }
  return header;
}

void expect_tetrahedron(const StlSurface& surface, Real z) {
  ASSERT_EQ(surface.nodes.size(), 4u);
  ASSERT_EQ(surface.triangles.size(), 4u);
  EXPECT_EQ(surface.degenerate, 0u);
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 wanted = kTetrahedron[t][c];
      if (wanted[2] != 0) wanted[2] = z;
      EXPECT_EQ(surface.nodes[static_cast<std::size_t>(surface.triangles[t][c])], wanted);
    }
  }
}

TEST(Stl, ReadsText) { expect_tetrahedron(read_stl(write("a.stl", text_of(kTetrahedron))), 0.1); }

// Numbers of a binary file are single; one that begins as text does is known by its size.
TEST(Stl, ReadsBinary) {
  for (const char* header : {"made by a program", "solid part"}) {
    const auto surface = read_stl(write("b.stl", binary_of(kTetrahedron, header)));
    expect_tetrahedron(surface, static_cast<Real>(0.1F));
  }
}

TEST(Stl, LeavesOutTrianglesWithoutArea) {
  auto triangles = kTetrahedron;
  triangles.push_back({Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 1, 0)});
  triangles.push_back({Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 0.5, 0)});
  triangles.push_back({Vec3(-0.0, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -0.0)});
  const auto surface = read_stl(write("c.stl", text_of(triangles)));
  EXPECT_EQ(surface.triangles.size(), 4u);
  EXPECT_EQ(surface.degenerate, 3u);
}

std::string message_of(const std::string& path) {
  try {
    read_stl(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Stl, SaysWhereAFileIsWrong) {
  const auto has = [](const std::string& path, const std::string& part) {
    const std::string message = message_of(path);
    EXPECT_EQ(message.rfind(path, 0), 0u) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  has(test::own_file("none.stl"), "no such file");
  has(write("d.stl", ""), "no triangle");
  has(write("e.stl", "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0\n"), ":4: a vertex has");
  has(write("f.stl", "solid a\nfacet normal 0 0 0\nvertex 0 0 0\nendfacet\n"), ":4: the triangle");
  has(write("g.stl", "solid a\nfacet normal 0 0 0\nvertex 0 0 0\n"), "ends inside");
  has(write("h.stl", "solid a\nhello\n"), ":2: 'hello'");
  has(write("i.stl", binary_of(kTetrahedron, "x").substr(0, 200)), "cut off");
  auto bad = kTetrahedron;
  bad[1][2][0] = std::nan("");
  has(write("j.stl", binary_of(bad, "x")), "triangle 2 is no number");
}

}  // namespace
}  // namespace brunt
