// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/friction/active_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/spectra.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::active_set_test {

constexpr Material material{1, 0.28};

/// The slip of a steady problem, in one value.
struct SlipEquations {
  Eigen::MatrixXd response;
  Eigen::VectorXd offset;
  Eigen::VectorXd bound;
  Eigen::VectorXd weights;
};

ContactState solve_active_set(const SlipEquations& equations, const Load& load) {
  return ActiveSet(equations.response, equations.weights)
      .solve({.bound = equations.bound,
              .offset = equations.offset,
              .reference = Eigen::VectorXd::Zero(equations.bound.size())},
             load);
}

SlipEquations steady_equations(Eigen::Index n, const Basis& basis, double step_ratio) {
  const Grid grid({.half_width = 1, .elements = n});
  const double dx = grid.spacing();
  return {
      .response = influence_difference_matrix(PlaneKernel(material, 1), basis, dx, n, step_ratio) /
                  (step_ratio * dx),
      .offset = Eigen::VectorXd::Zero(n),
      .bound = bound_at(HertzBound(1, 1), grid.nodes()),
      .weights = Eigen::VectorXd::Constant(n, dx)};
}

void expect_contact_conditions(const SlipEquations& equations, const ContactState& state) {
  const Eigen::VectorXd slip = equations.offset + equations.response * state.traction +
                               Eigen::VectorXd::Constant(state.traction.size(), state.rigid_slip);
  for (Eigen::Index i = 0; i < state.traction.size(); ++i) {
    if (state.zones[static_cast<std::size_t>(i)] == Zone::adhesion) {
      EXPECT_NEAR(slip[i], 0, 1e-11);
      EXPECT_LE(std::abs(state.traction[i]), equations.bound[i] + 1e-11);
    } else {
      EXPECT_NEAR(slip[i], state.slip[i], 1e-11);
      EXPECT_DOUBLE_EQ(std::abs(state.traction[i]), equations.bound[i]);
      EXPECT_LE(slip[i] * state.traction[i], 1e-11);
    }
  }
}

