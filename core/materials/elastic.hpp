#pragma once
/// No limit of strength: the deviator follows the strain elastically.
#include "core/materials/material.hpp"
#include "core/schema.hpp"
#include "core/simd.hpp"

namespace brunt {

/// The deck's `strength: none`; also what a material without the key has.
struct NoStrength {
  static constexpr const char* deck_name = "none";
  static constexpr const char* deck_help = "never yields: the stress deviator stays elastic";
};
inline void describe(Schema&, NoStrength&) {}

/// s + 2 G dev(strain) of one component; third: a third of the strain's trace for xx, yy and zz.
template <class V>
BRUNT_INLINE V trial_stress(V stress, V strain, V third, Real shear) {
  return stress + (2.0 * shear) * (strain - third);
}

/// Hooke's law for the deviator: s += 2 G dev(strain).
class ElasticStrength final : public Strength {
 public:
  /// shear  G [Pa]
  explicit ElasticStrength(Real shear) : shear_(shear) {}
  void update(MaterialTile& tile, Real dt) const override;
  bool yields() const override { return false; }
  bool needs_temperature() const override { return false; }
  Real flow_stress(const MaterialState&, std::size_t, Real) const override { return kInfinity; }

 private:
  Real shear_;
};

}  // namespace brunt
// Tested by tests/unit/core/material_test.cpp.
