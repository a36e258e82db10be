// SPDX-License-Identifier: GPL-3.0-or-later
#include "steady.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "microslip/rolling/large_creepage.hpp"
#include "microslip/support/require.hpp"
#include "problem.hpp"
#include "zero.hpp"

namespace microslip::capi {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double* row_of(double* values, std::size_t row, std::size_t size) {
  return values == nullptr ? nullptr : values + row * size;
}

void put(double* to, const Eigen::VectorXd& values) {
  if (to != nullptr) std::transform(values.begin(), values.end(), to, without_sign_of_zero);
}

void put_nan(const NodesOut& nodes, Eigen::Index size) {
  for (double* to : {nodes.x, nodes.bound, nodes.traction, nodes.slip, nodes.displacement}) {
    if (to != nullptr) std::fill_n(to, size, nan);
  }
}

microslip_steady in_c(const SteadySolution& solution) {
  const bool inverted = solution.scheme == SteadyScheme::inversion;
  return {.creepage = without_sign_of_zero(solution.creepage),
          .force = without_sign_of_zero(solution.force),
          .dissipation = without_sign_of_zero(solution.dissipation),
          .stick_edge = solution.stick_edge.value_or(nan),
          .residual = solution.evidence.residual,
          .violation = solution.evidence.violation(),
          .dissipation_error = solution.evidence.dissipation_error(),
          .condition = solution.condition,
          .adhesion_elements = static_cast<int>(solution.adhesion_elements()),
          .slip_elements = static_cast<int>(solution.slip_elements()),
          .method = inverted ? MICROSLIP_INVERSION : MICROSLIP_ELEMENTS,
          .status = MICROSLIP_OK};
}

}  // namespace

NodesOut::NodesOut(const microslip_steady_nodes* nodes, std::size_t row, std::size_t size)
    : x(nullptr), bound(nullptr), traction(nullptr), slip(nullptr), displacement(nullptr) {
  if (nodes == nullptr) return;
  x = row_of(nodes->x, row, size);
  bound = row_of(nodes->bound, row, size);
  traction = row_of(nodes->traction, row, size);
  slip = row_of(nodes->slip, row, size);
  displacement = row_of(nodes->displacement, row, size);
}

void require_load_type(int type) {
  require(type == MICROSLIP_CREEPAGE || type == MICROSLIP_FORCE, "load_type", type,
          "0 for creepages or 1 for forces");
}

std::string doubt_of_loads(const SteadyProblem& problem, int type, const double* loads,
                           std::size_t count) {
  if (type != MICROSLIP_CREEPAGE || count == 0) return "";
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double largest = *std::max_element(loads, loads + count, by_size);
  const double strain = bound_strain(problem.contact.bound, problem.contact.kernel);
  const std::string doubt = doubt_of_creepage(largest, strain);
  return doubt.empty() ? "" : fmt::format("creepage = {:.6g}: {}", largest, doubt);
}

microslip_steady solve_load(SteadyProblem problem, int type, double load, const NodesOut& nodes,
                            const Message& message) noexcept {
  microslip_steady state{nan, nan, nan, nan, nan, nan, nan, nan, 0, 0, 0, MICROSLIP_OK};
  const microslip_status status = guarded(message, [&] {
    if (type == MICROSLIP_FORCE) {
      problem.load = PrescribedForce{load};
    } else {
      problem.load = PrescribedCreepage{load};
    }
    const SteadySolution solution = solve_steady(problem);
    require_evidence(solution.evidence, solution.condition, solution.iterations, problem.accepted);
    put(nodes.x, solution.x);
    put(nodes.bound, solution.bound);
    put(nodes.traction, solution.traction);
    put(nodes.slip, solution.slip);
    put(nodes.displacement, solution.displacement);
    state = in_c(solution);
  });
  if (status != MICROSLIP_OK) put_nan(nodes, problem.grid.size());
  state.status = status;
  return state;
}

}  // namespace microslip::capi

using namespace microslip::capi;

microslip_status microslip_solve_steady(const microslip_material* material,
                                        const microslip_contact* contact,
                                        const microslip_kernel* kernel, int elements, int load_type,
                                        const double* loads, size_t count, microslip_steady* states,
                                        const microslip_steady_nodes* nodes, char* message,
                                        size_t message_size) {
  const Message said{message, message_size};
  microslip_status first = MICROSLIP_OK;
  const microslip_status status = guarded(said, [&] {
    const microslip::SteadyProblem problem = make_steady_problem(
        require_pointer(material, "material"), require_pointer(contact, "contact"),
        require_pointer(kernel, "kernel"), elements);
    require_load_type(load_type);
    if (count > 0) require_pointer(loads, "loads");
    if (count > 0) require_pointer(states, "states");
    const auto size = static_cast<std::size_t>(problem.grid.size());
    for (std::size_t i = 0; i < count; ++i) {
      char why[512] = "";
      states[i] =
          solve_load(problem, load_type, loads[i], NodesOut(nodes, i, size), {why, sizeof why});
      if (states[i].status == MICROSLIP_OK || first != MICROSLIP_OK) continue;
      first = static_cast<microslip_status>(states[i].status);
      char text[sizeof why];
      std::snprintf(text, sizeof text, "loads[%zu]: %.*s", i, static_cast<int>(sizeof text) - 40,
                    why);
      said.say(text);
    }
    if (first != MICROSLIP_OK) return;
    std::string doubt = doubt_of_loads(problem, load_type, loads, count);
    if (doubt.empty()) doubt = doubt_of_units(*material, problem.contact.bound);
    said.say(doubt.empty() ? "" : "warning: " + doubt);
  });
  return status != MICROSLIP_OK ? status : first;
}
