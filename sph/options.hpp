#pragma once
#include "core/types.hpp"

namespace brunt {

enum class KernelKind : int { cubic, quadratic, hyperbolic, wendland_c2, wendland_c4 };

struct MonaghanViscosity {
  Real alpha = 1.0;
  Real beta = 2.0;
};

/// The keys of a body with method: sph.
struct SphOptions {
  KernelKind kernel = KernelKind::cubic;
  Real smoothing = 1.2;          ///< h over spacing
  bool adaptive_h = true;        ///< h follows (m/rho)^(1/Dim)
  bool correction = true;        ///< gradient correction B
  Real artificial_stress = 0.3;  ///< epsilon of Gray, Monaghan & Swift 2001
  MonaghanViscosity viscosity;
  Real xsph = 0;
};

}  // namespace brunt
