#include "core/boundaries/force.hpp"

#include <utility>

#include "core/exact_sum.hpp"

namespace brunt {

void describe(Schema& s, AppliedForce& load) {
  s.components({"force", "force in total on all these points, shared by mass"}, load.force, {"N"},
               kTimeOrPlace);
}

template <int Dim>
ForceLoad<Dim>::ForceLoad(const AppliedForce& load, Patch<Dim> on) : patch(std::move(on)) {
  const auto weight = [&](std::size_t k) {
    return patch.weight.empty() ? patch.points->mass[patch.point(k)] : patch.weight[k];
  };
  ExactSum all;
  for (std::size_t k = 0; k < patch.size(); ++k) all.add(weight(k));
  for (std::size_t k = 0; k < patch.size(); ++k) share.push_back(weight(k) / all.value());
  for (std::size_t c = 0; c < load.force->size() && c < Dim; ++c) {
    if ((*load.force)[c]) force[c] = function_of(*(*load.force)[c]);
  }
}

template <int Dim>
void ForceLoad<Dim>::add_forces(Real time, Real dt) {
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const Vec3 place = patch.place(k);
    Vec<Dim> now = Vec<Dim>::Zero();
    for (int c = 0; c < Dim && patch.acts(time); ++c) {
      if (force[c]) now[c] = share[k] * (*force[c])(time, place);
    }
    books.push(k, patch.point(k), now, dt, *patch.points);
  }
}

template struct ForceLoad<2>;
template struct ForceLoad<3>;

}  // namespace brunt
// Tested by tests/unit/app/loads_test.cpp.
