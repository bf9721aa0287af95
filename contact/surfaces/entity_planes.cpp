/// Planes and boxes of the faces at each step, and what they say as a whole.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "contact/geometry/four_planes.hpp"
#include "contact/law/springs.hpp"
#include "contact/surfaces/entities.hpp"
#include "contact/surfaces/start_warp.hpp"
#include "core/parallel/threads.hpp"
#include "core/transpose.hpp"

namespace brunt {

namespace {
template <int Dim>
SearchBox<Dim> grown(const FacePlane<Dim>& plane, Real depth, Real gap, const SearchBox<Dim>& box) {
  SearchBox<Dim> reach;
  for (int c = 0; c < Dim; ++c) {
    const auto k = slot_of(c);
    const Real by = kReachPerDepth * depth * std::fabs(plane.normal[c]) +
                    kReachPerWarp * plane.warp + 0.5 * gap;
    reach.lo[k] = box.lo[k] - by;
    reach.hi[k] = box.hi[k] + by;
  }
  return reach;
}

/// True for faces whose springs bound the step.
template <int Dim>
bool bounds_step(const ContactFace<Dim>& face) {
  return face.deforms() && !face.held && face.area_start > 0;
}

/// What of its plane does not move.
template <int Dim>
void describe(const ContactFace<Dim>& face, FacePlane<Dim>& plane) {
  plane.n_corners = face.n_nodes;
  plane.borders = face.borders;
  plane.sharpness = face.sharpness;
  plane.rigid = !face.deforms();
}
}  // namespace

template <int Dim>
void Entities<Dim>::Seen::take(const Seen& other) {
  step_limit.take(other.step_limit);
  warped = std::max(warped, other.warped);
  turned_square = std::max(turned_square, other.turned_square);
}

template <int Dim>
void Entities<Dim>::take_corners(std::size_t f) {
  const auto& face = faces[f];
  auto& plane = planes[f];
  describe(face, plane);
  for (int c = 0; c < FacePlane<Dim>::kCorners; ++c) {
    const auto k = slot_of(c);
    const bool there = c < face.n_nodes;
    plane.corner[k] = there ? nodes.x[slot_of(face.node[k])] : Vec<Dim>::Zero();
  }
}

template <int Dim>
void Entities<Dim>::refresh_plane(std::size_t f) {
  take_corners(f);
  auto& plane = planes[f];
  refresh(plane);
  compare_with_start(faces[f], plane);
  boxes[f] = box_of(plane, 0.0);
}

namespace {
/// The corners of a quad, twelve numbers in a row, as three packs.
struct CornerRows {
  Pack row[3];
  CornerRows(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
      : row{{a[0], a[1], a[2], b[0]}, {b[1], b[2], c[0], c[1]}, {c[2], d[0], d[1], d[2]}} {}
};

/// Corner c of four quads, for c = 0 .. 3.
std::array<Place<Pack>, 4> side_by_side(const CornerRows& a, const CornerRows& b,
                                        const CornerRows& c, const CornerRows& d) {
  Pack first[4], middle[4], last[4];
  transpose(a.row[0], b.row[0], c.row[0], d.row[0], first);
  transpose(a.row[1], b.row[1], c.row[1], d.row[1], middle);
  transpose(a.row[2], b.row[2], c.row[2], d.row[2], last);
  return {{{first[0], first[1], first[2]},
           {first[3], middle[0], middle[1]},
           {middle[2], middle[3], last[0]},
           {last[1], last[2], last[3]}}};
}
}  // namespace

/// Four quads at a time.
template <int Dim>
void Entities<Dim>::refresh_four_quads(const LocalIndex* f) {
  if constexpr (Dim == 3) {
    const auto rows = [&](int lane) {
      const auto& face = faces[slot_of(f[lane])];
      auto& plane = planes[slot_of(f[lane])];
      describe(face, plane);
      const auto at = [&](std::size_t c) -> const Vec3& { return nodes.x[slot_of(face.node[c])]; };
      const CornerRows corners(at(0), at(1), at(2), at(3));
      Real* to = plane.corner[0].data();
      for (int i = 0; i < 3; ++i) store(to + i * kLanes, corners.row[i]);
      return corners;
    };
    const auto start = [&](int lane) { return faces[slot_of(f[lane])].area_start; };
    FourPlanes(side_by_side(rows(0), rows(1), rows(2), rows(3)),
               Pack{start(0), start(1), start(2), start(3)})
        .give({&planes[slot_of(f[0])], &planes[slot_of(f[1])], &planes[slot_of(f[2])],
               &planes[slot_of(f[3])]},
              {&boxes[slot_of(f[0])], &boxes[slot_of(f[1])], &boxes[slot_of(f[2])],
               &boxes[slot_of(f[3])]});
  }
}

template <int Dim>
void Entities<Dim>::refresh_some_planes(std::span<const LocalIndex> some) {
  std::size_t k = 0;
  if constexpr (Dim == 3) {
    for (; k + kLanes <= some.size(); k += kLanes) {
      const LocalIndex* f = &some[k];
      if (are_quads(f)) {
        refresh_four_quads(f);
      } else {
        for (int lane = 0; lane < kLanes; ++lane) refresh_plane(slot_of(f[lane]));
      }
    }
  }
  for (; k < some.size(); ++k) refresh_plane(slot_of(some[k]));
}

template <int Dim>
bool Entities<Dim>::are_quads(const LocalIndex* f) const {
  bool quads = true;
  for (int lane = 0; lane < kLanes; ++lane) quads &= faces[slot_of(f[lane])].n_nodes == 4;
  return quads;
}

template <int Dim>
void Entities<Dim>::compare_with_lists(std::size_t f, Seen& seen) const {
  if (shapes.empty()) return;
  const auto& plane = planes[f];
  seen.warped = std::max(seen.warped, plane.warp - shapes[f].warp);
  const Real turn_square = (plane.normal - shapes[f].normal).squaredNorm();
  seen.turned_square = std::max(seen.turned_square, turn_square);
}

template <int Dim>
void Entities<Dim>::look_at(std::size_t f, Seen& seen) const {
  compare_with_lists(f, seen);
  const auto& face = faces[f];
  if (!bounds_step(face)) return;
  const Real area = std::max(planes[f].area, face.footprint);
  const Real phi = face.phi_always * recoil_factor(face.recoil) * area / face.area_start;
  const Real ratio = surface_step_ratio(phi, recoil_damping(face.zeta, face.recoil));
  seen.step_limit.take({face.element_step * ratio, "contact stiffness", face.body, face.id});
}

/// The same of four: roots and divisions side by side.
template <int Dim>
void Entities<Dim>::look_at_four(const LocalIndex* f, Seen& seen) const {
  const std::array<const ContactFace<Dim>*, 4> face = {
      &faces[slot_of(f[0])], &faces[slot_of(f[1])], &faces[slot_of(f[2])], &faces[slot_of(f[3])]};
  bool any = false;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    compare_with_lists(slot_of(f[lane]), seen);
    any |= bounds_step(*face[lane]);
  }
  if (!any) return;
  const auto four = [&](Real ContactFace<Dim>::*of) {
    return Pack{face[0]->*of, face[1]->*of, face[2]->*of, face[3]->*of};
  };
  using Face = ContactFace<Dim>;
  const auto area_of = [&](int lane) { return planes[slot_of(f[lane])].area; };
  const Pack area =
      vmax(four(&Face::footprint), Pack{area_of(0), area_of(1), area_of(2), area_of(3)});
  const Pack recoil = four(&Face::recoil);
  const Pack phi = four(&Face::phi_always) * recoil_factor(recoil) * area / four(&Face::area_start);
  const Pack zeta = recoil_damping(four(&Face::zeta), recoil);
  const Pack limit = four(&Face::element_step) * surface_step_ratio(phi, zeta);
  for (int lane = 0; lane < kLanes; ++lane) {
    const Face& one = *face[slot_of(lane)];
    if (!bounds_step(one) || limit[lane] > seen.step_limit.step) continue;
    seen.step_limit.take({limit[lane], "contact stiffness", one.body, one.id});
  }
}

namespace {
using FourUnlisted = std::array<const UnlistedQuad*, kLanes>;

template <class Of>
BRUNT_INLINE Pack four(const FourUnlisted& quad, const Of& of) {
  return Pack{of(*quad[0]), of(*quad[1]), of(*quad[2]), of(*quad[3])};
}

BRUNT_INLINE std::array<Place<Pack>, 4> corners_of(const FourUnlisted& quad, const Vec3* x) {
  std::array<Place<Pack>, 4> corner;
  for (std::size_t c = 0; c < 4; ++c) {
    const auto along = [&](int i) {
      return four(quad, [&](const UnlistedQuad& one) { return x[slot_of(one.node[c])][i]; });
    };
    corner[c] = {along(0), along(1), along(2)};
  }
  return corner;
}

/// True only if none of four quads has warped more than `warped` [m] since the lists were built,
/// nor allows a step as short as `step` [s]; next to always, without a root or a division. A warp
/// is |a . n|/4 with a = x0 - x1 + x2 - x3 and n = m/|m|, m twice the area along the normal.
BRUNT_INLINE bool say_nothing(const FourUnlisted& quad, const std::array<Place<Pack>, 4>& x,
                              Real warped, Real step) {
  constexpr std::size_t first = offsetof(UnlistedQuad, warp), next = sizeof(Real);
  static_assert(offsetof(UnlistedQuad, wide_square) == first + next &&
                offsetof(UnlistedQuad, least) == first + 2 * next &&
                offsetof(UnlistedQuad, area_start) == first + 3 * next);  // the last is not used
  const auto row = [&](std::size_t i) { return load(&quad[i]->warp); };
  Pack of[4];
  transpose(row(0), row(1), row(2), row(3), of);
  const Place<Pack> twice = cross(x[2] - x[0], x[3] - x[1]);
  const Place<Pack> bent = (x[0] - x[1]) + (x[2] - x[3]);
  const Pack square = dot(twice, twice), out = dot(bent, twice), allowed = 4.0 * (of[0] + warped);
  // Rounding changes a warp by some 1e-16 of |a| and of itself: by less than what these leave.
  constexpr Real kLess = 1 - 1e-6, kRounds = 1e14, kNoArea = 1e-200;
  const Pack limit = allowed * allowed;
  return mask_bits((square > kNoArea) & (square <= of[1]) & (of[2] > step) &
                   (out * out <= kLess * limit * square) & (dot(bent, bent) <= kRounds * limit)) ==
         0b1111U;
}
}  // namespace

/// Four at a time, with the bits that look_at gives of each.
template <int Dim>
void Entities<Dim>::look_at_unlisted(std::size_t first, std::size_t last, Seen& seen) const {
  if constexpr (Dim == 3) {
    for (std::size_t k = first; k < last; k += kLanes) {
      // The last ones are looked at as often as it takes.
      FourUnlisted quad;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        quad[lane] = &unlisted[std::min(k + lane, last - 1)];
      }
      const auto corner = corners_of(quad, nodes.x.data());
      if (say_nothing(quad, corner, seen.warped, seen.step_limit.step)) continue;
      const FourMeans means(corner);
      const Pack grown = means.warp - four(quad, [](auto& one) { return one.warp; });
      const Pack area = vmax(means.area, four(quad, [](auto& one) { return one.footprint; }));
      const Pack phi = four(quad, [](auto& one) { return one.phi; }) * area /
                       four(quad, [](auto& one) { return one.area_start; });
      const Pack limit = four(quad, [](auto& one) { return one.longest; }) *
                         surface_step_ratio(phi, four(quad, [](auto& one) { return one.zeta; }));
      for (int lane = 0; lane < kLanes; ++lane) {
        seen.warped = std::max(seen.warped, grown[lane]);
        if (limit[lane] > seen.step_limit.step) continue;
        const auto& face = faces[slot_of(quad[slot_of(lane)]->face)];
        seen.step_limit.take({limit[lane], "contact stiffness", face.body, face.id});
      }
    }
  }
}

