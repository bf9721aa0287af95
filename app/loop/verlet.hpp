#pragma once
#include "core/points.hpp"

namespace brunt {

/// First half of velocity Verlet: v += dt/2 a, x += dt v, f = 0, and so heat rates (Swope et al.
/// 1982). docs/theory/integration.md (I1), (I2), (I5). Books to each point what a changed step
/// leaves in m v(n-1/2).v(n+1/2)/2: (dt^2 - dt_last^2) m a^2 / 8 [J]: docs/theory/ledger.md (L3).
template <int Dim>
void predict(Points<Dim>& points, Real dt, Real dt_last);

/// Second half: a = f/m, v += dt/2 a: docs/theory/integration.md (I3), (I4). Points without mass
/// keep their velocity. Where points conduct: H += dt q, T = T_start + H/C. The state is the heat H
/// since time 0 and not T, whose rounding would be that of its 300 K.
template <int Dim>
void correct(Points<Dim>& points, Real dt);

}  // namespace brunt
