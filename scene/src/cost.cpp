// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

namespace {

constexpr double row_of_history = 1000;
constexpr double row_of_instant = 1200;

/// Memory of a patch that rolls by steps, over that of steady rolling.
constexpr double memory_of_steps = 2;

/// Cost of a shift, in steps: some ten partitions, each with new factors.
constexpr double steps_of_shift = 16;

/// Memory of a contact: per element where matrices are Toeplitz, in matrices where they are dense.
struct Memory {
  double element;   ///< [bytes]
  double matrices;  ///< kept at once
};

double memory_by(const Memory& memory, bool fft, Eigen::Index elements) {
  const auto n = static_cast<double>(elements);
  if (fft) return memory.element * n;
  require_dense(elements);
  return memory.matrices * sizeof(double) * n * n;
}

bool by_fft(const SteadyProblem& problem) {
  const Eigen::Index n = problem.grid.size();
  const auto* differences = std::get_if<Differences>(&problem.method);
  if (differences == nullptr) return by_fft(problem.solver, problem.basis, n);
  const Solver solver = strain_solver(problem.solver, n, differences->step_ratio);
  return !differences->edge_displacement && by_fft(solver, problem.basis, n);
}

bool by_fft(const TransientProblem& problem) {
  return by_fft(problem.solver, problem.basis, problem.grid.size());
}

double log2_of(double n) { return std::log2(std::max(n, 2.0)); }

template <class Steps>
double of_instants(const Steps& scene, Eigen::Index elements) {
  return row_of_instant * static_cast<double>(scene.instants.size()) *
         static_cast<double>(elements);
}

struct MemoryOf {
  double operator()(const SteadyProblem& problem) const {
    const Eigen::Index n = problem.grid.size();
    if (std::holds_alternative<ChebyshevCollocation>(problem.method)) {
      return memory_by({.element = 600, .matrices = 0}, true, n);
    }
    const bool differences = std::holds_alternative<Differences>(problem.method);
    return memory_by({.element = 1000, .matrices = differences ? 2.7 : 4}, by_fft(problem), n);
  }
  double operator()(const SteadyTarget&) const { return 0; }
  double operator()(const SteadyPatch& patch) const {
    const auto n = static_cast<double>(patch.rows * patch.elements);
    return 240 * n * n;
  }
  double operator()(const PatchTarget& target) const { return (*this)(target.patch); }
  double operator()(const TransientScene& scene) const {
    const bool shifts = !scene.shifts.empty() || std::holds_alternative<CattaneoShift>(scene.start);
    const bool twice = shifts && std::holds_alternative<Remembered>(scene.problem.scheme);
    return memory_by(twice ? Memory{.element = 2400, .matrices = 5.2}
                           : Memory{.element = 1600, .matrices = 4.1},
                     by_fft(scene.problem), scene.problem.grid.size()) +
           row_of_history * (steps_needed(scene) + static_cast<double>(scene.shifts.size())) +
           of_instants(scene, scene.problem.grid.size());
  }
  double operator()(const PatchTransient& scene) const {
    constexpr double of_rectangle = 4000;
    const double rows = steps_needed(scene) + static_cast<double>(scene.shifts.size());
    const double of_contact =
        !std::holds_alternative<Remembered>(scene.scheme)
            ? of_rectangle * static_cast<double>(scene.patch.rows * scene.patch.elements)
            : memory_of_steps * (*this)(scene.patch);
    return of_contact + row_of_history * rows +
           of_instants(scene, scene.patch.rows * scene.patch.elements);
  }
  double operator()(const CylinderScene& scene) const {
    return memory_by({.element = 1600, .matrices = 5}, by_fft(scene.problem),
                     scene.problem.grid.size()) +
           row_of_history * steps_needed(scene);
  }
};

struct StepsOf {
  double operator()(const SteadyProblem&) const { return 0; }
  double operator()(const SteadyTarget&) const { return 0; }
  double operator()(const SteadyPatch&) const { return 0; }
  double operator()(const PatchTarget&) const { return 0; }
  double operator()(const TransientScene& scene) const {
    return static_cast<double>(number_of_steps(scene.distance, scene.step_lengths(), scene.from));
  }
  double operator()(const PatchTransient& scene) const {
    return static_cast<double>(number_of_steps(scene.distance, scene.step_lengths(), scene.from));
  }
  double operator()(const CylinderScene& scene) const {
    const double length = scene.step_ratio * scene.problem.grid.spacing();
    return static_cast<double>(number_of_steps(scene.distance, {length}));
  }
};

/// Constants are of the runs of the study speed_accuracy.
struct WorkOf {
  static constexpr double rounds_of_friction = 25;  ///< that depends on slip, in each step
  /// The same of ellipses, in systems over those of a solution, or over a step that is followed.
  static constexpr double systems_of_friction = 8, systems_of_friction_in_step = 60;

