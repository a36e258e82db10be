// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "doubts.hpp"
#include "few_steps.hpp"
#include "hertz.hpp"
#include "instants.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/large_creepage.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/straight_steps.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/units.hpp"
#include "microslip/scene/unloaded.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "run_file.hpp"
#include "slip_friction.hpp"
#include "start_file.hpp"

namespace microslip {

const std::vector<std::string> load_keys{"load.creepage", "load.force", "load.force_ratio",
                                         "load.stick_ratio"};

namespace {

/// The contact of a steady or transient scene.
struct ContactModel {
  Contact contact;
  Grid grid;
};

void warn_of_long_waves(Scene& scene, const Kernel& kernel, double half_width) {
  if (kernel.least_wave_number() * half_width <= 1) return;
  scene.warn("kernel.table", kernel.least_wave_number(),
             fmt::format("the first wave number is above 1 / half_width = {}: the bodies' symbol "
                         "is taken as constant below, although the contact is longer than these "
                         "waves",
                         format_short(1 / half_width)));
}

/// \param whole  the elements form the grid, with the offsets of the scene; otherwise nodes in the
///               middles of equal elements only say where a result is shown
/// \param tangential  the constants of the kernel
ContactModel read_contact(Scene& scene, const Material& material, const Material& tangential,
                          bool whole = true) {
  require_line_contact(scene);
  const TractionBound bound = read_bound(scene, material);
  const Kernel kernel = read_kernel(scene, tangential);
  const double a = half_width_of(bound);
  warn_of_long_waves(scene, kernel, a);
  const double mean = bound_strain(bound, 1);
  warn_of_strain(scene, 4 / std::numbers::pi * mean, material.shear_modulus);  // as Hertz's
  return {{kernel, bound},
          whole ? read_grid(scene, a)
                : Grid({.half_width = a, .elements = scene.whole("grid.elements")})};
}

AdvectionScheme read_scheme(Scene& scene) {
  const AdvectionEntry& entry = advection_scheme(scene.word("step.scheme"));
  return entry.scheme(entry.takes_relaxation ? scene.number("step.relaxation") : 1);
}

LoadHistory read_loads(Scene& scene, const TransientProblem& problem) {
  std::vector<std::string> keys = load_keys;
  keys.emplace_back("load.file");
  if (scene.one_of(keys) == "load.file") return read_run(scene, problem);
  return read_load(scene, problem.contact.kernel, problem.contact.bound);
}

bool has_step_tolerance(Scene& scene, const TransientProblem& problem) {
  return scene.has("load.file") && std::holds_alternative<Remembered>(problem.scheme) &&
         scene.has("step.tolerance");
}

/// Steps of load.file by step.tolerance, dq/dx.
std::vector<double> read_straight_steps(Scene& scene, const TransientProblem& problem,
                                        const LoadHistory& loads) {
  const double tolerance = scene.number("step.tolerance");
  scene.demand_in_range("step.tolerance", tolerance);
  const double spacing = problem.grid.spacing();
  double longest = std::numeric_limits<double>::infinity();
  if (scene.has("step.ratio")) {
    const double ratio = scene.number("step.ratio");
    require_step_ratio(ratio, "step.ratio");
    longest = ratio * spacing;
  }
  const auto lengths = straight_steps(loads, tolerance_of_load(problem, tolerance), longest,
                                      static_cast<std::size_t>(most_steps));
  require(lengths.has_value(), "step.tolerance", tolerance, [&] {
    return fmt::format("one that takes at most {} steps{}", format_short(most_steps),
                       instead_of_many_steps(problem, loads, true));
  });
  std::vector<double> ratios = *lengths;
  for (double& ratio : ratios) ratio /= spacing;
  return ratios;
}

/// \return dq/dx; of load.file without step.ratio from row to row
std::vector<double> read_steps(Scene& scene, const TransientProblem& problem,
                               const LoadHistory& loads) {
  require_few_rows(scene, problem, loads);
  if (has_step_tolerance(scene, problem)) return read_straight_steps(scene, problem, loads);
  if (scene.has("step.ratio") || loads.distances().empty()) return read_step_ratios(scene);
  return row_ratios(loads.distances(), problem.grid.spacing());
}

/// The steps to warn of: all that are given, but of rows, which may be many, the extremes.
std::vector<double> judged_steps(const Scene& scene, const std::vector<double>& step_ratios) {
  if (scene.has("step.ratio") && !scene.has("step.tolerance")) return step_ratios;
  const auto [least, most] = std::ranges::minmax(step_ratios);
  return {least, most};
}

/// How a transient begins, before it rolls.
struct Beginning {
  Start start = Rest{};
  std::vector<ShiftLoad> shifts = {};
  double distance = 0;  ///< rolled so far  [mm]
};

std::vector<double> read_start_forces(Scene& scene, const Load& load) {
  const auto* of_load = std::get_if<PrescribedForce>(&load);
  if (scene.has("start.force") || of_load == nullptr) return scene.numbers("start.force");
  return {scene.number("start.force", of_load->value)};
}

/// \param most  full sliding at the start  [N/mm]
Beginning read_shifts(Scene& scene, double most, const Load& load) {
  Beginning beginning;
  const std::string given = scene.at_most_one_of({"start.force", "start.shift"});
  if (given == "start.shift") {
    for (const double shift : scene.numbers("start.shift")) {
      beginning.shifts.emplace_back(PrescribedShift{shift});
    }
    return beginning;
  }
  const std::string key = given.empty() ? "load.force" : given;
  for (const double force : read_start_forces(scene, load)) {
    require_below_full_sliding(force, most, key);
    beginning.shifts.emplace_back(PrescribedForce{force});
  }
  if (beginning.shifts.size() > 1) return beginning;
  return {.start = CattaneoShift{std::get<PrescribedForce>(beginning.shifts.front()).value}};
}

Beginning read_beginning(Scene& scene, const TransientProblem& problem, const Load& load,
                         const ContactScale& contact) {
  const std::string type = scene.word("start.type");
  if (type == "rest") return {};
  if (type == "cattaneo") {
    const double full = full_sliding_force(problem.contact.bound);
    return read_shifts(scene, full * contact.full_sliding(), load);
  }
  if (type == "state") {
    return scene.with_file("start.state", [&]() -> Beginning {
      const SavedState saved{scene.file("start.state")};
      return {.start = saved, .distance = distance_of(saved, problem)};
    });
  }
  const std::vector<FileColumn> wanted = {{"x", "mm"}, {"traction", "N/mm^2"}};
  return {.start = scene.from_columns("start.file", wanted, [&](const auto& columns) {
    return traction_at_nodes(*columns[0], *columns[1], problem);
  })};
}

const SteadyEntry& read_steady_scheme(Scene& scene) {
  const bool chebyshev = scene.word("method") == "chebyshev";
  return steady_scheme(chebyshev ? "chebyshev" : scene.word("leading_edge"));
}

bool takes_slip_friction(const SteadyProblem& problem) {
  return !problem.contact.has_unlike_bodies() &&
         !std::holds_alternative<ChebyshevCollocation>(problem.method);
}

bool takes_slip_friction(const TransientProblem& problem) {
  return !problem.contact.has_unlike_bodies() &&
         (std::holds_alternative<Remembered>(problem.scheme) ||
          std::holds_alternative<Direct>(problem.scheme));
}

/// Takes notice of a load that has no part in the model.
Load read_no_load(Scene& scene) {
  for (const std::string& key : load_keys) {
    if (scene.has(key)) scene.number(key);
  }
  return PrescribedCreepage{0};
}

SteadyProblem read_steady(Scene& scene, const SteadyMethod& method, const Material& material,
                          bool with_load) {
  const ContactModel model = read_contact(scene, material, read_tangential(scene, material),
                                          std::holds_alternative<Differences>(method));
  const bool elements = !std::holds_alternative<ChebyshevCollocation>(method);
  return {.contact = model.contact,
          .grid = model.grid,
          .basis = elements ? read_basis(scene, model.grid) : constant_basis(),
          .method = method,
          .load = with_load ? read_load(scene, model.contact.kernel, model.contact.bound)
                            : read_no_load(scene),
          .solver = elements ? read_solver(scene) : Solver{},
          .accepted = elements ? read_acceptance(scene) : Acceptance{}};
}

/// Across the rolling, pressure displaces nothing in plane strain.
template <class Problem>
void press(Scene& scene, const Bodies& bodies, Problem& problem) {
  if (bodies.dundurs_beta == 0 || scene.word("direction") != "longitudinal") return;
  problem.contact.pressure_strain = pressure_strain(bodies, 1);
  validate(problem);  // first: where no method takes such bodies, friction is not what is missing
  const double friction = read_friction(scene);
  problem.contact.pressure_strain /= friction;
  problem.contact.coupling = bodies.dundurs_beta * friction;
}

SteadyProblem read_steady(Scene& scene, bool with_load) {
  const SteadyEntry& entry = read_steady_scheme(scene);
  const double step_ratio = entry.safe_steps ? scene.number("step.ratio") : 1;
  require_step_ratio(step_ratio, "step.ratio");
  const Bodies bodies = read_bodies(scene);
  SteadyProblem problem = solved_by(
      entry, read_steady(scene, entry.method(step_ratio), bodies.combined, with_load), step_ratio);
  press(scene, bodies, problem);
  if (takes_slip_friction(problem)) problem.friction = read_slip_friction(scene);
  const std::string instead = "leading_edge inversion";
  if (entry.safe_steps) warn_outside(scene, *entry.safe_steps, "step.ratio", step_ratio, instead);
  if (entry.by_elements) {
    warn_outside(scene, safe_elements(problem.basis), "grid.elements",
                 static_cast<double>(problem.grid.size()), instead);
  }
  if (entry.safe_steps) {
    warn_near_full_sliding(scene, problem.load, problem.contact.bound, problem.grid.size(),
                           instead);
  }
  return problem;
}

}  // namespace

SteadyProblem read_steady(Scene& scene) { return read_steady(scene, true); }

SteadyProblem read_unloaded_steady(Scene& scene) { return read_steady(scene, false); }

SteadyTarget read_steady_target(Scene& scene) {
  const double target = scene.number("target_error");
  require_target_error(target);
  const Material material = read_material_if_any(scene);
  const Material tangential = read_tangential(scene, material);
  const TractionBound bound = read_bound(scene, material);
  const Kernel kernel = read_kernel(scene, tangential);
  warn_of_long_waves(scene, kernel, half_width_of(bound));
  const Load load = read_load(scene, kernel, bound);
  return {{{kernel, bound}, load}, target};
}

SteadyProblem read_steady(Scene& scene, const SteadyMethod& method) {
  return read_steady(scene, method, read_material(scene), true);
}

std::vector<double> TransientScene::step_lengths() const {
  std::vector<double> lengths = step_ratios;
  for (double& length : lengths) length *= problem.grid.spacing();
  return lengths;
}

namespace {

TransientProblem read_contact_of_transient(Scene& scene) {
  const Bodies bodies = read_bodies(scene);
  const Material& material = bodies.combined;
  const ContactModel model = read_contact(scene, material, read_tangential(scene, material));
  TransientProblem problem{.contact = model.contact,
                           .grid = model.grid,
                           .basis = read_basis(scene, model.grid),
                           .scheme = read_scheme(scene),
                           .solver = read_solver(scene),
                           .accepted = read_acceptance(scene)};
  press(scene, bodies, problem);
  require_definite(problem);
  return problem;
}

}  // namespace

TransientProblem read_transient_problem(Scene& scene) {
  TransientProblem problem = read_contact_of_transient(scene);
  if (takes_slip_friction(problem)) problem.friction = read_slip_friction(scene);
  validate(problem);
  return problem;
}

TransientScene read_transient(Scene& scene) {
  TransientProblem problem = read_contact_of_transient(scene);
  const LoadHistory loads = read_loads(scene, problem);
  if (takes_slip_friction(problem)) problem.friction = read_slip_friction(scene, loads);
  validate(problem);
  const std::vector<double> step_ratios = read_steps(scene, problem, loads);
  const std::vector<double> judged = judged_steps(scene, step_ratios);
  for (const double ratio : judged) {
    require_step_ratio(ratio, "step.ratio");
    warn_outside(scene, entry_of(problem.scheme).safe_steps, "step.ratio", ratio,
                 "step.scheme remembered");
  }
  if (!std::holds_alternative<Remembered>(problem.scheme)) {
    warn_outside(scene, safe_elements(problem.basis), "grid.elements",
                 static_cast<double>(problem.grid.size()), "step.scheme remembered");
    warn_near_full_sliding(scene, loads.at(0), problem.contact.bound, problem.grid.size(),
                           "step.scheme remembered");
  }
  if (problem.contact.pressure_strain == 0) warn_of_unresolved_table(scene, problem, loads);
  const Load load = loads.at(0);
  const Beginning beginning = read_beginning(scene, problem, load, loads.contact_at(0));
  warn_of_sudden_force(scene, loads, step_ratios.front() * problem.grid.spacing());
  const double distance = read_distance(scene, loads.distance(), beginning.distance);
  const double mean = std::accumulate(step_ratios.begin(), step_ratios.end(), 0.0) /
                      static_cast<double>(step_ratios.size());
  require_few_steps(distance, beginning.distance, mean * problem.grid.spacing(), [&] {
    return instead_of_many_steps(problem, loads, has_step_tolerance(scene, problem));
  });
  TransientScene read{.problem = problem,
                      .start = beginning.start,
                      .shifts = beginning.shifts,
                      .distance = distance,
                      .step_ratios = step_ratios,
                      .loads = loads,
                      .from = beginning.distance};
  const std::vector<double> lengths = read.step_lengths(), ends = loads.ends_of_steps();
  const RunSteps steps{distance, lengths, read.from, ends};
  read.instants = read_instants(scene, steps);
  warn_of_missed_rows(scene, steps, loads, [&](double at) -> Eigen::Vector3d {
    const Load there = loads.at(at);
    const auto* force = std::get_if<PrescribedForce>(&there);
    return {force == nullptr ? 0 : force->value / full_sliding_force(problem.contact.bound), 0, 0};
  });
  if (Prescribed(load).by_force) {
    warn_of_short_end(scene, read);
    for (const double ratio : judged) warn_of_noise(scene, problem.grid.size(), ratio);
  }
  return read;
}

CylinderScene read_cylinder(Scene& scene, const AdvectionScheme& scheme, Integrator integrator) {
  const Material material = read_material(scene);
  const ContactModel model = read_contact(scene, material, material);
  // This is not written within the braces of the scene, because GCC 12 destroys a nested aggregate
  // twice if a later reader throws.
  const TransientProblem problem{.contact = model.contact,
                                 .grid = model.grid,
                                 .basis = read_basis(scene, model.grid),
                                 .scheme = scheme,
                                 .solver = read_solver(scene),
                                 .accepted = read_acceptance(scene)};
  CylinderScene cylinder{.problem = problem,
                         .cylinder = {.mass = scene.positive("cylinder.mass"),
                                      .inertia = scene.positive("cylinder.inertia"),
                                      .radius = scene.positive("cylinder.radius"),
                                      .slope_force = scene.positive("cylinder.slope_force")},
                         .integrator = integrator,
                         .step_ratio = scene.number("step.ratio"),
                         .distance = scene.number("motion.distance")};
  warn_of_other_radius(scene, cylinder.cylinder.radius);
  warn_of_small_radius(scene, "cylinder.radius", cylinder.cylinder.radius,
                       half_width_of(model.contact.bound));
  require_definite(cylinder.problem);
  require_positive("motion.distance", cylinder.distance);
  require_step_ratio(cylinder.step_ratio, "step.ratio");
  require_few_steps(cylinder.distance, 0, cylinder.step_ratio * model.grid.spacing(),
                    [] { return ""; });
  warn_outside(scene, entry_of(scheme).safe_steps, "step.ratio", cylinder.step_ratio,
               "step.scheme remembered");
  return cylinder;
}

CylinderScene read_cylinder(Scene& scene) {
  const std::string integrator = scene.word("motion.integrator");
  const AdvectionScheme scheme = read_scheme(scene);
  CylinderScene cylinder = read_cylinder(scene, scheme,
                                         integrator == "midpoint" ? Integrator::midpoint
                                         : integrator == "verlet" ? Integrator::verlet
                                                                  : Integrator::leapfrog);
  const double velocity = scene.number("cylinder.velocity");
  require(velocity >= 0, "cylinder.velocity", velocity, "a number >= 0");
  cylinder.cylinder.velocity = velocity;
  constexpr const char* tolerance = "motion.tolerance";
  if (cylinder.integrator == Integrator::midpoint && scene.has(tolerance)) {
    cylinder.tolerance = scene.number(tolerance);
    require_tolerance(*cylinder.tolerance);
  }
  return cylinder;
}

namespace {

Model read_any(Scene& scene) {
  const std::string problem = scene.word("problem");
  if (problem == "steady" && scene.has_patch()) {
    if (scene.has("target_error")) return read_patch_target(scene);
    return read_steady_patch(scene);
  }
  if (problem == "transient" && scene.has_patch()) return read_patch_transient(scene);
  if (problem == "transient") return read_transient(scene);
  if (problem == "cylinder") return read_cylinder(scene);
  if (scene.has("target_error")) return read_steady_target(scene);
  return read_steady(scene);
}

}  // namespace

Model read_model(Scene& scene) {
  try {
    return read_any(scene);
  } catch (const MissingKey& first) {
    throw all_missing(scene, first, [](Scene& completed) { read_any(completed); });
  }
}

Eigen::Index elements_of(const Model& model) {
  struct Elements {
    Eigen::Index operator()(const SteadyProblem& problem) const { return problem.grid.size(); }
    Eigen::Index operator()(const SteadyTarget&) const { return 0; }
    Eigen::Index operator()(const SteadyPatch& patch) const { return patch.elements; }
    Eigen::Index operator()(const PatchTarget& target) const { return target.patch.elements; }
    Eigen::Index operator()(const TransientScene& scene) const { return scene.problem.grid.size(); }
    Eigen::Index operator()(const PatchTransient& scene) const { return scene.patch.elements; }
    Eigen::Index operator()(const CylinderScene& scene) const { return scene.problem.grid.size(); }
  };
  return std::visit(Elements{}, model);
}

}  // namespace microslip
