#include "app/gather_view.hpp"

#include <algorithm>
#include <map>

#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
void pack(Packer& packer, const std::vector<Field>& fields) {
  packer << static_cast<std::uint64_t>(fields.size());
  for (const auto& field : fields) packer << field.name << field.components << field.values;
}

std::vector<Field> unpack_fields(Unpacker& from) {
  std::uint64_t n = 0;
  from >> n;
  std::vector<Field> fields(n);
  for (auto& field : fields) from >> field.name >> field.components >> field.values;
  return fields;
}

Bytes pack(const BodyView& view) {
  Packer packer;
  packer << view.position << view.connectivity << view.corners;
  pack(packer, view.point_fields);
  pack(packer, view.cell_fields);
  packer << view.point_mass << view.point_radius << view.cell_volume << view.point_owned;
  return packer.take();
}

BodyView unpack(const Bytes& bytes) {
  BodyView view;
  Unpacker from(bytes);
  from >> view.position >> view.connectivity >> view.corners;
  view.point_fields = unpack_fields(from);
  view.cell_fields = unpack_fields(from);
  from >> view.point_mass >> view.point_radius >> view.cell_volume >> view.point_owned;
  return view;
}

/// Ids of the entities, empty where the view has none.
std::vector<Real> ids_of(const std::vector<Field>& fields) {
  for (const auto& field : fields) {
    if (field.name == "id") return field.values;
  }
  return {};
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

/// Fields of the chosen entities; parts without any entity have no fields to take part with.
std::vector<Field> merge_fields(const std::vector<BodyView>& parts,
                                const std::vector<Place>& places,
                                std::vector<Field> BodyView::*fields) {
  std::vector<Field> merged;
  if (places.empty()) return merged;
  for (const auto& field : parts[places.front().part].*fields) {
    merged.push_back({field.name, field.components, {}});
  }
  for (const auto& place : places) {
    const auto& from = parts[place.part].*fields;
    for (std::size_t f = 0; f < merged.size(); ++f) {
      append(merged[f].values, from[f].values, place.index,
             static_cast<std::size_t>(merged[f].components));
    }
  }
  return merged;
}
}  // namespace

BodyView gather_view(const BodyView& mine, const Communicator& ranks) {
  if (ranks.alone()) return mine;
  BodyView view;
  view.body = mine.body, view.time = mine.time;
  std::vector<BodyView> parts;
  for (const Bytes& bytes : ranks.gather(pack(mine))) parts.push_back(unpack(bytes));
  if (!ranks.is_root()) return view;
  std::vector<Place> points, cells;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto ids = ids_of(parts[p].point_fields);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (parts[p].point_owned.empty() || parts[p].point_owned[i]) points.push_back({ids[i], p, i});
    }
    view.corners = std::max(view.corners, parts[p].corners);
    if (parts[p].corners == 0) continue;
    const auto cell_ids = ids_of(parts[p].cell_fields);
    const std::size_t n = parts[p].connectivity.size() / static_cast<std::size_t>(parts[p].corners);
    for (std::size_t i = 0; i < n; ++i) {
      cells.push_back({cell_ids.empty() ? static_cast<Real>(i) : cell_ids[i], p, i});
    }
  }
  std::sort(points.begin(), points.end());
  std::sort(cells.begin(), cells.end());
  std::map<Real, std::int64_t> number;
  for (const auto& point : points) {
    const auto& part = parts[point.part];
    number[point.id] = static_cast<std::int64_t>(number.size());
    append(view.position, part.position, point.index, 3);
    append(view.point_mass, part.point_mass, point.index, 1);
    append(view.point_radius, part.point_radius, point.index, 1);
  }
  for (const auto& cell : cells) {
    const auto& part = parts[cell.part];
    const auto ids = ids_of(part.point_fields);
    const auto corners = static_cast<std::size_t>(part.corners);
    for (std::size_t c = 0; c < corners; ++c) {
      const auto local = static_cast<std::size_t>(part.connectivity[cell.index * corners + c]);
      view.connectivity.push_back(number.at(ids[local]));
    }
    append(view.cell_volume, part.cell_volume, cell.index, 1);
  }
  view.point_fields = merge_fields(parts, points, &BodyView::point_fields);
  view.cell_fields = merge_fields(parts, cells, &BodyView::cell_fields);
  return view;
}

namespace {
/// The contacts of a view in the order of their keys.
ContactView sorted(const ContactView& all) {
  const std::size_t n = all.key.size();
  std::vector<std::size_t> order(n), first(n + 1, 0);  // first: corner of each contact
  for (std::size_t i = 0; i < n; ++i) {
    order[i] = i;
    first[i + 1] = first[i] + static_cast<std::size_t>(all.polygon_size[i]);
  }
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return all.key[a] < all.key[b]; });
  ContactView view;
  for (const std::size_t i : order) {
    for (std::size_t corner = first[i]; corner < first[i + 1]; ++corner) {
      append(view.position, all.position, corner, 3);
    }
    view.polygon_size.push_back(all.polygon_size[i]);
    append(view.normal, all.normal, i, 3);
    append(view.pressure, all.pressure, i, 1);
    append(view.penetration, all.penetration, i, 1);
    append(view.force, all.force, i, 3);
    view.body_a.push_back(all.body_a[i]);
    view.body_b.push_back(all.body_b[i]);
    view.key.push_back(all.key[i]);
  }
  return view;
}
}  // namespace

ContactView gather_view(const ContactView& mine, const Communicator& ranks) {
  if (ranks.alone()) return mine;
  Packer packer;
  packer << mine.position << mine.polygon_size << mine.normal << mine.pressure << mine.penetration
         << mine.force << mine.body_a << mine.body_b << mine.key;
  ContactView view;
  const auto join = [](auto& to, Unpacker& from) {
    std::decay_t<decltype(to)> part;
    from >> part;
    to.insert(to.end(), part.begin(), part.end());
  };
  for (const Bytes& bytes : ranks.gather(packer.take())) {
    Unpacker from(bytes);
    join(view.position, from), join(view.polygon_size, from), join(view.normal, from);
    join(view.pressure, from), join(view.penetration, from), join(view.force, from);
    join(view.body_a, from), join(view.body_b, from), join(view.key, from);
  }
  return sorted(view);
}

}  // namespace brunt
