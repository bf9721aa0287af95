/// What has broken in a scene, said alike on any ranks: of all that breaks by one step the same is
/// named, the first in the order of one rank.
#include <cmath>
#include <tuple>

#include "app/scene/scene.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
Bytes packed(const PhysicsFailure& failure) {
  return (Packer() << failure.time << failure.body << failure.entity << failure.quantity
                   << failure.value << failure.cause << failure.group << failure.id)
      .take();
}

PhysicsFailure failure_in(const Bytes& bytes) {
  PhysicsFailure failure;
  Unpacker(bytes) >> failure.time >> failure.body >> failure.entity >> failure.quantity >>
      failure.value >> failure.cause >> failure.group >> failure.id;
  return failure;
}

/// Throws on all ranks the first failure of all.
void agree(const std::optional<PhysicsFailure>& mine, const Communicator& ranks) {
  if (!ranks.any(mine.has_value())) return;
  std::optional<PhysicsFailure> first;
  for (const Bytes& bytes : ranks.all_gather(mine ? packed(*mine) : Bytes{})) {
    if (bytes.empty()) continue;
    PhysicsFailure one = failure_in(bytes);
    const bool before = !first || std::tie(one.group, one.id) < std::tie(first->group, first->id);
    if (before) first = std::move(one);
  }
  throw PhysicsError(*first);
}

/// The first owned point whose position, velocity or temperature is no number.
template <int Dim>
std::optional<PhysicsFailure> point_failure(const Points<Dim>& points, Real time,
                                            const std::vector<std::string>& body_names) {
  for (std::size_t i = 0; i < points.owned(); ++i) {
    // One test finds NaN and infinity in either vector.
    Real sum = points.x[i].sum() + points.v[i].sum();
    const bool moves = std::isfinite(sum);
    if (points.conducts) sum += points.temperature[i];
    if (std::isfinite(sum)) continue;
    PhysicsFailure failure{
        time,
        body_names[points.body[i]],
        "point " + std::to_string(points.id[i]),
        moves ? "temperature" : "position or velocity",
        sum,
        "a force on it was no number: try a smaller time.safety, and look at the "
        "last frame for an element or particle that collapsed"};
    failure.id = points.id[i];
    return failure;
  }
  return {};
}

/// What a check throws, as one of `group`.
template <class Check>
std::optional<PhysicsFailure> caught(std::size_t group, const Check& check) {
  try {
    check();
  } catch (const PhysicsError& error) {
    PhysicsFailure failure = error.failure();
    failure.group = group;
    return failure;
  }
  return {};
}
}  // namespace

template <int Dim>
void Scene<Dim>::check(Real time) const {
  agree(own_failure(time), *ranks);
}

template <int Dim>
bool Scene<Dim>::is_sound(Real time) const {
  return !ranks->any(own_failure(time).has_value());
}

template <int Dim>
std::optional<PhysicsFailure> Scene<Dim>::own_failure(Real time) const {
  // Elements and particles first: an inverted element is why its points are no numbers.
  std::size_t group = 0;
  std::optional<PhysicsFailure> failure;
  for (const auto& solid : solids) {
    failure = caught(group++, [&] { solid->check(time, body_names); });
    if (failure) return failure;
  }
  failure = caught(group++, [&] {
    if (contact) contact->check(time, origin);
  });
  for (const auto& solid : solids) {
    if (failure) return failure;
    failure = point_failure(solid->points(), time, body_names);
    if (failure) failure->group = group;
    ++group;
  }
  return failure;
}

template void Scene<2>::check(Real) const;
template void Scene<3>::check(Real) const;
template bool Scene<2>::is_sound(Real) const;
template bool Scene<3>::is_sound(Real) const;
template std::optional<PhysicsFailure> Scene<2>::own_failure(Real) const;
template std::optional<PhysicsFailure> Scene<3>::own_failure(Real) const;

}  // namespace brunt
