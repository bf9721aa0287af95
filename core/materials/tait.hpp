#pragma once
/// Liquids: Tait, P.G., Report on some of the physical properties of fresh water and of sea water,
/// 1888, in the form of Murnaghan 1944; gamma of water: Cole, R.H., Underwater explosions, 1948.
#include <optional>

#include "core/materials/printed_eos.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `eos: {tait: {...}}`.
struct Tait : PrintedEos {
  static constexpr const char* deck_name = "tait";
  static constexpr const char* deck_help =
      "liquids: p = p0 + B ((rho/rho0)^gamma - 1), B = rho0 c0^2/gamma";
  static constexpr bool kFluid = true;
  std::optional<Real> c0;  ///< [m/s] sound speed at the reference density, or
  std::optional<Real> B;   ///< [Pa] rho0 c0^2/gamma: one of the two
  Real gamma = 7.15;       ///< [1]
  Real pressure = 0;       ///< [Pa] p0 at the reference density

  template <class N>
  BRUNT_INLINE N formula(const EosState<N>& at) const {
    return pressure + b_ * (vpow(at.relative_density, gamma) - 1.0);
  }
  void prepare(const EosInputs& inputs) {
    b_ = B ? *B : inputs.density * c0.value_or(0) * c0.value_or(0) / gamma;
  }
  bool needs_energy() const { return false; }

 private:
  Real b_ = 0;  // [Pa] B
};

inline void describe(Schema& s, Tait& liquid) {
  s.real({"c0", "sound speed at the density given; less than the true one makes longer steps"},
         liquid.c0, {"m/s", positive(), between(1, 1e4)});
  s.real({"B", "density c0^2/gamma, in place of c0; water: 304.7 MPa"}, liquid.B,
         {"Pa", positive(), between(1, 1e11)});
  s.real({"gamma", "exponent of the density; water: 7.15"}, liquid.gamma,
         {"1", positive(), between(1, 15)});
  s.real({"pressure", "pressure at the density given"}, liquid.pressure,
         {"Pa", {}, between(-1e9, 1e11)});
  s.require(liquid.c0 || liquid.B, "", "needs c0, or B = density c0^2/gamma");
  s.require(!liquid.c0 || !liquid.B, "B", "says c0 again, as density c0^2/gamma: leave one out");
}

}  // namespace brunt
