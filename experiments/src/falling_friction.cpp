// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/falling_friction.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "falling_friction_ellipse.hpp"
#include "falling_friction_limits.hpp"
#include "falling_friction_tables.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;
using falling_friction_study::Tables;

namespace {

using Parameters = FallingFrictionParameters;

/// CONTACT's example veldep_fric: dx, and the force over that of full sliding at rest, as printed,
/// in steady rolling and after a step of 0.1 mm, from bodies that stick and from bodies that slide.
constexpr double contact_spacing = 0.1, contact_steady = 0.5941, contact_least = 0.5977,
                 contact_most = 0.5702;

class Study {
 public:
  Study(const Parameters& parameters, const Progress& progress)
      : p_(parameters),
        progress_(progress),
        material_{p_.shear_modulus, p_.poisson_ratio},
        kernel_(PlaneKernel(material_, p_.length)),
        bound_(p_.half_width, p_.peak_traction),
        total_(p_.elements.size() * p_.steady_memories.size() + p_.curve_speeds.size() +
               p_.step_lengths.size() +
               (p_.memories.size() + 1 + p_.ellipse_memories.size()) * p_.step_ratios.size() + 1) {}

  std::vector<Table> tables() {
    add_steady();
    add_curves();
    add_steps();
    add_runs();
    add_contact();
    falling_friction_study::add_ellipse(
        p_, [&](double memory) { return friction(memory); }, [&] { count(); }, tables_.ellipse);
    return {tables_.steady,  tables_.curve,   tables_.steps,
            tables_.runs,    tables_.limits,  tables_.tractions,
            tables_.contact, tables_.ellipse, claims_of(p_, tables_)};
  }

 private:
  SlipFriction friction(double memory, SlipBranch branch = SlipBranch::least) const {
    return {.law = FrictionLaw(FrictionLaw::Form::exponential, p_.kinetic_ratio, p_.half_speed),
            .speed = p_.speed,
            .memory_length = memory,
            .branch = branch};
  }

  double ratio(double force) const { return force / bound_.total(); }

  SteadyProblem steady(Index elements, double creepage, const SlipFriction& friction) const {
    SteadyProblem problem{.contact = {kernel_, bound_},
                          .grid = Grid({.half_width = p_.half_width, .elements = elements}),
                          .method = Calibrated{},
                          .load = PrescribedCreepage{creepage}};
    problem.friction = friction;
    return problem;
  }

  void count() { progress_(++done_, total_); }

