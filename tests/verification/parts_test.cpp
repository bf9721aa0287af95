// Parts of a body, by place at time 0.
//   A slab, pulled by its end, with a hole's worth of points held: `cylinder` chooses what is
//   within
// the radius of its axis. On a cubic mesh of 1 mm about the axis, radius 1.2 mm, those are the five
// of a row of layers; in plane strain a disc, in axisymmetry about the axis of symmetry.
//   Measures of a part: temperatures that grow by 10 K a millimetre from the middle, by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "app/deck/where.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

TEST(Parts, ACylinderHoldsWhatIsWithinItsRadiusAndLength) {
  deck::WhereCylinder part;
  part.cylinder.radius = 2, part.cylinder.length = 3;
  part.cylinder.base = {1, 0, 0}, part.cylinder.axis = {2, 0, 0};
  const auto holds = [&](std::vector<Real> place) { return part.holds(place, 1e-9); };
  EXPECT_TRUE(holds({1, 0, 2}));
  EXPECT_TRUE(holds({4, 1.4, 1.4}));
  EXPECT_FALSE(holds({4, 1.5, 1.5}));
  EXPECT_FALSE(holds({0.9, 0, 0}));
  EXPECT_FALSE(holds({4.1, 0, 0}));
  part.geometry = Geometry::plane_strain, part.cylinder.base = {1, 1};
  EXPECT_TRUE(holds({1, 3}));
  EXPECT_FALSE(holds({2.5, 2.5}));
  part.geometry = Geometry::axisymmetric, part.cylinder.base = {0, 1};
  EXPECT_TRUE(holds({2, 4}));
  EXPECT_FALSE(holds({2, 0.9}));
  EXPECT_FALSE(holds({2.1, 2}));
}

TEST(Parts, WhatIsHeldInACylinderStays) {
  const std::string slab = R"(
title: A slab that is held about a bolt
geometry: 3d
time: {end: 2 us}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  slab:
    material: steel
    shape: {box: {min: [-5 mm, -5 mm, 0], max: [5 mm, 5 mm, 2 mm]}}
    size: 1 mm
    velocity: [10 m/s, 0, 0]
boundaries:
  bolt:
    body: slab
    where: {cylinder: {radius: 1.2 mm, length: 2 mm, base: [0, 0, 0], axis: z}}
    fix: [x, y, z]
)";
  const auto run = simulate_text(slab);
  ASSERT_EQ(run.failure, "");
  const auto& view = run.bodies.at("slab");
  const auto& v = field_named(view.point_fields, "velocity")->values;
  int held = 0;
  for (std::size_t i = 0; i < v.size(); i += 3) {
    const bool still = v[i] == 0 && v[i + 1] == 0 && v[i + 2] == 0;
    if (!still) continue;
    ++held;
    EXPECT_LT(std::hypot(view.position[i], view.position[i + 1]), 1.001e-3);
  }
  EXPECT_EQ(held, 3 * 5);
}

/// Quads of 1 mm, 8 x 4 of them; each starts with the velocity and the stress of its place, which
/// 1e-15 s change by 1e-10 m/s and 1 Pa.
std::string strip(const std::string& where) {
  return R"(
title: A strip
geometry: plane-strain
time: {end: 1e-15 s}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies:
  strip:
    material: steel
    shape: {box: {min: [0, 0], max: [8 mm, 4 mm]}}
    size: 1 mm
    velocity: ["= 1000*x", 0]
    stress: {xx: "= 1e9*x"}
measures:
  mean: {mean: {body: strip, field: velocity.x, )" +
         where + R"(}}
  least: {min: {body: strip, field: velocity.x, )" +
         where + R"(}}
  most: {max: {body: strip, field: velocity.x, )" +
         where + R"(}}
  stress: {mean: {body: strip, field: stress.xx, )" +
         where + R"(}}
)";
}

TEST(Parts, MeasuresOfABoxSeeItsPointsAndElements) {
  const auto run = simulate_text(strip("where: {box: {min: [2 mm, 0], max: [5 mm, 4 mm]}}"));
  EXPECT_NEAR(run.measures.at("least"), 2, 1e-9);
  EXPECT_NEAR(run.measures.at("most"), 5, 1e-9);
  EXPECT_NEAR(run.measures.at("mean"), 3.5, 1e-5);  // masses by the density under stress
  EXPECT_NEAR(run.measures.at("stress"), 3.5e6, 1);
}

TEST(Parts, MeasuresOfADiscDoToo) {
  const auto run = simulate_text(strip("where: {cylinder: {radius: 1.1 mm, base: [6 mm, 2 mm]}}"));
  EXPECT_NEAR(run.measures.at("least"), 5, 1e-9);
  EXPECT_NEAR(run.measures.at("most"), 7, 1e-9);
  EXPECT_NEAR(run.measures.at("stress"), 6e6, 1);
}

TEST(Parts, OfWhatErodesWhatIsLeftCounts) {
  const auto run = simulate_text(
      R"(
title: A part of a strip erodes
geometry: plane-strain
time: {end: 2 us}
materials: {lead: {density: 11340, elastic: {E: 16 GPa, nu: 0.44}, strength: {j2: {yield: 1 MPa}}}}
bodies:
  strip:
    material: lead
    shape: {box: {min: [0, 0], max: [8 mm, 1 mm]}}
    cells: [8, 1]
    erode: {when: {strain: 0.05}, to: nothing}
boundaries:
  ends: {body: strip, where: all, velocity: ["= x > 0.0035 ? 100 : 0", 0]}
measures:
  gap: {max: {body: strip, field: eps_p, where: {box: {min: [3 mm, 0], max: [4 mm, 1 mm]}}}}
  rest: {max: {body: strip, field: eps_p, where: {box: {min: [4 mm, 0], max: [8 mm, 1 mm]}}}}
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_TRUE(std::isnan(run.measures.at("gap")));
  EXPECT_EQ(run.measures.at("rest"), 0);
}

}  // namespace
}  // namespace brunt::test
