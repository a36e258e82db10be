// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of different material by elements, against the inversion, which shares no equations with
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "microslip/reference/carter.hpp"
#include "microslip/rolling/steady.hpp"

namespace microslip::unlike_contacts_test {

using Eigen::Index;

// Next to full sliding an end of a zone that is known to a part of an element decides on the
// creepage. Among 1024 contacts like these 38 were wrong by more than 10 %, of the creepage or the
// creepage of like bodies, whichever is larger, and 113 were warned of.
TEST(UnlikeContacts, LargeErrorsAreDoubted) {
  constexpr Material material{1, 0.28};
  const HertzBound bound(1, 1);
  std::mt19937 random(5);
  const auto between = [&](double from, double to) {
    return std::exp(std::uniform_real_distribution<double>(std::log(from), std::log(to))(random));
  };
  int large = 0, doubted = 0;
  for (int k = 0; k < 300; ++k) {
    const double strain_ratio = between(0.01, 100);
    const double part = (1 - between(3e-3, 1)) * (k % 2 == 0 ? 1 : -1);
    const auto elements = static_cast<Index>(between(20, 400));
    SteadyProblem problem{
        .contact = {PlaneKernel(material, 10), bound, strain_ratio * compliance(material)},
        .grid = Grid({.half_width = 1, .elements = elements}),
        .method = Inversion{},
        .load = PrescribedForce{-part * bound.total()}};
    const SteadySolution exact = solve_steady(problem);
    if (exact.scheme != SteadyScheme::inversion) continue;
    problem.method = Calibrated{};
    const SteadySolution found = solve_steady(problem);
    const double of_like =
        Carter::from_force(material, bound, std::abs(part) * bound.total()).creepage();
    const double error = std::abs(found.creepage - exact.creepage) /
                         std::max(std::abs(exact.creepage), std::abs(of_like));
    const bool doubt = doubt_of(found.evidence, Acceptance{}, true).has_value();
    EXPECT_TRUE(doubt || error < 0.06) << "beta/mu = " << strain_ratio << ", force " << part
                                       << ", N = " << elements << ": " << error;
    large += error > 0.1 ? 1 : 0;
    doubted += doubt ? 1 : 0;
  }
  EXPECT_GE(large, 3);
  EXPECT_LE(doubted, 60);
}

}  // namespace microslip::unlike_contacts_test
