#pragma once
/// Concrete under impact.
///   Holmquist, T.J., Johnson, G.R. & Cook, W.H., A computational constitutive model for concrete
///   subjected to large strains, high strain rates, and high pressures, 14th Int. Symp. Ballistics,
///   1993; docs/theory/materials.md (M39) to (M43)
#include "core/materials/porous_return.hpp"
#include "core/schema.hpp"
#include "core/simd_math.hpp"

namespace brunt {

/// The deck's `strength: {hjc: {...}}`.
struct Holmquist {
  static constexpr const char* deck_name = "hjc";
  static constexpr const char* deck_help =
      "concrete after Holmquist, Johnson and Cook: strength over pressure, rate and damage, with "
      "its own compaction; gives the pressure too";
  /// What it keeps: largest compression mu of the past, that which is left at no pressure, damage.
  enum Own { kLargest, kPermanent, kDamage };
  static constexpr std::size_t kOwn = 3;
  static constexpr bool kPores = false, kRegularised = false;
  using Point = PorousPoint<kOwn>;
  /// What mu_lock is: the compression at p_lock, or that which is left once it is released from
  /// there; the one at p_lock follows then, where the curve of the dense solid reaches p_lock.
  enum class Locking { at_pressure, permanent };

  Real fc = 0;                      ///< [Pa] unconfined compressive strength
  Real G = 0;                       ///< [Pa] shear modulus
  Real A = 0, B = 0, N = 1, C = 0;  ///< [1]
  Real S_max = kInfinity;           ///< [1] largest strength over fc
  Real rate_ref = 1;                ///< [1/s]
  Real T = 0;                       ///< [Pa] largest tension
  Real D1 = 0, D2 = 1, ef_min = 0;  ///< [1]
  Real p_crush = 0, mu_crush = 0;   ///< [Pa], [1] where pores begin to close
  Real p_lock = 0, mu_lock = 0;     ///< [Pa], [1] where none is left
  Real K1 = 0, K2 = 0, K3 = 0;      ///< [Pa] of the dense solid
  Locking locking = Locking::at_pressure;

  void prepare() { mu_full_ = locking == Locking::permanent ? compression_at_lock() : mu_lock; }
  Real bulk_modulus() const { return p_crush / mu_crush; }
  Real shear_modulus() const { return G; }
  void start(Point& at) const { at.bulk = bulk_modulus(), at.tension = T; }
  void step(Point& at) const;
  int parts(const Point&, Real) const { return 1; }
  Real strength(const Point& at) const { return strength(at.pressure, at.own[kDamage], at.rate); }

  /// Strength [Pa]: fc [A (1 - D) + B (p/fc)^N] (1 + C ln(rate/rate_ref)), at most S_max fc; in
  /// tension fc A max(1 - D + p/T, 0) of that rate.
  Real strength(Real pressure, Real damage, Real rate) const;
  /// eps_p + mu_p that a point bears [1]: D1 ((p + T)/fc)^D2, at least ef_min.
  Real strain_to_fail(Real pressure) const;
  /// Pressure [Pa] of first loading to a compression mu = 1/J - 1.
  Real first_loading(Real mu) const;
  Real compression_full() const { return mu_full_; }  ///< [1] at p_lock
  /// The compression that is left at no pressure after a largest one.
  Real permanent(Real largest) const;

 private:
  struct Slope {
    Real pressure, modulus;  // [Pa], [Pa] dp/dmu
  };
  Slope dense(Real mu) const;
  Slope pressure_at(Real mu, Real largest) const;
  Real share_crushed(Real largest) const {
    return vmin(vmax((largest - mu_crush) / (mu_full_ - mu_crush), 0.0), 1.0);
  }
  Real compression_at_lock() const;

