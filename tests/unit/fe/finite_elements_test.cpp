/// The solid as a whole: conservation, bits, checks, surface, view.
/// - Free elastic block with a random velocity field of 1e-4 of the sound speed, constant step: the
///   work of all channels equals the loss of 1/2 m v(n-1/2).v(n+1/2) to round-off: 1000 steps of
///   sums with relative error 1e-16 each, gate 1e-10 of the largest column.
/// - Momentum: corner forces of an element cancel to round-off, gate 1e-13 of sum m |v|.
#include "fe/finite_elements.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>

#include "core/errors.hpp"
#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

template <int Dim>
void shake(Points<Dim>& points, Real speed, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<Real> uniform(-speed, speed);
  for (auto& v : points.v) {
    for (int i = 0; i < Dim; ++i) v[i] = uniform(random);
  }
}

template <int Dim>
void expect_conservation() {
  const Material material = elastic(200e9, 0.3, 7850);
  const Real c = std::sqrt(material.modulus() / material.density);
  std::array<int, Dim> cells;
  cells.fill(3);
  Vec<Dim> corner = Vec<Dim>::Zero();
  for (const Variant& variant : variants_of(Dim)) {
    for (const Hourglass hourglass :
         {Hourglass{StiffnessHourglass{}}, Hourglass{ViscousHourglass{}}}) {
      SCOPED_TRACE(name_of(variant) + (hourglass.index() == 1 ? " viscous" : " stiffness"));
      const bool ring = variant.geometry == Geometry::axisymmetric;
      corner[0] = ring ? 1 : 0;
      ElementOptions options;
      options.hourglass = hourglass;
      auto body = make_body(box_mesh<Dim>(cells, corner, Vec<Dim>::Constant(1.0), 0.15), material,
                            variant, options);
      Points<Dim>& points = body->points();
      shake(points, 1e-4 * c, 3);
      Vec<Dim> before = Vec<Dim>::Zero();
      Real scale = 0;
      for (LocalIndex k = 0; k < points.size(); ++k) {
        before += points.mass[k] * points.v[k];
        scale += points.mass[k] * points.v[k].norm();
      }
      const Real dt = 0.5 * body->stable_step().step;
      const Real start = kinetic_energy(points, dt);
      for (int step = 0; step < 1000; ++step) step_free(*body, dt);
      const Totals<Dim> totals = totals_of(*body);
      Real sum = kinetic_energy(points, dt), most = start;
      for (const Column column : {Column::internal, Column::hourglass, Column::viscosity}) {
        sum += totals.value(column);
        most = std::max(most, totals.value(column));
      }
      EXPECT_NEAR(sum, start, 1e-10 * most);
      EXPECT_GT(totals.value(Column::internal), 1e-6 * start);
      EXPECT_GT(totals.value(Column::viscosity), 1e-3 * start);
      if (variant.integration == Integration::one_point) {
        EXPECT_GT(totals.value(Column::hourglass), 1e-6 * start);
      } else {
        EXPECT_EQ(totals.value(Column::hourglass), 0);
      }
      Vec<Dim> after = Vec<Dim>::Zero();
      for (LocalIndex k = 0; k < points.size(); ++k) after += points.mass[k] * points.v[k];
      for (int i = ring ? 1 : 0; i < Dim; ++i) {  // the radial component is no momentum
        EXPECT_NEAR(after[i], before[i], 1e-13 * scale);
      }
      body->check(0, {"block"});
    }
  }
}
TEST(finite_elements, conserves_energy_and_momentum_3d) { expect_conservation<3>(); }
TEST(finite_elements, conserves_energy_and_momentum_2d) { expect_conservation<2>(); }

template <int Dim>
struct Bits {
  std::vector<Vec<Dim>> x, v;
  std::uint64_t hash;
  Real step;
};

