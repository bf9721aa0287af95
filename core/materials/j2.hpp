#pragma once
/// Plasticity after von Mises (J2) with isotropic hardening, without rate and heat.
#include <array>
#include <optional>

#include "core/materials/law.hpp"
#include "core/schema.hpp"

namespace brunt {

template <class V>
class NearJ2;

/// The deck's `strength: {j2: {...}}`.
struct J2 {
  static constexpr const char* deck_name = "j2";
  static constexpr const char* deck_help = "von Mises plasticity with isotropic hardening";
  Real yield = 0;                    ///< [Pa] flow stress at no plastic strain
  std::optional<Varying> hardening;  ///< [Pa] modulus H; or a table of R over eps_p; none: perfect

  /// sigma_y = yield + R(eps_p), R = H eps_p or the table: linear between, held outside.
  ///   von Mises 1913
  template <class V>
  BRUNT_INLINE V flow_stress(V eps_p, V, V) const {
    return hardened(eps_p).value;
  }
  template <class V>
  BRUNT_INLINE V static_floor(V eps_p, V) const {
    return hardened(eps_p).value;
  }
  template <class V>
  BRUNT_INLINE NearJ2<V> near(V eps_p, V) const {
    return NearJ2<V>(this, eps_p);
  }
  void prepare() {}
  bool needs_temperature() const { return false; }

  /// Flow stress with its slope (the one to the right where the table has a corner).
  template <class V>
  BRUNT_INLINE FlowStress<V> hardened(V eps_p) const {
    const V zero = broadcast<V>(0.0);
    FlowStress<V> flow{broadcast<V>(yield), zero, zero, zero, zero};
    if (!hardening) return flow;
    if (hardening->is_constant()) {
      flow.value = yield + hardening->constant * eps_p;
      flow.d_eps_p = broadcast<V>(hardening->constant);
      return flow;
    }
    const auto& strain = hardening->abscissa;
    const auto& stress = hardening->ordinate;
    flow.value = broadcast<V>(yield + stress.front());
    for (std::size_t i = 0; i + 1 < strain.size(); ++i) {
      const Real width = strain[i + 1] - strain[i];
      const Real slope = (stress[i + 1] - stress[i]) / width;
      const V in_segment = vmin(vmax(eps_p - strain[i], zero), broadcast<V>(width));
      flow.value = flow.value + slope * in_segment;
      const auto inside = (strain[i] <= eps_p) & (eps_p < strain[i + 1]);
      flow.d_eps_p = select(inside, broadcast<V>(slope), flow.d_eps_p);
    }
    return flow;
  }
};

/// The law about a point.
template <class V>
class NearJ2 {
 public:
  NearJ2() = default;
  NearJ2(const J2* law, V eps_p) : law_(law), eps_p_(eps_p) {}
  BRUNT_INLINE V static_stress() const { return law_->hardened(eps_p_).value; }
  BRUNT_INLINE V hardening() const { return law_->hardened(eps_p_).d_eps_p; }
  BRUNT_INLINE V rate_hardening() const { return broadcast<V>(0.0); }
  Real corner_rate() const { return 0; }
  BRUNT_INLINE FlowStress<V> at(V increment, V, V) const {
    return law_->hardened(eps_p_ + increment);
  }

 private:
  const J2* law_;
  V eps_p_;
};

inline void describe(Schema& s, J2& law) {
  static constexpr std::array over{Varying::Over::eps_p};
  s.real({"yield", "flow stress at no plastic strain", Need::required}, law.yield,
         {"Pa", at_least(0), between(1e3, 1e10)});
  s.varying({"hardening",
             "modulus: flow stress gained per plastic strain; or a table over eps_p of the stress "
             "gained; without it the material is perfectly plastic"},
            law.hardening, {"Pa", at_least(0), between(0, 1e11)}, over);
}

}  // namespace brunt
