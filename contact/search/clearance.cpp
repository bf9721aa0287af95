#include "contact/search/clearance.hpp"

#include <algorithm>

namespace brunt {

namespace {
/// Of the lengths that a clearance is found from: far more than rounding, in single precision too.
constexpr Real kSafe = 1e-6;
}  // namespace

template <int Dim>
Clearance clearance_of(const Entities<Dim>& entities, const ContactParticle& particle,
                       std::size_t face) {
  const auto& plane = entities.planes[face];
  const auto& box = entities.boxes[face];
  const Vec<Dim>& x = entities.nodes.x[slot_of(particle.node)];
  Real apart = -kInfinity;
  for (int c = 0; c < Dim; ++c) {
    const auto k = slot_of(c);
    apart = std::max({apart, box.lo[k] - x[c], x[c] - box.hi[k]});
  }
  const Vec<Dim> arm = x - plane.center;
  const Real length = arm.norm();
  const Real error = kSafe * (length + particle.radius + plane.warp);
  const bool two_sides = entities.faces[face].open;
  const Real before = two_sides ? -kInfinity : plane.normal.dot(arm) - plane.warp;
  return {static_cast<LocalIndex>(face), static_cast<float>(apart - particle.radius - error),
          static_cast<float>(before - error), static_cast<float>(length + error)};
}

template Clearance clearance_of<2>(const Entities<2>&, const ContactParticle&, std::size_t);
template Clearance clearance_of<3>(const Entities<3>&, const ContactParticle&, std::size_t);

}  // namespace brunt
