// Adiabatic shear (C24): where heat softens steel more than strain hardens it, strain goes into one
// row of elements, however thin: halves of the size double its strain. Nothing in the
// law has a length that would stop it, so a run says that it happened (app/watch/shear_bands.hpp).
//   A layer of 4340 (Johnson & Cook 1985: A 792, B 510 MPa, n 0.26, m 1.03), 20 K hotter in its
// middle, is sheared by 1.2, mean plastic strain 0.69. Along the adiabatic curve the flow stress
// passes its maximum at 0.42 and has fallen by 7 % at 1.2: 10 rows have not localised by then,
// 20 rows and more have. Without heat it never falls.
//   A bar of the same steel that hits a wall at 500 m/s is strained by 3 at its foot, and softens
// there, over many elements: no band.
#include <gtest/gtest.h>

#include <cmath>

#include "app/watch/shear_bands.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kLayer = R"yaml(
title: A layer of steel is sheared until a band forms
geometry: plane-strain
parameters: {n: 40}
time: {end: 60 us}
heat: adiabatic
materials: {steel: {library: steel-4340}}
bodies:
  layer:
    material: steel
    shape: {box: {min: [0, 0], max: [0.1 mm, 1 mm]}}
    cells: [4, $n]
    temperature: "= 300 + 20*exp(-((y-0.5e-3)/0.1e-3)^2)"
boundaries:
  bottom: {body: layer, where: {side: min-y}, fix: [x, y]}
  top: {body: layer, where: {side: max-y}, velocity: [20 m/s, 0]}
  sides: {body: layer, where: all, fix: [y]}
measures: {most: {max: {body: layer, field: eps_p}}}
)yaml";

std::string band_warning(const Simulation& run) {
  for (const auto& warning : run.reported) {
    if (warning.text.starts_with("strain has localised")) return warning.id + ": " + warning.text;
  }
  return "";
}

TEST(ShearBand, IsToldWhereStrainLocalises) {
  Real before = 0;
  for (const char* n : {"20", "40"}) {
    const auto run = simulate_text(kLayer, {"parameters.n=" + std::string(n)});
    ASSERT_EQ(run.failure, "");
    EXPECT_EQ(band_warning(run).substr(0, 67),
              "bodies.layer.size: strain has localised in 4 elements of 'layer' th")
        << n;
    const Real most = run.measures.at("most");
    EXPECT_TRUE(before == 0 || std::fabs(most / before - 2) < 0.3) << most / before;
    before = most;
  }
}

TEST(ShearBand, IsNotToldWhereNoneIs) {
  EXPECT_EQ(band_warning(simulate_text(kLayer, {"parameters.n=10"})), "");
  EXPECT_EQ(band_warning(simulate_text(kLayer, {"heat=off"})), "");
  const auto bar = simulate_text(R"(
title: A bar of steel hits a wall
geometry: 3d
time: {end: 20 us}
heat: adiabatic
materials: {steel: {library: steel-4340}}
bodies:
  bar:
    material: steel
    shape: {cylinder: {radius: 4 mm, length: 12 mm, base: [0, 0, 0.01 mm], axis: z}}
    size: 1 mm
    velocity: [0, 0, -500 m/s]
  wall: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 40 mm}}}
measures: {most: {max: {body: bar, field: eps_p}}}
)");
  ASSERT_EQ(bar.failure, "");
  EXPECT_GT(bar.measures.at("most"), 1);
  EXPECT_EQ(band_warning(bar), "");
}

/// Rows of quads over the height, `across` of them side by side, with a strain each.
BodyView rows(const std::vector<Real>& strains, std::size_t across) {
  BodyView view;
  view.corners = 4;
  Field strain{"eps_p", 1, {}};
  const std::size_t stride = across + 1;
  view.position.resize(3 * stride * (strains.size() + 1));
  for (std::size_t row = 0; row < strains.size(); ++row) {
    for (std::size_t i = 0; i < across; ++i) {
      const auto first = static_cast<std::int64_t>(row * stride + i);
      const auto next = static_cast<std::int64_t>(stride);
      view.connectivity.insert(view.connectivity.end(),
                               {first, first + 1, first + 1 + next, first + next});
      strain.values.push_back(strains[row]);
    }
  }
  view.cell_fields.push_back(strain);
  return view;
}

TEST(ShearBand, CellsOfARowThatStandsOut) {
  EXPECT_EQ(localised_cells(rows({0.2, 0.2, 1, 0.2, 0.2}, 5)).size(), 5u);
  EXPECT_EQ(localised_cells(rows({1, 0.2, 0.2}, 5)).size(), 5u);                  // along a wall
  EXPECT_EQ(localised_cells(rows({0.2, 0.2, 0.8, 1, 0.2, 0.2}, 5)).size(), 10u);  // of two rows
  EXPECT_EQ(localised_cells(rows({0.2, 0.5, 1, 0.5, 0.2}, 5)).size(), 0u);
  EXPECT_EQ(localised_cells(rows({0.05, 0.05, 0.25, 0.05, 0.05}, 5)).size(), 0u);
  EXPECT_EQ(localised_cells(rows({1}, 5)).size(), 0u);
}

}  // namespace
}  // namespace brunt::test
