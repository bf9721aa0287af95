/// Bodies of all kinds of elements, of particles and of materials stand in one scene, are squeezed,
/// and go on from a checkpoint: what each carries is found again, whatever the others carry.
/// (Blocks of one-point elements with viscous hourglass control and with stiffness, and tetrahedra,
/// once wrote rows of different lengths into one table, which no run could read.)
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/simulate.hpp"

namespace brunt {
namespace {
using namespace test;

constexpr const char* kMaterials = R"(
  metal:
    density: 7850 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    strength: {j2: {yield: 50 MPa, hardening: 1 GPa}}
  cap: {density: 2440 kg/m^3, strength: {concrete-cap: {fc: 45.4 MPa}}}
  crushed:
    density: 2440 kg/m^3
    strength:
      hjc: {fc: 119 MPa, G: 24.17 GPa, A: 0.29, B: 2.06, N: 0.866, C: 0.0013, S_max: 5,
            T: 8.2 MPa, D1: 0.04, D2: 1, ef_min: 0.01, p_crush: 40 MPa, mu_crush: 0.00124,
            p_lock: 1200 MPa, mu_lock: 0.011, locking: permanent, K1: 12.87 GPa,
            K2: 16.31 GPa, K3: 64.95 GPa}
  elastic: {density: 2000 kg/m^3, elastic: {E: 20 GPa, nu: 0.2}}
)";

/// Blocks of 4 mm in a row, 6 mm apart, which are squeezed along x.
std::string blocks(const std::vector<std::string>& kinds) {
  std::string text =
      "title: many kinds\ngeometry: 3d\nparameters: {v: 20 m/s, side: 4 mm, apart: 6 mm}\n"
      "time: {end: 3 us}\nmaterials:" +
      std::string(kMaterials) + "bodies:\n";
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const std::string from = std::to_string(k) + " * $apart";
    text += "  b" + std::to_string(k) + ": {" + kinds[k] + ", shape: {box: {min: [\"= " + from +
            "\", 0, 0], max: [\"= " + from + " + $side\", $side, $side]}}, size: 1 mm, " +
            "velocity: [\"= -$v * (x - " + from + ") / $side\", 0, 0]}\n";
  }
  return text + "output: {every: 1 ms, history: 0.2 us, state_hash: true}\n";
}

void expect_same_after_a_split(const std::vector<std::string>& kinds) {
  const std::string deck = blocks(kinds);
  const auto whole = simulate_text(deck);
  ASSERT_EQ(whole.failure, "");
  EXPECT_GT(whole.column("energy.internal").back(), 0);
  EXPECT_EQ(simulate_text(deck, {}, {.split_at = 7}).hashes, whole.hashes);
}

TEST(MixedState, ElementsOfAllKindsAreFoundAgain) {
  std::vector<std::string> kinds;
  for (const char* material : {"metal", "cap", "crushed", "elastic"}) {
    for (const char* element : {"{integration: one-point, hourglass: {viscous: 0.1}}",
                                "{integration: one-point, hourglass: {stiffness: 0.05}}",
                                "{integration: q1p0}", "{integration: full}", "{type: tet4}"}) {
      kinds.push_back("material: " + std::string(material) + ", element: " + element);
    }
  }
  expect_same_after_a_split(kinds);
}

TEST(MixedState, ParticlesOfAllMaterialsAreFoundAgain) {
  std::vector<std::string> kinds;
  for (const char* material : {"metal", "cap", "crushed", "elastic"}) {
    kinds.push_back("method: sph, material: " + std::string(material));
  }
  expect_same_after_a_split(kinds);
}

}  // namespace
}  // namespace brunt
