#include "tests/support/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace brunt::test {

double largest_eigenvalue_of(const Eigen::MatrixXd& matrix) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().real().maxCoeff();
}

double spectral_radius_of(const Eigen::MatrixXd& matrix) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

Eigen::VectorXd symmetric_eigenvalues_of(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

Eigen::MatrixXd tensile_part_of(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(matrix);
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).asDiagonal() *
         axes.eigenvectors().transpose();
}

}  // namespace brunt::test
