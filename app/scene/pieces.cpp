#include "app/scene/pieces.hpp"

#include <algorithm>

#include "app/deck/deck.hpp"

namespace brunt {

namespace {
using Kept = std::vector<char>;

/// Drops what is not kept of an array with so many values an entity.
template <class T>
void keep(const Kept& kept, std::size_t components, std::vector<T>& values) {
  if (values.empty()) return;
  std::size_t n = 0;
  for (std::size_t e = 0; e < kept.size(); ++e) {
    if (kept[e] == 0) continue;
    for (std::size_t c = 0; c < components; ++c) values[n++] = values[e * components + c];
  }
  values.resize(n);
}

void keep(const Kept& kept, std::vector<Field>& fields) {
  for (Field& field : fields) keep(kept, slot_of(field.components), field.values);
}

Kept is_piece(Label piece, const Field* of) {
  Kept kept;
  if (of == nullptr) return kept;
  for (const Real value : of->values) kept.push_back(value == static_cast<Real>(piece));
  return kept;
}
}  // namespace

std::optional<BodyPart> part_named(const std::vector<std::string>& bodies,
                                   const std::vector<NamedPiece>& pieces, const std::string& name) {
  const auto body = std::find(bodies.begin(), bodies.end(), name);
  if (body != bodies.end()) return BodyPart{static_cast<Label>(body - bodies.begin()), {}};
  const auto piece = std::find_if(pieces.begin(), pieces.end(), [&](const NamedPiece& one) {
    return !one.name.empty() && one.name == name;
  });
  if (piece == pieces.end()) return std::nullopt;
  return BodyPart{piece->body, static_cast<Label>(piece - pieces.begin())};
}

std::string piece_problem(const std::vector<std::string>& bodies,
                          const std::vector<NamedPiece>& pieces, const std::string& name) {
  if (part_named(bodies, pieces, name)) return "";
  const std::string whole = body_of_part(name);
  const auto body = part_named(bodies, pieces, whole);
  if (!body) return "";  // the deck's own checks say so
  std::vector<std::string> names;
  for (const NamedPiece& piece : pieces) {
    if (piece.body == body->body && !piece.name.empty()) names.push_back(piece.name);
  }
  if (names.empty()) return "'" + whole + "' is of one piece: write body: " + whole;
  // Of so many alike names the range says more than one that is near.
  return "'" + whole + "' has no piece '" + name + "'; it has " + std::to_string(names.size()) +
         ", '" + names.front() + "' to '" + names.back() + "'";
}

void keep_piece(Label piece, const BodyView& pieces, BodyView& view) {
  const Kept points = is_piece(piece, field_named(pieces.point_fields, "piece"));
  const auto corners = slot_of(view.corners);
  Kept cells;  // those of one piece have no point in common with those of another
  for (std::size_t c = 0; c < view.n_cells(); ++c) {
    cells.push_back(points[slot_of(view.connectivity[c * corners])]);
  }
  std::vector<std::int64_t> place(points.size());
  std::int64_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) place[i] = points[i] != 0 ? count++ : -1;
  keep(cells, corners, view.connectivity);
  for (auto& corner : view.connectivity) corner = place[slot_of(corner)];
  keep(cells, 1, view.cell_volume);
  keep(cells, view.cell_fields);
  keep(points, 3, view.position);
  keep(points, 1, view.point_mass);
  keep(points, 1, view.point_radius);
  keep(points, 1, view.point_owned);
  keep(points, view.point_fields);
}

}  // namespace brunt
