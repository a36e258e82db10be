// SPDX-License-Identifier: GPL-3.0-or-later
#include "creep_tables_methods.hpp"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "creep_tables_data.hpp"
#include "creep_tables_usetab.hpp"
#include "least_time.hpp"
#include "microslip/creep_table/creep_table_file.hpp"
#include "microslip/reference/creep_force_laws.hpp"
#include "microslip/support/parallel.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

using States = std::vector<ComparedState>;

/// A method as a function of a/b and a motion; all a/b of the states are prepared.
using Evaluate = std::function<std::optional<Vector3d>(double ratio, const Vector3d& motion)>;

constexpr double sliding_of_unit_patch = 2 * std::numbers::pi / 3;

/// States for the time of a method, evenly among all that it has.
std::vector<const CreepState*> sample_of(const States& states, const ComparedMethod& method,
                                         std::size_t most) {
  std::vector<const CreepState*> all, sample;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (method.forces[i]) all.push_back(&states[i].state);
  }
  const std::size_t count = std::min(most, all.size());
  for (std::size_t i = 0; i < count; ++i) sample.push_back(all[i * all.size() / count]);
  return sample;
}

/// Time of a motion [s]; repeated until the clock can measure it.
double time_of_motion(const States& states, const ComparedMethod& method, std::size_t most,
                      int repeats, const Evaluate& evaluate) {
  const auto sample = sample_of(states, method, most);
  if (sample.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  const double time = least_time([&] {
    for (int k = 0; k < repeats; ++k) {
      for (const CreepState* state : sample) {
        const auto found = evaluate(state->ratio, state->motion);
        if (found) sum += (*found)[0];
      }
    }
  });
  // A sum that is used keeps the calls.
  return time / (static_cast<double>(sample.size()) * (std::isnan(sum) ? 0 : repeats));
}

ComparedMethod fast_method(std::string name, bool has_moment, const States& states, int repeats,
                           const Evaluate& evaluate, const auto& has) {
  ComparedMethod method{.name = std::move(name), .has_moment = has_moment};
  for (const ComparedState& one : states) {
    method.forces.push_back(has(one) ? evaluate(one.state.ratio, one.state.motion) : std::nullopt);
  }
  method.time = time_of_motion(states, method, 200, repeats, evaluate);
  return method;
}

bool has_any(const ComparedState&) { return true; }

/// The laws, with exact creep coefficients.
std::vector<ComparedMethod> laws_of(const CreepTablesParameters& p, const States& states) {
  std::map<double, CreepForceContact> contacts;
  for (const ComparedState& one : states) {
    const double ratio = one.state.ratio;
    if (contacts.contains(ratio)) continue;
    contacts[ratio] = {
        .half_width = std::sqrt(ratio),
        .lateral_half_width = 1 / std::sqrt(ratio),
        .shear_modulus = 1,
        .full_sliding = sliding_of_unit_patch,
        .coefficients = creep_coefficients(ratio, poisson_ratio_of_creep_tables).value};
  }
  const auto by = [&](const auto& law) {
    return Evaluate([&contacts, law](double ratio, const Vector3d& motion) {
      return Vector3d(law(contacts.at(ratio), motion) / sliding_of_unit_patch);
    });
  };
  const auto by_fastsim = [&](Flexibilities flexibilities) {
    return by([cells = p.fastsim_cells, flexibilities](const CreepForceContact& contact,
                                                       const Vector3d& motion) {
      return fastsim(contact, motion, flexibilities, cells);
    });
  };
  const auto without_moment = [&](Vector2d (*law)(const CreepForceContact&, const Vector3d&)) {
    return by([law](const CreepForceContact& contact, const Vector3d& motion) {
      const Vector2d force = law(contact, motion);
      return Vector3d(force[0], force[1], 0);
    });
  };
  return {fast_method("fastsim_three", true, states, 3, by_fastsim(Flexibilities::three), has_any),
          fast_method("fastsim_one", true, states, 3, by_fastsim(Flexibilities::one), has_any),
          fast_method("vermeulen_johnson", false, states, 100, without_moment(vermeulen_johnson),
                      has_any),
          fast_method("polach", false, states, 100, without_moment(polach), has_any)};
}

ComparedMethod installed_table(const States& states) {
  const CreepTable table(read_creep_table(std::string(creep_table_bytes())));
  return fast_method(
      "table", true, states, 30,
      [&](double ratio, const Vector3d& motion) { return table.forces(ratio, motion); }, has_any);
}

/// CONTACT's cases on a circle.
bool is_on_circle(const ComparedState& one) { return !one.is_random() && one.state.ratio == 1; }

ComparedMethod usetab(const CreepTablesParameters& p, const States& states) {
  std::vector<Vector3d> motions;
  for (const ComparedState& one : states) {
    if (is_on_circle(one)) motions.push_back(one.state.motion);
  }
  const UsetabLayout layout(1, motions, p.usetab_cells);
  return fast_method(
      "usetab", true, states, 1000,
      [&](double, const Vector3d& motion) { return layout.forces(motion); }, is_on_circle);
}

ComparedMethod printed_by_contact(const States& states) {
  ComparedMethod method{.name = "contact"};
  for (const ComparedState& one : states) method.forces.push_back(one.by_contact);
  return method;
}

/// Direct solutions on few cells, from rest.
ComparedMethod direct_on(Index cells, const States& states) {
  std::map<double, std::unique_ptr<UnitPatch>> patches;
  for (const ComparedState& one : states) patches[one.state.ratio];
  std::vector<double> ratios;
  for (const auto& of : patches) ratios.push_back(of.first);
  const auto make = [&](double ratio) {
    return std::make_unique<UnitPatch>(ratio, poisson_ratio_of_creep_tables, cells);
  };
  for_each_case(ratios.size(), available_cores(),
                [&](std::size_t i) { patches.at(ratios[i]) = make(ratios[i]); });
  const Evaluate evaluate = [&](double ratio, const Vector3d& motion) {
    std::optional<PatchState> state;
    return patches.at(ratio)->forces(motion, state);
  };
  ComparedMethod method{.name = fmt::format("direct_{}", cells)};
  method.forces.resize(states.size());
  for_each_case(states.size(), available_cores(), [&](std::size_t i) {
    method.forces[i] = evaluate(states[i].state.ratio, states[i].state.motion);
  });
  constexpr std::size_t timed = 40;
  method.time = time_of_motion(states, method, timed, 1, evaluate);
  const std::size_t timed_ratios = std::min<std::size_t>(5, ratios.size());
  method.setup = least_time([&] {
                   for (std::size_t i = 0; i < timed_ratios; ++i) make(ratios[i]);
                 }) /
                 static_cast<double>(timed_ratios);
  return method;
}

}  // namespace

std::vector<ComparedMethod> compared_methods(const CreepTablesParameters& p, const States& states) {
  std::vector<ComparedMethod> methods{installed_table(states), usetab(p, states)};
  for (ComparedMethod& law : laws_of(p, states)) methods.push_back(std::move(law));
  methods.push_back(printed_by_contact(states));
  for (const Index cells : p.direct) methods.push_back(direct_on(cells, states));
  return methods;
}

}  // namespace microslip::experiments
