/// What no unit and no place may change: a scene of elements, particles, a rigid ball, friction and
/// plastic flow, of another size, and far from the origin.
/// - All lengths and times times L, with the same density, moduli and velocities, are the same
///   motion: stresses and strains stay, forces go by L^2, energies and impulses by L^3. A tolerance
///   in metres anywhere, or a number of joules, would show. L = 2^k only moves exponents, but logs
///   and roots round otherwise, and 825 steps of friction let that grow: 1e-10 of the largest value
///   of each column (measured 3e-11).
/// - Moved by X, every difference of places loses X/size digits: of 16, 6 at X = 1e6 sizes leave
///   1e-10 a step, and forces of contact, k times an overlap of some 1e-3 sizes, 1e-7. 1e-5 of the
///   largest value of each column (measured 1e-7). Torques are about the origin, and left out.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

std::string number(Real value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// The scene with lengths and times `scale` times as large, moved by `offset` [m] before that.
std::string scene(Real scale, const Vec3& offset) {
  const auto at = [&](Real x, Real y, Real z) {
    return "[" + number(scale * (x + offset[0])) + ", " + number(scale * (y + offset[1])) + ", " +
           number(scale * (z + offset[2])) + "]";
  };
  const auto length = [&](Real value) { return number(scale * value); };
  const auto box = [&](const std::string& from, const std::string& to, Real size) {
    return "shape: {box: {min: " + from + ", max: " + to + "}}, size: " + length(size);
  };
  return "title: of any size\ngeometry: 3d\ntime: {end: " + length(0x1p-9) +
         "}\noutput: {history: " + length(0x1p-13) + R"(}
materials:
  steel:
    {density: 7800, elastic: {E: 200e9, nu: 0.3}, strength: {j2: {yield: 400e6, hardening: 1e9}}}
  soft: {density: 1950, elastic: {E: 20e9, nu: 0.3}, strength: {j2: {yield: 100e6, hardening: 1e8}}}
contact: {default: {friction: 0.3}}
bodies:
  block: {material: steel, velocity: [30, 5, -60], )" +
         box(at(0, 0, 0.01), at(0.25, 0.25, 0.26), 0.0625) + R"(}
  plate: {material: soft, )" +
         box(at(-0.5, -0.5, -0.25), at(0.75, 0.75, 0), 0.125) + R"(}
  cloud: {method: sph, material: soft, velocity: [0, 0, -80], )" +
         box(at(0.3125, 0, 0.02), at(0.5625, 0.25, 0.27), 0.0625) + R"(}
  ball: {rigid: true, material: steel, velocity: [0, 0, -100], shape: {sphere: {center: )" +
         at(0.1, 0.1, 0.4) + ", radius: " + length(0.11) + "}}, size: " + length(0.04) + "}\n";
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// By which power of the length a column goes.
int power_of(const std::string& column) {
  if (column == "time" || column == "dt" || ends_with(column, "max_penetration")) return 1;
  if (column.find(".position") != column.npos) return 1;
  if (column.find(".velocity") != column.npos || column.find(".rotation") != column.npos) return 0;
  if (column.find(".spin") != column.npos) return -1;
  if (column.find(".force") != column.npos || ends_with(column, ".area")) return 2;
  if (ends_with(column, "heat_rate") || ends_with(column, "friction_heat")) return 2;  // [W]
  return 3;  // energies, masses, impulses, torques
}

/// True of columns that are no matter of size or place: counts, names, and a drift of rounding.
bool is_left_out(const std::string& column) {
  return column == "step" || column == "dt_body" || column == "energy.drift" ||
         ends_with(column, "planes");
}

Real largest(const std::vector<Real>& values) {
  Real most = 0;
  for (const Real value : values) most = std::max(most, std::fabs(value));
  return most;
}

void expect_same(const Simulation& one, const Simulation& other, Real scale, const Vec3& offset,
                 Real tolerance) {
  ASSERT_EQ(one.failure, "");
  ASSERT_EQ(other.failure, "");
  EXPECT_EQ(one.steps, other.steps);
  ASSERT_EQ(one.rows.size(), other.rows.size());
  for (const auto& column : one.columns) {
    if (is_left_out(column)) continue;
    const bool moved = offset.norm() > 0;
    if (moved && column.find(".torque") != column.npos) continue;
    const auto expected = one.column(column), found = other.column(column);
    const Real unit = std::pow(scale, power_of(column)), most = largest(expected);
    const auto axis = column.find(".position.");
    const Real shift = axis == column.npos ? 0.0 : offset[column[axis + 10] - 'x'];
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(found[k] / unit - shift, expected[k], tolerance * most) << column << " row " << k;
    }
  }
}

TEST(Scale, NanometresAndKilometresMoveAlike) {
  const Simulation metre = simulate_text(scene(1, Vec3::Zero()));
  for (const int exponent : {-30, 10}) {
    SCOPED_TRACE(exponent);
    const Real scale = std::ldexp(1.0, exponent);
    expect_same(metre, simulate_text(scene(scale, Vec3::Zero())), scale, Vec3::Zero(), 1e-10);
  }
}

TEST(Scale, AMillionSizesFromTheOriginItMovesAsAtIt) {
  const Simulation here = simulate_text(scene(1, Vec3::Zero()));
  const Vec3 far(1e6, 3e5, -2e5);
  expect_same(here, simulate_text(scene(1, far)), 1, far, 1e-5);
}

}  // namespace
}  // namespace brunt::test
