// In which order elements, facets and contact's particles are stored changes no bit: sums run in
// the order of ids. Points are stored by id, always (core/points.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "fe/finite_elements.hpp"
#include "tests/support/simulate.hpp"
#include "tests/support/source_path.hpp"

namespace brunt {
namespace {

std::vector<std::size_t> shuffled(std::size_t n, std::mt19937& random) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

/// The elements of a group in sets as a builder would hand them over, in another order.
std::vector<ElementSet<3>> shuffled_sets(const FiniteElements<3>& elements, std::mt19937& random) {
  std::vector<ElementSet<3>> sets;
  for (const auto& block : elements.blocks()) {
    auto& set = sets.emplace_back();
    set.material = block.material, set.options = block.options;
    set.temperature = block.temperature, set.adiabatic = block.adiabatic;
    set.conducts = block.conducts, set.held = block.held;
    for (const std::size_t e : shuffled(static_cast<std::size_t>(block.n), random)) {
      std::array<LocalIndex, 8> corners;
      std::copy_n(block.corner.begin() + static_cast<std::ptrdiff_t>(8 * e), 8, corners.begin());
      set.corners.push_back(corners);
      set.id.push_back(block.id[e]);
      set.body.push_back(block.body[e]);
      set.piece.push_back(block.piece[e]);
      set.owned.push_back(1);
    }
  }
  std::shuffle(sets.begin(), sets.end(), random);
  return sets;
}

/// Stores everything that may be stored in any order in another one. partition  of one rank,
/// outlives it
void shuffle_storage(Scene<3>& scene, const Partition& partition) {
  std::mt19937 random(7);
  std::vector<std::unique_ptr<Solid<3>>> old;
  std::vector<Surface<3>*> surfaces;
  for (auto& solid : scene.solids) {
    if (const auto* elements = dynamic_cast<const FiniteElements<3>*>(solid.get())) {
      auto fresh = std::make_unique<FiniteElements<3>>(
          elements->points(), shuffled_sets(*elements, random), Geometry::three_d, 1.0);
      // Elements stand by id in their block, however they are handed over.
      ASSERT_TRUE(std::is_sorted(fresh->blocks()[0].id.begin(), fresh->blocks()[0].id.end()));
      scene.rigid_motions.follow(solid->points(), fresh->points());
      scene.boundaries.follow(solid->points(), fresh->points());
      scene.loads.follow(solid->points(), fresh->points());
      old.push_back(std::exchange(solid, std::move(fresh)));
    }
    auto& surface = solid->surface();
    std::shuffle(surface.facets.begin(), surface.facets.end(), random);
    std::shuffle(surface.particles.begin(), surface.particles.end(), random);
    surfaces.push_back(&surface);
  }
  scene.contact = std::make_unique<ContactManager<3>>(*scene.contact, std::move(surfaces),
                                                      partition, lone_rank());
}

void expect_same_bits(const std::string& name, const std::vector<std::string>& overrides,
                      const std::string& column) {
  const std::string path = test::source_path("decks/" + name + "/" + name + ".yaml");
  const LoadedDeck loaded = load_deck(path, overrides);
  const auto plain = test::simulate(loaded);
  Partition partition;
  test::SceneHooks hooks;
  hooks.built = [&](Scene<3>& scene) {
    partition.owner.assign(scene.n_points(), 0);
    shuffle_storage(scene, partition);
  };
  const auto other = test::simulate(loaded, {}, hooks);
  ASSERT_TRUE(plain.failure.empty() && other.failure.empty());
  ASSERT_GT(plain.rows.size(), 10U);
  EXPECT_EQ(plain.hashes, other.hashes);
  EXPECT_EQ(plain.rows, other.rows);
  // Something did touch, or the order of contacts would not have mattered.
  const auto planes = plain.column(column);
  EXPECT_GT(*std::max_element(planes.begin(), planes.end()), 4);
}

TEST(StorageOrder, OfElementsAndFacets) {
  for (const char* element : {"{integration: one-point}", "{integration: q1p0}"}) {
    expect_same_bits(
        "taylor-bar",
        {"parameters.size=0.9 mm", "time.end=3 us", std::string("bodies.bar.element=") + element},
        "contact.bar-anvil.planes");
  }
}

TEST(StorageOrder, OfElementsFacetsAndParticles) {
  expect_same_bits("drop-on-plate", {"parameters.size=4 mm", "time.end=40 us"},
                   "contact.block-plate.planes");
}

TEST(StorageOrder, OfContactsOfParticles) {
  expect_same_bits("taylor-bar-sph", {"parameters.spacing=0.8 mm", "time.end=3 us"},
                   "contact.bar-anvil.planes");
}

}  // namespace
}  // namespace brunt
