#pragma once
#include <memory>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/setup/bodies.hpp"

namespace brunt {

/// The temperature at time 0 of each body over the place, by label; null where it has one.
template <int Dim>
std::vector<std::unique_ptr<InitialTemperature>> make_initial_temperature(const LoadedDeck& loaded,
                                                                          const Scene<Dim>& scene);

/// [K] of a body as a whole at time 0: where it depends on the place the mean over its points, with
/// which go the properties that a face or a set has one of. Throws InitialTemperatureError.
template <int Dim>
Real start_temperature(const LoadedDeck& loaded, const Scene<Dim>& scene,
                       const BodyGeometry<Dim>& body);

/// What is wrong with a temperature, at the key of its body.
DeckProblem problem_of(const LoadedDeck& loaded, const InitialTemperatureError& error);

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
