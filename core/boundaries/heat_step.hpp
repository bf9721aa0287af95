#pragma once
#include "core/points.hpp"
#include "core/step_limit.hpp"

namespace brunt {

/// The longest stable step of conducting points, least capacity/conductance over N = steps, and
/// whose it is: the N steps that an evaluation of conduction acts for, a window, are together no
/// longer than a stable step of heat.
///   Step n of a window makes of T_i  (1 - a_n) T_i + a_n T_f + dt_n/C_i sum_j G_ij (T_j0 - T_i0)
/// with T_0 as at its start and a_n = dt_n H_i/C_i, H_i of all else, which draws T_i to T_f. T_i is
/// then a sum of T_i0, the T_j0 and T_f whose weights sum to 1. That of T_i0 is, with G_i = sum_j
/// G_ij, R_n = prod_{m<=n} 1/(1 - a_m) and dt_m (G_i + H_i) <= C_i/N,
///   (1 - sum_{m<=n} R_m dt_m G_i/C_i)/R_n >= (1 - sum R_m (1/N - a_m))/R_n
///                                          = (R_n - (R_1 + .. + R_n)/N)/R_n >= 0
/// since a_m R_m = R_m - R_m-1 and R grows. So no point passes the extremes, whatever H does within
/// the window. Where heat flows from cold to hot in some pairs (G_ij < 0), a window multiplies
/// modes by factors between -1 and 1 still (Gershgorin): it is stable. C_i/(N G_i + H_i) would do
/// while H is steady, but lets points pass T_f. What contact exchanges is no part of H: by backward
/// Euler, it bounds no step (docs/decisions/027-heat-across-contacts.md).
///
/// With N = 1 a window of several steps must end before it is long: at t_n (G_i + H_i) <= 0.015 C_i
/// (app/scene/heat_windows.hpp) R_16 is at most 1.06, and the weight of T_i0 at least 0.92 (0.93 at
/// equal steps).
template <int Dim>
StepLimit heat_step(const Points<Dim>& points, int steps);

}  // namespace brunt
// Tested by tests/verification/heat_every_test.cpp.
