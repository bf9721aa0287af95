#pragma once
/// The deck's `gravity`: one acceleration of all that is free, constant or over time.
#include <array>
#include <optional>
#include <vector>

#include "core/schema.hpp"

namespace brunt::deck {

/// [m/s^2] by component; none: no gravity
using Gravity = std::optional<std::vector<std::optional<Varying>>>;

void describe_gravity(Schema& s, Gravity& gravity);

/// True where it pulls: zeros for ever are none.
bool pulls(const Gravity& gravity);
/// True where a component is a table or an expression.
bool is_over_time(const Gravity& gravity);
/// [m/s^2] at a time [s], 0 beyond its components.
std::array<Real, 3> gravity_at(const Gravity& gravity, Real time);
/// Moments of a run [s] that show what it does: bends of tables, and of expressions 257 equal ones.
std::vector<Real> gravity_times(const Gravity& gravity, Real end);
/// [m/s^2] by component where it is largest in a run: of several such moments the first.
std::vector<Real> largest_gravity(const Gravity& gravity, Real end);

}  // namespace brunt::deck
// Tested by tests/unit/app/gravity_test.cpp.
