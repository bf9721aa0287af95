#include "app/ranks/distribute.hpp"

#include <utility>

namespace brunt {

template <int Dim>
WeighedPoints<Dim> weighed_points(const Scene<Dim>& scene) {
  std::size_t n = 0;
  for (const auto& solid : scene.solids) n += solid->points().x.size();
  WeighedPoints<Dim> all{std::vector<Vec<Dim>>(n, Vec<Dim>::Zero()), std::vector<Real>(n, 0.0)};
  for (const auto& solid : scene.solids) {
    const auto& points = solid->points();
    // A particle costs as much as some five hexes; points of rigid surfaces next to nothing, and a
    // wall that is wider than what hits it would turn the cuts along it.
    const Real cost = solid->n_particles() ? 5.0 : (solid->n_elements() ? 1.0 : 0.0);
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
  scene.partition = std::move(partition);
  std::vector<std::unique_ptr<Solid<Dim>>> whole;
  for (auto& solid : scene.solids) {
    auto part = solid->part(*scene.partition, ranks);
    scene.rigid_motions.follow(solid->points(), part->points());
    scene.boundaries.follow(solid->points(), part->points());
    scene.loads.follow(solid->points(), part->points());
    if (scene.rigid) scene.rigid->follow(solid->points(), part->points());
    whole.push_back(std::exchange(solid, std::move(part)));
  }
  if (!scene.contact) return;
  std::vector<Surface<Dim>*> surfaces;
  for (auto& solid : scene.solids) surfaces.push_back(&solid->surface());
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
