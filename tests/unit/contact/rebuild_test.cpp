// No answer may depend on when the lists are built, how wide they are, or whether the run was saved
// and went on in a new manager: loose faces and particles
// in a box, kicked at random, must end with the same bits for any skin, any forced rebuild, grid or
// brute force, one thread or more; and brute force with a skin beyond the scene lists every pair,
// so equal states at every step are equal active sets.
#include <gtest/gtest.h>
#include <omp.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

template <int Dim>
std::vector<Vec<Dim>> loose_face(std::mt19937_64& random, const Vec<Dim>& center) {
  std::normal_distribution<Real> normal(0, 1);
  std::vector<Vec<Dim>> corners;
  if constexpr (Dim == 2) {
    const Vec<2> half = 0.5 * Vec<2>(normal(random), normal(random)).normalized();
    corners = {center - half, center + half};
  } else {
    const Vec3 a = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Vec3 b = a.cross(Vec3(normal(random), normal(random), normal(random))).normalized();
    corners = {center - 0.5 * a - 0.5 * b, center + 0.5 * a - 0.5 * b, center + 0.5 * a + 0.5 * b,
               center - 0.5 * a + 0.5 * b};
    if (random() % 3 == 0) corners.pop_back();
  }
  return corners;
}

template <int Dim>
ContactScene<Dim> cloud() {
  ContactScene<Dim> scene;
  Varying& friction = scene.options.fallback.coulomb.friction.emplace();
  friction.constant = 0.3;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<Real> place(0, Dim == 2 ? 4 : 3);
  const auto anywhere = [&] {
    Vec<Dim> x;
    for (int c = 0; c < Dim; ++c) x[c] = place(random);
    return x;
  };
  for (int i = 0; i < 20; ++i) {
    auto& group = scene.add_group();
    const bool rigid = i % 5 == 0;
    scene.add_face(group, loose_face<Dim>(random, anywhere()), rigid ? 0 : 1e6, rigid ? 0 : 0.5,
                   rigid ? 0 : 100);
  }
  auto& group = scene.add_group();
  for (int i = 0; i < 20; ++i) scene.add_particle(group, anywhere(), 0.15, 1e6, 20);
  return scene;
}

struct Setting {
  std::optional<Real> skin;
  int forced = 0;  // rebuild every so many steps
  SearchMode mode = SearchMode::grid;
  int threads = 1;
  int restarted = 0;  // goes on in a new manager every so many steps
};

/// The present state in a manager that knows nothing but the surfaces.
template <int Dim>
void restart(ContactScene<Dim>& scene) {
  std::vector<StateTable> tables;
  scene.contact->save_state(tables);
  const auto contacts = scene.contact->work().contacts;
  const Real force = scene.contact->reports().at(0).force[0];
  scene.start().load_state(StateTables(std::move(tables)));
  EXPECT_EQ(scene.contact->work().contacts, contacts);
  EXPECT_EQ(scene.contact->reports().at(0).force[0], force);
}

/// State hashes along the way; contacts counts those that carried force.
template <int Dim>
std::vector<std::uint64_t> run(const Setting& setting, int steps, std::size_t& contacts) {
  auto scene = cloud<Dim>();
  scene.options.skin = setting.skin;
  scene.options.search = setting.mode;
  omp_set_num_threads(setting.threads);
  scene.start();
  std::mt19937_64 random(12);
  std::uniform_real_distribution<Real> kick(-1, 1);
  std::vector<std::uint64_t> hashes;
  Real dt = 1e-3;
  contacts = 0;
  for (int step = 0; step < steps; ++step) {
    if (setting.restarted && step % setting.restarted == 0) restart(scene);
    dt = std::min(0.5 * scene.contact->stable_step().step, 5e-3);
    const bool due = setting.forced && step % setting.forced == 0;
    if (due) scene.contact->rearrange();
    // The kick comes after all that could predict it: what is checked is the motion itself.
    for (auto& group : scene.groups) {
      auto& p = group.points;
      Vec<Dim> push;
      for (int c = 0; c < Dim; ++c) push[c] = kick(random);
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        // Walls far out pull back, so that the cloud stays together.
        const Vec<Dim> home = Vec<Dim>::Constant(1.5) - p.x[i];
        p.v[i] = 0.98 * p.v[i] + 0.3 * push + 0.02 * home;
      }
    }
    scene.step(dt);
    contacts += scene.contact->work().contacts;
    EntityHash hash(scene.totals().state_hash);
    for (const auto& group : scene.groups) {
      for (const auto& x : group.points.x) {
        for (int c = 0; c < Dim; ++c) hash.add(x[c]);
      }
    }
    hash.add(dt);
    hashes.push_back(hash.value());
  }
  omp_set_num_threads(omp_get_num_procs());
  return hashes;
}

