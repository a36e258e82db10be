// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <optional>
#include <variant>

#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/linalg/gmres.hpp"
#include "microslip/linalg/solver.hpp"
#include "microslip/linalg/square_matrix.hpp"
#include "microslip/linalg/toeplitz_inverse.hpp"

namespace microslip {

/// Positions of n + 1 equations between, before and after n nodes, from the centre  [elements]
Eigen::VectorXd middles_of(Eigen::Index n);

/// n elements and the creepage from a strain that is given as a mean over each element from node
/// i - 1 to node i, i = 0 ... n, with nodes -1 and n outside the elements. The strain of elements
/// and their spacing only depends on the ratio of that to the strip width: in plane strain one
/// system serves all spacings, and for strips the factors of one nearby.
class StrainSystem {
 public:
  /// \throws std::invalid_argument if the solver wants FFT for functions that are not all equal
  StrainSystem(const Kernel& kernel, const Basis& basis, Eigen::Index elements,
               const Solver& solver);

  struct Unknowns {
    Eigen::VectorXd elements;  ///< coefficients of the functions  [N/mm^2]
    double creepage;           ///< [1]
    double residual;           ///< of the equations, over the strain  [1]
  };

  /// \throws NotConverged if the residual is above the tolerance
  Unknowns solve(double spacing, const Eigen::VectorXd& strain);

  /// Estimate of the condition number of the last factors in the 1-norm.
  double condition() const;

 private:
  using Index = Eigen::Index;

  void assemble(double spacing);
  void factorise();
  void multiply(const Eigen::VectorXd& unknowns, Eigen::VectorXd& strain) const;
  void solve_nearby(const Eigen::VectorXd& strain, Eigen::VectorXd& unknowns);
  double refine(const Eigen::VectorXd& strain, Eigen::VectorXd& unknowns);

  Kernel kernel_;
  Basis basis_;
  Index elements_;
  Solver solver_;
  bool plane_;
  double spacing_ = 0;                  ///< of the matrix
  std::optional<SquareMatrix> matrix_;  ///< of n + 1 nodes from -1 on if Toeplitz; else bordered

  double factored_spacing_ = 0;
  std::variant<Eigen::PartialPivLU<Eigen::MatrixXd>, ToeplitzInverse> factors_;
  Eigen::VectorXd unit_strain_;  ///< Toeplitz: all n + 1 nodes for a strain of 1

  Gmres gmres_;
  mutable Eigen::VectorXd padded_;
  Eigen::VectorXd product_, rest_, correction_;
};

}  // namespace microslip