template <int Dim>
void Entities<Dim>::refresh_planes() {
  // A few at a time: the roots of a face wait for nothing of its neighbours, and what is looked at
  // is still in the cache.
  constexpr std::size_t kBlock = 64;
  const std::size_t n = listed_faces.size(), n_unlisted = unlisted.size();
  const LocalIndex* const face = listed_faces.data();
  Seen all;
  on_threads(n + n_unlisted > kWorthThreads, [&] {
    Seen part;
#pragma omp for schedule(static) nowait
    for (std::size_t first = 0; first < n; first += kBlock) {
      const std::size_t last = std::min(first + kBlock, n);
      refresh_some_planes({face + first, face + last});
      std::size_t k = first;
      for (; k + kLanes <= last; k += kLanes) look_at_four(face + k, part);
      for (; k < last; ++k) look_at(slot_of(face[k]), part);
    }
#pragma omp for schedule(static) nowait
    for (std::size_t first = 0; first < n_unlisted; first += kBlock) {
      look_at_unlisted(first, std::min(first + kBlock, n_unlisted), part);
    }
#pragma omp critical(brunt_contact_step_limit)
    all.take(part);
  });
  surface_limit = all.step_limit;
  warped = all.warped;
  turned = std::sqrt(all.turned_square);
}

template <int Dim>
void Entities<Dim>::refresh_unlisted_planes() {
  std::vector<LocalIndex> some;
  for (const UnlistedQuad& quad : unlisted) some.push_back(quad.face);
  refresh_some_planes(some);
}

