#include <algorithm>
#include <cmath>
#include <map>

#include "app/deck/findings.hpp"
#include "app/setup/scene_checks.hpp"
#include "core/geometry/solid_angle.hpp"

namespace brunt {

namespace {
constexpr Real kHeavy = 0.5;       // of an element or spacing: contact would throw bodies apart
constexpr Real kSamePlace = 1e-9;  // of a spacing: rounding of lattices that coincide
constexpr std::size_t kMostWork = 2e7;  // points times facets that one pair of bodies is worth

/// The skin of one body at time 0: segments in 2D, triangles in 3D, outward; particles have none.
template <int Dim>
struct Skin {
  std::vector<std::array<Vec<Dim>, Dim>> simplices;
  std::vector<Vec<Dim>> points;  // of the skin, or all particles
  Vec<Dim> low = Vec<Dim>::Constant(kInfinity), high = Vec<Dim>::Constant(-kInfinity);
  Real size = kInfinity;  // [m] of an element or a spacing; held or of prescribed motion: none
  bool particles = false, plane = false, rigid = false;

  Vec<Dim> center() const { return 0.5 * (low + high); }
};

Real turn(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Share of the full angle under which a point sees a simplex; the sum is 1 inside a closed skin.
Real angle(const std::array<Vec<2>, 2>& s, const Vec<2>& x) {
  const Vec<2> a = s[0] - x, b = s[1] - x;
  return std::atan2(turn(a, b), a.dot(b)) / (2 * kPi);
}
Real angle(const std::array<Vec3, 3>& s, const Vec3& x) {
  return solid_angle(s[0], s[1], s[2], x) / (4 * kPi);
}

Real distance(const Vec<2>& a, const Vec<2>& b, const Vec<2>& x) {
  const Real t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - x).norm();
}
Real distance(const std::array<Vec<2>, 2>& s, const Vec<2>& x) { return distance(s[0], s[1], x); }
/// To the plane of the triangle where the point lies above it, else to the nearest edge.
Real distance(const std::array<Vec3, 3>& s, const Vec3& x) {
  const Vec3 normal = (s[1] - s[0]).cross(s[2] - s[0]).normalized();
  bool above = true;
  Real nearest = kInfinity;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = s[i], edge = s[(i + 1) % 3] - a;
    above = above && normal.dot(edge.cross(x - a)) >= 0;
    const Real t = std::clamp((x - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + t * edge - x).norm());
  }
  return above ? std::fabs(normal.dot(x - s[0])) : nearest;
}

Vec<2> normal_of(const std::array<Vec<2>, 2>& s) {
  const Vec<2> along = (s[1] - s[0]).normalized();
  return {along[1], -along[0]};
}
Vec3 normal_of(const std::array<Vec3, 3>& s) {
  return (s[1] - s[0]).cross(s[2] - s[0]).normalized();
}

template <int Dim>
std::vector<Skin<Dim>> skins_of(const Deck& deck, Scene<Dim>& scene) {
  std::vector<Skin<Dim>> skins(deck.bodies.size());
  std::vector<std::map<LocalIndex, bool>> used(deck.bodies.size());
  for (auto& solid : scene.solids) {
    const auto& x = solid->points().x;
    const auto& surface = solid->surface();
    const auto at = [&](LocalIndex i) { return x[i]; };
    for (const auto& facet : surface.facets) {
      auto& skin = skins[facet.body];
      if constexpr (Dim == 2) {
        skin.simplices.push_back({at(facet.node[0]), at(facet.node[1])});
      } else {
        skin.simplices.push_back({at(facet.node[0]), at(facet.node[1]), at(facet.node[2])});
        if (facet.n_nodes() == 4) {
          skin.simplices.push_back({at(facet.node[0]), at(facet.node[2]), at(facet.node[3])});
        }
      }
      // A free rigid body may be one facet a side: contact takes it for elements of this depth.
      const Real edge = (at(facet.node[1]) - at(facet.node[0])).norm();
      const Real size = facet.compliance > 0 ? 2 * facet.depth : edge;
      if (!facet.rigid()) skin.size = std::min(skin.size, size);
      for (int k = 0; k < facet.n_nodes(); ++k) {
        const LocalIndex node = facet.node[k];
        if (used[facet.body].emplace(node, true).second) skin.points.push_back(at(node));
      }
    }
    if (solid->n_particles() == 0) continue;
    for (std::size_t i = 0; i < x.size(); ++i) {
      skins[solid->points().body[i]].points.push_back(x[i]);
      skins[solid->points().body[i]].particles = true;
    }
  }
  for (std::size_t b = 0; b < skins.size(); ++b) {
    const auto& body = deck.bodies[b].value;
    auto& skin = skins[b];
    skin.rigid = body.rigid && !deck::follows_forces(body);
    skin.plane = std::holds_alternative<Plane>(body.shape.kind);
    if (skin.particles && body.size) skin.size = body.size->front();
    for (const auto& p : skin.points) {
      skin.low = skin.low.cwiseMin(p), skin.high = skin.high.cwiseMax(p);
    }
  }
  return skins;
}

/// Depth [m] of a point below a skin; 0 outside.
template <int Dim>
Real depth_of(const Vec<Dim>& x, const Skin<Dim>& skin) {
  Real nearest = kInfinity, angles = 0, below = 0;
  for (const auto& simplex : skin.simplices) {
    nearest = std::min(nearest, distance(simplex, x));
    if (!skin.plane) angles += angle(simplex, x);
    below = -normal_of(simplex).dot(x - simplex[0]);
  }
  // Under a plane, but not past its edge.
  if (skin.plane) return below > 0 && nearest < below * (1 + 1e-9) ? below : 0;
  return angles > 0.5 ? nearest : 0;
}

/// Largest depth [m] of the points of one body below the skin of another.
template <int Dim>
Real depth_in(const Skin<Dim>& body, const Skin<Dim>& other) {
  if (other.simplices.empty()) return 0;
  // Whatever lies behind a plane as a whole was put there.
  const auto& first = other.simplices.front();
  if (other.plane && normal_of(first).dot(body.center() - first[0]) <= 0) return 0;
  std::vector<Vec<Dim>> near;
  for (const auto& x : body.points) {
    const bool inside = (x - other.low).minCoeff() > 0 && (other.high - x).minCoeff() > 0;
    if (inside || other.plane) near.push_back(x);
  }
  const std::size_t stride = near.size() * other.simplices.size() / kMostWork + 1;
  Real deepest = 0;
  for (std::size_t i = 0; i < near.size(); i += stride) {
    deepest = std::max(deepest, depth_of(near[i], other));
  }
  return deepest;
}

/// How far inside each other two clouds of particles are: the depth of the first in the box that
/// shares particles closer than half a spacing; 0 where there are none.
/// in_one_place  out: particles of the first in the place of one of the second, to rounding
template <int Dim>
Real depth_of_particles(const Skin<Dim>& a, const Skin<Dim>& b, std::size_t& in_one_place) {
  in_one_place = 0;
  const Real h = std::min(a.size, b.size);
  std::map<std::array<long, Dim>, std::vector<const Vec<Dim>*>> cells;
  const auto cell_of = [&](const Vec<Dim>& x) {
    std::array<long, Dim> cell;
    for (int c = 0; c < Dim; ++c) {
      cell[c] = static_cast<long>(std::floor(x[c] / h));
    }
    return cell;
  };
  for (const auto& x : b.points) {
    if ((x - a.low).minCoeff() > -h && (a.high - x).minCoeff() > -h)
      cells[cell_of(x)].push_back(&x);
  }
  Vec<Dim> low = Vec<Dim>::Constant(kInfinity), high = Vec<Dim>::Constant(-kInfinity);
  for (const auto& x : a.points) {
    constexpr int kAround = Dim == 2 ? 9 : 27;
    for (int k = 0; k < kAround && !cells.empty(); ++k) {
      auto cell = cell_of(x);
      for (int c = 0, rest = k; c < Dim; ++c, rest /= 3) {
        cell[c] += rest % 3 - 1;
      }
      const auto found = cells.find(cell);
      if (found == cells.end()) continue;
      for (const auto* other : found->second) {
        const Real apart = (x - *other).norm();
        if (apart >= kHeavy * h) continue;
        in_one_place += apart < kSamePlace * h ? 1 : 0;
        low = low.cwiseMin(x), high = high.cwiseMax(x);
      }
    }
  }
  return low[0] > high[0] ? 0 : (high - low).minCoeff() + h;
}

/// The shortest way [m] along an axis that parts two boxes, for the first of them.
template <int Dim>
std::string way_out(const Skin<Dim>& a, const Skin<Dim>& b) {
  int axis = 0;
  Real shortest = kInfinity;
  for (int c = 0; c < Dim; ++c) {
    const Real up = b.high[c] - a.low[c], down = b.low[c] - a.high[c];
    const Real way = std::fabs(up) < std::fabs(down) ? up : down;
    if (std::fabs(way) < std::fabs(shortest)) shortest = way, axis = c;
  }
  return deck::length_text(shortest) + " along " + "xyz"[axis];
}
}  // namespace

