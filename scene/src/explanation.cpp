// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/explanation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>

#include "microslip/patch/patch_rolling.hpp"
#include "microslip/reference/kalker.hpp"
#include "microslip/rolling/large_creepage.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/cost.hpp"

namespace microslip {

namespace {

std::string kind_of(const Load& load) {
  return Prescribed(load).by_force ? "a force" : "a creepage";
}

std::string sliding(const TractionBound& bound) {
  return fmt::format("full sliding at {:.5g} N/mm", full_sliding_force(bound));
}

std::string sliding(const TractionBound& bound, const Load& load) {
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr) return sliding(bound);
  return fmt::format("{}; the load is {:.5g} of it", sliding(bound),
                     std::abs(force->value) / full_sliding_force(bound));
}

std::string elements_of(const Grid& grid) {
  return fmt::format("{} elements of {:.5g} mm", grid.size(), grid.spacing());
}

std::string method_of(const SteadyProblem& problem) {
  if (problem.contact.has_unlike_bodies() && std::holds_alternative<Inversion>(problem.method)) {
    return "all stick zones are solved by inversion under Hertz's bound; otherwise by elements "
           "over the whole contact, constant functions; the row 'method' of the summary names the "
           "method";
  }
  const auto* differences = std::get_if<Differences>(&problem.method);
  const double c = differences == nullptr ? 1 : differences->step_ratio;
  const bool by_elements = std::holds_alternative<Inversion>(problem.method) &&
                           (problem.friction || !problem.contact.kernel.is_half_space());
  const SteadyEntry& entry = by_elements ? steady_scheme("calibrated") : entry_of(problem);
  return fmt::format(fmt::runtime(entry.text),
                     fmt::arg("functions", problem.basis.name() + " functions"),
                     fmt::arg("c", fmt::format("{:.5g}", c)));
}

std::string method_of(const AdvectionScheme& scheme) { return std::string(entry_of(scheme).text); }

std::string rolled(const Model& model, double distance, const Grid& grid) {
  return fmt::format("rolls {:.5g} mm, {:.5g} contact widths, in {:.5g} steps", distance,
                     distance / (2 * grid.half_width()), steps_needed(model));
}

/// Full sliding, and the largest part of it that is prescribed.
std::string loaded(const TransientScene& scene) {
  Load largest = scene.loads.at(0);
  const auto size = [](const Load& load) { return std::abs(Prescribed(load).value); };
  for (const double distance : scene.loads.distances()) {
    const Load load = scene.loads.at(distance);
    if (size(load) > size(largest)) largest = load;
  }
  return sliding(scene.problem.contact.bound, largest);
}

/// The shifts before rolling, except for the shift of an ordinary start.
std::vector<std::string> shifted(const TransientScene& scene) {
  if (scene.shifts.empty()) return {};
  double most = 0;
  for (const ShiftLoad& load : scene.shifts) {
    most = std::max(most, std::abs(Prescribed(load).value));
  }
  const bool by_force = Prescribed(scene.shifts.front()).by_force;
  const std::string size = by_force
                               ? fmt::format("to at most {:.5g} of full sliding",
                                             most / full_sliding_force(scene.problem.contact.bound))
                               : fmt::format("by at most {:.5g} mm", most);
  const std::size_t count = scene.shifts.size();
  return {
      fmt::format("{} shift{} without rolling before it, {}", count, count == 1 ? "" : "s", size)};
}

/// The sizes of a contact that changes.
/// \param a  half-width of the problem  [mm]
std::vector<std::string> changed(const LoadHistory& loads, double a) {
  if (!loads.changes_contact()) return {};
  double least = std::numeric_limits<double>::infinity(), most = 0;
  std::vector<double> lost;
  const std::vector<ContactScale> contacts = loads.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    least = std::min(least, contacts[i].half_width);
    most = std::max(most, contacts[i].half_width);
    if (!contacts[i].carries()) lost.push_back(loads.position_at(loads.distances()[i]));
  }
  const std::string loses =
      lost.empty() ? ""
                   : fmt::format(
                         "; in {} row{} of load.file contact or friction is lost, {}at q = {:.5g} "
                         "mm, and the bodies forget",
                         lost.size(), lost.size() == 1 ? "" : "s", lost.size() == 1 ? "" : "first ",
                         lost.front());
  return {fmt::format("the contact changes: its half-width is from {:.5g} to {:.5g} mm{}",
                      least * a, most * a, loses)};
}

