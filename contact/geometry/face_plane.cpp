#include "contact/geometry/face_plane.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/four_planes.hpp"

namespace brunt {

namespace {
void finish(FacePlane<2>& face) {
  const Vec<2> edge = face.corner[1] - face.corner[0];
  face.center = 0.5 * (face.corner[0] + face.corner[1]);
  face.area = edge.norm();
  face.normal = Vec<2>(edge[1], -edge[0]) / face.area;
}

void finish_triangle(FacePlane<3>& face) {
  const auto& x = face.corner;
  face.center = (x[0] + x[1] + x[2]) / 3;
  const Vec3 twice = (x[1] - x[0]).cross(x[2] - x[0]);
  const Real norm = twice.norm();
  face.area = 0.5 * norm;
  face.normal = twice / norm;
}

/// One formula for a quad by itself and for four side by side.
void finish_quad(FacePlane<3>& face) {
  const auto& x = face.corner;
  const Pack no_start = broadcast<Pack>(0);
  FourPlanes({everywhere(x[0]), everywhere(x[1]), everywhere(x[2]), everywhere(x[3])}, no_start)
      .give(0, face);
}
}  // namespace

template <int Dim>
void refresh(FacePlane<Dim>& face) {
  face.warp = 0;
  face.simple = face.flat = true;
  if constexpr (Dim == 2) {
    finish(face);
  } else if (face.n_corners == 3) {
    finish_triangle(face);
  } else {
    finish_quad(face);
  }
  if (!(face.area > 0) || !(face.normal.squaredNorm() > 0.5)) {
    face.area = 0;
    face.warp = 0;
    face.simple = face.flat = true;
    face.normal.setZero();
  }
}

namespace {
/// All components of a quad at once, from four numbers at each corner; what is read or written
/// beyond the third is not used.
SearchBox<3> box_of_quad(const FacePlane<3>& face, Real reach) {
  static_assert(sizeof(SearchBox<3>) == 6 * sizeof(Real));
  const Real* x = face.corner[0].data();
  const Pack last = load(x + 8);
  Pack lo = load(x), hi = lo;
  for (const Pack corner : {load(x + 3), load(x + 6), Pack{last[1], last[2], last[3], last[0]}}) {
    lo = vmin(corner, lo);
    hi = vmax(corner, hi);
  }
  lo = lo - broadcast<Pack>(reach);
  hi = hi + broadcast<Pack>(reach);
  return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
}
}  // namespace

template <int Dim>
SearchBox<Dim> box_of(const FacePlane<Dim>& face, Real reach) {
  if constexpr (Dim == 3) {
    if (face.n_corners == 4) return box_of_quad(face, reach);
  }
  SearchBox<Dim> box;
  for (int c = 0; c < Dim; ++c) {
    Real lo = face.corner[0][c], hi = lo;
    for (int i = 1; i < face.n_corners; ++i) {
      lo = std::min(lo, face.corner[slot_of(i)][c]);
      hi = std::max(hi, face.corner[slot_of(i)][c]);
    }
    box.lo[slot_of(c)] = lo - reach;
    box.hi[slot_of(c)] = hi + reach;
  }
  return box;
}

std::array<FacePlane<3>, 4> split(const FacePlane<3>& face) {
  std::array<FacePlane<3>, 4> parts;
  for (std::size_t i = 0; i < 4; ++i) {
    auto& part = parts[i];
    part.n_corners = 3;
    part.sharpness = face.sharpness;
    part.corner = {face.corner[i], face.corner[(i + 1) % 4], face.center, Vec3::Zero()};
    // The edge of the face keeps its border; those to the centre are none.
    part.borders = static_cast<std::uint8_t>(face.borders >> i & 1U);
    refresh(part);
    if (part.normal.dot(face.normal) > 0) continue;
    part.area = 0;
    part.normal.setZero();
  }
  return parts;
}

template void refresh<2>(FacePlane<2>&);
template void refresh<3>(FacePlane<3>&);
template SearchBox<2> box_of<2>(const FacePlane<2>&, Real);
template SearchBox<3> box_of<3>(const FacePlane<3>&, Real);

}  // namespace brunt
