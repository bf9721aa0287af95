// docs/theory/sph.md (S9a) to (S9c). Moments K = sum c_j r_j (x) r_j of arms in a plane, on a line,
// or nearly so, c > 0; rates R = G K of affine motions G, and any rates.
// - A turn W strains nothing: R = W K, A = W Q (Q = B K, eigenvalues w), and S_ab =
//   (w_a W_ab w_b + w_b W_ba w_a)/(w_a + w_b) = 0.
// - Where the neighbourhood is complete (w = 1), L = R K^-1.
// - The pair stress T B has the power sigma : L on any R, and T B K is symmetric: forces have no
//   moment (docs/theory/sph.md (S13), (S14)).
// Rounding: eigenvectors to 1e-15, divided by shares of 0.15^8 = 3e-7 at the least seen here.
#include "sph/thin_moment.hpp"

#include <gtest/gtest.h>

#include <random>

namespace brunt {
namespace {

template <int Dim>
using Square = Eigen::Matrix<Real, Dim, Dim>;
template <int Dim>
using Rows = Eigen::Matrix<Real, Dim, Dim, Eigen::RowMajor>;

/// Random numbers, and neighbourhoods that are `flat` times as thick as wide along some axes.
template <int Dim>
struct Draw {
  std::mt19937_64 random{11};

  Real number() { return static_cast<Real>(random() >> 11) * 0x1p-52 - 1; }
  Square<Dim> matrix() {
    Square<Dim> m;
    for (int k = 0; k < Dim * Dim; ++k) m(k / Dim, k % Dim) = number();
    return m;
  }
  Square<Dim> turn() {
    const Square<Dim> m = matrix();
    return m - m.transpose();
  }
  Square<Dim> moment(int thin_axes, Real flat) {
    const Square<Dim> W = turn(), one = Square<Dim>::Identity();
    const Square<Dim> axes = (one - W).inverse() * (one + W);  // Cayley: a rotation
    Square<Dim> K = Square<Dim>::Zero();
    for (int j = 0; j < 20; ++j) {
      Vec<Dim> arm;
      for (int d = 0; d < Dim; ++d) arm[d] = number() * (d < thin_axes ? flat : 1);
      arm = axes * arm;
      K += 0.05 * (1 + 0.5 * number()) * arm * arm.transpose();
    }
    return K;
  }
};

template <int Dim>
ThinMoment<Dim> thin_of(const Square<Dim>& K) {
  Real moment[kSymmetric<Dim>];
  for (int a = 0; a < Dim; ++a) {
    for (int b = a; b < Dim; ++b) moment[symmetric_place<Dim>(a, b)] = K(a, b);
  }
  return thin_moment<Dim>(moment);
}

template <int Dim>
Square<Dim> gradient_of(const Square<Dim>& R, const ThinMoment<Dim>& thin) {
  Real rate[Dim * Dim], gradient[Dim * Dim];
  Eigen::Map<Rows<Dim>>{rate} = R;
  thin_gradient<Dim>(rate, thin, gradient);
  return Eigen::Map<Rows<Dim>>{gradient};
}

template <int Dim, class F>
void for_neighbourhoods(const F& f) {
  Draw<Dim> draw;
  for (int thin_axes = 0; thin_axes < Dim; ++thin_axes) {
    for (const Real flat : {0.0, 1e-3, 0.1, 0.35, 0.5, 0.8}) {
      for (int k = 0; k < 20; ++k) f(draw, draw.moment(thin_axes, flat), thin_axes, flat);
    }
  }
}

template <int Dim>
void turns_strain_nothing() {
  for_neighbourhoods<Dim>([](Draw<Dim>& draw, const Square<Dim>& K, int, Real) {
    const Square<Dim> W = draw.turn();
    const Square<Dim> L = gradient_of<Dim>(W * K, thin_of<Dim>(K));
    EXPECT_LT((L + L.transpose()).norm(), 1e-12 * W.norm()) << K;
  });
}
TEST(ThinMoment, TurnsStrainNothing) { turns_strain_nothing<2>(), turns_strain_nothing<3>(); }

template <int Dim>
void powers_agree() {
  for_neighbourhoods<Dim>([](Draw<Dim>& draw, const Square<Dim>& K, int, Real) {
    const auto thin = thin_of<Dim>(K);
    const Square<Dim> R = draw.matrix(), m = draw.matrix(), sigma = m + m.transpose();
    const Square<Dim> pair = thin_stress<Dim>(sigma, thin);
    const Real power = sigma.cwiseProduct(gradient_of<Dim>(R, thin)).sum();
    EXPECT_NEAR(pair.cwiseProduct(R).sum(), power, 1e-12 * sigma.norm() * thin.inverse.norm());
    const Square<Dim> moment = pair * K;
    EXPECT_LT((moment - moment.transpose()).norm(), 1e-12 * sigma.norm());
  });
}
TEST(ThinMoment, ThePairStressHasThePowerOfTheStrainAndNoMoment) {
  powers_agree<2>(), powers_agree<3>();
}

template <int Dim>
void sheets_turn_with_their_normal() {
  for_neighbourhoods<Dim>([](Draw<Dim>& draw, const Square<Dim>& K, int thin_axes, Real flat) {
    if (flat != 0 || thin_axes != 1) return;
    const auto thin = thin_of<Dim>(K);
    const Square<Dim> W = draw.turn();
    EXPECT_LT((gradient_of<Dim>(W * K, thin) - W).norm(), 1e-11 * W.norm());
  });
}
TEST(ThinMoment, TheNormalOfASheetTurnsWithIt) {
  sheets_turn_with_their_normal<2>(), sheets_turn_with_their_normal<3>();
}

template <int Dim>
void complete_ones_are_inverted() {
  int seen = 0;
  for_neighbourhoods<Dim>([&](Draw<Dim>& draw, const Square<Dim>& K, int, Real) {
    const auto thin = thin_of<Dim>(K);
    if (thin.share.minCoeff() < 1) return;
    ++seen;
    const Square<Dim> R = draw.matrix(), inverse = K.inverse();
    EXPECT_LT((gradient_of<Dim>(R, thin) - R * inverse).norm(), 1e-12 * inverse.norm());
  });
  EXPECT_GT(seen, 20);
}
TEST(ThinMoment, CompleteNeighbourhoodsHaveTheInverse) {
  complete_ones_are_inverted<2>(), complete_ones_are_inverted<3>();
}

// What invert_thick takes, thin_moment counts in full: the two agree where they meet.
TEST(ThinMoment, TheFastInverseTakesCompleteNeighbourhoodsAlone) {
  int thick = 0;
  for_neighbourhoods<3>([&](Draw<3>&, const Square<3>& K, int, Real) {
    Real moment[6], inverse[6];
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) moment[symmetric_place<3>(a, b)] = K(a, b);
    }
    if (!invert_thick<3>(moment, inverse)) return;
    ++thick;
    EXPECT_EQ(thin_moment<3>(moment).share.minCoeff(), 1);
  });
  EXPECT_GT(thick, 20);
}

