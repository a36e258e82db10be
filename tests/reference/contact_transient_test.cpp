// SPDX-License-Identifier: GPL-3.0-or-later
// The direct scheme against another program. Figures: CONTACT (E. Vollebregt, open source version
// of 2025-07-23), one row of 50 elements of 0.04 mm x 200 mm, G = 82000 N/mm^2, nu = 0.28, mu =
// 0.3, F_n = 35780 N, piecewise constant. Its bound is that of its own normal solver. Its traction
// has the sign of its force, so its creepage is the negative of ours.
#include <gtest/gtest.h>

#include <array>

#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::contact_transient_test {

using Row = std::array<double, 50>;

constexpr Row contact_bound = {
    6.18729, 11.6957, 14.8889, 17.4341, 19.5551, 21.3804, 22.9805, 24.3998, 25.6683, 26.8073,
    27.8329, 28.7571, 29.5895, 30.3375, 31.0074, 31.6041, 32.1315, 32.5935, 32.9922, 33.33,
    33.609,  33.8307, 33.996,  34.1055, 34.1604, 34.1604, 34.1055, 33.996,  33.8307, 33.609,
    33.33,   32.9922, 32.5935, 32.1315, 31.6041, 31.0074, 30.3375, 29.5895, 28.7571, 27.8329,
    26.8073, 25.6683, 24.3998, 22.9805, 21.3804, 19.5551, 17.4341, 14.8889, 11.6957, 6.18729};

// Steady rolling, creepage -0.00024, c = 1.
constexpr Row steady_traction = {
    6.18728, 11.6957, 14.8889, 17.4341, 19.5551, 21.3804, 22.9805, 24.3998, 25.6683, 26.8073,
    27.8329, 28.7571, 29.5895, 30.3376, 31.0075, 31.6041, 32.1316, 32.5934, 32.9921, 33.3301,
    29.5111, 25.1589, 22.9068, 21.149,  19.7043, 18.465,  17.3732, 16.3929, 15.4998, 14.6767,
    13.9105, 13.1915, 12.5118, 11.8649, 11.2454, 10.6488, 10.0709, 9.508,   8.9567,  8.41355,
    7.8751,  7.33766, 6.79708, 6.24842, 5.68542, 5.09953, 4.47814, 3.8006,  3.02498, 2.09194};

// A shift under 0.64 of full sliding.
constexpr Row cattaneo_traction = {
    6.18728, 11.6957, 14.8889, 17.4341, 19.5551, 21.3804, 22.9805, 24.3998, 25.6683, 26.8073,
    23.0581, 19.7911, 18.2608, 17.1763, 16.3681, 15.74,   15.241,  14.84,   14.5169, 14.2579,
    14.0534, 13.8965, 13.7826, 13.7083, 13.6717, 13.6717, 13.7083, 13.7826, 13.8965, 14.0534,
    14.2579, 14.5169, 14.84,   15.241,  15.74,   16.3681, 17.1763, 18.2608, 19.7911, 23.0581,
    26.8073, 25.6683, 24.3998, 22.9805, 21.3804, 19.5551, 17.4341, 14.8889, 11.6957, 6.18728};

struct Rolled {
  double step_ratio;
  Row traction;
};