  void add_steady() {
    for (const double memory : p_.steady_memories) {
      std::vector<double> forces;
      std::vector<std::vector<Cell>> rows;
      for (const Index n : p_.elements) {
        const auto least = solve_steady(steady(n, p_.creepage, friction(memory)));
        const auto most = solve_steady(steady(n, p_.creepage, friction(memory, SlipBranch::most)));
        forces.push_back(ratio(least.force));
        rows.push_back({memory, static_cast<double>(n), forces.back(),
                        static_cast<double>(least.adhesion_elements()) / static_cast<double>(n),
                        least.has_second ? 1.0 : 0.0, std::abs(ratio(most.force) - forces.back())});
        count();
      }
      for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].emplace_back(std::abs(forces[i] - forces.back()));
        tables_.steady.add(rows[i]);
      }
    }
  }

  void add_curves() {
    for (const double speed : p_.curve_speeds) {
      for (Index i = 0; i < p_.curve_points; ++i) {
        const double creepage =
            p_.largest_creepage * static_cast<double>(i) / static_cast<double>(p_.curve_points - 1);
        SlipFriction of_speed = friction(0);
        of_speed.speed = speed;
        const auto found = solve_steady(steady(p_.run_elements, -creepage, of_speed));
        tables_.curve.add({speed, creepage, ratio(found.force), found.has_second ? 1.0 : 0.0});
      }
      count();
    }
  }

  /// Steps of the standard scheme, which does not divide them.
  void add_steps() {
    SteadyProblem before = steady(p_.step_elements, p_.creepage * (1 - p_.change), friction(0));
    before.method = Differences{};
    const SteadySolution from = solve_steady(before);
    tables_.limits.add({0.0, limit_of_unique_steps(before, from), not_given});
    for (const double length : p_.step_lengths) {
      for (const auto branch : {SlipBranch::least, SlipBranch::most}) {
        TransientRolling rolling =
            rolling_from(before, Direct{}, friction(0, branch), from.traction);
        rolling.step(length, PrescribedCreepage{p_.creepage});
        const TransientState& state = rolling.state();
        tables_.steps.add({length, name_of(branch), ratio(state.force),
                           state.slip.cwiseAbs().maxCoeff() * p_.speed,
                           state.has_second ? 1.0 : 0.0});
      }
      count();
    }
  }

  static TransientRolling rolling_from(const SteadyProblem& steady, const AdvectionScheme& scheme,
                                       const SlipFriction& friction, const VectorXd& traction) {
    TransientProblem problem{.contact = steady.contact,
                             .grid = steady.grid,
                             .basis = constant_basis(),
                             .scheme = scheme};
    problem.friction = friction;
    return TransientRolling(problem, Start{traction});
  }

  static std::string name_of(SlipBranch branch) {
    return branch == SlipBranch::least ? "least" : "most";
  }

  void add_runs() {
    for (const double memory : p_.memories) {
      if (memory > 0) add_limit(memory);
      for (const double c : p_.step_ratios) add_run(memory, SlipBranch::least, c);
    }
    for (const double c : p_.step_ratios) add_run(0, SlipBranch::most, c);
  }

  void add_limit(double memory) {
    const SteadyProblem problem = steady(p_.run_elements, p_.creepage, friction(memory));
    const double limit = limit_of_unique_steps(whole_contact(problem), solve_steady(problem));
    tables_.limits.add({memory, limit, limit / memory});
  }

  /// Rolls from steady tractions, with friction at rest at first.
  void add_run(double memory, SlipBranch branch, double step_ratio) {
    const SteadyProblem of_steady = steady(p_.run_elements, p_.creepage, friction(memory));
    const SteadySolution from = solve_steady(of_steady);  // by elements over the whole contact
    TransientRolling rolling =
        rolling_from(of_steady, Remembered{}, friction(memory, branch),
                     interpolated(from.x, from.traction, of_steady.grid.nodes()));
    const double step = step_ratio * of_steady.grid.spacing();
    const auto steps = static_cast<int>(std::lround(p_.run_distance / step));
    const auto shown = static_cast<int>(std::lround(p_.shown / step));
    double least = 2, most = 0, sum = 0;
    int doubled = 0, settled = 0, counted = 0;
    try {
      for (; settled < steps; ++settled) {
        rolling.step(step, PrescribedCreepage{p_.creepage});
        const double now = ratio(rolling.state().force);
        doubled += rolling.state().has_second ? 1 : 0;
        if (settled + 1 == shown) add_tractions(memory, branch, step_ratio, rolling);
        if (2 * settled < steps) continue;
        least = std::min(least, now);
        most = std::max(most, now);
        sum += now;
        ++counted;
      }
    } catch (const NotConverged&) {  // a row tells it
    }
    const bool all = settled == steps;
    tables_.runs.add({memory, name_of(branch), step_ratio, all ? 1.0 : 0.0,
                      all ? ratio(rolling.state().force) : not_given,
                      all ? sum / counted : not_given, all ? most - least : not_given,
                      static_cast<double>(doubled) / std::max(settled, 1)});
    count();
  }

  void add_tractions(double memory, SlipBranch branch, double step_ratio,
                     const TransientRolling& rolling) {
    const VectorXd traction = rolling.traction_at_nodes(), bound = rolling.bound_at_nodes();
    for (Index i = 0; i < traction.size(); ++i) {
      tables_.tractions.add({memory, name_of(branch), step_ratio, rolling.x()[i] / p_.half_width,
                             bound[i] / bound_.peak(), traction[i] / bound_.peak()});
    }
  }

  void add_contact() {
    const TabulatedBound pressed = bound_by_elements(material_, kernel_, bound_, contact_spacing);
    const double edge = half_width_of(pressed);
    const Grid grid({.half_width = edge, .elements = pressed.x().size() - 2});
    const auto values = [&](SteadyProblem problem, double creepage) {
      problem.contact = {kernel_, pressed};
      problem.grid = grid;
      problem.method = Differences{};
      problem.load = PrescribedCreepage{creepage};
      return problem;
    };
    const SteadyProblem any = steady(1, p_.creepage, friction(0));
    const SteadySolution from = solve_steady(values(any, p_.creepage * (1 - p_.change)));
    const auto add = [&](const char* state, double force, double printed, Index adhesion) {
      tables_.contact.add({state, ratio(force), printed, static_cast<double>(adhesion)});
    };
    add("steady", from.force, contact_steady, from.adhesion_elements());
    for (const auto branch : {SlipBranch::least, SlipBranch::most}) {
      TransientRolling rolling =
          rolling_from(values(any, 0), Direct{}, friction(0, branch), from.traction);
      rolling.step(contact_spacing, PrescribedCreepage{p_.creepage});
      const bool sticks = branch == SlipBranch::least;
      add(sticks ? "step from sticking" : "step from sliding", rolling.state().force,
          sticks ? contact_least : contact_most, rolling.state().adhesion_elements);
    }
    count();
  }

  const Parameters& p_;
  const Progress& progress_;
  Material material_;
  Kernel kernel_;
  HertzBound bound_;
  Tables tables_;
  std::size_t done_ = 0, total_;
};

}  // namespace

