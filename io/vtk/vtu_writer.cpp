#include "io/vtk/vtu_writer.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/view_fields.hpp"
#include "io/vtk/grid.hpp"

namespace brunt {

namespace {

/// How many corners a cell has: all that one of the view may, but for triangles among quads.
std::size_t corners_in(const std::int64_t* cell, std::size_t corners, bool may_be_triangle) {
  return may_be_triangle && (cell[3] < 0 || cell[3] == cell[2]) ? 3 : corners;
}

/// Corners of cells are points of the view; the last of a quad may be none.
void check_corners(const BodyView& view, std::span<const std::int64_t> all) {
  const auto n_points = static_cast<std::int64_t>(view.position.size() / 3);
  const auto corners = slot_of(std::max(view.corners, 1));
  const bool may_lack = corners == 4 && view.cell_dimension != 3;
  for (std::size_t c = 0; c < all.size(); ++c) {
    const bool left_out = may_lack && all[c] < 0 && c % corners == 3;
    if (!left_out && (all[c] < 0 || all[c] >= n_points)) misfit("connectivity");
  }
}

/// Calls take(cell) with the corners of each cell. Those that wait are made in parts.
template <class Take>
void for_cells(const BodyView& view, std::size_t n, const Take& take) {
  const auto corners = slot_of(view.corners);
  std::vector<std::int64_t> made(view.fill_corners ? kFieldPart * corners : 0);
  for (std::size_t first = 0; first < n; first += kFieldPart) {
    const std::size_t last = std::min(n, first + kFieldPart);
    const std::int64_t* part = made.data();
    if (view.fill_corners) {
      view.fill_corners(first, last, made.data());
      check_corners(view, std::span(made).first((last - first) * corners));
    } else {
      part = &view.connectivity[first * corners];
    }
    for (std::size_t c = first; c < last; ++c, part += corners) take(part);
  }
}

/// connectivity, offsets and types; particles are one vertex a point.
std::vector<VtkFileArray> cell_arrays(const BodyView& view, std::size_t n_points) {
  const auto corners = slot_of(std::max(view.corners, 1));
  const std::size_t n = view.corners == 0 ? n_points : view.n_cells();
  const bool may_be_triangle = view.corners == 4 && view.cell_dimension != 3;
  const auto for_sizes = [&view, n, corners, may_be_triangle](const auto& take) {
    if (may_be_triangle) {
      return for_cells(view, n, [&](auto* cell) { take(corners_in(cell, corners, true)); });
    }
    for (std::size_t c = 0; c < n; ++c) take(corners);
  };
  std::size_t n_corners = n * corners;
  if (may_be_triangle) n_corners = 0, for_sizes([&](std::size_t size) { n_corners += size; });
  const auto fill_corners = [&view, n, corners, may_be_triangle](auto* to) {
    using To = std::remove_pointer_t<decltype(to)>;
    if (view.corners == 0) return std::iota(to, to + n, To{0});
    for_cells(view, n, [&](auto* cell) {
      const auto* const end = cell + corners_in(cell, corners, may_be_triangle);
      to = std::transform(cell, end, to, [](auto at) { return static_cast<To>(at); });
    });
  };
  const auto fill_ends = [for_sizes](auto* to) {
    std::size_t end = 0;
    for_sizes([&](std::size_t size) { *to++ = static_cast<decltype(+*to)>(end += size); });
  };
  const auto fill_types = [&view, for_sizes](std::uint8_t* to) {
    for_sizes([&](std::size_t size) {
      *to++ = vtk_cell_type(static_cast<int>(size), view.cell_dimension);
    });
  };
  const auto types = [n, fill_types](std::string& room) {
    return made<std::uint8_t>(room, n, fill_types);
  };
  return {whole_numbers("connectivity", n_corners, n_points, fill_corners),
          whole_numbers("offsets", n, n_corners, fill_ends),
          {"UInt8", "types", 1, types, "types"}};
}

/// Which points are copies of other ranks'.
VtkFileArray ghost_array(const BodyView& view) {
  constexpr std::uint8_t kDuplicatePoint = 1;  // of VTK
  const auto fill = [&view](std::uint8_t* to) {
    for (const char owned : view.point_owned) *to++ = owned != 0 ? 0 : kDuplicatePoint;
  };
  return {"UInt8", "vtkGhostType", 1,
          [&view, fill](std::string& room) {
            return made<std::uint8_t>(room, view.point_owned.size(), fill);
          },
          "vtkGhostType"};
}

/// The radius of particles, which may be none; empty where there can be none.
Field radius_of(const BodyView& view) { return {"radius", 1, view.point_radius}; }

/// radius  that of the view; it has to stay, as the view
std::vector<VtkFileArray> point_arrays(const BodyView& view, const Field& radius) {
  std::vector<VtkFileArray> arrays;
  for (const auto& field : view.point_fields) arrays.push_back(array_of(field, "points."));
  const bool no_particles =
      view.corners == 0 && view.position.empty() && !view.point_fields.empty();
  if (radius.size() > 0 || no_particles) arrays.push_back(singles(radius));
  if (!view.point_owned.empty()) arrays.push_back(ghost_array(view));
  return arrays;
}

std::vector<VtkFileArray> field_arrays(const BodyView& view) {
  std::vector<VtkFileArray> arrays;
  for (const auto& field : view.cell_fields) arrays.push_back(array_of(field, "cells."));
  return arrays;
}

void check_lengths(const BodyView& view, std::size_t n_points, std::size_t n_cells) {
  if (view.position.size() % 3 != 0) misfit("position");
  if (view.connectivity.size() % slot_of(std::max(view.corners, 1)) != 0) misfit("connectivity");
  check_corners(view, view.connectivity);
  const auto check = [](const std::vector<Field>& fields, std::size_t n) {
    for (const auto& field : fields) {
      if (field.size() != n * slot_of(field.components)) {
        misfit("field " + field.name);
      }
    }
  };
  check(view.point_fields, n_points), check(view.cell_fields, n_cells);
  if (!view.point_radius.empty() && view.point_radius.size() != n_points) misfit("radius");
  if (!view.point_owned.empty() && view.point_owned.size() != n_points) misfit("point_owned");
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const BodyView& view, VtkFileMemory& memory) {
  const std::size_t n_points = view.position.size() / 3;
  const std::size_t n_cells = view.corners == 0 ? n_points : view.n_cells();
  check_lengths(view, n_points, n_cells);
  VtkFile file(path, "UnstructuredGrid", view.time);
  file.text("    <Piece NumberOfPoints=\"" + std::to_string(n_points) + "\" NumberOfCells=\"" +
            std::to_string(n_cells) + "\">\n      <PointData>\n");
  const Field radius = radius_of(view);
  for (auto& array : point_arrays(view, radius)) file.declare(std::move(array));
  file.text("      </PointData>\n      <CellData>\n");
  for (auto& array : field_arrays(view)) file.declare(std::move(array));
  file.text("      </CellData>\n      <Points>\n");
  file.declare(reals("Points", 3, view.position));
  file.text("      </Points>\n      <Cells>\n");
  for (auto& array : cell_arrays(view, n_points)) file.declare(std::move(array));
  file.text("      </Cells>\n    </Piece>\n");
  file.finish(memory, view.body);
}

FramePiece listed_arrays(const BodyView& view) {
  FramePiece piece;
  const Field radius = radius_of(view);
  for (const auto& array : point_arrays(view, radius)) piece.point_arrays += joined_line(array);
  for (const auto& array : field_arrays(view)) piece.cell_arrays += joined_line(array);
  return piece;
}

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
