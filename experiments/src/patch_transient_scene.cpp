// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "microslip/experiments/contact_tables.hpp"
#include "microslip/experiments/scene_tables.hpp"
#include "microslip/patch/joined_rows.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/standard_patch.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "microslip/support/not_converged.hpp"
#include "patch_tables.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Values of a patch that do not change as it rolls, at the elements.
struct PatchElements {
  VectorXd area;    ///< [mm^2]
  VectorXd bound;   ///< [N/mm^2]
  VectorXd weight;  ///< the force in an element over the traction at its centre  [mm^2]
};

PatchElements elements_of(const SteadyPatch& patch, const PatchRolling&) {
  const double c = patch.bound.size();
  const JoinedRows rows(patch.bound.shape().scaled(1 / c), patch.rows, patch.elements);
  PatchElements found{.area = c * c * rows.areas(),
                      .bound = VectorXd(rows.cells()),
                      .weight = c * c * rows.moments().row(0)};
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const Index cell = rows.cell(i, k);
      found.bound[cell] = patch.bound(rows.lobe(k), rows.psi(k), rows.theta(i));
      found.weight[cell] /= std::tan(rows.theta(i) / 2);
    }
  }
  return found;
}

PatchElements elements_of(const SteadyPatch&, const RectangleRolling& rolling) {
  const VectorXd area = VectorXd::Constant(rolling.size(), rolling.area());
  return {.area = area, .bound = rolling.bound(), .weight = area};
}

using AnyRolling = std::variant<PatchRolling, RectangleRolling>;

AnyRolling rolling_of(const SteadyPatch& patch, const AdvectionScheme& scheme) {
  if (std::holds_alternative<Remembered>(scheme)) return PatchRolling(patch);
  const PatchBound& bound = patch.bound;
  return RectangleRolling({.material = patch.material,
                           .bound = {bound.half_width(), bound.lateral_half_width(), bound.peak()},
                           .elements = patch.elements,
                           .rows = patch.rows});
}

/// The end of a step or a shift.
struct PatchStepEnd {
  Vector3d resultants, motion;
  double slip_share;  ///< [1]
  int iterations;
  Evidence evidence;
};

/// A patch that rolls or is shifted, with evidence for each step.
class RolledPatch {
 public:
  RolledPatch(const SteadyPatch& patch, const AdvectionScheme& scheme)
      : patch_(patch),
        rolling_(rolling_of(patch, scheme)),
        elements_(std::visit([&](const auto& of) { return elements_of(patch, of); }, rolling_)) {}

  PatchStepEnd shift(const PatchLoad& load) {
    std::visit([&](auto& of) { of.shift(load); }, rolling_);
    return end(load);
  }

  PatchStepEnd roll(double dq, const PatchLoad& load) {
    std::visit([&](auto& of) { of.roll(dq, load); }, rolling_);
    return end(load);
  }

  Table tractions() const {
    return std::visit(
        [&](const auto& of) {
          return patch_traction_table(
              "transient rolling", {of.x(), of.y(), elements_.area, elements_.bound, of.tractions(),
                                    of.slip(), of.slips()});
        },
        rolling_);
  }

  Table edges() const {
    const auto* rectangles = std::get_if<RectangleRolling>(&rolling_);
    if (rectangles == nullptr) return patch_edges_table(patch_);
    return rectangles_edges_table(rectangles->x(), rectangles->y(), rectangles->element(),
                                  rectangles->area() / rectangles->element());
  }

 private:
  PatchStepEnd end(const PatchLoad& load) const {
    return std::visit([&](const auto& of) { return end_of(of, load); }, rolling_);
  }

  template <class Rolling>
  PatchStepEnd end_of(const Rolling& rolling, const PatchLoad& load) const {
    PatchStepEnd found{.resultants = rolling.resultants(),
                       .motion = rolling.motion(),
                       .slip_share = 0,
                       .iterations = rolling.iterations(),
                       .evidence = {}};
    for (std::size_t j = 0; j < load.size(); ++j) {  // without rounding
      (load[j].by_resultant ? found.resultants : found.motion)[static_cast<Index>(j)] =
          load[j].value;
    }
    Evidence& evidence = found.evidence;
    evidence.residual = rolling.residual();
    evidence.load = found.resultants.head<2>().norm();
    evidence.full_sliding = patch_.bound.total();
    const MatrixX2d tractions = rolling.tractions(), slip = rolling.slip();
    double slipping = 0;
    for (Index i = 0; i < elements_.area.size(); ++i) {
      if (!rolling.slips()[static_cast<std::size_t>(i)]) continue;
      slipping += elements_.area[i];
      const double weight = elements_.weight[i], power = weight * tractions.row(i).dot(slip.row(i));
      evidence.excess += weight * std::max(0.0, tractions.row(i).norm() - elements_.bound[i]);
      evidence.backward += std::max(0.0, power);
      evidence.dissipated -= power;
    }
    found.slip_share = slipping / elements_.area.sum();
    evidence.power = std::max(std::abs(found.motion.dot(found.resultants)), evidence.dissipated);
    evidence.unresolved =
        found.slip_share * std::abs(elements_.weight.dot(elements_.bound) - evidence.full_sliding);
    return found;
  }

