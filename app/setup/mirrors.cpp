#include "app/setup/mirrors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace brunt {

namespace {
/// [1] Of a spacing. Lattices end half a spacing before a plane, hexagonal ones a quarter.
constexpr Real kBeside = 0.75, kOn = 0.15;

/// How a sum lies to a plane.
struct Extent {
  Real least = kInfinity, most = -kInfinity;  ///< [m] above the plane
  Real nearest = kInfinity;                   ///< [1] to it, over the spacing
  Label first = 0;                            ///< body of the particle nearest to it
};

template <int Dim>
std::map<Label, Extent> extents(const Points<Dim>& points, int axis, Real at,
                                const std::vector<Real>& spacing, const std::vector<Label>& sums) {
  std::map<Label, Extent> all;
  for (std::size_t i = 0; i < points.owned(); ++i) {
    const Label body = points.body[i];
    Extent& one = all[sums[points.piece[i]]];
    const Real above = points.x[i][axis] - at, away = std::fabs(above) / spacing[body];
    one.least = std::min(one.least, above), one.most = std::max(one.most, above);
    if (away < one.nearest) one.nearest = away, one.first = body;
  }
  return all;
}

/// What is wrong with a sum at a plane; "": nothing.
std::string obstacle(const Extent& one, const std::string& body) {
  if (one.nearest < kOn) {
    return "particles of '" + body +
           "' lie on the plane, and would coincide with their images: let its shape end at the "
           "plane, which leaves them half a spacing beside it";
  }
  if (one.least < 0 && one.most > 0) {
    return "'" + body + "' lies on both sides of the plane: take the half of it away";
  }
  return "";
}
}  // namespace

template <int Dim>
Mirrors<Dim> mirrors_of(const LoadedDeck& loaded, const Scene<Dim>& scene,
                        const Points<Dim>& points, const std::vector<Real>& spacing,
                        const std::vector<Label>& sums) {
  Mirrors<Dim> mirrors;
  if (!loaded.deck.symmetry) return mirrors;
  std::vector<DeckProblem> problems;
  for (int axis = 0; axis < Dim; ++axis) {
    const auto& place = loaded.deck.symmetry->across(axis);
    if (!place) continue;
    auto& plane = mirrors.plane[slot_of(axis)];
    plane.at = *place - scene.origin[axis];
    for (const auto& [sum, one] : extents(points, axis, plane.at, spacing, sums)) {
      if (one.nearest > kBeside) continue;
      const std::string wrong = obstacle(one, loaded.deck.bodies[one.first].name);
      const std::string path = std::string("symmetry.") + static_cast<char>('x' + axis);
      if (!wrong.empty()) problems.push_back(loaded.places.problem(path, wrong));
      plane.sums.push_back({sum, one.least > 0 ? 1.0 : -1.0});
    }
  }
  if (!problems.empty()) throw DeckError(problems);
  return mirrors;
}

template Mirrors<2> mirrors_of(const LoadedDeck&, const Scene<2>&, const Points<2>&,
                               const std::vector<Real>&, const std::vector<Label>&);
template Mirrors<3> mirrors_of(const LoadedDeck&, const Scene<3>&, const Points<3>&,
                               const std::vector<Real>&, const std::vector<Label>&);

}  // namespace brunt
// Tested by tests/unit/app/mirrors_test.cpp.
