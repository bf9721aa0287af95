#pragma once
/// Radial return (Wilkins 1964; Krieg & Krieg 1977) of a law sigma_y(eps_p, rate, T), over tiles.
#include <algorithm>
#include <array>
#include <utility>

#include "core/materials/elastic.hpp"
#include "core/materials/law.hpp"
#include "core/materials/plastic_heat.hpp"

namespace brunt {

/// The unknown of one point's return, the increment of eps_p, between its brackets.
template <class V>
struct ReturnPoint {
  V q_trial, q_old;     ///< [Pa] equivalent stress of the trial; old flow stress, for the heating
  V temperature;        ///< [K] before the step
  V heating;            ///< [K/Pa] temperature per mean flow stress and plastic strain
  V step;               ///< [1] length of the last step
  V increment, lo, hi;  ///< [1] of eps_p
  decltype(V{} < V{}) active;  ///< where it has not converged
};

inline constexpr int kNewtonOnly = 8;  ///< iterations after which a step must halve the last one

/// Between the brackets, by ratio where they are far apart.
template <class V>
BRUNT_INLINE V middle(V lo, V hi) {
  const V geometric = vsqrt(vmax(lo, hi * 1e-4)) * vsqrt(hi);
  return select(4.0 * lo < hi, geometric, 0.5 * (lo + hi));
}

/// Longest last step over the increment. Newton's method converges as the square: a step of 1e-5
/// leaves an error of 1e-10 at the most. Halley's leaves a twelfth of the cube of it where g bends
/// as a logarithm or a power.
inline constexpr Real kNewtonStep = 1e-5, kHalleyStep = 5e-4;

/// A falling function g of the increment, where it is now.
template <class V>
struct Residual {
  V value;      ///< [Pa] g
  V slope;      ///< [Pa] g', below 0
  V bend;       ///< [Pa] increment times g''; 0: not known
  V last_step;  ///< [1] over the increment: what ends the iteration
  V corner;     ///< [1] an increment where g has a corner; 0: none. No step across it is the last
};

/// One safeguarded step of Halley's method towards the root of g; of Newton's without its bend. It
/// is four times Newton's at the most. A point that has converged is frozen: what its neighbours in
/// the pack need does not change it. Late steps that do not shrink are replaced, so that a corner
/// of g (at rate_ref, at melting) cannot keep Newton going to and fro.
///
/// iteration  from 0
template <class V>
BRUNT_INLINE void improve(ReturnPoint<V>& p, const Residual<V>& at, int iteration) {
  const V d = p.increment, g = at.value;
  const auto right = 0.0 < g;  // the root is at a larger increment
  p.lo = select(right, d, p.lo);
  p.hi = select(right, p.hi, d);
  const V twice = 2.0 * vmax(d, broadcast<V>(1e-100)) * at.slope, square = twice * at.slope;
  const V halley = d - (g * twice) / vmax(square - g * at.bend, 0.25 * square);
  const V longest = iteration < kNewtonOnly ? broadcast<V>(kInfinity) : 0.5 * p.step;
  const auto good = (p.lo <= halley) & (halley <= p.hi) & (vabs(halley - d) <= longest);
  V next = halley;
  if (any(!good)) next = select(good, halley, middle(p.lo, p.hi));
  // An increment below 1e-30 is none: the point has only just reached its yield stress.
  const auto exact = vabs(g) <= 1e-14 * p.q_trial;
  const auto crosses = (d < at.corner) ^ (next < at.corner);
  const auto converged = exact | (good & !crosses & (vabs(next - d) <= at.last_step * d)) |
                         (p.hi - p.lo <= 1e-14 * p.hi) | (p.hi <= 1e-30);
  next = select(p.active & !exact, next, d);
  p.step = vabs(next - d);
  p.increment = next;
  p.active = p.active & !converged;
}

/// What a step has for all points of a material.
struct ReturnStep {
  Real shear = 0;       ///< [Pa]
  Real dt = 0;          ///< [s]
  Real inverse_dt = 0;  ///< [1/s]; 0 where dt is
};

/// Where the increment would stand if what resists grew along its slopes from the old flow stress
/// on, that of the rate by its logarithm: from the rate of the last step, if the point yielded
/// then.
///
/// stiff    [Pa] slope of elastic unloading and hardening
///
/// of_rate  [Pa] d(flow stress)/d(ln rate)
///
/// last     [1] increment at that rate
template <class V>
BRUNT_INLINE V guessed_increment(const ReturnPoint<V>& p, V stiff, V of_rate, V last) {
  const V zero = broadcast<V>(0.0), over = p.q_trial - p.q_old;
  const auto goes_on = zero < last;
  return select(goes_on, (of_rate + vmax(over, zero)) * last, over) /
         select(goes_on, (of_rate - vmin(over, zero)) + stiff * last, stiff);
}

/// Improves by g(d) = q_trial - 3 G d - sigma_y(eps_p + d, d/dt, T + dT(d)) = 0,
/// dT = heating (q_old + q_trial - 3 G d)/2 d.
template <class V, class NearLaw>
BRUNT_INLINE void return_step(ReturnPoint<V>& p, const NearLaw& law, const ReturnStep& step,
                              int iteration) {
  const Real shear = step.shear, inverse_dt = step.inverse_dt;
  const V d = p.increment;
  const V stress = p.q_trial - (3.0 * shear) * d;
  const V both = p.q_old + stress;
  const auto flow = law.at(d, d * inverse_dt, p.temperature + (0.5 * p.heating) * (both * d));
  const V d_temperature = (0.5 * p.heating) * (both - (3.0 * shear) * d);
  const V g = stress - flow.value;
  const V of_rate = flow.d_rate * inverse_dt;  // of a logarithm, whose bend is its slope
  const V slope = (-3.0 * shear - flow.d_eps_p) - of_rate - flow.d_temperature * d_temperature;
  const V of_heat = flow.d_temperature * p.heating * (3.0 * shear * d);
  // The bend of softening is left out: it has to be small beside all that resists.
  const auto halley = flow.smooth & (vabs(flow.d_temperature * d_temperature) <= -1e-3 * slope);
  const V last_step = select(halley, broadcast<V>(kHalleyStep), broadcast<V>(kNewtonStep));
  improve(p,
          {g, slope, of_rate + flow.bend + of_heat, last_step,
           broadcast<V>(law.corner_rate() * step.dt)},
          iteration);
}

/// Strength that follows a law by radial return. V: the width of its arithmetic; the bits of a
/// point do not depend on it.
template <FlowLaw Law, class V = Pack>
class RadialReturn final : public Strength {
 public:
  RadialReturn(Law law, const StrengthInputs& inputs) : law_(std::move(law)), inputs_(inputs) {
    law_.prepare();
  }

