// Assumed-strain hourglass control is a potential of the positions. Forces are found again by
// central differences of it; it does not change where the element turns; and what single strains
// store is known: a rectangle of half edges a, b whose hourglass is h (1, 0) bends its fibres by
// h eta/a, so that U = int E' (h eta/a)^2/2 dV = V E' h^2/(6 a^2), with nothing for the shear
// h xi/b. A box twisted about x by theta' per length, u_y = -theta' x z, u_z = theta' x y, has the
// modes u_y of zeta xi and u_z of xi eta, and layers over y and over z that are sheared by
// theta' times y and z: U = G theta'^2 V (b^2 + c^2)/6 with half edges b, c. (For a square that is
// the polar moment of inertia, as of a bar whose section stays plane.)
#include "fe/assumed_strain.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

namespace brunt {
namespace {

constexpr BendingModuli kModuli = {3.0, 3.0 / (1 - 0.09), 0.3, 1.2};

template <int Dim>
struct Modes {
  Real h[Shape<Dim>::kHourglass][Dim] = {};
  Real l[Dim][Dim] = {};

  Real inverse[Dim];  ///< of the lengths at time 0

  Modes() { std::fill_n(inverse, Dim, 1.0); }
  void starts_here() {
    for (int i = 0; i < Dim; ++i)
      inverse[i] = 1 / std::hypot(l[i][0], l[i][1], l[i][Dim - 1] * (Dim - 2));
  }
  AssumedStrainEnergy<Dim, Real> energy(Real volume = 2) const {
    return {h, l, inverse, kModuli, volume};
  }
};

template <int Dim>
Modes<Dim> random_modes(std::mt19937& random) {
  std::uniform_real_distribution<Real> number(-1, 1);
  Modes<Dim> modes;
  for (auto& mode : modes.h) {
    for (Real& component : mode) component = number(random);
  }
  for (int i = 0; i < Dim; ++i) {
    for (int c = 0; c < Dim; ++c) modes.l[i][c] = (i == c ? 2 : 0) + 0.5 * number(random);
  }
  return modes;
}

template <int Dim>
void expect_forces_are_slopes() {
  std::mt19937 random(1);
  constexpr Real kStep = 1e-5;  // errors of second order, 1e-10, and of rounding, 1e-11
  for (int repeat = 0; repeat < 20; ++repeat) {
    Modes<Dim> modes = random_modes<Dim>(random);
    const auto exact = modes.energy();
    const auto slope = [&](Real& place) {
      const Real at = place;
      place = at + kStep;
      const Real above = modes.energy().energy;
      place = at - kStep;
      const Real below = modes.energy().energy;
      place = at;
      return (above - below) / (2 * kStep);
    };
    for (int c = 0; c < Dim; ++c) {
      for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
        EXPECT_NEAR(exact.by_hourglass[a][c], slope(modes.h[a][c]), 1e-8 * exact.energy);
      }
      for (int i = 0; i < Dim; ++i) {
        EXPECT_NEAR(exact.by_linear[i][c], slope(modes.l[i][c]), 1e-8 * exact.energy);
      }
    }
  }
}

TEST(AssumedStrain, ForcesAreSlopesOfTheEnergy) {
  expect_forces_are_slopes<2>();
  expect_forces_are_slopes<3>();
}

TEST(AssumedStrain, TurningChangesNothing) {
  std::mt19937 random(2);
  const Modes<3> modes = random_modes<3>(random);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  Modes<3> turned;
  const auto rotate = [&](const Real(&from)[3], Real(&to)[3]) {
    Eigen::Map<Eigen::Vector3d>(to, 3) = turn * Eigen::Map<const Eigen::Vector3d>(from, 3);
  };
  for (int a = 0; a < 4; ++a) rotate(modes.h[a], turned.h[a]);
  for (int i = 0; i < 3; ++i) rotate(modes.l[i], turned.l[i]);
  EXPECT_NEAR(turned.energy().energy, modes.energy().energy, 1e-14 * modes.energy().energy);
}

TEST(AssumedStrain, BendingOfARectangle) {
  const Real a = 0.7, b = 0.2, h = 0.01, volume = 4 * a * b;
  Modes<2> modes;
  modes.l[0][0] = a, modes.l[1][1] = b, modes.h[0][0] = h;
  modes.starts_here();
  EXPECT_NEAR(modes.energy(volume).energy, volume * kModuli.plate * h * h / (6 * a * a), 1e-18);
}

// Curvature about z and the anticlastic one that makes it uniaxial: E, not E/(1 - nu^2).
TEST(AssumedStrain, BendingOfABoxIsUniaxialWhereItsSidesAreFree) {
  const Real a = 0.7, b = 0.2, c = 0.4, h = 0.01, volume = 8 * a * b * c;
  Modes<3> modes;
  modes.l[0][0] = a, modes.l[1][1] = b, modes.l[2][2] = c;
  modes.starts_here();
  modes.h[2][0] = h;                          // u_x = h xi eta
  modes.h[0][2] = -kModuli.nu * h * (c / a);  // u_z, which leaves sigma_zz = 0
  EXPECT_NEAR(modes.energy(volume).energy, volume * kModuli.uniaxial * h * h / (6 * a * a), 1e-16);
}

TEST(AssumedStrain, TwistOfABox) {
  const Real a = 0.7, b = 0.2, c = 0.4, twist = 0.03, volume = 8 * a * b * c;
  Modes<3> modes;
  modes.l[0][0] = a, modes.l[1][1] = b, modes.l[2][2] = c;
  modes.starts_here();
  modes.h[1][1] = -twist * a * c;
  modes.h[2][2] = twist * a * b;
  EXPECT_NEAR(modes.energy(volume).energy,
              kModuli.shear * twist * twist * volume * (b * b + c * c) / 6, 1e-17);
}

}  // namespace
}  // namespace brunt