template <int Dim>
void check_all() {
  constexpr int steps = 10000;
  std::size_t contacts = 0, other = 0;
  const auto all = run<Dim>({100.0, 0, SearchMode::brute, 1}, steps, contacts);
  EXPECT_GT(contacts, static_cast<std::size_t>(steps / 2));
  for (const Setting& setting : {Setting{0.0, 0, SearchMode::grid, 1},
                                 {0.01, 3, SearchMode::grid, 2},
                                 {0.2, 0, SearchMode::grid, 1},
                                 {2.0, 0, SearchMode::grid, 2},
                                 {std::nullopt, 0, SearchMode::grid, 2},
                                 {std::nullopt, 7, SearchMode::brute, 1},
                                 {std::nullopt, 0, SearchMode::grid, 1, 11}}) {
    const auto hashes = run<Dim>(setting, steps, other);
    EXPECT_EQ(contacts, other);
    const auto differ = std::mismatch(all.begin(), all.end(), hashes.begin());
    EXPECT_EQ(differ.first - all.begin(), steps) << "skin " << setting.skin.value_or(-1);
  }
}

/// State hashes of a cloud of which every other body is put elsewhere and back between steps, as no
/// velocity tells.
template <int Dim>
std::vector<std::uint64_t> run_with_jumps(std::optional<Real> skin, std::size_t& contacts) {
  auto scene = cloud<Dim>();
  scene.options.skin = skin;
  scene.start();
  std::vector<std::uint64_t> hashes;
  contacts = 0;
  for (int step = 0; step < 60; ++step) {
    const Real jump = (step % 2 ? -1 : 1) * (0.1 + 0.03 * (step / 2));
    for (std::size_t g = 0; g < scene.groups.size(); g += 2) {
      for (auto& x : scene.groups[g].points.x) x += Vec<Dim>::Constant(jump);
    }
    scene.step(1e-4);
    contacts += scene.contact->work().contacts;
    EntityHash hash(scene.totals().state_hash);
    for (const auto& group : scene.groups) {
      for (const auto& f : group.points.f) {
        for (int c = 0; c < Dim; ++c) hash.add(f[c]);
      }
    }
    hashes.push_back(hash.value());
  }
  return hashes;
}

template <int Dim>
void check_jumps() {
  std::size_t contacts = 0, other = 0;
  const auto all = run_with_jumps<Dim>(100.0, contacts);  // every pair there is
  EXPECT_GT(contacts, 60u);
  for (const std::optional<Real> skin : {std::optional<Real>(0.0), {0.2}, {}}) {
    EXPECT_EQ(run_with_jumps<Dim>(skin, other), all) << skin.value_or(-1);
    EXPECT_EQ(contacts, other);
  }
}

/// Forces on a rough sheet of 40 x 40 faces that lies in another of 37 x 37, under 3000 particles.
std::vector<Vec3> forces_with(int threads) {
  ContactScene<3> scene;
  const auto rough = [](const Vec3& x) {
    return Vec3(x + 0.02 * Vec3(0, 0, std::sin(31 * x[0]) + std::cos(17 * x[1])));
  };
  testing::add_sheet(scene, 40, 0, 10, 0, true, 1e6, 0.3, rough);
  testing::add_sheet(scene, 37, 0, 10, 0, false, 1e6, 0.3, rough);
  auto& group = scene.add_group();
  for (int i = 0; i < 3000; ++i) {
    scene.add_particle(group, Vec3(i % 55 * 0.18, i / 55 * 0.18, 0.05), 0.09, 1e6, 1);
  }
  omp_set_num_threads(threads);
  scene.start();
  for (int step = 0; step < 3; ++step) scene.step(1e-4);
  omp_set_num_threads(omp_get_num_procs());
  EXPECT_GT(scene.contact->work().contacts, 4000u);
  std::vector<Vec3> forces;
  for (const auto& of : scene.groups) {
    forces.insert(forces.end(), of.points.f.begin(), of.points.f.end());
  }
  return forces;
}

TEST(ContactRebuild, ThreadsChangeNoBit) {
  const auto one = forces_with(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(one, forces_with(threads)) << threads;
}

TEST(ContactRebuild, ChangesNoBitInTwoDimensions) { check_all<2>(); }
TEST(ContactRebuild, ChangesNoBitInThreeDimensions) { check_all<3>(); }
TEST(ContactRebuild, ListsAreCheckedAfterTheMotion) {
  check_jumps<2>();
  check_jumps<3>();
}

}  // namespace
}  // namespace brunt
