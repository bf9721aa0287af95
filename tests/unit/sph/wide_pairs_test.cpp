// Eight pairs at a time have the bits of four: terms are those of each pair, and sums have four
// lanes in any case. Particles thrown at random, neighbours of one of them: what is selected and
// every sum over it agree bit for bit, of rows from none to several stretches long, of all kernels,
// where all, some or none are in tension.
#include <gtest/gtest.h>

#include <bit>
#include <numeric>
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

/// A row as NeighbourRows pads it.
struct Selected {
  std::vector<LocalIndex> row;
  int count = 0;
  bool operator==(const Selected&) const = default;
};

template <int Dim, class P>
Selected selected(const Cloud<Dim>& cloud, LocalIndex i,
                  const std::vector<LocalIndex>& candidates) {
  Selected found{std::vector<LocalIndex>(candidates.size() + 16), 0};
  const auto n = static_cast<int>(candidates.size());
  found.count =
      select_neighbours<Dim, P>(cloud.motion.data(), i, candidates.data(), n, found.row.data());
  found.row.resize(slot_of((found.count + 7) / 8 * 8));
  std::fill(found.row.begin() + found.count, found.row.end(), i);
  return found;
}

/// All particles but i.
std::vector<LocalIndex> all_but(LocalIndex i, std::size_t n) {
  std::vector<LocalIndex> others;
  for (LocalIndex j = 0; slot_of(j) < n; ++j) {
    if (j != i) others.push_back(j);
  }
  return others;
}

/// Eight that share all particles as candidates have the rows that each has alone.
template <class P>
void expect_rows_of_group(const Cloud<3>& cloud, const ParticleGroup& group) {
  const std::size_t n = cloud.motion.size();
  std::vector<LocalIndex> candidates(n + kByte);
  std::iota(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(n), 0);
  std::vector<std::uint64_t> words((n + kByte - 1) / kByte);
  select_neighbours_of<3, P>(cloud.motion.data(), group, candidates.data(), static_cast<int>(n),
                             words.data());
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(words.data());
  for (std::size_t m = 0; m < group.size(); ++m) {
    const Selected alone = selected<3, DoublePairs>(cloud, group[m], all_but(group[m], n));
    std::vector<LocalIndex> row(n + 24);
    const int count = expand_bits<P>(candidates.data(), static_cast<int>(n), bytes + m, row.data());
    ASSERT_EQ(count, alone.count);
    EXPECT_TRUE(std::equal(row.begin(), row.begin() + count, alone.row.begin()));
  }
}

template <class Sums>
std::vector<std::uint64_t> bits_of_sums(const Sums& sums) {
  std::vector<std::uint64_t> bits(sizeof(Sums) / sizeof(std::uint64_t));
  std::memcpy(bits.data(), &sums, sizeof(Sums));
  return bits;
}

template <int Dim, class Kernel>
void expect_bits_of_four(const Cloud<Dim>& cloud, const std::vector<LocalIndex>& candidates) {
  const Selected four = selected<Dim, DoublePairs>(cloud, 0, candidates);
  if constexpr (Dim == 2) {
    ASSERT_EQ(four, (selected<2, WidePairs>(cloud, 0, candidates)));
  }
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
      const auto candidates = all_but(0, n);
      expect_bits_of_four<Dim, CubicKernel>(cloud, candidates);
      expect_bits_of_four<Dim, QuadraticKernel>(cloud, candidates);
      expect_bits_of_four<Dim, HyperbolicKernel>(cloud, candidates);
      expect_bits_of_four<Dim, WendlandC2Kernel>(cloud, candidates);
      expect_bits_of_four<Dim, WendlandC4Kernel>(cloud, candidates);
    }
  }
}

TEST(WidePairs, GroupsFindWhatEachFindsAlone) {
  std::mt19937 random(11);
  for (const std::size_t n : {1, 2, 7, 8, 9, 16, 17, 60, 300, 900}) {
    const Cloud<3> cloud(n, 5e-4, 0, random);
    ParticleGroup group;
    for (auto& one : group) one = static_cast<LocalIndex>(random() % n);
    expect_rows_of_group<DoublePairs>(cloud, group);
    if (can_run_wide()) expect_rows_of_group<WidePairs>(cloud, group);
  }
}

// Two at one place are neighbours of each other, and none of itself.
TEST(WidePairs, ParticlesAtOnePlaceAreNeighbours) {
  std::mt19937 random(3);
  Cloud<3> cloud(9, 5e-4, 0, random);
  cloud.motion[4] = cloud.motion[0];
  expect_rows_of_group<DoublePairs>(cloud, {0, 1, 2, 3, 4, 5, 6, 7});
  const Selected row = selected<3, DoublePairs>(cloud, 0, all_but(0, 9));
  EXPECT_EQ(std::count(row.row.begin(), row.row.begin() + row.count, 4), 1);
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
  const Selected found = selected<3, DoublePairs>(cloud, 0, all_but(0, 200));
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
