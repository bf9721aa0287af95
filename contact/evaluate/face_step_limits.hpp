#pragma once
#include "contact/evaluate/evaluate.hpp"

namespace brunt {

/// Takes in the bound of two faces that close in on each other, docs/theory/contact.md (C43): in
/// one step they come no deeper than the onset g0 of their barrier, or half of that deeper than
/// they are, each by its foremost and its fastest corner. What is farther behind than its limit
/// does not bound the step.
template <int Dim>
void limit_by_approach(const Entities<Dim>& entities, const FaceCandidate& candidate,
                       const EvaluationStep& step, StepLimit& step_limit);

/// Takes in the bounds of both faces of a plane that reaches into the barrier, or does so in a step
/// at its speed: those of elements, and of rigid bodies, with the slope that the pressure has there
/// for that of the linear spring; and that of faces that open, by half of what they are beyond g0.
/// closing  [m/s]
template <int Dim>
void limit_by_barrier(const Entities<Dim>& entities, const FaceCandidate& candidate,
                      const CommonPlane<Dim>& plane, Real closing, const EvaluationStep& step,
                      StepLimit& step_limit);

/// Takes in the bounds of both faces of a watched pair (PairOptions::watched), by the area
/// that they may press in a step at their speed: docs/theory/contact.md (C56). An edge that digs
/// into a face presses little of it, however stiff the pair.
template <int Dim>
void limit_by_pressed_area(const Entities<Dim>& entities, const FaceCandidate& candidate,
                           const EvaluationStep& step, StepLimit& step_limit);

/// Takes in the bounds of faces whose pressure fades as they turn to each other: where the ramp of
/// (C7) is on its slope, what the pair would hold without it bends by 6/width^2 at most.
template <int Dim>
void limit_by_turn(const Entities<Dim>& entities, const FaceCandidate& candidate,
                   const CommonPlane<Dim>& plane, StepLimit& step_limit);

/// The same bounds of faces that do not push, but turn so fast that they come onto that slope in
/// the longest step that may follow.
/// overlap  [m] of which contact takes no notice
template <int Dim>
void limit_by_turning(const Entities<Dim>& entities, const FaceCandidate& candidate,
                      const Section& section, Real overlap, const EvaluationStep& step,
                      StepLimit& step_limit);

}  // namespace brunt
