#pragma once
/// Small scenes for the tests of contact: points, facets and particles by hand, and the time loop.
#include <cmath>
#include <deque>
#include <functional>
#include <memory>

#include "contact/manager/manager.hpp"

namespace brunt::testing {

/// Bodies by label 0, 1, ...; each body is a group of its own. They may be put into each other by
/// hand: what overlaps at time 0 presses.
template <int Dim>
struct ContactScene {
  struct Group {
    Points<Dim> points;
    Surface<Dim> surface;
  };
  std::deque<Group> groups;
  ContactOptions options;
  Geometry geometry = Dim == 3 ? Geometry::three_d : Geometry::plane_strain;
  Real depth = 1;  // [m]
  std::unique_ptr<ContactManager<Dim>> contact;

  ContactScene() { options.fallback.initial_overlap = InitialOverlap::press; }

  Group& add_group() {
    auto& group = groups.emplace_back();
    group.surface.points = &group.points;
    return group;
  }

  LocalIndex add_point(Group& group, const Vec<Dim>& x, Real mass) {
    auto& points = group.points;
    const auto label = static_cast<Label>(groups.size() - 1);
    points.id.push_back(points.id.size());
    points.body.push_back(label);
    points.piece.push_back(0);
    points.mass.push_back(mass);
    for (auto* field : {&points.x, &points.x_start}) field->push_back(x);
    for (auto* field : {&points.x_rest, &points.v, &points.a, &points.f}) {
      field->push_back(Vec<Dim>::Zero());
    }
    points.integration.push_back(0);
    return points.n_owned++;
  }

  /// A face on new points of its own; stiffness 0: rigid. Its id is unique in the scene.
  Facet<Dim>& add_face(Group& group, const std::vector<Vec<Dim>>& corners, Real stiffness,
                       Real depth_of_element, Real mass) {
    auto& facet = group.surface.facets.emplace_back();
    facet.node.fill(-1);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      facet.node[c] = add_point(group, corners[c], mass);
    }
    name(group, facet, stiffness, depth_of_element);
    return facet;
  }

  void name(const Group& group, Facet<Dim>& facet, Real stiffness, Real depth_of_element) {
    const std::size_t body = groups.size() - 1;
    facet.id = (body << 32) | (group.surface.facets.size() << 3);
    facet.body = static_cast<Label>(body);
    facet.stiffness = stiffness;
    facet.depth = depth_of_element;
    facet.areal_mass = stiffness > 0 ? 1000 * depth_of_element / 2 : 0;  // rho = 1000 kg/m^3
  }

  void add_particle(Group& group, const Vec<Dim>& x, Real radius, Real modulus, Real mass) {
    group.surface.add_particle(add_point(group, x, mass), radius, {modulus});
  }

  ContactManager<Dim>& start() {
    std::vector<Surface<Dim>*> surfaces;
    std::vector<std::string> names;
    for (auto& group : groups) {
      surfaces.push_back(&group.surface);
      names.push_back(std::string("b").append(std::to_string(names.size())));
    }
    contact = std::make_unique<ContactManager<Dim>>(options, geometry, surfaces, names, depth);
    return *contact;
  }

  /// Forces at the present positions, without motion.
  void evaluate() {
    for (auto& group : groups) {
      for (auto& f : group.points.f) f.setZero();
    }
    contact->add_forces(0);
  }

  /// One step of velocity Verlet with contact and, if given, other forces; points without mass
  /// keep their velocity.
  void step(Real dt, const std::function<void()>& add_other_forces = {}) {
    for (auto& group : groups) {
      auto& p = group.points;
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        p.v[i] += 0.5 * dt * p.a[i];
        p.x[i] += dt * p.v[i];
        p.f[i].setZero();
      }
    }
    contact->add_forces(dt);
    if (add_other_forces) add_other_forces();
    for (auto& group : groups) {
      auto& p = group.points;
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        if (p.mass[i] == 0) continue;
        p.a[i] = p.f[i] / p.mass[i];
        p.v[i] += 0.5 * dt * p.a[i];
      }
    }
  }

  Vec<Dim> force(std::size_t group) const {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const auto& f : groups[group].points.f) sum += f;
    return sum;
  }

  /// The kinetic energy that velocity Verlet keeps, sum m v(n-1/2) . v(n+1/2) / 2 [J].
  Real kinetic(Real dt) const {
    Real sum = 0;
    for (const auto& group : groups) {
      const auto& p = group.points;
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        sum += 0.5 * p.mass[i] * (p.v[i].squaredNorm() - 0.25 * dt * dt * p.a[i].squaredNorm());
      }
    }
    return sum;
  }

  Totals<Dim> totals() const {
    Totals<Dim> totals;
    totals.bodies.resize(groups.size());
    contact->add_totals(totals);
    return totals;
  }
};

/// Adds a sheet of n x n quads over [x0, x0 + size]^2 at height z, facing up or down, with shared
/// points; shape moves each point.
inline void add_sheet(ContactScene<3>& scene, int n, Real x0, Real size, Real z, bool up,
                      Real stiffness, Real element_depth,
                      const std::function<Vec3(const Vec3&)>& shape = {}) {
  auto& group = scene.add_group();
  const Real h = size / n;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const Vec3 x(x0 + h * i, x0 + h * j, z);
      scene.add_point(group, shape ? shape(x) : x, stiffness > 0 ? 1.0 : 0.0);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const LocalIndex a = j * (n + 1) + i, b = a + n + 1;
      auto& facet = group.surface.facets.emplace_back();
      facet.node = {a, a + 1, b + 1, b};
      if (!up) std::swap(facet.node[1], facet.node[3]);
      scene.name(group, facet, stiffness, element_depth);
    }
  }
}

/// The same in 2D: n edges over [x0, x0 + size] at height y. Up: the body lies below.
inline void add_sheet(ContactScene<2>& scene, int n, Real x0, Real size, Real y, bool up,
                      Real stiffness, Real element_depth) {
  auto& group = scene.add_group();
  for (int i = 0; i <= n; ++i) {
    scene.add_point(group, Vec<2>(x0 + size / n * i, y), stiffness > 0 ? 1.0 : 0.0);
  }
  for (int i = 0; i < n; ++i) {
    auto& facet = group.surface.facets.emplace_back();
    // normal = (dy, -dx): an edge that runs to the left faces up.
    facet.node = {up ? i + 1 : i, up ? i : i + 1};
    scene.name(group, facet, stiffness, element_depth);
  }
}

}  // namespace brunt::testing
