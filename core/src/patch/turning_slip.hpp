// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/stick_slip.hpp"

namespace microslip {

/// The disc on which q lies, the tractions of a cell over their limit. It is the unit disc about 0, but
/// for cells within which the slip turns.
struct FrictionDisc {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 1;
};

/// The disc's derivatives by the slip that is seen and by the slip at the centre of a cell and of those
/// around.
struct DiscGrowth {
  std::array<Eigen::Matrix2d, 9> centre_by_seen, centre_by_slip;
  std::array<Eigen::Vector2d, 9> centre_by_pole;  ///< by lateral slip of PatchResponse::pole()
  std::array<Eigen::RowVector2d, 9> radius_by_seen, radius_by_slip;
};

/// The slip of cells about which it turns.
///
/// A cell slips in the direction of the slip at its centre. Where spin is strong, the slip turns about
/// a pole, and all directions meet in the cell that has it: the direction at the centre is a matter of
/// chance then. There q is the mean m of the directions over the cell, so that the disc shrinks to the
/// point m as the cells around begin to slip, and as their directions differ:
///   centre W m,  radius 1 - W.
/// The slip within the cell and halfway beyond is the parabola through the slip at nine centres, with
/// that of PatchResponse::pole(). Tractions that are interpolated between centres are to have the mean
/// of directions, so that m has 1/24 of their second differences less.
///
/// How much the cells around slip is told by the slip that is seen. The own slip of a short step
/// would leave some without a solution near: traction falls as a cell begins to slip, which gives
/// more slip, all the more the shorter the step.
class TurningSlip {
 public:
  using Index = Eigen::Index;

  /// \param response  must outlive this object
  /// \param limits    g, over G and by p/v
  TurningSlip(const PatchResponse& response, const Eigen::VectorXd& limits);

  /// Whether the eight cells around a cell slip. Cells at the edges are not enclosed.
  bool is_enclosed(Index cell, const std::vector<bool>& slips) const;

  /// A cell and those around it, which it is the middle one of. The cell must not be at an edge.
  std::array<Index, 9> around(Index cell) const;

  /// Takes the state that all questions below are about, until it is changed.
  /// \param state  must outlive this object
  void look_at(const PatchState& state);

  const FrictionDisc& disc(Index cell) const { return discs_[static_cast<std::size_t>(cell)]; }

  /// The derivatives of the disc of a cell about which the slip turns.
  DiscGrowth growth(Index cell) const;

  /// The lateral slip of PatchResponse::pole() in a cell about which the slip turns, or next to one.
  double pole_slip(Index cell) const { return pole_slip_[cell]; }

 private:
  /// How much the cells around a cell slip, and how their directions differ.
  struct Ring {
    double slip;           ///< from 0 to 1
    Eigen::Vector2d mean;  ///< of directions
  };

  Ring ring_of(Index cell) const;
  Eigen::Matrix<double, 9, 2> slips_about(Index cell) const;

  const PatchResponse* response_;
  Eigen::VectorXd bounds_;  ///< the largest in the row of each cell, over G
  Index elements_;
  std::vector<bool> is_inner_;
  const PatchState* state_ = nullptr;
  std::vector<FrictionDisc> discs_;
  Eigen::Matrix2Xd directions_;  ///< of the slip at centres
  Eigen::VectorXd sizes_;        ///< of the same, more than 0
  Eigen::VectorXd parts_;        ///< of full slip, from 0 to 1; 0 of cells that stick
  Eigen::VectorXd pole_slip_;
};

}  // namespace microslip