FallingFrictionParameters read_falling_friction(Scene& scene) {
  using P = FallingFrictionParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::shear_modulus, "material.shear_modulus"},
       {&P::poisson_ratio, "material.poisson_ratio"},
       {&P::half_width, "contact.half_width"},
       {&P::peak_traction, "contact.peak_traction"},
       {&P::kinetic_ratio, "contact.kinetic_ratio"},
       {&P::half_speed, "contact.half_speed"},
       {&P::length, "kernel.length"},
       {&P::creepage, "load.creepage"},
       {&P::speed, "load.speed"},
       {&P::change, "load.change", "1", "of the creepage before a single step, relative",
        range(1e-8, 0.1)},
       {&P::elements, "steady.elements", "1", "N of steady rolling", range(11, Grid::max_elements),
        rising},
       {&P::steady_memories, "steady.memories", "mm", "lengths of the memory of friction",
        range(0, 1), rising},
       {&P::curve_speeds, "curve.speeds", "mm/s", "of rolling, of curves", above_zero, rising},
       {&P::curve_points, "curve.points", "1", "of a curve", range(2, 1000)},
       {&P::largest_creepage, "curve.largest", "1", "creepage of curves", range_above(0, 0.2)},
       {&P::step_elements, "steps.elements", "1", "N of single steps", range(11, 2000)},
       {&P::step_lengths, "steps.lengths", "mm", "dq of single steps", above_zero, falling},
       {&P::run_elements, "run.elements", "1", "N of runs and curves", range(11, 2000)},
       {&P::run_distance, "run.distance", "mm", "distance of runs", above_zero},
       {&P::step_ratios, "run.step_ratios", "1", "c = dq/dx of runs", range(0.01, 4), falling},
       {&P::memories, "run.memories", "mm", "lengths of the memory of friction; 0: none",
        range(0, 1), rising},
       {&P::shown, "run.shown", "mm", "distance of the tractions in figures", above_zero,
        "at most run.distance"},
       {&P::lateral_half_width, "ellipse.lateral_half_width", "mm",
        "of the ellipse, across the rolling", above_zero},
       {&P::ellipse_rows, "ellipse.rows", "1", "rows of the ellipse", range(1, 40)},
       {&P::ellipse_elements, "ellipse.elements", "1", "elements of each row", range(2, 40)},
       {&P::ellipse_distance, "ellipse.distance", "mm", "distance of the runs of the ellipse",
        above_zero},
       {&P::ellipse_memories, "ellipse.memories", "mm",
        "lengths of the memory of friction of the ellipse; 0: none", range(0, 1), rising}});
  const P p = keys.read({});
  require(p.creepage < 0, "load.creepage", p.creepage, "a number < 0");
  scene.demand("run.shown", p.shown, p.shown <= p.run_distance);
  return p;
}

std::vector<Table> falling_friction(const FallingFrictionParameters& parameters,
                                    const Progress& progress) {
  return Study(parameters, progress).tables();
}

}  // namespace microslip::experiments
