#pragma once
/// Materials that decks of several tests have; more of them may follow, two spaces in.
#include <string>

namespace brunt::test {

inline const std::string kRubber = R"(
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0.3}}
)";

/// It does not widen where it is pressed: a bar of it carries plane waves.
inline const std::string kSteelForPlaneWaves = R"(
materials:
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0}}
)";

/// Copper of the Taylor bar that many codes publish: 227 m/s, 32.4 mm long, 3.2 mm in radius.
inline const std::string kTaylorCopper = R"(
materials:
  copper:
    density: 8930 kg/m^3
    elastic: {E: 117 GPa, nu: 0.35}
    strength: {j2: {yield: 400 MPa, hardening: 100 MPa}}
)";

}  // namespace brunt::test
