// Eight pairs at a time have the bits of four: terms are those of each pair, and sums have four
// lanes in any case. Particles thrown at random, neighbours of one of them: what is selected and
// every sum over it agree bit for bit, of rows from none to several stretches long, of all kernels,
// where all, some or none are in tension.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "core/wide_lanes.hpp"
#include "sph/pair_passes.hpp"

namespace brunt {
namespace {

template <int Dim>
struct Cloud {
  std::vector<MotionRecord<Dim>> motion;
  std::vector<StressRecord<Dim>> stress;
  std::vector<ArtificialRecord<Dim>> artificial;
  std::vector<HeatRecord> heat;

  /// tense  [1] the part of particles in tension
  Cloud(std::size_t n, Real h, Real tense, std::mt19937& random) {
    std::uniform_real_distribution<Real> even(-1, 1);
    motion.resize(n), stress.resize(n), artificial.resize(n), heat.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (int d = 0; d < Dim; ++d) {
        motion[i].data[d] = 1e-3 * even(random);
        motion[i].data[MotionRecord<Dim>::kVelocity + d] = 100 * even(random);
      }
      motion[i].data[MotionRecord<Dim>::kInverse] = (1 + 0.2 * even(random)) / h;
      motion[i].data[MotionRecord<Dim>::kVolume] = std::pow(h, Dim) * (1 + 0.5 * even(random));
      heat[i].data[HeatRecord::kTemperature] = 300 + 100 * even(random);
      heat[i].data[HeatRecord::kConductivity] = std::max(0.0, 300 * even(random));
      heat[i].data[HeatRecord::kSupplement] = 1.2 + 0.2 * even(random);
      heat[i].data[HeatRecord::kVolume] = motion[i].data[MotionRecord<Dim>::kVolume];
      const bool pulled = 0.5 * (even(random) + 1) < tense;
      for (int k = 0; k < Dim * Dim; ++k) stress[i].data[k] = 1e9 * even(random);
      stress[i].data[StressRecord<Dim>::kSoundSpeed] = 4e3 + 1e2 * even(random);
      stress[i].data[StressRecord<Dim>::kDensity] = 9e3 + 1e2 * even(random);
      stress[i].data[StressRecord<Dim>::kTension] = pulled ? 1 : 0;
      for (int k = 0; pulled && k < kSymmetric<Dim>; ++k) {
        artificial[i].data[k] = 1e8 * even(random);
      }
    }
  }
  ForceRecords<Dim> records() const { return {motion.data(), stress.data(), artificial.data()}; }
};

/// A row as NeighbourRows pads it, with the bits of its candidates.
struct Selected {
  std::vector<LocalIndex> row;
  std::vector<std::uint8_t> bits;
  int count = 0;
  bool operator==(const Selected&) const = default;
};

template <int Dim, class P>
Selected selected(const Cloud<Dim>& cloud, const std::vector<LocalIndex>& candidates) {
  Selected found{std::vector<LocalIndex>(candidates.size() + 16),
                 std::vector<std::uint8_t>(candidates.size() / 8 + 1), 0};
  const auto n = static_cast<int>(candidates.size());
  const int count = select_neighbours<Dim, P>(cloud.motion.data(), 0, candidates.data(), n,
                                              found.row.data(), found.bits.data());
  found.count = count;
  found.row.resize(slot_of((count + 7) / 8 * 8));
  std::fill(found.row.begin() + count, found.row.end(), 0);
  if (Dim == 3) {
    std::vector<LocalIndex> again(candidates.size() + 16);
    EXPECT_EQ(expand_bits<P>(0, candidates.data(), n, found.bits.data(), again.data()), count);
    EXPECT_TRUE(std::equal(found.row.begin(), found.row.begin() + count, again.begin()));
  }
  return found;
}

template <class Sums>
std::vector<std::uint64_t> bits_of_sums(const Sums& sums) {
  std::vector<std::uint64_t> bits(sizeof(Sums) / sizeof(std::uint64_t));
  std::memcpy(bits.data(), &sums, sizeof(Sums));
  return bits;
}

template <int Dim, class Kernel>
void expect_bits_of_four(const Cloud<Dim>& cloud, const std::vector<LocalIndex>& candidates) {
  const Selected four = selected<Dim, DoublePairs>(cloud, candidates);
  ASSERT_EQ(four, (selected<Dim, WidePairs>(cloud, candidates)));
  const auto row = std::span<const LocalIndex>(four.row);
  std::vector<Real> weights(row.size()), wide_weights(row.size());
  const auto gradients =
      gradients_over<Dim, Kernel, DoublePairs>(cloud.motion.data(), 0, row, 1.0, weights.data());
  const auto wide_gradients =
      gradients_over<Dim, Kernel, WidePairs>(cloud.motion.data(), 0, row, 1.0, wide_weights.data());
  EXPECT_EQ(bits_of_sums(gradients), bits_of_sums(wide_gradients));
  EXPECT_EQ(weights, wide_weights);
  const HeatRecords<Dim> heat{cloud.heat.data(), cloud.motion.data()};
  const auto of_four = row.first(slot_of((four.count + 3) / 4 * 4));  // as NeighbourRows hands out
  EXPECT_EQ(bits_of_sums(heat_over<Dim, Kernel, DoublePairs>(heat, 0, of_four, weights.data())),
            bits_of_sums(heat_over<Dim, Kernel, WidePairs>(heat, 0, row, weights.data())));
  const SphPairOptions options{0.5, 1.0, 1.3};
  const auto records = cloud.records();
  const ForceRecords<Dim, WidePairs> wide{records.motion, records.stress, records.artificial};
  const auto forces = forces_over<Dim, Kernel>(records, 0, row, weights.data(), options);
  const auto wide_forces = forces_over<Dim, Kernel>(wide, 0, row, weights.data(), options);
  EXPECT_EQ(bits_of_sums(forces), bits_of_sums(wide_forces));
}

template <int Dim>
void expect_bits_of_four() {
  std::mt19937 random(4711);
  for (const std::size_t n : {1, 2, 5, 9, 17, 60, 150, 300, 900}) {
    for (const Real tense : {0.0, 0.1, 1.0}) {
      const Cloud<Dim> cloud(n, 5e-4, tense, random);
      std::vector<LocalIndex> candidates;
      for (std::size_t j = 1; j < n; ++j) candidates.push_back(static_cast<LocalIndex>(j));
      expect_bits_of_four<Dim, CubicKernel>(cloud, candidates);
      expect_bits_of_four<Dim, QuadraticKernel>(cloud, candidates);
      expect_bits_of_four<Dim, HyperbolicKernel>(cloud, candidates);
      expect_bits_of_four<Dim, WendlandC2Kernel>(cloud, candidates);
      expect_bits_of_four<Dim, WendlandC4Kernel>(cloud, candidates);
    }
  }
}

TEST(WidePairs, SumsInThePlaneHaveTheBitsOfFour) {
  if (!can_run_wide()) GTEST_SKIP() << "no AVX-512 here";
  expect_bits_of_four<2>();
}
TEST(WidePairs, SumsInSpaceHaveTheBitsOfFour) {
  if (!can_run_wide()) GTEST_SKIP() << "no AVX-512 here";
  expect_bits_of_four<3>();
}

// A row of one particle too many would be seen: the sums of eight are not those of nothing.
TEST(WidePairs, SumsAreNotEmpty) {
  if (!can_run_wide()) GTEST_SKIP() << "no AVX-512 here";
  std::mt19937 random(7);
  const Cloud<3> cloud(200, 5e-4, 1.0, random);
  std::vector<LocalIndex> candidates(199);
  for (std::size_t j = 0; j < 199; ++j) candidates[j] = static_cast<LocalIndex>(j + 1);
  const Selected found = selected<3, WidePairs>(cloud, candidates);
  EXPECT_GT(found.row.size(), 20U);
  const auto records = cloud.records();
  const ForceRecords<3, WidePairs> wide{records.motion, records.stress, records.artificial};
  const auto sums = forces_over<3, CubicKernel>(wide, 0, found.row, nullptr, SphPairOptions{});
  EXPECT_GT(sums.speed, 0);
  EXPECT_NE(sums.artificial[0], 0);
  EXPECT_NE(sums.stress[0], 0);
}

}  // namespace
}  // namespace brunt
