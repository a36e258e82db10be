// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/schemes.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "microslip/rolling/chebyshev_rolling.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

constexpr double ten_digits = std::numeric_limits<double>::infinity();
constexpr SafeRange anywhere{};
constexpr SafeRange about_an_element{0.7, 1.5};

SteadyMethod differences(double step_ratio) { return Differences{.step_ratio = step_ratio}; }

void know_the_edge(SteadyProblem& problem) {
  std::get<Differences>(problem.method).edge_displacement =
      ChebyshevRolling(problem.contact.kernel, problem.contact.bound)
          .solve(problem.load)
          .displacement(half_width_of(problem.contact.bound));
}

void trim_the_last(SteadyProblem& problem) {
  if (!problem.basis.has_only(linear_shape())) {
    reject("basis", problem.basis.name(), "linear where the last function is trimmed");
  }
  problem.basis = trimmed_linear_basis(problem.grid.leading_offset());
}

constexpr std::array steady{
    SteadyEntry{
        .name = "inversion",
        .text =
            "one stick zone is solved by inversion, to ten digits; more zones by elements over the "
            "whole contact, {functions}; the row 'method' of the summary names the method",
        .limits = "else elements are taken over the whole contact",
        .order = ten_digits,
        .by_elements = false,
        .method = [](double) -> SteadyMethod { return Inversion{}; }},
    SteadyEntry{.name = "calibrated",
                .text = "elements over the whole contact, {functions}, with calibrated edges: "
                        "second order in dx, with noise from stick-slip points inside elements",
                .limits = "noise from stick-slip points inside elements",
                .order = 2,
                .by_elements = true,
                .method = [](double) -> SteadyMethod { return Calibrated{}; }},
    SteadyEntry{.name = "standard",
                .text = "differences over c = {c} elements, {functions}: first order in dx",
                .limits = "wiggles for small step ratios",
                .order = 1,
                .by_elements = true,
                .method = differences,
                .safe_steps = about_an_element},
    SteadyEntry{.name = "known_edge",
                .text = "differences over c = {c} elements, {functions}, displacement at the "
                        "leading edge known: order 3/2",
                .limits = "smooth bounds",
                .order = 1.5,
                .by_elements = true,
                .method = differences,
                .safe_steps = about_an_element,
                .complete = know_the_edge},
    SteadyEntry{.name = "trimmed",
                .text = "differences over c = {c} elements, {functions}: first order in dx",
                .limits = "linear functions",
                .order = 1,
                .by_elements = true,
                .method = differences,
                .safe_steps = about_an_element,
                .basis = "linear",
                .complete = trim_the_last},
    SteadyEntry{.name = "chebyshev",
                .text = "Chebyshev collocation on the stick zone: ten digits; values at the nodes "
                        "of the grid",
                .limits = "one stick zone, strips at least as wide as the half-width",
                .order = ten_digits,
                .by_elements = false,
                .method = [](double) -> SteadyMethod { return ChebyshevCollocation{}; }}};

constexpr const char* relaxed = "under-relaxed: first order, no wiggles, smoothed peaks";