/// Places where the bodies turn, or stand.
/// \param stops  of a run
std::vector<std::string> stopped(const std::vector<double>& stops) {
  if (stops.empty()) return {};
  return {
      fmt::format("the bodies turn, or are shifted without rolling, at {} place{}: steps end "
                  "there",
                  stops.size(), stops.size() == 1 ? "" : "s")};
}

const std::string normal_changes =
    "the normal contact: bound and edges are given, or by Hertz from the load, from row to row; "
    "they do not depend on tractions";
const std::string normal =
    "the normal contact: bound and edges are given, or by Hertz from the load, and stay as they "
    "are";
/// The largest bound at rest over G.
double strain_of(const SteadyPatch& patch) {
  return patch.bound.peak() / patch.material.shear_modulus;
}

/// The same, as if the bound were Hertz's.
double strain_of(const Contact& contact) {
  return 4 / std::numbers::pi * bound_strain(contact.bound, contact.kernel);
}

/// How friction falls with slip, and with which memory short steps have one solution: the factor of
/// docs/theory.md, "Friction that falls with slip", is below 1 then for all waves in the contact.
/// \param strain      of the largest bound at rest, bound over G  [1]
/// \param half_width  a, along the rolling  [mm]
std::vector<std::string> falling(const std::optional<SlipFriction>& friction, double strain,
                                 double half_width) {
  if (!friction) return {};
  const double kinetic = friction->law(std::numeric_limits<double>::infinity());
  const std::string memory =
      friction->remembers()
          ? fmt::format("over a length of slip of {:.5g} mm", friction->memory_length)
          : "at once; a short step then has two solutions or more (docs/theory.md)";
  return {
      fmt::format("friction falls with slip to {:.5g} of that at rest, {}", kinetic, memory),
      fmt::format("a contact.friction_memory of 2 (1 - mu_k/mu_s) a g/G = {:.2g} mm is enough for "
                  "one solution in each step",
                  2 * (1 - kinetic) * half_width * strain)};
}

const std::string how_steady = "the start of rolling, and the inertia of the bodies";
const std::string details =
    "creepage in the other direction, spin, bodies of different material, friction that depends on "
    "slip, heat, "
    "wear";
const std::string details_of_falling =
    "creepage in the other direction, spin, bodies of different material, heat, wear";
const std::string details_of_unlike =
    "creepage in the other direction, spin, friction that depends on slip, heat, wear";

/// In full sliding the singular integral equation of the pressure has the solution Hertz's pressure
/// times ((a + x)/(a - x))^e with tan(pi e) = -+beta mu. Where (a + x)/(a - x) = e^pi, at 0.917 a,
/// the factor differs from 1 by beta mu, to first order.
std::string goodman(double coupling) {
  return fmt::format(
      "the change of pressure by tangential tractions on bodies of different material (Goodman): "
      "in "
      "full sliding it is the fraction beta mu = {:.2g} of the pressure at 0.92 half-widths, and "
      "less in the middle or under less load",
      std::abs(coupling));
}

/// States that the pressure makes bodies of different material creep in free rolling.
template <class Problem>
std::vector<std::string> stretched(const Problem& problem) {
  if (!problem.contact.has_unlike_bodies()) return {};
  const double ratio =
      problem.contact.pressure_strain / compliance(problem.contact.kernel.material());
  return {
      fmt::format("bodies of different material, beta/mu = {:.5g}: the pressure stretches one "
                  "surface against the other",
                  ratio)};
}

/// Compares the rows of a tabulated bound with the elements.
std::vector<std::string> tabulated(const TractionBound& bound, const Grid& grid) {
  const auto* table = std::get_if<TabulatedBound>(&bound);
  if (table == nullptr) return {};
  const double width = table->x()[table->x().size() - 1] - table->x()[0];
  const double row = width / static_cast<double>(table->x().size() - 1);
  return {
      fmt::format("the bound is a table of {} rows, about {:.2g} mm apart; an element is as long "
                  "as {:.2g} of these distances",
                  table->x().size(), row, grid.spacing() / row)};
}

std::string five_digits(double value) { return fmt::format("{:.5g}", value); }

/// The consequences of a kernel other than a half-space's, and what it does not model.
struct OfKernel {
  double half_width;
  std::vector<std::string> consequences = {};
  std::vector<std::string> not_modelled = {};

