#include "core/merge_views.hpp"

#include <algorithm>

namespace brunt {

namespace {
/// Ids of the entities, empty where the view has none.
const std::vector<Real>& ids_of(const std::vector<Field>& fields) {
  static const std::vector<Real> none;
  const Field* id = field_named(fields, "id");
  return id != nullptr ? id->values : none;
}

/// An entity of the merged view: which part has it, and where.
struct Place {
  Real id;
  std::size_t part, index;
  bool operator<(const Place& other) const { return id < other.id; }
};

void append(std::vector<Real>& to, const std::vector<Real>& from, std::size_t index,
            std::size_t width) {
  if (from.empty()) return;
  const auto at = from.begin() + static_cast<std::ptrdiff_t>(index * width);
  to.insert(to.end(), at, at + static_cast<std::ptrdiff_t>(width));
}

/// Fields of the chosen entities; parts without any entity may have no fields to take part with.
/// Where nothing is left of a body, its fields are there without values, as on one rank.
std::vector<Field> merge_fields(const std::vector<BodyView>& parts,
                                const std::vector<Place>& places,
                                std::vector<Field> BodyView::*fields) {
  std::vector<Field> merged;
  auto model = std::find_if(parts.begin(), parts.end(),
                            [&](const BodyView& part) { return !(part.*fields).empty(); });
  if (!places.empty()) model = parts.begin() + static_cast<std::ptrdiff_t>(places.front().part);
  if (model == parts.end()) return merged;
  for (const auto& field : (*model).*fields) merged.push_back({field.name, field.components, {}});
  for (const auto& place : places) {
    const auto& from = parts[place.part].*fields;
    for (std::size_t f = 0; f < merged.size(); ++f) {
      append(merged[f].values, from[f].values, place.index, slot_of(merged[f].components));
    }
  }
  return merged;
}

std::vector<Place> owned_points(const std::vector<BodyView>& parts) {
  std::vector<Place> points;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto& ids = ids_of(parts[p].point_fields);
    const auto& owned = parts[p].point_owned;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (owned.empty() || owned[i]) points.push_back({ids[i], p, i});
    }
  }
  std::sort(points.begin(), points.end());
  return points;
}

/// Corners of a cell; a part without cells does not know.
int corners_of(const std::vector<BodyView>& parts) {
  int any = 0;
  for (const auto& part : parts) {
    if (!part.connectivity.empty()) return part.corners;
    any = std::max(any, part.corners);
  }
  return any;
}

std::vector<Place> all_cells(const std::vector<BodyView>& parts) {
  std::vector<Place> cells;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (parts[p].corners == 0) continue;
    const auto& ids = ids_of(parts[p].cell_fields);
    const std::size_t n = parts[p].connectivity.size() / slot_of(parts[p].corners);
    for (std::size_t i = 0; i < n; ++i) {
      cells.push_back({ids.empty() ? static_cast<Real>(i) : ids[i], p, i});
    }
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/// The number of a point of a part among the merged ones; -1, no corner, stays.
std::int64_t merged_number(std::int64_t local, const std::vector<Real>& ids,
                           const std::vector<Place>& points) {
  if (local < 0) return local;
  const Place wanted{ids.at(slot_of(local)), 0, 0};
  return std::lower_bound(points.begin(), points.end(), wanted) - points.begin();
}
}  // namespace

BodyView merge_views(const std::vector<BodyView>& parts) {
  BodyView view;
  for (const auto& part : parts) {
    if (view.body.empty()) view.body = part.body, view.time = part.time;
    view.cell_dimension = std::max(view.cell_dimension, part.cell_dimension);
  }
  view.corners = corners_of(parts);
  const auto points = owned_points(parts);
  const auto cells = all_cells(parts);
  for (const auto& point : points) {
    const auto& part = parts[point.part];
    append(view.position, part.position, point.index, 3);
    append(view.point_mass, part.point_mass, point.index, 1);
    append(view.point_radius, part.point_radius, point.index, 1);
  }
  for (const auto& cell : cells) {
    const auto& part = parts[cell.part];
    const auto& ids = ids_of(part.point_fields);
    const auto corners = slot_of(part.corners);
    for (std::size_t c = cell.index * corners; c < (cell.index + 1) * corners; ++c) {
      view.connectivity.push_back(merged_number(part.connectivity[c], ids, points));
    }
    append(view.cell_volume, part.cell_volume, cell.index, 1);
  }
  view.point_fields = merge_fields(parts, points, &BodyView::point_fields);
  view.cell_fields = merge_fields(parts, cells, &BodyView::cell_fields);
  return view;
}

}  // namespace brunt
