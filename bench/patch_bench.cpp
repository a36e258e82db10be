// SPDX-License-Identifier: GPL-3.0-or-later
// Steady rolling of a circle under both creepages and spin, half of it slipping.
#include <memory>
#include <numbers>

#include "bench.hpp"
#include "microslip/patch/steady_patch.hpp"

namespace microslip::bench {

namespace {

using Eigen::Index;

/// \param level  of the load; 1 is a load for which CONTACT was timed
SteadyPatch circle(Index size, double level) {
  return {.material = {1, 0.28},
          .bound = EllipticBound(1, 1, 0.45 / std::numbers::pi),
          .rows = size,
          .elements = size,
          .load = {{{false, 0.028 * level}, {false, -0.024 * level}, {false, 0.16 * level}}}};
}

PatchResponse response_of(Index size) {
  return {JoinedRows(1, size, size), circle(size, 1).material.poisson_ratio};
}

Work first(Index size) {
  const auto response = std::make_shared<PatchResponse>(response_of(size));
  return [=] { return solve_steady(circle(size, 1), *response).iterations; };
}

/// Two loads in turn, 2 % apart.
Work neighbour(Index size) {
  struct State {
    PatchResponse response;
    PatchState solution;
    double level = 1, other = 1.02;
  };
  const auto state = std::make_shared<State>(
      State{response_of(size), solve_steady(circle(size, 1.02), response_of(size)).state});
  return [=] {
    const auto solution =
        solve_steady(circle(size, state->level), state->response, &state->solution);
    std::swap(state->level, state->other);
    state->solution = solution.state;
    return solution.iterations;
  };
}

}  // namespace

std::vector<Case> patch_cases(const BenchParameters& p) {
  std::vector<Case> cases;
  for (const Index size : p.ellipse) {
    const auto add = [&](const char* quantity, const std::function<Work()>& prepare) {
      cases.push_back({{quantity, "half_space", "joined", size * size}, prepare});
    };
    add("ellipse_response", [size] {
      return Work([size] {
        response_of(size);
        return 0;
      });
    });
    add("ellipse_first", [size] { return first(size); });
    add("ellipse_neighbour", [size] { return neighbour(size); });
  }
  return cases;
}

}  // namespace microslip::bench
