#include "contact/geometry/soft_layer.hpp"

#include <algorithm>

namespace brunt {

namespace {
template <class Value>
void mix(Value& of_layer, Real part, const Value& of_firm, Real rest) {
  for (std::size_t k = 0; k < of_layer.size(); ++k) {
    of_layer[k] = part * of_layer[k] + rest * of_firm[k];
  }
}

/// Lets a plane have the part s of its force, but all of its barrier, which was given as 1/s.
template <int Dim>
void soften(const SoftLayer& layer, CommonPlane<Dim>& plane) {
  const Real s = layer.softness;
  plane.layered = plane.volume / (plane.ramp * plane.area);
  plane.volume *= s;
  plane.energy *= s;
  plane.mean_slope = 1 + s * (plane.mean_slope - 1);
  plane.barrier.strength *= s;
  if (!(plane.share > 0)) return;
  for (auto& push : plane.lower_push) push *= s;
  for (auto& push : plane.upper_push) push *= s;
}

/// Adds the part `rest` of a plane between the same faces from the end of the layer on.
template <int Dim>
void add_firm(Real rest, const CommonPlane<Dim>& firm, CommonPlane<Dim>& plane) {
  const Real below = rest * firm.volume, all = plane.volume + below;
  const Real share = below / all;
  mix(plane.lower_weight, 1 - share, firm.lower_weight, share);
  mix(plane.upper_weight, 1 - share, firm.upper_weight, share);
  plane.point += share * (firm.point - plane.point);
  plane.volume = all;
  plane.energy += rest * firm.energy;
  if (!(firm.share > 0)) return;
  if (!(plane.share > 0)) {
    plane.lower_push.fill(Vec<Dim>::Zero());
    plane.upper_push.fill(Vec<Dim>::Zero());
  }
  mix(plane.lower_push, 1, firm.lower_push, rest);
  mix(plane.upper_push, 1, firm.upper_push, rest);
  plane.share = std::max(plane.share, firm.share);
}
}  // namespace

template <int Dim>
int layered_planes(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Section& section,
                   const SoftLayer& layer, Planes<Dim>& plane, PlaneNeeds needs) {
  const Real s = layer.softness;
  needs.barrier.strength /= s;
  const int n = common_planes<Dim>(lower, upper, section, plane, needs);
  Real deepest = 0;
  for (int i = 0; i < n; ++i) {
    auto& one = plane[slot_of(i)];
    soften(layer, one);
    deepest = std::max(deepest, one.deepest);
  }
  if (!(deepest > layer.depth)) return n;
  Planes<Dim> firm;
  const int m = common_planes<Dim>(lower, upper, section, firm,
                                   {.middle = true,
                                    .opening = needs.opening - layer.depth,
                                    .limit = needs.limit,
                                    .at_point = needs.at_point});
  for (int j = 0; j < m; ++j) {
    const auto& under = firm[slot_of(j)];
    const auto end = plane.begin() + n;
    const auto over = std::find_if(plane.begin(), end, [&](const CommonPlane<Dim>& one) {
      return one.ordinal == under.ordinal;
    });
    if (over != end) add_firm(1 - s, under, *over);
  }
  return n;
}

template int layered_planes<2>(const FacePlane<2>&, const FacePlane<2>&, const Section&,
                               const SoftLayer&, Planes<2>&, PlaneNeeds);
template int layered_planes<3>(const FacePlane<3>&, const FacePlane<3>&, const Section&,
                               const SoftLayer&, Planes<3>&, PlaneNeeds);

}  // namespace brunt