namespace {
/// How much a face that is in no list may grow before what it allows is found anew, and how much
/// less than that is surely less, whatever rounds.
constexpr Real kWider = 1.05, kSurelyLess = 1 - 1e-9;
}  // namespace

template <int Dim>
void Entities<Dim>::mark_planes(const std::vector<char>& in_lists) {
  shapes.clear();
  shapes.reserve(planes.size());
  for (const auto& plane : planes) shapes.push_back({plane.normal, plane.warp});
  // What is held by a tie or a joint has its planes read besides.
  if (Dim == 2 || nodes.holds) return;
  listed_faces.clear();
  unlisted.clear();
  for (const LocalIndex f : near_faces) {
    const auto& face = faces[slot_of(f)];
    if (in_lists[slot_of(f)] != 0 || face.n_nodes != 4) {
      listed_faces.push_back(f);
      continue;
    }
    UnlistedQuad& quad = unlisted.emplace_back();
    std::copy_n(face.node.begin(), Facet<Dim>::kNodes, quad.node.begin());
    quad.face = f, quad.warp = planes[slot_of(f)].warp;
    const Real area = std::max(kWider * planes[slot_of(f)].area, face.footprint);
    quad.wide_square = quad.least = kInfinity;
    if (!bounds_step(face)) continue;
    quad.wide_square = 4 * area * area;
    quad.area_start = face.area_start, quad.footprint = face.footprint;
    quad.phi = face.phi_always * recoil_factor(face.recoil);
    quad.zeta = recoil_damping(face.zeta, face.recoil);
    quad.longest = face.element_step;
    const Real ratio = surface_step_ratio(quad.phi * area / face.area_start, quad.zeta);
    quad.least = kSurelyLess * quad.longest * ratio;
  }
}