template <int Dim>
void check_overlaps(const LoadedDeck& loaded, Scene<Dim>& scene,
                    std::vector<DeckProblem>& problems) {
  const Deck& deck = loaded.deck;
  // What could not be read may say that they ignore each other.
  const auto& unread = loaded.wrong;
  if (std::any_of(unread.begin(), unread.end(), [&](const std::string& path) {
        return path.empty() ? !loaded.places.has("contact") : deck::related(path, "contact");
      })) {
    return;
  }
  const auto skins = skins_of(deck, scene);
  const auto ignored = [&](const std::string& a, const std::string& b) {
    bool ignore = deck.contact.fallback.ignore;
    for (const auto& [name, pair] : deck.contact.pairs) {
      const auto &first = pair.between[0], &second = pair.between[1];
      if ((first == a && second == b) || (first == b && second == a)) return pair.options.ignore;
      if (second == "any" && (first == a || first == b)) ignore = pair.options.ignore;
    }
    return ignore;
  };
  for (std::size_t i = 0; i < skins.size(); ++i) {
    for (std::size_t j = i + 1; j < skins.size(); ++j) {
      const auto &a = skins[i], &b = skins[j];
      const std::string &one = deck.bodies[i].name, &two = deck.bodies[j].name;
      const Real gap = std::max((a.low - b.high).maxCoeff(), (b.low - a.high).maxCoeff());
      // Boxes are those of centres of particles: where they touch, centres may meet.
      const bool apart = a.particles && b.particles ? gap > 0 : gap >= 0;
      if ((a.rigid && b.rigid) || apart || ignored(one, two)) continue;
      const Real size = std::min(a.size, b.size);
      std::size_t in_one_place = 0;
      const Real depth = a.particles && b.particles ? depth_of_particles(a, b, in_one_place)
                                                    : std::max(depth_in(a, b), depth_in(b, a));
      if (depth <= kHeavy * size) continue;
      if (in_one_place > 0) {
        problems.push_back(loaded.places.problem(
            "bodies." + two + ".shape",
            "has " + std::to_string(in_one_place) +
                " particles in the very places of particles of '" + one +
                "': they have no direction to push each other in; move one of the bodies"));
        continue;
      }
      problems.push_back(loaded.places.problem(
          "bodies." + two + ".shape",
          "is inside '" + one + "' by " + deck::length_text(depth) + " at time 0 (an element has " +
              deck::length_text(size) + "): contact would throw them apart; moving '" + two +
              "' by " + way_out(b, a) + " parts them, and contact.pairs with between: [" + one +
              ", " + two + "], ignore: true lets them be"));
    }
  }
}

template void check_overlaps<2>(const LoadedDeck&, Scene<2>&, std::vector<DeckProblem>&);
template void check_overlaps<3>(const LoadedDeck&, Scene<3>&, std::vector<DeckProblem>&);

}  // namespace brunt
