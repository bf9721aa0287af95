#pragma once
/// Sets and surfaces of Abaqus: as they are written, and as sets of a mesh.
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "io/mesh/abaqus_keyword.hpp"
#include "io/mesh/mesh_file.hpp"

namespace brunt {

/// A set as it is written: of ids, ranges of them, and other sets.
struct AbaqusSet {
  struct Range {
    std::int64_t from, to, step;
  };
  struct Use {
    AbaqusLabel set;
    int line;
  };
  std::string name;  ///< as it is written first
  std::vector<std::int64_t> ids;
  std::vector<Range> ranges;
  std::vector<Use> sets;
  std::vector<Use> of_elements;  ///< sets of elements whose nodes it has
};

/// A surface: faces of elements, or, of TYPE=NODE, a set of nodes.
struct AbaqusSurface {
  struct Face {
    AbaqusLabel set;  ///< of elements; empty: of the one of this id
    std::int64_t id = 0;
    int face = 0;  ///< from 1; 0: all nodes of the element
    int line = 0;
  };
  std::string name;
  std::vector<Face> faces;
  AbaqusSet nodes;
};

/// The sets of a file, by the keys of their labels.
class AbaqusSets {
 public:
  /// The set of a name; a new one where there is none.
  AbaqusSet& nodes(const AbaqusLabel& label) { return named(nodes_, label); }
  AbaqusSet& elements(const AbaqusLabel& label) { return named(elements_, label); }
  AbaqusSurface& surface(const AbaqusLabel& label) { return named(surfaces_, label); }

  /// Keys of all sets and surfaces.
  std::set<std::string> keys() const;

  /// Makes them the sets of the mesh, whose nodes and elements are all there. Throws
  /// std::runtime_error with file:line where a set is nowhere, or an element has no such face.
  void resolve(MeshFile& mesh) const;

 private:
  using Sets = std::map<std::string, AbaqusSet>;
  template <class T>
  static T& named(std::map<std::string, T>& all, const AbaqusLabel& label) {
    T& one = all[label.key];
    if (one.name.empty()) one.name = label.text;
    return one;
  }

  Sets nodes_, elements_;
  std::map<std::string, AbaqusSurface> surfaces_;
};

}  // namespace brunt
// Tested by tests/unit/io/abaqus_test.cpp.
