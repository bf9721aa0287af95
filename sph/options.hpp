#pragma once
#include "core/schema.hpp"
#include "core/types.hpp"

namespace brunt {

/// In what numbers sums over pairs of particles are formed (sph/pair_precision.hpp).
enum class PairPrecision : int { double_precision, single_precision };

enum class KernelKind : int { cubic, quadratic, hyperbolic, wendland_c2, wendland_c4 };

struct MonaghanViscosity {
  Real alpha = 1.0;
  Real beta = 2.0;
};

/// The keys of a body with method: sph.
struct SphOptions {
  KernelKind kernel = KernelKind::cubic;
  Real smoothing = 1.7;        ///< h over spacing
  bool adaptive_h = true;      ///< h follows (m/rho)^(1/Dim)
  bool correction = true;      ///< gradient correction B
  Real artificial_stress = 0;  ///< epsilon of Gray, Monaghan & Swift 2001
  MonaghanViscosity viscosity;
  Real xsph = 0;
  PairPrecision pair_precision = PairPrecision::double_precision;
};

inline void describe(Schema& s, MonaghanViscosity& viscosity) {
  s.real({"alpha", "linear coefficient of Monaghan's artificial viscosity"}, viscosity.alpha,
         {"1", at_least(0), between(0, 10)});
  s.real({"beta", "quadratic coefficient"}, viscosity.beta, {"1", at_least(0), between(0, 20)});
}
inline void describe(Schema& s, SphOptions& sph) {
  static constexpr const char* kKernels[] = {"cubic", "quadratic", "hyperbolic", "wendland-c2",
                                             "wendland-c4"};
  static constexpr const char* kPrecisions[] = {"double", "single"};
  static constexpr const char* kLater[] = {"formulation", "hourglass"};
  s.choice({"kernel", "smoothing kernel"}, sph.kernel, kKernels);
  s.real({"smoothing", "smoothing length over particle spacing"}, sph.smoothing,
         {"1", positive(), between(0.9, 2.5)});
  s.flag({"adaptive_h", "the smoothing length follows (m/rho)^(1/dim)"}, sph.adaptive_h);
  s.flag({"correction", "corrected gradients; without them faces are too soft"}, sph.correction);
  s.real({"artificial_stress", "against clumping in tension (Gray, Monaghan & Swift 2001)"},
         sph.artificial_stress, {"1", between(0, 1)});
  s.object({"viscosity", "artificial viscosity that spreads shocks"}, sph.viscosity);
  s.real({"xsph", "share of the neighbours' velocity with which particles move"}, sph.xsph,
         {"1", between(0, 1)});
  s.choice(
      {"pair_precision", "numbers of the sums over pairs: single is faster, and wrong by 1e-6"},
      sph.pair_precision, kPrecisions);
  s.later(kLater);
}

}  // namespace brunt