constexpr std::array advection{
    AdvectionEntry{.name = "remembered",
                   .text = "the material remembers its displacement, and the stick-slip point may "
                           "lie anywhere within an element: second order in dx for any step, "
                           "also for small changes of the load",
                   .limits = "constant functions",
                   .order = 2,
                   .safe_steps = anywhere,
                   .scheme = [](double) -> AdvectionScheme { return Remembered{}; }},
    AdvectionEntry{.name = "direct",
                   .text = "displacements at the nodes moved by c dx: first order, wiggles for c "
                           "<< 1 and smoothed peaks unless c is whole",
                   .limits = "wiggles for small step ratios, smoothing unless c is whole",
                   .order = 1,
                   .safe_steps = {0.5, 1.3},
                   .scheme = [](double) -> AdvectionScheme { return Direct{}; }},
    AdvectionEntry{.name = "relaxed",
                   .text = relaxed,
                   .limits = "peaks are smoothed",
                   .order = 1,
                   .safe_steps = {0.01, 1.3},
                   .scheme = [](double c) -> AdvectionScheme { return Relaxed{c}; },
                   .takes_relaxation = true},
    AdvectionEntry{.name = "relaxed_traction",
                   .text = relaxed,
                   .limits = "peaks are smoothed, and a prescribed force is only approached",
                   .order = 1,
                   .safe_steps = {0.01, 1.3},
                   .scheme = [](double c) -> AdvectionScheme { return RelaxedTraction{c}; },
                   .takes_relaxation = true},
    AdvectionEntry{.name = "fractional",
                   .text = "fractional powers of a shift by one element: first order, peaks are "
                           "kept",
                   .limits = "equal functions on an odd number of nodes",
                   .order = 1,
                   .safe_steps = {1, 1},
                   .scheme = [](double) -> AdvectionScheme { return Fractional{}; }}};

template <class Entries>
const auto& found(const Entries& entries, std::string_view name) {
  const auto entry =
      std::ranges::find_if(entries, [&](const auto& one) { return one.name == name; });
  if (entry != entries.end()) return *entry;
  throw std::invalid_argument("no such scheme: " + std::string(name));
}

}  // namespace

SafeRange safe_elements(const Basis& basis) {
  struct Measured {
    std::string_view name;
    double least;
  };
  static constexpr std::array measured{Measured{"constant", 11}, Measured{"linear", 21},
                                       Measured{"trimmed linear", 21}, Measured{"quadratic", 51}};
  const auto found = std::ranges::find(measured, basis.name(), &Measured::name);
  if (found != measured.end()) return {.least = found->least};
  throw std::logic_error("safe_elements: expected a number for basis " + basis.name());
}

std::span<const SteadyEntry> steady_schemes() { return steady; }

std::vector<std::string_view> leading_edge_names() {
  std::vector<std::string_view> names;
  for (const SteadyEntry& entry : steady) {
    const bool has_edge = !std::holds_alternative<ChebyshevCollocation>(entry.method(1));
    if (has_edge) names.push_back(entry.name);
  }
  return names;
}

const SteadyEntry& steady_scheme(std::string_view name) { return found(steady, name); }

Basis basis_of(const SteadyEntry& entry) {
  return make_basis(entry.basis.empty() ? basis_names().front() : entry.basis);
}

const SteadyEntry& entry_of(const SteadyProblem& problem) {
  const auto* by_differences = std::get_if<Differences>(&problem.method);
  if (by_differences != nullptr) {
    if (by_differences->edge_displacement) return steady_scheme("known_edge");
    return steady_scheme(problem.basis.name() == "trimmed linear" ? "trimmed" : "standard");
  }
  return *std::ranges::find_if(steady, [&](const SteadyEntry& entry) {
    return entry.method(1).index() == problem.method.index();
  });
}

SteadyProblem solved_by(const SteadyEntry& entry, SteadyProblem problem, double step_ratio) {
  problem.method = entry.method(step_ratio);
  if (entry.complete != nullptr) entry.complete(problem);
  return problem;
}

std::span<const AdvectionEntry> advection_schemes() { return advection; }

std::vector<std::string_view> advection_names() {
  std::vector<std::string_view> names;
  for (const AdvectionEntry& entry : advection) names.push_back(entry.name);
  return names;
}

const AdvectionEntry& advection_scheme(std::string_view name) { return found(advection, name); }

const AdvectionEntry& entry_of(const AdvectionScheme& scheme) {
  return *std::ranges::find_if(advection, [&](const AdvectionEntry& entry) {
    return entry.scheme(1).index() == scheme.index();
  });
}

std::string name_of(const AdvectionScheme& scheme) { return std::string(entry_of(scheme).name); }

double least_step_under_force(Eigen::Index elements) {
  return 1e-13 * static_cast<double>(elements);
}

}  // namespace microslip
