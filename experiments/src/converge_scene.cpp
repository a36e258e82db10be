// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/converge_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>

#include "campaign.hpp"
#include "converge_advice.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/cost.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/interpolation.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// The part of a solution that errors are measured of.
struct Outcome {
  VectorXd distance;  ///< at the start and after each step; steady rolling has one, 0  [mm]
  /// The force; if the force is prescribed, the creepage, and in transients the creep so far.
  VectorXd answer;
  VectorXd x;
  VectorXd traction;        ///< at the end  [N/mm^2]
  double lost = 0;          ///< dissipated energy  [N/mm or N]
  double longest_step = 0;  ///< time of the longest step except for the first  [s]

  /// Counts the steps of a transient; steady rolling counts as one step.
  double steps() const { return std::max(1.0, static_cast<double>(distance.size() - 1)); }
};

Outcome outcome_of(const SteadyProblem& problem) {
  const SteadySolution solution = solve_steady(problem);
  if (!solution.fallback.empty()) throw std::invalid_argument(solution.fallback);
  require_evidence(solution.evidence, solution.condition, solution.iterations, problem.accepted);
  const bool under_force = Prescribed(problem.load).by_force;
  return {.distance = VectorXd::Zero(1),
          .answer = VectorXd::Constant(1, under_force ? solution.creepage : solution.force),
          .x = solution.x,
          .traction = solution.traction,
          .lost = solution.dissipation};
}

Outcome outcome_of(const TransientScene& scene) {
  TransientRolling rolling(scene.problem, scene.start, scene.loads.contact_at(0));
  Outcome outcome;
  for (const ShiftLoad& load : scene.shifts) outcome.lost += rolling.shift(load).dissipation;
  const bool under_force = Prescribed(scene.loads.at(0)).by_force;
  std::vector<double> distance{rolling.state().distance};
  std::vector<double> answer{under_force ? 0 : rolling.state().force};
  WorstOfSteps worst;
  using Clock = std::chrono::steady_clock;
  Clock::time_point before = Clock::now();
  rolling.roll_to(scene.distance, scene.step_lengths(), scene.loads, [&](const TransientState& s) {
    const Clock::time_point now = Clock::now();
    const double took = std::chrono::duration<double>(now - before).count();
    if (distance.size() > 1) outcome.longest_step = std::max(outcome.longest_step, took);
    const double length = s.distance - distance.back();
    answer.push_back(under_force ? answer.back() + length * s.creepage : s.force);
    distance.push_back(s.distance);
    outcome.lost += s.dissipation * length;
    worst.include(s);
    before = Clock::now();
  });
  constexpr double no_condition = 1;
  require_evidence(worst.evidence, no_condition, worst.iterations, scene.problem.accepted);
  outcome.distance = VectorXd::Map(distance.data(), static_cast<Index>(distance.size()));
  outcome.answer = VectorXd::Map(answer.data(), outcome.distance.size());
  outcome.x = rolling.x();
  outcome.traction = rolling.traction_at_nodes();
  return outcome;
}

[[noreturn]] void reject_cylinder() {
  reject("problem", "cylinder", "steady or transient, which have a load");
}

Outcome outcome_of(const SteadyTarget&) { throw std::logic_error("converge: a target error"); }
Outcome outcome_of(const CylinderScene&) { reject_cylinder(); }
Outcome outcome_of(const SteadyPatch&) { throw std::logic_error("converge: an ellipse"); }
Outcome outcome_of(const PatchTransient&) { throw std::logic_error("converge: an ellipse"); }

/// Relative errors.
struct Errors {
  double answer, traction, energy;
};

Errors errors_of(const Outcome& outcome, const Outcome& exact) {
  const VectorXd answer = interpolated(exact.distance, exact.answer, outcome.distance);
  const VectorXd traction = interpolated(exact.x, exact.traction, outcome.x);
  return {
      (outcome.answer - answer).lpNorm<Eigen::Infinity>() / exact.answer.lpNorm<Eigen::Infinity>(),
      (outcome.traction - traction).lpNorm<1>() / traction.lpNorm<1>(),
      std::abs(outcome.lost / exact.lost - 1)};
}

