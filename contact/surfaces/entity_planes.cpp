/// Planes and boxes of the faces at each step, and what they say as a whole.
#include <algorithm>
#include <cmath>

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

/// Four at a time, with the bits that look_at gives of each.
template <int Dim>
void Entities<Dim>::look_at_unlisted(std::size_t first, std::size_t last, Seen& seen) const {
  if constexpr (Dim == 3) {
    for (std::size_t k = first; k < last; k += kLanes) {
      // The last ones are looked at as often as it takes.
      std::array<const UnlistedQuad*, kLanes> quad;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        quad[lane] = &unlisted[std::min(k + lane, last - 1)];
      }
      const auto four = [&](const auto& of) {
        return Pack{of(*quad[0]), of(*quad[1]), of(*quad[2]), of(*quad[3])};
      };
      std::array<Place<Pack>, 4> corner;
      for (std::size_t c = 0; c < 4; ++c) {
        const auto along = [&](int i) {
          return four([&](const UnlistedQuad& one) { return nodes.x[slot_of(one.node[c])][i]; });
        };
        corner[c] = {along(0), along(1), along(2)};
      }
      const FourMeans means(corner);
      const Pack grown = means.warp - four([](auto& one) { return one.warp; });
      const Pack area = vmax(means.area, four([](auto& one) { return one.footprint; }));
      const Pack phi = four([](auto& one) { return one.phi; }) * area /
                       four([](auto& one) { return one.area_start; });
      const Pack limit = four([](auto& one) { return one.longest; }) *
                         surface_step_ratio(phi, four([](auto& one) { return one.zeta; }));
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
    if (!bounds_step(face)) continue;
    quad.area_start = face.area_start, quad.footprint = face.footprint;
    quad.phi = face.phi_always * recoil_factor(face.recoil);
    quad.zeta = recoil_damping(face.zeta, face.recoil);
    quad.longest = face.element_step;
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
