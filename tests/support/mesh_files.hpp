#pragma once
/// Texts of mesh files of one block of hexahedra, for tests of their readers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "io/mesh/mesh_file.hpp"
#include "tests/support/own_file.hpp"

namespace brunt::test {

/// n x n x n hexahedra of edge 1 from the origin, with the quadrilaterals at z = 0. Node i has the
/// number 10 i + 7; hexahedra are numbered from 1, the quadrilaterals go on. Both halves along z
/// are volumes 5 and 6 of the same physical group "block"; the faces, surface 3, are "foot".
struct BlockMesh {
  explicit BlockMesh(int count) : n(count) {
    const auto node = [&](int i, int j, int k) { return i + (n + 1) * (j + (n + 1) * k); };
    for (int k = 0; k <= n; ++k) {
      for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) nodes.emplace_back(i, j, k);
      }
    }
    for (int k = 0; k < n; ++k) {
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          std::array<int, 8> hex{};
          const int round[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
          for (std::size_t c = 0; c < 8; ++c) {
            hex[c] = node(i + round[c % 4][0], j + round[c % 4][1], k + (c < 4 ? 0 : 1));
          }
          hexes.push_back(hex);
          if (k == 0) quads.push_back({hex[0], hex[3], hex[2], hex[1]});
        }
      }
    }
  }
  static std::int64_t id(int node) { return 10 * std::int64_t{node} + 7; }

  int n;
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 8>> hexes;
  std::vector<std::array<int, 4>> quads;
};

/// Writes numbers as text, or as they lie in memory.
class MeshWriter {
 public:
  explicit MeshWriter(bool is_binary) : binary(is_binary) { out.precision(17); }
  void text(const std::string& line) { out << line << "\n"; }
  void int32(std::int64_t value) { put(static_cast<std::int32_t>(value)); }
  void int64(std::int64_t value) { put(value); }
  void real(Real value) { put(value); }
  void end_line() {
    if (!binary) out << "\n";
  }
  /// The end of a section's numbers.
  void end_numbers() {
    if (binary) out << "\n";
  }
  std::string str() const { return out.str(); }

  bool binary;

 private:
  template <class T>
  void put(T value) {
    if (binary) {
      out.write(reinterpret_cast<const char*>(&value), sizeof value);
    } else {
      out << value << " ";
    }
  }
  std::ostringstream out;
};

inline void write_gmsh_head(MeshWriter& out, const char* version) {
  out.text("$MeshFormat");
  out.text(std::string(version) + (out.binary ? " 1 8" : " 0 8"));
  if (out.binary) out.int32(1), out.text("");
  out.text("$EndMeshFormat");
  out.text("$PhysicalNames\n2\n2 9 \"foot\"\n3 4 \"block\"\n$EndPhysicalNames");
}

/// The block as Gmsh 2.2 writes it.
inline std::string gmsh2_text(const BlockMesh& block, bool binary) {
  MeshWriter out(binary);
  write_gmsh_head(out, "2.2");
  out.text("$Nodes");
  out.text(std::to_string(block.nodes.size()));
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    out.int32(BlockMesh::id(static_cast<int>(i)));
    for (int c = 0; c < 3; ++c) out.real(block.nodes[i][c]);
    out.end_line();
  }
  out.end_numbers();
  out.text("$EndNodes\n$Elements");
  out.text(std::to_string(block.hexes.size() + block.quads.size()));
  std::int64_t id = 1;
  const auto element = [&](const auto& corners, int type, int group, int entity) {
    if (!binary) out.int64(id);
    out.int32(type);
    if (binary) out.int32(1);
    out.int32(2);
    if (binary) out.int32(id);
    ++id;
    out.int32(group), out.int32(entity);
    for (const int corner : corners) out.int32(BlockMesh::id(corner));
    out.end_line();
  };
  for (const auto& hex : block.hexes) {
    element(hex, 5, 4, block.nodes[static_cast<std::size_t>(hex[0])][2] < 0.5 * block.n ? 5 : 6);
  }
  for (const auto& quad : block.quads) element(quad, 3, 9, 3);
  out.end_numbers();
  out.text("$EndElements");
  return out.str();
}

