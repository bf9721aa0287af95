/// Planes of quads while lists hold: those in lists, four at a time, and what the others say.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "contact/law/springs.hpp"
#include "contact/surfaces/corner_rows.hpp"

namespace brunt {

namespace {
/// Numbers of four quads, each of them side by side.
struct FourListed {
  Pack limits[4], places[4], normal[4];
  explicit FourListed(const ListedQuad* quad) {
    constexpr std::size_t first = offsetof(ListedQuad, area_start), next = sizeof(Real);
    static_assert(offsetof(ListedQuad, longest) == first + 4 * next &&
                  offsetof(ListedQuad, normal) == first + 8 * next);
    const auto row = [&](int lane, int of) {
      Pack numbers;
      std::memcpy(&numbers, reinterpret_cast<const char*>(&quad[lane]) + first + of * sizeof(Pack),
                  sizeof numbers);
      return numbers;
    };
    int of = 0;
    for (auto* rows : {limits, places, normal}) {
      transpose(row(0, of), row(1, of), row(2, of), row(3, of), rows);
      ++of;
    }
  }
  Pack area_start() const { return limits[0]; }
  Pack footprint() const { return limits[1]; }
  Pack phi() const { return limits[2]; }
  Pack zeta() const { return limits[3]; }
  Pack longest() const { return places[0]; }
  Pack warp() const { return places[1]; }
  Pack by_normal() const { return places[2]; }
  Pack by_gap() const { return places[3]; }
};

/// Boxes wide enough for any contact, as of reach_of, of four quads.
void give_reaches(const FourListed& quad, const FourPlanes& now, SearchBox<3>* const (&reach)[4]) {
  const auto by = [&](Pack n) {
    return quad.by_normal() * vabs(n) + kReachPerWarp * now.warp + quad.by_gap();
  };
  const Place<Pack> wider = {by(now.normal.x), by(now.normal.y), by(now.normal.z)};
  const Place<Pack> lo = now.lo - wider, hi = now.hi + wider;
  Pack low[4], high[4];
  transpose(lo.x, lo.y, lo.z, hi.x, low);
  transpose(hi.y, hi.z, hi.y, hi.z, high);
  for (int lane = 0; lane < kLanes; ++lane) {
    static_assert(sizeof(SearchBox<3>) == 6 * sizeof(Real));
    char* const sides = reinterpret_cast<char*>(reach[lane]);
    std::memcpy(sides, &low[lane], sizeof(Pack));
    std::memcpy(sides + sizeof(Pack), &high[lane], 2 * sizeof(Real));
  }
}
}  // namespace

/// What look_at says of each of four, and their reaches.
template <int Dim>
void Entities<Dim>::look_at_listed(const ListedQuad* four, const FourPlanes& now, Seen& seen) {
  const FourListed of(four);
  const Place<Pack> turn = now.normal - Place<Pack>{of.normal[0], of.normal[1], of.normal[2]};
  const Pack grown = now.warp - of.warp(), turn_square = dot(turn, turn);
  if (any((grown > seen.warped) | (turn_square > seen.turned_square))) {
    for (int lane = 0; lane < kLanes; ++lane) {
      seen.warped = std::max(seen.warped, grown[lane]);
      seen.turned_square = std::max(seen.turned_square, turn_square[lane]);
    }
  }
  if constexpr (Dim == 3) {
    const auto reach = [&](int lane) { return &reaches[slot_of(four[lane].face)]; };
    give_reaches(of, now, {reach(0), reach(1), reach(2), reach(3)});
  }
  const Pack phi = of.phi() * vmax(now.area, of.footprint()) / of.area_start();
  const Pack limit = of.longest() * surface_step_ratio(phi, of.zeta());
  if (!any(limit <= seen.step_limit.step)) return;
  for (int lane = 0; lane < kLanes; ++lane) {
    if (!(limit[lane] <= seen.step_limit.step) || four[lane].longest == kInfinity) continue;
    const auto& face = faces[slot_of(four[lane].face)];
    seen.step_limit.take({limit[lane], "contact stiffness", face.body, face.id});
  }
}

template <int Dim>
void Entities<Dim>::refresh_listed_quads(std::size_t first, std::size_t last, Seen& seen) {
  if constexpr (Dim == 3) {
    for (std::size_t k = first; k < last; k += kLanes) {
      const ListedQuad* const quad = &listed_quads[k];
      const auto plane = [&](int lane) { return &planes[slot_of(quad[lane].face)]; };
      const auto box = [&](int lane) { return &boxes[slot_of(quad[lane].face)]; };
      const auto rows = [&](int lane) {
        return take_rows(quad[lane].node, nodes.x.data(), *plane(lane));
      };
      const FourPlanes now(
          side_by_side(rows(0), rows(1), rows(2), rows(3)),
          Pack{quad[0].area_start, quad[1].area_start, quad[2].area_start, quad[3].area_start});
      now.give({plane(0), plane(1), plane(2), plane(3)}, {box(0), box(1), box(2), box(3)});
      look_at_listed(quad, now, seen);
    }
  }
}

namespace {
using FourUnlisted = std::array<const UnlistedQuad*, kLanes>;
using FourSigns = const UnlistedSigns*;

template <class Of>
BRUNT_INLINE Pack four(const FourUnlisted& quad, const Of& of) {
  return Pack{of(*quad[0]), of(*quad[1]), of(*quad[2]), of(*quad[3])};
}

BRUNT_INLINE std::array<Place<Pack>, 4> corners_of(FourSigns quad, const Vec3* x) {
  using Two = Real __attribute__((vector_size(16)));
  std::array<Place<Pack>, 4> corner;
  for (std::size_t c = 0; c < 4; ++c) {
    const auto at = [&](int lane) -> const Real* { return x[slot_of(quad[lane].node[c])].data(); };
    const Real* const from[] = {at(0), at(1), at(2), at(3)};
    const auto two = [&](std::size_t lane) {
      Two xy;
      std::memcpy(&xy, from[lane], sizeof xy);
      return xy;
    };
    const Pack even = __builtin_shufflevector(two(0), two(2), 0, 1, 2, 3);
    const Pack odd = __builtin_shufflevector(two(1), two(3), 0, 1, 2, 3);
    corner[c] = {__builtin_shufflevector(even, odd, 0, 4, 2, 6),
                 __builtin_shufflevector(even, odd, 1, 5, 3, 7),
                 Pack{from[0][2], from[1][2], from[2][2], from[3][2]}};
  }
  return corner;
}

/// True only if none of four quads has warped more than `warped` [m] since the lists were built,
/// nor allows a step as short as `step` [s]; next to always, without a root or a division. A warp
/// is |a . n|/4 with a = x0 - x1 + x2 - x3 and n = m/|m|, m twice the area along the normal.
BRUNT_INLINE bool say_nothing(FourSigns quad, const std::array<Place<Pack>, 4>& x, Real warped,
                              Real step) {
  using Four = float __attribute__((vector_size(16)));
  const auto row = [&](int lane) {
    Four limit;
    std::memcpy(&limit, quad[lane].limit.data(), sizeof limit);
    return __builtin_convertvector(limit, Pack);
  };
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
      const FourSigns signs = &unlisted_signs[k];
      const auto corner = corners_of(signs, nodes.x.data());
      if (say_nothing(signs, corner, seen.warped, seen.step_limit.step)) continue;
      FourUnlisted quad;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        quad[lane] = &unlisted[std::min(k + lane, unlisted.size() - 1)];
      }
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
ListedQuad Entities<Dim>::listed_quad(LocalIndex f) const {
  ListedQuad quad;
  const UnlistedQuad of = unlisted_quad(f);
  const auto& face = faces[slot_of(f)];
  quad.node = of.node, quad.face = f;
  quad.area_start = face.area_start, quad.footprint = of.footprint;
  quad.phi = of.phi, quad.zeta = of.zeta, quad.longest = of.longest;
  quad.warp = of.warp;
  quad.by_normal = kReachPerDepth * (face.rigid() ? deepest : face.depth);
  quad.by_gap = 0.5 * gap(face.body);
  std::copy_n(planes[slot_of(f)].normal.data(), Dim, quad.normal.begin());
  return quad;
}

template <int Dim>
UnlistedQuad Entities<Dim>::unlisted_quad(LocalIndex f) const {
  const auto& face = faces[slot_of(f)];
  UnlistedQuad quad;
  std::copy_n(face.node.begin(), Facet<Dim>::kNodes, quad.node.begin());
  quad.face = f, quad.warp = planes[slot_of(f)].warp;
  const Real area = std::max(kWider * planes[slot_of(f)].area, face.footprint);
  quad.wide_square = quad.least = kInfinity;
  if (!face.bounds_step()) return quad;
  quad.wide_square = 4 * area * area;
  quad.area_start = face.area_start, quad.footprint = face.footprint;
  quad.phi = face.phi_always * recoil_factor(face.recoil);
  quad.zeta = recoil_damping(face.zeta, face.recoil);
  quad.longest = face.element_step;
  const Real ratio = surface_step_ratio(quad.phi * area / face.area_start, quad.zeta);
  quad.least = kSurelyLess * quad.longest * ratio;
  return quad;
}

namespace {
UnlistedSigns signs_of(const UnlistedQuad& quad) {
  const auto down = [](Real s) {
    const auto rounded = static_cast<float>(s);
    return rounded > s ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
  };
  return {quad.node, {down(quad.warp), down(quad.wide_square), down(quad.least), 0}};
}

/// Repeats the last one until there are whole fours.
template <class T>
void fill_up(std::vector<T>& all) {
  while (all.size() % kLanes != 0) all.push_back(T(all.back()));
}
}  // namespace

template <int Dim>
void Entities<Dim>::clear_lists() {
  listed_quads.clear(), listed_others.clear();
  unlisted.clear(), unlisted_signs.clear();
}

template <int Dim>
void Entities<Dim>::mark_planes(const std::vector<char>& in_lists) {
  shapes.clear();
  shapes.reserve(planes.size());
  for (const auto& plane : planes) shapes.push_back({plane.normal, plane.warp});
  // What is held by a tie or a joint has its planes read besides.
  if (Dim == 2 || nodes.holds) return;
  listed_faces.clear();
  clear_lists();
  const auto n_listed =
      slot_of(std::count_if(near_faces.begin(), near_faces.end(),
                            [&](LocalIndex f) { return in_lists[slot_of(f)] != 0; }));
  listed_quads.reserve(n_listed + kLanes);
  unlisted_signs.reserve(near_faces.size() - n_listed + kLanes);
  for (const LocalIndex f : near_faces) {
    const bool is_listed = in_lists[slot_of(f)] != 0, is_quad = faces[slot_of(f)].n_nodes == 4;
    if (is_listed || !is_quad) listed_faces.push_back(f);
    if (!is_quad) {
      listed_others.push_back(f);
    } else if (is_listed) {
      listed_quads.push_back(listed_quad(f));
    } else {
      unlisted_signs.push_back(signs_of(unlisted.emplace_back(unlisted_quad(f))));
    }
  }
  fill_up(listed_quads), fill_up(unlisted_signs);
  for (const auto& quad : listed_quads) reaches[slot_of(quad.face)] = reach_of(slot_of(quad.face));
}

template void Entities<3>::look_at_unlisted(std::size_t, std::size_t, Seen&) const;
template void Entities<2>::look_at_unlisted(std::size_t, std::size_t, Seen&) const;
template void Entities<3>::refresh_listed_quads(std::size_t, std::size_t, Seen&);
template void Entities<2>::refresh_listed_quads(std::size_t, std::size_t, Seen&);
template void Entities<2>::refresh_unlisted_planes();
template void Entities<3>::refresh_unlisted_planes();
template void Entities<2>::clear_lists();
template void Entities<3>::clear_lists();
template void Entities<2>::mark_planes(const std::vector<char>&);
template void Entities<3>::mark_planes(const std::vector<char>&);

}  // namespace brunt
// Tested by tests/unit/contact/unlisted_faces_test.cpp.
