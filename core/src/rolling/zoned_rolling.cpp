// SPDX-License-Identifier: GPL-3.0-or-later
#include "zoned_rolling.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "graded_elements.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/support/chebyshev_series.hpp"
#include "microslip/support/not_converged.hpp"
#include "stick_zones_search.hpp"
#include "zoned_field.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr std::size_t most_zoned_rows = 400;
constexpr std::size_t most_zones = 10;  // more take seconds, and are not always found

/// Elements over the contact to begin with, one number after the other until zones are found.
constexpr Index first_elements[] = {40, 57, 81};
constexpr Index most_graded_elements = 800;

/// Tables of more rows are tried once: each try takes tenths of a second, and others rarely help.
constexpr std::size_t many_rows = 150;

/// The stick zones that elements show, where the bound is above zero.
/// \param fewest  number of elements in a zone; shorter ones are joined with their neighbours
std::vector<ZoneEnds> zones_of(const GradedState& found, const BoundRows& rows,
                               std::size_t fewest) {
  const auto sticks = [&](std::size_t i) {
    const double middle = (found.ends[i] + found.ends[i + 1]) / 2;
    return found.state.zones[i] == Zone::adhesion && rows.bound(rows.place_of(middle)) > 0;
  };
  struct Run {
    bool sticks;
    std::size_t begin, end;
  };
  std::vector<Run> runs;
  const std::size_t n = found.state.zones.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (runs.empty() || runs.back().sticks != sticks(i)) runs.push_back({sticks(i), i, i});
    runs.back().end = i + 1;
  }
  std::vector<Run> kept;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Run run = runs[k];
    const bool inner = k > 0 && k + 1 < runs.size();
    if (inner && run.end - run.begin < fewest) run.sticks = !run.sticks;
    if (!kept.empty() && kept.back().sticks == run.sticks) {
      kept.back().end = run.end;
    } else {
      kept.push_back(run);
    }
  }
  std::vector<ZoneEnds> zones;
  for (const Run& run : kept) {
    if (run.sticks)
      zones.push_back({rows.place_of(found.ends[run.begin]), rows.place_of(found.ends[run.end])});
  }
  return zones;
}

/// Anderson's acceleration of a fixed point x = g(x).
class Anderson {
 public:
  VectorXd next(const VectorXd& x, const VectorXd& image) {
    constexpr std::size_t depth = 6;
    const VectorXd left = image - x;
    if (!images_.empty()) {
      image_changes_.push_back(image - images_.back());
      left_changes_.push_back(left - lefts_.back());
    }
    images_.push_back(image);
    lefts_.push_back(left);
    if (image_changes_.size() > depth) {
      image_changes_.erase(image_changes_.begin());
      left_changes_.erase(left_changes_.begin());
    }
    if (left_changes_.empty()) return image;
    const auto count = static_cast<Index>(left_changes_.size());
    MatrixXd changes(left.size(), count), moves(left.size(), count);
    for (Index k = 0; k < count; ++k) {
      changes.col(k) = left_changes_[static_cast<std::size_t>(k)];
      moves.col(k) = image_changes_[static_cast<std::size_t>(k)];
    }
    return image - moves * least_squares(changes, left);
  }

 private:
  std::vector<VectorXd> images_, lefts_, image_changes_, left_changes_;
};

ZonedField field_of(const StickZones& zones, const ZonesLoad& load) {
  return {zones, zones.size() == 0 ? *load.level : zones.level(0)};
}

std::optional<ZonedField> plane_field(const std::shared_ptr<const ZonedContact>& contact,
                                      const ZonesLoad& load, const std::vector<ZoneEnds>& guess) {
  const auto found = find_stick_zones(contact, load, guess);
  if (!found) return std::nullopt;
  return field_of(*found, load);
}

/// The smooth strain by the tractions of elements.
double strain_by_elements(const ZonedContact& contact, const GradedState& elements, double x) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < elements.ends.size(); ++i) {
    const double middle = (elements.ends[i] + elements.ends[i + 1]) / 2;
    sum += (elements.ends[i + 1] - elements.ends[i]) *
           std::abs(elements.state.traction[static_cast<Index>(i)]) *
           visit_half_space([&](const auto& k) { return k.regular_decay(x - middle); },
                            contact.kernel);
  }
  return sum / contact.log_factor;
}

