// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "bench.hpp"
#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/rolling/schemes.hpp"
#include "peak_memory.hpp"

namespace microslip::bench {

namespace {

using Eigen::Index;

SteadyProblem problem_of(const BenchParameters& p, const Kernel& kernel, std::string_view scheme,
                         Index n, Solver::Type type) {
  return solved_by(steady_scheme(scheme),
                   {.contact = {kernel, p.bound},
                    .grid = Grid({.half_width = p.bound.half_width(), .elements = n}),
                    .load = p.force,
                    .solver = {.type = type}});
}

void add_steady(std::vector<Case>& cases, const BenchParameters& p, Index n) {
  const auto add = [&](const NamedKernel& kernel, const std::string& name,
                       const SteadyProblem& problem) {
    cases.push_back({{"steady", kernel.name, name, n}, [problem] {
                       return Work([problem] { return solve_steady(problem).iterations; });
                     }});
  };
  for (const NamedKernel& kernel : p.kernels) {
    const auto add_elements = [&](const std::string& solver, Solver::Type type) {
      for (const std::string scheme : steady_by_elements) {
        add(kernel, fmt::format("{}_{}", scheme, solver),
            problem_of(p, kernel.kernel, scheme, n, type));
      }
    };
    add(kernel, "inversion", problem_of(p, kernel.kernel, "inversion", n, Solver::Type::automatic));
    add_elements("fft", Solver::Type::fft);
    if (n <= p.dense_steady) add_elements("dense", Solver::Type::dense);
  }
}

/// Two places of the stick-slip point, in turn, so that nothing is known from the call before.
template <class Rolling>
Work points(Rolling rolling, double near) {
  struct State {
    Rolling rolling;
    double stick_edge;
    double other;
  };
  auto state = std::make_shared<State>(State{std::move(rolling), near, near + 0.01});
  return [state] {
    std::swap(state->stick_edge, state->other);
    state->rolling.at(state->stick_edge);
    return 0;
  };
}

void add_chebyshev_points(std::vector<Case>& cases, const BenchParameters& p, Index unknowns) {
  for (const NamedKernel& kernel : p.kernels) {
    cases.push_back({{"point", kernel.name, "chebyshev", unknowns}, [=, &p] {
                       const double edge = -0.2 * p.bound.half_width();
                       return points(ChebyshevRolling(kernel.kernel, p.bound, unknowns), edge);
                     }});
  }
}

/// The collocation takes as many unknowns as it needs.
void add_chebyshev_steady(std::vector<Case>& cases, const BenchParameters& p) {
  for (const NamedKernel& kernel : p.kernels) {
    const Index unknowns = ChebyshevRolling(kernel.kernel, p.bound).unknowns();
    cases.push_back({{"steady", kernel.name, "chebyshev", unknowns}, [=, &p] {
                       return Work([=, &p] {
                         const ChebyshevRolling rolling(kernel.kernel, p.bound);
                         return rolling.solve(p.force).evaluations();
                       });
                     }});
  }
}

}  // namespace

std::vector<Case> steady_cases(const BenchParameters& p) {
  std::vector<Case> cases;
  for (const Index n : p.steady) add_steady(cases, p, n);
  for (const Index n : p.unknowns) add_chebyshev_points(cases, p, n);
  add_chebyshev_steady(cases, p);
  return cases;
}

Table memory_table(const BenchParameters& p) {
  Table table("memory", "peak memory of a process that solves one steady problem, by FFT",
              {{"kernel", "1", "strip or plane"},
               {"method", "1", "of steady rolling"},
               {"elements", "1", "number N of elements"},
               {"peak_memory", "byte", "largest resident set, with that of the program itself"}});
  for (const Index n : p.memory) {
    for (const std::string method : {"standard", "calibrated", "inversion"}) {
      const SteadyProblem problem = problem_of(p, p.strip(), method, n, Solver::Type::fft);
      const double peak = peak_memory([&] { solve_steady(problem); });
      table.add({p.kernels.front().name, method, n, peak});
    }
  }
  return table;
}

}  // namespace microslip::bench
