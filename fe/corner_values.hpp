#pragma once
/// Moves nodal values into kernels and corner forces out of them, four or eight elements at a time.
#include "core/simd.hpp"
#include "fe/force_chunks.hpp"

namespace brunt {

/// Two values side by side.
using HalfPack = Real __attribute__((vector_size(16)));
BRUNT_INLINE HalfPack load_half(const Real* p) {
  HalfPack r;
  std::memcpy(&r, p, sizeof r);
  return r;
}

/// Values of a nodal field at the corners of four elements.
template <int Dim, int N>
BRUNT_INLINE void gather(const LocalIndex* corner, const Vec<Dim>* field, Pack (&node)[N][Dim]) {
  constexpr int n = N;
  for (int I = 0; I < n; ++I) {
    const Real* a = field[corner[I]].data();
    const Real* b = field[corner[n + I]].data();
    const Real* c = field[corner[2 * n + I]].data();
    const Real* d = field[corner[3 * n + I]].data();
    const Pack ac = __builtin_shufflevector(load_half(a), load_half(c), 0, 1, 2, 3);
    const Pack bd = __builtin_shufflevector(load_half(b), load_half(d), 0, 1, 2, 3);
    node[I][0] = __builtin_shufflevector(ac, bd, 0, 4, 2, 6);
    node[I][1] = __builtin_shufflevector(ac, bd, 1, 5, 3, 7);
    if constexpr (Dim == 3) node[I][2] = Pack{a[2], b[2], c[2], d[2]};
  }
}

/// Mechanical heat of lanes_of<V> elements, which their corners share.
template <class V>
struct SharedHeat {
  static constexpr Real kNone[kMostCorners * kGroup] = {};