  void update(MaterialTile& tile, Real dt) const override {
    const ReturnStep step{inputs_.shear, dt, dt > 0 ? 1.0 / dt : 0.0};
    Candidates candidates;
    for (int i = 0; i < tile.count; i += kStep) trial(tile, i, candidates);
    if (candidates.count == 0) return;
    Returned returned;
    const bool all = candidates.count == (tile.count + kStep - 1) / kStep * kStep;
    if (!all) returned.begin();
    solve(candidates, all, step, returned);
    for (int i = 0; i < tile.count; i += kStep) finish(tile, i, step.inverse_dt, returned);
  }
  bool yields() const override { return true; }
  bool needs_temperature() const override { return law_.needs_temperature(); }
  Real flow_stress(const MaterialState& state, std::size_t k,
                   Real fixed_temperature) const override {
    const Real T = state.temperature.empty() ? fixed_temperature : state.temperature[k];
    return law_.flow_stress(state.eps_p[k], state.strain_rate[k], T);
  }

 private:
  static constexpr int kStep = lanes_of<V>;
  static constexpr int kMaxIterations = 50;
  using Near = decltype(std::declval<const Law&>().near(V{}, V{}));

  /// Points of a tile that may yield, side by side; fields as in ReturnPoint.
  struct Candidates {
    int count = 0;
    int point[kTile];  ///< index within the tile
    alignas(32) Real q_trial[kTile], q_old[kTile], eps_p[kTile], temperature[kTile], heating[kTile];
    alignas(32) Real rate[kTile];  ///< [1/s] of the step before
  };
  /// What the return leaves at each point of a tile.
  struct Returned {
    alignas(32) Real scale[kTile];      ///< [1] factor of the trial deviator
    alignas(32) Real increment[kTile];  ///< [1] of eps_p
    alignas(32) Real work[kTile];       ///< [Pa] plastic work per current volume
    Returned() {}  // NOLINT(modernize-use-equals-default): candidates fill it, if all are
    /// The identity, for points that do not yield.
    void begin() {
      std::fill_n(scale, kTile, 1.0);
      std::fill_n(increment, kTile, 0.0);
      std::fill_n(work, kTile, 0.0);
    }
  };