/// Returns the condition number of the equations of the elements in adhesion, with the creepage as
/// an unknown and the force as a row.
double bordered_condition(const SlipEquations& equations, const ContactState& state) {
  std::vector<Eigen::Index> stuck;
  for (std::size_t i = 0; i < state.zones.size(); ++i) {
    if (state.zones[i] == Zone::adhesion) stuck.push_back(static_cast<Eigen::Index>(i));
  }
  const auto m = static_cast<Eigen::Index>(stuck.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Ones(m + 1, m + 1);
  matrix.topLeftCorner(m, m) = equations.response(stuck, stuck);
  matrix(m, m) = 0;
  return condition(matrix);
}

class ActiveSetAtStep : public testing::TestWithParam<std::tuple<std::string, double>> {};

// From c = 0.1 down, exchanging all violating elements at once never settles: these run the path.
TEST_P(ActiveSetAtStep, MeetsTheContactConditions) {
  const auto [basis, step_ratio] = GetParam();
  const SlipEquations equations = steady_equations(60, make_basis(basis), step_ratio);
  for (const Load load : {Load(PrescribedCreepage{0.576}), Load(PrescribedCreepage{-0.1}),
                          Load(PrescribedForce{-1}), Load(PrescribedForce{0.2})}) {
    expect_contact_conditions(equations, solve_active_set(equations, load));
  }
}

TEST_P(ActiveSetAtStep, ForceAndCreepageDescribeTheSameSolution) {
  const auto [basis, step_ratio] = GetParam();
  const SlipEquations equations = steady_equations(60, make_basis(basis), step_ratio);
  const ContactState by_creepage = solve_active_set(equations, PrescribedCreepage{0.576});
  const double force = equations.weights.dot(by_creepage.traction);
  const ContactState by_force = solve_active_set(equations, PrescribedForce{force});
  // Below 1e-10 down to c = 0.01. For c -> 0 the response turns antisymmetric: singular with an odd
  // number of adhesion elements, and with an even one its bordered form is, so digits are lost.
  const double rounding = 1e-15 * bordered_condition(equations, by_creepage);
  EXPECT_NEAR(by_force.rigid_slip, 0.576, rounding);
  EXPECT_NEAR((by_force.traction - by_creepage.traction).lpNorm<Eigen::Infinity>(), 0, rounding);
  EXPECT_EQ(by_force.zones, by_creepage.zones);
}

// The condition under which the path is proven to end.
TEST_P(ActiveSetAtStep, SymmetricPartOfTheResponseIsPositiveDefinite) {
  const auto [basis, step_ratio] = GetParam();
  const Eigen::MatrixXd r = steady_equations(60, make_basis(basis), step_ratio).response;
  EXPECT_GT(least_eigenvalue(r + r.transpose()), 0);
}

INSTANTIATE_TEST_SUITE_P(Steps, ActiveSetAtStep,
                         testing::Combine(testing::Values(std::string("constant"),
                                                          std::string("linear")),
                                          testing::Values(1.0, 0.5, 0.1, 0.01, 1e-6)));

TEST(ActiveSet, ReversesWithItsLoad) {
  const SlipEquations equations = steady_equations(30, constant_basis(), 1);
  const ContactState forward = solve_active_set(equations, PrescribedCreepage{0.3});
  const ContactState backward = solve_active_set(equations, PrescribedCreepage{-0.3});
  EXPECT_NEAR((forward.traction + backward.traction).lpNorm<Eigen::Infinity>(), 0, 1e-14);
}

TEST(ActiveSet, SticksEverywhereWithoutCreepage) {
  const SlipEquations equations = steady_equations(30, constant_basis(), 1);
  const ContactState state = solve_active_set(equations, PrescribedCreepage{0});
  EXPECT_EQ(state.traction.lpNorm<Eigen::Infinity>(), 0);
}

TEST(ActiveSet, SlidesEverywhereUnderLargeCreepage) {
  const SlipEquations equations = steady_equations(30, constant_basis(), 1);
  const ContactState state = solve_active_set(equations, PrescribedCreepage{100});
  EXPECT_EQ(state.traction, -equations.bound);
}

TEST(ActiveSet, FewRoundsNearAUnitStep) {
  for (const Eigen::Index n : {30, 240}) {
    const SlipEquations equations = steady_equations(n, constant_basis(), 1);
    EXPECT_LE(solve_active_set(equations, PrescribedCreepage{0.576}).iterations,
              std::log2(static_cast<double>(n)) + 2);
  }
}

TEST(ActiveSet, RejectsAForceOfFullSliding) {
  const SlipEquations equations = steady_equations(30, constant_basis(), 1);
  const double limit = equations.weights.dot(equations.bound);
  EXPECT_NO_THROW(solve_active_set(equations, PrescribedForce{0.999999 * limit}));
  EXPECT_THROW(solve_active_set(equations, PrescribedForce{limit}), std::invalid_argument);
  EXPECT_THROW(solve_active_set(equations, PrescribedForce{-2 * limit}), std::invalid_argument);
}

// s = w - p: traction drives slip instead of resisting it, and the way from adhesion leads to no
// solution: to a slip of w - 1 along the traction, however small.
TEST(ActiveSet, ThrowsWhereThereIsNoSolution) {
  const SlipEquations equations{.response = Eigen::MatrixXd::Constant(1, 1, -1),
                                .offset = Eigen::VectorXd::Zero(1),
                                .bound = Eigen::VectorXd::Constant(1, 1),
                                .weights = Eigen::VectorXd::Constant(1, 1)};
  for (const double wrong : {1.0, 1e-2, 1e-4, 1e-6, 1e-8}) {
    try {
      solve_active_set(equations, PrescribedCreepage{1 + wrong});
      FAIL() << "expected NotConverged";
    } catch (const NotConverged& error) {
      EXPECT_GT(error.iterations(), 0);
      EXPECT_NEAR(error.residual(), wrong / (1 + wrong), 1e-6 * wrong);
    }
  }
}

// Positive definite responses have a solution for any load that the bounds can carry, and it is
// found from any partition. Where a bound is small, an element may stick on the way from one
// direction of slip to the other only.
TEST(ActiveSet, SolvesWhateverIsPositiveDefinite) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_int_distribution<int> any_zone(-1, 1);
  const auto number = [&](Eigen::Index) { return uniform(random); };
  for (int k = 0; k < 3000; ++k) {
    const Eigen::Index n = 2 + k % 7;
    const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(
        n, n, [&](Eigen::Index, Eigen::Index) { return uniform(random); });
    SlipEquations equations{
        .response = root * root.transpose() + 0.01 * Eigen::MatrixXd::Identity(n, n),
        .offset = Eigen::VectorXd::NullaryExpr(n, number),
        .bound = Eigen::VectorXd::NullaryExpr(n, number).unaryExpr(
            [](double x) { return std::pow(10, 2 * x - 2); }),
        .weights = Eigen::VectorXd::Ones(n)};
    std::vector<Zone> first;
    for (Eigen::Index i = 0; i < n; ++i) first.push_back(static_cast<Zone>(any_zone(random)));
    const double most = equations.bound.sum();
    ActiveSet active_set(equations.response, equations.weights);
    const SlipConditions conditions{.bound = equations.bound,
                                    .offset = equations.offset,
                                    .reference = Eigen::VectorXd::Zero(n)};
    for (const Load load : {Load(PrescribedForce{0.9 * most * uniform(random)}),
                            Load(PrescribedCreepage{uniform(random)})}) {
      const ContactState state = active_set.solve(conditions, load, first);
      expect_contact_conditions(equations, state);
    }
  }
}

