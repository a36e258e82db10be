// SPDX-License-Identifier: GPL-3.0-or-later
// Steady rolling in the C interface: Carter's closed form at generated loads, what must not change
// the answer, and what is refused.
#include "microslip/rolling/steady.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "c99.h"
#include "handle.hpp"
#include "microslip/reference/carter.hpp"

namespace microslip::steady_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Solved {
  microslip_status status;
  std::string message;
  std::vector<microslip_steady> states;
  std::vector<double> x, traction, slip;
};

Solved solve(const Parts& parts, int type, const std::vector<double>& loads) {
  const auto size = loads.size() * static_cast<std::size_t>(std::max(parts.grid.elements, 0));
  Solved solved{.status = MICROSLIP_OK,
                .message = "",
                .states = std::vector<microslip_steady>(loads.size()),
                .x = std::vector<double>(size),
                .traction = std::vector<double>(size),
                .slip = std::vector<double>(size)};
  const microslip_steady_nodes nodes{solved.x.data(), nullptr, solved.traction.data(),
                                     solved.slip.data(), nullptr};
  char text[512] = "";
  solved.status = microslip_solve_steady(&parts.material, &parts.contact, &parts.kernel,
                                         parts.grid.elements, type, loads.data(), loads.size(),
                                         solved.states.data(), &nodes, text, sizeof text);
  solved.message = text;
  return solved;
}

/// A generated contact of any size, with loads from 1e-6 of full sliding to close below it.
struct Generated {
  Parts parts;
  std::vector<double> forces;
};

Generated generated(std::mt19937& random) {
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution(from, to)(random);
  };
  Generated made;
  const double half_width = std::pow(10, uniform(-1, 1)), peak = std::pow(10, uniform(0, 3));
  made.parts = {.material = {std::pow(10, uniform(2, 5)), uniform(0, 0.5)},
                .contact = {half_width, peak, nullptr, nullptr, 0},
                .kernel = {MICROSLIP_PLANE, half_width * std::pow(10, uniform(-1, 3))},
                .grid = {static_cast<int>(uniform(1, 60)), MICROSLIP_REMEMBERED}};
  for (int i = 0; i < 4; ++i) {
    const double ratio = i < 2 ? std::pow(10, -uniform(0, 6)) : 1 - std::pow(10, -uniform(1, 6));
    made.forces.push_back((uniform(-1, 1) < 0 ? -ratio : ratio) *
                          HertzBound(half_width, peak).total());
  }
  return made;
}

TEST(CSteady, IsCartersAtGeneratedLoads) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const auto [parts, forces] = generated(random);
    const Material material{parts.material.shear_modulus, parts.material.poisson_ratio};
    const HertzBound bound(parts.contact.half_width, parts.contact.peak_traction);
    const Solved by_force = solve(parts, MICROSLIP_FORCE, forces);
    ASSERT_EQ(by_force.status, MICROSLIP_OK) << by_force.message;
    std::vector<double> creepages;
    for (const double force : forces) {
      creepages.push_back(Carter::from_force(material, bound, force).creepage());
    }
    const Solved by_creepage = solve(parts, MICROSLIP_CREEPAGE, creepages);
    ASSERT_EQ(by_creepage.status, MICROSLIP_OK) << by_creepage.message;
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const Carter exact = Carter::from_force(material, bound, forces[k]);
      SCOPED_TRACE(testing::Message()
                   << "trial " << trial << ", F/Fmax = " << forces[k] / bound.total());
      EXPECT_NEAR(by_force.states[k].creepage / exact.creepage(), 1, 1e-9);
      EXPECT_NEAR(by_creepage.states[k].force / forces[k], 1, 1e-9);
      EXPECT_EQ(by_force.states[k].method, MICROSLIP_INVERSION);
      EXPECT_NEAR(by_force.states[k].dissipation / std::abs(exact.creepage() * forces[k]), 1, 1e-9);
      const double edge = parts.contact.half_width * (1 - 2 * exact.stick_ratio());
      EXPECT_NEAR(by_force.states[k].stick_edge, edge, 1e-6 * parts.contact.half_width);
      const auto size = static_cast<std::size_t>(parts.grid.elements);
      for (std::size_t i = k * size; i < (k + 1) * size; ++i) {
        EXPECT_NEAR(by_force.traction[i], exact.traction(by_force.x[i]), 1e-8 * bound.peak());
        EXPECT_NEAR(by_force.slip[i], exact.slip(by_force.x[i]), 1e-7 * std::abs(exact.creepage()));
      }
    }
  }
}

