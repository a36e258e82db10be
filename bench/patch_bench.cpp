// SPDX-License-Identifier: GPL-3.0-or-later
// A circle under both creepages and spin, half of it slipping: steady rolling, and steps.
#include <memory>
#include <numbers>

#include "bench.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/standard_patch.hpp"
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

/// Steps of an element, after so many that the same cells slip in each of them.
template <class Rolling>
Work step(Rolling rolling, Index size) {
  const double dq = 2 / static_cast<double>(size);
  const PatchLoad load = circle(size, 1).load;
  const auto state = std::make_shared<Rolling>(std::move(rolling));
  for (Index i = 0; i < 4 * size; ++i) state->roll(dq, load);
  return [=] {
    state->roll(dq, load);
    return state->iterations();
  };
}

Work remembered_step(Index size) { return step(PatchRolling(circle(size, 1)), size); }

Work direct_step(Index size) {
  const SteadyPatch of = circle(size, 1);
  return step(RectangleRolling({.material = of.material,
                                .bound = {1, 1, of.bound.peak()},
                                .elements = size,
                                .rows = size}),
              size);
}

/// As many steps of an element from rest as a row has cells, a contact length: with the response of a
/// step, and with cells that begin to slip.
Work rolling_from_rest(Index size) {
  const auto rest = std::make_shared<const PatchRolling>(circle(size, 1));
  return [=] {
    PatchRolling rolling(*rest);
    int iterations = 0;
    for (Index i = 0; i < size; ++i) {
      rolling.roll(2 / static_cast<double>(size), circle(size, 1).load);
      iterations += rolling.iterations();
    }
    return iterations;
  };
}

}  // namespace

std::vector<Case> patch_cases(const BenchParameters& p) {
  std::vector<Case> cases;
  for (const Index size : p.ellipse) {
    const auto add = [&](const char* quantity, const char* method,
                         const std::function<Work()>& prepare) {
      cases.push_back({{quantity, "half_space", method, size * size}, prepare});
    };
    add("ellipse_response", "joined", [size] {
      return Work([size] {
        response_of(size);
        return 0;
      });
    });
    add("ellipse_first", "joined", [size] { return first(size); });
    add("ellipse_neighbour", "joined", [size] { return neighbour(size); });
    add("ellipse_step", "remembered", [size] { return remembered_step(size); });
    add("ellipse_step", "direct", [size] { return direct_step(size); });
    add("ellipse_rolling", "remembered", [size] { return rolling_from_rest(size); });
  }
  return cases;
}

}  // namespace microslip::bench
