// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/linalg/lu_factors.hpp"

namespace microslip {

class Archive;

inline std::size_t to_size(Eigen::Index i) { return static_cast<std::size_t>(i); }

/// The linear equations of the elements in adhesion: response_HH d_H + w = ..., thesis (3.19). The
/// rigid slip is one more unknown, and the prescribed force or rigid slip one more row.
///
/// The factors follow the partition. The factors of an earlier adhesion area, the base, are kept.
/// Elements that came or left since then form a border of these factors, and only the Schur
/// complement of the border is factorised again. Elements that have gone back keep their place in
/// the border, because the same elements come and go with every element travelled. New factors, LU
/// or ToeplitzSubmatrix, are made after some exchanges, when the border is badly conditioned, and
/// when an element of the border has been in use too long. Compliant elements are in the border,
/// where their entries on the diagonal may change from solve to solve.
///
/// Memory is allocated only for new factors, and for a new element in the border.
class AdhesionSystem {
 public:
  AdhesionSystem(LinearOperator response, Eigen::VectorXd weights, const Solver& solver);

  Eigen::Index size() const { return weights_.size(); }
  const LinearOperator& response() const { return response_; }
  const Eigen::VectorXd& weights() const { return weights_; }
  const Solver& solver() const { return solver_; }

  /// Selects the added row: the weights, for a prescribed force, or the rigid slip alone.
  void prescribe_force(bool force);

  /// Puts elements on springs; response() does not include the springs.
  void set_compliant(const std::vector<CompliantElement>& compliant);

  /// Makes the elements in adhesion the unknowns.
  void follow(const std::vector<Zone>& zones);

  struct Unknowns {
    Eigen::VectorXd increment;  ///< n, zero in slip
    Eigen::VectorXd response;   ///< of the slip to the increment; n
    double rigid_slip;
    double residual;  ///< largest residual of the rows in adhesion and of the added row, over their
                      ///< largest term
  };

  /// Solves, and refines until the residual is small enough, or at the level of rounding errors.
  /// \param slip        right-hand side of the rows; entries of slip elements are ignored
  /// \param prescribed  right-hand side of the added row
  /// \param enough      required residual, over the tolerance
  void solve(const Eigen::VectorXd& slip, double prescribed, double enough, Unknowns& unknowns);

  /// Estimate of the condition number in the 1-norm; 1 without elements. Refactorises first, so
  /// that the estimate does not depend on the history of updates.
  double condition();

  /// Writes or reads the data that determine the bits of the next solve: the base, the border with
  /// its columns, and the elements in adhesion. Factors are not stored; a reader makes the same
  /// factors again.
  void archive(Archive& archive);

 private:
  using Index = Eigen::Index;

  bool in_base(Index i) const { return position_[static_cast<std::size_t>(i)] >= 0; }
  Index position(Index i) const { return position_[static_cast<std::size_t>(i)]; }
  double compliance_of(Index i) const;
  bool is_stuck(Index i) const { return stuck_[static_cast<std::size_t>(i)] != 0; }
  Index element(Index change) const { return changes_[static_cast<std::size_t>(change)].element; }
  /// Whether an element of the border has come, left or become compliant, and not gone back.
  bool is_active(Index i) const {
    return is_stuck(i) ? !in_base(i) || compliance_of(i) > 0 : in_base(i);
  }
  std::size_t most_changes() const;
  double corner(Index i) const;
  double border_scale(Index i) const { return 1 + std::abs(corner(i)) / scale_; }

  double entry(Index i, Index j) const;

  void factorise();
  void factorise_base();
  void factorise_again(const std::vector<Index>& elements);
  void make_room();
  void place_row(Index change);
  void border(const std::vector<Index>& arrivals);
  void factorise_schur();
  void forget_those_gone_back();
  bool adhesion_is_in_parts() const;
  bool serves_too_long();
  void solve_base(Eigen::VectorXd& values);
  void solve_block(Eigen::VectorXd& values);
  void solve_bordered(const Eigen::VectorXd& rhs, Eigen::VectorXd& all);
  double find_rest(const Unknowns& unknowns);

  LinearOperator response_;
  Eigen::VectorXd weights_;
  Solver solver_;
  double scale_;  ///< makes the added row and column as large as the others
  double force_scale_;
  bool force_prescribed_ = true;
  std::vector<CompliantElement> compliant_;

  std::vector<char> stuck_;      ///< whether an element is in adhesion
  std::vector<Index> base_;      ///< elements of the factors
  std::vector<Index> position_;  ///< in base_, or -1
  LuFactors factors_;
  double factors_rcond_ = 0;

  // The operator's solver replaces the LU factors if it has one and the base is large. A constant is
  // added to symmetric matrices to make them positive definite; the rigid slip is corrected for
  // that constant.
  std::optional<LinearOperator::BlockSolver> block_;
  bool by_block_ = false;
  bool base_is_in_parts_ = false;  ///< whether the base has several intervals, so that solves of
                                   ///< the block are iterative
  Eigen::VectorXd base_weights_;
  Eigen::VectorXd unit_slip_;  ///< tractions of the base for a slip of 1

  struct Change {
    Index element;
    std::size_t rounds = 0;  ///< consecutive rounds in which the change was active
  };

  // The border. An element that came adds its row and column. An element of the base that left adds
  // its slip as an unknown, and the equation that its traction is zero, or, for an element that has
  // become compliant, that the traction is the slip over the compliance. The matrices have room for
  // most_changes().
  std::vector<Change> changes_;
  Eigen::MatrixXd rows_;     ///< of each change, at the elements of the base
  Eigen::MatrixXd columns_;  ///< factors^-1 times the column of each change
  Eigen::MatrixXd schur_;    ///< for all elements hard and none gone back
  LuFactors schur_factors_;
  double schur_rcond_ = 0;      ///< estimated from the pivots
  bool border_is_new_ = false;  ///< whether the border has changed since the Schur complement was
                                ///< factorised
  std::vector<Index> arrivals_;

  Eigen::VectorXd rhs_, rest_, all_, values_, solved_, border_, border_solved_, block_values_,
      block_solved_;
};

}  // namespace microslip
