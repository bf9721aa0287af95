#pragma once
#include <vector>

#include "contact/contacts/face_tractions.hpp"
#include "contact/contacts/friction_check.hpp"

namespace brunt {

/// Books what friction did in a step (docs/theory/contact.md (C33)) to the nodes of its evaluators,
/// with what ended in it, sums what the faces carry from now on, and shows every coefficient to
/// `check`. The spring of a face that went takes what it holds with it.
/// died  ids of these, ascending;  elsewhere  what contacts of other ranks leave on faces here,
/// sorted by key
template <int Dim>
void book_friction(const Records<Dim>& records, const FrictionHistory<Dim>& past,
                   const std::vector<GlobalId>& died, const PairTable& pairs,
                   std::vector<TractionShare<Dim>> elsewhere, FrictionCheck<Dim>& check,
                   Entities<Dim>& entities);

/// Books what joints have used up in this evaluation: it comes from what their springs have taken
/// from motion.
template <int Dim>
void book_losses(const Records<Dim>& records, Entities<Dim>& entities);

/// Books what springs whose face went in this step hold: as they stood at its start, and what their
/// forces have taken from motion in its first half. nodes  with the motion of the step
/// died  ids of these faces, ascending;  dt  [s]
template <int Dim>
void book_eroded(const Records<Dim>& records, const std::vector<GlobalId>& died, Real dt,
                 ContactNodes<Dim>& nodes);

}  // namespace brunt