// From that shift, under its force, after a distance of 25 elements.
constexpr std::array<Rolled, 5> rolled = {
    {{1,
      {6.18728, 11.6957, 14.8889, 17.4341, 19.5551, 21.3804, 22.9805, 24.3998, 25.6683, 26.8073,
       27.8329, 28.7571, 29.5895, 30.3376, 31.0075, 31.6041, 32.1316, 32.5934, 32.9921, 33.3301,
       33.6091, 33.8307, 33.9959, 31.9903, 21.5145, 14.557,  13.307,  12.3638, 11.6016, 10.969,
       10.4074, 9.91017, 9.46375, 9.06011, 8.6953,  8.34061, 8.00879, 7.70276, 7.40951, 7.11724,
       6.84899, 6.57995, 6.32476, 6.07922, 5.8684,  5.83121, 5.37785, 4.59268, 3.66235, 2.52667}},
     {0.5,
      {6.18728, 11.6957, 14.8889, 17.4341, 19.5551, 21.3804, 22.9805, 24.3998, 25.6683, 26.8073,
       27.8329, 28.7571, 29.5895, 30.3376, 31.0075, 31.6041, 32.1316, 32.5934, 32.9921, 33.3301,
       33.6091, 33.8307, 33.9959, 30.5532, 21.3879, 17.3507, 14.1835, 12.2774, 11.2225, 10.6388,
       10.2236, 9.82964, 9.4273,  9.0328,  8.66123, 8.31508, 7.99018, 7.68186, 7.38684, 7.10311,
       6.82877, 6.56094, 6.30734, 6.09729, 5.92844, 5.6888,  5.22088, 4.47644, 3.50147, 2.23504}},
     {0.2,
      {6.18728, 11.6957, 14.8889, 17.4341, 19.5551, 21.3804, 22.9805, 24.3998, 25.6683, 26.8073,
       27.8329, 28.7571, 29.5895, 30.3376, 31.0075, 31.6041, 32.1316, 32.5934, 32.9921, 33.3301,
       33.6091, 33.8307, 33.9959, 34.1056, 25.4938, 19.6704, 16.6753, 13.427,  10.6697, 8.34567,
       6.96546, 6.77915, 7.50547, 8.43731, 8.91022, 8.68943, 8.00058, 7.2758,  6.83586, 6.69583,
       6.62375, 6.412,   6.07659, 5.76162, 5.52203, 5.29243, 5.00078, 4.56637, 3.81436, 2.55833}},
     {0.1,
      {6.18728, 11.6957, 14.8889, 17.4341, 19.5551, 21.3804, 22.9805, 24.3998, 25.6683, 26.8073,
       27.8329, 28.7571, 29.5895, 30.3376, 31.0075, 31.6041, 32.1316, 32.5934, 32.9921, 33.3301,
       33.6091, 33.8307, 33.9959, 34.1056, 26.6435, 19.0156, 16.8781, 13.5923, 11.1056, 8.54381,
       6.61329, 6.00714, 6.82382, 8.23685, 9.15508, 9.07008, 8.26236, 7.29101, 6.60344, 6.41696,
       6.57988, 6.59465, 6.17776, 5.65205, 5.40882, 5.30515, 5.02232, 4.54416, 3.84004, 2.62159}},
     {0.05,
      {6.18728, 11.6957, 14.8889, 17.4341, 19.5551, 21.3804, 22.9805, 24.3998, 25.6683, 26.8073,
       27.8329, 28.7571, 29.5895, 30.3376, 31.0075, 31.6041, 32.1316, 32.5934, 32.9921, 33.3301,
       33.6091, 33.8307, 33.9959, 34.1056, 27.2008, 18.4982, 16.944,  13.6664, 11.2852, 8.7128,
       6.45165, 5.57717, 6.53108, 8.22631, 9.42058, 9.25082, 8.34226, 7.29354, 6.51212, 6.20547,
       6.50086, 6.78674, 6.33482, 5.52938, 5.28008, 5.38595, 5.08383, 4.4825,  3.83667, 2.66619}}}};

constexpr double dx = 0.04;
constexpr double force = 0.64 * 0.3 * 35780 / 200;  // per mm

Eigen::VectorXd to_vector(const Row& row) {
  return Eigen::Map<const Eigen::VectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
}

const StripKernel kernel({82000, 0.28}, 200);
const Grid grid({.half_width = 1, .elements = 50});

TabulatedBound bound() { return {1, grid.nodes(), to_vector(contact_bound)}; }

TransientRolling shifted() {
  TransientRolling rolling(
      {.contact = {kernel, bound()}, .grid = grid, .basis = constant_basis(), .scheme = Direct{}});
  rolling.start_from_shift({force});
  return rolling;
}

void expect_printed_digits(const Eigen::VectorXd& traction, const Row& expected) {
  const double largest = to_vector(contact_bound).maxCoeff();
  EXPECT_LT((traction - to_vector(expected)).lpNorm<Eigen::Infinity>(), 1e-5 * largest);
}

TEST(ContactReference, SteadyRolling) {
  const SteadySolution steady = solve_steady({.contact = {kernel, bound()},
                                              .grid = grid,
                                              .basis = constant_basis(),
                                              .method = Differences{},
                                              .load = PrescribedCreepage{-0.00024}});
  expect_printed_digits(steady.traction, steady_traction);
}

TEST(ContactReference, CattaneoShift) {
  expect_printed_digits(shifted().state().traction, cattaneo_traction);
}

TEST(ContactReference, TransientRolling) {
  for (const Rolled& reference : rolled) {
    TransientRolling rolling = shifted();
    rolling.roll(25 * dx, {reference.step_ratio * dx}, PrescribedForce{force},
                 [](const TransientState&) {});
    SCOPED_TRACE(reference.step_ratio);
    expect_printed_digits(rolling.state().traction, reference.traction);
  }
}

}  // namespace microslip::contact_transient_test