// A pair, or a straight row, knows of one direction: K = c r (x) r, rounded in each component. Its
// determinant and cofactors are rounding alone; of 2 % of all directions their quotient is that of
// a thick neighbourhood, with |B| up to 50. B r = r/(c r^2) is along the pair, and nothing across.
TEST(ThinMoment, APairIsThinInWhateverDirection) {
  Draw<3> draw;
  for (int k = 0; k < 10000; ++k) {
    const Vec<3> arm{draw.number(), draw.number(), draw.number()};
    const Real weight = (0.02 + 0.3 * std::abs(draw.number())) / arm.squaredNorm();
    Real moment[6], inverse[6];
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) moment[symmetric_place<3>(a, b)] = weight * arm[a] * arm[b];
    }
    ASSERT_FALSE(invert_thick<3>(moment, inverse)) << arm.transpose();
    invert_moment<3>(moment, inverse);
    const Square<3> along =
        arm * arm.transpose() / (weight * arm.squaredNorm() * arm.squaredNorm());
    ASSERT_LT((full_matrix<3>(inverse) - along).norm(), 1e-12 * along.norm()) << arm.transpose();
  }
}

// Two layers at 0.3 of their distance: K tells them from a warped sheet no longer, directions do.
TEST(ThinMoment, LayersThatArePressedTogetherCountInFull) {
  const Real pressed[6] = {0.6, 0.6, 0.03, 0, 0, 0};
  const Real of_layers[6] = {1, 1, 0.34, 0, 0, 0}, of_a_sheet[6] = {1, 1, 0.05, 0, 0, 0};
  EXPECT_NEAR(thin_moment<3>(pressed).share.minCoeff(), std::pow(0.05 / 0.15, 8), 1e-12);
  EXPECT_EQ(thin_moment<3>(pressed, &of_layers).share.minCoeff(), 1);
  EXPECT_NEAR(thin_moment<3>(pressed, &of_a_sheet).share.minCoeff(), std::pow(0.05 / 0.15, 8),
              1e-12);
  const Real hardly[6] = {0.6, 0.6, 0.01, 0, 0, 0};  // no longer: B would be 100 and more
  EXPECT_NEAR(thin_moment<3>(hardly, &of_layers).share.minCoeff(), std::pow(0.5, 8), 1e-12);
}

}  // namespace
}  // namespace brunt
