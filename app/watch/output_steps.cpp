#include "app/watch/output_steps.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
// [ns] on one core, docs/performance.md: a row adds up so many values of each and writes its
// columns, a frame writes so many values; a step takes at least so much, of the cheapest material
// and formulation. What a frame takes however little there is in it is left out: less than a tenth
// of a second in a run.
constexpr Real kRowOfColumn = 400;
constexpr Real kRowOfPoint2d = 10, kRowOfEntity2d = 10, kRowOfPoint = 20, kRowOfEntity = 15;
constexpr Real kFrameOfPoint = 100, kFrameOfEntity = 100;
constexpr Real kStepOfQuad = 45, kStepOfHex = 100, kStepOfParticle2d = 150, kStepOfParticle = 700;

std::int64_t steps_for(Real work, Real share, Real step) {
  constexpr Real kEver = 1e15;
  if (!(step > 0)) return 1;
  return static_cast<std::int64_t>(std::clamp(std::ceil(work / (share * step)), Real{1}, kEver));
}
}  // namespace

template <int Dim>
OutputWork output_work(const Scene<Dim>& scene, std::size_t columns) {
  const auto points = static_cast<Real>(scene.n_points());
  const auto elements = static_cast<Real>(scene.n_elements());
  const auto particles = static_cast<Real>(scene.n_particles());
  const bool space = Dim == 3;
  return {kRowOfColumn * static_cast<Real>(columns) +
              (space ? kRowOfPoint : kRowOfPoint2d) * points +
              (space ? kRowOfEntity : kRowOfEntity2d) * (elements + particles),
          kFrameOfPoint * points + kFrameOfEntity * (elements + particles),
          (space ? kStepOfHex : kStepOfQuad) * elements +
              (space ? kStepOfParticle : kStepOfParticle2d) * particles};
}

std::int64_t steps_between_rows(const OutputWork& work) {
  constexpr std::int64_t kMost = 100;
  return std::min(steps_for(work.row, kShareOfRows, work.step), kMost);
}

Real sure_rows(const OutputWork& work) {
  return work.row > 0 ? std::floor(kTimeOfSureRows / work.row) : kInfinity;
}

std::int64_t steps_between_frames(const OutputWork& work) {
  return steps_for(work.frame, kShareOfFrames, work.step);
}

template OutputWork output_work<2>(const Scene<2>&, std::size_t);
template OutputWork output_work<3>(const Scene<3>&, std::size_t);

}  // namespace brunt
// Tested by tests/unit/app/output_steps_test.cpp.
