#pragma once
/// Concrete and rock whose pores are crushed under pressure, that dilates and softens in shear and
/// parts in tension: a pseudo-cap model after Rubin, Vorobiev & Glenn, Int. J. Solids Struct. 37,
/// 2000, in the simplified form of docs/theory/materials.md (M30) to (M38); shear surfaces after
/// Malvar et al., Int. J. Impact Eng. 19, 1997.
#include <optional>

#include "core/materials/porous_return.hpp"
#include "core/schema.hpp"
#include "core/simd_math.hpp"

namespace brunt {

/// The deck's `strength: {concrete-cap: {...}}`.
struct ConcreteCap {
  static constexpr const char* deck_name = "concrete-cap";
  static constexpr const char* deck_help =
      "concrete, rock: pores are crushed under pressure, shear dilates and softens, tension opens "
      "cracks that take an energy; gives the pressure too";
  /// What it keeps: porosity that compaction takes, that shear has made, that tension has opened;
  /// damage by shear and by tension.
  enum Own { kCompaction, kDilated, kOpened, kShear, kTensile };
  static constexpr std::size_t kOwn = 5;
  static constexpr bool kPores = true, kRegularised = true;
  using Point = PorousPoint<kOwn>;

  Real fc = 0;                              ///< [Pa] unconfined compressive strength
  std::optional<Real> ft;                   ///< [Pa] tensile strength; 3.5 MPa (fc/45.4 MPa)^(2/3)
  Real K = 16e9, K_solid = 45e9, G = 13e9;  ///< [Pa] bulk modulus at phi0, without pores; shear
  Real phi0 = 0.09;                         ///< [1] porosity at the start
  std::optional<Real> p_crush;              ///< [Pa] where compaction begins; fc
  Real p_lock = 1e9;                        ///< [Pa] where no pores are left
  Real cap_start = 0.7;                     ///< [1] kappa
  std::optional<Real> a0, a2, b2;           ///< [Pa], [1/Pa], [1/Pa] of the surfaces; scale with fc
  Real a1 = 0.4463, b1 = 0.4417;            ///< [1]
  Real dilatancy = 0.5;                     ///< [1] beta_0
  Real phi_damage = 0.002;                  ///< [1] phi_D
  Real Gf = 100;                            ///< [J/m^2] energy of fracture

  void prepare();
  Real bulk_modulus() const { return K; }
  Real shear_modulus() const { return G; }
  void start(Point& at) const;
  void step(Point& at) const;
  int parts(const Point& at, Real q_before) const;
  Real strength(const Point& at) const {
    return strength(at.pressure, at.own[kShear], at.own[kTensile]);
  }

  /// Bulk modulus [Pa], pressure at which pores are crushed [Pa], at a porosity.
  Real modulus(Real porosity) const;
  Real crush_pressure(Real porosity) const;
  /// -K ln J_e [Pa], J_e = J (1 - phi)/(1 - phi0).
  Real pressure(Real ratio, Real compaction, Real dilated) const;
  /// Of an intact point; of one with damage by shear and by tension [Pa].
  Real intact_strength(Real pressure) const;
  Real strength(Real pressure, Real shear, Real tensile) const;

 private:
  static constexpr Real kMostDilated = 0.3;      // [1] that shear makes
  static constexpr Real kLeastStrength = 1e-12;  // [1] of fc, that a stress is divided by

  static constexpr Real kMostParts = 1000;  // of a step

  struct Cap;
  Real left_in_tension(const Point& at) const;
  void open(Point& at, Real opened, Real tension, Real work) const;
  void close(Point& at) const;
  void hold_tension(Point& at) const;
  void crush(Point& at) const;
  void shear(Point& at, Real cap) const;
  Real start_of_cap(const Point& at, Real before, Real after) const;
  Real beyond(Cap& cap, Real gamma, Point& at) const;

