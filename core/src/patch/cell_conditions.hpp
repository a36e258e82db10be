// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/stick_slip.hpp"
#include "slip_boundary.hpp"
#include "turning_slip.hpp"

namespace microslip {

/// The condition of a cell, linear about a state: by_q q, and by_own t + by_centre c + by_pole d +
/// by_q q of the cell and of up to eleven near it, are right. d is the lateral slip of
/// PatchResponse::pole().
struct CellCondition {
  struct BySlip {
    Eigen::Index cell;
    Eigen::Matrix2d by_own = Eigen::Matrix2d::Zero(), by_centre = Eigen::Matrix2d::Zero();
    Eigen::Vector2d by_pole = Eigen::Vector2d::Zero();
    Eigen::Matrix2d by_q = Eigen::Matrix2d::Zero();
  };

  Eigen::Matrix2d by_q;
  Eigen::Vector2d right;
  std::array<BySlip, 12> terms;
  std::size_t count = 1;
  bool slides = false;  ///< whether q is on the circle

  std::span<const BySlip> by_slip() const { return {terms.data(), count}; }

  /// The term of a cell, a new one if there is none yet.
  BySlip& term_of(Eigen::Index cell);
};

/// The slip conditions of cells about a state; equations and letters are those of solve_stick_slip().
class CellConditions {
 public:
  using Index = Eigen::Index;
  using Vector2d = Eigen::Vector2d;

  /// \param response  must outlive this object
  /// \param limits    g, which must outlive this object
  CellConditions(const PatchResponse& response, const Eigen::VectorXd& limits);

  /// \param ratio  r over r0, which is 1 until it is set
  void set_length(double ratio) { length_ratio_ = ratio; }

  /// Whether discs stay those of the state that is looked at now.
  void keep_discs(bool keeps) { keeps_discs_ = keeps; }

  /// Takes the state that all questions are about, until it is changed.
  /// \param state  must outlive this object
  void look_at(const PatchState& state);

  Vector2d quotient(Index i) const;

  /// The nearest point to q on the disc of a cell.
  Vector2d on_disc(Index i, const Vector2d& q) const;

  /// The nearest point to the present q on the circle of a cell.
  Vector2d on_circle(Index i) const;

  /// Computes the part of its limit that each cell carries where it slips, without what it loses by
  /// slip that turns: n.
  void find_carried(Eigen::VectorXd& parts) const;

  /// Those of all cells, on the disc: 2n.
  Eigen::VectorXd quotients() const;

  /// Whether a cell slips in the next system, |q - r t| > 1.
  bool slips_next(Index i, const Vector2d& q) const;

  /// s, which begins at the own slip and becomes that at the centre.
  Vector2d slip(Index i) const;

  /// q - P(q - r0 s)
  Vector2d error(Index i) const;

  /// The size of the largest error, not a number if one is not.
  double residual() const;

  /// With z = q - r s, e = z/|z| and D = (1 - e e')/|z|, the condition q = e is linear about z:
  ///   (1 - D) q + r D s = e.
  /// Within the disc the condition is s = 0, which is e = 0 and D = 1.
  /// In the transition s depends on q - r0 t, too; and the disc on the slip of the cells around.
  /// \param q  on the disc
  CellCondition about(Index i, const Vector2d& q) const;

  /// Whether the slip at the centre of a cell matters: it slips, or those around it do.
  bool has_centre_slip(Index i, const std::vector<bool>& slips) const;

 private:
  const FrictionDisc& disc(Index i) const { return discs_[static_cast<std::size_t>(i)]; }
  double carried(Index i) const { return 1 - shortfalls_[static_cast<std::size_t>(i)].value; }
  void add_own(Index cell, const Eigen::Matrix2d& by_own, CellCondition& found) const;
  void add_seen(Index cell, const Eigen::Matrix2d& by_seen, CellCondition& found) const;
  void add_shortfall(Index i, const Vector2d& by_value, CellCondition& found) const;

  const PatchResponse* response_;
  const Eigen::VectorXd* limits_;
  Eigen::VectorXd lengths_;  ///< r0
  TurningSlip turning_;
  SlipBoundary boundary_;
  std::vector<Shortfall> shortfalls_;
  std::vector<FrictionDisc> discs_;
  Eigen::VectorXd transitions_;  ///< |q - r0 t| - 1 from which the slip is that at the centre
  double length_ratio_ = 1;
  bool keeps_discs_ = false;
  const PatchState* state_ = nullptr;
};

}  // namespace microslip
