// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/linalg/gmres.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/patch/patch_response.hpp"

namespace microslip {

/// Solves systems of slip in rows of cells, and of a few unknowns of the whole patch behind it: small
/// ones by LU, large ones by GMRES, with the blocks of the rows as a preconditioner.
class RowBlockSolver {
 public:
  using Index = Eigen::Index;

  /// \param near  a vector near the solution, where GMRES begins
  /// \param rows  the row of each slip; the unknowns behind these belong to no row
  Eigen::VectorXd solve(const PatchResponse::Matrix& system, const Eigen::VectorXd& right,
                        const Eigen::VectorXd& near, const std::vector<Index>& rows);

 private:
  struct Block {
    std::vector<Index> places;
    LuFactors factors;
  };

  void factor(const PatchResponse::Matrix& system, const std::vector<Index>& rows);
  void precondition(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

  static constexpr int most_iterations = 60;
  std::vector<Block> blocks_;
  Gmres gmres_{most_iterations};
};

}  // namespace microslip