/// The block as Gmsh 4.1 writes it.
inline std::string gmsh4_text(const BlockMesh& block, bool binary) {
  MeshWriter out(binary);
  write_gmsh_head(out, "4.1");
  out.text("$Entities");
  for (const int count : {1, 0, 1, 2}) out.int64(count);
  out.end_line();
  const auto entity = [&](int dim, int tag, int group) {
    out.int32(tag);
    for (int c = 0; c < (dim == 0 ? 3 : 6); ++c) out.real(c < 3 ? 0 : block.n);
    out.int64(group == 0 ? 0 : 1);
    if (group != 0) out.int32(group);
    if (dim > 0) out.int64(1), out.int32(-2);
    out.end_line();
  };
  entity(0, 1, 0), entity(2, 3, 9), entity(3, 5, 4), entity(3, 6, 4);
  out.end_numbers();
  out.text("$EndEntities\n$Nodes");
  const auto n_nodes = static_cast<std::int64_t>(block.nodes.size());
  for (const std::int64_t count : {std::int64_t{1}, n_nodes, std::int64_t{7}, 10 * n_nodes}) {
    out.int64(count);
  }
  out.end_line();
  out.int32(3), out.int32(5), out.int32(0), out.int64(n_nodes), out.end_line();
  for (int i = 0; i < n_nodes; ++i) out.int64(BlockMesh::id(i)), out.end_line();
  for (const Vec3& x : block.nodes) {
    for (int c = 0; c < 3; ++c) out.real(x[c]);
    out.end_line();
  }
  out.end_numbers();
  out.text("$EndNodes\n$Elements");
  const auto half = block.hexes.size() / 2;
  const auto n_cells = static_cast<std::int64_t>(block.hexes.size() + block.quads.size());
  for (const std::int64_t count : {std::int64_t{3}, n_cells, std::int64_t{1}, n_cells}) {
    out.int64(count);
  }
  out.end_line();
  std::int64_t id = 1;
  const auto head = [&](int dim, int tag, int type, std::size_t count) {
    out.int32(dim), out.int32(tag), out.int32(type), out.int64(static_cast<std::int64_t>(count));
    out.end_line();
  };
  const auto element = [&](const auto& corners) {
    out.int64(id++);
    for (const int corner : corners) out.int64(BlockMesh::id(corner));
    out.end_line();
  };
  head(3, 5, 5, half);
  for (std::size_t e = 0; e < half; ++e) element(block.hexes[e]);
  head(3, 6, 5, block.hexes.size() - half);
  for (std::size_t e = half; e < block.hexes.size(); ++e) element(block.hexes[e]);
  head(2, 3, 3, block.quads.size());
  for (const auto& quad : block.quads) element(quad);
  out.end_numbers();
  out.text("$EndElements");
  return out.str();
}

/// The block as an input file of Abaqus: its set of elements in two, one from a range; its faces as
/// a set of nodes, "foot", and as a surface, "base".
inline std::string abaqus_text(const BlockMesh& block) {
  std::ostringstream out;
  out << "*HEADING\na block\n** its nodes\n*Node, nset=all\n";
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    const Vec3& x = block.nodes[i];
    out << BlockMesh::id(static_cast<int>(i)) << ", " << x[0] << "., " << x[1] << "., " << x[2]
        << ".\n";
  }
  out << "*Element, type=C3D8R, elset=first\n";
  for (std::size_t e = 0; e < block.hexes.size(); ++e) {
    out << e + 1;
    for (std::size_t c = 0; c < 8; ++c) {
      out << "," << (c == 5 ? "\n  " : " ") << BlockMesh::id(block.hexes[e][c]);
    }
    out << "\n";
    if (e == 0) out << "*Element, type=C3D8R\n";
  }
  out << "*Elset, elset=rest, generate\n1, " << block.hexes.size() << ", 1\n";
  out << "*Elset, elset=block\n rest, first\n*Nset, nset=foot\n";
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    if (block.nodes[i][2] == 0) out << BlockMesh::id(static_cast<int>(i)) << ",\n";
  }
  out << "*Surface, name=base, type=ELEMENT\n";
  for (std::size_t e = 0; e < block.quads.size(); ++e) out << e + 1 << ", S1\n";
  out << "*Material, name=steel\n*Density\n7850.,\n*Step\n*End step\n";
  return out.str();
}

/// The block as a keyword file of LS-DYNA, in columns; its faces are a set of segments, "foot".
inline std::string dyna_text(const BlockMesh& block) {
  std::ostringstream out;
  const auto columns = [&](int width, std::int64_t value) {
    const std::string text = std::to_string(value);
    out << std::string(static_cast<std::size_t>(width) - text.size(), ' ') << text;
  };
  out << "*KEYWORD\n*TITLE\na block\n*PART\nblock\n";
  columns(10, 4), columns(10, 1), columns(10, 1);
  out << "\n*NODE\n$    nid               x\n";
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    columns(8, BlockMesh::id(static_cast<int>(i)));
    for (int c = 0; c < 3; ++c)
      columns(14, static_cast<std::int64_t>(block.nodes[i][c])), out << ".0";
    out << "       0       0\n";
  }
  out << "*ELEMENT_SOLID\n";
  for (std::size_t e = 0; e < block.hexes.size(); ++e) {
    columns(8, static_cast<std::int64_t>(e) + 1), columns(8, 4);
    if (e % 2 == 1) out << "\n";  // both ways to write it
    for (const int corner : block.hexes[e]) columns(8, BlockMesh::id(corner));
    out << "\n";
  }
  out << "*SET_SEGMENT_TITLE\nfoot\n";
  columns(10, 9), out << "\n";
  for (const auto& quad : block.quads) {
    for (const int corner : quad) columns(10, BlockMesh::id(corner));
    out << "\n";
  }
  out << "*MAT_ELASTIC\n         1    7850.0\n*END\nwhat follows is not read\n";
  return out.str();
}

