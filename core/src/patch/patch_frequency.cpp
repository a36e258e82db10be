// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_frequency.hpp"

#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "microslip/linalg/lu_factors.hpp"
#include "microslip/support/require.hpp"
#include "slip_maps.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixX3cd;
using Eigen::MatrixXcd;
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
  edges_.noalias() = edges * inverse_;
  resultants_.noalias() = resultants_by_traction(rows) * inverse_;
}

MatrixX3cd PatchFrequencyResponse::displacements(double wave_number) const {
  require(wave_number >= 0 && wave_number <= 1e3, "wave_number", wave_number,
          "a number from 0 to 1000");
  const Index n = rows_.cells(), M = rows_.rows();
  MatrixX3cd by_motion = MatrixX3cd::Zero(2 * n, 3);
  MatrixXcd by_edge = MatrixXcd::Zero(n, M);
  for (Index k = 0; k < M; ++k) {
    for (Index i = 0; i < rows_.elements(); ++i) {
      const Index cell = rows_.cell(i, k);
      const double x = rows_.x(2 * i + 1, k), way = rows_.x(0, k) - x;
      const PhaseIntegrals integrals(wave_number, way);
      by_edge(cell, k) = std::polar(1.0, -wave_number * way);
      by_motion.row(cell) << -integrals.plain, 0, rows_.y(k) * integrals.plain;
      by_motion.row(n + cell) << 0, -integrals.plain, -(x * integrals.plain + integrals.first);
    }
  }
  MatrixXcd system = MatrixXcd::Identity(2 * M, 2 * M);
  system.leftCols(M) -= edges_.leftCols(n) * by_edge;
  system.rightCols(M) -= edges_.rightCols(n) * by_edge;
  const MatrixX3cd edge = system.partialPivLu().solve(edges_ * by_motion);
  by_motion.topRows(n).noalias() += by_edge * edge.topRows(M);
  by_motion.bottomRows(n).noalias() += by_edge * edge.bottomRows(M);
  return by_motion;
}

Eigen::Matrix3cd PatchFrequencyResponse::linear(double wave_number) const {
  return resultants_ * displacements(wave_number);
}

MatrixX3cd PatchFrequencyResponse::unknowns(double wave_number) const {
  return inverse_ * displacements(wave_number);
}

}  // namespace microslip
