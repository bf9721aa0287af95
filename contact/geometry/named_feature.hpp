#pragma once
#include "contact/geometry/particle_face.hpp"
#include "core/simd.hpp"

namespace brunt {

/// What of the face the weights of a triangle name.
struct NamedFeature {
  Feature feature = Feature::face;
  bool smooth = true;
  std::int16_t first = 0, second = 0;  // corners
};

/// By a bit for each weight that is 0. corner  of the triangle; -1: the centre of a quad
constexpr NamedFeature name_feature(unsigned zeros, const int (&corner)[3]) {
  NamedFeature named;
  const auto set = [&](Feature feature, int first, int second) {
    named.feature = feature;
    named.first = static_cast<std::int16_t>(first),
    named.second = static_cast<std::int16_t>(second);
  };
  named.smooth = zeros == 0;
  const bool is_quad = corner[2] < 0;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned bit = 1U << i;
    if (zeros == (7U ^ bit) && corner[i] >= 0) set(Feature::vertex, corner[i], corner[i]);
    if (zeros == bit && (!is_quad || i == 2)) {
      set(Feature::edge, corner[(i + 1) % 3], corner[(i + 2) % 3]);
    }
  }
  return named;
}

/// Of the four triangles of a quad; looked up, since which it is changes from face to face.
struct QuadFeatures {
  NamedFeature of[kLanes][8];
  constexpr QuadFeatures() : of{} {
    for (int k = 0; k < kLanes; ++k) {
      for (unsigned zeros = 0; zeros < 8; ++zeros) {
        of[k][zeros] = name_feature(zeros, {k, (k + 1) % kLanes, -1});
      }
    }
  }
};
inline constexpr QuadFeatures kQuadFeatures;

}  // namespace brunt
// Tested by tests/unit/contact/nearest_quads_test.cpp.
