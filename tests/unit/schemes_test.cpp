// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/schemes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace microslip::schemes_test {

const Material material{1, 0.28};

SteadyProblem problem_for(const SteadyEntry& entry) {
  return {.contact = {PlaneKernel(material, 10), HertzBound(1, 1)},
          .grid = Grid({.half_width = 1, .elements = 51}),
          .basis = basis_of(entry),
          .load = PrescribedForce{-0.5}};
}

TEST(SchemeCatalogue, AreFoundByNameAndByWhatTheySolve) {
  for (const SteadyEntry& entry : steady_schemes()) {
    EXPECT_EQ(&steady_scheme(entry.name), &entry);
    EXPECT_EQ(entry_of(solved_by(entry, problem_for(entry), 0.8)).name, entry.name);
  }
  for (const AdvectionEntry& entry : advection_schemes()) {
    EXPECT_EQ(&advection_scheme(entry.name), &entry);
    EXPECT_EQ(name_of(entry.scheme(1)), entry.name);
  }
  EXPECT_THROW(steady_scheme("relaxed"), std::invalid_argument);
  EXPECT_THROW(advection_scheme("standard"), std::invalid_argument);
}

TEST(SchemeCatalogue, OfWhichTheFirstIsTheDefault) {
  EXPECT_EQ(leading_edge_names().front(), "inversion");
  EXPECT_EQ(advection_names().front(), "remembered");
  EXPECT_EQ(leading_edge_names().size() + 1, steady_schemes().size());
}

TEST(SchemeCatalogue, SolveTheirProblem) {
  const double exact = solve_steady(problem_for(steady_scheme("inversion"))).creepage;
  for (const SteadyEntry& entry : steady_schemes()) {
    const SteadySolution found = solve_steady(solved_by(entry, problem_for(entry)));
    EXPECT_NEAR(found.creepage / exact, 1, std::isinf(entry.order) ? 1e-10 : 0.05) << entry.name;
  }
}

TEST(SchemeCatalogue, TakeTheStepRatioWhereItHasARole) {
  for (const SteadyEntry& entry : steady_schemes()) {
    const SteadyProblem problem = solved_by(entry, problem_for(entry), 0.8);
    const auto* differences = std::get_if<Differences>(&problem.method);
    EXPECT_EQ(differences != nullptr, entry.safe_steps.has_value()) << entry.name;
    if (differences == nullptr) continue;
    EXPECT_EQ(differences->step_ratio, 0.8) << entry.name;
  }
  for (const AdvectionEntry& entry : advection_schemes()) {
    if (!entry.takes_relaxation) continue;
    const AdvectionScheme half = entry.scheme(0.5);
    const auto* relaxed = std::get_if<Relaxed>(&half);
    EXPECT_EQ(relaxed == nullptr ? std::get<RelaxedTraction>(half).step_ratio : relaxed->step_ratio,
              0.5);
  }
}

TEST(SchemeCatalogue, GoWithTheBasisThatTheyName) {
  for (const SteadyEntry& entry : steady_schemes()) {
    if (entry.basis.empty()) continue;
    SteadyProblem problem = problem_for(entry);
    problem.basis = make_basis(entry.basis == "constant" ? "linear" : "constant");
    EXPECT_THROW(solved_by(entry, problem), std::invalid_argument) << entry.name;
  }
}

// Where they are explained.
TEST(SchemeCatalogue, AreInTheDocumentation) {
  std::ifstream file(MICROSLIP_SOURCE "/docs/scenes.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const std::string_view name : leading_edge_names()) {
    EXPECT_NE(text.find("| `leading_edge " + std::string(name) + "` |"), std::string::npos) << name;
  }
  for (const std::string_view name : advection_names()) {
    EXPECT_NE(text.find("\n| `" + std::string(name) + "`"), std::string::npos) << name;
  }
}

TEST(SchemeCatalogue, EachBasisOfScenesHasASafeNumberOfElements) {
  for (const std::string_view name : basis_names()) {
    EXPECT_GT(safe_elements(make_basis(name)).least, 1) << name;
  }
  const Basis unmeasured("spline", Basis::Pattern::uniform, {linear_shape()});
  EXPECT_THROW(safe_elements(unmeasured), std::logic_error);
}

}  // namespace microslip::schemes_test
