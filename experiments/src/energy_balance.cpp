// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/energy_balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "cylinder_trajectory.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/convergence.hpp"
#include "microslip/support/format.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Parameters = EnergyBalanceParameters;

struct Named {
  std::string name;  ///< of the scheme
  AdvectionScheme scheme;
  std::string integrator;
  Integrator rule;
};

std::vector<Named> combinations() {
  std::vector<Named> all;
  for (const AdvectionScheme& scheme : {AdvectionScheme(Direct{}), AdvectionScheme(Remembered{})}) {
    const std::string name = name_of(scheme);
    all.push_back({name, scheme, "verlet", Integrator::verlet});
    all.push_back({name, scheme, "leapfrog", Integrator::leapfrog});
    all.push_back({name, scheme, "midpoint", Integrator::midpoint});
  }
  return all;
}

RollingCylinder cylinder_on(const Parameters& p, Index elements, const AdvectionScheme& scheme,
                            Integrator integrator, double step_ratio,
                            std::optional<double> tolerance) {
  TransientProblem contact = p.scene.problem;
  contact.scheme = scheme;
  contact.grid = Grid({.half_width = contact.grid.half_width(), .elements = elements});
  return {contact, p.scene.cylinder, integrator, step_ratio, tolerance};
}

RollingCylinder cylinder_on(const Parameters& p, Index elements, const AdvectionScheme& scheme,
                            Integrator integrator) {
  return cylinder_on(p, elements, scheme, integrator, p.scene.step_ratio, {});
}

struct Tables {
  Table motion{"motion",
               "the motion (remembered, midpoint)",
               {{"X", "mm", "distance rolled"},
                {"t", "s", "time"},
                {"v", "mm/s", "velocity"},
                {"omega_R", "mm/s", "angular velocity times radius"},
                {"force", "N/mm", "force F of the contact"},
                {"creepage", "1", "(v - omega R)/v"},
                {"predicted_wavelength", "mm", "v times the period on a contact that sticks"}}};
  Table snapshots{"snapshots",
                  "tractions on the way",
                  {{"X", "mm", "distance rolled"},
                   {"x", "mm", "position in the contact, rolling towards +x"},
                   {"bound", "N/mm^2", "traction bound g"},
                   {"traction", "N/mm^2", "tangential traction p"}}};
  Table energy{
      "energy",
      "energies against the distance, per mm of width",
      {{"scheme", "1", "step.scheme: direct or remembered"},
       {"integrator", "1", "verlet, leapfrog or midpoint"},
       {"X", "mm", "distance rolled"},
       {"potential", "N", "-F_cm X"},
       {"translation", "N", "m v^2/2"},
       {"rotation", "N", "I omega^2/2"},
       {"elastic", "N", "half the integral of p u"},
       {"dissipated", "N", "thesis (9.11), tractions at the end of each step"},
       {"total", "N", "sum of the five; exact: 0"},
       {"mean_dissipated", "N",
        "mean tractions of material points (direct); work that is not stored (remembered)"},
       {"mean_total", "N", "sum with that; exact: 0", 1e-12}}};
  Table energy_error{"energy_error",
                     "error of the balance over the energy turned over",
                     {{"scheme", "1", "step.scheme"},
                      {"integrator", "1", "verlet, leapfrog or midpoint"},
                      {"elements", "1", "N"},
                      {"steps", "1", "steps made"},
                      {"error", "1", "|total| / (F_cm X) with the thesis's ledger"},
                      {"mean_error", "1", "the same with mean_dissipated", 1e-10},
                      {"velocity", "mm/s", "at the end"}}};
  Table motion_error{"motion_error",
                     "motion against the motion on a finer grid (remembered, midpoint), root of "
                     "mean square",
                     {{"scheme", "1", "step.scheme"},
                      {"integrator", "1", "verlet, leapfrog or midpoint"},
                      {"elements", "1", "N"},
                      {"contact_steps", "1", "steps of the contact solved"},
                      {"position_error", "1", "over the distance"},
                      {"velocity_error", "1", "over the velocity at the end"},
                      {"rotation_error", "1", "of omega, over omega at the end"}}};
  Table step_control{"step_control",
                     "error of v by the length of time steps alone, root of mean square "
                     "(remembered, midpoint)",
                     {{"steps", "1", "equal, or by tolerance"},
                      {"ratio", "1", "c"},
                      {"tolerance", "1", "nan for equal steps"},
                      {"count", "1", "steps made"},
                      {"contact_steps", "1", "steps of the contact solved"},
                      {"velocity_error", "1", "over the velocity at the end"}}};
  Table orders{"orders",
               "fitted orders in dx",
               {{"scheme", "1", "step.scheme"},
                {"integrator", "1", "verlet, leapfrog or midpoint"},
                {"quantity", "1", "what converges"},
                {"order", "1", "least-squares slope"}}};
};

