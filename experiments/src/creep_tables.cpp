// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/creep_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "creep_tables_methods.hpp"
#include "creep_tables_states.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/support/error_sizes.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::Vector3d;

namespace {

using Methods = std::vector<ComparedMethod>;
using Compared = std::vector<ComparedState>;

/// Forces and moments that are rounding, over full sliding.
constexpr double rounding_of_solutions = 1e-7;

constexpr const char* meaning_of_methods =
    "table: the installed one; usetab: USETAB's layout at a/b = 1; fastsim_three, fastsim_one: "
    "flexibilities; vermeulen_johnson: spin as by Shen, Hedrick and Elkins; polach; contact: "
    "printed, on 11 x 11; direct_N: direct solutions, N cells of a circle";

/// The larger one of the errors of both forces.
double error_of_force(const Vector3d& error) { return error.head<2>().cwiseAbs().maxCoeff(); }

/// Errors of a method in the wanted states, by component; the last ones are those of the force.
struct MethodErrors {
  std::array<ErrorSizes, 3> components;
  ErrorSizes force;

  MethodErrors(const ComparedMethod& method, const Compared& states, const auto& wanted) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (!method.forces[i] || !wanted(states[i])) continue;
      const Vector3d error = *method.forces[i] - states[i].state.forces;
      for (std::size_t c = 0; c < (method.has_moment ? 3 : 2); ++c) {
        components[c].add(error[static_cast<Index>(c)]);
      }
      force.add(error_of_force(error));
    }
  }
};

struct StateSet {
  const char* name;
  bool (*has)(const ComparedState&);
};

constexpr std::array<StateSet, 6> state_sets{
    {{"all", [](const ComparedState&) { return true; }},
     {"random", [](const ComparedState& one) { return one.is_random(); }},
     {"contact", [](const ComparedState& one) { return !one.is_random(); }},
     {"without_spin", [](const ComparedState& one) { return !one.has_spin; }},
     {"with_spin", [](const ComparedState& one) { return !one.is_random() && one.has_spin; }},
     {"circle",
      [](const ComparedState& one) { return !one.is_random() && one.state.ratio == 1; }}}};

Table states_table(const Compared& states, const Methods& methods) {
  std::vector<Column> columns{
      {"set", "1", "random, or contact: CONTACT's public test table"},
      {"ratio", "1", "a/b"},
      {"creepage", "1", "xi over mu p0/G"},
      {"lateral_creepage", "1", "eta over mu p0/G"},
      {"spin", "1", "phi c over mu p0/G"},
      {"force", "1", "Fx over mu F_n, reference", rounding_of_solutions},
      {"lateral_force", "1", "Fy over mu F_n, reference", rounding_of_solutions},
      {"spin_moment", "1", "Mz over mu F_n c, reference", rounding_of_solutions}};
  // The installed table may become another one, and with it its errors.
  for (const ComparedMethod& method : methods) {
    if (method.name == "table") continue;
    columns.push_back({method.name, "1", "larger error of both forces; nan where there is none",
                       rounding_of_solutions});
  }
  Table table("states", "motions with their references, and errors of the methods", columns);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [ratio, motion, forces] = states[i].state;
    std::vector<Cell> row{states[i].is_random() ? "random" : "contact", ratio};
    for (const double value : motion) row.emplace_back(value);
    for (const double value : forces) row.emplace_back(value);
    for (const ComparedMethod& method : methods) {
      if (method.name == "table") continue;
      row.emplace_back(method.forces[i] ? error_of_force(*method.forces[i] - forces) : not_given);
    }
    table.add(std::move(row));
  }
  return table;
}

/// Errors of the references, and of the table in the same states.
struct ReferenceErrors {
  Table table{"reference",
              "errors of the references: changes to solutions on finer grids, over full sliding",
              {{"ratio", "1", "a/b; 0 for all of them"},
               {"states", "1", "random motions"},
               {"cells", "1", "of a circle, and one more"},
               {"fine_cells", "1", "the same of the finer grids"},
               {"force_rms", "1", "of Fx, root of the mean square"},
               {"lateral_force_rms", "1", "of Fy"},
               {"spin_moment_rms", "1", "of Mz"},
               {"largest", "1", "of all"},
               {"unsolved", "1", "motions of the study without a reference"}}};
  double rms = not_given;  ///< of all components

