// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_file.hpp"

#include <cmath>
#include <string>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

void require_below_full_sliding(const Eigen::VectorXd& forces, const TractionBound& bound) {
  const double most = full_sliding_force(bound);
  for (Eigen::Index i = 0; i < forces.size(); ++i) {
    if (std::abs(forces[i]) < most) continue;
    require(false, "row " + std::to_string(i + 1) + ": force", forces[i],
            "an absolute value below full sliding, " + format_short(most));
  }
}

}  // namespace

LoadHistory read_run(Scene& scene, const TractionBound& bound) {
  const std::vector<FileColumn> wanted = {{"q", "mm", false},       {"t", "s", false},
                                          {"v", "mm/s", false},     {"creepage", "1", false},
                                          {"force", "N/mm", false}, {"omega", "1/s", false}};
  RunRows rows = scene.from_columns("load.file", wanted, [](const auto& columns) {
    return RunRows{.distance = columns[0],
                   .time = columns[1],
                   .velocity = columns[2],
                   .creepage = columns[3],
                   .force = columns[4],
                   .angular_velocity = columns[5]};
  });
  if (rows.angular_velocity) rows.radius = scene.positive("load.radius");
  return scene.with_file("load.file", [&] {
    if (rows.force) require_below_full_sliding(*rows.force, bound);
    return LoadHistory(rows);
  });
}

std::vector<double> row_ratios(const LoadHistory& loads, double spacing) {
  std::vector<double> ratios;
  const std::vector<double>& rows = loads.distances();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ratios.push_back((rows[i] - rows[i - 1]) / spacing);
  }
  return ratios;
}

}  // namespace microslip