// Antiplane shear yields 1/(1 - nu) times as much as plane strain, Johnson's Contact Mechanics 8.3.
TEST(CSteady, YieldsMoreAcrossTheRolling) {
  Parts parts{.material = {82000, 0.28},
              .contact = {5, 300, nullptr, nullptr, 0},
              .kernel = {MICROSLIP_PLANE, 100},
              .grid = {50, 0}};
  const std::vector<double> forces{-10, -1000, -2300};
  const Solved along = solve(parts, MICROSLIP_FORCE, forces);
  parts.kernel.type = MICROSLIP_PLANE_LATERAL;
  const Solved across = solve(parts, MICROSLIP_FORCE, forces);
  ASSERT_EQ(across.status, MICROSLIP_OK) << across.message;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    EXPECT_NEAR(across.states[i].creepage / along.states[i].creepage, 1 / (1 - 0.28), 1e-9);
  }
}

// Back and forth, the other direction, other units, and twice the bound under twice the load;
// strips and tables, of which no closed form is known.
TEST(CSteady, DoesNotDependOnWhatIsArbitrary) {
  const double x[] = {-0.7, -0.2, 0.4, 0.9}, value[] = {0.3, 1.1, 0.8, 0.1},
               twice[] = {0.6, 2.2, 1.6, 0.2};
  const double far[] = {-7, -2, 4, 9};
  const std::vector<double> creepages{0.02, 0.3, 0.5, 1};
  const Eigen::VectorXd places = Eigen::Map<const Eigen::VectorXd>(x, 4),
                        values = Eigen::Map<const Eigen::VectorXd>(value, 4);
  const double full = TabulatedBound(1, places, values).total();
  for (const microslip_kernel kernel :
       {microslip_kernel{MICROSLIP_STRIP, 2}, microslip_kernel{MICROSLIP_PLANE, 9}}) {
    const Parts parts{.contact = {1, 0, x, value, 4}, .kernel = kernel, .grid = {40, 0}};
    const Solved first = solve(parts, MICROSLIP_CREEPAGE, creepages);
    ASSERT_EQ(first.status, MICROSLIP_OK) << first.message;
    Parts other = parts;
    other.contact.bound_value = twice;
    other.material.shear_modulus *= 2;
    const Solved doubled = solve(other, MICROSLIP_CREEPAGE, creepages);
    other = {.contact = {10, 0, far, value, 4},
             .kernel = {kernel.type, 10 * kernel.length},
             .grid = {40, 0}};
    const Solved longer = solve(other, MICROSLIP_CREEPAGE, creepages);
    const Solved turned = solve(parts, MICROSLIP_CREEPAGE, {-0.02, -0.3, -0.5, -1});
    for (std::size_t k = 0; k < creepages.size(); ++k) {
      const double force = first.states[k].force;
      EXPECT_LT(force, 0);
      EXPECT_NEAR(doubled.states[k].force / force, 2, 1e-9);
      EXPECT_NEAR(longer.states[k].force / force, 10, 1e-8);
      EXPECT_EQ(turned.states[k].force, -force);
      if (std::abs(force) > 0.99 * full) continue;  // there the force hardly tells the creepage
      const Solved back = solve(parts, MICROSLIP_FORCE, {force});
      EXPECT_NEAR(back.states[0].creepage / creepages[k], 1, 1e-8);
    }
  }
}

