#pragma once
/// Four or eight doubles side by side, on GNU vector types alone: the same bits on every
/// instruction set, because each lane is one IEEE operation and nothing is contracted. Kernels are
/// written once on a scalar V: Real, Pack or Wide. A lane never looks at another lane: what a group
/// does may not change the bits of one.
#include <array>
#include <cmath>
#include <cstring>

#include "core/types.hpp"

#ifdef BRUNT_WIDE
#include <immintrin.h>
#endif

// Clang has fused instructions wherever it has AVX-512; it uses none without being asked.
#if !defined(BRUNT_WIDE) || !defined(__clang__)
#if defined(__FMA__) || defined(__FMA4__) || (defined(__AVX512F__) && !defined(BRUNT_WIDE))
#error "fused instructions change bits: see CMakeLists.txt and docs/decisions/122-fused-turns.md"
#endif
#endif

namespace brunt {

inline constexpr int kLanes = 4;
using Pack = Real __attribute__((vector_size(32)));
/// Of kernels that have a version for processors with AVX-512 (core/wide_lanes.hpp); elsewhere it
/// is two Packs.
using Wide = Real __attribute__((vector_size(64)));
/// What comparing two V gives: bool, or 0 or -1 in each lane.
template <class V>
using MaskOf = decltype(V{} < V{});
using PackMask = MaskOf<Pack>;
using WideMask = MaskOf<Wide>;

#define BRUNT_INLINE inline __attribute__((always_inline))

template <class V>
inline constexpr int lanes_of = sizeof(V) / sizeof(Real);

template <class V>
BRUNT_INLINE V broadcast(Real s) {
  if constexpr (lanes_of<V> == 1) {
    return s;
  } else {
    return s - V{};
  }
}
BRUNT_INLINE Pack load(const Real* p) {
  Pack r;
  std::memcpy(&r, p, sizeof r);
  return r;
}
BRUNT_INLINE void store(Real* p, Pack v) { std::memcpy(p, &v, sizeof v); }

template <class V>
BRUNT_INLINE V load_as(const Real* p) {
  V r;
  std::memcpy(&r, p, sizeof r);
  return r;
}
BRUNT_INLINE void store(Real* p, Real v) { *p = v; }
BRUNT_INLINE void store(Real* p, Wide v) { std::memcpy(p, &v, sizeof v); }

BRUNT_INLINE Pack low_half(Wide a) { return __builtin_shufflevector(a, a, 0, 1, 2, 3); }
BRUNT_INLINE Pack high_half(Wide a) { return __builtin_shufflevector(a, a, 4, 5, 6, 7); }
BRUNT_INLINE Wide joined_wide(Pack low, Pack high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

BRUNT_INLINE Real select(bool m, Real a, Real b) { return m ? a : b; }
BRUNT_INLINE Pack select(PackMask m, Pack a, Pack b) { return m ? a : b; }
BRUNT_INLINE Wide select(WideMask m, Wide a, Wide b) { return m ? a : b; }
BRUNT_INLINE bool any(bool m) { return m; }
BRUNT_INLINE bool any(WideMask m) {
#ifdef BRUNT_WIDE
  return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m)) != 0;
#else
  return (m[0] | m[1] | m[2] | m[3] | m[4] | m[5] | m[6] | m[7]) != 0;
#endif
}
BRUNT_INLINE bool any(PackMask m) {
#ifdef __AVX__
  return __builtin_ia32_movmskpd256(reinterpret_cast<Pack>(m)) !=
         0;  // one instruction; same answer
#else
  return (m[0] | m[1] | m[2] | m[3]) != 0;
#endif
}
/// One bit a lane.
BRUNT_INLINE unsigned mask_bits(PackMask m) {
#ifdef __AVX__
  return static_cast<unsigned>(__builtin_ia32_movmskpd256(reinterpret_cast<Pack>(m)));
#else
  return static_cast<unsigned>((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
#endif
}
BRUNT_INLINE unsigned mask_bits(WideMask m) {
#ifdef BRUNT_WIDE
  return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m));
#else
  unsigned bits = 0;
  for (int lane = 0; lane < 2 * kLanes; ++lane) bits |= (m[lane] != 0 ? 1U : 0U) << lane;
  return bits;
#endif
}
/// to[k] = from[lane[k]] for four indices; `to` may overlap nothing.
BRUNT_INLINE void store_permuted(LocalIndex* to, const LocalIndex* from, const std::int32_t* lane) {
#ifdef __AVX__
  using Four = float __attribute__((vector_size(16)));
  using Lanes = std::int32_t __attribute__((vector_size(16)));
  Four indices;
  Lanes lanes;
  std::memcpy(&indices, from, sizeof indices);
  std::memcpy(&lanes, lane, sizeof lanes);
  indices = __builtin_ia32_vpermilvarps(indices, lanes);  // moves bits; they are no numbers here
  std::memcpy(to, &indices, sizeof indices);
#else
  for (int k = 0; k < kLanes; ++k) to[k] = from[lane[k]];
#endif
}
BRUNT_INLINE bool lane_of(bool m, int) { return m; }
BRUNT_INLINE bool lane_of(PackMask m, int lane) { return m[lane] != 0; }
BRUNT_INLINE bool lane_of(WideMask m, int lane) { return m[lane] != 0; }
BRUNT_INLINE Real lane_of(Real a, int) { return a; }
BRUNT_INLINE Real lane_of(Pack a, int lane) { return a[lane]; }
BRUNT_INLINE Real lane_of(Wide a, int lane) { return a[lane]; }
BRUNT_INLINE void set_lane(Real& a, int, Real value) { a = value; }
BRUNT_INLINE void set_lane(Pack& a, int lane, Real value) { a[lane] = value; }
BRUNT_INLINE void set_lane(Wide& a, int lane, Real value) { a[lane] = value; }
BRUNT_INLINE Real vmin(Real a, Real b) { return a < b ? a : b; }
BRUNT_INLINE Pack vmin(Pack a, Pack b) {
#ifdef __AVX__
  return __builtin_ia32_minpd256(a, b);  // one instruction; the same answer, b if one is no number
#else
  return a < b ? a : b;
#endif
}
BRUNT_INLINE Wide vmin(Wide a, Wide b) {
#ifdef BRUNT_WIDE
  return _mm512_maskz_min_pd(0xff, a, b);
#else
  return a < b ? a : b;
#endif
}
BRUNT_INLINE Real vmax(Real a, Real b) { return a > b ? a : b; }
BRUNT_INLINE Pack vmax(Pack a, Pack b) {
#ifdef __AVX__
  return __builtin_ia32_maxpd256(a, b);
#else
  return a > b ? a : b;
#endif
}
BRUNT_INLINE Wide vmax(Wide a, Wide b) {
#ifdef BRUNT_WIDE
  return _mm512_maskz_max_pd(0xff, a, b);
#else
  return a > b ? a : b;
#endif
}
BRUNT_INLINE Real vabs(Real a) { return std::fabs(a); }
BRUNT_INLINE Pack vabs(Pack a) {
  return reinterpret_cast<Pack>(reinterpret_cast<PackMask>(a) & 0x7fffffffffffffffLL);
}
BRUNT_INLINE Wide vabs(Wide a) {
  return reinterpret_cast<Wide>(reinterpret_cast<WideMask>(a) & 0x7fffffffffffffffLL);
}
BRUNT_INLINE Real vsqrt(Real a) { return std::sqrt(a); }
BRUNT_INLINE Pack vsqrt(Pack a) {
  return Pack{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
BRUNT_INLINE Wide vsqrt(Wide a) {
#ifdef BRUNT_WIDE
  return _mm512_maskz_sqrt_pd(0xff, a);  // all lanes; the plain one warns in GCC 12's own header
#else
  return joined_wide(vsqrt(low_half(a)), vsqrt(high_half(a)));
#endif
}

/// a b + c, rounded once: one instruction where the processor has it (all of x86-64-v3), the same
/// bits where it has not. Products and sums are fused where the source says so, and nowhere else.
BRUNT_INLINE Real vfma(Real a, Real b, Real c) {
#if defined(__AVX2__)
  // By name: compilers are told not to fuse (docs/decisions/225-fused-by-name.md).
  asm("vfmadd231sd %2, %1, %0" : "+x"(c) : "x"(a), "xm"(b));
  return c;
#else
  return std::fma(a, b, c);
#endif
}
BRUNT_INLINE Pack vfma(Pack a, Pack b, Pack c) {
#if defined(__AVX2__)
  asm("vfmadd231pd %2, %1, %0" : "+x"(c) : "x"(a), "xm"(b));
  return c;
#else
  return Pack{std::fma(a[0], b[0], c[0]), std::fma(a[1], b[1], c[1]), std::fma(a[2], b[2], c[2]),
              std::fma(a[3], b[3], c[3])};
#endif
}
BRUNT_INLINE Wide vfma(Wide a, Wide b, Wide c) {
#ifdef BRUNT_WIDE
  return _mm512_fmadd_pd(a, b, c);
#else
  return joined_wide(vfma(low_half(a), low_half(b), low_half(c)),
                     vfma(high_half(a), high_half(b), high_half(c)));
#endif
}
/// c - a b, rounded once.
BRUNT_INLINE Real vfnma(Real a, Real b, Real c) {
#if defined(__AVX2__)
  asm("vfnmadd231sd %2, %1, %0" : "+x"(c) : "x"(a), "xm"(b));
  return c;
#else
  return std::fma(-a, b, c);
#endif
}
BRUNT_INLINE Pack vfnma(Pack a, Pack b, Pack c) {
#if defined(__AVX2__)
  asm("vfnmadd231pd %2, %1, %0" : "+x"(c) : "x"(a), "xm"(b));
  return c;
#else
  return vfma(-a, b, c);
#endif
}
BRUNT_INLINE Wide vfnma(Wide a, Wide b, Wide c) {
#ifdef BRUNT_WIDE
  return _mm512_fnmadd_pd(a, b, c);
#else
  return vfma(-a, b, c);
#endif
}
/// What comes before is done before what comes after, as far as the compiler is concerned: fewer
/// values wait for their use, and sums stay in registers. No value depends on it.
#ifdef BRUNT_WIDE
BRUNT_INLINE void keep_order(Wide& a) { asm volatile("" : "+v"(a) : : "memory"); }
BRUNT_INLINE void keep_order(Wide (&a)[2]) {
  asm volatile("" : "+v"(a[0]), "+v"(a[1]) : : "memory");
}
BRUNT_INLINE void keep_order(Wide (&a)[3]) {
  asm volatile("" : "+v"(a[0]), "+v"(a[1]), "+v"(a[2]) : : "memory");
}
#else
template <class V>
BRUNT_INLINE void keep_order(V&) {}
#endif
/// True where any bit of any lane is set.
BRUNT_INLINE bool any_bit(Wide a) {
#ifdef BRUNT_WIDE
  const auto bits = reinterpret_cast<__m512i>(a);
  return _mm512_test_epi64_mask(bits, bits) != 0;
#else
  return any(reinterpret_cast<WideMask>(a) != 0);
#endif
}
/// at_0 + slope x, rounded once.
template <class V>
BRUNT_INLINE V line_at(V x, Real at_0, Real slope) {
  return vfma(x, broadcast<V>(slope), broadcast<V>(at_0));
}
/// a b - c d: the second product is rounded, the difference once.
template <class V>
BRUNT_INLINE V difference_of_products(V a, V b, V c, V d) {
  return vfma(a, b, -(c * d));
}

}  // namespace brunt
