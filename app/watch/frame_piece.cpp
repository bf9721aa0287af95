#include "app/watch/frame_piece.hpp"

#include <algorithm>

#include "core/fields.hpp"
#include "core/parallel/ghosts.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
/// The rows of an array of `width` values each that are kept.
template <class Value>
void keep_rows(std::vector<Value>& values, const std::vector<char>& keep, std::size_t width) {
  if (values.empty()) return;
  std::size_t to = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    for (std::size_t c = 0; c < width; ++c) values[to++] = values[i * width + c];
  }
  values.resize(to);
}

/// Without copies of points that none of the cells touches.
void drop_idle_copies(BodyView& view) {
  std::vector<char> keep = view.point_owned;
  for (const auto corner : view.connectivity) keep.at(slot_of(corner)) = 1;
  std::vector<std::int64_t> number(keep.size());
  std::int64_t n = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) number[i] = keep[i] ? n++ : -1;
  for (auto& corner : view.connectivity) corner = number[corner];
  keep_rows(view.position, keep, 3);
  keep_rows(view.point_mass, keep, 1);
  keep_rows(view.point_radius, keep, 1);
  keep_rows(view.point_owned, keep, 1);
  for (auto& field : view.point_fields) {
    keep_rows(field.values, keep, slot_of(field.components));
  }
}

/// Only cells say which fields they have: a rank without any takes those of the others, empty.
void take_cell_fields(BodyView& view, const Communicator& ranks) {
  const bool has_cells = !view.connectivity.empty();
  if (!has_cells) view.cell_fields.clear();
  Packer mine;
  for (const auto& field : view.cell_fields) mine << field.name << field.components;
  for (const Bytes& bytes : ranks.all_gather(mine.take())) {
    Unpacker from(bytes);
    if (has_cells || !view.cell_fields.empty()) break;
    while (!from.done()) {
      auto& field = view.cell_fields.emplace_back();
      from >> field.name >> field.components;
    }
  }
}

/// The places of copies of other ranks' points in the view, and of what they are copies of.
struct Copies {
  std::vector<GlobalId> owned;           // ids, ascending
  std::vector<std::size_t> owned_place;  // where each stands
  GhostPlan plan;                        // by number in `owned`, by place of the copy
};

Copies find_copies(const BodyView& view, const Partition& partition, const Communicator& ranks) {
  Copies copies;
  std::vector<GlobalId> ids;
  std::vector<LocalIndex> places;
  std::vector<int> owners;
  const Field* id = field_named(view.point_fields, "id");
  for (std::size_t i = 0; i < view.point_owned.size(); ++i) {
    const auto number = static_cast<GlobalId>(id->values[i]);
    if (view.point_owned[i]) {
      copies.owned.push_back(number);
      copies.owned_place.push_back(i);
    } else {
      ids.push_back(number);
      places.push_back(static_cast<LocalIndex>(i));
      owners.push_back(partition.of(number));
    }
  }
  copies.plan = plan_ghosts(ranks, ids, places, owners, copies.owned);
  return copies;
}

}  // namespace

void add_owner(BodyView& view, int rank) {
  if (view.position.empty()) return;  // a piece without points has no fields
  const auto owner = [&](std::size_t n) {
    return Field{kOwnerField.name, 1, std::vector<Real>(n, static_cast<Real>(rank))};
  };
  view.point_fields.push_back(owner(view.position.size() / 3));
  if (view.n_cells() > 0) view.cell_fields.push_back(owner(view.n_cells()));
}

BodyView frame_piece(BodyView view, const Partition& partition, const Communicator& ranks) {
  take_cell_fields(view, ranks);
  if (!view.point_owned.empty()) drop_idle_copies(view);
  const Copies copies = find_copies(view, partition, ranks);
  std::size_t width = 3;
  for (const auto& field : view.point_fields) width += slot_of(field.components);
  const auto each = [&view](const auto& what) {
    what(view.position, 3);
    for (auto& field : view.point_fields) what(field.values, field.components);
  };
  refresh_ghosts(
      ranks, copies.plan, width,
      [&](std::size_t owned, Real* out) {
        const std::size_t at = copies.owned_place[owned];
        each([&](std::vector<Real>& values, int n) {
          const auto components = slot_of(n);
          out = std::copy_n(&values[at * components], components, out);
        });
      },
      [&](std::size_t at, const Real* in) {
        each([&](std::vector<Real>& values, int n) {
          const auto components = slot_of(n);
          std::copy_n(in, components, &values[at * components]);
          in += components;
        });
      });
  return view;
}

}  // namespace brunt
