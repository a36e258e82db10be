// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/linalg/toeplitz_block.hpp"

namespace microslip {

class Archive;

/// The linear equations of the elements in adhesion: response_HH d_H + w = ..., thesis (3.19). The
/// creepage is one more unknown, and the prescribed force or creepage one more row.
///
/// The factors follow the partition. The factors of an earlier adhesion area, the base, stay.
/// Elements that came or left since then border them, and only the Schur complement of the border
/// is new. Elements that have gone back keep their place in the border, because the same elements
/// come and go with every element travelled. New factors, LU or ToeplitzBlock, are made after some
/// exchanges, when the border is badly conditioned, and when one of its elements has served long
/// enough. Compliant elements are in the border, where their entries on the diagonal may change
/// from solve to solve.
///
/// Memory is allocated for new factors, and for an element that is new in the border.
class AdhesionSystem {
 public:
  AdhesionSystem(SquareMatrix response, Eigen::VectorXd weights, const Solver& solver);

  Eigen::Index size() const { return weights_.size(); }
  const SquareMatrix& response() const { return response_; }
  const Eigen::VectorXd& weights() const { return weights_; }
  const Solver& solver() const { return solver_; }

  /// Whether the added row holds the weights, for a force, or the creepage alone.
  void prescribe_force(bool force);

  /// Puts elements on springs, which the response() does not include.
  void set_compliant(const std::vector<CompliantElement>& compliant);

  /// Makes the elements in adhesion the unknowns.
  void follow(const std::vector<Zone>& zones);

  struct Unknowns {
    Eigen::VectorXd increment;  ///< n, zero in slip
    Eigen::VectorXd response;   ///< to the increment; n
    double creepage;
    double residual;  ///< largest of the rows in adhesion and of the added one, over the largest of
                      ///< their terms
  };

  /// Refines until a residual is reached, or rounding.
  /// \param slip        right-hand side of the rows; those of slip elements are ignored
  /// \param prescribed  that of the added row
  /// \param enough      residual, over the tolerance
  void solve(const Eigen::VectorXd& slip, double prescribed, double enough, Unknowns& unknowns);

  /// Estimate of the condition number in the 1-norm; 1 without elements. Refactorises first, so
  /// that the estimate does not depend on the history of updates.
  double condition();

  /// Writes or reads what the next solve depends on to the bit: the base, the border with its
  /// columns, and what sticks. The factors are made again, which gives the same ones.
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

  SquareMatrix response_;
  Eigen::VectorXd weights_;
  Solver solver_;
  double scale_;  ///< makes the added row and column as large as the others
  double force_scale_;
  bool force_prescribed_ = true;
  std::vector<CompliantElement> compliant_;

  std::vector<char> stuck_;      ///< whether an element is in adhesion
  std::vector<Index> base_;      ///< elements of the factors
  std::vector<Index> position_;  ///< in base_, or -1
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
  double factors_rcond_ = 0;

  // These take the place of the factors where the base is Toeplitz and large. A constant added to
  // symmetric matrices makes them positive definite; the creepage is corrected for it.
  std::optional<ToeplitzBlock> block_;
  double constant_ = 0;
  bool by_block_ = false;
  bool base_is_in_parts_ = false;  ///< in several intervals: solves of the block are iterative
  Eigen::VectorXd base_weights_;
  Eigen::VectorXd unit_slip_;  ///< tractions of the base for a slip of 1

  struct Change {
    Index element;
    std::size_t rounds = 0;  ///< that it has served in a row
  };

  // The border. An element that came adds its row and column. An element of the base that left adds
  // its slip as an unknown, and the equation that its traction is zero, or, if it has become
  // compliant, that its traction is the slip over its compliance. The matrices have room for
  // most_changes().
  std::vector<Change> changes_;
  Eigen::MatrixXd rows_;     ///< of each change, at the elements of the base
  Eigen::MatrixXd columns_;  ///< factors^-1 times the column of each
  Eigen::MatrixXd schur_;    ///< as if no element were compliant or had gone back
  Eigen::PartialPivLU<Eigen::MatrixXd> schur_factors_;
  double schur_rcond_ = 0;      ///< by its pivots
  bool border_is_new_ = false;  ///< since the factors of the Schur complement
  std::vector<Index> arrivals_;

  Eigen::VectorXd rhs_, rest_, all_, values_, solved_, border_, border_solved_, block_values_,
      block_solved_;
};

}  // namespace microslip
