#include "contact/law/resting_layer.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
/// How far a body reaches along a direction.
struct Extent {
  Real least = kInfinity, most = -kInfinity;
  void take(Real from, Real to) { least = std::min(least, from), most = std::max(most, to); }
};

/// Takes M and c of what is stiffest in the body.
void take(Real modulus, Real density, RestingBody& body) {
  if (!(modulus > body.modulus && density > 0)) return;
  body.modulus = modulus;
  body.sound_speed = std::sqrt(modulus / density);
}
}  // namespace

template <int Dim>
std::map<Label, RestingBody> resting_bodies(const std::vector<Surface<Dim>*>& surfaces,
                                            const Section& section, const Vec<Dim>& gravity) {
  std::map<Label, RestingBody> bodies;
  if (gravity.isZero(0)) return bodies;
  const Vec<Dim> down = gravity.normalized();
  std::map<Label, Extent> extents;
  for (const auto* surface : surfaces) {
    const auto& points = *surface->points;
    const auto height = [&](LocalIndex p) { return down.dot(points.x_start[slot_of(p)]); };
    for (const auto& facet : surface->facets) {
      if (surface->held || facet.rigid()) continue;
      for (int c = 0; c < facet.n_nodes(); ++c) {
        const Real at = height(facet.node[slot_of(c)]);
        extents[facet.body].take(at, at);
      }
      auto& body = bodies[facet.body];
      if (facet.compliance > 0 || !(facet.depth > 0)) continue;
      take(facet.stiffness * facet.depth, 2 * facet.areal_mass / facet.depth, body);
    }
    for (const auto& one : surface->particles) {
      const auto p = slot_of(one.point);
      const Label label = points.body[p];
      extents[label].take(height(one.point) - one.radius, height(one.point) + one.radius);
      const Real breadth = section.breadth_of_particle(points.x_start[p][0], one.radius);
      const Real volume = std::pow(2 * one.radius, Dim) * breadth;
      take(surface->matters[one.matter].modulus, points.mass[p] / volume, bodies[label]);
    }
  }
  for (auto& [label, body] : bodies) body.height = extents[label].most - extents[label].least;
  return bodies;
}

RestingLayer resting_layer(const RestingBody& a, const RestingBody& b, Real gravity, Real weights) {
  const RestingBody& rests = b.height == 0 || (a.height > 0 && a.height <= b.height) ? a : b;
  const RestingBody& deforms = rests.modulus > 0 ? rests : (a.modulus > 0 ? a : b);
  if (!(weights > 0 && gravity > 0 && rests.height > 0 && deforms.modulus > 0)) return {};
  RestingLayer layer;
  layer.stiffness = RestingLayer::kStiffness * deforms.modulus / rests.height;
  const Real squared = deforms.sound_speed * deforms.sound_speed;
  layer.depth =
      weights * gravity * rests.height * rests.height / squared / RestingLayer::kStiffness;
  return layer;
}

template std::map<Label, RestingBody> resting_bodies<2>(const std::vector<Surface<2>*>&,
                                                        const Section&, const Vec<2>&);
template std::map<Label, RestingBody> resting_bodies<3>(const std::vector<Surface<3>*>&,
                                                        const Section&, const Vec<3>&);

}  // namespace brunt
