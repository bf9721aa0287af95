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
std::optional<Calibration> run_whole(const LoadedDeck& loaded, Real seconds) {
  try {
    const auto scene = build_scene<Dim>(loaded);
    constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();
    return calibrate(loaded, *scene, SampleLimits{seconds, kNoLimit});
  } catch (const std::exception&) {
    return std::nullopt;  // too coarse to be built
  }
}
}  // namespace

Real expected_growth(const std::vector<Rehearsal>& rehearsals) {
  if (rehearsals.empty()) return 1;
  const Real finest = rehearsals.back().growth;
  if (rehearsals.size() < 2) return finest;
  return finest + 0.5 * std::max(0.0, finest - rehearsals[rehearsals.size() - 2].growth);
}

std::vector<Rehearsal> rehearse(const std::string& deck, const std::vector<std::string>& overrides,
                                const LoadedDeck& loaded, Real seconds) {
  constexpr Real kFactors[] = {3, 2};
  constexpr Real kPart = 0.25, kLeast = 20, kMost = 60;  // [s]
  std::vector<Rehearsal> done;
  const bool solid = loaded.deck.geometry == Geometry::three_d;
  if (seconds < kShortRun) {
    const auto run = solid ? run_whole<3>(loaded, kLeast) : run_whole<2>(loaded, kLeast);
    if (run && run->ended) {  // at its end, or where `stop` says
      const Real kept = loaded.deck.time.end / run->planned_step;
      return {{1, run->planned_step > 0 ? static_cast<Real>(run->steps) / kept : 1}};
    }
  }
  const SizeLever lever = own_sizes(loaded);
  if (lever.keys.empty()) return done;
  const Real finer = std::pow(kFactors[0] / kFactors[1], solid ? 4 : 3);  // more points and steps
  const Real begun = processor_seconds();
  Real last = 0;  // [s] what the one before took
  for (const Real factor : kFactors) {
    auto coarser = overrides;
    for (const auto& change : lever.at(loaded, factor)) coarser.push_back(change);
    const auto coarse = resized_deck(deck, coarser, loaded);
    if (!coarse) continue;
    const Real growth = done.empty() ? flattening_of(loaded.deck).most_steps() : done[0].growth;
    const Real before = processor_seconds();
    const Real left = std::clamp(kPart * growth * seconds, kLeast, kMost) - (before - begun);
    if (last * finer > left) break;
    const auto run = solid ? run_whole<3>(*coarse, left) : run_whole<2>(*coarse, left);
    if (!run || !run->ended) continue;
    done.push_back({factor, run->growth()});
    last = processor_seconds() - before;
  }
  return done;
}

}  // namespace brunt
