#include "core/rigid/rigid_surfaces.hpp"

#include <utility>

namespace brunt {

template <int Dim>
Vec<Dim> RigidMotion<Dim>::position(const Vec<Dim>& start, Real t) const {
  Vec<Dim> arm = start - center;
  if (spin != 0) {
    Vec3 arm3 = Vec3::Zero();
    arm3.template head<Dim>() = arm;
    arm = (Eigen::AngleAxis<Real>(spin * t, axis) * arm3).eval().template head<Dim>();
  }
  return center + velocity * t + arm;
}

template <int Dim>
RigidSurfaces<Dim>::RigidSurfaces(Points<Dim> points, std::vector<Facet<Dim>> facets)
    : points_(std::move(points)) {
  surface_.points = &points_;
  surface_.facets = std::move(facets);
}

template <int Dim>
BodyView RigidSurfaces<Dim>::view(Label body) const {
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
  }
  // A surface of triangles and quads is written as quads with a repeated last corner.
  view.corners = Dim == 2 ? 2 : 4;
  for (const auto& facet : surface_.facets) {
    if (facet.body != body) continue;
    for (int c = 0; c < view.corners; ++c) {
      const int corner = std::min(c, facet.n_nodes() - 1);
      view.connectivity.push_back(local[static_cast<std::size_t>(facet.node[corner])]);
    }
  }
  view.point_fields = {displacement, velocity, force, id};
  view.point_mass.assign(static_cast<std::size_t>(count), 0.0);
  return view;
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;
template class RigidSurfaces<2>;
template class RigidSurfaces<3>;

}  // namespace brunt
