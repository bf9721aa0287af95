/// Compiled for AVX-512 (sph/CMakeLists.txt): nothing here may be out of line but what has Wide in
/// its name.
#include "sph/tile_passes.hpp"

namespace brunt {

template <int Dim, class V>
void strain_points_by(const TilePoints& points, const ParticlesAhead<Dim>& ahead,
                      TileStress<Dim>& stress, MaterialTile& tile) {
  strain_points<Dim, V>(points, ahead, stress, tile);
}

template <int Dim, class V>
void stress_points_by(const TilePoints& points, const SphOptions& options, const Real* ratio,
                      const ParticlesAhead<Dim>& ahead, TileStress<Dim>& stress) {
  stress_points<Dim, V>(points, options, ratio, ahead, stress);
}

#define BRUNT_TILES(Dim)                                                                       \
  template void strain_points_by<Dim, Wide>(const TilePoints&, const ParticlesAhead<Dim>&,     \
                                            TileStress<Dim>&, MaterialTile&);                  \
  template void stress_points_by<Dim, Wide>(const TilePoints&, const SphOptions&, const Real*, \
                                            const ParticlesAhead<Dim>&, TileStress<Dim>&);
BRUNT_TILES(2)
BRUNT_TILES(3)
#undef BRUNT_TILES

}  // namespace brunt
// Tested by tests/unit/sph/wide_tile_test.cpp.