void add_energy(Table& table, const Named& named, const RollingCylinder& body) {
  const EnergyLedger e = body.ledger();
  table.add({named.name, named.integrator, body.state().position, e.potential, e.translation,
             e.rotation, e.elastic, e.end_dissipated, e.end_total(), e.dissipated, e.total()});
}

/// Returns the times between one braking maximum of the force and the next.
std::vector<double> force_periods(const Table& motion) {
  std::vector<double> maxima;
  for (std::size_t i = 1; i + 1 < motion.rows(); ++i) {
    const auto braking = [&](std::size_t row) { return -motion.number(row, "force"); };
    if (braking(i) > braking(i - 1) && braking(i) >= braking(i + 1)) {
      maxima.push_back(motion.number(i, "t"));
    }
  }
  std::vector<double> periods;
  for (std::size_t i = 1; i < maxima.size(); ++i) periods.push_back(maxima[i] - maxima[i - 1]);
  return periods;
}

/// Adds the motion with snapshots and energies. Returns the period on a contact that sticks.
double add_motion(Tables& tables, const Parameters& p) {
  const double radius = p.scene.cylinder.radius;
  const Index elements = p.scene.problem.grid.size();
  double period = 0;
  for (const Named& named : combinations()) {
    if (named.integrator == "leapfrog") continue;
    RollingCylinder body = cylinder_on(p, elements, named.scheme, named.rule);
    const bool shown = named.name == "remembered" && named.integrator == "midpoint";
    if (shown) period = body.period();
    std::size_t snapshot = 0;
    while (body.state().position < p.scene.distance) {
      body.step();
      add_energy(tables.energy, named, body);
      if (!shown) continue;
      const CylinderState& s = body.state();
      tables.motion.add({s.position, s.time, s.velocity, s.angular_velocity * radius, s.force,
                         s.creepage, s.velocity * period});
      if (snapshot == p.snapshots.size() || s.position < p.snapshots[snapshot]) continue;
      ++snapshot;
      const TransientRolling& contact = body.contact();
      for (Index i = 0; i < contact.x().size(); ++i) {
        if (contact.bound()[i] <= 0) continue;
        tables.snapshots.add(
            {s.position, contact.x()[i], contact.bound()[i], contact.state().traction[i]});
      }
    }
  }
  return period;
}

void add_energy_errors(Tables& tables, const Parameters& p, const Progress& progress,
                       std::size_t total) {
  std::size_t done = 0;
  for (const Named& named : combinations()) {
    std::vector<double> sizes, errors, mean_errors;
    for (const Index elements : p.sizes) {
      RollingCylinder body = cylinder_on(p, elements, named.scheme, named.rule);
      double steps = 0;
      for (; body.state().position < p.error_distance; ++steps) body.step();
      const EnergyLedger ledger = body.ledger();
      sizes.push_back(static_cast<double>(elements));
      errors.push_back(std::abs(ledger.end_total() / ledger.potential));
      mean_errors.push_back(std::abs(ledger.total() / ledger.potential));
      tables.energy_error.add({named.name, named.integrator, sizes.back(), steps, errors.back(),
                               mean_errors.back(), body.state().velocity});
      progress(++done, total);
    }
    tables.orders.add({named.name, named.integrator, "energy", fitted_order(sizes, errors)});
    if (named.name == "remembered" && named.integrator != "midpoint") {
      tables.orders.add(
          {named.name, named.integrator, "mean energy", fitted_order(sizes, mean_errors)});
    }
  }
}

Eigen::VectorXd times_to(double end) { return Eigen::VectorXd::LinSpaced(200, end / 200, end); }

/// Returns the time at which a body with the shown grid has rolled a distance.
double time_of(const Parameters& p, double distance) {
  RollingCylinder body =
      cylinder_on(p, p.scene.problem.grid.size(), Remembered{}, Integrator::verlet);
  while (body.state().position < distance) body.step();
  return body.state().time;
}