/// Finds zones with the strain that follows from them.
std::optional<ZonedField> strip_field(const std::shared_ptr<const ZonedContact>& contact,
                                      const ZonesLoad& load, const GradedState& elements,
                                      std::vector<ZoneEnds> guess) {
  constexpr int most = 30;
  constexpr double enough = 1e-12, settled = 1e-10;
  const double a = contact->rows.half_width();
  const auto terms = static_cast<Index>(22 / std::asinh(contact->clear / a)) + 6;
  const VectorXd places = chebyshev_points(a, terms + 1);
  VectorXd values =
      places.unaryExpr([&](double x) { return strain_by_elements(*contact, elements, x); });
  Anderson anderson;
  double before = HUGE_VAL;
  for (int i = 0; i < most; ++i) {
    const AddedStrain strain{std::make_shared<ChebyshevSeries>(values, a), terms};
    if (!move_ends(contact, load, strain, guess)) return std::nullopt;
    const ZonedField field =
        field_of(zones_with(contact, guess, strain, StickZones::for_strain), load);
    const VectorXd image = places.unaryExpr([&](double x) { return field.regular_strain(x); });
    const double change = (image - values).lpNorm<Eigen::Infinity>();
    const double scale = std::max(image.lpNorm<Eigen::Infinity>(), field.level());
    if (change <= enough * scale || (change <= settled * scale && change > before / 2)) {
      const ZonedField found =
          field_of(zones_with(contact, guess, strain, StickZones::for_places), load);
      const auto repaired = found.repaired();
      if (!repaired) return found;
      guess = *repaired;
    }
    before = change;
    values = anderson.next(values, image);
  }
  return std::nullopt;
}

SteadySolution sampled(const SteadyProblem& problem, const ZonedField& field, double direction) {
  const VectorXd x = problem.grid.nodes();
  const ZonedField::Sums sums = field.sums();
  const auto [by_force, value] = Prescribed(problem.load);
  const double force = by_force ? value : -direction * field.zones().force();
  const double creepage = by_force ? direction * field.creepage() : value;
  SteadySolution found{
      .x = x,
      .bound = bound_at(problem.contact.bound, x),
      .traction = x.unaryExpr([&](double at) { return -direction * field.traction(at); }),
      .slip = x.unaryExpr([&](double at) { return direction * field.slip(at); }),
      .displacement = -direction * field.displacement(x),
      .zones = {},
      .force = force,
      .creepage = creepage,
      .dissipation = -creepage * force,
      .iterations = 0,
      .evidence = {.excess = sums.excess,
                   .backward = sums.backward,
                   .dissipated = sums.dissipated,
                   .load = std::abs(force),
                   .power = std::abs(creepage * force),
                   .full_sliding = full_sliding_force(problem.contact.bound)},
      .condition = 1,
      .scheme = SteadyScheme::inversion};
  const auto& zones = field.zones().zones();
  if (zones.size() == 1) found.stick_edge = field.zones().position({1, 0});
  if (zones.empty()) found.stick_edge = half_width_of(problem.contact.bound);
  const Zone slipping = direction < 0 ? Zone::slip_positive : Zone::slip_negative;
  for (const double at : x) {
    found.zones.push_back(field.zones().zone_of(at) ? Zone::adhesion : slipping);
  }
  return found;
}

}  // namespace

std::optional<SteadySolution> solve_by_zones(const SteadyProblem& problem) {
  const auto* table = std::get_if<TabulatedBound>(&problem.contact.bound);
  const Prescribed prescribed(problem.load);
  const auto [by_force, value] = prescribed;
  if (!problem.contact.kernel.is_half_space() || problem.contact.has_unlike_bodies() ||
      value == 0 || (table != nullptr && table->x().size() > static_cast<Index>(most_zoned_rows))) {
    return std::nullopt;
  }
  const auto contact =
      std::make_shared<ZonedContact>(problem.contact.kernel, problem.contact.bound);
  const double direction = prescribed.direction();
  ZonesLoad load;
  (by_force ? load.force : load.level) =
      by_force ? std::abs(value) : std::abs(value) / contact->log_factor;
  for (const Index elements : first_elements) {
    try {
      const GradedState graded = solve_graded(
          problem, graded_elements(problem.contact.bound, elements), most_graded_elements);
      std::size_t tried = 0;  // number of zones
      for (const std::size_t fewest : {std::size_t{1}, std::size_t{3}}) {
        const std::vector<ZoneEnds> guess = zones_of(graded, contact->rows, fewest);
        if (guess.size() > most_zones || (guess.empty() && by_force)) continue;
        if (fewest > 1 && guess.size() == tried) continue;
        tried = guess.size();
        const auto field = std::isfinite(contact->clear) ? strip_field(contact, load, graded, guess)
                                                         : plane_field(contact, load, guess);
        if (field) return sampled(problem, *field, direction);
      }
    } catch (const NotConverged&) {
      continue;  // other elements may find a partition
    }
    if (contact->rows.size() > many_rows) break;
  }
  return std::nullopt;
}

}  // namespace microslip
