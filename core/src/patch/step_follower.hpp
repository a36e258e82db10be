// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "cell_conditions.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/stick_slip.hpp"

namespace microslip {

/// Solves steps in which the same cells slip as before, without new factors and without memory:
/// corrections come from the system of an earlier state, which it was prepared with. They become
/// smaller by a constant factor, which is the change since then.
class StepFollower {
 public:
  using Index = Eigen::Index;
  using VectorXd = Eigen::VectorXd;

  /// \param response, limits  must outlive this object
  /// \param state             a solved one
  StepFollower(const PatchResponse& response, const VectorXd& limits, const PatchState& state,
               const PatchLoad& load);

  /// The state that it was prepared with, of which only the slip and the tractions matter.
  const PatchState& prepared_with() const { return prepared_->state; }

  /// The load that it was prepared for, of which only the kinds of components matter.
  const PatchLoad& prepared_for() const { return prepared_->load; }

  /// Whether it was prepared for a load like this one, and for these cells.
  bool fits(const PatchLoad& load, const std::vector<bool>& slips) const;

  /// Solves a step from the state before it.
  /// \return whether it is solved; otherwise the state is of no use
  bool follow(const PatchLoad& load, const ImposedSlip& imposed, PatchState& state);

 private:
  void begin(const PatchLoad& load, const ImposedSlip& imposed, PatchState& state);
  bool correct(const PatchLoad& load, PatchState& state);
  double residual(const ImposedSlip& imposed, PatchState& state);
  bool converges(const PatchLoad& load, const ImposedSlip& imposed, PatchState& state);

  /// What it was prepared with, and what follows from it.
  struct Prepared {
    PatchState state;
    PatchLoad load;
    std::vector<Index> columns, free;
    std::vector<Index> centres;  ///< places of the slip at centres that matters, in 2n values
    LuFactors factors;
    // By the unknowns: elastic own slip of cells that slip, and free components of the motion.
    Eigen::MatrixXd tractions, centre_slip;     ///< 2n x m, and only at centres
    Eigen::MatrixXd rigid;                      ///< own slip at columns by free components
    PatchResponse::Matrix centre_slip_elastic;  ///< at centres, by the elastic own slip
  };

  const PatchResponse* response_;
  const VectorXd* limits_;
  CellConditions conditions_;
  std::shared_ptr<const Prepared> prepared_;
  VectorXd elastic_, missing_, correction_, tractions_, slip_;
};

}  // namespace microslip
