// SPDX-License-Identifier: GPL-3.0-or-later
#include "row_parts.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/linalg/lu_factors.hpp"

namespace microslip {

using Eigen::Index;
using std::numbers::pi;

namespace {

constexpr int parts_across = 3;  ///< sub-rows of a row, on which v is constant across
constexpr int parts_along = 5;   ///< sub-cells of a cell, on which v is constant and p linear

/// Means of cos and sin over a part, with the weight of the tractions.
struct Means {
  double cos, sin;
};

/// Makes the stencil that is exact for 1, cos and sin at three centres; for 1 and one of them at
/// two; for 1 at one.
/// \param angle  of the first centre
/// \param step   from centre to centre
Stencil stencil(Index first, Index size, double angle, double step, const Means& mean,
                bool by_cos) {
  Stencil found{first, size, {1, 0, 0}};
  if (size == 2) {
    const auto value = [&](double at) { return by_cos ? std::cos(at) : std::sin(at); };
    const double from = value(angle), to = value(angle + step);
    const double part = ((by_cos ? mean.cos : mean.sin) - from) / (to - from);
    found.weights = {1 - part, part, 0};
  } else if (size == 3) {
    Eigen::MatrixXd values(3, 3);
    for (int j = 0; j < 3; ++j) {
      const double at = angle + j * step;
      values.col(j) = Eigen::Vector3d(1, std::cos(at), std::sin(at));
    }
    const Eigen::VectorXd weights = LuFactors(values).solve(Eigen::Vector3d(1, mean.cos, mean.sin));
    found.weights = {weights[0], weights[1], weights[2]};
  }
  return found;
}

}  // namespace

std::vector<SubCell> sub_cells(Index elements) {
  const Index size = parts_along * elements;
  const double step = pi / static_cast<double>(elements);
  std::vector<SubCell> parts;
  for (Index e = 0; e < size; ++e) {
    const double from = pi * static_cast<double>(e) / static_cast<double>(size);
    const double to = pi * static_cast<double>(e + 1) / static_cast<double>(size);
    const auto integral = [&](const auto& of) { return of(to) - of(from); };
    const double sum = integral([](double t) { return t - std::sin(t); });
    const double with_cos =
        integral([](double t) { return std::sin(t) - t / 2 - std::sin(2 * t) / 4; });
    const double with_sin =
        integral([](double t) { return -std::cos(t) - std::sin(t) * std::sin(t) / 2; });
    SubCell part{.width = std::cos(from) - std::cos(to),
                 .middle = (std::cos(from) + std::cos(to)) / 2,
                 .mean = 0,
                 .slope = 0,
                 .along = {}};
    part.mean = sum / part.width;
    part.slope = 12 * (with_cos - part.middle * sum) / std::pow(part.width, 3);
    // v is even in theta at both edges, so that two centres are enough there.
    const Index i = e / parts_along;
    const bool at_edge = i == 0 || i == elements - 1;
    const Index count = std::min<Index>(elements, at_edge ? 2 : 3);
    const Index first = std::clamp<Index>(i - 1, 0, elements - count);
    part.along = stencil(first, count, (static_cast<double>(first) + 0.5) * step, step,
                         {with_cos / sum, with_sin / sum}, true);
    parts.push_back(part);
  }
  return parts;
}

std::vector<SubRow> sub_rows(const Lobe& lobe, Index first_row, Index rows) {
  const Index size = parts_across * rows;
  const double step = pi / static_cast<double>(rows);
  std::vector<SubRow> parts;
  for (Index e = 0; e < size; ++e) {
    const double from = -pi / 2 + pi * static_cast<double>(e) / static_cast<double>(size);
    const double to = -pi / 2 + pi * static_cast<double>(e + 1) / static_cast<double>(size);
    const auto weighted = [&](const auto& of) {
      return lobe.integral(from, to,
                           [&](double psi) { return lobe.row(psi).half_length * of(psi); });
    };
    const double sum = weighted([](double) { return 1.0; });
    const double with_cos = weighted([](double psi) { return std::cos(psi); });
    const double with_sin = weighted([](double psi) { return std::sin(psi); });
    const Index count = std::min<Index>(rows, 3);
    const Index first = std::clamp<Index>(e / parts_across - 1, 0, rows - count);
    parts.push_back(
        {from, to,
         stencil(first_row + first, count, -pi / 2 + (static_cast<double>(first) + 0.5) * step,
                 step, {with_cos / sum, with_sin / sum}, false)});
  }
  return parts;
}

}  // namespace microslip
