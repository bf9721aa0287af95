#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "core/geometry/brick_wall.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/profile.hpp"
#include "core/geometry/wedge.hpp"

namespace brunt {

namespace {
/// Number of particles of spacing d along a length, and the spacing that fills it.
std::pair<int, Real> layers(Real length, Real d) {
  const int n = std::max(1, static_cast<int>(std::ceil(length / d * (1 - 1e-9))));
  return {n, length / n};
}

/// Centres of a lattice in the box low .. high, half a spacing from its faces, along the last axis
/// fastest; a hexagonal lattice shifts every second row, and every second layer.
template <int Dim>
std::vector<Vec<Dim>> lattice_points(const Vec<Dim>& low, const Vec<Dim>& high,
                                     const std::vector<Real>& spacing, LatticeKind kind) {
  const bool hexagonal = kind == LatticeKind::hexagonal;
  // Rows of a triangular lattice are sqrt(3)/2 apart, layers of the hexagonal one sqrt(2/3).
  const Real factor[3] = {1, hexagonal ? std::sqrt(0.75) : 1, hexagonal ? std::sqrt(2.0 / 3) : 1};
  std::array<int, 3> n{1, 1, 1};
  Real d[3] = {0, 0, 0};
  for (int c = 0; c < Dim; ++c) {
    const Real h = spacing[std::min<std::size_t>(slot_of(c), spacing.size() - 1)];
    std::tie(n[c], d[c]) = layers(high[c] - low[c], h * factor[c]);
  }
  std::vector<Vec<Dim>> points;
  for (int i = 0; i < n[0]; ++i) {
    for (int j = 0; j < n[1]; ++j) {
      for (int k = 0; k < n[2]; ++k) {
        const int cell[3] = {i, j, k};
        Vec<Dim> x;
        for (int c = 0; c < Dim; ++c) x[c] = low[c] + (cell[c] + 0.5) * d[c];
        if (hexagonal) {
          x[0] += 0.25 * d[0] * ((j + k) % 2 == 0 ? -1 : 1);
          if (Dim == 3) x[1] += d[1] / 6 * (k % 2 == 0 ? -1 : 1);
        }
        points.push_back(x);
      }
    }
  }
  return points;
}

/// What a shape is to the filler: a box that holds it in a local frame, an inside test, its volume.
template <int Dim>
struct Region {
  Vec<Dim> low, high;                           // [m] local
  std::function<bool(const Vec<Dim>&)> inside;  // local
  std::function<Vec<Dim>(const Vec<Dim>&)> place = [](const Vec<Dim>& x) { return x; };
  Real volume = 0;  // [m^Dim]
};

/// A box about the axis whose sides are whole numbers of spacings: the lattice is symmetric.
Real rounded_up(Real radius, const std::vector<Real>& spacing) {
  const Real d = spacing.front();
  return d * std::ceil(radius / d * (1 - 1e-9));
}

Region<3> revolved(const std::vector<Real>& base, const std::vector<Real>& axis, Real inner,
                   const Profile& profile, const std::vector<Real>& spacing) {
  const Frame3 frame = frame_along(base, axis);
  const Real r = rounded_up(profile.largest(), spacing);
  Region<3> region;
  region.low = Vec3(-r, -r, 0), region.high = Vec3(r, r, profile.length);
  region.inside = [inner, profile](const Vec3& x) {
    const Real radius = std::hypot(x[0], x[1]);
    return radius >= inner && radius <= profile.radius(x[2]);
  };
  region.place = [frame](const Vec3& x) { return frame.place(x); };
  region.volume = profile.volume() - kPi * inner * inner * profile.length;
  return region;
}

template <int Dim>
Region<Dim> box_region(const Vec<Dim>& low, const Vec<Dim>& high) {
  Region<Dim> region;
  region.low = low, region.high = high;
  region.inside = [](const Vec<Dim>&) { return true; };
  region.volume = (high - low).prod();
  return region;
}

/// A flat region about a centre between two radii.
Region<2> disc_region(const std::vector<Real>& center, Real inner, Real outer,
                      const std::vector<Real>& spacing) {
  const Vec<2> c = to_vector<2>(center);
  const Real r = rounded_up(outer, spacing);
  Region<2> region;
  region.low = Vec<2>(-r, -r), region.high = Vec<2>(r, r);
  region.inside = [inner, outer](const Vec<2>& x) {
    return x.norm() >= inner && x.norm() <= outer;
  };
  region.place = [c](const Vec<2>& x) { return Vec<2>(x + c); };
  region.volume = kPi * (outer * outer - inner * inner);
  return region;
}

Region<2> polygon_region(const PolygonShape& polygon) {
  Region<2> region;
  region.low = Vec<2>::Constant(kInfinity), region.high = Vec<2>::Constant(-kInfinity);
  std::vector<Vec<2>> points;
  for (const auto& point : polygon.points) {
    points.push_back(to_vector<2>(point));
    region.low = region.low.cwiseMin(points.back());
    region.high = region.high.cwiseMax(points.back());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& a = points[i];
    const auto& b = points[(i + 1) % points.size()];
    region.volume += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  require_simple(points);
  region.volume = std::fabs(region.volume);
  region.inside = [points](const Vec<2>& x) { return inside_polygon(points, x); };
  return region;
}

struct Filler3 {
  const std::vector<Real>& spacing;
  Region<3> operator()(const Box& b) const {
    return box_region<3>(to_vector<3>(b.min), to_vector<3>(b.max));
  }
  Region<3> operator()(const Cylinder& c) const {
    return revolved(c.base, c.axis, 0, cylinder_profile(c.radius, c.length), spacing);
  }
  Region<3> operator()(const Tube& t) const {
    return revolved(t.base, t.axis, t.inner, cylinder_profile(t.outer, t.length), spacing);
  }
  Region<3> operator()(const Ogive& o) const {
    return revolved(o.base, o.axis, 0, ogive_profile(o), spacing);
  }
  Region<3> operator()(const Sphere& s) const {
    const Vec3 center = to_vector<3>(s.center);
    const Real r = rounded_up(s.radius, spacing), radius = s.radius;
    Region<3> region;
    region.low = Vec3(-r, -r, -r), region.high = Vec3(r, r, r);
    region.inside = [radius](const Vec3& x) { return x.norm() <= radius; };
    region.place = [center](const Vec3& x) { return Vec3(x + center); };
    region.volume = 4.0 / 3 * kPi * radius * radius * radius;
    return region;
  }
  Region<3> operator()(const PolygonShape& p) const {
    if (!(p.thickness > 0)) throw std::invalid_argument("a polygon needs `thickness` in 3D");
    const Region<2> flat = polygon_region(p);
    Region<3> region;
    region.low << flat.low, p.base;
    region.high << flat.high, p.base + p.thickness;
    region.inside = [flat](const Vec3& x) { return flat.inside(x.head<2>()); };
    region.volume = flat.volume * p.thickness;
    return region;
  }
  Region<3> operator()(const Wedge& w) const { return (*this)(polygon_of(w)); }
  Region<3> operator()(const Plane&) const {
    throw std::invalid_argument("a plane has no volume to fill with particles");
  }
  Region<3> operator()(const BrickWall&) const { throw std::logic_error("walls fill by brick"); }
};

struct Filler2 {
  const std::vector<Real>& spacing;
  Region<2> operator()(const Box& b) const {
    return box_region<2>(to_vector<2>(b.min), to_vector<2>(b.max));
  }
  Region<2> operator()(const Cylinder& c) const {
    return disc_region(c.base, 0, c.radius, spacing);
  }
  Region<2> operator()(const Tube& t) const {
    return disc_region(t.base, t.inner, t.outer, spacing);
  }
  Region<2> operator()(const Sphere& s) const {
    return disc_region(s.center, 0, s.radius, spacing);
  }
  Region<2> operator()(const PolygonShape& p) const { return polygon_region(p); }
  Region<2> operator()(const Wedge& w) const { return polygon_region(polygon_of(w)); }
  Region<2> operator()(const Ogive& o) const {
    const Profile profile = ogive_profile(o);
    Vec<2> along = to_vector<2>(o.axis);
    if (!(along.norm() > 0)) throw std::invalid_argument("the axis has no length in the plane");
    along.normalize();
    const Vec<2> across(-along[1], along[0]), base = to_vector<2>(o.base);
    const Real r = rounded_up(o.radius, spacing);
    Region<2> region;
    region.low = Vec<2>(0, -r), region.high = Vec<2>(o.length, r);
    region.inside = [profile](const Vec<2>& x) { return std::fabs(x[1]) <= profile.radius(x[0]); };
    region.place = [=](const Vec<2>& x) { return Vec<2>(base + x[0] * along + x[1] * across); };
    region.volume = profile.area();
    return region;
  }
  Region<2> operator()(const Plane&) const {
    throw std::invalid_argument("a plane has no volume to fill with particles");
  }
  Region<2> operator()(const BrickWall&) const { throw std::logic_error("walls fill by brick"); }
};

/// A lattice is squeezed to fit a shape; less than half a spacing is no room for a particle.
template <int Dim>
void require_room_for_particles(const Vec<Dim>& edges, const std::vector<Real>& spacing) {
  for (int c = 0; c < Dim; ++c) {
    const Real h = spacing[std::min<std::size_t>(slot_of(c), spacing.size() - 1)];
    if (edges[c] >= 0.5 * h) continue;
    std::ostringstream message;
    message << "the shape is " << edges[c] << " m thick along its axis "
            << "xyz"[c] << ", less than half a particle: `size` is " << h
            << " m; give a smaller one";
    throw std::invalid_argument(message.str());
  }
}

template <int Dim>
void fill_region(const Region<Dim>& region, const std::vector<Real>& spacing, LatticeKind lattice,
                 Filling<Dim>& filling) {
  const auto piece = static_cast<Label>(filling.piece_names.size());
  require_room_for_particles<Dim>(region.high - region.low, spacing);
  for (const auto& x : lattice_points<Dim>(region.low, region.high, spacing, lattice)) {
    if (!region.inside(x)) continue;
    filling.points.push_back(region.place(x));
    filling.piece.push_back(piece);
  }
  filling.volume += region.volume;
}
}  // namespace

template <int Dim>
Filling<Dim> fill_shape(const BodyShape& shape, const std::vector<Real>& spacing,
                        LatticeKind lattice) {
  Filling<Dim> filling;
  if (const auto* wall = std::get_if<BrickWall>(&shape.kind)) {
    for (const auto& brick : bricks_of<Dim>(*wall)) {
      fill_region<Dim>(box_region<Dim>(brick.low, brick.high), spacing, lattice, filling);
      filling.piece_names.push_back(brick.name);
    }
  } else {
    using Filler = std::conditional_t<Dim == 3, Filler3, Filler2>;
    fill_region<Dim>(std::visit(Filler{spacing}, shape.kind), spacing, lattice, filling);
    filling.piece_names.emplace_back();
  }
  if (filling.points.empty()) {
    throw std::invalid_argument(
        "no particle fits in: the shape is smaller than one; give a smaller `size`");
  }
  place_all<Dim>(shape, filling.points);
  return filling;
}

namespace {
/// A piece for each room that has particles.
void name_rooms(const ClosedSurface& surface, Filling<3>& filling) {
  constexpr Label kNone = std::numeric_limits<Label>::max();
  std::vector<Label> piece(surface.n_rooms(), kNone);
  for (std::size_t i = 0; i < filling.points.size(); ++i) {
    filling.piece[i] = surface.room_at(filling.points[i]);
    piece[filling.piece[i]] = 0;
  }
  for (std::size_t room = 0; room < piece.size(); ++room) {
    if (piece[room] == kNone) continue;
    piece[room] = static_cast<Label>(filling.piece_names.size());
    filling.piece_names.push_back(std::to_string(room + 1));
  }
  filling.empty = piece.size() - filling.piece_names.size();
  if (piece.size() == 1) filling.piece_names = {""};
  for (Label& one : filling.piece) one = piece[one];
}
}  // namespace

Filling<3> fill_surface(const ClosedSurface& surface, const std::vector<Real>& spacing,
                        LatticeKind lattice) {
  Real count = 1;
  for (int c = 0; c < 3; ++c) count *= (surface.high()[c] - surface.low()[c]) / spacing.front();
  constexpr Real kMost = std::numeric_limits<LocalIndex>::max();
  if (count > kMost) {
    throw std::invalid_argument(
        "its box holds more particles than can be counted: look at `scale`, the length of a unit "
        "of the file, and `size`");
  }
  Region<3> region;
  region.low = surface.low(), region.high = surface.high();
  region.volume = surface.volume();
  region.inside = [&surface](const Vec3& x) {
    const int winding = surface.winding(x);
    if (winding == 0 || winding == 1) return winding == 1;
    std::ostringstream message;
    message << "shells of the surface overlap at (" << x[0] << ", " << x[1] << ", " << x[2]
            << ") m: unite them where they were drawn";
    throw std::invalid_argument(message.str());
  };
  Filling<3> filling;
  fill_region<3>(region, spacing, lattice, filling);
  name_rooms(surface, filling);
  if (filling.points.empty()) {
    throw std::invalid_argument("no particle fits in: give a smaller `size`");
  }
  return filling;
}

template Filling<2> fill_shape<2>(const BodyShape&, const std::vector<Real>&, LatticeKind);
template Filling<3> fill_shape<3>(const BodyShape&, const std::vector<Real>&, LatticeKind);

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