void add_motion_errors(Tables& tables, const Parameters& p) {
  const Eigen::VectorXd times = times_to(time_of(p, p.error_distance));
  const Trajectory fine = trajectory(
      cylinder_on(p, p.refinement * p.motion_sizes.back(), Remembered{}, Integrator::midpoint),
      p.scene.cylinder, times);
  for (const Named& named : combinations()) {
    std::vector<double> sizes;
    std::array<std::vector<double>, 3> errors;
    for (const Index elements : p.motion_sizes) {
      const Trajectory coarse =
          trajectory(cylinder_on(p, elements, named.scheme, named.rule), p.scene.cylinder, times);
      const Eigen::Array3d error = errors_of(coarse, fine);
      sizes.push_back(static_cast<double>(elements));
      for (std::size_t i = 0; i < 3; ++i) errors[i].push_back(error[static_cast<Index>(i)]);
      tables.motion_error.add({named.name, named.integrator, sizes.back(), coarse.contact_steps,
                               error[0], error[1], error[2]});
    }
    constexpr std::array quantities = {"position", "velocity", "rotation"};
    for (std::size_t i = 0; i < 3; ++i) {
      tables.orders.add(
          {named.name, named.integrator, quantities[i], fitted_order(sizes, errors[i])});
    }
  }
}

/// Adds what the control of steps gains, on the shown grid over the shown distance.
void add_step_control(Tables& tables, const Parameters& p) {
  const Eigen::VectorXd times = times_to(time_of(p, p.scene.distance));
  const auto rolled = [&](double step_ratio, std::optional<double> tolerance) {
    return trajectory(cylinder_on(p, p.scene.problem.grid.size(), Remembered{},
                                  Integrator::midpoint, step_ratio, tolerance),
                      p.scene.cylinder, times);
  };
  constexpr double finer = 4;
  const Trajectory fine = rolled(p.step_ratios.back() / finer, {});
  const auto add = [&](const char* steps, double step_ratio, std::optional<double> tolerance) {
    const Trajectory coarse = rolled(step_ratio, tolerance);
    tables.step_control.add({steps, step_ratio, tolerance.value_or(not_given), coarse.steps,
                             coarse.contact_steps, errors_of(coarse, fine)[1]});
  };
  for (const double step_ratio : p.step_ratios) add("equal", step_ratio, {});
  for (const double tolerance : p.tolerances) add("tolerance", p.step_ratios.front(), tolerance);
}

/// Divides the number of equal steps that reach the error of the smallest tolerance by the number
/// of steps by tolerance. The error falls with the square of the number of equal steps.
double saved_by_tolerance(const Parameters& p, const Table& control) {
  const auto square_root_error = [&](std::size_t row) {
    return std::sqrt(control.number(row, "velocity_error"));
  };
  const std::size_t equal = p.step_ratios.size() - 1, last = control.rows() - 1;
  return control.number(equal, "count") * square_root_error(equal) / square_root_error(last) /
         control.number(last, "count");
}

double order_of(const Tables& tables, const Named& named, const std::string& quantity) {
  return tables.orders.latest(
      {{"scheme", named.name}, {"integrator", named.integrator}, {"quantity", quantity}}, "order");
}

/// Fits the order of the energy balance with tractions at the end of each step, to the last three
/// of n rows.
double end_order_on_fine_grids(const Table& errors, std::size_t first, std::size_t n) {
  std::vector<double> sizes, values;
  for (std::size_t row = first + n - 3; row < first + n; ++row) {
    sizes.push_back(errors.number(row, "elements"));
    values.push_back(errors.number(row, "error"));
  }
  return fitted_order(sizes, values);
}

