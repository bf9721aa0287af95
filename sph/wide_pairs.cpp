/// Compiled for AVX-512 (sph/CMakeLists.txt): nothing here may be out of line but what has Wide in
/// its name.
#include "sph/pair_passes.hpp"

namespace brunt {

template <int Dim, class V>
int select_row_by(const MotionRecord<Dim>* records, LocalIndex i, const LocalIndex* candidate,
                  int n, LocalIndex* out) {
  return select_row<Dim, RealPairs<V>>(records, i, candidate, n, out);
}

template <int Dim, class V>
void select_group_by(const MotionRecord<Dim>* records, const ParticleGroup& group,
                     const LocalIndex* candidate, int n, std::uint64_t* word) {
  select_group<Dim, RealPairs<V>>(records, group, candidate, n, word);
}

template <class V>
int expand_row_by(const LocalIndex* candidate, int n, const std::uint8_t* byte, LocalIndex* out) {
  return expand_row<RealPairs<V>>(candidate, n, byte, out);
}

template <int Dim, class Kernel, class V>
GradientSums<Dim> sum_gradients_by(const MotionRecord<Dim>* motion, LocalIndex i,
                                   std::span<const LocalIndex> row, Real* weights) {
  return sum_gradients<Dim, Kernel, RealPairs<V>>(motion, i, row, 1.0, weights);
}

template <int Dim, class Kernel, class V>
ForceSums<Dim> sum_forces_by(const ForceRecords<Dim>& records, LocalIndex i,
                             std::span<const LocalIndex> row, const Real* weights,
                             const SphPairOptions& options) {
  const ForceRecords<Dim, RealPairs<V>> wide{records.motion, records.stress, records.artificial};
  return sum_forces<Dim, Kernel>(wide, i, row, weights, options);
}

template <int Dim, class Kernel, class V>
PairHeat sum_heat_by(const HeatRecords<Dim>& records, LocalIndex i, std::span<const LocalIndex> row,
                     const Real* weights) {
  return sum_heat<Dim, Kernel, RealPairs<V>>(records, i, row, weights);
}

template int expand_row_by<Wide>(const LocalIndex*, int, const std::uint8_t*, LocalIndex*);
template int select_row_by<2, Wide>(const MotionRecord<2>*, LocalIndex, const LocalIndex*, int,
                                    LocalIndex*);
template void select_group_by<3, Wide>(const MotionRecord<3>*, const ParticleGroup&,
                                       const LocalIndex*, int, std::uint64_t*);

#define BRUNT_PASSES(Dim, Kernel)                                                                \
  template GradientSums<Dim> sum_gradients_by<Dim, Kernel, Wide>(                                \
      const MotionRecord<Dim>*, LocalIndex, std::span<const LocalIndex>, Real*);                 \
  template ForceSums<Dim> sum_forces_by<Dim, Kernel, Wide>(const ForceRecords<Dim>&, LocalIndex, \
                                                           std::span<const LocalIndex>,          \
                                                           const Real*, const SphPairOptions&);  \
  template PairHeat sum_heat_by<Dim, Kernel, Wide>(const HeatRecords<Dim>&, LocalIndex,          \
                                                   std::span<const LocalIndex>, const Real*);
BRUNT_PASSES(2, CubicKernel)
BRUNT_PASSES(3, CubicKernel)
BRUNT_PASSES(2, QuadraticKernel)
BRUNT_PASSES(3, QuadraticKernel)
BRUNT_PASSES(2, HyperbolicKernel)
BRUNT_PASSES(3, HyperbolicKernel)
BRUNT_PASSES(2, WendlandC2Kernel)
BRUNT_PASSES(3, WendlandC2Kernel)
BRUNT_PASSES(2, WendlandC4Kernel)
BRUNT_PASSES(3, WendlandC4Kernel)
#undef BRUNT_PASSES

}  // namespace brunt
// Tested by tests/unit/sph/wide_pairs_test.cpp.
