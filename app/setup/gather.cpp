#include "app/setup/gather.hpp"

#include "core/boundaries/function.hpp"
#include "core/geometry/curve.hpp"

namespace brunt {

namespace {
template <int Dim>
Vec<Dim> vector_of(const std::vector<Real>& values) {
  Vec<Dim> v = Vec<Dim>::Zero();
  for (std::size_t c = 0; c < values.size() && c < Dim; ++c) v[static_cast<int>(c)] = values[c];
  return v;
}

/// Velocity at time 0 of a point of a body: its translation and its spin.
template <int Dim>
Vec<Dim> start_velocity(const deck::Body& body, const Vec<Dim>& absolute) {
  Vec<Dim> v = vector_of<Dim>(body.velocity);
  for (int c = 0; deck::has_velocity_field(body) && c < Dim; ++c) {
    const Varying& given = *(*body.start_velocity)[slot_of(c)];
    Vec3 place = Vec3::Zero();
    place.template head<Dim>() = absolute;
    v[c] = function_of(given)(0, place);
  }
  if (body.spin) {
    Vec3 arm = Vec3::Zero();
    arm.template head<Dim>() = absolute - vector_of<Dim>(body.spin->about);
    const Vec3 axis = Dim == 2 ? Vec3::UnitZ() : vector_of<3>(body.spin->axis);
    v += (body.spin->rate * axis.cross(arm)).template head<Dim>();
  }
  return v;
}
}  // namespace

template <int Dim>
Gathered<Dim> gather(const LoadedDeck& loaded, const Scene<Dim>& scene,
                     const std::vector<BodyGeometry<Dim>>& bodies,
                     const std::vector<std::size_t>& chosen, NextIds& next) {
  Gathered<Dim> gathered;
  gathered.place_of.resize(bodies.size());
  std::vector<Origin> origins;
  std::vector<Vec<Dim>> positions;
  std::size_t n = 0;
  for (const std::size_t b : chosen) n += bodies[b].points.size();
  origins.reserve(n), positions.reserve(n), gathered.from.reserve(n);
  for (const std::size_t b : chosen) {
    gathered.place_of[b].resize(bodies[b].points.size());
    for (std::size_t i = 0; i < bodies[b].points.size(); ++i) {
      origins.push_back({static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(i)});
      positions.push_back(bodies[b].points[i] - scene.origin);
    }
  }
  const auto order = order_of(curve_keys<Dim>(positions));
  auto& points = gathered.points;
  points.resize(static_cast<LocalIndex>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) {
    // The curve goes through bodies in jumps, which no processor foresees.
    constexpr std::size_t kAhead = 16;
    if (k + kAhead < order.size()) {
      const Origin next_from = origins[order[k + kAhead]];
      __builtin_prefetch(&positions[order[k + kAhead]]);
      __builtin_prefetch(&bodies[next_from.body].points[next_from.index]);
    }
    const Origin from = origins[order[k]];
    const Label label = bodies[from.body].label;
    gathered.from.push_back(from);
    gathered.place_of[from.body][from.index] = static_cast<LocalIndex>(k);
    points.id[k] = next.point++;
    points.body[k] = label;
    points.x[k] = points.x_start[k] = positions[order[k]];
    const auto& body = loaded.deck.bodies[label].value;
    points.v[k] = start_velocity<Dim>(body, bodies[from.body].points[from.index]);
  }
  return gathered;
}

template Gathered<2> gather(const LoadedDeck&, const Scene<2>&, const std::vector<BodyGeometry<2>>&,
                            const std::vector<std::size_t>&, NextIds&);
template Gathered<3> gather(const LoadedDeck&, const Scene<3>&, const std::vector<BodyGeometry<3>>&,
                            const std::vector<std::size_t>&, NextIds&);

}  // namespace brunt
