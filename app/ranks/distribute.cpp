#include "app/ranks/distribute.hpp"

#include <utility>

#include "sph/particles.hpp"

namespace brunt {
namespace {

/// The particles of a group that ride on nodes; null where they are none.
template <int Dim>
SphParticles<Dim>* riders_of(const std::unique_ptr<Solid<Dim>>& solid) {
  return solid->rides() ? dynamic_cast<SphParticles<Dim>*>(solid.get()) : nullptr;
}

/// Riders go where their nodes go.
template <int Dim>
void join_riders(const Scene<Dim>& scene, Partition& partition) {
  for (const auto& solid : scene.solids) {
    const auto* const riders = riders_of(solid);
    if (riders == nullptr) continue;
    const auto nodes = riders->nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      partition.owner[riders->points().id[i]] = partition.owner[nodes[i]];
    }
  }
}

/// The parts of riders ride on the part of their carrier.
template <int Dim>
void mount_riders(const std::vector<std::unique_ptr<Solid<Dim>>>& whole, Scene<Dim>& scene) {
  for (std::size_t s = 0; s < whole.size(); ++s) {
    const auto* const riders = riders_of(whole[s]);
    for (std::size_t c = 0; riders != nullptr && c < whole.size(); ++c) {
      if (dynamic_cast<const ParticleCarrier<Dim>*>(whole[c].get()) != riders->carrier()) continue;
      auto& part = dynamic_cast<SphParticles<Dim>&>(*scene.solids[s]);
      part.ride_on(dynamic_cast<ParticleCarrier<Dim>&>(*scene.solids[c]),
                   {part.nodes().begin(), part.nodes().end()});
    }
  }
}

}  // namespace

template <int Dim>
WeighedPoints<Dim> weighed_points(const Scene<Dim>& scene) {
  std::size_t n = 0;
  for (const auto& solid : scene.solids) n += solid->points().x.size();
  WeighedPoints<Dim> all{std::vector<Vec<Dim>>(n, Vec<Dim>::Zero()), std::vector<Real>(n, 0.0)};
  for (const auto& solid : scene.solids) {
    const auto& points = solid->points();
    // A particle costs as much as some five hexes; points of rigid surfaces next to nothing, and a
    // wall that is wider than what hits it would turn the cuts along it.
    const Real cost = solid->rides()         ? 0.0
                      : solid->n_particles() ? 5.0
                                             : (solid->n_elements() ? 1.0 : 0.0);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      all.x[points.id[i]] = points.x[i];
      all.weight[points.id[i]] = cost;
    }
  }
  return all;
}

template <int Dim>
void distribute(Scene<Dim>& scene, const Communicator& ranks,
                std::unique_ptr<const Partition> partition) {
  scene.ranks = &ranks;
  scene.phases.ranks = &ranks;
  if (ranks.alone()) return;
  Partition joined = *partition;
  join_riders(scene, joined);
  scene.partition = std::make_unique<const Partition>(std::move(joined));
  std::vector<std::unique_ptr<Solid<Dim>>> whole;
  for (auto& solid : scene.solids) {
    auto part = solid->part(*scene.partition, ranks);
    scene.rigid_motions.follow(solid->points(), part->points());
    scene.boundaries.follow(solid->points(), part->points());
    scene.loads.follow(solid->points(), part->points());
    if (scene.rigid) scene.rigid->follow(solid->points(), part->points());
    whole.push_back(std::exchange(solid, std::move(part)));
  }
  mount_riders(whole, scene);
  if (!scene.contact) return;
  std::vector<Surface<Dim>*> surfaces;
  for (auto& solid : scene.solids) {
    if (!solid->rides()) surfaces.push_back(&solid->surface());
  }
  scene.contact = std::make_unique<ContactManager<Dim>>(*scene.contact, std::move(surfaces),
                                                        *scene.partition, ranks);
}

template <int Dim>
void distribute(Scene<Dim>& scene, const Communicator& ranks) {
  if (ranks.alone()) return distribute(scene, ranks, nullptr);
  const auto points = weighed_points(scene);
  distribute(
      scene, ranks,
      std::make_unique<const Partition>(make_partition<Dim>(ranks, points.x, points.weight)));
}

template WeighedPoints<2> weighed_points(const Scene<2>&);
template WeighedPoints<3> weighed_points(const Scene<3>&);
template void distribute<2>(Scene<2>&, const Communicator&);
template void distribute<3>(Scene<3>&, const Communicator&);
template void distribute<2>(Scene<2>&, const Communicator&, std::unique_ptr<const Partition>);
template void distribute<3>(Scene<3>&, const Communicator&, std::unique_ptr<const Partition>);

}  // namespace brunt
