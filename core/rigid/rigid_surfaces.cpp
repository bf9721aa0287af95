#include "core/rigid/rigid_surfaces.hpp"

#include <utility>

namespace brunt {

template <int Dim>
RigidSurfaces<Dim>::RigidSurfaces(Points<Dim> points, std::vector<Facet<Dim>> facets)
    : points_(std::move(points)) {
  surface_.points = &points_;
  surface_.facets = std::move(facets);
  surface_.everywhere = true;
}

/// All points and facets stand on every rank; forces and work are kept by the owner of each point.
template <int Dim>
std::unique_ptr<Solid<Dim>> RigidSurfaces<Dim>::part(const Partition& partition,
                                                     const Communicator& ranks) const {
  std::vector<LocalIndex> order, place(points_.x.size());
  LocalIndex n_owned = 0;
  for (const bool owned : {true, false}) {
    for (LocalIndex i = 0; i < points_.size(); ++i) {
      const auto k = slot_of(i);
      if ((partition.of(points_.id[k]) == ranks.rank()) != owned) continue;
      place[k] = static_cast<LocalIndex>(order.size());
      order.push_back(i);
    }
    if (owned) n_owned = static_cast<LocalIndex>(order.size());
  }
  auto facets = surface_.facets;
  for (auto& facet : facets) {
    facet.owned = partition.of(points_.id[facet.node[0]]) == ranks.rank();
  }
  for (auto& facet : facets) {
    for (auto& node : facet.node) {
      if (node >= 0) node = place[node];
    }
  }
  auto here = std::make_unique<RigidSurfaces>(points_.subset(order, n_owned), std::move(facets));
  here->shows_facets_ = ranks.is_root();
  if (shares_.empty()) return here;
  std::vector<Real> shares;
  shares.reserve(order.size());
  for (const LocalIndex i : order) shares.push_back(shares_[i]);
  here->set_shares(std::move(shares));
  return here;
}

template <int Dim>
BodyView RigidSurfaces<Dim>::view(Label body, const WantedFields& wanted) const {
  BodyView view;
  Field displacement{"displacement", 3, {}}, velocity{"velocity", 3, {}}, force{"force", 3, {}};
  Field id{"id", 1, {}};
  std::vector<std::int64_t> local(points_.x.size(), -1);
  std::int64_t count = 0;
  for (std::size_t i = 0; i < points_.x.size(); ++i) {
    if (points_.body[i] != body) continue;
    local[i] = count++;
    const auto append = [](std::vector<Real>& values, const Vec<Dim>& v) {
      for (int c = 0; c < 3; ++c) values.push_back(c < Dim ? v[c] : 0.0);
    };
    append(view.position, points_.x[i]);
    append(displacement.values, points_.x[i] - points_.x_start[i]);
    append(velocity.values, points_.v[i]);
    append(force.values, points_.f[i]);
    id.values.push_back(static_cast<Real>(points_.id[i]));
    view.point_owned.push_back(static_cast<LocalIndex>(i) < points_.n_owned);
    view.point_mass.push_back(shares_.empty() ? 0.0 : shares_[i]);
  }
  // A surface of triangles and quads is written as quads with a repeated last corner.
  view.corners = Dim == 2 ? 2 : 4;
  for (const auto& facet : surface_.facets) {
    if (facet.body != body || !shows_facets_) continue;
    for (int c = 0; c < view.corners; ++c) {
      const int corner = std::min(c, facet.n_nodes() - 1);
      view.connectivity.push_back(local[facet.node[corner]]);
    }
  }
  view.point_fields = {displacement, velocity, force, id};
  if (points_.conducts) {
    Field temperature{"temperature", 1, {}};
    for (std::size_t i = 0; i < points_.x.size(); ++i) {
      if (points_.body[i] == body) temperature.values.push_back(points_.temperature[i]);
    }
    view.point_fields.push_back(std::move(temperature));
  }
  if (wanted.names && wanted.has("piece")) {  // by name alone: most are of one
    Field piece{"piece", 1, {}};
    for (std::size_t i = 0; i < points_.x.size(); ++i) {
      if (points_.body[i] == body) piece.values.push_back(static_cast<Real>(points_.piece[i]));
    }
    view.point_fields.push_back(std::move(piece));
  }
  std::erase_if(view.point_fields, [&](const Field& field) { return !wanted.has(field.name); });
  return view;
}

template class RigidSurfaces<2>;
template class RigidSurfaces<3>;

}  // namespace brunt
// Tested by tests/verification/rigid_test.cpp.
