// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/friction/friction_law.hpp"
#include "microslip/patch/joined_rows.hpp"
#include "microslip/support/archive.hpp"

namespace microslip {

/// The ratios mu/mu_s of a friction that depends on the speed of slip, in the rows of a patch. With a
/// memory, points of the material remember them: they travel with the material, so that nothing is
/// smeared, and follow the law on their way. Material that enters has the ratio 1. Between points
/// ratios are linear, and so are speeds of slip between the centres of cells.
///
/// Lengths are over the size of the problem's patch, speeds are in mm/s.
class FrictionRows {
 public:
  using Index = Eigen::Index;
  using VectorXd = Eigen::VectorXd;

  /// \param size_of_patch  c  [mm]
  /// \param size           of the contact
  FrictionRows(const JoinedRows& rows, const SlipFriction& friction, double size_of_patch,
               double size = 1);

  /// \param speed  V of the next steps, > 0  [mm/s]
  void set_speed(double speed) { friction_.speed = speed; }
  const SlipFriction& friction() const { return friction_; }

  /// Computes the ratios of cells at the end of a step, by their speeds of slip.
  /// \param dq  infinity for steady rolling
  void follow(double dq, const VectorXd& speeds, VectorXd& ratios) const;

  /// The same from the present speeds on, for a step that is taken.
  void take(double dq, const VectorXd& speeds);

  double size() const { return size_; }  ///< of the contact

  /// The ratios of cells at the end of the last step; 1 before it.
  const VectorXd& ratios() const { return ratios_; }

  /// Takes over what is remembered by rows that lie where those of a contact of another size do.
  void resize(double size);

  void archive(Archive& archive);

 private:
  struct Point {
    double x, ratio;
  };
  using Points = std::vector<Point>;  ///< of a row, from its trailing edge on

  Points new_row(Index k) const;
  double edge(Index k) const { return size_ * rows_->x(0, k); }
  double centre(Index i, Index k) const { return size_ * rows_->x(2 * i + 1, k); }
  double speed_at(double x, Index k, const VectorXd& speeds) const;
  double after_way(double from, double to, Index k, const VectorXd& speeds, double ratio) const;
  double after_step(double x, double dq, Index k, const VectorXd& speeds) const;
  Points moved(const Points& points, Index k, double dq, const VectorXd& speeds) const;

  const JoinedRows* rows_;
  SlipFriction friction_;
  double unit_, size_;
  std::vector<Points> points_;  ///< with a memory
  VectorXd ratios_;
};

}  // namespace microslip
