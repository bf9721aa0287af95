// The potential of the overlap of two faces in 3D (contact/geometry/overlap_push.hpp).
#include <algorithm>
#include <cmath>

#include "contact/geometry/overlap_gradient.hpp"

namespace brunt {

namespace {
/// An edge of the outline of a face in the plane, and the corners of the face at its ends.
struct Edge {
  Vec<2> from, along;  ///< [m]
  std::size_t first, last;

  /// Where p lies along it, 0 .. 1.
  Real share(const Vec<2>& p) const {
    const Real squared = along.squaredNorm();
    return squared > 0 ? (p - from).dot(along) / squared : 0.0;
  }
  /// Unit, into the face.
  Vec<2> inward() const { return Vec<2>(-along[1], along[0]).normalized(); }
};

/// Edge number side of a face's polygon; corners of the upper face run back in it.
Edge edge_of(const OverlapArea& overlap, bool of_upper, int side) {
  const Polygon& face = of_upper ? overlap.above : overlap.below;
  const int next = side + 1 == face.size ? 0 : side + 1;
  const auto corner = [&](int k) { return slot_of(of_upper ? face.size - 1 - k : k); };
  return {face[side], face[next] - face[side], corner(side), corner(next)};
}

/// Number in its polygon of the edge from corner c of a face to the next, and back.
int side_of_edge(const Polygon& face, bool of_upper, int c) {
  return of_upper ? (2 * face.size - 2 - c) % face.size : c;
}

/// Two borders between which the overlap fades, with dU/dA by the distance from both.
struct Room {
  Edge lower, upper;
  Real weight, by_facing;

  Real at(const Vec<2>& p) const {
    return weight * (lower.inward().dot(p - lower.from) + upper.inward().dot(p - upper.from));
  }
};

/// The edge of a face from its corner c to the next.
Edge border_of(const OverlapArea& overlap, bool of_upper, int c) {
  return edge_of(overlap, of_upper,
                 side_of_edge(of_upper ? overlap.above : overlap.below, of_upper, c));
}

bool is_border(const OverlapArea& overlap, bool of_upper, int c) {
  return ((of_upper ? overlap.upper_borders : overlap.lower_borders) >> c & 1U) != 0;
}

Real cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Which part of the way from the border of the lower face to that of the upper the overlap has.
Real filled_part(const CommonPlane<3>& plane, const Vec<2>& inward, Real between) {
  Real least = kInfinity, most = -kInfinity;
  for (int i = 0; i < plane.polygon.size; ++i) {
    const Real at = inward.dot(plane.polygon[i]);
    least = std::min(least, at), most = std::max(most, at);
  }
  return most - least < between ? (most - least) / between : 1.0;
}

class AreaGradient {
 public:
  AreaGradient(const OverlapArea& overlap, const BorderFade<3>& fade, Real layer,
               const CommonPlane<3>& plane)
      : overlap_(overlap),
        plane_(plane),
        layer_(layer),
        density_(fade, plane),
        c_(plane.half_cosine()) {
    for (std::size_t k = 0; k < slot_of(fade.n); ++k) {
      const auto& pair = fade.pair[k];
      rooms_[n_rooms_++] = {border_of(overlap, false, pair.lower),
                            border_of(overlap, true, pair.upper), density_.by_room[k],
                            plane.energy_by_fade * pair.by_facing};
    }
    const auto& sum = overlap.sum;
    push(2 * density_.squared * c_ * sum.total + density_.linear * sum.area,
         2 * density_.squared * c_ * sum.moment + density_.linear * sum.first);
    for (int i = 0; i < plane.polygon.size; ++i) add_side(i);
    if (overlap.deep.squared > 0) add_barrier(overlap.deep);
    for (std::size_t k = 0; k < n_rooms_; ++k) {
      const Room& room = rooms_[k];
      move_border(room.lower, room.upper, room, gradient_.lower);
      move_border(room.upper, room.lower, room, gradient_.upper);
    }
  }
  OverlapGradient<3>& gradient() { return gradient_; }