  void operator()(const StripKernel&) {}
  void operator()(const PlaneKernel&) {}
  void operator()(const WinklerKernel& winkler) {
    consequences = {
        fmt::format("springs beside one another, {} mm^3/N: tractions grow in "
                    "proportion to the distance from the leading edge",
                    five_digits(winkler.layer_compliance()))};
    not_modelled = {
        "what a traction does beside itself: bodies are springs, as in FASTSIM, not half-spaces"};
  }
  void operator()(const LayeredKernel& layered) {
    const double half_space = layered.decay(1e-3 * half_width) * 1e-3 * half_width;
    consequences = {fmt::format(
        "a layer of springs on the half-space, {} mm^3/N: as compliant as the half-space to waves "
        "of {} half-widths",
        five_digits(layered.layer_compliance()),
        five_digits(2 * layered.layer_compliance() / half_space / half_width))};
    not_modelled = {"the layer's own thickness, and shear from each of its springs to the next"};
  }
  void operator()(const SymbolKernel& symbol) {
    const auto& waves = symbol.wave_numbers();
    const double longest = 2 * std::numbers::pi / waves[0];
    const double shortest = 2 * std::numbers::pi / waves[waves.size() - 1];
    consequences = {fmt::format(
        "a kernel by its symbol, from waves of {} to {} mm; shorter waves feel a half-space with "
        "2 (1 - nu)/G = {} mm^2/N and a layer of {} mm^3/N, as the last two rows say",
        five_digits(longest), five_digits(shortest),
        five_digits(std::numbers::pi * symbol.log_factor()),
        five_digits(symbol.layer_compliance()))};
    not_modelled = {
        fmt::format("how bodies yield to waves longer than {} mm, {} half-widths: as to this wave, "
                    "so that they "
                    "do not move far from a load",
                    five_digits(longest), five_digits(longest / half_width))};
  }
};

Explanation with_kernel(const Contact& contact, Explanation found) {
  OfKernel of{half_width_of(contact.bound)};
  contact.kernel.visit(of);
  std::ranges::move(of.consequences, std::back_inserter(found.consequences));
  found.not_modelled.insert(found.not_modelled.begin(), of.not_modelled.begin(),
                            of.not_modelled.end());
  return found;
}

/// "a creepage along the rolling, a force across it, ..."
std::string kind_of(const PatchLoad& load) {
  constexpr std::array names{"along the rolling", "across it", "about the normal"};
  std::string kinds;
  for (std::size_t j = 0; j < names.size(); ++j) {
    const bool is_moment = j == 2;
    kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ",
                         load[j].by_resultant ? (is_moment ? "a moment" : "a force")
                                              : (is_moment ? "a spin" : "a creepage"),
                         names[j]);
  }
  return kinds;
}

std::string name_of(const PatchShape& shape) {
  return shape.is_ellipse() ? "an ellipse" : "a patch";
}

/// The largest resultants, the shape and the grid.
std::vector<std::string> sizes_of(const SteadyPatch& patch, bool by_rectangles = false) {
  const PatchShape& shape = patch.bound.shape();
  const std::string c = five_digits(patch.bound.size());
  const std::size_t lobes = shape.lobes().size();
  return {
      fmt::format("full sliding at {} N; turning about {} at {} N mm",
                  five_digits(patch.bound.total()), shape.is_ellipse() ? "the centre" : "x = y = 0",
                  five_digits(patch.bound.turning_moment())),
      shape.is_ellipse()
          ? fmt::format("a/b = {}, c = (a b)^(1/2) = {} mm", five_digits(patch.bound.ratio()), c)
          : fmt::format("{} of the area {} mm^2, c = (area/pi)^(1/2) = {} mm, mean length over "
                        "width {}",
                        lobes == 1 ? "one lobe" : fmt::format("{} lobes", lobes),
                        five_digits(shape.area()), c, five_digits(patch.bound.ratio())),
      fmt::format(
          "{} rows of {} {}", patch.rows, patch.elements,
          by_rectangles ? "rectangles around the ellipse" : "elements between their own edges")};
}

const std::string unlike_patch =
    "that the pressure of bodies of different material displaces their surfaces";
const std::string shape_by_spin =
    "spin that changes the shape of the contact, and a contact in more than one plane";

/// Whether a line contact would do in the place of an ellipse, with the errors of the study
/// ellipse_convergence: docs/ellipse.md.
std::string in_place_of(const SteadyPatch& patch) {
  const auto acts = [&](std::size_t j) { return patch.load[j] != PatchComponent{}; };
  if (acts(2) || (acts(0) && acts(1))) {
    return "no line contact would do: it has no spin, and no creepage along and across at once";
  }
  constexpr double width_over_axis = std::numbers::pi / 2;
  constexpr double peak_over_peak = 8 / (3 * std::numbers::pi);
  return fmt::format(
      "a line contact would do within 3 % of full sliding: kernel.type strip, kernel.width {} mm, "
      "contact.peak_traction {} N/mm^2{}",
      five_digits(width_over_axis * patch.bound.lateral_half_width()),
      five_digits(peak_over_peak * patch.bound.peak()), acts(1) ? ", direction lateral" : "");
}

