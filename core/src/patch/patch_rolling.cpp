// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_rolling.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "material_records.hpp"
#include "microslip/support/require.hpp"
#include "patch_scale.hpp"
#include "slip_maps.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// Records of material that has entered are not closer than this part of the half-length of a row,
/// over the number of cells.
constexpr double spacing_of_records = 0.5;

/// Lengths of steps over the size of the patch. Records that are closer than the least one have no
/// digits of a slope between them.
constexpr double least_step = 1e-6, longest_step = 1e6;

/// Displacements are lost beside larger ones, in what the material remembers.
constexpr double largest_motion_of_step = 1e8;

/// The way of material in a step.
struct Way {
  double x;        ///< where it is at the end
  double length;   ///< that it rolled within the contact
  double entered;  ///< at this part of the step; 0 if before
};

/// Weights of the displacements at the leading edge now, before the step and a step earlier, for
/// that at the time between: a parabola, or a line without an earlier step.
struct EntryWeights {
  double now, before, earlier;

  /// \param entered  part of the step
  /// \param ratio    of the step before to this one; 0 without
  EntryWeights(double entered, double ratio) : now(entered), before(1 - entered), earlier(0) {
    if (ratio == 0) return;
    now = entered * (entered + ratio) / (1 + ratio);
    before = (1 - entered) * (entered + ratio) / ratio;
    earlier = -entered * (1 - entered) / (ratio * (1 + ratio));
  }
};

}  // namespace

/// All is in units by which the size of the patch, the bound's peak and the shear modulus are 1.
struct PatchRolling::Parts {
  /// The response in steps of one length, after steps of a ratio to it.
  struct StepResponse {
    double dq, ratio;
    PatchResponse of;
  };

  SteadyPatch problem;
  PatchUnits units;
  JoinedRows rows;
  MatrixXd displacement;  ///< by tractions, at points
  VectorXd limits;
  std::vector<MaterialRecords> memory;
  RigidPath path;
  double distance = 0;
  double step_before = 0;  ///< 0 if there was none, or a shift
  VectorXd u_before;
  VectorXd u;  ///< at points, along and across
  PatchState state;
  bool rolled = false;  ///< or shifted, in the last step
  std::optional<StepResponse> response;

  explicit Parts(const SteadyPatch& given)
      : problem(given),
        units(given.material, given.bound.peak(), given.bound.size()),
        rows(rows_of(given)),
        displacement(displacement_by_traction(rows, given.material.poisson_ratio)),
        limits(limits_of(rows, given.bound)),
        u_before(VectorXd::Zero(2 * rows.points())),
        u(u_before) {
    for (Index k = 0; k < rows.rows(); ++k) {
      memory.emplace_back(
          rows.x(2 * rows.elements(), k), rows.x(0, k),
          spacing_of_records * rows.half_length(k) / static_cast<double>(rows.elements()));
    }
    const Index n = rows.cells();
    state.unknowns = state.own_slip = state.centre_slip = VectorXd::Zero(2 * n);
    state.motion.setZero();
    state.slips.assign(static_cast<std::size_t>(n), false);
  }

  double leading(Index k) const { return rows.x(0, k); }
  double centre(Index i, Index k) const { return rows.x(2 * i + 1, k); }

  Vector2d at(const VectorXd& values, Index j, Index k) const {
    const Index point = rows.point(j, k);
    return {values[point], values[rows.points() + point]};
  }

  /// The step before over this one, or 0 where it is too long or too short to tell.
  double ratio_before(double dq) const {
    constexpr double most = 5;
    return step_before > dq * most || step_before * most < dq ? 0 : step_before / dq;
  }

  Way way_to(double x, Index k, double dq) const {
    const double way = leading(k) - x;
    return way >= dq ? Way{x, dq, 0} : Way{x, way, 1 - way / dq};
  }

  /// The way of the material that passes a centre in the middle of a step; or, in long steps, that
  /// is at the trailing side of the cell at the end.
  Way way_about_centre(Index i, Index k, double dq) const {
    const double x = centre(i, k), behind = rows.x(2 * i + 2, k);
    return way_to(std::max(x - dq / 2, behind), k, dq);
  }

