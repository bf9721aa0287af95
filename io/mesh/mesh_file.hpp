#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// What a cell of a mesh file is. Corners are numbered as in Quad4, Hex8 and Tet4; of the `higher`
/// kinds (of more nodes than corners, by dimension) none are kept, nor of `other`: elements of a
/// type that no kind stands for, which no body takes.
enum class CellKind : std::uint8_t {
  point1,
  line2,
  higher1,
  tri3,
  quad4,
  higher2,
  tet4,
  pyramid5,
  wedge6,
  hex8,
  higher3,
  other
};
struct CellKindInfo {
  const char* name;  ///< in messages, plural
  int dim;
  int corners;
};
const CellKindInfo& info(CellKind kind);

/// A named set: cells, nodes, or both where a file has two of one name.
struct MeshSet {
  std::string name;
  std::vector<int> cells;
  std::vector<int> nodes;
};

/// What the reader of a mesh file fills: everything the file has, in its unit of length. Indices
/// count from 0 in the file's order; ids are the file's own numbers.
struct MeshFile {
  std::string path;
  std::vector<Vec3> nodes;
  std::vector<std::int64_t> node_id;
  std::vector<int> node_line;  ///< of the file; 0: it has none. Empty: none has

  std::vector<CellKind> kind;  ///< of each cell
  std::vector<std::int64_t> cell_id;
  std::vector<int> cell_line;         ///< as node_line
  std::vector<std::size_t> first{0};  ///< corners of cell c: corner[first[c]] to corner[first[c+1]]
  std::vector<int> corner;            ///< nodes

  std::vector<MeshSet> sets;
  /// The file's names of types that are `other`, by the first cell of each, ascending.
  std::vector<std::pair<std::size_t, std::string>> other_types;
  std::vector<std::string> notes;        ///< of elements that were passed over
  std::vector<std::string> unread_sets;  ///< keywords of sets that are not among `sets`, with lines

  std::size_t n_cells() const { return kind.size(); }
  std::span<const int> corners(std::size_t cell) const {
    return {corner.data() + first[cell], first[cell + 1] - first[cell]};
  }
  void add_node(std::int64_t id, const Vec3& x, int line = 0);
  /// Corners are as the file has them: ids, until resolve_corners.
  void add_cell(CellKind of, std::int64_t id, std::span<const std::int64_t> corner_ids,
                int line = 0);
  /// The set of a name; a new one where there is none.
  MeshSet& set(const std::string& name);
  const MeshSet* find(const std::string& name) const;
  /// "element 7 (part.msh:120)", "node 5"; of `other`: "element 7 (part.inp:12) of TYPE=COH3D8".
  std::string cell_name(std::size_t cell) const;
  std::string node_name(std::size_t node) const;

  /// "part.msh:120", of a line of the file.
  std::string place(int line) const;

  /// Turns ids of corners into indices, when all nodes and cells are there. Throws
  /// std::runtime_error where two nodes have one id, a cell has a node that the file has not, or a
  /// coordinate is not finite.
  void resolve_corners();

 private:
  std::vector<std::int64_t> corner_id_;
};

/// Indices of things by their ids: a table where ids are dense, else sorted.
class IdTable {
 public:
  /// ids  outlive the table
  explicit IdTable(const std::vector<std::int64_t>& ids);
  /// -1: there is none.
  int operator[](std::int64_t id) const;
  /// The first that has the id of one before it; -1: all differ.
  int repeated() const { return repeated_; }

 private:
  const std::vector<std::int64_t>& ids_;
  std::int64_t low_ = 0;
  std::vector<int> dense_;   // by id - low_
  std::vector<int> sorted_;  // by id
  int repeated_ = -1;
};

/// The named sets of a file with what they hold, for messages: "'wall' (80 hexahedra), 'foot' (9
/// nodes)"; at most a dozen. Those that were not read follow by their keywords.
std::string set_list(const MeshFile& mesh);

}  // namespace brunt
// Tested by tests/unit/io/gmsh_test.cpp.