/// Ten steps of a block large enough for threads.
template <int Dim>
Bits<Dim> run_block(const Variant& variant, int threads, bool permuted) {
  const Material material = elastic(200e9, 0.3, 7850);
  std::array<int, Dim> cells;
  cells.fill(Dim == 3 ? 13 : 50);
  Vec<Dim> corner = Vec<Dim>::Zero();
  corner[0] = 1;
  Mesh<Dim> mesh = box_mesh<Dim>(cells, corner, Vec<Dim>::Constant(1.0), 0.2);
  if (permuted) {
    std::vector<std::size_t> order(mesh.set.id.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937_64(11));
    const ElementSet<Dim> set = mesh.set;
    for (std::size_t e = 0; e < order.size(); ++e) {
      mesh.set.id[e] = set.id[order[e]];
      mesh.set.corners[e] = set.corners[order[e]];
    }
  }
  omp_set_num_threads(threads);
  auto body = make_body(mesh, material, variant);
  shake(body->points(), 50.0, 5);
  const Real dt = 0.5 * body->stable_step().step;
  for (int step = 0; step < 10; ++step) step_free(*body, dt);
  return {body->points().x, body->points().v, totals_of(*body).state_hash,
          body->stable_step().step};
}

template <int Dim>
void expect_same_bits() {
  for (const Variant& variant : variants_of(Dim)) {
    if (variant.integration == Integration::full) continue;  // the kernel of q1p0
    SCOPED_TRACE(name_of(variant));
    const Bits<Dim> one = run_block<Dim>(variant, 1, false);
    const std::size_t bytes = one.x.size() * sizeof(Vec<Dim>);
    for (const bool permuted : {false, true}) {
      const Bits<Dim> two = run_block<Dim>(variant, 2, permuted);
      EXPECT_EQ(std::memcmp(one.x.data(), two.x.data(), bytes), 0);
      EXPECT_EQ(std::memcmp(one.v.data(), two.v.data(), bytes), 0);
      EXPECT_EQ(one.hash, two.hash);
      EXPECT_EQ(one.step, two.step);
    }
  }
}
TEST(finite_elements, bits_do_not_depend_on_threads_or_order_3d) { expect_same_bits<3>(); }
TEST(finite_elements, bits_do_not_depend_on_threads_or_order_2d) { expect_same_bits<2>(); }

TEST(finite_elements, what_lies_on_the_axis_stays_there) {
  // A cylinder stretched along r would pull its axis outwards: no radial force acts there.
  const Material material = elastic(200e9, 0.3, 7850);
  for (const Variant& variant : variants_of(2)) {
    if (variant.geometry != Geometry::axisymmetric) continue;
    auto body = make_body(box_mesh<2>({2, 2}, Vec<2>::Zero(), {1.0, 1.0}, 0.1), material, variant);
    std::vector<Vec<2>> x = body->points().x;
    for (auto& place : x) place[0] *= 1.01;
    step_to(*body, x, 1e-6);
    for (LocalIndex k = 0; k < body->points().size(); ++k) {
      if (x[k][0] == 0) {
        EXPECT_EQ(body->points().f[k][0], 0);
      } else if (x[k][0] > 1) {
        EXPECT_LT(body->points().f[k][0], 0);
      }
    }
  }
}

TEST(finite_elements, a_squeezed_element_is_named) {
  // The top of a unit cube moves down by 0.1 a step: flat after ten, inverted after eleven.
  const Material material = elastic(200e9, 0.3, 7850);
  for (const Variant& variant : variants_of(3)) {
    SCOPED_TRACE(name_of(variant));
    Mesh<3> mesh = cell_mesh<3>(Vec<3>::Ones(), 0.0, 1);
    mesh.set.id[0] = 1234;
    auto body = make_body(mesh, material, variant);
    std::vector<Vec<3>> x = body->points().x;
    for (int step = 0; step < 11; ++step) {
      body->check(0.5, {"cube"});
      for (auto& place : x) place[2] -= place[2] > 0.01 || step == 10 ? 0.1 : 0;
      if (step == 10) {
        for (int k = 0; k < 4; ++k) x[k][2] = 0;
      }
      step_to(*body, x, 1e-6);
    }
    try {
      body->check(0.5, {"cube"});
      FAIL() << "no error";
    } catch (const PhysicsError& error) {
      EXPECT_EQ(error.failure().quantity, "volume");
      // Elements of several Gauss points name the one that is turned inside out.
      const bool several = variant.integration != Integration::one_point;
      EXPECT_EQ(error.failure().entity.rfind("element 1234", 0), 0u);
      EXPECT_EQ(error.failure().entity.find(", Gauss point ") != std::string::npos, several);
      EXPECT_EQ(error.failure().body, "cube");
      EXPECT_EQ(error.failure().time, 0.5);
      EXPECT_LE(error.failure().value, 0);
    }
  }
}

