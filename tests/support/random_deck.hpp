#pragma once
#include <cstdint>
#include <string>

namespace brunt::test {

/// A valid deck of two or three bodies that are thrown at each other, all of it drawn from `seed`:
/// geometry, shapes, elements, particles and rigid bodies, materials, contact, heat, boundaries,
/// gravity, speeds from 1 to 500 m/s. Some hundred elements and steps; a step that collapses to a
/// fortieth of the first stops it. The same on all machines.
/// newer  draws what came later too: other equations of state and strengths, damage, erosion,
///        tetrahedra, tied contact and joints, symmetry, pressure
std::string random_deck(std::uint64_t seed, bool newer = false);

}  // namespace brunt::test
