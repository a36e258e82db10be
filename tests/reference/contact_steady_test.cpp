// SPDX-License-Identifier: GPL-3.0-or-later
// The direct scheme against another program. Figures: CONTACT (E. Vollebregt, open source version
// of 2025-07-23), one row of 25 elements of 0.08 mm x 200 mm, G = 82000 N/mm^2, nu = 0.28, steady
// rolling with creepage -0.00024, c = 1, piecewise constant. Its bound is that of its own normal
// solver. Its traction has the sign of its force, so its creepage is the negative of ours.
#include <gtest/gtest.h>

#include <array>

#include "microslip/rolling/steady.hpp"

namespace microslip::contact_steady_test {

constexpr std::array<double, 25> contact_bound = {
    8.70084, 16.2836, 20.4944, 23.7094, 26.2518, 28.3061, 29.9728, 31.314, 32.37,
    33.168,  33.7263, 34.0572, 34.1667, 34.0572, 33.7263, 33.168,  32.37,  31.314,
    29.9728, 28.3061, 26.2518, 23.7094, 20.4944, 16.2836, 8.70084};

constexpr std::array<double, 25> contact_traction = {
    8.70084, 16.2836, 20.4944, 23.7095, 26.2518, 28.3061, 29.9728, 31.3139, 32.3699,
    33.1679, 28.001,  22.1419, 19.2466, 17.0279, 15.2248, 13.6825, 12.3173, 11.0759,
    9.92037, 8.8208,  7.75035, 6.68057, 5.57482, 4.36909, 2.97732};

constexpr std::array<double, 25> contact_slip = {
    0.000707664, 0.00065348,  0.000598235, 0.000541603, 0.000483087,
    0.000421892, 0.000356599, 0.000284249, 0.00019607,  6.46861e-05,
    0,           0,           0,           0,           0,
    0,           0,           0,           0,           0,
    0,           0,           0,           0,           0};

TEST(ContactReference, SteadyTractionAndSlipAgreeToItsPrintedDigits) {
  const auto to_vector = [](const std::array<double, 25>& row) {
    return Eigen::Map<const Eigen::VectorXd>(row.data(), 25);
  };
  const Grid grid({.half_width = 1, .elements = 25});
  const SteadySolution state =
      solve_steady({.contact = {StripKernel({82000, 0.28}, 200),
                                TabulatedBound(1, grid.nodes(), to_vector(contact_bound))},
                    .grid = grid,
                    .basis = constant_basis(),
                    .method = Differences{},
                    .load = PrescribedCreepage{-0.00024}});
  const double largest = to_vector(contact_bound).maxCoeff();
  for (Eigen::Index i = 0; i < 25; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(state.traction[i], contact_traction[k], 1e-5 * largest) << i;
    EXPECT_NEAR(std::abs(state.slip[i]), contact_slip[k], 1e-8) << i;
    EXPECT_EQ(state.zones[k] == Zone::adhesion, contact_slip[k] == 0) << i;
  }
}

}  // namespace microslip::contact_steady_test