TEST(finite_elements, a_stress_that_is_no_number_is_named) {
  const Material material = elastic(200e9, 0.3, 7850);
  auto body = make_body(box_mesh<3>({2, 1, 1}, Vec<3>::Zero(), {2.0, 1.0, 1.0}), material, {});
  body->check(0, {"a"});
  body->blocks()[0].state.pressure[1] = std::nan("");
  try {
    body->check(0, {"a"});
    FAIL() << "no error";
  } catch (const PhysicsError& error) {
    EXPECT_EQ(error.failure().quantity, "stress");
    EXPECT_EQ(error.failure().entity, "element 1");
  }
}

TEST(finite_elements, surface_of_two_bricks) {
  // 2 x 1 x 1 cells each, bricks without common nodes: 10 outer faces each, closed: sum A n = 0,
  // sum x . A n = 3 V. Faces at the ends have an element of depth 0.5 behind
  // them, all others one of depth 1 that is a plate: it lets go at its middle, at 0.5 as well.
  // Those are 0.5 wide, less than their depth, so that their springs are those of that length too.
  const Material material = elastic(200e9, 0.3, 7850);
  Mesh<3> a = box_mesh<3>({2, 1, 1}, Vec<3>::Zero(), Vec<3>::Ones());
  const Mesh<3> b = box_mesh<3>({2, 1, 1}, {0, 1.0, 0}, Vec<3>::Ones());
  for (int e = 0; e < 2; ++e) {
    auto corners = b.set.corners[e];
    for (auto& node : corners) node += a.points.size();
    a.set.corners.push_back(corners);
    a.set.id.push_back(static_cast<GlobalId>(2 + e));
    a.set.body.push_back(0);
    a.set.piece.push_back(1);
  }
  const LocalIndex half = a.points.size();
  a.points.x.insert(a.points.x.end(), b.points.x.begin(), b.points.x.end());
  for (auto* field : {&a.points.v, &a.points.a, &a.points.f}) {
    field->resize(a.points.x.size(), Vec<3>::Zero());
  }
  a.points.id.resize(a.points.x.size());
  a.points.piece.resize(a.points.x.size());
  auto body = make_body(a, material, {});
  const auto& facets = body->surface().facets;
  ASSERT_EQ(facets.size(), 20u);
  EXPECT_EQ(body->surface().points, &body->points());
  for (Label piece = 0; piece < 2; ++piece) {
    Vec<3> area = Vec<3>::Zero();
    Real volume = 0;
    for (std::size_t k = 0; k < facets.size(); ++k) {
      const auto& facet = facets[k];
      if (k > 0) {
        EXPECT_GT(facet.id, facets[k - 1].id);
      }
      if (facet.piece != piece) continue;
      Vec<3> x[4];
      for (int i = 0; i < 4; ++i) x[i] = body->points().x[facet.node[i]];
      EXPECT_EQ(facet.node[0] >= half, piece == 1);
      const Vec<3> normal = 0.5 * (x[2] - x[0]).cross(x[3] - x[1]);
      area += normal;
      volume += normal.dot(0.25 * (x[0] + x[1] + x[2] + x[3])) / 3;
      const bool end = std::abs(normal[0]) > 0.5;
      const Real depth = end ? 0.5 : 1.0;
      EXPECT_NEAR(facet.depth, 0.5, 1e-14);
      EXPECT_NEAR(facet.stiffness, material.modulus() / 0.5, 1e-3);
      EXPECT_NEAR(facet.areal_mass, 0.5 * 7850 * depth, 1e-9);
    }
    EXPECT_LT(area.norm(), 1e-14);
    EXPECT_NEAR(volume, 1.0, 1e-14);
  }
}

