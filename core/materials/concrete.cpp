/// What decks say of laws of concrete.
#include "core/materials/concrete_cap.hpp"
#include "core/materials/holmquist.hpp"

namespace brunt {

namespace {
constexpr Quantity kStress{"Pa", positive(), between(1e3, 1e12)};
constexpr Quantity kNumber{"1", positive(), between(1e-6, 100)};
}  // namespace

void describe(Schema& s, ConcreteCap& law) {
  s.real({"fc", "unconfined compressive strength; all that is not given scales with it",
          Need::required},
         law.fc, {"Pa", positive(), between(1e6, 3e8)});
  s.real({"ft", "tensile strength; 3.5 MPa (fc/45.4 MPa)^(2/3)"}, law.ft,
         {"Pa", positive(), between(1e4, 1e8)});
  s.real({"Gf", "energy of fracture: what a crack takes per area, whatever the size of elements"},
         law.Gf, {"J/m^2", positive(), between(1, 1e5)});
  s.real({"K", "bulk modulus with all pores"}, law.K, kStress);
  s.real({"K_solid", "bulk modulus without pores"}, law.K_solid, kStress);
  s.real({"G", "shear modulus"}, law.G, kStress);
  s.real({"phi0", "porosity at the start"}, law.phi0, {"1", {0, 0.6, true, false}, {}});
  s.real({"p_crush", "pressure at which pores begin to close; fc"}, law.p_crush, kStress);
  s.real({"p_lock", "pressure at which none is left"}, law.p_lock, kStress);
  s.real({"cap_start", "share of the crush pressure at which the cap begins"}, law.cap_start,
         {"1", {0, 1, true, true}, {}});
  s.real({"a0", "of the strength a0 + p/(a1 + a2 p) beyond fc/3; 0.2956 fc"}, law.a0,
         {"Pa", at_least(0), between(1e3, 1e9)});
  s.real({"a1", "of the same"}, law.a1, kNumber);
  s.real({"a2", "of the same; 0.0808/fc"}, law.a2, {"1/Pa", at_least(0), {}});
  s.real({"b1", "of the strength p/(b1 + b2 p) of what has failed in shear"}, law.b1, kNumber);
  s.real({"b2", "of the same; 0.1183/fc"}, law.b2, {"1/Pa", at_least(0), {}});
  s.real({"dilatancy", "porosity that shear makes per eps_p"}, law.dilatancy,
         {"1", at_least(0), between(0, 2)});
  s.real({"phi_damage", "porosity of shear at which it has failed"}, law.phi_damage,
         {"1", positive(), between(1e-5, 1)});
  s.require(law.K_solid >= law.K, "K_solid", "must not be below K: pores make it softer");
  s.require(law.p_lock > law.p_crush.value_or(law.fc), "p_lock", "must be above p_crush");
}

void describe(Schema& s, Holmquist& law) {
  static constexpr const char* kLocking[] = {"at-pressure", "permanent"};
  s.real({"fc", "unconfined compressive strength, to which A and B refer", Need::required}, law.fc,
         {"Pa", positive(), between(1e6, 3e8)});
  s.real({"G", "shear modulus", Need::required}, law.G, kStress);
  s.real({"A", "cohesion over fc", Need::required}, law.A, {"1", at_least(0), between(0, 10)});
  s.real({"B", "hardening by pressure over fc", Need::required}, law.B,
         {"1", at_least(0), between(0, 10)});
  s.real({"N", "exponent of the pressure over fc"}, law.N, {"1", positive(), between(0.1, 2)});
  s.real({"C", "growth with ln(rate/rate_ref)"}, law.C, {"1", at_least(0), between(0, 0.2)});
  s.real({"rate_ref", "rate of strain below which rates count as it"}, law.rate_ref,
         {"1/s", positive(), between(1e-6, 1e3)});
  s.real({"S_max", "largest strength over fc; none"}, law.S_max,
         {"1", positive(), between(0.5, 30)});
  s.real({"T", "largest tension of the mean stress", Need::required}, law.T,
         {"Pa", positive(), between(1e4, 1e8)});
  s.real({"D1", "strain to fail, D1 ((p + T)/fc)^D2", Need::required}, law.D1,
         {"1", at_least(0), between(1e-4, 1)});
  s.real({"D2", "of the same"}, law.D2, {"1", at_least(0), between(0, 3)});
  s.real({"ef_min", "the least strain to fail", Need::required}, law.ef_min,
         {"1", positive(), between(1e-5, 1)});
  s.real({"p_crush", "pressure at which pores begin to close", Need::required}, law.p_crush,
         kStress);
  s.real({"mu_crush", "compression rho/rho0 - 1 at p_crush; the bulk modulus is p_crush/mu_crush",
          Need::required},
         law.mu_crush, {"1", positive(), between(1e-5, 0.1)});
  s.real({"p_lock", "pressure at which no pores are left", Need::required}, law.p_lock, kStress);
  s.real({"mu_lock", "compression without pores: see `locking`", Need::required}, law.mu_lock,
         {"1", positive(), between(1e-4, 1)});
  s.choice({"locking",
            "mu_lock is the compression at p_lock, or what is left of it after release: that at "
            "p_lock follows from K1, K2, K3"},
           law.locking, kLocking);
  s.real({"K1", "of the solid without pores: K1 m + K2 m^2 + K3 m^3", Need::required}, law.K1,
         kStress);
  s.real({"K2", "of the same"}, law.K2, {"Pa", {}, between(-1e12, 1e12)});
  s.real({"K3", "of the same"}, law.K3, {"Pa", {}, between(-1e12, 1e12)});
  s.require(law.p_lock > law.p_crush, "p_lock", "must be above p_crush");
  s.require(law.locking == Holmquist::Locking::permanent || law.mu_lock > law.mu_crush, "mu_lock",
            "must be above mu_crush");
  Holmquist made = law;
  made.prepare();
  const Real full = made.compression_full();
  s.require(!(law.K1 > 0 && law.p_lock > 0 && law.mu_crush > 0) ||
                (made.p_lock - made.p_crush) / (full - made.mu_crush) <= made.bulk_modulus(),
            "p_lock",
            "makes crushing stiffer than the elastic solid, so that release would make energy; "
            "locking: permanent takes mu_lock as what is left after release");
}

}  // namespace brunt
// Tested by tests/unit/core/{concrete_cap,holmquist}_test.cpp.
