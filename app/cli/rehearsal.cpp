#include "app/cli/rehearsal.hpp"

#include <algorithm>
#include <cmath>

#include "app/cli/calibration.hpp"
#include "app/cli/forecast.hpp"
#include "app/setup/scene_builder.hpp"
#include "app/trade/refine.hpp"

namespace brunt {

namespace {
template <int Dim>
std::optional<Calibration> run_whole(const LoadedDeck& loaded, Real seconds, Real first_part) {
  try {
    const auto scene = build_scene<Dim>(loaded);
    constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();
    return calibrate(loaded, *scene, SampleLimits{seconds, kNoLimit, first_part});
  } catch (const std::exception&) {
    return std::nullopt;  // too coarse to be built
  }
}

/// Seconds of a step over those of the first ones, as a coarser run has it. No more than that run
/// took by its points: a coarse scene has more surface, so that each of them costs more.
Real dearer_than_first(const Calibration& measured, const Calibration& coarse) {
  const Real by_points = coarse.seconds_per_step * measured.points / coarse.points;
  return std::min(coarse.dearer, by_points / measured.seconds_per_step);
}

bool erodes(const Deck& deck) {
  return std::ranges::any_of(deck.bodies, [](const auto& named) {
    const auto& [name, body] = named;
    return !body.rigid && body.element.erosion.has_value();
  });
}

/// Steps that the deck gives in seconds bound those of a coarser run as they bound those of this
/// one.
void scale_steps(Deck& deck, Real factor) {
  for (auto& [name, body] : deck.bodies) {
    body.element.least_step *= factor;
    auto& erosion = body.element.erosion;
    if (erosion && erosion->when.step) *erosion->when.step *= factor;
  }
}

bool stops(const deck::Stop& stop) { return stop.at_rest || stop.beyond || !stop.when.empty(); }

/// Whether a third, finer rehearsal is worth its time: how thin an element gets before it erodes
/// depends on its size, and coarse bodies may slide for ever where finer ones come to rest.
bool needs_finer(const Deck& deck, const std::vector<Rehearsal>& done) {
  const bool none_stopped =
      std::ranges::all_of(done, [](const auto& one) { return one.share == 1; });
  return erodes(deck) || (stops(deck.stop) && none_stopped);
}
}  // namespace

Real expected_growth(const std::vector<Rehearsal>& rehearsals) {
  if (rehearsals.empty()) return 1;
  const Real finest = rehearsals.back().growth;
  constexpr Real kNear = 2;  // sizes: a finer one is as it is
  if (rehearsals.size() < 2 || rehearsals.back().factor < kNear) return finest;
  return finest + 0.5 * std::max(0.0, finest - rehearsals[rehearsals.size() - 2].growth);
}

Real expected_cost(const std::vector<Rehearsal>& rehearsals) {
  return rehearsals.empty() ? 1 : rehearsals.back().dearer;
}

Real expected_share(const std::vector<Rehearsal>& rehearsals) {
  return rehearsals.empty() ? 1 : rehearsals.back().share;
}

std::vector<Rehearsal> rehearse(const std::string& deck, const std::vector<std::string>& overrides,
                                const LoadedDeck& loaded, const Calibration& measured,
                                Real seconds) {
  constexpr Real kFiner = 1.5, kFactors[] = {3, 2, kFiner};
  constexpr Real kPart = 0.25, kPartFiner = 0.4;
  constexpr Real kLeast = 20, kMost = 60, kLeastFiner = 40, kMostFiner = 120;  // [s]
  std::vector<Rehearsal> done;
  const bool solid = loaded.deck.geometry == Geometry::three_d;
  if (seconds < kShortRun) {
    const auto run = solid ? run_whole<3>(loaded, kLeast, 0) : run_whole<2>(loaded, kLeast, 0);
    if (run && run->whole()) {
      return {{1, run->growth(), run->seconds_per_step / measured.seconds_per_step,
               run->reached / loaded.deck.time.end}};
    }
  }
  const SizeLever lever = own_sizes(loaded);
  if (lever.keys.empty()) return done;
  const Real begun = processor_seconds();
  Real last = 0;  // [s] what the one before took
  Real size = kFactors[0];
  for (const Real factor : kFactors) {
    const bool finer = factor == kFiner;
    if (finer && !needs_finer(loaded.deck, done)) break;
    auto coarser = overrides;
    for (const auto& change : lever.at(loaded, factor)) coarser.push_back(change);
    auto coarse = resized_deck(deck, coarser, loaded);
    if (!coarse) continue;
    scale_steps(coarse->deck, factor);
    const Real growth =
        done.empty() ? flattening_of(loaded.deck).most_steps() : expected_growth(done);
    const Real before = processor_seconds();
    const Real part = finer ? kPartFiner : kPart;
    const Real least = finer ? kLeastFiner : kLeast, most = finer ? kMostFiner : kMost;
    const Real left = std::clamp(part * growth * seconds, least, most) - (before - begun);
    if (last * std::pow(size / factor, solid ? 4 : 3) > left) break;  // more points and steps
    const auto run = solid ? run_whole<3>(*coarse, left, measured.reached)
                           : run_whole<2>(*coarse, left, measured.reached);
    if (!run || !run->whole()) continue;
    done.push_back({factor, run->growth(), dearer_than_first(measured, *run),
                    run->reached / loaded.deck.time.end});
    last = processor_seconds() - before;
    size = factor;
  }
  return done;
}

}  // namespace brunt
