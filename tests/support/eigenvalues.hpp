#pragma once
#include <Eigen/Core>

namespace brunt::test {

/// Largest real part of the eigenvalues of a square matrix; of D^-1 A too, where D is diagonal and
/// A symmetric, whose eigenvalues are real. Compiled once, without sanitizers: Eigen's solvers take
/// a minute of the compiler's time with them in each file that names one.
double largest_eigenvalue_of(const Eigen::MatrixXd& matrix);

/// Largest absolute value of the eigenvalues.
double spectral_radius_of(const Eigen::MatrixXd& matrix);

/// Eigenvalues of a symmetric matrix, ascending.
Eigen::VectorXd symmetric_eigenvalues_of(const Eigen::MatrixXd& matrix);

/// sum of w e (x) e over the eigenvalues w > 0 of a symmetric matrix, e their unit vectors.
Eigen::MatrixXd tensile_part_of(const Eigen::MatrixXd& matrix);

}  // namespace brunt::test