/// A scheme, with the settings of a scene that choose it.
struct Contestant {
  std::string name;
  std::vector<std::string> settings;
  bool by_elements = true;
};

std::vector<Contestant> contestants_for(bool steady) {
  std::vector<Contestant> all;
  if (!steady) {
    for (const std::string_view name : advection_names()) {
      all.push_back({std::string(name), {fmt::format("step.scheme={}", name)}});
    }
    return all;
  }
  for (const SteadyEntry& entry : steady_schemes()) {
    const std::string name(entry.name);
    Contestant contestant{name, {"method=collocation", "leading_edge=" + name}, entry.by_elements};
    if (name == "chebyshev") contestant.settings = {"method=chebyshev"};
    if (!entry.basis.empty()) contestant.settings.push_back(fmt::format("basis={}", entry.basis));
    all.push_back(contestant);
  }
  return all;
}

Model model_of(const ConvergeScene& converge, const Contestant& contestant, Index elements) {
  Scene scene = converge.scene;
  scene.set(fmt::format("grid.elements={}", elements));
  for (const std::string& setting : contestant.settings) scene.set(setting);
  return read_model(scene);
}

Outcome solved(const Model& model) {
  return std::visit([](const auto& read) { return outcome_of(read); }, model);
}

struct Reference {
  Outcome outcome;
  std::string name;
  Index elements;
  double error;  ///< of the answer, estimate
};

