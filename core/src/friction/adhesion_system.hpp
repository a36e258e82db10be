// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <optional>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/linalg/toeplitz_block.hpp"

namespace microslip {

/// The linear equations of the elements in adhesion, with the creepage as one more unknown and one
/// more row for what is prescribed: response_HH d_H + w = ..., thesis (3.19).
///
/// Its factors follow the partition. Those of some earlier adhesion area stay; elements that came
/// or left since then border it, and only the Schur complement of the border is new. After some
/// exchanges, when the border is badly conditioned, or when it has served long enough, the factors
/// are made anew: LU, or ToeplitzBlock. A soft element is in the border, where its diagonal entry
/// may change from solve to solve, if any other one sticks.
class AdhesionSystem {
 public:
  AdhesionSystem(SquareMatrix response, Eigen::VectorXd weights, const Solver& solver);

  Eigen::Index size() const { return weights_.size(); }
  const SquareMatrix& response() const { return response_; }
  const Eigen::VectorXd& weights() const { return weights_; }
  const Solver& solver() const { return solver_; }

  /// Whether the added row holds the weights, for a force, or the creepage alone.
  void prescribe_force(bool force);

  /// Which element yields besides, if any; the response() does not show it.
  void soften(const std::optional<SoftElement>& soft);

  /// Makes the elements in adhesion the unknowns.
  void follow(const std::vector<Zone>& zones);

  struct Unknowns {
    Eigen::VectorXd increment;  ///< n, zero in slip
    Eigen::VectorXd response;   ///< to the increment; n
    double creepage;
    double residual;  ///< largest of the rows in adhesion and of the added one, over the largest of
                      ///< their terms
  };

  /// Refines until 1e-5 of the tolerance is reached, or rounding.
  /// \param slip        right-hand side of the rows; those of slip elements are ignored
  /// \param prescribed  that of the added row
  void solve(const Eigen::VectorXd& slip, double prescribed, Unknowns& unknowns);

 private:
  using Index = Eigen::Index;

  bool in_base(Index i) const { return position_[static_cast<std::size_t>(i)] >= 0; }
  Index position(Index i) const { return position_[static_cast<std::size_t>(i)]; }
  bool is_soft(Index i) const { return soft_ && soft_->element == i; }
  std::size_t exchanges() const;
  std::size_t most_changes() const;
  double border_softness(Index i) const {
    return is_soft(i) && !in_base(i) ? soft_->compliance : 0;
  }
  double border_scale(Index i) const { return 1 + border_softness(i) / scale_; }

  double entry(Index i, Index j) const;
  void column(Index j, Eigen::Ref<Eigen::VectorXd> values) const;
  double row_of_change(std::size_t change, const Eigen::VectorXd& base_values) const;

  void factorise();
  void factorise_base();
  void border(const std::vector<Index>& arrivals);
  void factorise_schur();
  void forget(std::size_t change);
  void solve_base(Eigen::VectorXd& values);
  void solve_block(Eigen::VectorXd& values);
  void solve_bordered(const Eigen::VectorXd& rhs, Eigen::VectorXd& all);
  double find_rest(const Unknowns& unknowns);

  SquareMatrix response_;
  Eigen::VectorXd weights_;
  Solver solver_;
  double scale_;  ///< makes the added row and column as large as the others
  double force_scale_;
  bool force_prescribed_ = false;
  std::optional<SoftElement> soft_;

  std::vector<char> stuck_;      ///< the unknowns; the creepage always is one
  std::vector<Index> base_;      ///< those of the factors
  std::vector<Index> position_;  ///< in base_, or -1
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
  double factors_rcond_ = 0;

  // In place of the factors where the base is Toeplitz and large. A constant is added to symmetric
  // matrices, which makes them positive definite, and taken off the creepage again.
  std::optional<ToeplitzBlock> block_;
  double constant_ = 0;
  bool by_block_ = false;
  Eigen::VectorXd base_weights_;
  Eigen::VectorXd unit_slip_;  ///< tractions of the base for a slip of 1

  std::vector<Index> changes_;  ///< elements that came or left since
  Eigen::MatrixXd columns_;     ///< factors^-1 times the column of each change
  Eigen::MatrixXd schur_;       ///< as if nothing were soft
  Eigen::PartialPivLU<Eigen::MatrixXd> schur_factors_;
  std::size_t quiet_rounds_ = 0;  ///< without a change

  Eigen::VectorXd rhs_, rest_, all_, values_, solved_, border_, block_values_, block_solved_;
};

}  // namespace microslip