// The rows are more than zones can be searched for.
TEST(CSteady, IsThatOfTheLibraryWhereElementsReplaceTheInversion) {
  constexpr int rows = 501;
  std::vector<double> x, value;
  for (int i = 0; i < rows; ++i) {
    x.push_back(0.9 * (2.0 * i / (rows - 1) - 1));
    value.push_back(1 + 0.9 * std::sin(40 * x.back()));
  }
  const Parts parts{.contact = {1, 0, x.data(), value.data(), rows},
                    .kernel = {MICROSLIP_STRIP, 3},
                    .grid = {80, 0}};
  const Solved solved = solve(parts, MICROSLIP_CREEPAGE, {0.4});
  ASSERT_EQ(solved.status, MICROSLIP_OK) << solved.message;
  const Eigen::VectorXd places = Eigen::Map<const Eigen::VectorXd>(x.data(), rows),
                        values = Eigen::Map<const Eigen::VectorXd>(value.data(), rows);
  const SteadySolution expected =
      solve_steady({.contact = {StripKernel({1, 0.28}, 3), TabulatedBound(1, places, values)},
                    .grid = Grid({.half_width = 1, .elements = 80}),
                    .load = PrescribedCreepage{0.4}});
  ASSERT_EQ(expected.scheme, SteadyScheme::calibrated);
  EXPECT_EQ(solved.states[0].method, MICROSLIP_ELEMENTS);
  EXPECT_TRUE(std::isnan(solved.states[0].stick_edge));
  EXPECT_EQ(solved.states[0].force, expected.force);
  expect_same(solved.traction, {expected.traction.begin(), expected.traction.end()});
  expect_same(solved.x, {expected.x.begin(), expected.x.end()});
}

TEST(CSteady, SolvesTheOtherLoadsWhereOneHasNoSolution) {
  const Solved solved = solve({}, MICROSLIP_FORCE, {-0.5, 2, nan, 0});
  EXPECT_EQ(solved.status, MICROSLIP_BAD_INPUT);
  EXPECT_TRUE(solved.message.starts_with("loads[1]: ")) << solved.message;
  EXPECT_NE(solved.message.find("= 2: expected an absolute value below full sliding, 1.57"),
            std::string::npos)
      << solved.message;
  EXPECT_EQ(solved.states[0].status, MICROSLIP_OK);
  EXPECT_GT(solved.states[0].creepage, 0);
  for (const std::size_t k : {1u, 2u}) {
    EXPECT_EQ(solved.states[k].status, MICROSLIP_BAD_INPUT);
    EXPECT_TRUE(std::isnan(solved.states[k].creepage));
    EXPECT_TRUE(std::isnan(solved.states[k].force));
    EXPECT_TRUE(std::isnan(solved.traction[k * 41 + 20]));
  }
  EXPECT_EQ(solved.states[3].status, MICROSLIP_OK);
  EXPECT_EQ(solved.states[3].creepage, 0);
}