 private:
  Vec3 in_space(const Vec<2>& p) const { return p[0] * plane_.axis_1 + p[1] * plane_.axis_2; }

  void push(Real by_depth, const Vec<2>& moment) {
    gradient_.push += by_depth;
    gradient_.push_moment += in_space(moment);
  }

  /// Moves the side by what moves the edge that it lies on, or by G where it is 0 along it.
  void add_side(int i) {
    const auto& area = plane_.polygon;
    const Vec<2>& p = area[i];
    const Vec<2>& q = area[i + 1 == area.size ? 0 : i + 1];
    const Real a = c_ * overlap_.penetration.at(p), b = c_ * overlap_.penetration.at(q);
    const Real at_p = density_.linear * a + rooms_at(p) + density_.uniform;
    const Real at_q = density_.linear * b + rooms_at(q) + density_.uniform;
    // Along the side, and weighted by 0 .. 1 along it; quadratic and linear functions, exact.
    const Real all = density_.squared * (a * a + a * b + b * b) / 3 + (at_p + at_q) / 2;
    const Real late =
        density_.squared * (a * a + 2 * a * b + 3 * b * b) / 12 + (at_p + 2 * at_q) / 6;
    const int side = area.side[slot_of(i)];
    if (side != Polygon::kCut) return move_side(p, q, side, {all, late});
    if (n_rooms_ == 0) return;
    const Real width = (q - p).norm() / (c_ * overlap_.penetration.slope.norm());
    push(width * all, width * ((all - late) * p + late * q));
  }

  /// The push of the barrier, and what it has along the sides of the faces.
  void add_barrier(const DeepArea& deep) {
    push(3 * density_.cubed * deep.squared, 3 * density_.cubed * deep.moment);
    const auto& area = deep.polygon;
    for (int i = 0; i < area.size; ++i) {
      const int side = area.side[slot_of(i)];
      if (side == Polygon::kCut) continue;
      const Vec<2>& p = area[i];
      const Vec<2>& q = area[i + 1 == area.size ? 0 : i + 1];
      const SideMeans means = cubic_means(std::max(deep.u.at(p), 0.0), std::max(deep.u.at(q), 0.0));
      move_side(p, q, side, {density_.cubed * means.all, density_.cubed * means.late});
    }
  }

  /// Moves the side from p to q by what moves the edge that it lies on, and by the border of the
  /// other face that is flush with it; dU/dA along it.
  void move_side(const Vec<2>& p, const Vec<2>& q, int side, const SideMeans& density) {
    const Vec<2> out(q[1] - p[1], p[0] - q[0]);  // as long as the side
    if (out[0] == 0 && out[1] == 0) return;
    const bool of_upper = side >= Polygon::kOfSecond;
    const int number = of_upper ? side - Polygon::kOfSecond : side;
    const Edge edge = edge_of(overlap_, of_upper, number);
    const int corner = of_upper ? side_of_edge(overlap_.above, true, number) : number;
    Real moved = 0;
    if (layer_ > 0 && is_border(overlap_, of_upper, corner)) {
      moved = move_flush(p, q, edge, of_upper, out, density);
    }
    move_edge(edge, of_upper, edge.share(p), edge.share(q), (1 - moved) * out, density);
  }