Table claims_of(const Tables& tables, const Parameters& p, double period) {
  const Named thesis{"direct", Direct{}, "verlet", Integrator::verlet};
  const Named ours{"remembered", Remembered{}, "midpoint", Integrator::midpoint};
  const double factor = std::pow(2, order_of(tables, thesis, "energy"));
  const Table& errors = tables.energy_error;
  const std::size_t n = errors.rows() / combinations().size();
  double integrators = 0, exact = 0;
  for (std::size_t k = 0; k < n; ++k) {
    for (const std::size_t scheme : {std::size_t{0}, 3 * n}) {
      const double verlet = errors.number(scheme + k, "velocity");
      const double leapfrog = errors.number(scheme + n + k, "velocity");
      integrators = std::max(integrators, std::abs(verlet / leapfrog - 1));
    }
    exact = std::max(exact, errors.number(5 * n + k, "mean_error"));
  }
  const std::vector<double> periods = force_periods(tables.motion);
  const double first = periods.empty() ? not_given : periods.front() / period;
  const auto velocity_error = [&](const char* integrator) {
    return tables.motion_error.latest({{"scheme", "remembered"}, {"integrator", integrator}},
                                      "velocity_error");
  };
  return claims_table(
      {{"doubling N divides the error in the energy by 1.7", "9", 1.7, factor, "1",
        holds_if({between(1.5, 2.1)}), "fitted over all N, direct scheme", "energy_balance_error"},
       {"no difference between Verlet and leapfrog", "9", 0, integrators, "1",
        holds_if({within(1e-10, 0)}),
        "largest relative difference of v at the end: as printed they are the same scheme",
        "energy_balance_error"},
       {"the traction oscillates until slip, traction and rotation have settled", "9", not_given,
        static_cast<double>(periods.size()), "1", holds_if({above(2)}),
        "periods of the force within the distance shown", "energy_balance_motion"},
       {"the body swings on the contact: period in time, wavelength growing as v", "9", not_given,
        first, "1", ours_if({within(0.25, 1)}),
        "first period of the force, over 2 pi sqrt(m'/k) of a contact that sticks",
        "energy_balance_motion"},
       {"the balance is first order with tractions at the end of each step", "9", not_given,
        end_order_on_fine_grids(errors, 3 * n, n), "1", ours_if({within(0.25, 1)}),
        "order of the energy error over the last three N, remembered scheme, Verlet",
        "energy_balance_error"},
       {"if work that the contact does not store is dissipated, the midpoint rule balances to "
        "rounding",
        "9", 0, exact, "1", ours_if({within(1e-10, 0)}),
        "largest error over the energy turned over, any N", "energy_balance_error"},
       {"exact bookkeeping is no proof of accuracy", "9", not_given,
        velocity_error("midpoint") / velocity_error("verlet"), "1", ours_if({between(0.5, 3)}),
        "error of v(t) by the midpoint rule over the error by Verlet, largest N",
        "energy_balance_error"},
       {"the motion is of second order", "9", not_given, order_of(tables, ours, "velocity"), "1",
        ours_if({within(0.2, 2)}),
        "order of v(t), remembered and midpoint rule; the order of Verlet is " +
            format_short(std::round(100 * tables.orders.latest({{"scheme", "remembered"},
                                                                {"integrator", "verlet"},
                                                                {"quantity", "velocity"}},
                                                               "order")) /
                         100),
        "energy_balance_cost"},
       {"a tolerance saves steps", "9", not_given, saved_by_tolerance(p, tables.step_control), "1",
        ours_if({above(1.5)}),
        "equal steps of the same error, over the steps of the smallest tolerance",
        "energy_balance_cost"}});
}

}  // namespace

EnergyBalanceParameters read_energy_balance(Scene& scene) {
  using P = EnergyBalanceParameters;
  const StudyKeys<P> keys(
      scene, {{&P::snapshots, "snapshots.positions", "mm", "of the tractions shown", range_from(0),
               rising},
              {&P::sizes, "error.sizes", "numbers N of nodes, for the errors of the energy",
               range(2, Grid::max_elements), three_or_more},
              {&P::error_distance, "error.distance", "mm", "distance after which errors are taken",
               above_zero},
              {&P::motion_sizes, "motion.sizes", "numbers N of nodes, for the errors of the motion",
               range(2, Grid::max_elements), three_or_more},
              {&P::refinement, "motion.refinement",
               "elements of the grid taken as exact for each one of the last of motion.sizes",
               range(2, 1000)},
              {&P::step_ratios, "control.step_ratios",
               "c of equal steps that a tolerance is held against", above_zero, falling},
              {&P::tolerances, "control.tolerances",
               "motion.tolerance, with the first of control.step_ratios", range_above(0, 1)}});
  return keys.read({.scene = read_cylinder(scene, Remembered{}, Integrator::midpoint)});
}

std::vector<Table> energy_balance(const EnergyBalanceParameters& p, const Progress& progress) {
  Tables tables;
  const std::size_t errors = combinations().size() * p.sizes.size();
  const std::size_t total = errors + 2;
  const double period = add_motion(tables, p);
  add_energy_errors(tables, p, progress, total);
  add_motion_errors(tables, p);
  progress(errors + 1, total);
  add_step_control(tables, p);
  progress(total, total);
  return {tables.motion,       tables.snapshots,    tables.energy, tables.energy_error,
          tables.motion_error, tables.step_control, tables.orders, claims_of(tables, p, period)};
}

}  // namespace microslip::experiments
