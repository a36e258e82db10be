// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/ellipse_wiggles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "contact_ellipse.hpp"
#include "contact_transients.hpp"
#include "ellipse_wiggles_runs.hpp"
#include "ellipse_wiggles_tables.hpp"
#include "microslip/experiments/claims.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::VectorXd;
using namespace ellipse_wiggles_study;

namespace {

Rolling under(const char* name, const EllipseWigglesParameters& p) {
  Rolling found{name, true, {}, 0};
  if (std::string(name) == "creepage") found.load[0].value = p.creepage;
  if (std::string(name) == "force") {
    found.load[0] = {true, -contact_force * contact_rectangles(1).bound.total()};
  }
  if (std::string(name) == "spin") {
    found.after_shift = false;
    found.load[2].value = p.spin;
    found.component = 1;
  }
  return found;
}

/// Waves, deviation and peak of a row in adhesion, beside the reference.
struct LineErrors {
  double wave = 0, deviation = 0, peak = 0;

  LineErrors(const VectorXd& line, const RolledCircle& reference) {
    const VectorXd d = line - reference.line;
    double sum = 0, count = 0, highest = 0, exact = 0;
    for (Index i = 0; i < d.size(); ++i) {
      const auto sticks = [&](Index at) {
        return at >= 0 && at < d.size() && reference.sticks[static_cast<std::size_t>(at)];
      };
      if (!sticks(i)) continue;
      sum += std::abs(d[i]);
      count += 1;
      highest = std::max(highest, std::abs(line[i]));
      exact = std::max(exact, std::abs(reference.line[i]));
      if (!sticks(i - 1) || !sticks(i + 1)) continue;
      wave = std::max(wave, std::abs(d[i - 1] - 2 * d[i] + d[i + 1]) / 4);
    }
    deviation = sum / count;
    peak = highest / exact;
  }
};

/// Distance after which the peak of the shift has left the contact  [half-widths]
constexpr double peak_has_left = 2;

/// Roots of mean squares over steps, over the mean creepage.
struct Noise {
  double sum = 0, waves = 0, errors = 0, count = 0;

  void include(double creepage, double wave, double error) {
    sum += creepage;
    waves += wave * wave;
    errors += error * error;
    count += 1;
  }
  double noise() const { return std::sqrt(waves * count) / sum; }
  double error() const { return std::sqrt(errors * count) / sum; }
};

class Runs {
 public:
  Runs(const EllipseWigglesParameters& p, Tables& tables, const std::function<void()>& advance)
      : p_(p), tables_(tables), advance_(advance) {}

  void run(const Rolling& rolling, const std::vector<double>& step_ratios) {
    const SteadyPatch fine = joined_circle(p_.reference_rows, p_.reference_elements);
    const Course reference =
        rolled(PatchRolling(fine), fine, rolling,
               2 * p_.reference_step_ratio / static_cast<double>(p_.reference_elements),
               p_.distances, p_.elements);
    advance_();
    show("reference", p_.reference_step_ratio, rolling, reference, reference);
    for (std::size_t k = 0; k < p_.distances.size(); ++k) {
      add("reference", p_.reference_step_ratio, k, rolling, reference, reference);
    }
    const auto compare = [&](const char* scheme, const auto& roll) {
      std::vector<Course> courses;
      for (const double c : step_ratios) {
        courses.push_back(roll(2 * c / static_cast<double>(p_.elements)));
        show(scheme, c, rolling, courses.back(), reference);
        advance_();
      }
      for (std::size_t k = 0; k < p_.distances.size(); ++k) {
        for (std::size_t j = 0; j < courses.size(); ++j) {
          add(scheme, step_ratios[j], k, rolling, courses[j], reference);
        }
      }
      add_dependence(scheme, rolling, courses);
      return courses;
    };
    const SteadyPatch joined = joined_circle(p_.rows, p_.elements);
    compare("remembered", [&](double step) {
      return rolled(PatchRolling(joined), joined, rolling, step, p_.distances, p_.elements);
    });
    const auto by_rectangles = [&](double step, double relaxation) {
      StandardPatch rectangles = contact_rectangles(p_.elements);
      rectangles.relaxation = relaxation;
      return rolled(RectangleRolling(rectangles), rolling, step, p_.distances);
    };
    const std::vector<Course> direct =
        compare("direct", [&](double step) { return by_rectangles(step, 0); });
    compare("relaxed", [&](double step) {
      return by_rectangles(step, std::max(1.0, step * static_cast<double>(p_.elements) / 2));
    });
    if (rolling.load[0].by_resultant) add_contact(rolling, step_ratios, direct, reference);
  }

