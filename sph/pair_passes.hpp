#pragma once
/// The passes over the neighbours of a particle, by the width of their arithmetic: of eight doubles
/// a source of their own has them (wide_pairs.cpp), all else is written out where it is called.
#include "sph/conduction.hpp"
#include "sph/force_sums.hpp"
#include "sph/gradient_sums.hpp"
#include "sph/row_selection.hpp"

namespace brunt {

/// As select_row, select_group, expand_row, sum_gradients, sum_forces and sum_heat with P =
/// RealPairs<V>; instantiated for Wide, to be called where wide_lanes() says so.
template <int Dim, class V>
int select_row_by(const MotionRecord<Dim>* records, LocalIndex i, const LocalIndex* candidate,
                  int n, LocalIndex* out);
template <int Dim, class V>
void select_group_by(const MotionRecord<Dim>* records, const ParticleGroup& group,
                     const LocalIndex* candidate, int n, std::uint64_t* word);
template <class V>
int expand_row_by(const LocalIndex* candidate, int n, const std::uint8_t* byte, LocalIndex* out);
template <int Dim, class Kernel, class V>
GradientSums<Dim> sum_gradients_by(const MotionRecord<Dim>* motion, LocalIndex i,
                                   std::span<const LocalIndex> row, Real* weights);
template <int Dim, class Kernel, class V>
ForceSums<Dim> sum_forces_by(const ForceRecords<Dim>& records, LocalIndex i,
                             std::span<const LocalIndex> row, const Real* weights,
                             const SphPairOptions& options);
template <int Dim, class Kernel, class V>
PairHeat sum_heat_by(const HeatRecords<Dim>& records, LocalIndex i, std::span<const LocalIndex> row,
                     const Real* weights);

/// select_row, wherever it is.
template <int Dim, class P>
BRUNT_INLINE int select_neighbours(const MotionRecord<Dim, typename P::Stored>* records,
                                   LocalIndex i, const LocalIndex* candidate, int n,
                                   LocalIndex* out) {
  if constexpr (std::is_same_v<P, WidePairs>) {
    return select_row_by<Dim, Wide>(records, i, candidate, n, out);
  } else {
    return select_row<Dim, P>(records, i, candidate, n, out);
  }
}

/// select_group, wherever it is.
template <int Dim, class P>
BRUNT_INLINE void select_neighbours_of(const MotionRecord<Dim, typename P::Stored>* records,
                                       const ParticleGroup& group, const LocalIndex* candidate,
                                       int n, std::uint64_t* word) {
  if constexpr (std::is_same_v<P, WidePairs>) {
    select_group_by<Dim, Wide>(records, group, candidate, n, word);
  } else {
    select_group<Dim, P>(records, group, candidate, n, word);
  }
}

/// expand_row, wherever it is.
template <class P>
BRUNT_INLINE int expand_bits(const LocalIndex* candidate, int n, const std::uint8_t* byte,
                             LocalIndex* out) {
  if constexpr (std::is_same_v<P, WidePairs>) {
    return expand_row_by<Wide>(candidate, n, byte, out);
  } else {
    return expand_row<P>(candidate, n, byte, out);
  }
}

/// sum_gradients, wherever it is.
template <int Dim, class Kernel, class P>
BRUNT_INLINE GradientSums<Dim> gradients_over(const MotionRecord<Dim, typename P::Stored>* motion,
                                              LocalIndex i, std::span<const LocalIndex> row,
                                              Real inverse_length, Real* weights) {
  if constexpr (std::is_same_v<P, WidePairs>) {
    return sum_gradients_by<Dim, Kernel, Wide>(motion, i, row, weights);
  } else {
    return sum_gradients<Dim, Kernel, P>(motion, i, row, inverse_length, weights);
  }
}

/// sum_forces, wherever it is.
template <int Dim, class Kernel, class P>
BRUNT_INLINE ForceSums<Dim> forces_over(const ForceRecords<Dim, P>& records, LocalIndex i,
                                        std::span<const LocalIndex> row, const Real* weights,
                                        const SphPairOptions& options) {
  if constexpr (std::is_same_v<P, WidePairs>) {
    const ForceRecords<Dim> same{records.motion, records.stress, records.artificial};
    return sum_forces_by<Dim, Kernel, Wide>(same, i, row, weights, options);
  } else {
    return sum_forces<Dim, Kernel>(records, i, row, weights, options);
  }
}

/// sum_heat, wherever it is.
template <int Dim, class Kernel, class P>
BRUNT_INLINE PairHeat heat_over(const HeatRecords<Dim>& records, LocalIndex i,
                                std::span<const LocalIndex> row, const Real* weights) {
  if constexpr (std::is_same_v<P, WidePairs>) {
    return sum_heat_by<Dim, Kernel, Wide>(records, i, row, weights);
  } else {
    return sum_heat<Dim, Kernel, P>(records, i, row, weights);
  }
}

}  // namespace brunt
// Tested by tests/unit/sph/wide_pairs_test.cpp.
