// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "microslip/support/archive.hpp"

namespace microslip {

/// The sum of all rigid slip since an origin of material at a place, x + q, in a row at y:
///   (along - turn y, across + turn place),
/// with q, the distance rolled since that origin.
struct RigidPath {
  double along = 0, across = 0, turn = 0;

  Eigen::Vector2d at(double place, double y) const {
    return {along - turn * y, across + turn * place};
  }

  /// \param length  that is rolled; 1 in a shift
  /// \param middle  of the distances rolled before and after it
  RigidPath after(const Eigen::Vector3d& motion, double length, double middle) const {
    return {along + motion[0] * length, across + (motion[1] - motion[2] * middle) * length,
            turn + motion[2] * length};
  }
};

/// The displacements that the material of a row remembers. A place of the material is its x at the
/// origin of the path, x + q after a distance q. There, the sum of its displacement and of all rigid slip
/// is constant while it sticks: that sum is what a record keeps, along and across.
class MaterialRecords {
 public:
  using Vector2d = Eigen::Vector2d;

  /// Remembers nothing but zero, from the place of the trailing edge to that of the leading one.
  /// \param least_spacing  of records of material that has entered
  MaterialRecords(double trailing, double leading, double least_spacing);

  /// The value at a place, by the cubic polynomial through the four records around it. Where the
  /// bodies were shifted as they hardly rolled, what has entered since then differs by a finite amount
  /// over next to no distance: the record at the edge has a part in the last interval alone then,
  /// which is linear.
  Vector2d at(double place) const;

  /// Records what enters at the leading edge, and forgets what is ahead of it. The edge of a contact
  /// that shrinks may go back.
  void enter(double place, const Vector2d& value);

  /// Forgets what has left, behind a place.
  void leave(double place);

  /// Changes what is remembered, record by record.
  void change(const std::function<void(double place, Vector2d& value)>& by);

  /// Forgets what is between two places.
  void forget(double from, double to);

  /// Whether no record is closer to a place than a distance.
  bool has_room(double place, double distance) const;

  /// Adds a record if there is room for it.
  void add(double place, const Vector2d& value, double distance);

  /// The same, where places move, too: `to` returns the new place, and keeps their order.
  void move(const std::function<double(double place, Vector2d& value)>& to);

  void archive(Archive& archive);

 private:
  struct Record {
    double place;
    Vector2d value;
  };
  std::vector<Record> records_;  ///< of rising places
  double least_spacing_;
};

}  // namespace microslip
