// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cell_conditions.hpp"
#include "microslip/patch/patch_load.hpp"
#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/stick_slip.hpp"

namespace microslip {

/// The linear system of the cells that slip: its unknowns are their elastic own slip, longitudinal
/// parts first, and the components of the motion that follow from a resultant.
class SlipSystem {
 public:
  using Index = Eigen::Index;
  using Matrix = PatchResponse::Matrix;
  using VectorXd = Eigen::VectorXd;

  SlipSystem(const PatchResponse& response, const VectorXd& limits)
      : response_(response), limits_(limits) {}

  /// Sets the conditions about a state, and those of the load.
  /// \param conditions  that look at the state
  /// \param q           of all cells, on the disc
  void assemble(const CellConditions& conditions, const PatchState& state, const VectorXd& q,
                const PatchLoad& load, const ImposedSlip& imposed);

  const Matrix& matrix() const { return matrix_; }
  const VectorXd& right() const { return right_; }

  /// The places of slip in vectors of 2n values.
  const std::vector<Index>& columns() const { return columns_; }

  /// Whether the condition of a cell is that q is on the circle of its disc.
  bool slides(Index cell) const { return slides_[static_cast<std::size_t>(cell)]; }

  /// The components of the motion that follow.
  const std::vector<Index>& free() const { return free_; }

  /// The prescribed motion, and a unit of each free component: 3 x (1 + free).
  const Eigen::MatrixXd& motions() const { return motions_; }

  /// The elastic slip of cells that stick, by these; 0 of others: 2n x (1 + free).
  const Eigen::MatrixXd& stuck() const { return stuck_; }

  /// The row of cells of each slip.
  std::vector<Index> rows_of_unknowns() const;

  /// The unknowns in a state.
  VectorXd unknowns_of(const PatchState& state, const ImposedSlip& imposed) const;

  /// Takes a solution over into a state.
  void apply(const VectorXd& solution, const CellConditions& conditions, const ImposedSlip& imposed,
             PatchState& state) const;

 private:
  void split_motion(const PatchLoad& load);
  void set_condition(const CellCondition& condition, Index r, Index size,
                     const ImposedSlip& imposed);
  void set_resultant(const PatchLoad& load, Index j, Index size);

  const PatchResponse& response_;
  const VectorXd& limits_;
  std::vector<Index> columns_, free_;
  std::vector<bool> slides_;
  std::vector<Index> places_;  ///< of slipping cells in `columns_`
  Eigen::MatrixXd motions_, stuck_;
  Matrix matrix_;
  VectorXd right_;
  Eigen::RowVectorXd by_elastic_;
};

}  // namespace microslip
