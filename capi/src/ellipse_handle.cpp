// SPDX-License-Identifier: GPL-3.0-or-later
#include "ellipse_handle.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "microslip/patch/large_motion.hpp"
#include "microslip/patch/patch_grid.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "zero.hpp"

namespace microslip::capi {

namespace {

void copy_to(double (&to)[3], const Eigen::Vector3d& from) {
  for (Eigen::Index j = 0; j < 3; ++j) to[j] = without_sign_of_zero(from[j]);
}

Eigen::Index cells_of(const char* name, int cells, Eigen::Index least) {
  require(cells >= least && cells <= most_cells_of_side, name, cells, [&] {
    return fmt::format("a whole number {} ... {}, or 0 of both", least, most_cells_of_side);
  });
  return cells;
}

/// The bound of an ellipse that is set.
EllipticBound bound_of(const microslip_ellipse& ellipse) {
  const PatchBound& first = ellipse.problem.bound;
  const auto& [size, bound] = ellipse.rolling.contact();
  return {size * first.half_width(), size * first.lateral_half_width(), bound * first.peak()};
}

template <class Values>
void put(double* to, const Values& values) {
  if (to == nullptr) return;
  for (const double value : values) *to++ = without_sign_of_zero(value);
}

template <class Value>
Value* moved(Value* to, std::size_t by) {
  return to == nullptr ? nullptr : to + by;
}

}  // namespace

SteadyPatch make_patch(const microslip_material& material, const microslip_ellipse_contact& contact,
                       const microslip_ellipse_grid* grid) {
  require_positive("half_width", contact.half_width);
  require_positive("lateral_half_width", contact.lateral_half_width);
  require_positive("peak_traction", contact.peak_traction);
  const double a = contact.half_width, b = contact.lateral_half_width;
  require(is_patch_ratio(a / b), "lateral_half_width", b, [&] {
    return fmt::format("a number between {} and {}, by half_width",
                       format_short(a / largest_patch_ratio), format_short(a / least_patch_ratio));
  });
  const PatchBound bound = EllipticBound(a, b, contact.peak_traction);
  PatchGrid cells = fitting_grid(bound.shape());
  if (grid != nullptr && (grid->rows != 0 || grid->elements != 0)) {
    cells = {.rows = cells_of("rows", grid->rows, 1),
             .elements = cells_of("elements", grid->elements, least_elements)};
  }
  SteadyPatch patch{.material = {.shear_modulus = material.shear_modulus,
                                 .poisson_ratio = material.poisson_ratio},
                    .bound = bound,
                    .rows = cells.rows,
                    .elements = cells.elements};
  patch.accepted.residual = largest_residual_of_step;  // on fine rows, rounding is above others
  validate(patch);
  return patch;
}

PatchLoad load_of(const microslip_ellipse_load& load) {
  PatchLoad found;
  for (std::size_t j = 0; j < found.size(); ++j) {
    const int kind = load.prescribed[j];
    if (kind != MICROSLIP_MOTION && kind != MICROSLIP_RESULTANT) {
      throw std::invalid_argument(fmt::format(
          "prescribed[{}] = {}: expected MICROSLIP_MOTION or MICROSLIP_RESULTANT", j, kind));
    }
    found[j] = {.by_resultant = kind == MICROSLIP_RESULTANT, .value = load.value[j]};
    require(true, name_of(found, j), load.value[j], "a finite number");
  }
  return found;
}

PatchLoad read_load(microslip_ellipse& ellipse, const microslip_ellipse_load* load) {
  const PatchLoad read = load_of(require_pointer(load, "load"));
  ellipse.warning.forget_load();
  for (std::size_t j = read.size(); j-- > 0;) {
    const auto& [by_resultant, value] = read[j];
    const std::string doubt = by_resultant ? "" : doubt_of_large_motion(j, value, ellipse.problem);
    if (doubt.empty()) continue;
    ellipse.warning.say(fmt::format("{} = {:.6g}: {}", name_of(read, j), value, doubt));
  }
  return read;
}

void attempt(microslip_ellipse& ellipse, double dq, const PatchLoad& load) {
  const microslip_ellipse::Attempt wanted{dq, load, ellipse.rolling.contact()};
  if (ellipse.attempt == wanted) return;
  ellipse.attempt.reset();
  ellipse.trial = ellipse.rolling;
  ellipse.trial.roll(dq, load);
  ellipse.attempt = wanted;
}

void advance(microslip_ellipse& ellipse, double dq, const PatchLoad& load) {
  if (ellipse.attempt == microslip_ellipse::Attempt{dq, load, ellipse.rolling.contact()}) {
    std::swap(ellipse.rolling, ellipse.trial);
  } else {
    ellipse.rolling.roll(dq, load);
  }
  ellipse.has_second = ellipse.rolling.has_second();
  ellipse.attempt.reset();
}

microslip_ellipse_state state_of(const PatchRolling& rolling) {
  microslip_ellipse_state state{};
  state.distance = without_sign_of_zero(rolling.distance());
  copy_to(state.resultants, rolling.resultants());
  copy_to(state.motion, rolling.motion());
  state.dissipation = without_sign_of_zero(rolling.dissipation());
  state.full_sliding = rolling.full_sliding();
  const Eigen::VectorXd areas = rolling.areas();
  const double area = areas.sum();
  state.slip_share = area > 0 ? slip_area_of(areas, rolling.slips()) / area : 0;
  state.residual = rolling.residual();
  state.iterations = rolling.iterations();
  return state;
}

microslip_ellipse_state solve_steady(microslip_ellipse& ellipse, const PatchLoad& load) {
  const auto& [size, bound] = ellipse.rolling.contact();
  const auto* const factor = size > 0 ? "bound_factor" : "size_factor";
  require(size > 0 && bound > 0, factor, 0, "a number > 0 for steady rolling");
  if (!ellipse.solver) ellipse.solver.emplace(ellipse.problem, false);
  const bool is_hertz = ellipse.problem.bound.is_hertz();
  if (is_hertz) ellipse.solver->set_bound(bound_of(ellipse));
  // Another bound that is g times as large has the same solution with g times the load, motions
  // included.
  const double g = is_hertz ? 1 : ellipse.rolling.contact().bound;
  require(g == 1 || !ellipse.problem.friction, "bound_factor", g,
          "1 where friction depends on slip, and the bound is not an ellipse's");
  PatchLoad over_bound = load;
  for (PatchComponent& component : over_bound) component.value /= g;
  SteadyPatchSolution solution = ellipse.solver->solve(over_bound);
  require_evidence(solution.evidence, solution.condition, solution.iterations,
                   ellipse.problem.accepted);
  ellipse.has_second = solution.has_second;
  solution.resultants *= g;
  solution.motion *= g;
  solution.dissipation *= g * g;
  return state_of(solution,
                  is_hertz ? bound_of(ellipse).total() : g * ellipse.problem.bound.total());
}

microslip_ellipse_state state_of(const SteadyPatchSolution& solution, double full_sliding) {
  microslip_ellipse_state state{};
  copy_to(state.resultants, solution.resultants);
  copy_to(state.motion, solution.motion);
  state.dissipation = without_sign_of_zero(solution.dissipation);
  state.full_sliding = full_sliding;
  state.slip_share = solution.slip_area() / solution.area.sum();
  state.residual = solution.state.residual;
  state.iterations = solution.iterations;
  return state;
}

void put_cells(const CellValues& values, const microslip_ellipse_cells& out) {
  put(out.x, values.x);
  put(out.y, values.y);
  put(out.area, values.area);
  put(out.bound, values.bound);
  put(out.traction_x, values.traction.col(0));
  put(out.traction_y, values.traction.col(1));
  put(out.slip_x, values.slip.col(0));
  put(out.slip_y, values.slip.col(1));
  if (out.slips != nullptr) std::ranges::copy(values.slips, out.slips);
}

microslip_ellipse_cells cells_from(const microslip_ellipse_cells& cells, std::size_t at) {
  return {.x = moved(cells.x, at),
          .y = moved(cells.y, at),
          .area = moved(cells.area, at),
          .bound = moved(cells.bound, at),
          .traction_x = moved(cells.traction_x, at),
          .traction_y = moved(cells.traction_y, at),
          .slip_x = moved(cells.slip_x, at),
          .slip_y = moved(cells.slip_y, at),
          .slips = moved(cells.slips, at)};
}

}  // namespace microslip::capi
