// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_frequency.hpp"

#include <Eigen/Core>
#include <cmath>
#include <complex>

#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/matrix_product.hpp"
#include "microslip/support/require.hpp"
#include "slip_maps.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixX3cd;
using Eigen::MatrixXd;
using std::complex;

namespace {

/// Integrals of exp(-i kappa s) and of s exp(-i kappa s), s from 0 to a length.
struct PhaseIntegrals {
  complex<double> plain, first;

  PhaseIntegrals(double wave_number, double length) {
    constexpr double short_wave = 0.5;
    const complex<double> i(0, 1);
    const complex<double> angle = -i * wave_number * length;
    if (std::abs(angle) < short_wave) {  // closed forms cancel
      complex<double> term = 1;
      plain = first = 0;
      for (int n = 0; n < 16; ++n) {
        plain += term / (n + 1.0);
        first += term / (n + 2.0);
        term *= angle / (n + 1.0);
      }
    } else {
      const complex<double> at_end = std::exp(angle);
      plain = (at_end - 1.0) / angle;
      first = (at_end - plain) / angle;
    }
    plain *= length;
    first *= length * length;
  }
};

MatrixX3cd complex_of(const MatrixXd& parts) {
  MatrixX3cd numbers(parts.rows(), 3);
  numbers.real() = parts.leftCols(3);
  numbers.imag() = parts.rightCols(3);
  return numbers;
}

}  // namespace

PatchFrequencyResponse::PatchFrequencyResponse(const JoinedRows& rows, double poisson_ratio)
    : rows_(rows) {
  const PatchResponse::Matrix displacement = displacement_by_traction(rows, poisson_ratio);
  const Index n = rows.cells(), M = rows.rows();
  MatrixXd centres(2 * n, 2 * n), edges(2 * M, 2 * n);
  for (Index c = 0; c < 2; ++c) {
    for (Index k = 0; k < M; ++k) {
      edges.row(c * M + k) = displacement.row(c * rows.points() + rows.point(0, k));
      for (Index i = 0; i < rows.elements(); ++i) {
        centres.row(c * n + rows.cell(i, k)) =
            displacement.row(c * rows.points() + rows.point(2 * i + 1, k));
      }
    }
  }
  inverse_ = LuFactors(centres).inverse();
  edges_ = matrix_product(edges, inverse_);
  resultants_ = matrix_product(resultants_by_traction(rows), inverse_);
}

MatrixXd PatchFrequencyResponse::displacements(double wave_number) const {
  require(wave_number >= 0 && wave_number <= 1e3, "wave_number", wave_number,
          "a number from 0 to 1000");
  const Index n = rows_.cells(), M = rows_.rows(), N = rows_.elements();
  MatrixXd by_motion = MatrixXd::Zero(2 * n, 6);
  MatrixXd by_edge(n, 2);  // real and imaginary part, of the edge of the cell's row
  for (Index k = 0; k < M; ++k) {
    for (Index i = 0; i < N; ++i) {
      const Index cell = rows_.cell(i, k);
      const double x = rows_.x(2 * i + 1, k), way = rows_.x(0, k) - x;
      const PhaseIntegrals integrals(wave_number, way);
      by_edge.row(cell) << std::cos(wave_number * way), -std::sin(wave_number * way);
      const auto set = [&](Index component, Index motion, complex<double> value) {
        by_motion(component * n + cell, motion) = value.real();
        by_motion(component * n + cell, 3 + motion) = value.imag();
      };
      set(0, 0, -integrals.plain);
      set(0, 2, rows_.y(k) * integrals.plain);
      set(1, 1, -integrals.plain);
      set(1, 2, -(x * integrals.plain + integrals.first));
    }
  }
  // u(e) = edges (by_motion m + by_edge u(e)), real parts above imaginary ones.
  MatrixXd system = MatrixXd::Identity(4 * M, 4 * M);
  MatrixXd right(4 * M, 3);
  const MatrixXd edges_by_motion = matrix_product(edges_, by_motion);
  right << edges_by_motion.leftCols(3), edges_by_motion.rightCols(3);
  for (Index c = 0; c < 2; ++c) {
    for (Index k = 0; k < M; ++k) {
      const Index column = c * M + k, first = rows_.cell(0, k);
      const MatrixXd parts =
          matrix_product(edges_.middleCols(c * n + first, N), by_edge.middleRows(first, N));
      system.col(column).head(2 * M) -= parts.col(0);
      system.col(column).tail(2 * M) -= parts.col(1);
      system.col(2 * M + column).head(2 * M) += parts.col(1);
      system.col(2 * M + column).tail(2 * M) -= parts.col(0);
    }
  }
  const MatrixXd edge = LuFactors(system).solve_columns(right);
  for (Index c = 0; c < 2; ++c) {
    for (Index cell = 0; cell < n; ++cell) {
      const auto real = edge.row(c * M + cell / N), imaginary = edge.row((2 + c) * M + cell / N);
      const double cosine = by_edge(cell, 0), sine = by_edge(cell, 1);
      by_motion.row(c * n + cell).head(3) += cosine * real - sine * imaginary;
      by_motion.row(c * n + cell).tail(3) += cosine * imaginary + sine * real;
    }
  }
  return by_motion;
}

Eigen::Matrix3cd PatchFrequencyResponse::linear(double wave_number) const {
  return complex_of(matrix_product(resultants_, displacements(wave_number)));
}

MatrixX3cd PatchFrequencyResponse::unknowns(double wave_number) const {
  return complex_of(matrix_product(inverse_, displacements(wave_number)));
}

}  // namespace microslip
