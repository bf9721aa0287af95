#pragma once
/// What a schema cannot see: values that are right one by one and do not fit together.
#include "app/deck/deck.hpp"
#include "app/deck/findings.hpp"

namespace brunt::deck {

/// All checks below. Parts that could not be read are left out.
void check_deck(const Deck& deck, Findings& findings);

/// Names of bodies, materials, pairs and measures.
void check_references(const Deck& deck, Findings& findings);
/// Temperatures, heat and equations of state against the rest of their material.
void check_materials(const Deck& deck, Findings& findings);
/// Bodies against the geometry, their method and what they are asked to do.
void check_bodies(const Deck& deck, Findings& findings);
/// Times and intervals against the end of the run; boundaries that contradict themselves.
void check_times(const Deck& deck, Findings& findings);
/// What time.process_speed cannot make faster, and what inertia decides.
void check_process_speed(const Deck& deck, Findings& findings);

}  // namespace brunt::deck
