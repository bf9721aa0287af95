#include "contact/geometry/particle_face.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <span>

namespace brunt {

namespace {
/// Distances that differ by less than this part of the radius are equal.
constexpr Real kSameDistance = 1e-9;

using Edge = std::pair<LocalIndex, LocalIndex>;

/// The nodes of the nearest feature, ascending; a vertex twice.
template <int Dim>
Edge feature_nodes(const ParticleHit<Dim>& hit) {
  const auto a = hit.node[slot_of(hit.nearest.corner[0])];
  const auto b = hit.node[slot_of(hit.nearest.corner[1])];
  return {std::min(a, b), std::max(a, b)};
}

/// Without a branch: where it stands changes from face to face.
template <int Dim>
int corner_of(const ParticleHit<Dim>& hit, LocalIndex node) {
  unsigned at = 0;
  for (int c = 0; c < ParticleHit<Dim>::kCorners; ++c) {
    at |= (hit.node[slot_of(c)] == node ? 1U : 0U) << c;
  }
  at &= (1U << hit.plane->n_corners) - 1;
  return at == 0 ? -1 : std::countr_zero(at);
}

template <int Dim>
bool has_edge(const ParticleHit<Dim>& hit, const Edge& edge) {
  const int a = corner_of(hit, edge.first), b = corner_of(hit, edge.second);
  const int apart = std::abs(a - b);
  return (a >= 0) & (b >= 0) & ((apart == 1) | (apart == hit.plane->n_corners - 1));
}

template <int Dim>
bool holds(const ParticleHit<Dim>& hit, Feature feature, const Edge& nodes) {
  return feature == Feature::edge ? has_edge(hit, nodes) : corner_of(hit, nodes.first) >= 0;
}

/// Drops an edge or vertex that another face holds and knows better: nearer, or equally near by a
/// higher feature, or by the same feature with a smaller id.
template <int Dim>
void drop_shared(std::span<ParticleHit<Dim>> hits, Real radius) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    auto& hit = hits[i];
    if (hit.nearest.feature == Feature::face) continue;
    const Edge nodes = feature_nodes(hit);
    for (std::size_t j = 0; j < hits.size() && hit.kept; ++j) {
      const auto& other = hits[j];
      if (j == i || !holds(other, hit.nearest.feature, nodes)) continue;
      const Real farther = hit.nearest.distance - other.nearest.distance;
      const bool same =
          other.nearest.feature == hit.nearest.feature && feature_nodes(other) == nodes;
      if (same) {
        hit.kept = i < j;
      } else if (farther > kSameDistance * radius) {
        hit.kept = false;
      } else if (farther >= -kSameDistance * radius) {
        hit.kept = !(other.nearest.feature < hit.nearest.feature);
      }
    }
  }
}

Real angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Normal of the part of a face that has its edge from corner `first` on. Particles see a quad as
/// four triangles: where a surface folds sharply, the mean planes of warped quads beside the edge
/// may have a sum that looks to the other side than that of these triangles.
Vec3 normal_beside(const FacePlane<3>& face, int first) {
  if (face.n_corners == 3) return face.normal;
  const Vec3& a = face.corner[slot_of(first)];
  const Vec3 twice = (face.corner[slot_of((first + 1) % 4)] - a).cross(face.center - a);
  const Real norm = twice.norm();
  return norm > 0 ? Vec3(twice / norm) : Vec3(Vec3::Zero());
}

/// Of an edge, of which both corners are given, or of a vertex: normals of the parts of a face that
/// meet there, at a vertex each by its angle.
Vec3 normal_at(const FacePlane<3>& face, int corner, int other) {
  const int n = face.n_corners, next = (corner + 1) % n, last = (corner + n - 1) % n;
  if (other == next) return normal_beside(face, corner);
  if (other == last) return normal_beside(face, last);
  const auto arm = [&](const Vec3& to) -> Vec3 { return to - face.corner[slot_of(corner)]; };
  const Vec3 a = arm(face.corner[slot_of(next)]), b = arm(face.corner[slot_of(last)]);
  if (n == 3) return angle_between(a, b) * face.normal;
  const Vec3 c = arm(face.center);
  return angle_between(a, c) * normal_beside(face, corner) +
         angle_between(c, b) * normal_beside(face, last);
}
Vec<2> normal_at(const FacePlane<2>& face, int, int) { return face.normal; }

/// Sum of the normals about an edge or vertex by their angles, and whether the faces close it. With
/// those of the triangles that meet there it looks to the side of what is nearest to it: outside,
/// an arm is a n_1 + b n_2 with a, b >= 0, and (n_1 + n_2) . arm = (a + b)(1 + n_1 . n_2) >= 0.
template <int Dim>
bool closed_normal(std::span<const ParticleHit<Dim>> hits, const ParticleHit<Dim>& hit,
                   Vec<Dim>& normal) {
  const Edge nodes = feature_nodes(hit);
  const bool is_edge = hit.nearest.feature == Feature::edge;
  normal.setZero();
  int faces = 0;
  bool closed = true;
  for (const auto& face : hits) {
    if (!holds(face, hit.nearest.feature, nodes)) continue;
    ++faces;
    const int corner = corner_of(face, nodes.first);
    normal += normal_at(*face.plane, corner, is_edge ? corner_of(face, nodes.second) : -1);
    if (Dim == 2 || is_edge) continue;
    // Each edge at the vertex must belong to a second face.
    const int n = face.plane->n_corners;
    for (const int step : {1, n - 1}) {
      const auto next = face.node[slot_of((corner + step) % n)];
      int holders = 0;
      for (const auto& other : hits) {
        holders += has_edge(other, {nodes.first, next}) ? 1 : 0;
      }
      closed = closed && holders == 2;
    }
  }
  return Dim == 3 && !is_edge ? closed : faces == 2;
}

