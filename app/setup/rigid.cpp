#include "app/setup/rigid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <stdexcept>

#include "app/setup/materials.hpp"
#include "app/setup/rigid_symmetry.hpp"
#include "contact/geometry/particle_face.hpp"
#include "core/geometry/placement.hpp"
#include "core/rigid/half_thickness.hpp"
#include "core/rigid/mass_properties.hpp"

namespace brunt {

namespace {
/// What is free of a body: all of it without motion, else the components that say so. A whole ring
/// moves along its axis alone.
template <int Dim>
void set_freedom(const deck::Body& body, Geometry geometry, FreeBody<Dim>& made) {
  made.free.fill(!body.motion);
  made.turns = !body.motion && geometry != Geometry::axisymmetric;
  for (std::size_t c = 0; body.motion && c < Dim && c < body.motion->velocity.size(); ++c) {
    made.free[c] = std::isnan(body.motion->velocity[c]);
  }
  if (geometry == Geometry::axisymmetric) made.free[0] = false;
}

/// Mass, place and motion at time 0.
template <int Dim>
void set_state(const deck::Body& body, const MassProperties& properties, const Vec<Dim>& origin,
               FreeBody<Dim>& made) {
  auto& state = made.state;
  state.mass = properties.mass;
  if (properties.inertia != Mat3::Zero()) {
    state.inertia = properties.inertia;
    state.inverse_inertia = properties.inertia.inverse();
  }
  state.x = made.center = properties.center;
  state.v = in_space<Dim>(to_vector<Dim>(body.velocity));
  if (!body.spin) return;
  Vec3 axis = Vec3::UnitZ(), about = in_space<Dim>(to_vector<Dim>(body.spin->about));
  if (Dim == 3) axis = to_vector<3>(body.spin->axis).normalized();
  about.template head<Dim>() -= origin;
  state.v += body.spin->rate * axis.cross(state.x - about);
  state.momentum = state.inertia * (body.spin->rate * axis);
}

/// Bodies of a plane that only move along it start so.
template <int Dim>
void set_prescribed_start(FreeBody<Dim>& made) {
  for (int c = 0; c < Dim; ++c) {
    if (!made.is_free(c)) made.state.v[c] = made.prescribed.velocity[c];
  }
  if (made.turns) return;
  const Vec3 spin = made.prescribed.spin * made.prescribed.axis;
  Vec3 arm = made.center;
  arm.template head<Dim>() -= made.prescribed.center;
  const Vec3 round = spin.cross(arm);
  for (int c = 0; c < Dim; ++c) {
    if (!made.is_free(c)) made.state.v[c] += round[c];
  }
  made.state.momentum = made.state.inertia * spin;
}

/// [1/kg] of the body on springs of all its faces. Of a quadrilateral four, of a triangle three,
/// of an edge two places integrate squares exactly.
template <int Dim>
Real mean_compliance_of(const FreeBody<Dim>& made, const Points<Dim>& points,
                        std::span<const Facet<Dim>> facets) {
  SurfaceSprings springs;
  for (const auto& facet : facets) {
    const int n = facet.n_nodes();
    std::array<Vec3, Facet<Dim>::kNodes> arm;
    Vec3 middle = Vec3::Zero();
    for (std::size_t c = 0; c < slot_of(n); ++c) {
      arm[c] = -made.center;
      arm[c].template head<Dim>() += points.x_start[facet.node[c]];
      middle += arm[c] / n;
    }
    const Real area = Dim == 2 ? (arm[1] - arm[0]).norm()
                      : n == 3 ? 0.5 * (arm[1] - arm[0]).cross(arm[2] - arm[0]).norm()
                               : 0.5 * (arm[2] - arm[0]).cross(arm[n - 1] - arm[1]).norm();
    const Real toward = n == 3 ? 0.5 : 1 / std::sqrt(3.0);  // the corners, from the middle
    for (std::size_t c = 0; c < slot_of(n); ++c) {
      springs.add(middle + toward * (arm[c] - middle), area / n);
    }
  }
  return springs.compliance(made.state.mass, made.state.inverse_inertia);
}

/// What contact needs to know of the faces.
template <int Dim>
void set_facets(const Material& material, const MassProperties& properties,
                const FreeBody<Dim>& made, const Points<Dim>& points,
                std::span<Facet<Dim>> facets) {
  const Real h = 2 * properties.volume / properties.area;
  const Real mean =
      made.turns ? mean_compliance_of<Dim>(made, points, facets) : 1 / made.state.mass;
  for (auto& facet : facets) {
    facet.stiffness = (material.bulk + 4.0 / 3 * material.shear) / h;
    facet.areal_mass = properties.mass / properties.area;
    facet.depth = 0.5 * h;
    facet.compliance = 1 / made.state.mass;
    facet.mean_compliance = mean;
    for (int c = 0; c < facet.n_nodes() && made.turns; ++c) {
      const auto node = slot_of(facet.node[c]);
      Vec3 arm = -made.center;
      arm.template head<Dim>() += points.x_start[node];
      facet.compliance = std::max(facet.compliance,
                                  compliance_at(arm, made.state.mass, made.state.inverse_inertia));
    }
  }
}

template <int Dim>
void set_shares(const FreeBody<Dim>& made, const Points<Dim>& points, std::vector<Real>& shares) {
  std::vector<std::size_t> mine;
  Vec<Dim> mean = Vec<Dim>::Zero();
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    if (points.piece[i] != made.piece) continue;
    mine.push_back(i);
    mean += points.x_start[i];
  }
  const auto n = static_cast<Real>(mine.size());
  mean /= n;
  Eigen::Matrix<Real, Dim, Dim> spread = Eigen::Matrix<Real, Dim, Dim>::Zero();
  for (const std::size_t i : mine) {
    const Vec<Dim> arm = points.x_start[i] - mean;
    spread += arm * arm.transpose();
  }
  const Vec<Dim> center = made.center.template head<Dim>();
  const Vec<Dim> b = made.state.mass * spread.inverse() * (center - mean);
  for (const std::size_t i : mine) {
    shares[i] = made.state.mass / n + b.dot(points.x_start[i] - mean);
  }
}
}  // namespace

