/// The bound on the time step against the true limit 2/omega of a single element, omega from the
/// eigenvalues of its stiffness, assembled column by column from the forces of the kernels on small
/// displacements (1e-6 of the size: nonlinear terms of 1e-6 relative).
#include "fe/element_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cstdio>

#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

struct Limit {
  Real bound;  ///< [s] the element's vote
  Real truth;  ///< [s] 2/omega
};

template <int Dim>
Limit limit_of(const Mesh<Dim>& mesh, const Material& material, const Variant& variant,
               Real kappa = 0.05) {
  ElementOptions options;
  options.bulk_viscosity = {0, 0};
  options.hourglass = StiffnessHourglass{kappa};
  constexpr int n = Shape<Dim>::kCorners * Dim;
  Eigen::Matrix<Real, n, n> K;
  Limit limit{};
  Real size = 1e-6;
  for (int k = 0; k < n; ++k) {
    auto body = make_body(mesh, material, variant, options);
    limit.bound = body->stable_step().step;
    std::vector<Vec<Dim>> x = body->points().x;
    x[k / Dim][k % Dim] += size;
    step_to(*body, x, 1e-3);
    const auto& p = body->points();
    for (int r = 0; r < n; ++r) K(r, k) = -p.f[r / Dim][r % Dim] / size / p.mass[r / Dim];
  }
  const Real omega2 = K.eigenvalues().real().maxCoeff();
  limit.truth = 2 / std::sqrt(omega2);
  return limit;
}

TEST(element_step, print) {
  for (const Real nu : {0.0, 0.3, 0.45}) {
    const Material material = elastic((1 + nu) * (1 - 2 * nu) / (1 - nu), nu, 1.0);
    for (const Variant& v : variants_of(3)) {
      for (const Vec<3>& size : {Vec<3>(1, 1, 1), Vec<3>(1, 1, .2), Vec<3>(1, 1, 5), Vec<3>(1, .5, .25)}) {
        const Limit l = limit_of(cell_mesh<3>(size, 0.0, 1), material, v);
        printf("%s nu %.2f box %.2f %.2f %.2f bound %.4f true %.4f ratio %.4f\n", name_of(v).c_str(), nu, size[0], size[1], size[2], l.bound, l.truth, l.bound / l.truth);
      }
      Real worst = 0, best = 9;
      for (unsigned s = 0; s < 30; ++s) {
        const Limit l = limit_of(cell_mesh<3>({1,1,1}, 0.25, s), material, v);
        worst = std::max(worst, l.bound / l.truth); best = std::min(best, l.bound / l.truth);
      }
      printf("   distorted .25: ratio %.4f .. %.4f\n", best, worst);
    }
    for (const Variant& v : variants_of(2)) {
      for (const Real radius : {0., 1., 100.}) {
        if (v.geometry == Geometry::plane_strain && radius > 0) continue;
      for (const Vec<2>& size : {Vec<2>(1, 1), Vec<2>(1, .2), Vec<2>(.2, 1)}) {
        const Limit l = limit_of(cell_mesh<2>(size, 0.0, 1, radius * size[0]), material, v);
        printf("%s nu %.2f r %.0f box %.2f %.2f bound %.4f true %.4f ratio %.4f\n", name_of(v).c_str(), nu, radius, size[0], size[1], l.bound, l.truth, l.bound / l.truth);
      }
      Real worst = 0, best = 9;
      for (unsigned s = 0; s < 30; ++s) {
        auto m = cell_mesh<2>({1,1}, 0.25, s, radius);
        if (radius == 0) m.points.x[0][0] = m.points.x[2][0] = 0;
        const Limit l = limit_of(m, material, v);
        worst = std::max(worst, l.bound / l.truth); best = std::min(best, l.bound / l.truth);
      }
      printf("   distorted .25: ratio %.4f .. %.4f\n", best, worst);
      }
    }
  }
}

}  // namespace
}  // namespace brunt