/// Side, direction and overlap of one hit.
template <int Dim>
void find_side(const Vec<Dim>& x, Real radius, std::span<const ParticleHit<Dim>> hits,
               ParticleHit<Dim>& hit) {
  const Vec<Dim> arm = x - hit.nearest.point;
  Vec<Dim> outward = hit.nearest.normal;
  bool closed = true;
  if (hit.nearest.feature != Feature::face) {
    closed = closed_normal<Dim>(hits, hit, outward);
  } else if (!hit.nearest.smooth) {
    outward = hit.plane->normal;
  }
  if (hit.open) {
    const int present = outward.dot(arm) < 0 ? -1 : 1;
    hit.side = closed ? (hit.side == 0 ? present : hit.side) : 0;
    if (hit.side < 0) outward = -outward;
  }
  hit.inside = closed && outward.dot(arm) < 0;
  if (hit.nearest.smooth) {
    hit.direction = outward;
  } else if (hit.nearest.distance > 1e-12 * radius) {
    hit.direction = (hit.inside ? -1.0 : 1.0) / hit.nearest.distance * arm;
  } else {
    hit.direction = outward.normalized();
  }
  hit.overlap = radius + (hit.inside ? hit.nearest.distance : -hit.nearest.distance);
}

/// Drops what lies behind the other side of a plate while the side of entry holds the centre:
/// squeezed, it may be nearer.
template <int Dim>
void keep_side_of_entry(std::span<ParticleHit<Dim>> hits) {
  for (const auto& own : hits) {
    if (own.entry <= 0 || !own.kept || !own.inside || own.nearest.distance > own.limit) continue;
    for (auto& hit : hits) {
      const bool same_body = hit.body == own.body && hit.piece == own.piece;
      if (same_body && hit.entry < 0) hit.kept = false;
    }
  }
}

template <int Dim>
bool is_held(Real radius, const ParticleHit<Dim>& hit) {
  const bool touches = hit.overlap >= -kTouchingGap * 2 * radius;
  return touches && (!hit.inside || hit.nearest.distance <= hit.limit);
}

/// A centre behind a surface belongs to the nearest face of that body; outside, to all it overlaps.
template <int Dim>
void keep_nearest_side(Real radius, std::span<ParticleHit<Dim>> hits) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    auto& hit = hits[i];
    if (!hit.kept || !hit.inside) continue;
    for (std::size_t j = 0; j < hits.size() && hit.kept; ++j) {
      const auto& other = hits[j];
      const bool same_body = other.body == hit.body && other.piece == hit.piece;
      if (j == i || !same_body || !other.kept) continue;
      const Real nearer = hit.nearest.distance - other.nearest.distance;
      if (nearer > 0 || (nearer == 0 && j < i)) hit.kept = false;
    }
  }
  for (auto& hit : hits) hit.kept = hit.kept && is_held(radius, hit);
}

/// The same as below of one that is kept alone: what is dropped takes no part.
template <int Dim>
void choose_alone(const Vec<Dim>& x, Real radius, std::span<const ParticleHit<Dim>> all,
                  ParticleHit<Dim>& hit) {
  find_side<Dim>(x, radius, all, hit);
  hit.kept = is_held(radius, hit);
  if (!hit.kept || !(hit.overlap > 0)) return;
  hit.share = hit.overlap / (hit.overlap * std::max(0.0, hit.direction.dot(hit.direction)));
}
}  // namespace

template <int Dim>
void choose_hits(const Vec<Dim>& x, Real radius, std::vector<ParticleHit<Dim>>& hits) {
  const std::span<ParticleHit<Dim>> all(hits);
  for (auto& hit : all) hit.kept = true, hit.share = 0;
  if (all.size() > 1) drop_shared(all, radius);
  std::size_t kept = 0;
  ParticleHit<Dim>* last = nullptr;
  for (auto& hit : all) {
    kept += hit.kept ? 1 : 0;
    last = hit.kept ? &hit : last;
  }
  if (kept == 1) return choose_alone<Dim>(x, radius, all, *last);
  for (auto& hit : all) {
    if (hit.kept) find_side<Dim>(x, radius, all, hit);
  }
  keep_side_of_entry(all);
  keep_nearest_side(radius, all);
  for (auto& hit : all) {
    if (!hit.kept || !(hit.overlap > 0)) continue;
    Real along = 0;
    for (const auto& other : all) {
      if (!other.kept || !(other.overlap > 0)) continue;
      along += other.overlap * std::max(0.0, hit.direction.dot(other.direction));
    }
    hit.share = hit.overlap / along;
  }
}

template <int Dim>
void join_at_axis(Real radius, std::vector<ParticleHit<Dim>>& hits) {
  const auto on_axis = [&](const ParticleHit<Dim>& hit, int corner) {
    return std::fabs(hit.plane->corner[slot_of(corner)][0]) <= kTouchingGap * radius;
  };
  std::erase_if(hits, [&](const auto& hit) { return on_axis(hit, 0) && on_axis(hit, 1); });
  for (auto& hit : hits) {
    if (on_axis(hit, hit.nearest.corner[0])) hit.nearest.feature = Feature::face;
  }
}

template void join_at_axis(Real, std::vector<ParticleHit<2>>&);
template void join_at_axis(Real, std::vector<ParticleHit<3>>&);
template void choose_hits<2>(const Vec<2>&, Real, std::vector<ParticleHit<2>>&);
template void choose_hits<3>(const Vec<3>&, Real, std::vector<ParticleHit<3>>&);

}  // namespace brunt