  Real mu_full_ = 0;  // [1] compression at p_lock
};

/// K1 m + K2 m^2 + K3 m^3, m = (mu - mu_lock)/(1 + mu_lock); linear where it is pulled.
inline Holmquist::Slope Holmquist::dense(Real mu) const {
  const Real m = (mu - mu_lock) / (1 + mu_lock), per_mu = 1 / (1 + mu_lock);
  if (m < 0) return {K1 * m, K1 * per_mu};
  return {m * (K1 + m * (K2 + m * K3)), (K1 + m * (2 * K2 + m * 3 * K3)) * per_mu};
}

inline Real Holmquist::compression_at_lock() const {
  Real lo = mu_lock, hi = mu_lock + 1e-6;
  for (int n = 0; n < 60 && dense(hi).pressure < p_lock; ++n) hi = mu_lock + 2 * (hi - mu_lock);
  for (int n = 0; n < 200 && hi - lo > 1e-16; ++n) {
    const Real middle = 0.5 * (lo + hi);
    (dense(middle).pressure < p_lock ? lo : hi) = middle;
  }
  return hi;
}

inline Real Holmquist::first_loading(Real mu) const {
  if (mu <= mu_crush) return bulk_modulus() * mu;
  if (mu <= mu_full_) {
    return p_crush + (p_lock - p_crush) * (mu - mu_crush) / (mu_full_ - mu_crush);
  }
  return vmax(p_lock, dense(mu).pressure);
}

/// Where mu_lock is the permanent one, it grows with what is crushed; else release has the modulus
/// between those of the solid with all pores and with none.
inline Real Holmquist::permanent(Real largest) const {
  const Real share = share_crushed(largest);
  if (share == 0) return 0;
  if (locking == Locking::permanent) return share * mu_lock;
  const Real modulus = (1 - share) * bulk_modulus() + share * K1;
  return largest - first_loading(largest) / modulus;
}

inline Holmquist::Slope Holmquist::pressure_at(Real mu, Real largest) const {
  if (largest <= mu_crush) return {bulk_modulus() * mu, bulk_modulus()};
  if (locking == Locking::permanent && largest >= mu_full_) return dense(mu);
  const Real left = permanent(largest), most = first_loading(largest);
  const Real modulus = most / (largest - left);
  return {modulus * (mu - left), modulus};
}

inline Real Holmquist::strength(Real pressure, Real damage, Real rate) const {
  const Real fast = 1 + C * vlog(vmax(1.0, rate / rate_ref));
  if (pressure <= 0) return fc * A * vmax(0.0, 1 - damage + pressure / T) * fast;
  const Real pressed = B * vpow(pressure / fc, N);
  return fc * vmin((A * (1 - damage) + pressed) * fast, S_max);
}

inline Real Holmquist::strain_to_fail(Real pressure) const {
  const Real pressed = vmax((pressure + T) / fc, 0.0);
  return vmax(ef_min, pressed > 0 ? D1 * vpow(pressed, D2) : 0.0);
}

inline void Holmquist::step(Point& at) const {
  const Real mu = 1 / at.ratio - 1;
  auto& own = at.own;
  const Real before = own[kPermanent];
  own[kLargest] = vmax(own[kLargest], mu);
  own[kPermanent] = vmax(before, permanent(own[kLargest]));
  const Slope now = pressure_at(mu, own[kLargest]);
  at.pressure = vmax(now.pressure, -T * (1 - own[kDamage]));
  const Real yield = strength(at);
  if (at.q > yield) {
    at.increment = (at.q - yield) / (3 * G);
    at.q = yield;
  }
  const Real crushed = own[kPermanent] - before;
  own[kDamage] = vmin(1.0, own[kDamage] + (at.increment + crushed) / strain_to_fail(at.pressure));
  at.tension = T * (1 - own[kDamage]);
  at.pressure = vmax(at.pressure, -at.tension);
  at.damage = own[kDamage];
  at.bulk = vmax(now.modulus, bulk_modulus()) * vmax(1 + mu, 1.0);
  at.plastic_volume = -vlog((1 + own[kPermanent]) / (1 + before));
}

void describe(Schema& s, Holmquist& law);

}  // namespace brunt
// Tested by tests/unit/core/holmquist_test.cpp.