  ReferenceErrors(const CreepTablesParameters& p, const SolvedStates& solved) {
    std::vector<double> ratios{0};
    for (const auto& pair : solved.finer) {
      if (pair[0].ratio != ratios.back()) ratios.push_back(pair[0].ratio);
    }
    for (const double ratio : ratios) {
      std::array<ErrorSizes, 3> sizes;
      ErrorSizes all;
      for (const auto& [one, fine] : solved.finer) {
        if (ratio != 0 && one.ratio != ratio) continue;
        for (std::size_t c = 0; c < 3; ++c) {
          const double change =
              one.forces[static_cast<Index>(c)] - fine.forces[static_cast<Index>(c)];
          sizes[c].add(change);
          all.add(change);
        }
      }
      table.add({ratio, sizes[0].count(), p.cells, p.fine_cells, sizes[0].rms(), sizes[1].rms(),
                 sizes[2].rms(), all.part(1), solved.unsolved});
      if (ratio == 0) rms = all.rms();
    }
  }
};

Table errors_table(const Compared& states, const Methods& methods) {
  std::vector<Column> columns{{"method", "1", meaning_of_methods},
                              {"set", "1",
                               "random; contact: CONTACT's test table, with_spin or without_spin; "
                               "circle: those at a/b = 1; "
                               "all: random and contact"},
                              {"states", "1", "motions that have a result"},
                              {"none", "1", "motions that have none"}};
  for (const char* of : {"force", "lateral_force", "spin_moment"}) {
    for (const char* size : {"rms", "99", "largest"}) {
      columns.push_back({std::string(of) + "_" + size, "1",
                         "error over full sliding: root of the mean square, 99 %, or largest"});
    }
  }
  Table table("errors", "errors of methods for creep forces", columns);
  for (const ComparedMethod& method : methods) {
    for (const StateSet& set : state_sets) {
      const MethodErrors errors(method, states, set.has);
      const std::size_t count = errors.force.count();
      if (count == 0) continue;
      const auto wanted = static_cast<std::size_t>(std::ranges::count_if(states, set.has));
      // A method that is for some states only has no part in sets with others.
      const bool is_partial = method.name == "usetab" || method.name == "contact";
      if (is_partial && count < wanted) continue;
      std::vector<Cell> row{method.name, set.name, count, wanted - count};
      for (const ErrorSizes& sizes : errors.components) {
        for (const double value : {sizes.rms(), sizes.part(0.99), sizes.part(1)}) {
          row.emplace_back(value);
        }
      }
      table.add(std::move(row));
    }
  }
  return table;
}

Table ratios_table(const Compared& states, const Methods& methods) {
  Table table("ratios", "errors of methods over a/b, roots of mean squares over full sliding",
              {{"method", "1", meaning_of_methods},
               {"set", "1", "random, or contact: CONTACT's test table"},
               {"ratio", "1", "a/b"},
               {"states", "1", "number of motions"},
               {"force", "1", "of the larger error of both forces"},
               {"spin_moment", "1", "of the moment"}});
  std::set<std::pair<bool, double>> ratios;
  for (const ComparedState& one : states) ratios.emplace(one.is_random(), one.state.ratio);
  for (const ComparedMethod& method : methods) {
    for (const auto& at : ratios) {
      const MethodErrors errors(method, states, [&](const ComparedState& one) {
        return at == std::pair(one.is_random(), one.state.ratio);
      });
      if (errors.force.count() == 0) continue;
      table.add({method.name, at.first ? "random" : "contact", at.second, errors.force.count(),
                 errors.force.rms(), errors.components[2].rms()});
    }
  }
  return table;
}

