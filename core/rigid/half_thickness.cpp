#include "core/rigid/half_thickness.hpp"

#include <algorithm>
#include <cmath>

#include "core/search/search.hpp"

namespace brunt {

namespace {
/// Least cosine between the ray and the normal of the facet through which it leaves a plate.
constexpr Real kOpposite = 0.866;
/// Places along a facet, at most.
constexpr Real kMostPlaces = 8;
/// A ray is looked at in boxes of so many sizes of facets, as along a diagonal one would be far
/// wider than the ray, but in no more than so many.
constexpr Real kFacetsInBox = 3;
constexpr Real kMostBoxes = 64;
/// Boxes that are looked at together.
constexpr std::size_t kBoxesAtOnce = 200000;
/// Edges belong to both facets, up to rounding.
constexpr Real kOnEdge = 1e-9;

template <int Dim>
struct Ray {
  std::size_t facet = 0;
  Vec<Dim> from, along;     ///< [m], unit
  Real leaves = kInfinity;  ///< [m] from `from`
  Real cosine = 0;          ///< with the normal where it leaves
};

template <int Dim>
Vec<Dim> corner_of(const Facet<Dim>& facet, std::span<const Vec<Dim>> x, std::size_t c) {
  return x[facet.node[c]];
}

template <int Dim>
SearchBox<Dim> box_of(const Facet<Dim>& facet, std::span<const Vec<Dim>> x) {
  auto box = SearchBox<Dim>::about(corner_of(facet, x, 0), 0);
  for (std::size_t c = 1; c < slot_of(facet.n_nodes()); ++c) {
    box.enclose(SearchBox<Dim>::about(corner_of(facet, x, c), 0));
  }
  return box;
}

/// Adds the rays from a facet, whose middle parts are no longer than `most` where that takes few.
void add_rays(const Facet<2>& facet, std::span<const Vec<2>> x, std::size_t number, Real most,
              std::vector<Ray<2>>& rays) {
  const Vec<2> a = corner_of(facet, x, 0), edge = corner_of(facet, x, 1) - a;
  const Real length = edge.norm();
  if (!(length > 0)) return;
  const auto n = static_cast<int>(std::clamp(std::ceil(length / most), 1.0, kMostPlaces));
  for (int i = 0; i < n; ++i) {
    rays.push_back({number, a + (i + 0.5) / n * edge, Vec<2>(-edge[1], edge[0]) / length});
  }
}

void add_rays(const Facet<3>& facet, std::span<const Vec<3>> x, std::size_t number, Real most,
              std::vector<Ray<3>>& rays) {
  const bool quad = facet.n_nodes() == 4;
  const Vec3 a = corner_of(facet, x, 0), b = corner_of(facet, x, 1), c = corner_of(facet, x, 2);
  const Vec3 d = quad ? corner_of(facet, x, 3) : c;
  const Vec3 area = (c - a).cross(d - b) + (quad ? Vec3::Zero().eval() : (b - a).cross(c - a));
  if (!(area.norm() > 0)) return;
  const Vec3 along = -area.normalized();
  const Real length = std::max({(b - a).norm(), (c - b).norm(), (d - c).norm(), (a - d).norm()});
  const auto n = static_cast<int>(std::clamp(std::ceil(length / most), 1.0, kMostPlaces));
  const Real inset = quad ? 0.5 : 1.0 / 3;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < (quad ? n : n - i); ++j) {
      const Real u = (i + inset) / n, v = (j + inset) / n;
      const Vec3 place = quad ? ((1 - u) * ((1 - v) * a + v * d) + u * ((1 - v) * b + v * c)).eval()
                              : (a + u * (b - a) + v * (c - a)).eval();
      rays.push_back({number, place, along});
    }
  }
}

/// Takes the point where the ray leaves through a facet, if it does so nearer than before.
void take_exit(const Facet<2>& facet, std::span<const Vec<2>> x, Ray<2>& ray) {
  const Vec<2> a = corner_of(facet, x, 0), edge = corner_of(facet, x, 1) - a;
  const Real length = edge.norm();
  const Real cosine = (edge[1] * ray.along[0] - edge[0] * ray.along[1]) / length;
  if (!(cosine > 0)) return;
  const Vec<2> arm = a - ray.from;
  const Real t = (edge[1] * arm[0] - edge[0] * arm[1]) / (length * cosine);
  const Real at = (ray.along[1] * arm[0] - ray.along[0] * arm[1]) / (length * cosine);
  const bool through = at >= -kOnEdge && at <= 1 + kOnEdge;
  if (through && t > 0 && t < ray.leaves) ray.leaves = t, ray.cosine = cosine;
}

