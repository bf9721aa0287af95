#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/points.hpp"

namespace brunt {

/// Proves that a neighbour list still holds every pair within reach. The particles of a label lie
/// in zones of a width w when the list is built. Pairs of the same or of touching zones can have
/// come nearer by what their zones moved against each other; others were apart by w along an axis.
/// Neighbours that stream past each other far apart, as in a body that turns, cost no search.
/// docs/theory/sph.md (S27), (S28).
template <int Dim>
class ListWatch {
 public:
  /// Remembers a list that holds all pairs within reach_i + reach_j + skin.
  /// label  only particles of one label are neighbours; reach  smoothing lengths [m]; skin  [m]
  /// x  [m]
  void start(std::span<const Vec<Dim>> x, std::span<const Label> label, std::vector<Real> reach,
             Real skin);
  /// True if the list still holds all pairs within reach_i + reach_j of the same label.
  /// x, reach [m]  of now
  bool covers(std::span<const Vec<Dim>> x, std::span<const Real> reach) const;

  /// Positions [m] and reaches [m] when the list was built.
  std::span<const Vec<Dim>> x() const { return x_; }
  std::span<const Real> reach() const { return reach_; }
  Real skin() const { return skin_; }  ///< [m]
  /// Zones of the list, and particles of each. Pairs within reach are of one or of two that touch.
  std::size_t n_zones() const { return zones_.size(); }
  std::span<const LocalIndex> members(std::size_t zone) const {
    const auto begin = slot_of(member_begin_[zone]), end = slot_of(member_begin_[zone + 1]);
    return {member_.data() + begin, end - begin};
  }
  /// Pairs of zones, each once, a zone with itself too.
  std::span<const std::array<LocalIndex, 2>> touching() const { return touching_; }

 private:
  struct Zone {
    Label label;
    std::array<std::int64_t, Dim> cell;
    auto operator<=>(const Zone&) const = default;
  };
  /// Displacements of the particles of a zone, by component, and growth of their reach.
  struct Extent {
    Vec<Dim> lower, upper;  // [m]
    Real growth;            // [m]
  };
  std::vector<Extent> extents(std::span<const Vec<Dim>> x, std::span<const Real> reach) const;
  bool touching_zones_hold(const std::vector<Extent>& extents) const;
  bool far_zones_hold(const std::vector<Extent>& extents) const;
  void link_zones();

  std::vector<Vec<Dim>> x_;  // [m] when the list was built
  std::vector<Real> reach_;  // [m] when the list was built
  Real skin_ = 0;            // [m]
  Real longest_ = 0;         // [m] of reach_
  Real width_ = 0;           // [m] of a zone
  std::vector<Zone> zones_;  // ascending
  std::vector<LocalIndex> member_, member_begin_;
  std::vector<std::array<LocalIndex, 2>> touching_;
};

}  // namespace brunt