  /// Moves the borders of the other face that are flush with an edge; returns the part that they
  /// have.
  Real move_flush(const Vec<2>& p, const Vec<2>& q, const Edge& edge, bool of_upper,
                  const Vec<2>& out, const SideMeans& density) {
    const Polygon& own = of_upper ? overlap_.above : overlap_.below;
    const Polygon& other = of_upper ? overlap_.below : overlap_.above;
    Real moved = 0;
    for (int c = 0; c < other.size; ++c) {
      if (!is_border(overlap_, !of_upper, c)) continue;
      const Edge border = border_of(overlap_, !of_upper, c);
      const Vec<2> in = border.inward();
      const Real width = std::min(area(own) / edge.along.norm(), area(other) / border.along.norm());
      const Real part =
          layer_ * part_of_flush(in.dot(0.5 * (p + q) - border.from), in.dot(edge.inward()), width);
      if (part == 0) continue;
      // Where `out` meets the border: the force keeps its line.
      const Real per_length = 1 / cross(border.along, out);
      move_edge(border, !of_upper, cross(p - border.from, out) * per_length,
                cross(q - border.from, out) * per_length, part * out, density);
      moved += part;
    }
    return moved;
  }

  /// Moves an edge by `out`, from one share of it to another by what density has along there.
  void move_edge(const Edge& edge, bool of_upper, Real begins, Real ends, const Vec<2>& out,
                 const SideMeans& density) {
    const auto [all, late] = density;
    const Real of_last = begins * all + (ends - begins) * late;
    auto& corners = of_upper ? gradient_.upper : gradient_.lower;
    corners[edge.first] += (all - of_last) * in_space(out);
    corners[edge.last] += of_last * in_space(out);
  }

  Real rooms_at(const Vec<2>& p) const {
    Real sum = 0;
    for (std::size_t k = 0; k < n_rooms_; ++k) sum += rooms_[k].at(p);
    return sum;
  }

  /// Moves the line from which distances are taken, and turns it against the other one.
  void move_border(const Edge& edge, const Edge& other, const Room& room,
                   std::array<Vec3, 4>& corners) const {
    const auto& sum = overlap_.sum;
    const Vec3 in = room.weight * sum.area * in_space(edge.inward());
    const Real share = edge.share(sum.first / sum.area);
    const Vec<2> t = edge.along.normalized(), o = other.along.normalized();
    const Vec3 turn = room.by_facing / edge.along.norm() * in_space(Vec<2>(o.dot(t) * t - o));
    corners[edge.first] -= (1 - share) * in + turn;
    corners[edge.last] -= share * in - turn;
  }

  const OverlapArea& overlap_;
  const CommonPlane<3>& plane_;
  Real layer_;
  Density<3> density_;
  std::array<Room, BorderFade<3>::kMost> rooms_;
  std::size_t n_rooms_ = 0;
  Real c_;
  OverlapGradient<3> gradient_;
};
}  // namespace

BorderFade<3> fade_of(const FacePlane<3>& lower, const FacePlane<3>& upper,
                      const OverlapArea& overlap, const CommonPlane<3>& plane) {
  BorderFade<3> fade;
  if (lower.borders == 0 || upper.borders == 0) return fade;
  const auto& sum = overlap.sum;
  const Real volume = plane.half_cosine() * sum.total;
  const auto room_of = [&](const Edge& edge) {
    return edge.inward().dot(sum.first - sum.area * edge.from);
  };
  for (int i = 0; i < lower.n_corners; ++i) {
    if (!is_border(overlap, false, i)) continue;
    const Edge of_lower = border_of(overlap, false, i);
    for (int j = 0; j < upper.n_corners; ++j) {
      if (!is_border(overlap, true, j)) continue;
      const Edge of_upper = border_of(overlap, true, j);
      const Real room = room_of(of_lower) + room_of(of_upper);
      fade.add(i, j, -of_lower.inward().dot(of_upper.inward()),
               {volume, room, sum.area, filled_part(plane, of_lower.inward(), room / sum.area),
                overlap.limit});
    }
  }
  return fade;
}

void add_potential(const FacePlane<3>& lower, const FacePlane<3>& upper, const OverlapArea& overlap,
                   const BorderFade<3>& fade, const PotentialShare& share, CommonPlane<3>& plane) {
  AreaGradient area(overlap, fade, share.layer, plane);
  finish(lower, upper, overlap.opening, share.value, area.gradient(), plane);
}

}  // namespace brunt
// Tested by tests/unit/contact/overlap_push_test.cpp.