Table distribution_table(const Compared& states, const Methods& methods) {
  Table table("distribution", "the larger error of both forces that a share of all motions exceeds",
              {{"method", "1", meaning_of_methods},
               {"share", "1", "of the motions"},
               {"error", "1", "over full sliding"}});
  constexpr int places = 40;
  for (const ComparedMethod& method : methods) {
    const MethodErrors errors(method, states, [](const ComparedState&) { return true; });
    const std::size_t count = errors.force.count();
    if (count < 2) continue;
    for (int i = 0; i < places; ++i) {
      const double share = log_spaced(1 / static_cast<double>(count), 1.0, i, places);
      table.add({method.name, share, errors.force.part(1 - share)});
    }
  }
  return table;
}

/// Measured times, and the errors beside them in all states that a method has.
Table times_table(const Compared& states, const Methods& methods) {
  Table table("cost_timing", "times of methods for creep forces on one core, and their errors",
              {{"method", "1", meaning_of_methods},
               {"time", "s", "of a motion"},
               {"setup", "s", "once for each a/b"},
               {"rms", "1", "of the larger error of both forces, over full sliding"},
               {"of_99_percent", "1", "the same, of 99 % of the motions"}});
  for (const ComparedMethod& method : methods) {
    const MethodErrors errors(method, states, [](const ComparedState&) { return true; });
    table.add(
        {method.name, method.time, method.setup, errors.force.rms(), errors.force.part(0.99)});
  }
  return table;
}

Table claims_of(const CreepTablesParameters& p, const Table& errors,
                const ReferenceErrors& reference) {
  constexpr std::array<const char*, 2> forces{"force", "lateral_force"};
  const auto at = [&](const std::string& method, const char* set, const std::string& column) {
    return errors.latest({{"method", method}, {"set", set}}, column);
  };
  const auto of_force = [&](const std::string& method, const char* set, const std::string& size) {
    double most = not_given;
    for (const char* force : forces) most = std::fmax(most, at(method, set, force + ("_" + size)));
    return most;
  };
  const auto of_all = [&](const std::string& method, const char* set, const std::string& size) {
    return std::fmax(of_force(method, set, size), at(method, set, "spin_moment_" + size));
  };
  const auto least_of_laws = [&](const char* set, const char* size) {
    double least = not_given;
    for (const char* law : {"fastsim_three", "fastsim_one", "vermeulen_johnson", "polach"}) {
      least = std::fmin(least, of_force(law, set, size));
    }
    return least;
  };
  const std::string few = "direct_" + std::to_string(p.direct.front());
  const std::string more = "direct_" + std::to_string(p.direct.back());
  constexpr const char* curves = "creep_tables_distribution";
  constexpr const char* over_ratios = "creep_tables_ratios";
  return claims_table(
      {{"references are right to three ten-thousandths of full sliding", "none", not_given,
        reference.rms, "1", ours_if({below(3e-4)}),
        "root of the mean square of changes to finer grids, all components", no_figure},
       {"the table has the forces of 99 % of the motions to half a percent of full sliding", "none",
        not_given, of_force("table", "all", "99"), "1", ours_if({below(0.005)}),
        "the larger one of Fx and Fy", curves},
       {"the table has all forces and moments to two percent of full sliding", "none", not_given,
        of_all("table", "all", "largest"), "1", ours_if({below(0.02)}),
        "largest error of a component", curves},
       {"the table has a tenth of the errors of the best of the fast laws, or less", "none",
        not_given, of_force("table", "all", "rms") / least_of_laws("all", "rms"), "1",
        ours_if({below(0.1)}), "ratio of the roots of mean squares of forces", curves},
       {"the table is nearer to direct solutions than CONTACT on 11 x 11 elements", "none",
        not_given, of_all("table", "contact", "rms") / of_all("contact", "contact", "rms"), "1",
        ours_if({below(0.5)}),
        "ratio of the roots of mean squares, of the component where each is largest", curves},
       {"without spin the laws of Vermeulen and Johnson and of Polach are right to some percent",
        "none", not_given,
        std::fmax(of_force("vermeulen_johnson", "without_spin", "rms"),
                  of_force("polach", "without_spin", "rms")),
        "1", ours_if({below(0.04)}), "root of the mean square of the worse force", over_ratios},
       {"with spin they are off by a tenth", "none", not_given,
        std::fmin(of_force("vermeulen_johnson", "with_spin", "rms"),
                  of_force("polach", "with_spin", "rms")),
        "1", ours_if({above(0.08)}),
        "root of the mean square of the worse force, of the better law", over_ratios},
       {"FASTSIM is off by a tenth of full sliding in one of a hundred motions", "none", not_given,
        of_force("fastsim_three", "all", "99"), "1", ours_if({above(0.08)}),
        "error of 99 % of the motions, three flexibilities", curves},
       {"three flexibilities are better than one", "none", not_given,
        of_force("fastsim_three", "all", "rms") / of_force("fastsim_one", "all", "rms"), "1",
        ours_if({below(1)}), "ratio of the roots of mean squares of the worse force", curves},
       {"direct solutions on some fifty cells are better than any fast law", "none", not_given,
        of_force(few, "all", "rms") / least_of_laws("all", "rms"), "1", ours_if({below(0.5)}),
        "ratio of the roots of mean squares of forces", curves},
       {"direct solutions on a hundred cells are better than CONTACT on 11 x 11 elements", "none",
        not_given, of_all(more, "contact", "rms") / of_all("contact", "contact", "rms"), "1",
        ours_if({below(0.5)}),
        "ratio of the roots of mean squares, of the component where each is largest", curves},
       {"USETAB's layout adds errors of a percent, ten times those of the table", "none", not_given,
        of_all("usetab", "circle", "rms") / of_all("table", "circle", "rms"), "1",
        ours_if({above(5)}), "ratio of the roots of mean squares on a circle", curves}});
}

}  // namespace

