#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/materials/material.hpp"
#include "core/surface.hpp"

namespace brunt {

/// What a boundary acts on, and when: points of one body that were chosen at time 0, and the outer
/// faces between them.
template <int Dim>
struct Patch {
  std::string name;  ///< of the boundary
  std::string body;  ///< its name in the deck
  Points<Dim>* points = nullptr;
  std::vector<LocalIndex> chosen;  ///< owned points, ascending
  /// Outer faces all of whose points are chosen, by id; here those with an owned point. None of
  /// particles.
  std::vector<Facet<Dim>> facets;
  /// Places in `chosen` of the nodes of each facet; -1: of another rank, or no node.
  std::vector<std::array<LocalIndex, Facet<Dim>::kNodes>> corners;
  std::vector<Real> spacing;  ///< [m] of each chosen particle; empty: points of elements
  bool whole = false;         ///< all points of the body are chosen
  /// By which a force in total is shared among those chosen at time 0; empty: by their masses.
  std::vector<Real> weight;
  const Material* material = nullptr;  ///< of the body
  Vec<Dim> origin = Vec<Dim>::Zero();  ///< [m] to which positions are relative
  Real depth = 1;                      ///< [m] of plane strain; 0: axisymmetric
  Real from = 0, to = kInfinity;       ///< [s] when it acts

  bool acts(Real time) const { return time >= from && time <= to; }
  bool has_particles() const { return !spacing.empty(); }
  std::size_t size() const { return chosen.size(); }
  std::size_t point(std::size_t k) const { return slot_of(chosen[k]); }
  /// [m] absolute place at time 0 of chosen point k.
  Vec3 place(std::size_t k) const { return in_space<Dim>(points->x_start[point(k)] + origin); }
  /// faces  all of whose points are chosen, by id
  void take_facets(std::vector<Facet<Dim>> faces);
  /// From now on it acts on those of its points that `now` owns, the same ids as in `old`. Returns
  /// the places in `chosen` of what is kept.
  std::vector<std::size_t> follow(const Points<Dim>& old, Points<Dim>& now);
  /// Leaves those of its facets that the surface of its points still has.
  void keep_facets(const Surface<Dim>& surface);
  /// Why what acts on faces cannot act here, "" where it can. who  "a pressure"
  std::string needs_faces(const std::string& who) const;
  /// The same of what acts on areas, which particles have too.
  std::string needs_areas() const;

  /// int N_k f dA of each chosen point k over the faces as they are now, by ascending facet: the
  /// same on any rank that owns the point. f(FacetPoint)  what to add, with the area in it
  template <class Value, class F>
  std::vector<Value> integral(const Value& zero, const F& f) const;
};

/// Facets of the surface all of whose points are among `chosen`, which ascend; by id.
template <int Dim>
std::vector<Facet<Dim>> facets_between(const Surface<Dim>& surface,
                                       const std::vector<LocalIndex>& chosen);

/// A place on a facet of a patch, for integrals over it: sum over the points of w f, where w holds
/// the area. Exact for products of two functions that are bilinear over a facet, so that forces of
/// a uniform pressure are the gradient of the volume behind the facets.
template <int Dim>
struct FacetPoint {
  std::array<Real, Facet<Dim>::kNodes> shape{};  ///< [1] N of each node
  Vec<Dim> area = Vec<Dim>::Zero();              ///< [m^2] outward normal times area, present
  Vec3 start = Vec3::Zero();                     ///< [m] absolute place at time 0
};
/// Points of an edge, a quad or a triangle. depth [m] of plane strain; 0: the ring about the axis.
template <int Dim>
struct FacetPoints {
  std::array<FacetPoint<Dim>, 4> point;
  std::size_t n = 0;
  const FacetPoint<Dim>* begin() const { return point.data(); }
  const FacetPoint<Dim>* end() const { return point.data() + n; }
};
template <int Dim>
FacetPoints<Dim> facet_points(const Patch<Dim>& patch, const Facet<Dim>& facet);

template <int Dim>
template <class Value, class F>
std::vector<Value> Patch<Dim>::integral(const Value& zero, const F& f) const {
  std::vector<Value> sum(chosen.size(), zero);
  for (std::size_t k = 0; k < facets.size(); ++k) {
    for (const FacetPoint<Dim>& at : facet_points(*this, facets[k])) {
      const Value value = f(at);
      for (std::size_t c = 0; c < at.shape.size(); ++c) {
        const LocalIndex place = corners[k][c];
        if (place >= 0) sum[place] += at.shape[c] * value;
      }
    }
  }
  return sum;
}

}  // namespace brunt
// Tested by tests/verification/pressure_test.cpp.