TEST(ActiveSet, ThrowsWhereASystemIsSingular) {
  const SlipEquations equations{.response = Eigen::MatrixXd::Zero(2, 2),
                                .offset = Eigen::VectorXd::Zero(2),
                                .bound = Eigen::VectorXd::Constant(2, 1),
                                .weights = Eigen::VectorXd::Constant(2, 1)};
  EXPECT_THROW(solve_active_set(equations, PrescribedCreepage{2}), NotConverged);
}

// The same as on the diagonal of the response, while the factors stay; those have one of the two as
// any other element, and the other one not at all.
TEST(ActiveSet, SoftElementsAreEntriesOfTheDiagonal) {
  const Eigen::Index n = 40, soft = 37, later = 30;
  const SlipEquations equations = steady_equations(n, constant_basis(), 1);
  const double stiff = equations.response.diagonal().maxCoeff();
  ActiveSet kept(equations.response, equations.weights);
  std::vector<Zone> zones(static_cast<std::size_t>(n), Zone::adhesion);
  Eigen::VectorXd reference = -0.1 * equations.bound;
  reference[soft] = 0;
  reference[later] = 0;
  kept.solve({.bound = equations.bound,
              .offset = equations.offset,
              .reference = reference,
              .compliant = {{soft, stiff}}},
             PrescribedForce{-0.8}, zones);
  int stuck = 0;
  for (const double compliance : {1e12, 30.0, 3.0, 1.0, 0.2, 0.0, 1.0, 1e15}) {
    for (const Load load : {Load(PrescribedForce{-0.8}), Load(PrescribedCreepage{0.4})}) {
      const double value = compliance * stiff;
      const ContactState state = kept.solve({.bound = equations.bound,
                                             .offset = equations.offset,
                                             .reference = reference,
                                             .compliant = {{soft, value}, {later, value / 2}}},
                                            load, zones);
      zones = state.zones;
      SlipEquations same = equations;
      same.response(soft, soft) += value;
      same.response(later, later) += value / 2;
      same.offset -= equations.response * reference;
      const ContactState expected = solve_active_set(same, load);
      EXPECT_EQ(state.zones, expected.zones);
      EXPECT_LT((state.traction - expected.traction).lpNorm<Eigen::Infinity>(), 1e-12);
      EXPECT_NEAR(state.rigid_slip, expected.rigid_slip, 1e-12);
      for (const Eigen::Index i : {soft, later}) {
        EXPECT_NEAR(state.traction[i] / expected.traction[i], 1, 1e-9) << compliance << " " << i;
        EXPECT_NEAR(state.slip[i], expected.slip[i], 1e-9 * std::abs(expected.slip[i]) + 1e-12);
        stuck += zones[static_cast<std::size_t>(i)] == Zone::adhesion ? 1 : 0;
      }
    }
  }
  EXPECT_GT(stuck, 16);
}

