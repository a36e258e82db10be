// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/response_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "microslip/experiments/contact_tables.hpp"
#include "microslip/rolling/frequency_response.hpp"
#include "microslip/rolling/inverted_rolling.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;

namespace {

constexpr double default_shortest = 0.3;  // wavelength over the half-length of the stick zone
constexpr double default_longest = 300;

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("the response: expected a contact with one stick zone, but " + why);
}

struct ContactOf {
  SteadyContact operator()(const SteadyProblem& problem) const {
    if (problem.contact.has_unlike_bodies()) refuse("the bodies differ in material");
    if (problem.friction) refuse("friction depends on slip");
    return {problem.contact, problem.load};
  }
  SteadyContact operator()(const SteadyTarget& target) const { return target.contact; }
  SteadyContact operator()(const SteadyPatch&) const { refuse("the contact is an ellipse"); }
  SteadyContact operator()(const PatchTarget&) const { refuse("the contact is an ellipse"); }
  SteadyContact operator()(const PatchTransient&) const { refuse("the contact is an ellipse"); }
  SteadyContact operator()(const TransientScene& scene) const {
    if (!scene.loads.distances().empty()) {
      throw std::invalid_argument("load.file: expected one load, of which there is a steady state");
    }
    if (scene.problem.contact.has_unlike_bodies()) refuse("the bodies differ in material");
    if (scene.problem.friction) refuse("friction depends on slip");
    return {scene.problem.contact, scene.loads.at(0)};
  }
  SteadyContact operator()(const CylinderScene&) const {
    reject("problem", "cylinder", "steady or transient, which have a load");
  }
};

std::optional<double> wavelength(Scene& scene, const std::string& key) {
  if (!scene.has(key)) return std::nullopt;
  return scene.positive(key);
}

/// Refuses a narrow strip under a smooth bound in words that do not name other methods.
InvertedRolling rolling_of(const SteadyContact& contact) {
  if (!contact.kernel.is_half_space()) {
    refuse(fmt::format("its kernel is {}, not a half-space", contact.kernel.name()));
  }
  try {
    return {contact.kernel, contact.bound};
  } catch (const BadParameter&) {
    refuse("the strip is too narrow for the inversion");
  }
}

/// A steady state with one stick zone.
struct Stuck {
  double begin, end;  ///< of the zone  [mm]
  double force;       ///< [N/mm]
  double creepage;
};

/// Returns the state without a load: all parts of the contact stick that can carry a traction.
Stuck at_rest(const TractionBound& bound) {
  const auto* table = std::get_if<TabulatedBound>(&bound);
  if (table == nullptr) return {-half_width_of(bound), half_width_of(bound), 0, 0};
  const auto carries = [](double value) { return value > 0; };
  const auto& g = table->values();
  const auto first = std::find_if(g.begin(), g.end(), carries) - g.begin();
  Index last = g.size() - 1;
  while (g[last] == 0) --last;
  if ((g.segment(first, last - first + 1).array() == 0).any()) refuse("its bound vanishes inside");
  return {table->x()[std::max<Index>(first - 1, 0)],
          table->x()[std::min<Index>(last + 1, g.size() - 1)], 0, 0};
}

Stuck steady_state(const SteadyContact& contact) {
  const InvertedRolling rolling = rolling_of(contact);
  if (const auto why = rolling.obstacle()) refuse(*why);
  if (Prescribed(contact.load).value == 0) {
    return at_rest(contact.bound);
  }
  try {
    const InvertedSolution state = rolling.solve(contact.load);
    if (!(state.stick_edge() < state.stick_end())) refuse("all of it slides");
    if (!state.keeps_conditions()) refuse("there is more than one zone of stick or of slip");
    return {state.stick_edge(), state.stick_end(), state.force(), state.creepage()};
  } catch (const NotConverged&) {
    refuse("no single stick zone carries the load");
  }
}

Table empty_response() {
  return {"response",
          "the force that answers a small harmonic creepage w0 + W exp(i 2 pi q / L)",
          {{"wavelength", "mm", "L"},
           {"wavelength_ratio", "1", "L over the half-width of the contact"},
           {"slope_real", "N/mm", "real part of dF/dw"},
           {"slope_imaginary", "N/mm", "imaginary part of dF/dw"},
           {"size", "1", "|H|, H = dF/dw over its value at an infinite wavelength"},
           {"phase", "rad", "argument of H; below zero, the force comes after the creepage"}}};
}

}  // namespace

ResponseScene read_response(Scene& scene) {
  const Model model = read_model(scene);
  ResponseScene read{.contact = std::visit(ContactOf{}, model),
                     .shortest = wavelength(scene, "response.shortest"),
                     .longest = wavelength(scene, "response.longest"),
                     .wavelengths = 0};
  const double wavelengths = scene.number("response.wavelengths");
  require(wavelengths >= 2 && wavelengths <= 1e5 && std::floor(wavelengths) == wavelengths,
          "response.wavelengths", wavelengths, "a whole number from 2 to 100000");
  read.wavelengths = static_cast<Index>(wavelengths);
  return read;
}

std::vector<Table> response_tables(const ResponseScene& scene, const Progress& progress) {
  const Stuck state = steady_state(scene.contact);
  const double half_length = (state.end - state.begin) / 2;
  const double half_width = half_width_of(scene.contact.bound);
  const double shortest = scene.shortest.value_or(default_shortest * half_length);
  const double longest = scene.longest.value_or(default_longest * half_length);
  require(longest > shortest, "response.longest", longest,
          [&] { return "more than the shortest wavelength, " + format_short(shortest); });
  const FrequencyResponse response(scene.contact.kernel, state.begin, state.end, shortest);
  const double steady = response.steady_slope();
  Table table = empty_response();
  // The length of a short zone next to full sliding is a difference of its ends.
  double error = 2 * std::numeric_limits<double>::epsilon() * half_width / half_length;
  for (Index i = 0; i < scene.wavelengths; ++i) {
    const double length = log_spaced(shortest, longest, i, scene.wavelengths);
    const auto slope = response.slope(length);
    error = std::max(error, response.estimated_error(length));
    table.add({length, length / half_width, slope.real(), slope.imag(), std::abs(slope / steady),
               std::arg(slope / steady)});
    progress(static_cast<std::size_t>(i + 1), static_cast<std::size_t>(scene.wavelengths));
  }
  constexpr double accepted = 1e-8;
  if (!(error <= accepted)) throw NotConverged("response: the stick zone is too short", 0, error);
  Table summary = empty_summary("the steady state, and its answer to a slow creepage");
  summary.add({"force", state.force, "N/mm"});
  summary.add({"creepage", state.creepage, "1"});
  summary.add({"full_sliding_force", full_sliding_force(scene.contact.bound), "N/mm"});
  summary.add({"stick_edge", state.begin, "mm"});
  summary.add({"stick_end", state.end, "mm"});
  summary.add({"steady_slope", steady, "N/mm"});
  summary.add({"terms", response.terms(), "1"});
  summary.add({"estimated_error", error, "1"}, Rounding{"value", 1e-8});
  return {table, summary};
}

}  // namespace microslip::experiments