  /// The largest difference of a traction of the standard scheme from CONTACT's, over mu p0.
  double from_contact() const { return from_contact_; }

 private:
  static bool is(const Rolling& rolling, const char* name) {
    return rolling.name == std::string(name);
  }

  /// Of one distance.
  void add(const char* scheme, double c, std::size_t k, const Rolling& rolling,
           const Course& course, const Course& reference) {
    const RolledCircle &found = course.at[k], &exact = reference.at[k];
    const LineErrors line(found.line, exact);
    const Eigen::Vector3d error = (found.resultants - exact.resultants).cwiseAbs();
    tables_.wiggles.add({rolling.name, scheme, c, p_.distances[k], line.wave, line.deviation,
                         line.peak, found.resultants[rolling.component], error.head<2>().maxCoeff(),
                         error[2], found.motion[0]});
  }

  void add_contact(const Rolling& rolling, const std::vector<double>& step_ratios,
                   const std::vector<Course>& direct, const Course& reference) {
    const auto last = std::ranges::find(p_.distances, contact_distances.back());
    if (p_.elements != static_cast<Index>(ContactTransient{}.traction.size()) ||
        last == p_.distances.end())
      return;
    const auto k = static_cast<std::size_t>(last - p_.distances.begin());
    for (const ContactTransient& of : contact_transients()) {
      const VectorXd traction =
          Eigen::Map<const VectorXd>(of.traction.data(), static_cast<Index>(of.traction.size())) /
          contact_rectangles(1).bound.peak();
      const LineErrors line(traction, reference.at[k]);
      for (std::size_t j = 0; j < step_ratios.size(); ++j) {
        if (step_ratios[j] != of.step_ratio) continue;
        const double difference = (direct[j].at[k].line - traction).cwiseAbs().maxCoeff();
        from_contact_ = std::fmax(from_contact_, difference);
      }
      tables_.wiggles.add({rolling.name, "contact", of.step_ratio, *last, line.wave, line.deviation,
                           line.peak, -contact_force, 0.0, 0.0, of.creepage.back()});
    }
  }

  void add_dependence(const char* scheme, const Rolling& rolling,
                      const std::vector<Course>& courses) {
    for (std::size_t k = 0; k < p_.distances.size(); ++k) {
      const RolledCircle& least = courses.back().at[k];
      double force = 0, mean = 0, largest = 0;
      for (const Course& course : courses) {
        const RolledCircle& other = course.at[k];
        const VectorXd difference = (other.tractions - least.tractions).rowwise().norm();
        force = std::max(force, (other.resultants - least.resultants).cwiseAbs().maxCoeff());
        mean =
            std::max(mean, difference.norm() / std::sqrt(static_cast<double>(difference.size())));
        largest = std::max(largest, difference.maxCoeff());
      }
      tables_.dependence.add({rolling.name, scheme, p_.distances[k], force, mean, largest});
    }
  }

  /// What figures show.
  void show(const char* scheme, double c, const Rolling& rolling, const Course& course,
            const Course& reference) {
    if (is(rolling, "creepage")) {
      const auto shown = std::ranges::find(p_.distances, p_.shown) - p_.distances.begin();
      const VectorXd x = stations(p_.elements);
      const double y = 1 / static_cast<double>(p_.elements);
      for (Index i = 0; i < x.size(); ++i) {
        const double traction = -course.at[static_cast<std::size_t>(shown)].line[i];
        tables_.tractions.add(
            {scheme, c, x[i], traction, std::sqrt(std::max(0.0, 1 - x[i] * x[i] - y * y))});
      }
    }
    if (!rolling.load[0].by_resultant) return;
    Noise whole, settled;
    for (std::size_t s = 0; s < course.steps.size(); ++s) {
      const Step& step = course.steps[s];
      tables_.creepages.add({scheme, c, step.middle, step.motion[0]});
      if (step.middle < 0.5 || s + 1 == course.steps.size()) continue;
      const double wave =
          (course.steps[s - 1].motion[0] - 2 * step.motion[0] + course.steps[s + 1].motion[0]) / 4;
      const double error = step.motion[0] - creepage_at(reference, step.middle);
      whole.include(step.motion[0], wave, error);
      if (step.middle >= peak_has_left) settled.include(step.motion[0], wave, error);
    }
    if (std::string(scheme) == "reference") return;
    tables_.noise.add({scheme, c, whole.noise(), settled.noise(), whole.error()});
  }