  Real ft_ = 0, p_crush_ = 0, a0_ = 0, a2_ = 0, b2_ = 0;
};

inline void ConcreteCap::prepare() {
  const Real ratio = fc / 45.4e6;
  ft_ = ft.value_or(3.5e6 * vexp(vlog(ratio) * (2.0 / 3.0)));
  p_crush_ = p_crush.value_or(fc);
  a0_ = a0.value_or(0.2956 * fc);
  a2_ = a2.value_or(0.0808 / fc);
  b2_ = b2.value_or(0.1183 / fc);
}

inline void ConcreteCap::start(Point& at) const {
  at.own = {phi0, 0, 0, 0, 0};
  at.bulk = K, at.porosity = phi0, at.tension = ft_;
}

inline Real ConcreteCap::modulus(Real porosity) const {
  return K_solid + (K - K_solid) * vmin(vmax(porosity / phi0, 0.0), 1.0);
}

inline Real ConcreteCap::crush_pressure(Real porosity) const {
  return p_lock - (p_lock - p_crush_) * std::sqrt(vmin(vmax(porosity / phi0, 0.0), 1.0));
}

inline Real ConcreteCap::pressure(Real ratio, Real compaction, Real dilated) const {
  const Real elastic = ratio * (1 - compaction - dilated) / (1 - phi0);
  return -modulus(compaction) * vlog(elastic);
}

/// Linear from tension over the unconfined test to the hyperbola of Malvar et al.
inline Real ConcreteCap::intact_strength(Real pressure) const {
  if (pressure >= fc / 3) return a0_ + pressure / (a1 + a2_ * pressure);
  if (pressure >= 0) return 1.5 * ft_ + (fc - 1.5 * ft_) * pressure / (fc / 3);
  return 1.5 * vmax(0.0, pressure + ft_);
}

inline Real ConcreteCap::strength(Real pressure, Real shear, Real tensile) const {
  if (pressure <= 0) return 1.5 * vmax(0.0, pressure + ft_ * (1 - vmax(shear, tensile)));
  const Real intact = intact_strength(pressure);
  const Real residual = vmin(pressure / (b1 + b2_ * pressure), intact);
  return (1 - shear) * intact + shear * residual;
}

/// The return to the cap: porosity, pressure and stress that a multiplier gives.
struct ConcreteCap::Cap {
  Real of_pores, of_shear;   // [1] directions of the trial
  Real compaction, q_trial;  // [1], [Pa] before
  Real least = -1;  // [1] of compaction, at which the pressure is down to p_0; < 0: unknown
};

/// Porosity at which the pressure is that where the cap begins: it is above it at `before`, below
/// at `after`.
inline Real ConcreteCap::start_of_cap(const Point& at, Real before, Real after) const {
  const Real others = at.own[kDilated] + at.own[kOpened];
  for (int n = 0; n < 60; ++n) {
    const Real pores = 0.5 * (before + after);
    const bool above = pressure(at.ratio, pores, others) > cap_start * crush_pressure(pores);
    (above ? before : after) = pores;
  }
  return before;
}

inline Real ConcreteCap::left_in_tension(const Point& at) const {
  return ft_ * (1 - vmax(at.own[kShear], at.own[kTensile]));
}

/// A crack that opens, or a point that flows in tension, loses tensile strength by the work that it
/// takes, so that whatever its path it takes Gf over its size in all.
/// opened [1] of the volume, at a tension [Pa]; work [J/m^3] of shear
inline void ConcreteCap::open(Point& at, Real opened, Real tension, Real work) const {
  auto& own = at.own;
  const Real solid = 1 - own[kCompaction] - own[kDilated] - own[kOpened];
  own[kOpened] += opened;
  const Real left = left_in_tension(at);
  if (!(left > kLeastStrength * fc)) return;
  const Real whole = work - tension * vlog(1 - opened / solid);
  own[kTensile] = 1 - (1 - own[kTensile]) * vexp(-whole / left * at.length * ft_ / Gf);
}

/// What has opened in tension closes first, without resistance.
inline void ConcreteCap::close(Point& at) const {
  auto& own = at.own;
  if (!(own[kOpened] > 0) || !(at.pressure > 0)) return;
  const Real pores = 1 - (1 - phi0) / at.ratio - own[kCompaction] - own[kDilated];
  own[kOpened] = vmin(vmax(pores, 0.0), own[kOpened]);
  const Real p = pressure(at.ratio, own[kCompaction], own[kDilated] + own[kOpened]);
  at.pressure = own[kOpened] > 0 ? 0.0 : p;
}

/// Beyond the tensile strength it opens.
inline void ConcreteCap::hold_tension(Point& at) const {
  const Real most = left_in_tension(at);
  if (!(at.pressure < -most)) return;
  auto& own = at.own;
  const Real elastic = vexp(most / modulus(own[kCompaction]));
  const Real pores = 1 - own[kCompaction] - elastic * (1 - phi0) / at.ratio;
  const Real opened = vmax(0.0, pores - own[kDilated] - own[kOpened]);
  open(at, opened, most, 0);
  at.pressure = -most;
}

/// ((p - p_0)/(p_c - p_0))^2 + (q/Y)^2 - 1 after so much flow, which falls with it.
/// No pores are crushed below p_0.
inline Real ConcreteCap::beyond(Cap& cap, Real gamma, Point& at) const {
  Real& pores = at.own[kCompaction];
  const Real others = at.own[kDilated] + at.own[kOpened];
  pores = vmax(0.0, cap.compaction - (1 - cap.compaction) * gamma * cap.of_pores);
  at.pressure = pressure(at.ratio, pores, others);
  if (at.pressure < cap_start * crush_pressure(pores)) {
    if (cap.least < 0) cap.least = start_of_cap(at, cap.compaction, pores);
    pores = cap.least;
    at.pressure = pressure(at.ratio, pores, others);
  }
  at.q = vmax(0.0, cap.q_trial - 3 * G * gamma * cap.of_shear);
  const Real limit = crush_pressure(pores), start = cap_start * limit;
  const Real along = pores > 0 ? vmax(0.0, at.pressure - start) / (limit - start) : 0.0;
  // A flow that is too large leaves neither stress nor strength.
  const Real across = at.q / vmax(strength(at), kLeastStrength * fc);
  return along * along + across * across - 1;
}

/// Return to the cap, in the directions of the trial, by secants between brackets of the
/// multiplier: where they do not halve the bracket, its middle comes next.
inline void ConcreteCap::crush(Point& at) const {
  const Real limit = crush_pressure(at.own[kCompaction]), start = cap_start * limit;
  const Real width = limit - start, yield = strength(at);
  Cap cap{2 * (at.pressure - start) / (width * width), 2 * at.q / (yield * yield),
          at.own[kCompaction], at.q};
  Real lo = 0, at_lo = beyond(cap, 0, at);
  if (!(at_lo > 0)) return;
  Real hi = 1e-6 / vmax(cap.of_pores, cap.of_shear), at_hi = beyond(cap, hi, at);
  for (int n = 0; n < 200 && at_hi > 0; ++n) {
    lo = hi, at_lo = at_hi;
    hi *= 2, at_hi = beyond(cap, hi, at);
  }
  Real gamma = hi;
  bool halved = true;
  for (int n = 0; n < 200 && hi - lo > 1e-13 * hi; ++n) {
    const Real width_before = hi - lo;
    gamma = halved ? (lo * at_hi - hi * at_lo) / (at_hi - at_lo) : 0.5 * (lo + hi);
    const Real value = beyond(cap, gamma, at);
    if (vabs(value) < 1e-12) break;
    (value > 0 ? lo : hi) = gamma;
    (value > 0 ? at_lo : at_hi) = value;
    halved = hi - lo < 0.5 * width_before;
  }
  at.increment = gamma * cap.of_shear;
  beyond(cap, gamma, at);
}

/// Beyond the cap the flow keeps the direction of its trial, which is far off where a step crosses
/// more than a part of the cap. Sixteenths of its width, or of the strength, leave 5 % of a stress.
inline int ConcreteCap::parts(const Point& at, Real q_before) const {
  const auto& own = at.own;
  const Real p = pressure(at.ratio, own[kCompaction], own[kDilated] + own[kOpened]);
  const Real limit = crush_pressure(own[kCompaction]), start = cap_start * limit;
  if (!(own[kCompaction] > 0) || !(p > start)) return 1;
  const Real along = (p - vmax(at.pressure, start)) / (limit - start);
  const Real across = vabs(at.q - q_before) / strength(start, own[kShear], own[kTensile]);
  return static_cast<int>(vmin(vmax(16 * vmax(along, across), 0.0), kMostParts - 1)) + 1;
}

/// Return to the shear surface; what yields dilates, and what dilates softens.
inline void ConcreteCap::shear(Point& at, Real cap) const {
  const Real yield = strength(at);
  if (!(at.q > yield)) return;
  auto& own = at.own;
  at.increment = (at.q - yield) / (3 * G);
  at.q = yield;
  const Real lost = vmax(own[kShear], own[kTensile]);
  const Real pressed = vmax(at.pressure, 0.0);
  const Real dilated = own[kCompaction] > 0
                           ? dilatancy * at.increment * vmax(0.0, 1 - pressed / cap) * (1 - lost)
                           : 0.0;
  if (at.pressure < 0) {
    open(at, dilated, -at.pressure, at.q * at.increment);
  } else {
    own[kDilated] = vmin(own[kDilated] + dilated, kMostDilated);
    own[kShear] = vmin(1.0, own[kShear] + dilated / phi_damage);
  }
  const Real p = pressure(at.ratio, own[kCompaction], own[kDilated] + own[kOpened]);
  at.pressure = vmax(p, -left_in_tension(at));
}

inline void ConcreteCap::step(Point& at) const {
  auto& own = at.own;
  const Real before = own[kCompaction] + own[kDilated] + own[kOpened];
  at.pressure = pressure(at.ratio, own[kCompaction], own[kDilated] + own[kOpened]);
  close(at);
  hold_tension(at);
  const Real cap = cap_start * crush_pressure(own[kCompaction]);
  if (own[kCompaction] > 0 && at.pressure > cap) {
    crush(at);
  } else {
    shear(at, cap);
  }
  at.bulk = modulus(own[kCompaction]);
  at.damage = vmax(own[kShear], own[kTensile]);
  at.tension = left_in_tension(at);
  at.porosity = own[kCompaction] + own[kDilated] + own[kOpened];
  at.plastic_volume = vlog((1 - before) / (1 - at.porosity));
}

void describe(Schema& s, ConcreteCap& law);

}  // namespace brunt
// Tested by tests/unit/core/concrete_cap_test.cpp.
