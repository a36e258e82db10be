// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <optional>

#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip_ellipse.h"
#include "status.hpp"

/// The ellipse behind a handle of the C interface.
struct microslip_ellipse {
  /// A step that was attempted, and what it led to.
  struct Attempt {
    double dq;
    microslip::PatchLoad load;
    microslip::ContactScale contact;

    bool operator==(const Attempt&) const = default;
  };

  explicit microslip_ellipse(const microslip::SteadyPatch& of)
      : problem(of), rolling(of), trial(rolling) {}

  microslip_ellipse(const microslip_ellipse& other)
      : problem(other.problem),
        rolling(other.rolling),
        trial(other.rolling),
        solver(other.solver),
        has_second(other.has_second),
        warning(other.warning) {}

  microslip::SteadyPatch problem;
  microslip::PatchRolling rolling, trial;
  std::optional<Attempt> attempt = {};  ///< that `trial` has made
  std::optional<microslip::SteadyPatchSolver> solver = {};
  bool has_second = false;  ///< of the last step or steady solution, see SlipFriction
  char message[512] = "";   ///< of the last call that failed
  microslip::capi::Warning warning = {};
  mutable std::mutex mutex;  ///< held by each call
};

namespace microslip::capi {

/// Does the work with an ellipse, while no other thread does.
template <class Work>
microslip_status with_ellipse(microslip_ellipse* handle, const Work& work) noexcept {
  if (handle == nullptr) return MICROSLIP_BAD_INPUT;
  const std::lock_guard lock(handle->mutex);
  return guarded({handle->message, sizeof handle->message}, [&] { work(*handle); });
}

/// \throws std::invalid_argument for what is out of its range
SteadyPatch make_patch(const microslip_material& material, const microslip_ellipse_contact& contact,
                       const microslip_ellipse_grid* grid);

/// \throws std::invalid_argument for what is none of microslip_prescribed, and no number
PatchLoad load_of(const microslip_ellipse_load& load);

/// Reads a load that is to be solved, and warns of motions that are doubtful.
/// \throws std::invalid_argument as load_of()
PatchLoad read_load(microslip_ellipse& ellipse, const microslip_ellipse_load* load);

/// Makes a step on the trial, unless it has made it.
/// \throws std::invalid_argument likewise, and as PatchRolling::roll; NotConverged
void attempt(microslip_ellipse& ellipse, double dq, const PatchLoad& load);

/// Makes a step, which costs nothing if it was the last one to be attempted.
/// \throws as attempt()
void advance(microslip_ellipse& ellipse, double dq, const PatchLoad& load);

microslip_ellipse_state state_of(const PatchRolling& rolling);
microslip_ellipse_state state_of(const SteadyPatchSolution& solution, double full_sliding);

/// Values of all cells, see microslip_ellipse_cells.
struct CellValues {
  Eigen::VectorXd x, y, area, bound;
  Eigen::MatrixX2d traction, slip;
  std::vector<bool> slips;
};
void put_cells(const CellValues& values, const microslip_ellipse_cells& out);

/// The same arrays from one of their values on; a null pointer stays one.
microslip_ellipse_cells cells_from(const microslip_ellipse_cells& cells, std::size_t at);

/// Solves steady rolling in the contact that is set.
/// \throws as SteadyPatchSolver
microslip_ellipse_state solve_steady(microslip_ellipse& ellipse, const PatchLoad& load);

}  // namespace microslip::capi