/// Of a triangle, after Moeller & Trumbore 1997.
void take_exit(const Vec3& a, const Vec3& b, const Vec3& c, Ray<3>& ray) {
  const Vec3 ab = b - a, ac = c - a, normal = ab.cross(ac);
  const Real way = normal.dot(ray.along);
  if (!(way > 0)) return;
  const Vec3 arm = ray.from - a, turned = arm.cross(ray.along);
  const Real u = -ac.dot(turned) / way, v = ab.dot(turned) / way, t = -normal.dot(arm) / way;
  const bool through = u >= -kOnEdge && v >= -kOnEdge && u + v <= 1 + kOnEdge;
  if (through && t > 0 && t < ray.leaves) ray.leaves = t, ray.cosine = way / normal.norm();
}
void take_exit(const Facet<3>& facet, std::span<const Vec<3>> x, Ray<3>& ray) {
  const Vec3 a = corner_of(facet, x, 0), c = corner_of(facet, x, 2);
  take_exit(a, corner_of(facet, x, 1), c, ray);
  if (facet.n_nodes() == 4) take_exit(a, c, corner_of(facet, x, 3), ray);
}

/// Boxes [1] for a ray of a given length [m] among facets of given boxes.
template <int Dim>
std::size_t boxes_of_a_ray(Real length, std::span<const SearchBox<Dim>> facets) {
  std::vector<Real> size;
  for (const auto& box : facets) {
    Real widest = 0;
    for (std::size_t c = 0; c < Dim; ++c) widest = std::max(widest, box.hi[c] - box.lo[c]);
    size.push_back(widest);
  }
  const auto middle = size.begin() + static_cast<std::ptrdiff_t>(size.size() / 2);
  std::nth_element(size.begin(), middle, size.end());
  const Real wanted = *middle > 0 ? length / (kFacetsInBox * *middle) : kMostBoxes;
  return static_cast<std::size_t>(std::clamp(std::ceil(wanted), 1.0, kMostBoxes));
}

/// Lets some rays of a given length leave, each looked at in so many boxes.
template <int Dim>
void follow(std::span<const Vec<Dim>> x, Real length, std::size_t n_boxes,
            std::span<const Facet<Dim>> facets, std::vector<SearchBox<Dim>> boxes,
            std::span<Ray<Dim>> rays) {
  const std::size_t n = facets.size();
  boxes.resize(n);
  for (const auto& ray : rays) {
    const auto at = [&](std::size_t k) {
      const Real part = static_cast<Real>(k) / static_cast<Real>(n_boxes);
      return SearchBox<Dim>::about(ray.from + part * length * ray.along, kOnEdge * length);
    };
    for (std::size_t k = 0; k < n_boxes; ++k) {
      boxes.push_back(at(k));
      boxes.back().enclose(at(k + 1));
    }
  }
  const auto ray_of = [&](LocalIndex box) { return (slot_of(box) - n) / n_boxes; };
  const auto admits = [&](LocalIndex i, LocalIndex j) {
    const auto f = slot_of(i);
    if (f >= n || slot_of(j) < n) return false;
    const std::size_t own = rays[ray_of(j)].facet;
    return own != f && facets[own].body == facets[f].body && facets[own].piece == facets[f].piece;
  };
  for (const auto& [i, j] : overlapping_pairs<Dim>(boxes, admits, SearchMode::grid)) {
    take_exit(facets[i], x, rays[ray_of(j)]);
  }
}
}  // namespace

template <int Dim>
void find_half_thickness(std::span<const Vec<Dim>> x, Real most, std::span<Facet<Dim>> facets) {
  std::vector<Ray<Dim>> rays;
  std::vector<SearchBox<Dim>> boxes;
  boxes.reserve(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    boxes.push_back(box_of(facets[f], x));
    const bool rigid = facets[f].rigid() || facets[f].compliance > 0;
    if (rigid && !facets[f].open) add_rays(facets[f], x, f, most, rays);
  }
  const Real length = most * (1 + kOpposite) / kOpposite;
  const std::span<Ray<Dim>> all(rays);
  const std::size_t n_boxes = rays.empty() ? 1 : boxes_of_a_ray<Dim>(length, boxes);
  const std::size_t at_once = kBoxesAtOnce / n_boxes;
  for (std::size_t first = 0; first < rays.size(); first += at_once) {
    const std::size_t n = std::min(at_once, rays.size() - first);
    follow<Dim>(x, length, n_boxes, facets, boxes, all.subspan(first, n));
  }
  for (auto& facet : facets) facet.half_thickness = kInfinity;
  for (const auto& ray : rays) {
    // Surfaces that lie on each other enclose nothing.
    if (ray.cosine < kOpposite || ray.leaves < kOnEdge * length) continue;
    const Real half = ray.leaves * ray.cosine / (1 + ray.cosine);
    auto& least = facets[ray.facet].half_thickness;
    if (half < most) least = std::min(least, half);
  }
}

template void find_half_thickness<2>(std::span<const Vec<2>>, Real, std::span<Facet<2>>);
template void find_half_thickness<3>(std::span<const Vec<3>>, Real, std::span<Facet<3>>);

}  // namespace brunt
