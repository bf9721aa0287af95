#include "app/cli/forecast.hpp"

#include <algorithm>
#include <cmath>

#include "app/deck/flow_stress.hpp"

namespace brunt {

namespace {
constexpr Real kMostStrain = 3;

/// The strain at which a body of this material has taken up rho v^2 / 2.
Real stopping_strain(const deck::Material& material, Real speed) {
  const Real energy = 0.5 * material.density * speed * speed;
  if (std::holds_alternative<NoStrength>(material.strength)) {
    const Real modulus = material.bulk_modulus() + 4.0 / 3 * material.shear_modulus();
    return std::min(kMostStrain, speed * std::sqrt(material.density / modulus));
  }
  constexpr Real kStep = 1e-3;
  const StrengthLaw law = material.melting_strength();
  Real taken = 0, strain = 0;
  for (; taken < energy && strain < kMostStrain; strain += kStep) {
    taken += kStep * deck::slow_flow_stress(law, strain + 0.5 * kStep);
  }
  return strain;
}

/// The largest speed [m/s] between a body and any other.
Real impact_speed(const Deck& deck, const deck::Body& body) {
  const auto own = deck::first_velocity(body);
  Real most = 0;
  for (const auto& other : deck.bodies) {
    const auto its = deck::first_velocity(other.value);
    most = std::max(most, std::hypot(own[0] - its[0], own[1] - its[1], own[2] - its[2]));
  }
  return most;
}
}  // namespace

Real Flattening::most_steps() const {
  constexpr Real kFaceOverMean = 6;
  return std::exp(std::min(kFaceOverMean * strain, kMostStrain * 2));
}

Flattening flattening_of(const Deck& deck) {
  Flattening worst;
  for (const auto& [name, body] : deck.bodies) {
    if (body.rigid) continue;
    const auto* material = deck.material_named(body.material);
    if (material == nullptr) continue;
    const Real speed = impact_speed(deck, body);
    const Real strain = stopping_strain(*material, speed);
    if (strain > worst.strain) worst = {speed, strain};
  }
  return worst;
}

}  // namespace brunt
