#pragma once
#include <algorithm>

#include "core/materials/material.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `eos: linear`; also what a material without the key has.
struct LinearEos {
  static constexpr const char* deck_name = "linear";
  static constexpr const char* deck_help = "p = K (rho/rho0 - 1), K from the elastic constants";
};
inline void describe(Schema&, LinearEos&) {}

/// p = K mu, mu = rho/rho0 - 1 = V0/V - 1; tangent K_t = rho dp/drho = K rho/rho0.
class LinearEquation final : public EquationOfState {
 public:
  /// bulk  K [Pa]
  explicit LinearEquation(Real bulk) : bulk_(bulk) {}
  void update(MaterialTile& tile, const Real* deviatoric_work) const override;
  bool needs_energy() const override { return false; }
  void isentropic_heating(const MaterialTile& tile, Real, Real* logarithm) const override {
    std::fill_n(logarithm, tile.count, 0.0);  // it has no energy, and no gamma
  }
  void held_ratio(Real, const Real* ratio, const Real*, int count, Real* held) const override {
    std::copy_n(ratio, count, held);
  }
  Real bulk_modulus() const override { return bulk_; }

 private:
  Real bulk_;
};

}  // namespace brunt
