// SPDX-License-Identifier: GPL-3.0-or-later
#include "doubts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "microslip/rolling/large_creepage.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/units.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "run_file.hpp"

namespace microslip {

void warn_outside(Scene& scene, const SafeRange& safe, const std::string& key, double value,
                  const std::string& instead) {
  if (safe.holds(value)) return;
  const std::string least = format_short(safe.least);
  const std::string range = safe.least == safe.most ? "at " + least
                            : std::isfinite(safe.most)
                                ? fmt::format("from {} to {}", least, format_short(safe.most))
                                : fmt::format("from {} on", least);
  scene.warn(key, value, fmt::format("this scheme is safe {}; {} is safe for any", range, instead));
}

void warn_near_full_sliding(Scene& scene, const Load& load, const TractionBound& bound,
                            Eigen::Index elements, const std::string& instead) {
  constexpr double safe_zone = 6;  // elements in the stick zone
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr) return;
  const double ratio = std::abs(force->value) / full_sliding_force(bound);
  const double zone = std::sqrt(std::max(0.0, 1 - ratio));  // by Carter, over the contact
  const auto count = static_cast<double>(elements);
  if (zone * count >= safe_zone) return;
  scene.warn("grid.elements", count,
             fmt::format("under a force of {:.6g} of full sliding the stick zone is some {} "
                         "elements long, and this scheme is safe with {}; {} is safe for any",
                         ratio, format_roughly(zone * count), safe_zone, instead));
}

void warn_of_short_end(Scene& scene, const TransientScene& read) {
  const AdvectionEntry& entry = entry_of(read.problem.scheme);
  if (!entry.safe_steps.holds(std::ranges::min(read.step_ratios))) return;
  const double step_ratio =
      last_step(read.distance, read.step_lengths(), read.from) / read.problem.grid.spacing();
  if (step_ratio >= (1 - 1e-9) * entry.safe_steps.least) return;
  scene.warn(
      "motion.distance", read.distance,
      fmt::format("cuts the last step to a step.ratio of {}, and the creepage of the summary "
                  "is its creepage; {} is safe from {} on, step.scheme remembered for any",
                  format_roughly(step_ratio), entry.name, format_short(entry.safe_steps.least)));
}

void warn_of_noise(Scene& scene, Eigen::Index elements, double step_ratio) {
  const double least = least_step_under_force(elements);
  if (step_ratio >= least) return;
  scene.warn("step.ratio", step_ratio,
             fmt::format("under a force, rounding is more than 1 % of the creepage below "
                         "step.ratio = {} with {} elements",
                         format_short(least), elements));
}

void warn_of_missed_rows(Scene& scene, const RunSteps& steps, const LoadHistory& rows,
                         const std::function<Eigen::Vector3d(double)>& resultants) {
  constexpr double doubtful = 0.05;
  if (!scene.has("step.ratio") || scene.has("step.tolerance")) return;
  using Values = Eigen::Vector<double, 5>;
  const auto at = [&](double distance) {
    constexpr double least = 0.02;  // below it, no part of a size or bound counts
    const ContactScale contact = rows.contact_at(distance);
    Values values;
    values << std::log(contact.half_width + least), std::log(contact.bound + least),
        resultants(distance);
    return values;
  };
  const std::vector<double> places = rows.row_distances();
  if (places.empty()) return;
  struct Missed {
    double bend = 0, from = 0, to = 0;
    std::size_t row = 0;
  } worst;
  std::size_t row = 0;
  for_steps(steps.distance, steps.lengths, steps.from, steps.ends,
            [&](double from, double to, double length) {
              const double rounding = 1e-9 * length;
              const auto is_within = [&] {
                return row < places.size() && places[row] < to - rounding;
              };
              while (row < places.size() && places[row] <= from + rounding) ++row;
              if (!is_within()) return;
              const Values first = at(from), last = at(to);
              for (; is_within(); ++row) {
                const double part = (places[row] - from) / length;
                const Values line = (1 - part) * first + part * last;
                const double bend = (at(places[row]) - line).cwiseAbs().maxCoeff();
                if (bend > worst.bend) worst = {bend, from, to, row};
              }
            });
  if (worst.bend <= doubtful) return;
  scene.warn(
      "step.ratio", scene.text("step.ratio"),
      fmt::format("row {} of load.file lies within a step, from {:.6g} to {:.6g} mm of the way, "
                  "and contact or forces bend there; a step takes them to be linear; without "
                  "step.ratio, steps end at the rows{}",
                  worst.row + 1, worst.from, worst.to,
                  scene.has_patch() ? ""
                                    : ", and step.tolerance makes them shorter where the "
                                      "load bends"));
}

void warn_of_other_radius(Scene& scene, double radius) {
  if (!scene.has("contact.normal_load")) return;
  for (const char* key : {"contact.radius_1", "contact.radius_2"}) {
    const auto given = scene.has(key) ? quantity(scene.text(key), "mm") : std::nullopt;
    if (given == radius) return;
  }
  scene.warn("cylinder.radius", radius, "differs from contact.radius_1 and contact.radius_2");
}

void warn_of_small_radius(Scene& scene, const std::string& key, double radius, double half_width) {
  constexpr double least = 10;  // half-widths
  if (radius >= least * half_width) return;
  scene.warn(key, radius,
             fmt::format("less than ten half-widths, {} mm: bodies are half-spaces next to the "
                         "contact; without a unit a radius is in mm",
                         format_roughly(least * half_width)));
}

void warn_of_large_creepage(Scene& scene, const std::string& key, double creepage,
                            const TractionBound& bound) {
  if (!is_large_creepage(creepage)) return;
  const double strain = bound_strain(bound, read_material_if_any(scene).shear_modulus);
  const std::string doubt = doubt_of_creepage(creepage, strain);
  if (!doubt.empty()) scene.warn(key, creepage, doubt);
}