Explanation of_patch(const SteadyPatch& patch, const std::optional<std::string>& how = {}) {
  Explanation found{fmt::format("steady rolling of {} under {}", name_of(patch.bound.shape()),
                                kind_of(patch.load)),
                    sizes_of(patch),
                    {normal, how_steady, unlike_patch, shape_by_spin}};
  if (how) found.consequences.back() = *how;
  std::ranges::copy(falling(patch.friction, strain_of(patch), patch.bound.half_width()),
                    std::back_inserter(found.consequences));
  found.consequences.emplace_back(
      how ? "stick and slip are found by Newton's method"
          : "stick and slip are found by Newton's method; where nothing slips, forces are right to "
            "1e-3");
  if (patch.bound.is_hertz() && patch.bound.ratio() >= least_kalker_ratio) {
    const CreepCoefficients of =
        creep_coefficients(patch.bound.ratio(), patch.material.poisson_ratio).value;
    found.consequences.push_back(fmt::format(
        "Kalker's coefficients: C11 = {}, C22 = {}, C23 = {}, C33 = {}", five_digits(of.c11),
        five_digits(of.c22), five_digits(of.c23), five_digits(of.c33)));
    found.consequences.push_back(in_place_of(patch));
  }
  return found;
}

/// The shifts of a patch before it rolls, and to which part of the largest resultants they lead.
std::vector<std::string> shifted(const PatchTransient& scene) {
  if (scene.shifts.empty()) return {};
  const Eigen::Vector3d largest = largest_resultants(scene.patch.bound, scene.loads.contact_at(0));
  double most = 0;
  for (const PatchLoad& load : scene.shifts) {
    for (std::size_t j = 0; j < load.size(); ++j) {
      if (!load[j].by_resultant) continue;
      most = std::max(most, std::abs(load[j].value) / largest[static_cast<Eigen::Index>(j)]);
    }
  }
  const std::size_t count = scene.shifts.size();
  return {fmt::format(
      "{} shift{} without rolling before it{}", count, count == 1 ? "" : "s",
      most > 0 ? ", to at most " + five_digits(most) + " of the largest force or moment" : "")};
}

Explanation of_patch(const PatchTransient& scene) {
  Explanation found{fmt::format("transient rolling of {} under {}{}",
                                name_of(scene.patch.bound.shape()), kind_of(scene.loads.at(0)),
                                scene.loads.distances().empty() ? "" : ", that change"),
                    sizes_of(scene.patch),
                    {scene.loads.changes_contact() ? normal_changes : normal,
                     "inertia of the bodies", unlike_patch, shape_by_spin}};
  std::vector<std::string>& lines = found.consequences;
  std::ranges::move(changed(scene.loads.rows(), scene.patch.bound.half_width()),
                    std::back_inserter(lines));
  std::ranges::move(stopped(scene.loads.stops()), std::back_inserter(lines));
  std::ranges::move(shifted(scene), std::back_inserter(lines));
  std::ranges::copy(
      falling(scene.patch.friction, strain_of(scene.patch), scene.patch.bound.half_width()),
      std::back_inserter(lines));
  lines.push_back(fmt::format(
      "rolls {} mm, {} contact lengths, in {} steps", five_digits(scene.distance - scene.from),
      five_digits((scene.distance - scene.from) / (2 * scene.patch.bound.half_width())),
      five_digits(steps_needed(scene))));
  if (!std::holds_alternative<Remembered>(scene.scheme)) {
    lines.emplace_back(
        "tractions are constant in equal rectangles, and displacements are moved with the "
        "material, as in CONTACT: first order in dx");
    if (const auto* relaxed = std::get_if<Relaxed>(&scene.scheme)) {
      lines.push_back(
          fmt::format("under-relaxation with c* = {}: short steps do not wiggle, but smooth peaks",
                      five_digits(relaxed->step_ratio)));
    }
  } else {
    lines.emplace_back(
        "the material remembers its displacement: second order in the step, of any length; stick "
        "and slip are found by Newton's method");
  }
  return found;
}

