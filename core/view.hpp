#pragma once
/// What a group shows to output, measures and pictures: plain data, SI. A group's view is
/// relative to the scene's origin; the scene adds it.
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// A named array with 1 (scalar), 3 (vector; 2D has z = 0) or 6 (SymmetricIndex) components.
struct Field {
  std::string name;  ///< as in core/fields.hpp: "displacement", "stress", "eps_p", ...
  int components = 1;
  std::vector<Real> values;
  /// Of a field that waits until it is read, and has no values yet: writes those of entities
  /// first to last - 1. core/view_fields.hpp
  std::function<void(std::size_t first, std::size_t last, Real* to)> fill = {};
  std::size_t n_waiting = 0;  ///< entities of a field that waits
  /// Number of values, of all components.
  std::size_t size() const { return fill ? n_waiting * slot_of(components) : values.size(); }
};

/// The field of that name; null where there is none.
inline const Field* field_named(const std::vector<Field>& fields, std::string_view name) {
  for (const auto& field : fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

/// Which fields a view shall have: all, or those of these names. Positions and cells are in every
/// view, weights of means where nothing waits.
struct WantedFields {
  std::optional<std::vector<std::string>> names;  ///< none: all
  /// True: fields and cells may wait until they are read, which is before anything moves on.
  bool may_wait = false;
  /// Elements or particles that are looked at, the first of the body: one says which fields it has.
  std::size_t most = std::numeric_limits<std::size_t>::max();
  bool has(std::string_view name) const {
    return !names || std::find(names->begin(), names->end(), name) != names->end();
  }
};

/// Positions, cells and weights alone.
inline const WantedFields kNoFields{std::vector<std::string>{}};

/// [m] Planes across x, y and z in which particles of a body are reflected, where there are any.
using MirrorPlanes = std::array<std::optional<Real>, 3>;

/// One named body at one instant. Cells hold corners (hexes 8, quads 4, triangles 3, edges 2);
/// a body of particles has no cells and its fields are point fields.
struct BodyView {
  std::string body;
  Real time = 0;
  std::vector<Real> position;              ///< 3 n
  std::vector<std::int64_t> connectivity;  ///< corners of all cells; empty where these wait
  /// Writes corners of cells first to last - 1 of a view whose fields may wait.
  std::function<void(std::size_t first, std::size_t last, std::int64_t* to)> fill_corners = {};
  std::size_t n_waiting_cells = 0;
  int corners = 0;         ///< corners of a cell; 0: particles
  int cell_dimension = 0;  ///< of elements, 2 or 3; 0: facets of a surface, or particles
  std::vector<Field> point_fields;
  std::vector<Field> cell_fields;
  std::vector<Real> point_mass;    ///< [kg] weights of means over point fields
  std::vector<Real> point_radius;  ///< [m] particles only: half the spacing
  std::vector<Real> cell_volume;   ///< [m^3] weights of means over cell fields
  MirrorPlanes mirrors = {};       ///< particles only
  std::vector<char> point_owned;   ///< 0: a copy of another rank's point; empty: all are owned

  /// Cells that hold corners; particles are none.
  std::size_t n_cells() const {
    if (fill_corners) return n_waiting_cells;
    return corners == 0 ? 0 : connectivity.size() / slot_of(corners);
  }
};

/// Contact planes (polygons) and particle contacts (points) of one instant, for a .vtp.
struct ContactView {
  std::vector<Real> position;     ///< 3 n polygon corners or contact points
  std::vector<int> polygon_size;  ///< corners of each polygon (1 for a particle contact)
  std::vector<Real> normal;       ///< 3 a contact
  std::vector<Real> pressure;     ///< [Pa]
  std::vector<Real> penetration;  ///< [m]
  std::vector<Real> bonded;       ///< 1 where a bond, a tie or an unbroken joint holds, else 0
  std::vector<Real> max_closure;  ///< [m] of a joint since time 0; 0 elsewhere
  std::vector<Real> force;        ///< 3 a contact [N]
  std::vector<Label> body_a, body_b;
  /// The place of a contact among all: kind, then ids of its two sides, then a number.
  std::vector<std::array<GlobalId, 4>> key;
};

}  // namespace brunt
// Tested by tests/unit/core/merge_views_test.cpp.