  SteadyPatch patch_;
  AnyRolling rolling_;
  PatchElements elements_;
};

/// The patch with rows and elements that are a third fewer; none if there are no fewer.
std::optional<SteadyPatch> with_fewer_elements(SteadyPatch patch) {
  const auto lobes = static_cast<Index>(patch.bound.shape().lobes().size());
  if (patch.rows == lobes || patch.elements == least_elements) return std::nullopt;
  patch.rows = std::max(lobes, (2 * patch.rows + 1) / 3);
  patch.elements = std::max(least_elements, (2 * patch.elements + 1) / 3);
  return patch;
}

/// The largest change of a motion, by its kind, over the largest motion of that kind.
struct MotionChange {
  double size;  ///< of the patch  [mm]
  Vector3d changes = Vector3d::Zero(), largest = Vector3d::Zero();

  void include(const Vector3d& from, const Vector3d& to) {
    const Vector3d units(1, 1, size);
    changes = changes.cwiseMax((to - from).cwiseProduct(units).cwiseAbs());
    largest = largest.cwiseMax(to.cwiseProduct(units).cwiseAbs());
  }

  double relative() const {
    const double creep = largest.head<2>().maxCoeff(), spin = largest[2];
    return std::max(creep > 0 ? changes.head<2>().maxCoeff() / creep : 0,
                    spin > 0 ? changes[2] / spin : 0);
  }
};

/// The same contact on rows and elements that are a third fewer, as long as it is solved there. The
/// change is the largest one of resultants after each step, over the largest resultants; of the
/// shifts, and of the way that is crept, over the largest; and of motions in the last step.
class CoarsePatch {
 public:
  CoarsePatch(const SteadyPatch& patch, const AdvectionScheme& scheme) : bound_(patch.bound) {
    if (const auto fewer = with_fewer_elements(patch)) rolled_.emplace(*fewer, scheme);
  }

  /// \param length  of the step; 1 for a shift  [mm]
  /// \param step    of RolledPatch
  template <class Step>
  void follow(const PatchStepEnd& fine, double length, const Step& step) {
    if (!rolled_) return;
    try {
      const PatchStepEnd coarse = step(*rolled_);
      const double full = bound_.total(), turning = bound_.turning_moment();
      const Vector3d of_resultants =
          (coarse.resultants - fine.resultants).cwiseQuotient(Vector3d(full, full, turning));
      of_resultants_ = std::max(of_resultants_, of_resultants.lpNorm<Eigen::Infinity>());
      path_ += length * fine.motion;
      coarse_path_ += length * coarse.motion;
      of_path_.include(coarse_path_, path_);
      of_last_ = {bound_.size()};
      of_last_.include(coarse.motion, fine.motion);
    } catch (const NotConverged&) {
      rolled_.reset();
    }
  }

  double change() const {
    if (!rolled_) return 1;
    return std::max({of_resultants_, of_path_.relative(), of_last_.relative()});
  }

 private:
  PatchBound bound_;
  std::optional<RolledPatch> rolled_;
  double of_resultants_ = 0;
  Vector3d path_ = Vector3d::Zero(), coarse_path_ = Vector3d::Zero();
  MotionChange of_path_{bound_.size()}, of_last_{bound_.size()};
};

/// Ends of steps, or of shifts, as rows of a table. Where a component is 0 by symmetry, the steps of
/// Newton's method leave up to 4e-7 of the largest one.
class PatchRecord {
 public:
  /// \param size  of the patch  [mm]
  explicit PatchRecord(double size) : size_(size) {}

  /// \param before, behind  cells of columns before and behind those of the record
  void add(const PatchStepEnd& end, std::vector<Cell> before = {},
           const std::vector<Cell>& behind = {}) {
    std::vector<Cell>& row = before;
    row.insert(row.end(), end.resultants.begin(), end.resultants.end());
    row.insert(row.end(), end.motion.begin(), end.motion.end());
    row.insert(row.end(), {end.slip_share, end.iterations});
    row.insert(row.end(), behind.begin(), behind.end());
    rows_.push_back(row);
    const Vector3d arms(1, 1, 1 / size_);
    force_ = std::max(force_, end.resultants.cwiseProduct(arms).lpNorm<Eigen::Infinity>());
    motion_ = std::max(motion_, end.motion.cwiseQuotient(arms).lpNorm<Eigen::Infinity>());
  }