CreepTablesParameters read_creep_tables(Scene& scene) {
  using P = CreepTablesParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::groups, "random.shapes", "random a/b, one in each of so many parts of 0.1 ... 10",
        range(1, 100)},
       {&P::states, "random.states", "random motions at each", range(1, 1000)},
       {&P::every, "contact.every", "of CONTACT's 23 magnitudes of the creepage, one of so many",
        range(1, 22)},
       {&P::cells, "reference.cells",
        "rows, and elements of each, of a circle: references are means of these and one more",
        range(4, 39)},
       {&P::fine_cells, "reference.fine_cells",
        "the same, by which errors of references are measured", range(5, 39),
        "above reference.cells"},
       {&P::fine_groups, "reference.fine_shapes", "a/b in the middle that are solved on these",
        range(1, 1000), "at most random.shapes"},
       {&P::fine_states, "reference.fine_states", "random motions at each", range(1, 1000)},
       {&P::direct, "direct.cells", "cells of a circle, of direct solutions on few", range(4, 20),
        two_or_more_rising},
       {&P::fastsim_cells, "fastsim.cells", "rows of FASTSIM, and elements of each", range(4, 200)},
       {&P::usetab_cells, "usetab.cells", "cells at the nodes of USETAB's layout, and one more",
        range(4, 39)}});
  P p = keys.read({});
  scene.demand("reference.fine_cells", static_cast<double>(p.fine_cells), p.fine_cells > p.cells);
  scene.demand("reference.fine_shapes", static_cast<double>(p.fine_groups),
               p.fine_groups <= p.groups);
  return p;
}

std::vector<Table> creep_tables(const CreepTablesParameters& p, const Progress& progress) {
  const SolvedStates solved = solve_states(p, progress);
  const Methods methods = compared_methods(p, solved.states);
  progress(steps_of_states(p) + 1, steps_of_states(p) + 1);
  const ReferenceErrors reference(p, solved);
  const Table errors = errors_table(solved.states, methods);
  return {states_table(solved.states, methods),
          reference.table,
          errors,
          ratios_table(solved.states, methods),
          distribution_table(solved.states, methods),
          times_table(solved.states, methods),
          claims_of(p, errors, reference)};
}

}  // namespace microslip::experiments
