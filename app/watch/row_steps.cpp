#include "app/watch/row_steps.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
// [ns] on one core, docs/performance.md: a row adds up so many values of each; a step takes at
// least so much, of the cheapest material and formulation. What a row takes however little it adds
// up is left out: it is less than a tenth of a second in all rows of a run.
constexpr Real kRowOfPoint = 20, kRowOfEntity = 15;
constexpr Real kStepOfQuad = 50, kStepOfHex = 150, kStepOfParticle2d = 300, kStepOfParticle = 700;
}  // namespace

template <int Dim>
RowWork row_work(const Scene<Dim>& scene) {
  const auto points = static_cast<Real>(scene.n_points());
  const auto elements = static_cast<Real>(scene.n_elements());
  const auto particles = static_cast<Real>(scene.n_particles());
  const Real of_element = Dim == 3 ? kStepOfHex : kStepOfQuad;
  const Real of_particle = Dim == 3 ? kStepOfParticle : kStepOfParticle2d;
  return {kRowOfPoint * points + kRowOfEntity * (elements + particles),
          of_element * elements + of_particle * particles};
}

std::int64_t steps_between_rows(const RowWork& work) {
  constexpr Real kMost = 100;
  if (!(work.step > 0)) return 1;
  const Real steps = std::ceil(work.row / (kShareOfRows * work.step));
  return static_cast<std::int64_t>(std::clamp(steps, Real{1}, kMost));
}

template RowWork row_work<2>(const Scene<2>&);
template RowWork row_work<3>(const Scene<3>&);

}  // namespace brunt
// Tested by tests/unit/app/row_steps_test.cpp.