// For c -> 0 and an odd number of elements in adhesion under a creepage the equations are next to
// singular: some have no solution that could be found. What was factorised for those serves no
// other partition: all that can be solved anew can be solved after them.
TEST(ActiveSet, FactorsNextToSingularAreNotKept) {
  int solved = 0;
  for (const double c : {1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15}) {
    for (const Eigen::Index n : {31, 41, 51, 61, 71}) {
      const SlipEquations equations = steady_equations(n, constant_basis(), c);
      const SlipConditions conditions{
          .bound = equations.bound, .offset = equations.offset, .reference = equations.offset};
      for (const int slipping : {1, 2, 3, 4}) {
        const Load load = PrescribedCreepage{0.05 * static_cast<double>(slipping)};
        try {
          solve_active_set(equations, load);
        } catch (const NotConverged&) {
          continue;
        }
        ++solved;
        ActiveSet kept(equations.response, equations.weights);
        std::vector<Zone> zones = kept.solve(conditions, PrescribedCreepage{0}).zones;
        std::fill_n(zones.begin(), slipping, Zone::slip_negative);
        EXPECT_NO_THROW(kept.solve(conditions, load, zones)) << c << " " << n << " " << slipping;
      }
    }
  }
  EXPECT_GT(solved, 90);  // of 120
}

// It carries what the others cannot, and then they help again.
TEST(ActiveSet, ASoftElementMayBeTheOnlyOneThatSticks) {
  const Eigen::Index n = 6, soft = 5;
  SlipEquations equations = steady_equations(n, constant_basis(), 1);
  equations.bound[soft] = 1;
  ActiveSet kept(equations.response, equations.weights);
  std::vector<Zone> zones(static_cast<std::size_t>(n), Zone::adhesion);
  const double all_slip = equations.weights.dot(equations.bound);
  int alone = 0;
  for (const double force : {-0.5, -0.999, -0.99, -0.3, 0.999}) {
    for (const double compliance : {1e3, 30.0, 1.0, 0.0}) {
      SlipEquations same = equations;
      same.response(soft, soft) += compliance;
      const Load load = PrescribedForce{force * all_slip};
      const ContactState state = kept.solve({.bound = equations.bound,
                                             .offset = equations.offset,
                                             .reference = Eigen::VectorXd::Zero(n),
                                             .compliant = {{soft, compliance}}},
                                            load, zones);
      zones = state.zones;
      expect_contact_conditions(same, state);
      EXPECT_NEAR(equations.weights.dot(state.traction), force * all_slip, 1e-12);
      const auto stuck = std::count(zones.begin(), zones.end(), Zone::adhesion);
      alone += stuck == 1 && zones.back() == Zone::adhesion ? 1 : 0;
    }
  }
  EXPECT_GT(alone, 0);
}

// Nothing is known there: such elements are not exchanged, and cost no iterations.
TEST(ActiveSet, ElementsWithoutABoundAreLeftAlone) {
  SlipEquations equations = steady_equations(40, constant_basis(), 1);
  ActiveSet solver(equations.response, equations.weights);
  equations.bound.tail(3).setZero();
  for (const Zone zone : {Zone::slip_negative, Zone::slip_positive}) {
    std::vector<Zone> zones(40, Zone::adhesion);
    std::fill(zones.end() - 3, zones.end(), zone);
    const ContactState state = solver.solve({.bound = equations.bound,
                                             .offset = equations.offset,
                                             .reference = Eigen::VectorXd::Zero(40)},
                                            PrescribedForce{-0.8}, zones);
    EXPECT_EQ(state.traction.tail(3).norm(), 0);
    EXPECT_EQ(state.zones.back(), zone);
    EXPECT_LT(state.iterations, 10);
  }
}

}  // namespace microslip::active_set_test
