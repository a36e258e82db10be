// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in which contact or friction is lost in one row and returns: bodies that part forget. The
// same runs with a tiny contact in the place of none, and with short steps, are the oracles.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "microslip/rolling/load_history.hpp"
#include "microslip/rolling/transient.hpp"
#include "samples.hpp"

namespace microslip::lost_contacts_test {

using Eigen::VectorXd;

enum class Lost { half_width, peak_traction, normal_load };

struct RunOfRows {
  VectorXd distance, creepage, size;  ///< rows
  Lost column;
};

RunOfRows generated(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  const Eigen::Index rows = 4 + static_cast<Eigen::Index>(seed % 3);
  RunOfRows run{.distance = VectorXd::Zero(rows),
                .creepage = VectorXd(rows),
                .size = VectorXd(rows),
                .column = static_cast<Lost>(seed % 3)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (i > 0) run.distance[i] = run.distance[i - 1] + between(1, 6);
    run.creepage[i] = between(2e-4, 2e-3);
    run.size[i] = between(0.5, 1.5);
  }
  run.size[1 + static_cast<Eigen::Index>(seed) % (rows - 2)] = 0;
  return run;
}

LoadHistory history_of(const RunOfRows& run, double in_place_of_zero) {
  RunRows rows;
  rows.distance = run.distance;
  rows.creepage = run.creepage;
  const VectorXd size = run.size.cwiseMax(in_place_of_zero);
  rows.of_problem = {.normal_load = 1000, .half_width = 5, .peak_traction = 300, .friction = 0.3};
  switch (run.column) {
    case Lost::half_width:
      rows.half_width = 5 * size;
      break;
    case Lost::peak_traction:
      rows.peak_traction = 300 * size;
      break;
    case Lost::normal_load:
      rows.normal_load = 1000 * size;
      break;
  }
  return LoadHistory(rows);
}

double last_force(const LoadHistory& loads, const std::vector<double>& lengths) {
  TransientRolling rolling({.contact = {StripKernel(Material(82000, 0.28), 10), HertzBound(5, 300)},
                            .grid = Grid({.half_width = 5, .elements = 40}),
                            .basis = constant_basis(),
                            .scheme = Remembered{}});
  rolling.roll(loads.distance(), lengths, loads, [](const TransientState&) {});
  return rolling.state().force;
}

std::vector<double> row_lengths(const LoadHistory& loads) {
  std::vector<double> lengths;
  for (std::size_t i = 1; i < loads.distances().size(); ++i) {
    lengths.push_back(loads.distances()[i] - loads.distances()[i - 1]);
  }
  return lengths;
}

unsigned seeds() { return static_cast<unsigned>(samples(60)); }

/// The contact of the last row grows from nothing over the last piece. Its force does not depend on
/// how nothing is written.
TEST(LostContacts, AreBegunWhereTheyReturn) {
  for (unsigned seed = 0; seed < seeds(); ++seed) {
    const RunOfRows run = generated(seed);
    const LoadHistory lost = history_of(run, 0);
    const LoadHistory tiny = history_of(run, 1e-9);
    const double by_rows = last_force(lost, row_lengths(lost));
    EXPECT_LT(by_rows, 0) << seed;
    EXPECT_NEAR(by_rows / last_force(tiny, row_lengths(tiny)), 1, 2e-3) << seed;
  }
}

/// A step may begin before the row in which contact is lost and end behind it.
TEST(LostContacts, AreForgottenWithinAStep) {
  for (unsigned seed = 0; seed < seeds(); ++seed) {
    const RunOfRows run = generated(seed);
    const LoadHistory lost = history_of(run, 0);
    const double fine = last_force(lost, {0.04});
    for (const double length : {0.31, 0.7}) {
      EXPECT_NEAR(last_force(lost, {length}) / fine, 1, 0.03) << seed << ' ' << length;
    }
  }
}

}  // namespace microslip::lost_contacts_test
