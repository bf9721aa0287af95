#include "sph/mirrors.hpp"

#include <algorithm>

namespace brunt {

template <int Dim>
bool Mirrors<Dim>::any() const {
  return std::any_of(plane.begin(), plane.end(),
                     [](const Plane& one) { return !one.sums.empty(); });
}

template <int Dim>
MirrorAxes Mirrors<Dim>::across(Label sum) const {
  MirrorAxes axes = 0;
  for (int c = 0; c < Dim; ++c) {
    const auto& sums = plane[slot_of(c)].sums;
    const auto found = std::ranges::lower_bound(sums, sum, {}, &Sum::sum);
    if (found != sums.end() && found->sum == sum) axes |= MirrorAxes{1} << c;
  }
  return axes;
}

template <int Dim>
Real Mirrors<Dim>::distance(const Vec<Dim>& x, int axis, Label sum) const {
  const Plane& one = plane[slot_of(axis)];
  return std::ranges::lower_bound(one.sums, sum, {}, &Sum::sum)->side * (x[axis] - one.at);
}

template struct Mirrors<2>;
template struct Mirrors<3>;

}  // namespace brunt
// Tested by tests/unit/sph/mirrors_test.cpp.
