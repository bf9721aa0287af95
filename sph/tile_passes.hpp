#pragma once
/// What a tile of particles computes before and after its law, by the width of the arithmetic: of
/// eight doubles a source of their own has it (wide_tile.cpp).
#include "core/geometry/rotation.hpp"
#include "core/wide_lanes.hpp"
#include "sph/correction.hpp"
#include "sph/fetch_record.hpp"
#include "sph/particles.hpp"
#include "sph/principal_tension.hpp"

namespace brunt {

/// What the particles of a tile publish, by slot of the tile.
template <int Dim>
struct TileStress {
  alignas(64) Real gradient[Dim * Dim][kTile];  // [1] L dt at x(n+1)
  alignas(64) Real correction[kSymmetric<Dim>][kTile];
  alignas(64) Real moment[kSymmetric<Dim>][kTile];      // [1] K, where B is left out
  alignas(64) Real growth[kTile];                       // [1] V(n+1)/V(n)
  alignas(64) Real corrected[Dim * Dim][kTile];         // [Pa] V(n+1)/V(n) sigma B
  alignas(64) Real artificial[kSymmetric<Dim>][kTile];  // [Pa]
  alignas(64) Real power[kTile];                        // [Pa] sigma : L dt
  alignas(64) Real sound_speed[kTile];                  // [m/s]
};

/// The material points of a tile in the state of their block, and two constants of their material.
struct TilePoints {
  Real* deviator[6];     // [Pa]
  const Real* pressure;  // [Pa]
  const Real* bulk;      // [Pa]
  Real density;          // [kg/m^3] reference
  Real shear;            // [Pa] G
};

/// Particles that are to be asked for before their tile begins, a few at a time: more would wait in
/// a row, and this tile with them.
template <int Dim>
struct ParticlesAhead {
  const LocalIndex *next, *end;
  const ParticleState<Dim>* state;
  const Vec<Dim>* v;

  BRUNT_INLINE void fetch(std::ptrdiff_t few) {
    const LocalIndex* const last = next + (few < end - next ? few : end - next);
    for (; next < last; ++next) {
      fetch_record(state[*next]);
      fetch_record(v[*next]);
    }
  }
};

/// Spin of the step's middle [rad] turns the deviator; D dt of the middle strains the point.
template <int Dim, class V>
BRUNT_INLINE void rotate_and_strain(const MidStep<Dim, V>& mid, V (&s)[6], V (&strain)[6]) {
  const auto& g = mid.gradient;
  const V zero = broadcast<V>(0.0);
  for (auto& component : strain) component = zero;
  step_strain(g, strain);
  if constexpr (Dim == 3) {
    rotate_symmetric(hughes_winget<V>(0.5 * (g[2][1] - g[1][2]), 0.5 * (g[0][2] - g[2][0]),
                                      0.5 * (g[1][0] - g[0][1])),
                     s);
  } else {
    rotate_symmetric(hughes_winget<V>(0.5 * (g[1][0] - g[0][1])), s);
  }
}

/// Cauchy stress in the plane or in space.
template <int Dim, class V>
BRUNT_INLINE void load_stress(const TilePoints& points, int i, V (&sigma)[Dim][Dim]) {
  const V p = load_as<V>(points.pressure + i);
  const auto component = [&](int k) { return load_as<V>(points.deviator[k] + i); };
  for (int d = 0; d < Dim; ++d) sigma[d][d] = component(d) - p;
  sigma[0][1] = sigma[1][0] = component(xy);
  if constexpr (Dim == 3) {
    sigma[1][2] = sigma[2][1] = component(yz);
    sigma[0][2] = sigma[2][0] = component(zx);
  }
}

/// The same of one point.
template <int Dim>
Eigen::Matrix<Real, Dim, Dim> stress_of(const MaterialState& state, std::size_t at) {
  Eigen::Matrix<Real, Dim, Dim> sigma;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      const auto component = slot_of(Dim == 3 ? symmetric_place<3>(a, b) : a == b ? a : xy);
      sigma(a, b) = state.deviator[component][at] - (a == b ? state.pressure[at] : 0.0);
    }
  }
  return sigma;
}

/// product <- a b, b by its symmetric components in a tile.
template <int Dim, class V, class Rows>
BRUNT_INLINE void times_symmetric(const V (&a)[Dim][Dim], const Rows& b, int i,
                                  V (&product)[Dim][Dim]) {
  for (int r = 0; r < Dim; ++r) {
    for (int k = 0; k < Dim; ++k) {
      V sum = broadcast<V>(0.0);
      for (int c = 0; c < Dim; ++c) {
        sum = sum + a[r][c] * load_as<V>(b[symmetric_place<Dim>(c, k)] + i);
      }
      product[r][k] = sum;
    }
  }
}

