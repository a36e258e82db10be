// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <optional>
#include <vector>

#include "microslip/friction/active_set.hpp"

namespace microslip {

/// The linear equations of the elements in adhesion, with the creepage as one more unknown and one
/// more row for what is prescribed: response_HH d_H + w = ..., thesis (3.19).
///
/// Its factorisation follows the partition. That of some earlier adhesion area stays; elements that
/// came or left since then border it, and only the Schur complement of the border is new. An
/// exchange so costs O(n^2). After n/16 + 8 of them, when the border is badly conditioned, or when
/// it has served long enough, the factors are made anew. A soft element is in the border,
/// where its diagonal entry may change from solve to solve, if any other one sticks.
class AdhesionSystem {
 public:
  AdhesionSystem(const Eigen::MatrixXd& response, Eigen::VectorXd weights);

  Eigen::Index size() const { return weights_.size(); }
  auto response() const { return matrix_.topLeftCorner(size(), size()); }
  const Eigen::VectorXd& weights() const { return weights_; }

  /// Whether the added row holds the weights, for a force, or the creepage alone.
  void prescribe_force(bool force);

  /// Which element yields besides, if any; the response() does not show it.
  void soften(const std::optional<SoftElement>& soft);

  /// Makes the elements in adhesion the unknowns.
  void follow(const std::vector<Zone>& zones);

  struct Unknowns {
    Eigen::VectorXd increment;  ///< n, zero in slip
    double creepage;
  };

  /// \param slip        right-hand side of the rows; those of slip elements are ignored
  /// \param prescribed  that of the added row
  Unknowns solve(const Eigen::VectorXd& slip, double prescribed) const;

 private:
  using Index = Eigen::Index;

  bool in_base(Index i) const { return position_[static_cast<std::size_t>(i)] >= 0; }
  Index position(Index i) const { return position_[static_cast<std::size_t>(i)]; }
  bool is_soft(Index i) const { return soft_ && soft_->element == i; }
  std::size_t exchanges() const;
  double border_softness(Index i) const {
    return is_soft(i) && !in_base(i) ? soft_->compliance : 0;
  }
  double border_scale(Index i) const { return 1 + border_softness(i) / scale_; }

  void factorise();
  void border(const std::vector<Index>& arrivals);
  void factorise_schur();
  void forget(std::size_t change);
  Eigen::VectorXd solve_bordered(const Eigen::VectorXd& rhs) const;
  double row_of_change(std::size_t change, const Eigen::VectorXd& base_values) const;

  Eigen::VectorXd weights_;
  Eigen::MatrixXd matrix_;  ///< response, with the added row and column last
  double scale_;            ///< makes the added row and column as large as the others
  double force_scale_;
  bool force_prescribed_ = false;
  std::optional<SoftElement> soft_;

  std::vector<char> stuck_;      ///< the unknowns; the creepage always is one
  std::vector<Index> base_;      ///< those of the factors
  std::vector<Index> position_;  ///< in base_, or -1
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
  double factors_rcond_ = 0;

  std::vector<Index> changes_;  ///< elements that came or left since
  Eigen::MatrixXd columns_;     ///< factors^-1 times the column of each change
  Eigen::MatrixXd schur_;       ///< as if nothing were soft
  Eigen::PartialPivLU<Eigen::MatrixXd> schur_factors_;
  std::size_t quiet_rounds_ = 0;  ///< without a change
};

}  // namespace microslip
