#pragma once
#include <string>
#include <vector>

#include "app/cli/calibration.hpp"
#include "app/deck/deck.hpp"

namespace brunt {

/// A run of the deck, mostly with larger elements and particles, which costs little: how its steps
/// grew.
struct Rehearsal {
  Real factor = 1;  ///< sizes over those of the deck; 1: that of the deck itself
  Real growth = 1;  ///< steps over those that its first step promised
  Real dearer = 1;  ///< seconds of a step over those of its first steps
  Real share = 1;   ///< of the time to the deck's end, where `stop` ends it before
};

/// The growth of steps that rehearsals lead to expect at the deck's own sizes: that of the finest,
/// and half of what it has over the one before, unless it is less than 2 times as coarse. Element
/// faces that are struck flatten the more, the thinner they are: 8.8, 12.6 and 17.3 times the steps
/// with elements 2.7, 2 and 1 times as large in taylor-bar-axisymmetric.
Real expected_growth(const std::vector<Rehearsal>& rehearsals);

/// How much dearer steps get than the first ones, and the share of its time that a run takes, as
/// the finest rehearsal says; 1 without any.
Real expected_cost(const std::vector<Rehearsal>& rehearsals);
Real expected_share(const std::vector<Rehearsal>& rehearsals);

/// [s] of processor time up to which a run is tried whole.
inline constexpr Real kShortRun = 5;

/// Runs the deck to its end on one thread: itself, if it then takes a few seconds; else with
/// elements and particles 3 and 2 times as large, as far as that takes no more than a quarter of
/// the run itself; where elements erode also 1.5 times as large, within 0.4 of it: how thin they
/// get before they go depends on their size. None where sizes cannot be made larger.
/// measured  its own first steps;  seconds  [s] of processor time that the run would take if steps
/// stayed as long as the first
std::vector<Rehearsal> rehearse(const std::string& deck, const std::vector<std::string>& overrides,
                                const LoadedDeck& loaded, const Calibration& measured,
                                Real seconds);

}  // namespace brunt
