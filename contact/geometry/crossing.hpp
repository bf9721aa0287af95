#pragma once
#include "contact/geometry/face_plane.hpp"

namespace brunt {

/// Where two faces go through each other.
template <int Dim>
struct Crossing {
  Real depth = 0;                     ///< [m] see find_crossing
  Vec<Dim> point = Vec<Dim>::Zero();  ///< [m]
};

/// True where each face reaches behind the other's plane by more than `limit` [m] and, in 3D, they
/// share a line longer than that: a corner of one body has gone into the other, or an edge through
/// one of its faces. The depth is the least of the three, so that the rim of what lies a little in
/// a large face is as deep as it lies, and edges that cross are as deep as they reach. Faces are
/// taken as their mean planes. False: crossing is as it was given.
template <int Dim>
bool find_crossing(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, Real limit,
                   Crossing<Dim>& crossing);

}  // namespace brunt
