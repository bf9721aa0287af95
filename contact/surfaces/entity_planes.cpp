/// Planes and boxes of the faces at each step, and what they say as a whole.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "contact/law/springs.hpp"
#include "contact/surfaces/corner_rows.hpp"
#include "contact/surfaces/start_warp.hpp"
#include "core/parallel/threads.hpp"

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

/// Four quads at a time.
template <int Dim>
void Entities<Dim>::refresh_four_quads(const LocalIndex* f) {
  if constexpr (Dim == 3) {
    const auto rows = [&](int lane) {
      const auto& face = faces[slot_of(f[lane])];
      auto& plane = planes[slot_of(f[lane])];
      describe(face, plane);
      return take_rows(face.node, nodes.x.data(), plane);
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
  if (!face.bounds_step()) return;
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
    any |= face[lane]->bounds_step();
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
    if (!one.bounds_step() || limit[lane] > seen.step_limit.step) continue;
    seen.step_limit.take({limit[lane], "contact stiffness", one.body, one.id});
  }
}

template <int Dim>
void Entities<Dim>::refresh_planes() {
  // A few at a time: the roots of a face wait for nothing of its neighbours, and what is looked at
  // is still in the cache.
  constexpr std::size_t kBlock = 64;
  const auto& others = listed_quads.empty() ? listed_faces : listed_others;
  const std::size_t n = others.size(), n_quads = listed_quads.size(),
                    n_unlisted = unlisted_signs.size();
  const LocalIndex* const face = others.data();
  Seen all;
  on_threads(n + n_quads + n_unlisted > kWorthThreads, [&] {
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
    for (std::size_t first = 0; first < n_quads; first += kBlock) {
      refresh_listed_quads(first, std::min(first + kBlock, n_quads), part);
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
SearchBox<Dim> Entities<Dim>::reach_of(std::size_t f) const {
  const auto& face = faces[f];
  return grown(planes[f], face.rigid() ? deepest : face.depth, gap(face.body), boxes[f]);
}

template <int Dim>
void Entities<Dim>::refresh_reaches() {
  const auto& others = listed_quads.empty() ? listed_faces : listed_others;
  for_each(others.size(), kWorthThreads, [&](std::size_t k) {
    const auto f = slot_of(others[k]);
    reaches[f] = reach_of(f);
  });
}

template void Entities<2>::refresh_planes();
template void Entities<3>::refresh_planes();
template SearchBox<2> Entities<2>::reach_of(std::size_t) const;
template SearchBox<3> Entities<3>::reach_of(std::size_t) const;
template void Entities<2>::refresh_some_planes(std::span<const LocalIndex>);
template void Entities<3>::refresh_some_planes(std::span<const LocalIndex>);
template void Entities<2>::refresh_sides();
template void Entities<3>::refresh_sides();
template void Entities<2>::refresh_reaches();
template void Entities<3>::refresh_reaches();

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
