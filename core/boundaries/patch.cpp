#include "core/boundaries/patch.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

template <int Dim>
std::vector<std::size_t> Patch<Dim>::follow(const Points<Dim>& old, Points<Dim>& now) {
  const auto here = [&](LocalIndex point) { return now.find(old.id[std::size_t(point)]); };
  std::vector<std::size_t> kept;
  std::vector<LocalIndex> owned;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const LocalIndex place = here(chosen[k]);
    if (place < 0 || place >= now.n_owned) continue;
    kept.push_back(k);
    owned.push_back(place);
  }
  std::vector<Facet<Dim>> faces;
  for (auto facet : facets) {
    bool all = true, any_owned = false;
    for (int c = 0; c < facet.n_nodes(); ++c) {
      auto& node = facet.node[c];
      node = here(node);
      all = all && node >= 0;
      any_owned = any_owned || (node >= 0 && node < now.n_owned);
    }
    if (all && any_owned) faces.push_back(facet);
  }
  points = &now;
  chosen = std::move(owned);
  take_facets(std::move(faces));
  if (has_particles()) keep_places(spacing, kept);
  return kept;
}

template <int Dim>
void Patch<Dim>::take_facets(std::vector<Facet<Dim>> faces) {
  facets = std::move(faces);
  corners.clear();
  for (const auto& facet : facets) {
    auto& places = corners.emplace_back();
    places.fill(-1);
    for (std::size_t c = 0; c < slot_of(facet.n_nodes()); ++c) {
      const auto at = std::lower_bound(chosen.begin(), chosen.end(), facet.node[c]);
      if (at == chosen.end() || *at != facet.node[c]) continue;
      places[c] = static_cast<LocalIndex>(at - chosen.begin());
    }
  }
}

template <int Dim>
void Patch<Dim>::keep_facets(const Surface<Dim>& surface) {
  if (surface.points != points || facets.empty()) return;
  const auto before = [](const Facet<Dim>& one, const Facet<Dim>& other) {
    return one.id < other.id;
  };
  auto left = facets;
  std::erase_if(left, [&](const Facet<Dim>& facet) {
    return !std::binary_search(surface.facets.begin(), surface.facets.end(), facet, before);
  });
  if (left.size() < facets.size()) take_facets(std::move(left));
}

template <int Dim>
std::string Patch<Dim>::needs_faces(const std::string& who) const {
  if (!has_particles()) return needs_areas();
  return who + " acts on faces, and '" + body +
         "' is of particles, which have none: choose elements (method: fe) for it";
}

template <int Dim>
std::string Patch<Dim>::needs_areas() const {
  if (has_particles() || !facets.empty()) return "";
  return "there is no outer facet all of whose points are chosen";
}

template <int Dim>
std::vector<Facet<Dim>> facets_between(const Surface<Dim>& surface,
                                       const std::vector<LocalIndex>& chosen) {
  std::vector<Facet<Dim>> facets;
  for (const auto& facet : surface.facets) {
    bool all = true;
    for (int k = 0; k < facet.n_nodes(); ++k) {
      const LocalIndex node = facet.node[k];
      all = all && std::binary_search(chosen.begin(), chosen.end(), node);
    }
    if (all) facets.push_back(facet);
  }
  return facets;
}

namespace {
/// 1/sqrt(3): Gauss points of two a direction.
constexpr Real kGauss = 0.57735026918962576451;

/// An edge: a place of it is at radius x[0] where the section is axisymmetric.
void add_points(const Patch<2>& patch, const Facet<2>& facet, FacetPoints<2>& to) {
  const auto i = slot_of(facet.node[0]);
  const auto j = slot_of(facet.node[1]);
  const auto& x = patch.points->x;
  const Vec<2> edge = x[j] - x[i];
  for (const Real at : {-kGauss, kGauss}) {
    auto& point = to.point[to.n++];
    point.shape = {0.5 * (1 - at), 0.5 * (1 + at)};
    const Real radius = point.shape[0] * x[i][0] + point.shape[1] * x[j][0];
    const Real width = patch.depth > 0 ? patch.depth : 2 * kPi * radius;
    point.area = 0.5 * width * Vec<2>(edge[1], -edge[0]);
  }
}

void add_triangle(const Patch<3>& patch, const Facet<3>& facet, FacetPoints<3>& to) {
  const auto x = [&](std::size_t c) { return patch.points->x[std::size_t(facet.node[c])]; };
  const Vec3 third = (x(1) - x(0)).cross(x(2) - x(0)) / 6;
  for (std::size_t near = 0; near < 3; ++near) {
    auto& point = to.point[to.n++];
    point.shape = {1.0 / 6, 1.0 / 6, 1.0 / 6, 0};
    point.shape[near] = 2.0 / 3;
    point.area = third;
  }
}

void add_points(const Patch<3>& patch, const Facet<3>& facet, FacetPoints<3>& to) {
  if (facet.n_nodes() == 3) return add_triangle(patch, facet, to);
  constexpr std::array<Real, 4> kXi = {-1, 1, 1, -1}, kEta = {-1, -1, 1, 1};
  for (std::size_t g = 0; g < 4; ++g) {
    auto& point = to.point[to.n++];
    const Real xi = kGauss * kXi[g], eta = kGauss * kEta[g];
    Vec3 along_xi = Vec3::Zero(), along_eta = Vec3::Zero();
    for (std::size_t c = 0; c < 4; ++c) {
      const Vec3& x = patch.points->x[facet.node[c]];
      point.shape[c] = 0.25 * (1 + kXi[c] * xi) * (1 + kEta[c] * eta);
      along_xi += 0.25 * kXi[c] * (1 + kEta[c] * eta) * x;
      along_eta += 0.25 * kEta[c] * (1 + kXi[c] * xi) * x;
    }
    point.area = along_xi.cross(along_eta);
  }
}
}  // namespace

template <int Dim>
FacetPoints<Dim> facet_points(const Patch<Dim>& patch, const Facet<Dim>& facet) {
  FacetPoints<Dim> all;
  add_points(patch, facet, all);
  for (std::size_t k = 0; k < all.n; ++k) {
    Vec<Dim> start = patch.origin;
    for (int c = 0; c < facet.n_nodes(); ++c) {
      const auto corner = slot_of(c);
      start += all.point[k].shape[corner] * patch.points->x_start[facet.node[corner]];
    }
    all.point[k].start = in_space<Dim>(start);
  }
  return all;
}

template struct Patch<2>;
template struct Patch<3>;
template std::vector<Facet<2>> facets_between(const Surface<2>&, const std::vector<LocalIndex>&);
template std::vector<Facet<3>> facets_between(const Surface<3>&, const std::vector<LocalIndex>&);
template FacetPoints<2> facet_points(const Patch<2>&, const Facet<2>&);
template FacetPoints<3> facet_points(const Patch<3>&, const Facet<3>&);

}  // namespace brunt
// Tested by tests/verification/pressure_test.cpp.