/// sigma - skew(sigma K) K^-1, which has the power sigma : (R + W - W K) on R (correct_turn).
template <int Dim, class V>
BRUNT_INLINE void plain_stress(const V (&sigma)[Dim][Dim], const TileStress<Dim>& tile, int i,
                               V (&stress)[Dim][Dim]) {
  V product[Dim][Dim], skew[Dim][Dim];
  times_symmetric<Dim>(sigma, tile.moment, i, product);
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) skew[a][b] = 0.5 * (product[a][b] - product[b][a]);
  }
  times_symmetric<Dim>(skew, tile.correction, i, product);
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) stress[a][b] = sigma[a][b] - product[a][b];
  }
}

/// sigma B, the artificial stress -epsilon times the tensile part of sigma, and sigma : L dt of a
/// pack of points.
template <int Dim, class V>
BRUNT_INLINE void form_pair_stress(const V (&sigma)[Dim][Dim], const SphOptions& options,
                                   TileStress<Dim>& tile, int i) {
  const Real epsilon = options.artificial_stress;
  const V growth = load_as<V>(tile.growth + i);
  V power = broadcast<V>(0.0), tension[Dim][Dim], pair[Dim][Dim];
  if (options.correction) {
    times_symmetric<Dim>(sigma, tile.correction, i, pair);
  } else {
    plain_stress<Dim>(sigma, tile, i, pair);
  }
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      store(tile.corrected[Dim * a + b] + i, growth * pair[a][b]);
      power = power + sigma[a][b] * load_as<V>(tile.gradient[Dim * a + b] + i);
    }
  }
  store(tile.power + i, power);
  if (epsilon == 0) return;
  principal_tension<Dim>(sigma, tension);
  for (int a = 0; a < Dim; ++a) {
    for (int b = a; b < Dim; ++b) {
      store(tile.artificial[symmetric_place<Dim>(a, b)] + i, (-epsilon * growth) * tension[a][b]);
    }
  }
}

/// Turns the deviator to the end of the step; strains and volume ratios of the tile.
template <int Dim, class V>
BRUNT_INLINE void strain_points(const TilePoints& points, ParticlesAhead<Dim> ahead,
                                TileStress<Dim>& stress, MaterialTile& tile) {
  for (int i = 0; i < kTile; i += lanes_of<V>) {
    ahead.fetch(lanes_of<V> / 2);
    V end[Dim][Dim], s[6], strain[6];
    for (int c = 0; c < Dim * Dim; ++c) end[c / Dim][c % Dim] = load_as<V>(stress.gradient[c] + i);
    for (int c = 0; c < 6; ++c) s[c] = load_as<V>(points.deviator[c] + i);
    const auto mid = mid_step<Dim>(end);
    rotate_and_strain(mid, s, strain);
    for (int c = 0; c < 6; ++c) {
      store(points.deviator[c] + i, s[c]);
      store(tile.strain[c] + i, strain[c]);
    }
    store(stress.growth + i, mid.volume_ratio);
    store(tile.ratio + i, load_as<V>(tile.ratio_old + i) * mid.volume_ratio);
  }
}

/// What neighbours will read of the stress, and sound speeds. ratio [1] V/V0 after the step
template <int Dim, class V>
BRUNT_INLINE void stress_points(const TilePoints& points, const SphOptions& options,
                                const Real* ratio, ParticlesAhead<Dim> ahead,
                                TileStress<Dim>& stress) {
  for (int i = 0; i < kTile; i += lanes_of<V>) {
    ahead.fetch(lanes_of<V> / 2);
    V sigma[Dim][Dim];
    load_stress<Dim>(points, i, sigma);
    form_pair_stress<Dim>(sigma, options, stress, i);
    const V modulus = load_as<V>(points.bulk + i) + (4.0 / 3.0) * points.shear;
    const V density = points.density / load_as<V>(ratio + i);
    store(stress.sound_speed + i, vsqrt(modulus / density));
  }
}

/// The same, for V = Wide.
template <int Dim, class V>
void strain_points_by(const TilePoints& points, const ParticlesAhead<Dim>& ahead,
                      TileStress<Dim>& stress, MaterialTile& tile);
template <int Dim, class V>
void stress_points_by(const TilePoints& points, const SphOptions& options, const Real* ratio,
                      const ParticlesAhead<Dim>& ahead, TileStress<Dim>& stress);

}  // namespace brunt
// Tested by tests/unit/sph/wide_tile_test.cpp.