inline std::string write_file(const std::string& name, const std::string& bytes) {
  const std::string path = own_file(name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

/// Expects what every reader makes of the block: nodes, cells, and its two sets.
inline void expect_block(const MeshFile& mesh, const BlockMesh& block) {
  ASSERT_EQ(mesh.nodes.size(), block.nodes.size());
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    EXPECT_EQ(mesh.nodes[i], block.nodes[i]);
    EXPECT_EQ(mesh.node_id[i], BlockMesh::id(static_cast<int>(i)));
  }
  const MeshSet* solid = mesh.find("block");
  const MeshSet* foot = mesh.find("foot");
  ASSERT_NE(solid, nullptr);
  ASSERT_NE(foot, nullptr);
  ASSERT_EQ(solid->cells.size(), block.hexes.size());
  for (std::size_t e = 0; e < block.hexes.size(); ++e) {
    const auto cell = static_cast<std::size_t>(solid->cells[e]);
    EXPECT_EQ(mesh.kind[cell], CellKind::hex8);
    const auto corners = mesh.corners(cell);
    ASSERT_EQ(corners.size(), 8u);
    EXPECT_TRUE(std::equal(corners.begin(), corners.end(), block.hexes[e].begin()));
  }
}

/// Mutations of a file, 300 of a fixed seed or as many as BRUNT_MUTATIONS says: bytes changed,
/// numbers changed, parts cut out, doubled or moved. `read` must return or throw
/// std::runtime_error or std::invalid_argument; anything else fails the test, or ends it.
inline void mutate(const std::string& name, const std::string& bytes,
                   const std::function<void(const std::string& path)>& read) {
  const char* asked = std::getenv("BRUNT_MUTATIONS");
  const int count = asked ? std::atoi(asked) : 300;
  std::mt19937 random(20240611);
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  int refused = 0;
  for (int m = 0; m < count; ++m) {
    std::string changed = bytes;
    for (std::size_t times = 1 + below(4); times > 0; --times) {
      const std::size_t at = below(changed.size()), length = below(40);
      switch (below(6)) {
        case 0:
          changed[at] = static_cast<char>(random());
          break;
        case 1:
          changed[at] = "0123456789-+.e \n,*$"[below(19)];
          break;
        case 2:
          changed.erase(at, length);
          break;
        case 3:
          changed.insert(at, changed.substr(below(changed.size()), length));
          break;
        case 4:
          changed.resize(at);
          break;
        default: {
          static const char* kNumbers[] = {
              "-1",  "0",          "99999999999",          "1e999",
              "nan", "2147483648", "-9223372036854775808", "9223372036854775807",
              "3"};
          const std::size_t digit = changed.find_first_of("0123456789", at);
          if (digit == std::string::npos) break;
          const std::size_t end = changed.find_first_not_of("0123456789.", digit);
          changed.replace(digit, std::min(end, changed.size()) - digit, kNumbers[below(9)]);
        }
      }
      if (changed.empty()) changed = " ";
    }
    const std::string path = write_file(std::to_string(m) + name, changed);
    try {
      read(path);
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()), "");
      ++refused;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()), "");
      ++refused;
    }
    std::remove(path.c_str());
  }
  EXPECT_GT(refused, count / 4) << "mutations that break nothing test nothing";
}

/// Expects that a reader, given these bytes, throws a message with all of these words.
inline void expect_refused(MeshFile (*read)(const std::string&), const std::string& name,
                           const std::string& bytes, const std::vector<std::string>& words) {
  const std::string path = write_file(name, bytes);
  try {
    read(path);
    FAIL() << "was read: " << words.front();
  } catch (const std::runtime_error& error) {
    for (const std::string& word : words) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << "'" << word << "' is not in: " << error.what();
    }
  }
}

/// bytes with the first `from` replaced by `to`.
inline std::string with(std::string bytes, const std::string& from, const std::string& to) {
  const std::size_t at = bytes.find(from);
  if (at == std::string::npos) throw std::logic_error("no '" + from + "' in the file");
  return bytes.replace(at, from.size(), to);
}

}  // namespace brunt::test
