#pragma once
#include <string>

namespace brunt::test {

/// A strip of 4 mm x 20 mm of 300 MPa + 900 MPa eps_p, which does not neck below 0.62, pulled at
/// 24 m/s for some [us] under damping; the force is the measure F.
inline std::string strip_that_hardens(const std::string& method, int end) {
  const std::string us = " us";
  return R"(
title: a strip that hardens
geometry: plane-strain
parameters: {end: )" +
         std::to_string(end) + us + ", slows: " + std::to_string(end - 20) + us + R"(}
time: {end: $end}
heat: off
damping: {rate: 1e5 1/s}
materials:
  m: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3},
    strength: {johnson-cook: {A: 300 MPa, B: 900 MPa, n: 1}}}
bodies:
  a: {material: m, shape: {box: {min: [0, 0], max: [4 mm, 20 mm]}}, size: 0.5 mm, )" +
         method + R"(}
boundaries:
  l: {body: a, where: {box: {min: [-1 mm, -1 mm], max: [9 mm, 1.5 mm]}}, fix: [y]}
  r: {body: a, where: {box: {min: [-1 mm, 18.5 mm], max: [9 mm, 21 mm]}},
    velocity: [free, {table: [[0, 0], [20 us, 24 m/s], [$slows, 24 m/s], [$end, 0]], over: time}]}
sections: {s: {body: a, plane: {axis: y, at: 10 mm}}}
measures: {F: {history: {column: section.s.force.y, reduce: last}}}
output: {every: $end, history: 5 us}
)";
}

}  // namespace brunt::test
// Tested by tests/verification/particle_tension_test.cpp.