/// Solves steady rolling by inversion to ten digits, if the inversion can solve the problem.
std::optional<Reference> inverted(const ConvergeScene& converge, Index elements) {
  constexpr double of_inversion = 1e-10;
  try {
    const Contestant inversion = contestants_for(true).front();
    return Reference{solved(model_of(converge, inversion, elements)), inversion.name, elements,
                     of_inversion};
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Returns the default one of the schemes by elements.
Contestant second_order(bool steady) {
  const std::vector<Contestant> all = contestants_for(steady);
  return *std::ranges::find_if(all, &Contestant::by_elements);
}

Index reference_elements(const ConvergeScene& converge) { return 4 * converge.elements.back() + 3; }

/// Solves by the scheme chebyshev, sampled at as many nodes as given.
Reference by_chebyshev(const ConvergeScene& converge, Index nodes) {
  constexpr double of_chebyshev = 1e-10;
  const std::vector<Contestant> all = contestants_for(true);
  const Contestant& scheme = *std::ranges::find(all, "chebyshev", &Contestant::name);
  return {solved(model_of(converge, scheme, nodes)), scheme.name, nodes, of_chebyshev};
}

Reference reference_of(const ConvergeScene& converge) {
  const Index fine = reference_elements(converge), half = fine / 2;
  if (converge.reference == "chebyshev") return by_chebyshev(converge, fine);
  if (converge.steady && converge.reference == "best") {
    if (auto reference = inverted(converge, fine)) return *reference;
  }
  const Contestant scheme = second_order(converge.steady);
  Outcome outcome = solved(model_of(converge, scheme, fine));
  const Outcome coarse = solved(model_of(converge, scheme, half));
  return {outcome, scheme.name, fine, errors_of(coarse, outcome).answer};
}

Model reference_model(const ConvergeScene& converge) {
  return model_of(converge, second_order(converge.steady), reference_elements(converge));
}

/// Leaves out the largest of the default numbers where the reference would take minutes.
void limit_elements(ConvergeScene& converge, Scene& scene) {
  constexpr double most_operations = 5e11;  // half a minute
  constexpr std::size_t least_count = 3;
  const Index most = converge.elements.back();
  const double work = work_needed(reference_model(converge));
  while (converge.elements.size() > least_count &&
         work_needed(reference_model(converge)) > most_operations) {
    converge.elements.pop_back();
  }
  if (converge.elements.back() == most) return;
  scene.warn("converge.elements", static_cast<double>(converge.elements.back()),
             fmt::format("the largest N unless more are given: the reference for {} takes {} "
                         "operations, {} times as many",
                         most, format_roughly(work),
                         format_roughly(work / work_needed(reference_model(converge)))));
}

void require_reference(ConvergeScene& converge) {
  constexpr double most_operations = 1e13;
  const Model model = reference_model(converge);
  converge.memory = memory_needed(model);
  const double work = work_needed(model);
  require(work <= most_operations, "converge.elements",
          static_cast<double>(converge.elements.back()), [&] {
            return fmt::format(
                "fewer: the reference with {} takes {} operations, and at most {} "
                "are accepted",
                reference_elements(converge), format_roughly(work),
                format_roughly(most_operations));
          });
}

Table converge_table(bool under_force) {
  return {
      "converge",
      "errors and counted work of every scheme against the number of elements",
      {{"scheme", "1", "leading_edge or method of steady rolling, step.scheme of a transient"},
       {"elements", "1", "N; nodes shown of inversion and chebyshev"},
       {"answer_error", "1",
        under_force ? "creepage; in a transient the creep after each step, the largest error; "
                      "over the largest that is exact"
                    : "force; in a transient after each step, the largest error; over the "
                      "largest that is exact",
        1e-9},
       {"order", "1", "of answer_error, from the row before"},
       {"traction_error", "1",
        "sum of |p - exact| at the nodes over the sum of |exact|; in a transient at the end", 1e-9},
       {"energy_error", "1", "energy lost by slip, relative", 1e-9},
       {"steps", "1", "steps of a transient"},
       {"work", "1", "counted floating-point operations"},
       {"status", "1", "ok, or why there is no result"}}};
}

Table timing_table() {
  return {"converge_timing",
          "measured time of every run that succeeded",
          {{"scheme", "1", "as in converge"},
           {"elements", "1", "N"},
           {"answer_error", "1", "as in converge"},
           {"time", "s", "of the processor, for all of it, least of the repeats"},
           {"step_time", "s", "the same over the number of steps"},
           {"longest_step", "s", "the longest step but the first, least of the repeats"}}};
}

}  // namespace

ConvergeScene read_converge(Scene& scene) {
  if (scene.has("target_error")) {
    throw BadParameter("target_error",
                       "target_error: expected a scene without it, as all N are tried");
  }
  require_line_contact(scene);
  const Model model = read_model(scene);
  if (std::holds_alternative<CylinderScene>(model)) reject_cylinder();
  const auto* transient = std::get_if<TransientScene>(&model);
  if (transient != nullptr && transient->from > 0) {
    reject("start.type", "state", "another start: a state belongs to one scheme and N");
  }
  const auto* steady = std::get_if<SteadyProblem>(&model);
  const Load load = steady != nullptr ? steady->load : transient->loads.at(0);
  ConvergeScene read{.scene = scene,
                     .elements = {15, 31, 63, 127, 255},
                     .error = 0,
                     .step_time = std::nullopt,
                     .steady = steady != nullptr,
                     .under_force = Prescribed(load).by_force,
                     .memory = 0,
                     .reference = scene.word("converge.reference")};
  if (read.reference == "chebyshev" && !read.steady) {
    reject("converge.reference", read.reference, "best or fine in a transient");
  }
  constexpr const char* elements = "converge.elements";
  if (scene.has(elements)) {
    read.elements = scene.wholes(elements);
    for (const Index n : read.elements) scene.demand_in_range(elements, static_cast<double>(n));
    demand(scene, elements, rising, {read.elements.begin(), read.elements.end()});
  } else {
    limit_elements(read, scene);
  }
  read.error = scene.number("converge.error");
  scene.demand_in_range("converge.error", read.error);
  if (scene.has("converge.step_time")) {
    read.step_time = scene.positive("converge.step_time");
    if (read.steady) reject("problem", "steady", "transient with converge.step_time");
  }
  require_reference(read);
  return read;
}

namespace {

/// Tells the progress in percent of the expected operations, also within a run.
class ExpectedWork {
 public:
  /// \param runs  for each number of elements
  ExpectedWork(const ConvergeScene& converge, std::size_t runs, const Progress& progress)
      : reference_(work_needed(reference_model(converge))), progress_(progress) {
    const Contestant scheme = second_order(converge.steady);
    for (const Index n : converge.elements) {
      of_run_[n] = work_needed(model_of(converge, scheme, n));
      total_ += static_cast<double>(runs) * of_run_[n];
    }
    total_ += reference_;
  }

  template <class Action>
  auto reference(Action action) {
    return part(reference_, action);
  }

  template <class Action>
  auto run(Index elements, Action action) {
    return part(of_run_.at(elements), action);
  }

  void end() const { progress_(percent, percent); }

 private:
  static constexpr std::size_t percent = 100;

  template <class Action>
  auto part(double expected, Action action) {
    const double before = done_;
    done_ += expected;
    const WorkWatch watch([=, this](double operations) {
      const double part = (before + std::min(operations, expected)) / total_;
      progress_(std::min(percent - 1, static_cast<std::size_t>(percent * part)), percent);
    });
    return action();
  }

  double reference_;
  const Progress& progress_;
  std::map<Index, double> of_run_;
  double total_ = 0;
  double done_ = 0;
};

}  // namespace

std::vector<Table> converge_tables(const ConvergeScene& converge, const Progress& progress) {
  const std::vector<Contestant> all = contestants_for(converge.steady);
  ExpectedWork expected(converge, all.size(), progress);

  const Reference reference = expected.reference([&] { return reference_of(converge); });
  if (reference.outcome.answer.isZero(0)) {
    throw std::invalid_argument("converge: expected a load that is not zero");
  }
  Table table = converge_table(converge.under_force), timing = timing_table();
  std::vector<Candidate> candidates;
  for (const Contestant& contestant : all) {
    constexpr double most_operations = 1e11, repeats = 0.05;
    Runs runs({.operations = most_operations, .repeats = repeats});
    double last_error = not_given, last_size = not_given;
    for (const Index n : converge.elements) {
      if (!contestant.by_elements && n != converge.elements.back()) continue;
      const auto size = static_cast<double>(n);
      Outcome outcome;
      double longest = not_given;
      std::optional<Model> read;
      const Attempt attempt = expected.run(n, [&] {
        return runs.run(size, [&] {
          if (!read) read = model_of(converge, contestant, n);
          outcome = solved(*read);
          longest = std::fmin(longest, outcome.longest_step);
        });
      });
      if (attempt.status != Status::ok) {
        const std::string why = attempt.message.empty() ? "" : ": " + attempt.message;
        table.add({contestant.name, size, not_given, not_given, not_given, not_given, not_given,
                   not_given, name_of(attempt.status) + why});
        continue;
      }
      const double steps = outcome.steps();
      const Errors errors = errors_of(outcome, reference.outcome);
      const double order = std::log(last_error / errors.answer) / std::log(size / last_size);
      table.add({contestant.name, size, errors.answer, order, errors.traction, errors.energy, steps,
                 attempt.work, "ok"});
      timing.add(
          {contestant.name, size, errors.answer, attempt.time, attempt.time / steps, longest});
      candidates.push_back({contestant.name, n, errors.answer, attempt.time, steps, longest});
      last_error = errors.answer;
      last_size = size;
    }
  }
  expected.end();
  Table summary = empty_summary("the reference that errors are measured against");
  summary.add({"reference", reference.name, "1"});
  summary.add({"reference_elements", reference.elements, "1"});
  summary.add({"reference_error", reference.error, "1"}, Rounding{"value", 1e-9});
  return {table, timing, summary,
          advice(candidates, {.error = converge.error,
                              .step_time = converge.step_time,
                              .quantity = converge.under_force ? "creepage" : "force",
                              .steady = converge.steady,
                              .reference_error = reference.error})};
}

}  // namespace microslip::experiments
