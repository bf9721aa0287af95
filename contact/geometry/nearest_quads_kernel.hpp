#pragma once
/// The kernel of nearest_on_quads.
#include <bit>
#include <cmath>

#include "contact/geometry/named_feature.hpp"
#include "contact/geometry/nearest_quads.hpp"
#include "contact/geometry/nearest_triangle.hpp"

namespace brunt {

namespace detail {

/// One Pack, or one in each half.
template <class V>
BRUNT_INLINE V halves(Pack low, Pack high) {
  if constexpr (lanes_of<V> == kLanes) {
    return low;
  } else {
#ifdef BRUNT_WIDE
    return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);  // compilers make more of it
#else
    return joined_wide(low, high);
#endif
  }
}
template <class V>
BRUNT_INLINE V broadcast_halves(Real low, Real high) {
#ifdef BRUNT_WIDE
  if constexpr (lanes_of < V >> kLanes) {
    return _mm512_mask_broadcastsd_pd(_mm512_set1_pd(low), 0xf0, _mm_set_sd(high));
  }
#endif
  return halves<V>(broadcast<Pack>(low), broadcast<Pack>(high));
}

BRUNT_INLINE unsigned equal_bits(Pack a, Pack b) { return mask_bits(a == b); }
BRUNT_INLINE unsigned equal_bits(Wide a, Wide b) {
#ifdef BRUNT_WIDE
  return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ);
#else
  return mask_bits(a == b);
#endif
}

/// The corners of a quad from their twelve numbers in a row.
BRUNT_INLINE Place<Pack> from_rows(Pack a, Pack b, Pack c) {
  const Pack x = __builtin_shufflevector(a, b, 0, 3, 6, 6);
  const Pack y = __builtin_shufflevector(a, b, 1, 4, 7, 7);
  const Pack z = __builtin_shufflevector(a, b, 2, 5, 5, 5);
  return {__builtin_shufflevector(x, c, 0, 1, 2, 5), __builtin_shufflevector(y, c, 0, 1, 2, 6),
          __builtin_shufflevector(z, c, 0, 1, 4, 7)};
}
BRUNT_INLINE Place<Wide> from_rows(Wide a, Wide b, Wide c) {
  const Wide x = __builtin_shufflevector(a, b, 0, 3, 10, 10, 4, 7, 14, 14);
  const Wide y = __builtin_shufflevector(a, b, 1, 8, 11, 11, 5, 12, 15, 15);
  const Wide z = __builtin_shufflevector(a, b, 2, 9, 9, 9, 6, 13, 13, 13);
  return {__builtin_shufflevector(x, c, 0, 1, 2, 9, 4, 5, 6, 13),
          __builtin_shufflevector(y, c, 0, 1, 2, 10, 4, 5, 6, 14),
          __builtin_shufflevector(z, c, 0, 1, 8, 11, 4, 5, 12, 15)};
}

/// Each smallest of four lanes, in all of them; a number that is none is not smaller than any.
BRUNT_INLINE Pack least_of_four(Pack v) {
  v = vmin(v, Pack{v[1], v[0], v[3], v[2]});
  return vmin(v, Pack{v[2], v[3], v[0], v[1]});
}
BRUNT_INLINE Wide least_of_four(Wide v) {
  v = vmin(v, __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6));
  return vmin(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
}

/// One lane of a Pack, or one of each half of a Wide.
template <class V>
class Chosen;
template <>
class Chosen<Pack> {
 public:
  using Values = Real;
  explicit Chosen(const int (&lane)[2]) : lane_(lane[0]) {}
  BRUNT_INLINE Real of(Pack v) const { return v[lane_]; }

 private:
  int lane_;
};
template <>
class Chosen<Wide> {
 public:
  using Values = Real __attribute__((vector_size(16)));
#ifdef BRUNT_WIDE
  BRUNT_INLINE explicit Chosen(const int (&lane)[2])
      : lanes_(_mm512_castsi128_si512(_mm_set_epi64x(lane[1] + kLanes, lane[0]))) {}
  BRUNT_INLINE Values of(Wide v) const {
    return _mm512_castpd512_pd128(_mm512_permutexvar_pd(lanes_, v));
  }

 private:
  __m512i lanes_;
#else
  explicit Chosen(const int (&lane)[2]) : lane_{lane[0], lane[1]} {}
  BRUNT_INLINE Values of(Wide v) const { return Values{v[lane_[0]], v[lane_[1] + kLanes]}; }

 private:
  int lane_[2];
#endif
};

/// What was found of one quad, without distance and direction of the normal.
struct FoundOnQuad {
  Real of_center, of_first, of_second;  ///< weights of the triangle
  unsigned zeros;                       ///< a bit for each weight that is 0
  int lane;                             ///< of the triangle
};

BRUNT_INLINE void set_weights(const FoundOnQuad& found, NearestPoint<3>& nearest) {
  const Real of_each = 0.25 * found.of_center;
  Real* weight = nearest.weight.data();
  store(weight, broadcast<Pack>(of_each));
  weight[found.lane] = of_each + found.of_first;
  weight[(found.lane + 1) % kLanes] = of_each + found.of_second;
  const NamedFeature named = kQuadFeatures.of[found.lane][found.zeros];
  nearest.feature = named.feature;
  nearest.smooth = named.smooth;
  int* corner = nearest.corner.data();
  corner[0] = named.first, corner[1] = named.second;
}

