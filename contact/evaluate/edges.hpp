#pragma once
#include "contact/evaluate/evaluate.hpp"

namespace brunt {

/// Appends a record for each two blades (contact/geometry/edge_contact.hpp) of a pair of faces that
/// push each other, and the bounds of their springs to part.step_limit. Their spring is k l^2
/// [N/m], k that of the faces and l [m] the depth at which they let go. Edges have no friction and
/// pass no heat. Blades that cross at time 0, or where a face is born, feel it as their faces do
/// (docs/theory/contact.md (C36)): what is left of that goes to part.face_touches.
/// born  one of the faces is new in this step
inline void add_blades(const Entities<2>&, const FaceCandidate&, const EvaluationStep&,
                       bool /*born*/, Records<2>::Part&) {}
void add_blades(const Entities<3>& entities, const FaceCandidate& candidate,
                const EvaluationStep& step, bool born, Records<3>::Part& part);

}  // namespace brunt
