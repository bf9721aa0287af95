#pragma once
#include "contact/geometry/face_plane.hpp"
#include "contact/geometry/place.hpp"

namespace brunt {

/// How far a quad of which all but `split` is known is two triangles (docs/theory/contact.md (C4)).
/// turns  [m^2] at each corner, area of the parallelogram of its edges, negative where concave
Real split_of(const FacePlane<3>& face, const Pack& turns);

}  // namespace brunt
// Tested by tests/unit/contact/face_split_test.cpp.