void warn_of_large_creepages(Scene& scene, const LoadHistory& loads, const TractionBound& bound) {
  double largest = 0;
  for (const double distance : loads.distances()) {
    const Load load = loads.at(distance);
    const auto* creepage = std::get_if<PrescribedCreepage>(&load);
    if (creepage != nullptr && std::abs(creepage->value) > std::abs(largest)) {
      largest = creepage->value;
    }
  }
  warn_of_large_creepage(scene, "creepage of load.file", largest, bound);
}

void warn_of_other_load(Scene& scene, const std::optional<Eigen::VectorXd>& column) {
  constexpr double far = 100;
  if (!column) return;
  double least = std::numeric_limits<double>::infinity(), largest = 0;  // of rows with contact
  for (const double load : *column) {
    if (load > 0) least = std::min(least, load);
    largest = std::max(largest, load);
  }
  constexpr const char* key = "contact.normal_load";
  const double of_scene = scene.positive(key);
  const bool is_less = largest > 0 && largest <= of_scene / far;
  if (!is_less && (least < far * of_scene || largest == 0)) return;
  scene.warn("normal_load of load.file", is_less ? largest : least,
             fmt::format("the {} of all rows, beside {} {} of {}; a column without a unit in its "
                         "name is in {}",
                         is_less ? "largest" : "least", format_short(of_scene), scene.unit_of(key),
                         key, scene.unit_of(key)));
}

void warn_of_short_way(Scene& scene, const LoadHistory& loads,
                       const std::optional<Eigen::VectorXd>& velocity, double half_width) {
  if (!velocity || loads.distance() >= half_width) return;
  scene.warn("v of load.file", velocity->cwiseAbs().maxCoeff(),
             fmt::format("the bodies roll {} mm in all, and the half-width is {} mm; a column "
                         "without a unit in its name is in mm/s",
                         format_roughly(loads.distance()), format_roughly(half_width)));
}

void warn_of_short_turns(Scene& scene, const std::optional<Eigen::VectorXd>& place,
                         double half_width) {
  constexpr double least_part = 0.01;  // of the half-width
  if (!place) return;
  std::vector<double> ways;  // between turns, with the sign of their direction
  for (Eigen::Index i = 1; i < place->size(); ++i) {
    const double length = (*place)[i] - (*place)[i - 1];
    if (length == 0) continue;
    if (ways.empty() || length * ways.back() < 0) ways.push_back(0);
    ways.back() += length;
  }
  if (ways.size() < 2) return;
  const double shortest =
      std::abs(std::ranges::min(ways, {}, [](double way) { return std::abs(way); }));
  if (shortest >= least_part * half_width) return;
  const std::size_t turns = ways.size() - 1;
  scene.warn("q of load.file", shortest,
             fmt::format("the shortest way, in mm, before the bodies turn again or stop; they turn "
                         "{}, and places that were measured want smoothing",
                         turns == 1 ? "once" : fmt::format("{} times", turns)));
}

namespace {

/// The largest load of a run; a force is kept below full sliding, so that a steady state carries
/// it.
Load largest_load(const LoadHistory& loads, double full_sliding) {
  constexpr double most = 0.9999;
  Load largest = loads.at(0);
  const auto size = [](const Load& load) { return std::abs(Prescribed(load).value); };
  for (const double distance : loads.distances()) {
    const Load load = loads.at(distance);
    if (size(load) > size(largest)) largest = load;
  }
  if (auto* force = std::get_if<PrescribedForce>(&largest)) {
    force->value = std::clamp(force->value, -most * full_sliding, most * full_sliding);
  }
  return largest;
}

}  // namespace

void warn_of_unresolved_table(Scene& scene, const TransientProblem& problem,
                              const LoadHistory& loads) {
  constexpr double doubtful = 0.01;
  constexpr Eigen::Index most_rows = 400;
  const auto* table = std::get_if<TabulatedBound>(&problem.contact.bound);
  if (table == nullptr || table->x().size() > most_rows) return;
  SteadyProblem steady{.contact = {problem.contact.kernel, problem.contact.bound},
                       .grid = problem.grid,
                       .load = largest_load(loads, full_sliding_force(problem.contact.bound))};
  if (Prescribed(steady.load).value == 0) return;
  double change = 0;
  try {
    const std::optional<SteadySolution> exact = solve_by_inversion(steady);
    if (!exact) return;
    steady.method = Calibrated{};
    change = answer_of(steady.load, solve_steady(steady)) / answer_of(steady.load, *exact) - 1;
  } catch (const NotConverged&) {
    return;  // the run itself reports what it cannot solve
  }
  if (std::abs(change) <= doubtful) return;
  const bool by_force = Prescribed(steady.load).by_force;
  scene.warn("grid.elements", static_cast<double>(problem.grid.size()),
             fmt::format("they do not resolve the table of the bound: in steady rolling under the "
                         "largest load of the run their {} is off by {}; take more of them",
                         by_force ? "creepage" : "force", format_percent(change)));
}

void warn_of_sudden_force(Scene& scene, const LoadHistory& loads, double first_step) {
  if (scene.word("start.type") != "rest") return;
  const Load load = loads.at(0);
  const auto* force = std::get_if<PrescribedForce>(&load);
  if (force == nullptr || force->value == 0 || shifts_first(loads.stops())) return;
  const std::string key =
      scene.one_of({"load.force", "load.force_ratio", "load.stick_ratio", "load.file"});
  scene.warn(key == "load.force" ? key : "force of " + key, force->value,
             fmt::format("from a start at rest, it is reached over the first step, of {} mm; "
                         "start.type cattaneo starts under it",
                         format_roughly(first_step)));
}

}  // namespace microslip