  using ReturnPoints = std::array<ReturnPoint<V>, kTile / kStep>;

  void trial(MaterialTile& tile, int i, Candidates& candidates) const;
  /// all  every point that was tried is a candidate, in order
  void solve(Candidates& candidates, bool all, const ReturnStep& step, Returned& returned) const;
  void hand_out(const Candidates& candidates, bool all, const ReturnPoints& points,
                Returned& returned) const;
  void finish(MaterialTile& tile, int i, Real inverse_dt, const Returned& returned) const;

  Law law_;
  StrengthInputs inputs_;
};

/// Elastic trial of kStep points; puts those above the law's floor among the candidates.
template <FlowLaw Law, class V>
void RadialReturn<Law, V>::trial(MaterialTile& tile, int i, Candidates& candidates) const {
  MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  const V third = (load_as<V>(tile.strain[xx] + i) + load_as<V>(tile.strain[yy] + i) +
                   load_as<V>(tile.strain[zz] + i)) *
                  (1.0 / 3.0);
  V old_square = broadcast<V>(0.0), square = old_square;
  for (std::size_t c = 0; c < 6; ++c) {
    Real* place = state.deviator[c].data() + at;
    const V old = load_as<V>(place), strain = load_as<V>(tile.strain[c] + i);
    const V stress = trial_stress(old, strain, c < 3 ? third : V{}, inputs_.shear);
    store(place, stress);
    const Real weight = c < 3 ? 1.5 : 3.0;
    old_square = old_square + weight * (old * old);
    square = square + weight * (stress * stress);
  }
  const V rate = load_as<V>(state.strain_rate.data() + at);
  store(state.strain_rate.data() + at, broadcast<V>(0.0));
  const V eps_p = load_as<V>(state.eps_p.data() + at);
  const V T = state.temperature.empty() ? broadcast<V>(tile.fixed_temperature)
                                        : load_as<V>(state.temperature.data() + at);
  const V q_trial = vsqrt(square);
  const auto may_yield = law_.static_floor(eps_p, T) < q_trial;
  if (!any(may_yield)) return;
  const V q_old = vsqrt(old_square);
  V heating = broadcast<V>(0.0);
  if (heats(inputs_, tile)) heating = heating_at(inputs_, T, heat_factor<V>(inputs_, tile, i));
  if (!any(!may_yield)) {
    const int n = candidates.count;
    for (int lane = 0; lane < kStep; ++lane) candidates.point[n + lane] = i + lane;
    store(candidates.q_trial + n, q_trial), store(candidates.q_old + n, q_old);
    store(candidates.eps_p + n, eps_p), store(candidates.temperature + n, T);
    store(candidates.heating + n, heating), store(candidates.rate + n, rate);
    candidates.count += kStep;
    return;
  }
  for (int lane = 0; lane < kStep; ++lane) {
    if (!lane_of(may_yield, lane)) continue;
    const int n = candidates.count++;
    candidates.point[n] = i + lane;
    candidates.q_trial[n] = lane_of(q_trial, lane);
    candidates.q_old[n] = lane_of(q_old, lane);
    candidates.eps_p[n] = lane_of(eps_p, lane);
    candidates.temperature[n] = lane_of(T, lane);
    candidates.heating[n] = lane_of(heating, lane);
    candidates.rate[n] = lane_of(rate, lane);
  }
}

/// Finds the increments of all candidates. Packs take turns, so that their chains overlap.
template <FlowLaw Law, class V>
void RadialReturn<Law, V>::solve(Candidates& c, bool all, const ReturnStep& step,
                                 Returned& returned) const {
  const Real shear = step.shear;
  int n = c.count;
  for (; n % kStep != 0; ++n) {  // fills the last pack up with copies of its last point
    c.q_trial[n] = c.q_trial[n - 1], c.q_old[n] = c.q_old[n - 1], c.eps_p[n] = c.eps_p[n - 1];
    c.temperature[n] = c.temperature[n - 1], c.heating[n] = c.heating[n - 1];
    c.rate[n] = c.rate[n - 1];
  }
  ReturnPoints points;
  std::array<Near, kTile / kStep> laws;
  const int packs = n / kStep;
  for (int k = 0; k < packs; ++k) {
    const int i = k * kStep;
    ReturnPoint<V>& p = points[k];
    p.q_trial = load_as<V>(c.q_trial + i);
    p.temperature = load_as<V>(c.temperature + i);
    p.heating = load_as<V>(c.heating + i);
    const Near near = law_.near(load_as<V>(c.eps_p + i), p.temperature);
    laws[k] = near;
    const V yield = near.static_stress();
    p.q_old = vmax(load_as<V>(c.q_old + i), yield);
    p.lo = p.step = broadcast<V>(0.0);
    p.hi = p.q_trial * (1.0 / (3.0 * shear));
    const V slope = vmin(near.hardening(), broadcast<V>(3.0 * shear));  // infinite where eps_p is 0
    p.increment = guessed_increment<V>(p, 3.0 * shear + slope, near.rate_hardening(),
                                       step.dt * load_as<V>(c.rate + i));
    p.increment = vmin(vmax(p.increment, 1e-7 * p.hi), 0.999 * p.hi);
    p.active = yield < p.q_trial;
    p.increment = select(p.active, p.increment, broadcast<V>(0.0));
  }
  bool busy = true;
  for (int iteration = 0; busy && iteration < kMaxIterations; ++iteration) {
    busy = false;
    for (int k = 0; k < packs; ++k) {
      ReturnPoint<V>& p = points[k];
      if (!any(p.active)) continue;
      return_step(p, laws[k], step, iteration);
      busy = busy || any(p.active);
    }
  }
  hand_out(c, all, points, returned);
}

/// What the increments of the candidates make of their points. Where all of a tile are candidates
/// they stand as their points do.
template <FlowLaw Law, class V>
void RadialReturn<Law, V>::hand_out(const Candidates& c, bool all, const ReturnPoints& points,
                                    Returned& returned) const {
  Returned side_by_side;
  Returned& out = all ? returned : side_by_side;
  for (int i = 0; i < c.count; i += kStep) {
    const ReturnPoint<V>& p = points[slot_of(i / kStep)];
    const V q = vmax(p.q_trial - (3.0 * inputs_.shear) * p.increment, broadcast<V>(0.0));
    const auto yields = broadcast<V>(0.0) < p.increment;
    store(out.scale + i, select(yields, q / p.q_trial, broadcast<V>(1.0)));
    store(out.increment + i, p.increment);
    store(out.work + i, (0.5 * (p.q_old + q)) * p.increment);
  }
  for (int i = 0; !all && i < c.count; ++i) {
    const int point = c.point[i];
    returned.scale[point] = out.scale[i];
    returned.increment[point] = out.increment[i];
    returned.work[point] = out.work[i];
  }
}

/// Brings what the return found into the state of kStep points.
template <FlowLaw Law, class V>
void RadialReturn<Law, V>::finish(MaterialTile& tile, int i, Real inverse_dt,
                                  const Returned& returned) const {
  MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  const V scale = load_as<V>(returned.scale + i), increment = load_as<V>(returned.increment + i);
  for (auto& component : state.deviator) {
    store(component.data() + at, load_as<V>(component.data() + at) * scale);
  }
  store(state.eps_p.data() + at, load_as<V>(state.eps_p.data() + at) + increment);
  store(state.strain_rate.data() + at, increment * inverse_dt);
  if (!state.heat.empty()) add_plastic_heat(inputs_, tile, i, load_as<V>(returned.work + i));
}

}  // namespace brunt