/// Of a quad without area: infinitely far.
BRUNT_INLINE void set_nowhere(NearestPoint<3>& nearest) {
  nearest.distance = kInfinity;
  nearest.feature = Feature::face;
  nearest.smooth = false;
  Real *point = nearest.point.data(), *normal = nearest.normal.data();
  for (int c = 0; c < 3; ++c) point[c] = normal[c] = 0;
  store(nearest.weight.data(), broadcast<Pack>(0.0));
  int* corner = nearest.corner.data();
  corner[0] = corner[1] = 0;
}

BRUNT_INLINE Real one_of(Real v, int) { return v; }
BRUNT_INLINE Real one_of(Chosen<Wide>::Values v, int k) { return v[k]; }
BRUNT_INLINE Real root_of(Real v) { return std::sqrt(v); }
BRUNT_INLINE Chosen<Wide>::Values root_of(Chosen<Wide>::Values v) {
  return Chosen<Wide>::Values{std::sqrt(v[0]), std::sqrt(v[1])};
}

/// All that is known of the triangles of one quad, or of two.
template <class V>
struct OfQuads {
  OfTriangles<V> found;
  V square;           // least distance [m^2] of a number
  unsigned least;     // a bit for each lane that has it
  unsigned zeros[3];  // a bit for each lane, of each weight, that is 0
};

template <class V>
BRUNT_INLINE void look_at_triangles(const NearQuery<3>& low, const NearQuery<3>& high,
                                    OfQuads<V>& quads) {
  const Real *of_low = low.face->corner[0].data(), *of_high = high.face->corner[0].data();
  const auto rows = [&](int i) {
    return halves<V>(load(of_low + i * kLanes), load(of_high + i * kLanes));
  };
  const auto all = [](const Vec3& a, const Vec3& b) {
    const Real *p = a.data(), *q = b.data();
    return Place<V>{broadcast_halves<V>(p[0], q[0]), broadcast_halves<V>(p[1], q[1]),
                    broadcast_halves<V>(p[2], q[2])};
  };
  const Place<V> from = from_rows(rows(0), rows(1), rows(2));
  const Place<V> t[3] = {from, next(from), all(low.face->center, high.face->center)};
  quads.found = nearest_on(t, all(low.x, high.x));
  const auto& found = quads.found;
  const V none = broadcast<V>(0.0), infinite = broadcast<V>(kInfinity);
  quads.square = select(found.squared_distance < infinite, found.squared_distance, infinite);
  quads.least = equal_bits(quads.square, least_of_four(quads.square));
  quads.zeros[0] = equal_bits(found.weight.x, none);
  quads.zeros[1] = equal_bits(found.weight.y, none);
  quads.zeros[2] = equal_bits(found.weight.z, none);
}

/// Of the first `n` of these quads.
template <class V>
BRUNT_INLINE void take_nearest(const OfQuads<V>& quads, int n, NearestPoint<3>* nearest) {
  const auto& found = quads.found;
  const unsigned least = quads.least;
  // In each half there is a least one.
  const int lane[2] = {std::countr_zero(least), std::countr_zero((least | 1U << 7) >> kLanes)};
  const Chosen<V> chosen(lane);
  const auto distance = root_of(chosen.of(quads.square)), length = root_of(chosen.of(found.square));
  const auto along = [&](V v) { return chosen.of(v) / length; };
  const auto normal_x = along(found.normal.x), normal_y = along(found.normal.y),
             normal_z = along(found.normal.z);
  const auto x = chosen.of(found.point.x), y = chosen.of(found.point.y),
             z = chosen.of(found.point.z);
  const auto first = chosen.of(found.weight.x), second = chosen.of(found.weight.y),
             center = chosen.of(found.weight.z);
  for (int k = 0; k < lanes_of<V> / kLanes && k < n; ++k) {
    auto& out = nearest[k];
    if (!(one_of(distance, k) < kInfinity)) {
      set_nowhere(out);
      continue;
    }
    const int bit = lane[k] + k * kLanes;
    const unsigned zeros = (quads.zeros[0] >> bit & 1U) | (quads.zeros[1] >> bit & 1U) << 1 |
                           (quads.zeros[2] >> bit & 1U) << 2;
    set_weights({one_of(center, k), one_of(first, k), one_of(second, k), zeros, lane[k]}, out);
    out.distance = one_of(distance, k);
    Real *point = out.point.data(), *normal = out.normal.data();
    point[0] = one_of(x, k), point[1] = one_of(y, k), point[2] = one_of(z, k);
    normal[0] = one_of(normal_x, k), normal[1] = one_of(normal_y, k);
    normal[2] = one_of(normal_z, k);
  }
}

}  // namespace detail

template <class V>
void nearest_on_quads(const NearQuery<3>* of, std::size_t n, NearestPoint<3>* nearest) {
  constexpr std::size_t kQuads = lanes_of<V> / kLanes, kBlock = 8;
  // Two loops: what is computed for one pair waits less for what is taken from the one before.
  detail::OfQuads<V> found[kBlock];
  for (std::size_t begin = 0; begin < n; begin += kBlock * kQuads) {
    const std::size_t end = n - begin < kBlock * kQuads ? n : begin + kBlock * kQuads;
    detail::OfQuads<V>* to = found;
    for (std::size_t i = begin; i < end; i += kQuads) {
      detail::look_at_triangles(of[i], of[i + kQuads <= n ? i + kQuads - 1 : i], *to++);
    }
    to = found;
    for (std::size_t i = begin; i < end; i += kQuads) {
      detail::take_nearest(*to++, i + kQuads <= n ? static_cast<int>(kQuads) : 1, nearest + i);
    }
  }
}

}  // namespace brunt
// Tested by tests/unit/contact/nearest_quads_test.cpp.
