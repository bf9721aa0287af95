#pragma once
#include "core/schema.hpp"
#include "core/types.hpp"

namespace brunt {

/// In what numbers sums over pairs of particles are formed (sph/pair_precision.hpp).
enum class PairPrecision : int { double_precision, single_precision };

/// Where gradients are taken: at the present places, or at those of time 0 (sph/total.hpp).
enum class SphFormulation : int { updated, total };

enum class KernelKind : int { cubic, quadratic, hyperbolic, wendland_c2, wendland_c4 };

struct MonaghanViscosity {
  Real alpha = 1.0;
  Real beta = 2.0;
  bool operator==(const MonaghanViscosity&) const = default;
};

/// The keys of a body with method: sph.
struct SphOptions {
  SphFormulation formulation = SphFormulation::updated;
  KernelKind kernel = KernelKind::cubic;
  Real smoothing = 1.7;        ///< h over spacing
  bool adaptive_h = true;      ///< h follows (m/rho)^(1/Dim)
  bool correction = true;      ///< gradient correction B
  Real artificial_stress = 0;  ///< epsilon of Gray, Monaghan & Swift 2001
  MonaghanViscosity viscosity;
  Real xsph = 0;
  Real hourglass = 20;  ///< [%] total: against motions that strain nothing
  PairPrecision pair_precision = PairPrecision::double_precision;
  bool operator==(const SphOptions&) const = default;
};

inline void describe(Schema& s, MonaghanViscosity& viscosity) {
  s.real({"alpha", "linear coefficient of Monaghan's artificial viscosity"}, viscosity.alpha,
         {"1", at_least(0), between(0, 10)});
  s.real({"beta", "quadratic coefficient"}, viscosity.beta, {"1", at_least(0), between(0, 20)});
}
/// What has no meaning, or no use, where gradients are taken at time 0.
inline void require_plain_total(Schema& s, const SphOptions& sph) {
  if (sph.formulation != SphFormulation::total) return;
  s.require(sph.correction, "correction",
            "formulation: total takes corrected gradients: take it out");
  s.require(sph.artificial_stress == 0, "artificial_stress",
            "formulation: total does not clump where it is pulled: take it out");
  s.require(sph.xsph == 0, "xsph",
            "formulation: total moves particles with their own velocities: take it out");
  s.require(sph.pair_precision == PairPrecision::double_precision, "pair_precision",
            "formulation: total is in double precision: take it out");
}

inline void describe(Schema& s, SphOptions& sph) {
  static constexpr const char* kKernels[] = {"cubic", "quadratic", "hyperbolic", "wendland-c2",
                                             "wendland-c4"};
  static constexpr const char* kPrecisions[] = {"double", "single"};
  static constexpr const char* kFormulations[] = {"updated", "total"};
  s.choice({"formulation",
            "gradients at the present places, or at those of time 0: total does not tear where it "
            "is pulled, and keeps its neighbours"},
           sph.formulation, kFormulations);
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
  const bool total = sph.formulation == SphFormulation::total;
  s.section(total, "only for formulation: total", [&](Schema& of) {
    of.real({"hourglass",
             "stiffness or, where the material yields, viscosity against motions of particles that "
             "strain nothing, as a share of the material's [%]"},
            sph.hourglass, {"1", between(0, 200), between(1, 100)});
  });
  require_plain_total(s, sph);
}

}  // namespace brunt