template <int Dim>
RigidMotion<Dim> motion_of(const deck::Body& body, Label label, const Vec<Dim>& origin) {
  RigidMotion<Dim> motion;
  motion.body = label;
  motion.center = -origin;
  if (!body.motion) return motion;
  for (std::size_t c = 0; c < body.motion->velocity.size() && c < Dim; ++c) {
    const Real prescribed = body.motion->velocity[c];
    if (!std::isnan(prescribed)) motion.velocity[static_cast<int>(c)] = prescribed;
    const auto& driven = (*body.motion->driven_velocity)[c];
    if (driven) motion.velocity_over_time[c] = driven_rate_of(*driven);
  }
  if (!body.motion->spin) return motion;
  const auto& spin = *body.motion->spin;
  motion.spin = motion.last_spin = spin.rate;
  motion.spin_over_time = driven_rate_of(*spin.driven_rate);
  if (Dim == 3) motion.axis = to_vector<3>(spin.axis).normalized();
  motion.center += to_vector<Dim>(spin.about);
  return motion;
}

namespace {
/// [m] Planes of symmetry that hold a body without `motion` of its own, from the scene's origin.
template <int Dim>
std::array<std::optional<Real>, 3> planes_of(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                             Label body) {
  std::array<std::optional<Real>, 3> planes;
  if (!loaded.deck.symmetry || loaded.deck.bodies[body].value.motion) return planes;
  for (int axis = 0; axis < Dim; ++axis) {
    const auto& at = loaded.deck.symmetry->across(axis);
    if (at) planes[slot_of(axis)] = *at - scene.origin[axis];
  }
  return planes;
}

/// One without `motion` of its own, on the planes of symmetry at which it ends.
template <int Dim>
void hold_on_planes(const LoadedDeck& loaded, const Scene<Dim>& scene, const Points<Dim>& points,
                    std::span<const Facet<Dim>> facets, FreeBody<Dim>& made,
                    std::vector<DeckProblem>& problems) {
  const auto planes = planes_of(loaded, scene, made.body);
  for (int axis = 0; axis < Dim; ++axis) {
    const auto& at = planes[slot_of(axis)];
    if (!at) continue;
    const std::string wrong = hold_on_plane<Dim>(points, facets, axis, *at, made);
    if (wrong.empty()) continue;
    problems.push_back(
        loaded.places.problem(std::string("symmetry.") + static_cast<char>('x' + axis),
                              "'" + loaded.deck.bodies[made.body].name + "' " + wrong));
  }
}
}  // namespace