  /// Calls f(i, k) for all cells.
  template <class F>
  void for_cells(const F& f) const {
    for (Index k = 0; k < rows.rows(); ++k) {
      for (Index i = 0; i < rows.elements(); ++i) f(i, k);
    }
  }

  const PatchResponse& response_of_step(double dq) {
    const double ratio = ratio_before(dq);
    if (response && response->dq == dq && response->ratio == ratio) return response->of;
    PatchSlipMap own = map_for(rows), at_centre = map_for(rows);
    for_cells([&](Index i, Index k) {
      const Index here = 2 * i + 1;
      if (dq == 0) {
        const PointSlip shifted{{here}, {1}, centre(i, k)};
        set_slip(own, rows, displacement, i, k, shifted);
        set_slip(at_centre, rows, displacement, i, k, shifted);
        return;
      }
      const Way way = way_to(centre(i, k), k, dq);
      const double entering = EntryWeights(way.entered, ratio).now;
      set_slip(own, rows, displacement, i, k,
               {{here, 0}, {1 / way.length, -entering / way.length}, way.x + way.length / 2});
      set_slip(at_centre, rows, displacement, i, k,
               slip_about(way_about_centre(i, k, dq), k, ratio));
    });
    response.emplace(StepResponse{dq, ratio, PatchResponse(rows, own, at_centre)});
    return response->of;
  }

  ImposedSlip imposed(double dq) const {
    const Index n = rows.cells();
    ImposedSlip found{VectorXd(2 * n), VectorXd(2 * n)};
    for_cells([&](Index i, Index k) {
      const Index cell = rows.cell(i, k);
      const auto put = [&](VectorXd& values, const Vector2d& value) {
        values[cell] = value[0];
        values[n + cell] = value[1];
      };
      if (dq == 0) {
        const Vector2d before = -remembered(centre(i, k), k, 0);
        put(found.own, before);
        put(found.centre, before);
        return;
      }
      put(found.own, imposed_slip(way_to(centre(i, k), k, dq), k, dq));
      put(found.centre, imposed_slip(way_about_centre(i, k, dq), k, dq));
    });
    return found;
  }

  /// The angle theta of a place within the edges of a row.
  double angle(double x, Index k) const {
    return std::acos(std::clamp(1 - (leading(k) - x) / rows.half_length(k), -1.0, 1.0));
  }

  /// Four points of a row around an angle, with the weights of the cubic in theta.
  PointSlip between(double theta) const {
    const double at = theta / pi * static_cast<double>(2 * rows.elements());
    const auto first = static_cast<Index>(std::floor(at)) - 1;
    PointSlip found{};
    for (Index j = 0; j < 4; ++j) {
      double weight = 1;
      for (Index l = 0; l < 4; ++l) {
        if (l != j) weight *= (at - static_cast<double>(first + l)) / static_cast<double>(j - l);
      }
      found.points[static_cast<std::size_t>(j)] = mirrored(rows, first + j);
      found.weights[static_cast<std::size_t>(j)] = weight;
    }
    return found;
  }

  PointSlip slip_about(const Way& way, Index k, double ratio) const {
    PointSlip slip = between(angle(way.x, k));
    for (double& weight : slip.weights) weight /= way.length;
    slip.points[4] = 0;
    slip.weights[4] = -EntryWeights(way.entered, ratio).now / way.length;
    slip.x = way.x + way.length / 2;
    return slip;
  }

  /// What material remembers of its displacement and of all rigid slip, without the latter.
  /// \param x  at the end of a step dq
  Vector2d remembered(double x, Index k, double dq) const {
    const double place = x + distance + dq;
    return memory[static_cast<std::size_t>(k)].at(place) - path.at(place, rows.y(k));
  }

  Vector2d imposed_slip(const Way& way, Index k, double dq) const {
    if (way.entered == 0) return -remembered(way.x, k, dq) / way.length;
    const EntryWeights weights(way.entered, ratio_before(dq));
    return -(weights.before * at(u, 0, k) + weights.earlier * at(u_before, 0, k)) / way.length;
  }

  Vector2d displacement_between(double theta, Index k) const {
    const PointSlip points = between(theta);
    Vector2d value = Vector2d::Zero();
    for (std::size_t l = 0; l < 4; ++l) value += points.weights[l] * at(u, points.points[l], k);
    return value;
  }

