// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/rolling/contact_scale.hpp"

namespace microslip {

/// Rows of a measured or computed run; all columns that are given have as many entries. There is a
/// distance or a time, not both, and one of creepage, force and angular velocity.
struct RunRows {
  std::optional<Eigen::VectorXd> distance;          ///< q, ascending  [mm]
  std::optional<Eigen::VectorXd> time;              ///< t, ascending  [s]
  std::optional<Eigen::VectorXd> velocity;          ///< v > 0, with times  [mm/s]
  std::optional<Eigen::VectorXd> creepage;          ///< w  [1]
  std::optional<Eigen::VectorXd> force;             ///< F  [N/mm]
  std::optional<Eigen::VectorXd> angular_velocity;  ///< omega, with v and a radius  [1/s]
  double radius = 0;                                ///< R > 0, with omega  [mm]

  // The contact: by Hertz's theory under a normal load, or by its half-width and the peak of its
  // bound; friction goes with either, except for the peak.
  std::optional<Eigen::VectorXd> normal_load;    ///< P >= 0  [N/mm]
  std::optional<Eigen::VectorXd> half_width;     ///< a >= 0  [mm]
  std::optional<Eigen::VectorXd> peak_traction;  ///< >= 0  [N/mm^2]
  std::optional<Eigen::VectorXd> friction;       ///< mu >= 0  [1]

  /// These of the problem's contact, each > 0; what has no column does not matter.
  struct Reference {
    double normal_load = 1;
    double half_width = 1;
    double peak_traction = 1;
    double friction = 1;
  } of_problem = {};
};

/// A load that changes on the way: velocities, creepage, force, and what there is of the contact,
/// are linear between rows, in distance or in time as the rows have it. With omega the creepage is
/// w = (v - omega R)/v.
class LoadHistory {
 public:
  /// One load for good.
  template <std::convertible_to<Load> OneLoad>
  LoadHistory(const OneLoad& constant) : constant_(constant) {}

  /// \throws std::invalid_argument for fewer than two rows, columns that do not go together or have
  ///         other numbers of rows, numbers that are not finite, rows that do not ascend and v <=
  ///         0. The message names row, from 1, and column
  explicit LoadHistory(const RunRows& rows);

  /// The distance from the first row to the last; infinite of one load  [mm]
  double distance() const;

  /// Distances of the rows, from 0 on; none if there is one load  [mm]
  const std::vector<double>& distances() const { return distances_; }

  /// The load at a distance within the rows: of the creepage, its value there.
  /// \param distance  in [0, distance()]  [mm]
  Load at(double distance) const;

  /// Whether the rows have a contact.
  bool changes_contact() const { return !(size_.empty() && load_.empty() && bound_.empty()); }

  /// The contact at a distance within the rows; that of the problem if they have none.
  ContactScale contact_at(double distance) const;

  /// The time at a distance, if the rows have times  [s]
  std::optional<double> time_at(double distance) const;

  /// The load of a step: the mean of the creepage over it, exact; or the force at its end. Cost:
  /// one binary search, and the rows within the step.
  /// \param from, to  distances from the first row, in [0, distance()], from < to  [mm]
  Load between(double from, double to) const;

 private:
  /// A place: a row, and time or distance since then.
  struct Place {
    std::size_t row;
    double since;
  };

  Place place_of(double distance) const;
  double between_rows(const std::vector<double>& column, const Place& at) const;
  void take_contact(const RunRows& rows);
  double force_at(double distance) const;
  double shift_within(std::size_t row, double from, double to) const;

  std::optional<Load> constant_;
  std::vector<double> distances_;  ///< of the rows
  std::vector<double> times_;      ///< likewise, if they have any
  std::vector<double> lengths_;    ///< from a row to the next, in distance or time
  std::vector<double> speed_;      ///< of the distance: v, or 1
  std::vector<double> force_;
  std::vector<double> load_;                ///< normal, over that of the problem's contact
  std::vector<double> size_;                ///< half-width likewise
  std::vector<double> bound_;               ///< peak, or friction coefficient, likewise
  std::vector<Eigen::Array3d> shift_rate_;  ///< coefficients of its polynomial from each row on
};

}  // namespace microslip