TEST(finite_elements, surface_in_2d) {
  // The body lies to the left of an edge, so (dy, -dx) points out; the edges on the axis of a
  // cylinder are no surface: 2 x 3 cells have 10 outer edges, 3 of them on the axis.
  const Material material = elastic(200e9, 0.3, 7850);
  for (const Geometry geometry : {Geometry::plane_strain, Geometry::axisymmetric}) {
    auto body = make_body(box_mesh<2>({2, 3}, Vec<2>::Zero(), {1.0, 1.5}), material, {geometry});
    const auto& facets = body->surface().facets;
    EXPECT_EQ(facets.size(), geometry == Geometry::axisymmetric ? 7u : 10u);
    for (const auto& facet : facets) {
      const Vec<2> a = body->points().x[facet.node[0]], b = body->points().x[facet.node[1]];
      const Vec<2> middle = 0.5 * (a + b) - Vec<2>(0.5, 0.75);
      EXPECT_GT(middle.dot(Vec<2>(b[1] - a[1], a[0] - b[0])), 0);
      EXPECT_NEAR(facet.depth, 0.5, 1e-14);
    }
  }
}

TEST(finite_elements, view_shows_one_body) {
  // Second of two cells, stretched by 1 % along x: density rho/1.01, p = K (1/1.01 - 1).
  const Material material = elastic(200e9, 0.3, 7850);
  Mesh<3> mesh = box_mesh<3>({2, 1, 1}, Vec<3>::Zero(), {2.0, 1.0, 1.0});
  mesh.set.body = {0, 1};
  mesh.set.piece = {0, 5};
  for (const Variant& variant : variants_of(3)) {
    auto body = make_body(mesh, material, variant);
    std::vector<Vec<3>> x = body->points().x;
    for (auto& place : x) place[0] *= 1.01;
    step_to(*body, x, 1e-6);
    const BodyView view = body->view(1);
    EXPECT_EQ(view.corners, 8);
    EXPECT_EQ(view.position.size(), 24u);
    ASSERT_EQ(view.connectivity.size(), 8u);
    EXPECT_EQ(view.position[3 * view.connectivity[6]], 2.02);
    EXPECT_EQ(view.position[3 * view.connectivity[6] + 2], 1.0);
    const auto field = [](const std::vector<Field>& fields, const std::string& name) {
      for (const Field& f : fields) {
        if (f.name == name) return f;
      }
      return Field{"missing", 0, {}};
    };
    EXPECT_NEAR(field(view.cell_fields, "density").values.at(0), 7850 / 1.01, 1e-9);
    const Real p = material.bulk * (1 / 1.01 - 1);
    EXPECT_NEAR(field(view.cell_fields, "pressure").values.at(0), p, 1e-9 * std::abs(p));
    const Real e = 0.01 / 1.005;
    EXPECT_NEAR(field(view.cell_fields, "von_mises").values.at(0), 2 * material.shear * e, 1);
    const auto stress = field(view.cell_fields, "stress");
    EXPECT_NEAR(stress.values.at(xx), 4.0 / 3 * material.shear * e - p, 1);
    EXPECT_NEAR(stress.values.at(yy), -2.0 / 3 * material.shear * e - p, 1);
    EXPECT_EQ(field(view.cell_fields, "piece").values.at(0), 5);
    EXPECT_EQ(field(view.cell_fields, "eps_p").components, 0);
    EXPECT_NEAR(view.cell_volume.at(0), 1.01, 1e-14);
    Real moved = 0;
    for (const Real u : field(view.point_fields, "displacement").values) moved += u;
    EXPECT_NEAR(moved, 4 * 0.01 + 4 * 0.02, 1e-13);
  }
}

}  // namespace
}  // namespace brunt
