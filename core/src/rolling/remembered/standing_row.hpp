// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "row_edges.hpp"
#include "row_memory.hpp"
#include "row_response.hpp"
#include "stick_slip_point.hpp"

namespace microslip {

/// A row in a shift without rolling, on a contact that keeps its size: the nodes and an element at
/// the entry carry traction. Adhesion may end anywhere within an element on either side, so that
/// the mean over partitions is taken at both ends.
class StandingRow {
 public:
  /// \param x  of the row's nodes on the problem's contact  [mm]
  StandingRow(const RowResponse& response, const RowEdges& edges, const TractionBound& bound,
              const Eigen::VectorXd& x);

  /// Solves a shift.
  /// \param before  the row before the shift
  /// \param memory  a copy of `before`; out
  /// \param result  out: residuals and iterations
  /// \return        the shift  [mm]
  /// \throws as ActiveSet::solve
  double shift(const RowResponse& response, const ShiftLoad& load, const RowMemory& before,
               RowMemory& memory, ContactState& result);

  /// RowResponse::version() of the influence coefficients.
  int version() const { return version_; }

  /// \param size  N
  void archive(Archive& archive, Eigen::Index size);

 private:
  bool search(const RowResponse& response, const ShiftLoad& load, const RowMemory& before,
              RowMemory& memory, ContactState& result);
  void average(const ShiftLoad& load, RowMemory& memory);

  /// Means of the bound over elements of the problem's contact, and of the mirrored one [N/mm^2]
  std::array<Eigen::VectorXd, 2> bounds_;
  CompliantElement entry_;
  int version_;
  ActiveSet active_set_;     ///< N + 1
  StickSlipPoint trailing_;  ///< stick-slip point
  StickSlipPoint leading_;   ///< stick-slip point of the mirrored row

  // The shift that is solved.
  SlipConditions conditions_;
  RolledContact partition_;
};

}  // namespace microslip
