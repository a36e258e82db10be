// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/spectra.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <utility>

#include "../support/gsl.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A matrix in GSL's order of entries, which its functions overwrite.
using ByRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::size_t size(Index n) { return static_cast<std::size_t>(n); }

gsl_matrix_view view(ByRows& matrix) {
  return gsl_matrix_view_array(matrix.data(), size(matrix.rows()), size(matrix.cols()));
}

gsl_vector_view view(VectorXd& values) {
  return gsl_vector_view_array(values.data(), size(values.size()));
}

void require_success(int status, const char* what) {
  if (status != GSL_SUCCESS) throw NotConverged(what, 0, 0);
}

}  // namespace

Eigen::VectorXcd eigenvalues(const MatrixXd& matrix) {
  ByRows entries = matrix;
  Eigen::VectorXcd values(matrix.rows());
  gsl_matrix_view in = view(entries);
  gsl_vector_complex_view out =
      gsl_vector_complex_view_array(reinterpret_cast<double*>(values.data()), size(values.size()));
  const auto work = gsl::owned<gsl_eigen_nonsymm_workspace>(
      [&] { return gsl_eigen_nonsymm_alloc(size(matrix.rows())); }, gsl_eigen_nonsymm_free);
  require_success(
      gsl::quietly([&] { return gsl_eigen_nonsymm(&in.matrix, &out.vector, work.get()); }),
      "the eigenvalues of a matrix");
  std::sort(values.begin(), values.end(), [](const auto& a, const auto& b) {
    return std::pair(a.imag(), a.real()) < std::pair(b.imag(), b.real());
  });
  return values;
}

double least_eigenvalue(const MatrixXd& symmetric) {
  ByRows entries = symmetric;
  VectorXd values(symmetric.rows());
  gsl_matrix_view in = view(entries);
  gsl_vector_view out = view(values);
  const auto work = gsl::owned<gsl_eigen_symm_workspace>(
      [&] { return gsl_eigen_symm_alloc(size(symmetric.rows())); }, gsl_eigen_symm_free);
  require_success(gsl::quietly([&] { return gsl_eigen_symm(&in.matrix, &out.vector, work.get()); }),
                  "the eigenvalues of a symmetric matrix");
  return values.minCoeff();
}

double condition(const MatrixXd& matrix) {
  ByRows left = matrix;
  ByRows right(matrix.cols(), matrix.cols());
  VectorXd values(matrix.cols());
  gsl_matrix_view in_and_left = view(left), out = view(right);
  gsl_vector_view singular = view(values);
  require_success(gsl::quietly([&] {
                    return gsl_linalg_SV_decomp_jacobi(&in_and_left.matrix, &out.matrix,
                                                       &singular.vector);
                  }),
                  "the singular values of a matrix");
  return values.maxCoeff() / values.minCoeff();
}

}  // namespace microslip