TEST(CSteady, RefusesWhatMakesNoContact) {
  const auto refused = [](const Parts& parts, int type = MICROSLIP_FORCE) {
    const Solved solved = solve(parts, type, {0.1});
    EXPECT_EQ(solved.status, MICROSLIP_BAD_INPUT);
    EXPECT_EQ(solved.states[0].force, 0);  // untouched
    return solved.message;
  };
  EXPECT_EQ(refused({.material = {0, 0.3}}), "shear_modulus = 0: expected a number > 0");
  EXPECT_EQ(refused({.grid = {0, 0}}), "elements = 0: expected a whole number in [1, 4000000]");
  EXPECT_EQ(refused({}, 2), "load_type = 2: expected 0 for creepages or 1 for forces");
  const Parts p;
  char text[64] = "";
  const double load = 0;
  microslip_steady state{};
  const auto call = [&](const double* loads, std::size_t count, microslip_steady* states) {
    return microslip_solve_steady(&p.material, &p.contact, &p.kernel, 20, MICROSLIP_FORCE, loads,
                                  count, states, nullptr, text, sizeof text);
  };
  EXPECT_EQ(call(nullptr, 1, &state), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(text, "loads = null: expected a pointer");
  EXPECT_EQ(call(&load, 1, nullptr), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(text, "states = null: expected a pointer");
  EXPECT_EQ(call(nullptr, 0, nullptr), MICROSLIP_OK);
  EXPECT_EQ(microslip_solve_steady(nullptr, &p.contact, &p.kernel, 20, MICROSLIP_FORCE, &load, 1,
                                   &state, nullptr, nullptr, 0),
            MICROSLIP_BAD_INPUT);
}

TEST(CSteady, WorksFromC99) {
  const Carter exact = Carter::from_creepage({1, 0.28}, HertzBound(1, 1), 0.5);
  EXPECT_NEAR(steady_force_in_c99(0.5) / exact.force(), 1, 1e-9);
}

// A creepage of 0.3 may be 0.3 % without the percent. Normalised contacts have no such limit.
TEST(SteadyInC, LargeCreepagesAreWarnedOf) {
  Parts parts;
  EXPECT_EQ(solve(parts, MICROSLIP_CREEPAGE, {0.1, 0.9}).message, "");
  parts.material.shear_modulus = 82000;
  EXPECT_EQ(solve(parts, MICROSLIP_CREEPAGE, {0.1, -0.2}).message, "");
  EXPECT_EQ(solve(parts, MICROSLIP_FORCE, {0.5}).message, "");
  const Solved solved = solve(parts, MICROSLIP_CREEPAGE, {0.1, -0.9, 0.3});
  EXPECT_EQ(solved.status, MICROSLIP_OK);
  EXPECT_EQ(solved.message.find("warning: creepage = -0.9: creepages above 0.2 are not small"), 0U)
      << solved.message;
  EXPECT_EQ(solve(parts, MICROSLIP_CREEPAGE, {0.9, nan}).message.find("loads[1]: creepage = nan"),
            0U);
}

TEST(RollingInC, ModuliInOtherUnitsAreWarnedOf) {
  Parts parts;
  const std::string doubt =
      "a shear modulus of 8.2e+10 N/mm^2, which is more than that of any solid; numbers are in N, "
      "mm "
      "and N/mm^2";
  parts.material.shear_modulus = 8.2e10;
  const Handle handle = created(parts);
  const auto told = [&] { return std::string(microslip_warning(handle.get())); };
  EXPECT_EQ(told(), doubt);
  EXPECT_EQ(microslip_set_creepage(handle.get(), 0.3), MICROSLIP_OK);
  EXPECT_EQ(told().find("creepage = 0.3: "), 0U);
  EXPECT_EQ(microslip_set_creepage(handle.get(), 0), MICROSLIP_OK);
  EXPECT_EQ(told(), doubt);
  EXPECT_EQ(solve(parts, MICROSLIP_CREEPAGE, {0}).message, "warning: " + doubt);
}

TEST(RollingInC, LargeCreepagesAreWarnedOf) {
  Parts parts;
  parts.material.shear_modulus = 82000;
  const Handle handle = created(parts);
  const auto told = [&] { return std::string(microslip_warning(handle.get())).substr(0, 15); };
  EXPECT_EQ(told(), "");
  EXPECT_STREQ(microslip_warning(nullptr), "");
  for (const auto& [creepage, expected] : {std::pair{0.25, "creepage = 0.25"}, std::pair{0.2, ""},
                                           std::pair{-0.3, "creepage = -0.3"}}) {
    EXPECT_EQ(microslip_set_creepage(handle.get(), creepage), MICROSLIP_OK);
    EXPECT_EQ(told(), expected);
    EXPECT_EQ(microslip_advance(handle.get(), 0.1), MICROSLIP_OK);
    EXPECT_EQ(told(), expected);
  }
  EXPECT_EQ(microslip_set_creepage(handle.get(), nan), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_set_force(handle.get(), 0.5), MICROSLIP_OK);
  EXPECT_EQ(told(), "");
  const std::vector<double> dq{0.1, 0.1}, large{0.001, 0.75}, small{0.001, 0.002};
  microslip_steps steps{};
  steps.count = 2;
  steps.dq = dq.data();
  steps.creepage = large.data();
  EXPECT_EQ(microslip_roll(handle.get(), &steps, nullptr), MICROSLIP_OK);
  EXPECT_EQ(told(), "creepage = 0.75");
  steps.creepage = small.data();
  EXPECT_EQ(microslip_roll(handle.get(), &steps, nullptr), MICROSLIP_OK);
  EXPECT_EQ(told(), "");
}

}  // namespace microslip::steady_test