  V rate{};                   ///< [W] of each element
  const Real* share = kNone;  ///< [1] of corner 0; that of the next stands kGroup further on
};

/// Adds forces and heat of the corners of four elements from e on to rows of nodes, element by
/// element.
template <int N, int Dim>
BRUNT_INLINE void add_to_nodes(const Pack (&node)[N][Dim], const SharedHeat<Pack>& heat,
                               std::size_t e, const CornerSums& sums) {
  const std::uint16_t* place = sums.place + (e - sums.first) * N;
  Pack row[kLanes][N];
  for (int I = 0; I < N; ++I) {
    const Pack h = heat.rate * load(heat.share + I * kGroup);
    const Pack z = Dim == 3 ? node[I][Dim - 1] : Pack{};
    const Pack xy02 = __builtin_shufflevector(node[I][0], node[I][1], 0, 4, 2, 6);
    const Pack xy13 = __builtin_shufflevector(node[I][0], node[I][1], 1, 5, 3, 7);
    const Pack zh02 = __builtin_shufflevector(z, h, 0, 4, 2, 6);
    const Pack zh13 = __builtin_shufflevector(z, h, 1, 5, 3, 7);
    row[0][I] = __builtin_shufflevector(xy02, zh02, 0, 1, 4, 5);
    row[1][I] = __builtin_shufflevector(xy13, zh13, 0, 1, 4, 5);
    row[2][I] = __builtin_shufflevector(xy02, zh02, 2, 3, 6, 7);
    row[3][I] = __builtin_shufflevector(xy13, zh13, 2, 3, 6, 7);
  }
  for (int lane = 0; lane < kLanes; ++lane) {
    for (int I = 0; I < N; ++I) {
      Real* to = sums.row + place[lane * N + I];
      store(to, load(to) + row[lane][I]);
    }
  }
}

#ifdef BRUNT_WIDE
/// Two rows of three values, with a 0 behind each. Nothing beside the rows is read.
BRUNT_INLINE Wide load_two_rows(const Real* low, const Real* high) {
  const __m512d first = _mm512_maskz_loadu_pd(0x07, low);
  return _mm512_mask_loadu_pd(first, 0x70, high - kLanes);
}
/// `gather` of eight elements: rows of two of them at once, such that what is interleaved comes out
/// in the order of elements.
template <int N>
BRUNT_INLINE void gather_rows(const LocalIndex* corner, const Vec<3>* field, Wide (&node)[N][3]) {
  for (int I = 0; I < N; ++I) {
    Wide two[kLanes];  // elements 0 and 2, 1 and 3, 4 and 6, 5 and 7
    for (int k = 0; k < kLanes; ++k) {
      const int low = k < 2 ? k : k + 2, high = low + 2;
      two[k] = load_two_rows(field[corner[low * N + I]].data(), field[corner[high * N + I]].data());
    }
    const Wide xz_low = __builtin_shufflevector(two[0], two[1], 0, 8, 2, 10, 4, 12, 6, 14);
    const Wide xz_high = __builtin_shufflevector(two[2], two[3], 0, 8, 2, 10, 4, 12, 6, 14);
    const Wide y_low = __builtin_shufflevector(two[0], two[1], 1, 9, 3, 11, 5, 13, 7, 15);
    const Wide y_high = __builtin_shufflevector(two[2], two[3], 1, 9, 3, 11, 5, 13, 7, 15);
    node[I][0] = __builtin_shufflevector(xz_low, xz_high, 0, 1, 4, 5, 8, 9, 12, 13);
    node[I][1] = __builtin_shufflevector(y_low, y_high, 0, 1, 4, 5, 8, 9, 12, 13);
    node[I][2] = __builtin_shufflevector(xz_low, xz_high, 2, 3, 6, 7, 10, 11, 14, 15);
  }
}
#endif

/// The same of eight elements.
template <int Dim, int N>
BRUNT_INLINE void gather(const LocalIndex* corner, const Vec<Dim>* field, Wide (&node)[N][Dim]) {
#ifdef BRUNT_WIDE
  if constexpr (Dim == 3) return gather_rows<N>(corner, field, node);
#endif
  Pack low[N][Dim], high[N][Dim];
  gather(corner, field, low);
  gather(corner + kLanes * N, field, high);
  for (int I = 0; I < N; ++I) {
    for (int i = 0; i < Dim; ++i) node[I][i] = joined_wide(low[I][i], high[I][i]);
  }
}
template <int N, int Dim>
BRUNT_INLINE void add_to_nodes(const Wide (&node)[N][Dim], const SharedHeat<Wide>& heat,
                               std::size_t e, const CornerSums& sums) {
  const std::uint16_t* place = sums.place + (e - sums.first) * N;
  Pack row[2 * kLanes][N];
  for (int I = 0; I < N; ++I) {
    const Wide h = heat.rate * load_as<Wide>(heat.share + I * kGroup);
    const Wide x = node[I][0], y = node[I][1], z = Dim == 3 ? node[I][Dim - 1] : Wide{};
    const Wide xy_even = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
    const Wide xy_odd = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
    const Wide zh_even = __builtin_shufflevector(z, h, 0, 8, 2, 10, 4, 12, 6, 14);
    const Wide zh_odd = __builtin_shufflevector(z, h, 1, 9, 3, 11, 5, 13, 7, 15);
    const Wide two[kLanes] = {__builtin_shufflevector(xy_even, zh_even, 0, 1, 8, 9, 4, 5, 12, 13),
                              __builtin_shufflevector(xy_odd, zh_odd, 0, 1, 8, 9, 4, 5, 12, 13),
                              __builtin_shufflevector(xy_even, zh_even, 2, 3, 10, 11, 6, 7, 14, 15),
                              __builtin_shufflevector(xy_odd, zh_odd, 2, 3, 10, 11, 6, 7, 14, 15)};
    for (int lane = 0; lane < kLanes; ++lane) {
      row[lane][I] = low_half(two[lane]), row[kLanes + lane][I] = high_half(two[lane]);
    }
  }
  for (int lane = 0; lane < 2 * kLanes; ++lane) {
    for (int I = 0; I < N; ++I) {
      Real* to = sums.row + place[lane * N + I];
      store(to, load(to) + row[lane][I]);
    }
  }
}

}  // namespace brunt
// Tested by tests/unit/fe/wide_lanes_test.cpp.