  /// \param motions  names, units and meanings of the three columns of motions
  Table table(const std::string& name, const std::string& description,
              const std::vector<Column>& before, std::vector<Column> motions,
              const std::vector<Column>& behind) const {
    constexpr double rounding = 1e-6;
    std::vector<Column> columns = before;
    columns.push_back({"force", "N", "Fx, force along the rolling", rounding * force_});
    columns.push_back({"lateral_force", "N", "Fy, force across the rolling", rounding * force_});
    columns.push_back(
        {"spin_moment", "N mm", "Mz, moment about x = y = 0", rounding * force_ * size_});
    for (std::size_t j = 0; j < motions.size(); ++j) {
      motions[j].rounding = rounding * motion_ / (j < 2 ? 1 : size_);
      columns.push_back(motions[j]);
    }
    columns.push_back({"slip_share", "1", "part of the area that slips"});
    columns.push_back({"iterations", "1", "systems that were solved"});
    columns.insert(columns.end(), behind.begin(), behind.end());
    Table made(name, description, columns);
    for (const std::vector<Cell>& row : rows_) made.add(row);
    return made;
  }

 private:
  double size_;
  double force_ = 0, motion_ = 0;  ///< largest ones; of moments over the size, of spin times it
  std::vector<std::vector<Cell>> rows_;
};

Table history_of(const PatchRecord& record, bool has_times) {
  return record.table(
      "history",
      "transient rolling of a patch, a row a step; the first is the start, where nothing moves",
      {{"q", "mm", "distance rolled"}},
      {{"creepage", "1", "xi, as a mean over the step"},
       {"lateral_creepage", "1", "eta, as a mean over the step"},
       {"spin", "1/mm", "phi, as a mean over the step"}},
      has_times ? std::vector<Column>{{"t", "s", "time"}} : std::vector<Column>{});
}

Table shifts_of(const PatchRecord& record) {
  return record.table(
      "shifts",
      "shifts without rolling before the bodies roll, a row a shift; the first is the start", {},
      {{"shift", "mm", "rigid shift along the rolling"},
       {"lateral_shift", "mm", "rigid shift across the rolling"},
       {"rotation", "rad", "rigid rotation about x = y = 0"}},
      {});
}

/// The worst evidence of all steps.
struct WorstOfPatch {
  Evidence evidence;
  int iterations = 0;

  void include(const PatchStepEnd& end) {
    evidence = worst_of(evidence, end.evidence);
    iterations = std::max(iterations, end.iterations);
  }
};

}  // namespace

std::vector<Table> scene_tables(const PatchTransient& scene, const Progress& progress) {
  const std::vector<double> lengths = scene.step_lengths();
  const std::size_t steps = number_of_steps(scene.distance, lengths);
  std::size_t done = 0;
  progress(done, scene.shifts.size() + steps);
  RolledPatch rolled(scene.patch, scene.scheme);
  CoarsePatch coarse(scene.patch, scene.scheme);
  WorstOfPatch worst;
  const auto take = [&](double length, const auto& step) {
    const PatchStepEnd end = step(rolled);
    coarse.follow(end, length, step);
    worst.include(end);
    progress(++done, scene.shifts.size() + steps);
    return end;
  };

  PatchStepEnd end{Vector3d::Zero(), Vector3d::Zero(), 0, 0, {}};
  PatchRecord shifts(scene.patch.bound.size()), history = shifts;
  shifts.add(end);
  for (const PatchLoad& load : scene.shifts) {
    end = take(1, [&](RolledPatch& patch) { return patch.shift(load); });
    shifts.add(end);
  }

  const auto record = [&](double q) {
    const auto time = scene.loads.time_at(q);
    history.add(end, {q}, time ? std::vector<Cell>{*time} : std::vector<Cell>{});
  };
  end.motion.setZero();
  end.iterations = 0;  // the start is no step
  record(0);
  Vector3d path = Vector3d::Zero();
  for_steps(scene.distance, lengths, 0, [&](double from, double to, double length) {
    const PatchLoad load = scene.loads.between(from, to);
    end = take(length, [&](RolledPatch& patch) { return patch.roll(length, load); });
    record(to);
    path += length * end.motion;
  });
  worst.evidence.change = coarse.change();

  Table summary = empty_summary("transient rolling of a patch, the whole contact at the end");
  summary.add({"distance", scene.distance, "mm"});
  summary.add({"steps", steps, "1"});
  add_patch_load(summary, end.resultants, end.motion);
  summary.add({"cumulative_creep", path[0], "mm"});
  summary.add({"cumulative_lateral_creep", path[1], "mm"});
  summary.add({"cumulative_spin", path[2], "rad"});
  add_patch_shares(summary, scene.patch, end.evidence.load, end.slip_share);
  add_patch_sizes(summary, scene.patch);
  if (!scene.shifts.empty()) summary.add({"shifts", scene.shifts.size(), "1"});
  summary.add({"method", name_of(scene.scheme), "1"});
  summary.add({"iterations", worst.iterations, "1"});
  add_evidence(summary, worst.evidence,
               {.condition = std::nullopt,
                .iterations = worst.iterations,
                .accepted = scene.patch.accepted,
                .doubt = doubt_of_patch(worst.evidence)});
  std::vector<Table> tables{rolled.tractions(), rolled.edges(),
                            history_of(history, scene.loads.time_at(0).has_value()), summary};
  if (!scene.shifts.empty()) tables.push_back(shifts_of(shifts));
  return tables;
}

}  // namespace microslip::experiments
