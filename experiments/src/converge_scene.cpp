// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/converge_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "campaign.hpp"
#include "converge_advice.hpp"
#include "converge_outcome.hpp"
#include "microslip/experiments/contact_tables.hpp"
#include "microslip/patch/patch_grid.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/cost.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

using Eigen::Index;

namespace {

/// A scheme, with the settings of a scene that choose it.
struct Contestant {
  std::string name;
  std::vector<std::string> settings;
  bool by_elements = true;
};

/// The schemes of line contacts.
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

std::vector<Contestant> contestants_for(const ConvergeScene& converge) {
  if (converge.shape && converge.steady) return {{.name = "rows", .settings = {}}};
  if (converge.shape) {
    return {{.name = "remembered", .settings = {"step.scheme=remembered"}},
            {.name = "direct", .settings = {"step.scheme=direct"}}};
  }
  return contestants_for(converge.steady);
}

/// The rows that fit a number of elements.
Index rows_for(const PatchShape& shape, Index elements) {
  constexpr double cells = 16;
  const PatchGrid fitting = fitting_grid(shape, cells);
  const double finer = static_cast<double>(elements) / static_cast<double>(fitting.elements);
  return std::max(static_cast<Index>(shape.lobes().size()),
                  fitting_grid(shape, cells * finer).rows);
}

Model model_of(const ConvergeScene& converge, const Contestant& contestant, Index elements) {
  Scene scene = converge.scene;
  if (converge.shape) scene.set(fmt::format("grid.rows={}", rows_for(*converge.shape, elements)));
  scene.set(fmt::format("grid.elements={}", elements));
  if (!converge.step_parts.empty()) {
    std::string ratios;
    for (const double part : converge.step_parts) {
      ratios +=
          fmt::format("{}{}", ratios.empty() ? "" : " ", static_cast<double>(elements) * part);
    }
    scene.set("step.ratio=" + ratios);
  }
  for (const std::string& setting : contestant.settings) scene.set(setting);
  return read_model(scene);
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
Contestant by_elements(const ConvergeScene& converge) {
  const std::vector<Contestant> all = contestants_for(converge);
  return *std::ranges::find_if(all, &Contestant::by_elements);
}

Index reference_elements(const ConvergeScene& converge) {
  const Index most = converge.elements.back();
  return converge.shape ? (3 * most + 1) / 2 : 4 * most + 3;
}

/// Solves by the scheme chebyshev, sampled at as many nodes as given.
Reference by_chebyshev(const ConvergeScene& converge, Index nodes) {
  constexpr double of_chebyshev = 1e-10;
  const std::vector<Contestant> all = contestants_for(true);
  const Contestant& scheme = *std::ranges::find(all, "chebyshev", &Contestant::name);
  return {solved(model_of(converge, scheme, nodes)), scheme.name, nodes, of_chebyshev};
}

/// Errors of a patch alternate with the number of elements: the change by one more tells the error.
Reference of_patch(const ConvergeScene& converge) {
  const Contestant rows = contestants_for(converge).front();
  const Index fine = reference_elements(converge);
  Outcome outcome = solved(model_of(converge, rows, fine));
  const Outcome other = solved(model_of(converge, rows, fine - 1));
  const double error = errors_of(other, outcome).answer;
  return {std::move(outcome), rows.name, fine, error};
}

Reference reference_of(const ConvergeScene& converge) {
  if (converge.shape) return of_patch(converge);
  const Index fine = reference_elements(converge), half = fine / 2;
  if (converge.reference == "chebyshev") return by_chebyshev(converge, fine);
  if (converge.steady && converge.reference == "best") {
    if (auto reference = inverted(converge, fine)) return *reference;
  }
  const Contestant scheme = by_elements(converge);
  Outcome outcome = solved(model_of(converge, scheme, fine));
  const Outcome coarse = solved(model_of(converge, scheme, half));
  return {outcome, scheme.name, fine, errors_of(coarse, outcome).answer};
}

Model reference_model(const ConvergeScene& converge) {
  return model_of(converge, by_elements(converge), reference_elements(converge));
}

/// Leaves out the largest of the default numbers where the reference would take minutes.
void limit_elements(ConvergeScene& converge, Scene& scene) {
  // Half a minute. An ellipse has two references, and twice as many grids of nearly their size.
  const double most_operations = converge.shape ? 1e11 : 5e11;
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

std::string quantity_of(const ConvergeScene& converge) {
  if (converge.shape && converge.steady) return "forces (over full sliding), moment and motions";
  if (converge.shape) return "forces (over full sliding), moment and ways crept";
  return converge.under_force ? "creepage" : "force";
}

std::string of_answer(const ConvergeScene& converge) {
  if (converge.shape && !converge.steady) {
    return "the largest one after any step of forces over full sliding, the moment over that of "
           "turning, and ways crept over the longest of their kind; steps have the same lengths "
           "with all N";
  }
  if (converge.shape) {
    return "the largest one of forces over full sliding, the moment over that of turning, and "
           "motions that follow over the largest of their kind";
  }
  return converge.under_force
             ? "creepage; in a transient the creep after each step, the largest error; over the "
               "largest that is exact"
             : "force; in a transient after each step, the largest error; over the largest that is "
               "exact";
}

Table converge_table(const ConvergeScene& converge) {
  return {
      "converge",
      "errors and counted work of every scheme against the number of elements",
      {{"scheme", "1",
        "leading_edge or method of steady rolling, step.scheme of a transient; rows of an ellipse"},
       {"elements", "1", "N; nodes shown of inversion and chebyshev"},
       {"answer_error", "1", of_answer(converge), 1e-9},
       {"order", "1", "of answer_error, from the row before"},
       {"traction_error", "1",
        "sum of |p - exact| at the nodes over the sum of |exact|; in a transient at the end; not "
        "given for an ellipse",
        1e-9},
       {"energy_error", "1", "energy lost by slip, relative", 1e-9},
       {"steps", "1", "steps of a transient"},
       {"work", "1", "counted floating-point operations; not given for an ellipse"},
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

/// The reference has half as many again, and at most 100.
constexpr Index most_elements_of_row = 2 * most_cells_of_side / 3;

/// Elements about those that fit a shape, in rising order.
std::vector<Index> elements_for(const PatchShape& shape) {
  const auto fitting = static_cast<double>(fitting_grid(shape).elements);
  std::vector<Index> all;
  for (const double part : {0.3, 0.4, 0.55, 0.75, 1.0, 1.4}) {
    const Index n = std::min(most_elements_of_row, static_cast<Index>(std::round(part * fitting)));
    if (n >= least_elements && (all.empty() || n > all.back())) all.push_back(n);
  }
  return all;
}

}  // namespace

ConvergeScene read_converge(Scene& scene) {
  if (scene.has("target_error")) {
    throw BadParameter("target_error",
                       "target_error: expected a scene without it, as all N are tried");
  }
  const Model model = read_model(scene);
  if (std::holds_alternative<CylinderScene>(model)) {
    reject("problem", "cylinder", "steady or transient, which have a load");
  }
  const auto* transient = std::get_if<TransientScene>(&model);
  const auto* rolling = std::get_if<PatchTransient>(&model);
  if ((transient != nullptr && transient->from > 0) ||
      (rolling != nullptr && rolling->state.has_value())) {
    reject("start.type", "state", "another start: a state belongs to one scheme and N");
  }
  const bool stops = (transient != nullptr && !transient->loads.stops().empty()) ||
                     (rolling != nullptr && !rolling->loads.stops().empty());
  if (stops) {
    reject("load.file", scene.text("load.file"), "rows that neither turn nor shift the bodies");
  }
  if (rolling != nullptr && !rolling->loads.ends_of_steps().empty()) {
    reject("load.file", scene.text("load.file"), "rows in which an ellipse keeps its contact");
  }
  const auto* patch = rolling != nullptr ? &rolling->patch : std::get_if<SteadyPatch>(&model);
  const auto* steady = std::get_if<SteadyProblem>(&model);
  ConvergeScene read{.scene = scene,
                     .elements = {15, 31, 63, 127, 255},
                     .error = 0,
                     .step_time = std::nullopt,
                     .steady = transient == nullptr && rolling == nullptr,
                     .shape = std::nullopt,
                     .under_force = false,
                     .memory = 0,
                     .reference = scene.word("converge.reference")};
  if (rolling != nullptr && (scene.has("step.ratio") || rolling->loads.distances().empty())) {
    for (const double ratio : rolling->step_ratios) {
      read.step_parts.push_back(ratio / static_cast<double>(rolling->patch.elements));
    }
  }
  if (patch != nullptr) {
    read.shape = patch->bound.shape();
    read.elements = elements_for(patch->bound.shape());
    if (read.reference == "chebyshev") {
      reject("converge.reference", read.reference, "best or fine for an ellipse");
    }
  } else {
    read.under_force =
        Prescribed(steady != nullptr ? steady->load : transient->loads.at(0)).by_force;
  }
  if (read.reference == "chebyshev" && !read.steady) {
    reject("converge.reference", read.reference, "best or fine in a transient");
  }
  constexpr const char* elements = "converge.elements";
  if (scene.has(elements)) {
    read.elements = scene.wholes(elements);
    for (const Index n : read.elements) {
      scene.demand_in_range(elements, static_cast<double>(n));
      if (patch == nullptr) continue;
      require(n <= most_elements_of_row, elements, static_cast<double>(n),
              [] { return fmt::format("at most {} in an ellipse", most_elements_of_row); });
    }
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
    const Contestant scheme = by_elements(converge);
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
  const std::vector<Contestant> all = contestants_for(converge);
  ExpectedWork expected(converge, all.size(), progress);

  const Reference reference = expected.reference([&] { return reference_of(converge); });
  if (!reference.outcome.has_answer()) {
    throw std::invalid_argument("converge: expected a load that is not zero");
  }
  Table table = converge_table(converge), timing = timing_table();
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
                 converge.shape ? not_given : attempt.work, "ok"});
      timing.add(
          {contestant.name, size, errors.answer, attempt.time, attempt.time / steps, longest});
      candidates.push_back({.scheme = contestant.name,
                            .elements = n,
                            .error = errors.answer,
                            .time = attempt.time,
                            .steps = steps,
                            .longest_step = longest,
                            .rows = converge.shape ? rows_for(*converge.shape, n) : 0});
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
                              .quantity = quantity_of(converge),
                              .steady = converge.steady,
                              .reference_error = reference.error})};
}

}  // namespace microslip::experiments
