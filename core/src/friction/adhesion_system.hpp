// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/linalg/toeplitz_block.hpp"

namespace microslip {

/// The linear equations of the elements in adhesion, with the creepage as one more unknown and one
/// more row for what is prescribed: response_HH d_H + w = ..., thesis (3.19).
///
/// Its factors follow the partition. Those of some earlier adhesion area stay; elements that came
/// or left since then border it, and only the Schur complement of the border is new. Elements that
/// have gone back keep their place in the border, for on a grid that is fixed to the material the
/// same ones come and go with every element travelled. After some exchanges, when the border is
/// badly conditioned, or when a part of it has served long enough, the factors are made anew: LU,
/// or ToeplitzBlock. Soft elements are in the border, where their entries on the diagonal may
/// change from solve to solve.
///
/// Memory is allocated for new factors, and where an element comes or leaves that the border does
/// not know.
class AdhesionSystem {
 public:
  AdhesionSystem(SquareMatrix response, Eigen::VectorXd weights, const Solver& solver);

  Eigen::Index size() const { return weights_.size(); }
  const SquareMatrix& response() const { return response_; }
  const Eigen::VectorXd& weights() const { return weights_; }
  const Solver& solver() const { return solver_; }

  /// Whether the added row holds the weights, for a force, or the creepage alone.
  void prescribe_force(bool force);

  /// Which elements yield besides; the response() does not show it.
  void soften(const std::vector<SoftElement>& soft);

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

  /// Estimate of the condition number in the 1-norm; 1 without elements. What borders the factors
  /// becomes part of new ones, or the estimate would be that of the way that led here.
  double condition();

 private:
  using Index = Eigen::Index;

  bool in_base(Index i) const { return position_[static_cast<std::size_t>(i)] >= 0; }
  Index position(Index i) const { return position_[static_cast<std::size_t>(i)]; }
  double softness(Index i) const;
  bool is_stuck(Index i) const { return stuck_[static_cast<std::size_t>(i)] != 0; }
  Index element(Index change) const { return changes_[static_cast<std::size_t>(change)].element; }
  /// Whether an element of the border has come, left or become soft, and not gone back.
  bool is_active(Index i) const {
    return is_stuck(i) ? !in_base(i) || softness(i) > 0 : in_base(i);
  }
  std::size_t most_changes() const;
  double corner(Index i) const;
  double border_scale(Index i) const { return 1 + std::abs(corner(i)) / scale_; }

  double entry(Index i, Index j) const;

  void factorise();
  void factorise_base();
  void border(const std::vector<Index>& arrivals);
  void factorise_schur();
  void forget_those_gone_back();
  bool serves_too_long();
  void solve_base(Eigen::VectorXd& values);
  void solve_block(Eigen::VectorXd& values);
  void solve_bordered(const Eigen::VectorXd& rhs, Eigen::VectorXd& all);
  double find_rest(const Unknowns& unknowns);

  SquareMatrix response_;
  Eigen::VectorXd weights_;
  Solver solver_;
  double scale_;  ///< makes the added row and column as large as the others
  double force_scale_;
  bool force_prescribed_ = true;
  std::vector<SoftElement> soft_;

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

  struct Change {
    Index element;
    std::size_t rounds = 0;  ///< that it has served in a row
  };

  // The border. An element that came adds its row and column. One of the base that left adds a slip
  // of its own as an unknown, and the condition that its traction is zero, or, if it has become
  // soft, that slip over its compliance. The matrices have room for most_changes().
  std::vector<Change> changes_;
  Eigen::MatrixXd rows_;     ///< of each change, at the elements of the base
  Eigen::MatrixXd columns_;  ///< factors^-1 times the column of each
  Eigen::MatrixXd schur_;    ///< as if nothing were soft, nor had gone back
  Eigen::PartialPivLU<Eigen::MatrixXd> schur_factors_;
  double schur_rcond_ = 0;      ///< by its pivots
  bool border_is_new_ = false;  ///< since the factors of the Schur complement
  std::vector<Index> arrivals_;

  Eigen::VectorXd rhs_, rest_, all_, values_, solved_, border_, border_solved_, block_values_,
      block_solved_;
};

}  // namespace microslip