struct Explain {
  Explanation operator()(const SteadyProblem& problem) const {
    std::vector<std::string> consequences = {sliding(problem.contact.bound, problem.load),
                                             elements_of(problem.grid), method_of(problem)};
    std::ranges::copy(tabulated(problem.contact.bound, problem.grid),
                      std::back_inserter(consequences));
    std::ranges::copy(stretched(problem), std::back_inserter(consequences));
    std::ranges::copy(
        falling(problem.friction, strain_of(problem.contact), problem.grid.half_width()),
        std::back_inserter(consequences));
    Explanation found = steady(kind_of(problem.load), consequences);
    if (problem.contact.has_unlike_bodies()) {
      found.not_modelled = {normal, goodman(problem.contact.coupling), how_steady,
                            details_of_unlike};
    }
    if (problem.friction) found.not_modelled.back() = details_of_falling;
    return with_kernel(problem.contact, found);
  }
  Explanation operator()(const SteadyTarget& target) const {
    return with_kernel(
        target.contact,
        steady(
            kind_of(target.contact.load),
            {sliding(target.contact.bound, target.contact.load),
             "the program chooses method and grid: inversion if one zone sticks, otherwise as many "
             "calibrated elements as the error needs"}));
  }
  Explanation operator()(const SteadyPatch& patch) const { return of_patch(patch); }
  Explanation operator()(const PatchTarget& target) const {
    const PatchGrid coarsest = grids_to_try(target.patch.bound.shape()).front();
    return of_patch(
        target.patch,
        fmt::format("the program chooses rows and elements: from {} rows of {} up to {} rows of "
                    "{}, each time with twice as many cells, until the estimate of the error is "
                    "below {}",
                    coarsest.rows, coarsest.elements, target.patch.rows, target.patch.elements,
                    five_digits(target.error)));
  }
  Explanation operator()(const PatchTransient& scene) const { return of_patch(scene); }
  Explanation operator()(const TransientScene& scene) const {
    std::vector<std::string> consequences = {loaded(scene), elements_of(scene.problem.grid)};
    std::ranges::copy(tabulated(scene.problem.contact.bound, scene.problem.grid),
                      std::back_inserter(consequences));
    std::ranges::copy(changed(scene.loads, scene.problem.grid.half_width()),
                      std::back_inserter(consequences));
    std::ranges::copy(stopped(scene.loads.stops()), std::back_inserter(consequences));
    std::ranges::copy(shifted(scene), std::back_inserter(consequences));
    consequences.push_back(rolled(scene, scene.distance, scene.problem.grid));
    consequences.push_back(method_of(scene.problem.scheme));
    std::ranges::copy(stretched(scene.problem), std::back_inserter(consequences));
    std::ranges::copy(falling(scene.problem.friction, strain_of(scene.problem.contact),
                              scene.problem.grid.half_width()),
                      std::back_inserter(consequences));
    std::vector<std::string> not_modelled = {
        scene.loads.changes_contact() ? normal_changes : normal,
        "inertia of the bodies (problem cylinder has it)", details};
    if (scene.problem.contact.has_unlike_bodies()) {
      not_modelled = {normal, goodman(scene.problem.contact.coupling),
                      "tractions of bodies that are pressed together: they start without any",
                      not_modelled[1], details_of_unlike};
    }
    if (scene.problem.friction) not_modelled.back() = details_of_falling;
    return with_kernel(scene.problem.contact,
                       {fmt::format("transient rolling under {}{}", kind_of(scene.loads.at(0)),
                                    scene.loads.distances().empty() ? "" : " that changes"),
                        consequences, not_modelled});
  }
  Explanation operator()(const CylinderScene& scene) const {
    const double velocity = scene.cylinder.velocity;
    const std::string start =
        velocity == 0 ? "rest" : fmt::format("free rolling with {:.5g} mm/s", velocity);
    return with_kernel(scene.problem.contact,
                       {"a cylinder that rolls down a slope from " + start,
                        {sliding(scene.problem.contact.bound), elements_of(scene.problem.grid),
                         rolled(scene, scene.distance, scene.problem.grid) +
                             " or more: steps from rest and steps of a swinging body are shorter",
                         method_of(scene.problem.scheme)},
                        {normal, "waves in the bodies: they deform as at rest", details}});
  }
  static Explanation steady(const std::string& load, std::vector<std::string> consequences) {
    return {"steady rolling under " + load, std::move(consequences), {normal, how_steady, details}};
  }
};

}  // namespace

Explanation explain(const Model& model) { return std::visit(Explain{}, model); }

}  // namespace microslip
