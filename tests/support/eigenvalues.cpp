#include "tests/support/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace brunt::test {

double largest_eigenvalue_of(const Eigen::MatrixXd& matrix) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().real().maxCoeff();
}

double spectral_radius_of(const Eigen::MatrixXd& matrix) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace brunt::test
