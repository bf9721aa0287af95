#pragma once
#include <span>

#include "contact/contacts/first_touch.hpp"
#include "contact/search/candidates.hpp"

namespace brunt {

/// What two faces keep from time 0, if anything.
template <int Dim>
FirstTouch first_touch(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper,
                       const Section& section, const FaceCandidate& candidate);

/// What two faces keep of which one is born in this step: contact takes no notice of any overlap
/// there is by then, however deep and whatever the pair's option says of time 0.
template <int Dim>
FirstTouch born_touch(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper,
                      const Section& section);

/// Largest penetration of planes [m], 0 at least.
template <int Dim>
Real deepest_of(std::span<const CommonPlane<Dim>> planes);

/// What is asked of the planes of two faces of which nothing is left of their first touch.
PlaneNeeds needs_of(const FaceCandidate& candidate, Real opening);

/// Sets the planes that carry force and returns how many: with the layer on which bodies rest, and
/// as what is left of the first touch of their faces says.
template <int Dim>
int planes_of(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Section& section,
              const FaceCandidate& candidate, const TouchStep& step, FirstTouch& touch,
              Planes<Dim>& planes);

}  // namespace brunt