  /// Linear between the middles of steps.
  static double creepage_at(const Course& course, double q) {
    const auto after = std::ranges::lower_bound(course.steps, q, {}, &Step::middle);
    if (after == course.steps.begin()) return after->motion[0];
    const Step& before = *(after - 1);
    if (after == course.steps.end()) return before.motion[0];
    const double part = (q - before.middle) / (after->middle - before.middle);
    return before.motion[0] + part * (after->motion[0] - before.motion[0]);
  }

  const EllipseWigglesParameters& p_;
  Tables& tables_;
  const std::function<void()>& advance_;
  double from_contact_ = not_given;
};

void add_map(Tables& tables, const EllipseWigglesParameters& p) {
  const SteadyPatch circle = joined_circle(p.map_rows, p.elements);
  PatchRolling cells(circle);
  const VectorXd x = cells.x(), y = cells.y();
  const Course course = rolled(std::move(cells), circle, under("spin", p),
                               2 / static_cast<double>(p.elements), p.map_distances, p.elements);
  for (const RolledCircle& at : course.at) {
    for (Index i = 0; i < x.size(); ++i) {
      const double half_length = std::sqrt(1 - y[i] * y[i]);
      const double bound = std::sqrt(half_length * half_length - x[i] * x[i]);
      const double theta = std::acos(x[i] / half_length), psi = std::asin(y[i]);
      const double half_cell = std::numbers::pi / 2 / static_cast<double>(p.elements);
      const double half_row = std::numbers::pi / 2 / static_cast<double>(p.map_rows);
      tables.map.add({at.distance, x[i], y[i], half_length * std::cos(theta + half_cell),
                      half_length * std::cos(theta - half_cell), std::sin(psi - half_row),
                      std::sin(psi + half_row), at.tractions(i, 0), at.tractions(i, 1),
                      at.tractions.row(i).norm() / bound,
                      at.slips[static_cast<std::size_t>(i)] ? 1.0 : 0.0});
    }
  }
}

}  // namespace

EllipseWigglesParameters read_ellipse_wiggles(Scene& scene) {
  using P = EllipseWigglesParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::elements, "grid.elements", "of a diameter in the standard scheme, and cells of a row",
        range(8, 40)},
       {&P::rows, "grid.rows", "joined rows; the standard scheme has as many as elements",
        range(4, 40)},
       {&P::step_ratios, "step.ratios", "c = dq/dx, after a shift by 0.6 of full sliding",
        range(0.01, 2), falling},
       {&P::force_step_ratios, "step.force_step_ratios", "c under a held force after the shift",
        range(0.01, 2), falling},
       {&P::spin_step_ratios, "step.spin_step_ratios", "c under spin from rest", range(0.01, 2),
        falling},
       {&P::creepage, "rolling.creepage", "after the shift", range(0.01, 0.5)},
       {&P::spin, "rolling.spin", "1/mm", "from rest", range(0.01, 1)},
       {&P::distances, "rolling.distances", "q/a of results", range(0.05, 20), rising},
       {&P::shown, "rolling.shown", "q/a of the tractions in figures", range(0.05, 20),
        "one of rolling.distances"},
       {&P::reference_rows, "reference.rows", "M of the reference", range(4, 40)},
       {&P::reference_elements, "reference.elements", "N of the reference", range(8, 60)},
       {&P::reference_step_ratio, "reference.step_ratio", "c of the reference", range(0.05, 1)},
       {&P::map_rows, "map.rows", "M of the map; its rows have grid.elements cells", range(4, 40)},
       {&P::map_distances, "map.distances", "q/a of the map, under spin", range(0.05, 20),
        rising}});
  const P p = keys.read({});
  scene.demand("rolling.shown", p.shown,
               std::ranges::find(p.distances, p.shown) != p.distances.end());
  return p;
}

std::vector<Table> ellipse_wiggles(const EllipseWigglesParameters& p, const Progress& progress) {
  const std::size_t steps =
      4 + 3 * (p.step_ratios.size() + p.force_step_ratios.size() + p.spin_step_ratios.size());
  std::size_t done = 0;
  const std::function<void()> advance = [&] { progress(++done, steps); };
  Tables tables;
  Runs runs(p, tables, advance);
  runs.run(under("creepage", p), p.step_ratios);
  runs.run(under("force", p), p.force_step_ratios);
  runs.run(under("spin", p), p.spin_step_ratios);
  add_map(tables, p);
  advance();
  return {tables.wiggles,
          tables.dependence,
          tables.tractions,
          tables.creepages,
          tables.noise,
          tables.map,
          claims_of(p, tables, runs.from_contact())};
}

}  // namespace microslip::experiments