template <int Dim>
void Entities<Dim>::refresh_sides() {
  if (!nodes.has_friction) return;
  side_at.assign(faces.size(), -1);
  std::vector<LocalIndex> rubbing;
  for (const LocalIndex f : listed_faces) {
    if (!(tractions[slot_of(f)].area > 0)) continue;
    side_at[slot_of(f)] = static_cast<std::int32_t>(rubbing.size());
    rubbing.push_back(f);
  }
  sides.resize(rubbing.size());
  for_each(rubbing.size(), kWorthThreads, [&](std::size_t k) {
    const auto& face = faces[slot_of(rubbing[k])];
    sides[k].set(nodes, std::span(face.node).first(slot_of(face.n_nodes)));
  });
}

template <int Dim>
void Entities<Dim>::refresh_reaches() {
  for_each(listed_faces.size(), kWorthThreads, [&](std::size_t k) {
    const auto f = slot_of(listed_faces[k]);
    const auto& face = faces[f];
    const Real depth = face.rigid() ? deepest : face.depth;
    reaches[f] = grown(planes[f], depth, gap(face.body), boxes[f]);
  });
}

template void Entities<2>::refresh_planes();
template void Entities<3>::refresh_planes();
template void Entities<2>::refresh_unlisted_planes();
template void Entities<3>::refresh_unlisted_planes();
template void Entities<2>::mark_planes(const std::vector<char>&);
template void Entities<3>::mark_planes(const std::vector<char>&);
template void Entities<2>::refresh_sides();
template void Entities<3>::refresh_sides();
template void Entities<2>::refresh_reaches();
template void Entities<3>::refresh_reaches();

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
