// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/memory.hpp"

#include <numeric>

#include "microslip/halfspace/influence.hpp"

namespace microslip {

namespace {

constexpr double row_of_history = 1000;

/// What a contact takes, see the header.
struct Cost {
  double element;   ///< where matrices are Toeplitz  [bytes]
  double matrices;  ///< with all entries that are kept at once
};

double memory_by(const Cost& cost, bool fft, Eigen::Index elements) {
  const auto n = static_cast<double>(elements);
  if (fft) return cost.element * n;
  require_dense(elements);
  return cost.matrices * sizeof(double) * n * n;
}

double memory_of(const TransientProblem& problem, const Cost& cost, double steps) {
  const Eigen::Index n = problem.grid.size();
  return memory_by(cost, by_fft(problem.solver, problem.basis, n), n) + row_of_history * steps;
}

}  // namespace

double memory_needed(const SteadyProblem& problem) {
  const Eigen::Index n = problem.grid.size();
  if (std::holds_alternative<ChebyshevCollocation>(problem.method)) {
    return memory_by({.element = 600, .matrices = 0}, true, n);
  }
  if (const auto* differences = std::get_if<Differences>(&problem.method)) {
    const Solver solver = strain_solver(problem.solver, n, differences->step_ratio);
    const bool fft = !differences->edge_displacement && by_fft(solver, problem.basis, n);
    return memory_by({.element = 1000, .matrices = 2.7}, fft, n);
  }
  return memory_by({.element = 750, .matrices = 5}, by_fft(problem.solver, problem.basis, n), n);
}

double memory_needed(const TransientScene& scene) {
  const double mean = std::accumulate(scene.step_ratios.begin(), scene.step_ratios.end(), 0.0) /
                      static_cast<double>(scene.step_ratios.size());
  return memory_of(scene.problem, {.element = 1600, .matrices = 4.1},
                   scene.distance / (mean * scene.problem.grid.spacing()));
}

double memory_needed(const CylinderScene& scene) {
  return memory_of(scene.contact, {.element = 1600, .matrices = 5},
                   scene.distance / (scene.step_ratio * scene.contact.grid.spacing()));
}

}  // namespace microslip