  double operator()(const SteadyProblem& problem) const {
    const auto n = static_cast<double>(problem.grid.size());
    const bool strip = std::isfinite(problem.contact.kernel.clear_distance());
    if (problem.friction) return (0.4 * n + 600) * n * n;
    if (std::holds_alternative<Inversion>(problem.method) &&
        problem.contact.kernel.is_half_space()) {
      const auto* table = std::get_if<TabulatedBound>(&problem.contact.bound);
      return table == nullptr ? 4e5 + 2000 * n : 1e5 + 300 * n + of_rows(problem, *table);
    }
    if (std::holds_alternative<ChebyshevCollocation>(problem.method)) {
      return 3e5 + (strip ? 60 * kernel_work : 60) * n;
    }
    if (by_fft(problem)) return 1500 * n * log2_of(n);
    return (0.4 * n * n + 5000) * n;
  }
  double operator()(const SteadyTarget&) const { return std::numeric_limits<double>::quiet_NaN(); }
  double operator()(const PatchTarget&) const { return std::numeric_limits<double>::quiet_NaN(); }
  /// Integrals of the kernels, then some seven systems of all cells, and the same for fewer cells.
  double operator()(const SteadyPatch& patch) const {
    const auto n = static_cast<double>(patch.rows * patch.elements);
    const double rounds = patch.friction ? systems_of_friction : 1;
    return 5e6 * static_cast<double>(patch.rows) + rounds * (15e3 + 60 * n) * n * n / 4;
  }
  /// Integrals and matrices as in steady rolling, a system for each step, and a response for each
  /// length of step, and for the first one; and for each step if the contact changes its size.
  /// Rectangles have products by FFT.
  double operator()(const PatchTransient& scene) const {
    const auto n = static_cast<double>(scene.patch.rows * scene.patch.elements);
    const double steps = steps_needed(scene) + static_cast<double>(scene.shifts.size());
    if (!std::holds_alternative<Remembered>(scene.scheme)) return 60 * steps * n * n;
    const double rounds = scene.patch.friction ? systems_of_friction_in_step : 1;
    const double response = 22 * n * n * n, step = rounds * 300 * n * n;
    const bool is_same = scene.step_ratios.size() == 1 && !scene.loads.changes_size();
    const double responses = is_same ? std::min(steps, 3.0) : steps;
    return (*this)(scene.patch) + steps * step + responses * response;
  }
  double operator()(const TransientScene& scene) const {
    const double steps = steps_needed(scene);
    const double elements = (scene.distance - scene.from) / scene.problem.grid.spacing() / steps;
    const double rounds = scene.problem.friction ? rounds_of_friction : 1;
    return steps * rounds * solves_of_step(scene.problem.scheme, elements) *
               (of_step(scene.problem, std::ranges::all_of(scene.step_ratios, is_whole)) +
                (scene.loads.changes_contact() ? of_change(scene.problem) : 0)) +
           steps_of_shift * static_cast<double>(scene.shifts.size()) * of_step(scene.problem, true);
  }
  double operator()(const CylinderScene& scene) const {
    const double rounds = scene.integrator == Integrator::midpoint ? 3 : 1;
    return steps_needed(scene) * rounds * solves_of_step(scene.problem.scheme, scene.step_ratio) *
           of_step(scene.problem, is_whole(scene.step_ratio));
  }
  /// Cost of the rows of a table in the slip zone, if one zone sticks. The zone is as long as in
  /// Carter's solution under the same part of full sliding; under a creepage this part is not
  /// known.
  static double of_rows(const SteadyProblem& problem, const TabulatedBound& table) {
    constexpr double under_creepage = 0.5;
    const auto* force = std::get_if<PrescribedForce>(&problem.load);
    const double part =
        force ? std::min(1.0, std::abs(force->value) / full_sliding_force(problem.contact.bound))
              : under_creepage;
    return static_cast<double>(table.x().size()) * (1 - std::sqrt(1 - part)) *
           (1.2e5 + 85 * static_cast<double>(problem.grid.size()));
  }
  /// The scheme remembered ends a substep where an element has been travelled.
  static double solves_of_step(const AdvectionScheme& scheme, double elements) {
    return std::holds_alternative<Remembered>(scheme) ? std::max(1.0, elements) : 1;
  }
  /// Cost of a change of the half-width: in plane strain one more solve, on a strip a new response.
  static double of_change(const TransientProblem& problem) {
    if (problem.contact.kernel.is_plane()) return of_step(problem, true);
    const auto n = static_cast<double>(problem.grid.size());
    return kernel_work * n + (by_fft(problem) ? 600 * n * log2_of(n) : 0.7 * n * n * n);
  }
  static bool is_whole(double step_ratio) { return step_ratio == std::floor(step_ratio); }
  static double of_step(const TransientProblem& problem, bool by_whole_elements) {
    const auto n = static_cast<double>(problem.grid.size());
    const bool power = std::holds_alternative<Fractional>(problem.scheme) && !by_whole_elements;
    return (power ? 1200 * n * log2_of(n) : 0) +
           (by_fft(problem) ? 150 * n * log2_of(n) : 15 * n * n);
  }
};

}  // namespace

double memory_needed(const Model& model) { return std::visit(MemoryOf{}, model); }

double work_needed(const Model& model) { return std::visit(WorkOf{}, model); }

double steps_needed(const Model& model) { return std::visit(StepsOf{}, model); }

}  // namespace microslip