  /// Takes over what the material has done: what slipped remembers where it is now.
  void remember(double dq) {
    for (Index k = 0; k < rows.rows(); ++k) {
      MaterialRecords& row = memory[static_cast<std::size_t>(k)];
      const double y = rows.y(k), front = leading(k), exit = rows.x(2 * rows.elements(), k);
      if (dq > 0) {
        row.enter(front + distance, at(u, 0, k) + path.at(front + distance, y));
        row.leave(exit + distance);
      }
      row.change([&](double place, Vector2d& value) {
        const double x = place - distance;
        if (x <= exit || x >= front) return;
        const double theta = angle(x, k);
        const auto cell = static_cast<Index>(theta / pi * static_cast<double>(rows.elements()));
        const Index i = std::min(cell, rows.elements() - 1);
        if (!state.slips[static_cast<std::size_t>(rows.cell(i, k))]) return;
        value = displacement_between(theta, k) + path.at(place, y);
      });
    }
  }

  const Vector3d& motion_unit() const { return rolled ? units.motion : units.shift; }

  /// \param dq  scaled; 0 for a shift
  void step(double dq, const PatchLoad& load) {
    validate(load, problem.bound.total(), problem.bound.turning_moment());
    const PatchLoad scaled = units.scaled(load, dq > 0 ? units.motion : units.shift);
    for (std::size_t j = 0; j < scaled.size(); ++j) {
      require(std::abs(scaled[j].value) <= largest_motion_of_step, name_of(load, j), load[j].value,
              "a motion of at most 1e8 times that by the bound's strain");
    }
    const PatchResponse& of = response_of_step(dq);
    const ImposedSlip from = imposed(dq);
    state = solve_stick_slip(of, limits, scaled, &state, &from);
    rolled = dq > 0;
    u_before = u;
    u.noalias() = displacement * state.unknowns;
    step_before = dq;
    path = path.after(state.motion, dq == 0 ? 1 : dq, distance + dq / 2);
    distance += dq;
    remember(dq);
  }
};

PatchRolling::PatchRolling(const SteadyPatch& problem)
    : parts_((validate(problem), std::make_unique<Parts>(problem))) {}
PatchRolling::~PatchRolling() = default;
PatchRolling::PatchRolling(PatchRolling&&) noexcept = default;
PatchRolling& PatchRolling::operator=(PatchRolling&&) noexcept = default;

void PatchRolling::shift(const PatchLoad& load) { parts_->step(0, load); }

void PatchRolling::roll(double dq, const PatchLoad& load) {
  const double c = parts_->problem.bound.size(), least = least_step * (c + distance());
  require(dq >= least && dq <= longest_step * c, "dq", dq,
          [&] { return fmt::format("a length from {:.3g} to {:.3g}", least, longest_step * c); });
  parts_->step(dq / c, load);
}

double PatchRolling::distance() const { return parts_->distance * parts_->problem.bound.size(); }

VectorXd PatchRolling::x() const {
  return parts_->problem.bound.size() * centres_of(parts_->rows).col(0);
}

VectorXd PatchRolling::y() const {
  return parts_->problem.bound.size() * centres_of(parts_->rows).col(1);
}

MatrixX2d PatchRolling::tractions() const {
  return tractions_of(parts_->rows, parts_->state.unknowns, parts_->problem.bound.peak());
}

MatrixX2d PatchRolling::slip() const { return parts_->motion_unit()[0] * slip_of(parts_->state); }

const std::vector<bool>& PatchRolling::slips() const { return parts_->state.slips; }

Vector3d PatchRolling::resultants() const {
  const Parts& p = *parts_;
  if (!p.response) return Vector3d::Zero();
  return (p.response->of.resultants() * p.state.unknowns).cwiseProduct(p.units.resultant);
}

Vector3d PatchRolling::motion() const {
  return parts_->state.motion.cwiseProduct(parts_->motion_unit());
}

int PatchRolling::iterations() const { return parts_->state.iterations; }
double PatchRolling::residual() const { return parts_->state.residual; }

}  // namespace microslip
