#pragma once
#include "contact/geometry/face_plane.hpp"
#include "contact/geometry/place.hpp"

namespace brunt {

/// Of the mean planes of four quads side by side what says how they stretch and warp.
struct FourMeans {
  Place<Pack> normal;
  Pack area, warp;
  PackMask there;  ///< those that have an area and a normal; others have 0 of all

  FourMeans() = default;
  /// x  [m] corner c of all four, for c = 0 .. 3
  explicit FourMeans(const std::array<Place<Pack>, 4>& x);
};

/// What refresh gives of four quads side by side, with the same bits, and their boxes.
struct FourPlanes {
  Place<Pack> center, normal;
  Pack area, warp;
  PackMask simple, flat;
  Place<Pack> lo, hi;

  /// x  [m] corner c of all four, for c = 0 .. 3; area_start  [m^2] at time 0
  /// (contact/surfaces/start_warp.hpp)
  FourPlanes(const std::array<Place<Pack>, 4>& x, Pack area_start);
  /// Hands those of one of them over: all that refresh fills.
  void give(int lane, FacePlane<3>& face) const;
  /// The same of all four, and their boxes.
  void give(FacePlane<3>* const (&face)[4], SearchBox<3>* const (&box)[4]) const;
  SearchBox<3> box(int lane) const;
};

}  // namespace brunt
