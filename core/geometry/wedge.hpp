#pragma once
#include "core/geometry/shape.hpp"

namespace brunt {

/// The outline of a cutting tool: rake face, rounded edge, clearance face, and its back. The edge
/// is a polyline on its circle, of equal chords that turn by 10 degrees at most, and so within
/// edge_radius (1 - cos 5 deg) of it. The four corners for elements are the middle of the edge and
/// the ends of the two faces and of the back. z begins at the tip's. The wedge must be sound.
PolygonShape polygon_of(const Wedge& wedge);

/// [m] how far from the tip, along both faces, the rounded edge begins.
Real length_of_edge(const Wedge& wedge);

}  // namespace brunt
