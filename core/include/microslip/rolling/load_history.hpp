// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/rolling/contact_scale.hpp"

namespace microslip {

/// Rows of a measured or computed run; all given columns have the same number of entries. There is
/// either a distance or a time, and one of creepage, force and angular velocity.
struct RunRows {
  std::optional<Eigen::VectorXd> distance;          ///< q, where the bodies are  [mm]
  std::optional<Eigen::VectorXd> time;              ///< t, not descending  [s]
  std::optional<Eigen::VectorXd> velocity;          ///< v of either sign, with times  [mm/s]
  std::optional<Eigen::VectorXd> creepage;          ///< w  [1]
  std::optional<Eigen::VectorXd> force;             ///< F  [N/mm]
  std::optional<Eigen::VectorXd> angular_velocity;  ///< omega, with v and a radius  [rad/s]
  double radius = 0;                                ///< R > 0, with omega  [mm]

  // The contact: either a normal load, with Hertz's theory, or a half-width and the peak of the
  // bound. Friction combines with both, except for the peak.
  std::optional<Eigen::VectorXd> normal_load;    ///< P >= 0  [N/mm]
  std::optional<Eigen::VectorXd> half_width;     ///< a >= 0  [mm]
  std::optional<Eigen::VectorXd> peak_traction;  ///< >= 0  [N/mm^2]
  std::optional<Eigen::VectorXd> friction;       ///< mu >= 0  [1]
  bool point_contact = false;                    ///< whether Hertz's is that of a point, P in [N]

  /// The same quantities of the problem's contact, each > 0; a quantity without a column is
  /// ignored.
  struct Reference {
    double normal_load = 1;
    double half_width = 1;
    double peak_traction = 1;
    double friction = 1;
  } of_problem = {};

  /// Whether the force of the first row acts before it, too. Else bodies that stand there, as after a
  /// start at rest, are shifted to it.
  bool force_acts_before = true;

  /// Names of the columns in messages, of a component that is not along the rolling.
  std::string creepage_name = "creepage", force_name = "force";
};

/// A load that changes on the way. Velocities, creepage, force and the contact's columns are linear
/// between rows, in distance or in time, whichever the rows have. A creepage is the rigid shift over
/// the distance rolled, w = dS/dq; with omega it is w = (v - omega R)/v. Where the bodies roll back,
/// dq < 0.
///
/// Distances are counted along the way, from 0 at the first row on, and never fall. At some of them
/// the run stops: the bodies turn, or stand and are shifted against one another. A force or a contact
/// that is another one in the next row of the same place shifts them; so does omega where v is 0. A
/// creepage may jump.
class LoadHistory {
 public:
  /// A constant load.
  template <std::convertible_to<Load> OneLoad>
  LoadHistory(const OneLoad& constant) : constant_(constant) {}

  /// \throws std::invalid_argument for fewer than two rows, columns that exclude each other or
  ///         differ in length, numbers that are not finite, times that descend, and rows that
  ///         never roll. The message names the row, from 1, and the column
  explicit LoadHistory(const RunRows& rows);

  /// The distance from the first row to the last; infinite for a constant load  [mm]
  double distance() const;

  /// Distances of the rows, and of turns between them, from 0 on; none for a constant load  [mm]
  const std::vector<double>& distances() const { return distances_; }

  /// Distances of the rows alone  [mm]
  std::vector<double> row_distances() const;

  /// The creepage or the force of a row; a row in which the bodies stand has no creepage, but 0.
  Load of_row(std::size_t row) const;

  /// The load at a distance within the rows: the creepage or the force at that point, behind a jump;
  /// 0 where the bodies are shifted without rolling.
  /// \param distance  in [0, distance()]  [mm]
  Load at(double distance) const;

  /// Distances at which the bodies turn or are shifted, ascending; steps end there  [mm]
  const std::vector<double>& stops() const { return stops_; }

  /// A shift where the bodies stand, or a change of the contact.
  struct Standing {
    ShiftLoad load;              ///< the shift, or the force at its end
    ContactScale contact;        ///< at the end
    bool changes;                ///< whether load or contact are others than before
    std::optional<double> time;  ///< at the end, if the rows have times  [s]
  };

  /// Returns the shifts and changes from row to row at a distance, in turn.
  std::vector<Standing> standing_at(double distance) const;

  /// 1, or -1 where the bodies roll back: on the way to a distance.
  /// \param distance  in (0, distance()]  [mm]
  int direction_to(double distance) const;

  /// Where the bodies are at a distance: q, 0 at the first row  [mm]
  double position_at(double distance) const;

  /// Whether the rows have columns of the contact.
  bool changes_contact() const { return !(size_.empty() && load_.empty() && bound_.empty()); }

  /// The contact with which a distance is reached, and at 0 that of the first row; the problem's
  /// contact if the rows have none.
  ContactScale contact_at(double distance) const;

  /// The contact of a row.
  ContactScale contact_of_row(std::size_t row) const { return contact_in(of_rows_[row]); }

  /// The contacts of all rows, and of turns between them.
  std::vector<ContactScale> contacts() const;

  /// Distances at which a step has to end, ascending: the stops, and rows in which nothing is carried,
  /// because contact or friction is lost there  [mm]
  std::vector<double> ends_of_steps() const;

  /// The time at which a distance is reached, if the rows have times  [s]
  std::optional<double> time_at(double distance) const;

  /// The load of a step: the exact mean of the creepage over the step, or the force at the end of
  /// the step, before a jump. Cost: one binary search, and the rows within the step.
  /// \param from, to  distances from the first row, in [0, distance()], from < to, without a stop
  ///                  between them  [mm]
  Load between(double from, double to) const;

 private:
  /// A place: a row, and the time or distance since that row.
  struct Place {
    std::size_t row;
    double since;
  };

  Place place_of(double distance) const;
  Place place_before(double distance) const;
  Place place_in(std::size_t row, double distance) const;
  Standing standing_in(std::size_t row) const;
  ContactScale contact_in(std::size_t row) const;
  template <class Value>
  ContactScale contact_by(const Value& value) const;
  void take_way(const RunRows& rows);
  void take_load(const RunRows& rows);
  void find_stops();
  double between_rows(const std::vector<double>& column, const Place& at) const;
  void take_scales(const RunRows& rows);
  double shift_within(std::size_t row, double from, double to) const;

  std::optional<Load> constant_;
  std::vector<double> distances_;  ///< of the rows, and of turns
  std::vector<double> positions_;  ///< q there
  std::vector<int> direction_;     ///< from a row to the next: 1, -1, or 0 where the bodies stand
  std::vector<double> stops_;      ///< distances
  std::vector<std::size_t> of_rows_;  ///< the rows of the file among these
  std::size_t last_row_ = 0;          ///< the last one after which anything is rolled
  std::vector<double> lost_;          ///< distances of the rows in which nothing is carried
  std::vector<double> times_;         ///< of the rows, if they have times
  std::vector<double> lengths_;       ///< from a row to the next, in distance or time
  std::vector<double> speed_;         ///< of the distance: |v|, or 1
  std::vector<double> force_;
  double largest_force_ = 0;
  bool force_acts_before_ = true;           ///< as RunRows::force_acts_before
  std::vector<double> load_;                ///< normal load over the problem's
  std::vector<double> size_;                ///< half-width over the problem's
  std::vector<double> bound_;               ///< peak, or friction coefficient, over the problem's
  bool point_contact_ = false;              ///< as RunRows::point_contact
  std::vector<Eigen::Array3d> shift_rate_;  ///< coefficients of the shift's rate as a polynomial,
                                            ///< from each row on
};

}  // namespace microslip
