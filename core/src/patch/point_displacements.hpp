// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "microslip/patch/joined_rows.hpp"
#include "microslip/patch/patch_response.hpp"

namespace microslip {

/// The displacements by tractions at the points of rows, each computed when it is asked for, once.
class PointDisplacements {
 public:
  using Index = Eigen::Index;
  using Vector2d = Eigen::Vector2d;

  /// \param by_traction  as displacement_by_traction(); both must outlive this object
  PointDisplacements(const JoinedRows& rows, const PatchResponse::Matrix& by_traction)
      : rows_(&rows), by_traction_(&by_traction), known_(static_cast<std::size_t>(rows.points())) {}

  const JoinedRows& rows() const { return *rows_; }

  /// Sets the tractions, which must outlive their use, and a factor on the displacements.
  void set(const Eigen::VectorXd& unknowns, double factor);

  Vector2d at(Index j, Index k);

  /// At an angle of a row, by the cubic through four points.
  Vector2d at_angle(double theta, Index k);

 private:
  struct Known {
    bool is_known = false;
    Vector2d value = {};
  };

  const JoinedRows* rows_;
  const PatchResponse::Matrix* by_traction_;
  const Eigen::VectorXd* unknowns_ = nullptr;
  double factor_ = 1;
  std::vector<Known> known_;
};

}  // namespace microslip