template <int Dim>
std::vector<FreeBody<Dim>> free_bodies_of(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                          Surface<Dim>& surface,
                                          std::vector<DeckProblem>& problems) {
  const auto& points = *surface.points;
  std::map<Label, std::vector<std::size_t>> pieces;  // which facets are theirs
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto& facet = surface.facets[f];
    if (deck::follows_forces(loaded.deck.bodies[facet.body].value))
      pieces[facet.piece].push_back(f);
  }
  std::vector<FreeBody<Dim>> made;
  for (const auto& [piece, places] : pieces) {
    std::vector<Facet<Dim>> facets;
    for (const std::size_t f : places) facets.push_back(surface.facets[f]);
    FreeBody<Dim> one;
    one.body = facets.front().body, one.piece = piece;
    const auto& [name, body] = loaded.deck.bodies[one.body];
    const Material* material = material_of(loaded.deck, scene.materials, body);
    if (material == nullptr) continue;
    one.prescribed = motion_of<Dim>(body, one.body, scene.origin);
    try {
      const auto properties = mass_properties<Dim>(
          points, facets, material->density, scene.geometry, scene.depth,
          facets_on_planes<Dim>(points, facets, planes_of(loaded, scene, one.body)));
      set_freedom(body, scene.geometry, one);
      set_state<Dim>(body, properties, scene.origin, one);
      hold_on_planes<Dim>(loaded, scene, points, facets, one, problems);
      set_prescribed_start(one);
      set_facets<Dim>(*material, properties, one, points, facets);
    } catch (const std::invalid_argument& error) {
      problems.push_back(loaded.places.problem("bodies." + name + ".shape", error.what()));
      continue;
    }
    for (std::size_t k = 0; k < places.size(); ++k) surface.facets[places[k]] = facets[k];
    made.push_back(std::move(one));
  }
  return made;
}

template <int Dim>
void find_rigid_centers(const Deck& deck, const Surface<Dim>& surface, Scene<Dim>& scene) {
  std::map<Label, std::vector<Facet<Dim>>> facets;
  for (const auto& facet : surface.facets) {
    if (!deck::follows_forces(deck.bodies[facet.body].value)) facets[facet.body].push_back(facet);
  }
  for (const auto& [body, of_body] : facets) {
    scene.rigid_centers[body] = center_of_shape<Dim>(*surface.points, of_body, scene.geometry);
  }
}

template <int Dim>
std::vector<Real> mass_shares(std::span<const FreeBody<Dim>> bodies, const Points<Dim>& points) {
  std::vector<Real> shares(points.x.size(), 0.0);
  for (const auto& body : bodies) set_shares(body, points, shares);
  return shares;
}

template <int Dim>
void find_half_thicknesses(Scene<Dim>& scene) {
  Real radius = 0;  // [m] of the largest particle
  for (const auto& solid : scene.solids) {
    for (const auto& one : solid->surface().particles) radius = std::max(radius, one.radius);
  }
  if (radius == 0) return;
  for (auto& solid : scene.solids) {
    auto& surface = solid->surface();
    find_half_thickness<Dim>(surface.points->x_start, kDepthRadii * radius, surface.facets);
  }
}

template RigidMotion<2> motion_of<2>(const deck::Body&, Label, const Vec<2>&);
template RigidMotion<3> motion_of<3>(const deck::Body&, Label, const Vec<3>&);
template std::vector<FreeBody<2>> free_bodies_of<2>(const LoadedDeck&, const Scene<2>&, Surface<2>&,
                                                    std::vector<DeckProblem>&);
template std::vector<FreeBody<3>> free_bodies_of<3>(const LoadedDeck&, const Scene<3>&, Surface<3>&,
                                                    std::vector<DeckProblem>&);
template std::vector<Real> mass_shares<2>(std::span<const FreeBody<2>>, const Points<2>&);
template std::vector<Real> mass_shares<3>(std::span<const FreeBody<3>>, const Points<3>&);
template void find_rigid_centers<2>(const Deck&, const Surface<2>&, Scene<2>&);
template void find_rigid_centers<3>(const Deck&, const Surface<3>&, Scene<3>&);
template void find_half_thicknesses<2>(Scene<2>&);
template void find_half_thicknesses<3>(Scene<3>&);

}  // namespace brunt
