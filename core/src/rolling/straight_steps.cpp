// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/straight_steps.hpp"

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

namespace microslip {

using Eigen::Array3d;

namespace {

/// Largest number of halvings of a piece of a row; the square root of the normal load is steep at
/// 0.
constexpr int most_halvings = 40;

/// Relative rounding error of lengths.
constexpr double rounding_of_length = 1e-9;

/// The load at a distance: the shift so far or the force, half-width and bound, each over half its
/// tolerance. The other half of the tolerance is left for the load between samples.
struct Sample {
  double distance;  ///< [mm]
  Array3d load;
};

class LoadPath {
 public:
  LoadPath(const LoadHistory& loads, const LoadTolerance& tolerance)
      : loads_(loads),
        under_force_(Prescribed(loads.at(0)).by_force),
        scale_(2 / (under_force_ ? tolerance.force : tolerance.shift), 2 / tolerance.contact,
               2 / tolerance.contact) {}

  Sample start() const {
    const ContactScale contact = loads_.contact_at(0);
    return {0, scale_ * Array3d(under_force_ ? force_at(0) : 0, contact.half_width, contact.bound)};
  }

  /// \param before  a sample at a distance below this one
  Sample after(const Sample& before, double distance) const {
    const ContactScale contact = loads_.contact_at(distance);
    const double path = under_force_
                            ? scale_[0] * force_at(distance)
                            : before.load[0] + scale_[0] * shift(before.distance, distance);
    return {distance, {path, scale_[1] * contact.half_width, scale_[2] * contact.bound}};
  }

 private:
  double force_at(double distance) const {
    return std::get<PrescribedForce>(loads_.at(distance)).value;
  }
  double shift(double from, double to) const {
    return (to - from) * std::get<PrescribedCreepage>(loads_.between(from, to)).value;
  }

  const LoadHistory& loads_;
  bool under_force_;
  Array3d scale_;
};

/// Makes steps from the samples in turn, like the swinging-door compression of measured data: a
/// line from the end of the last step has a slope with which it passes each later sample within 1.
class Steps {
 public:
  Steps(const Sample& start, double longest, std::size_t most)
      : longest_(longest), most_steps_(most), begin_(start), last_(start) {}

  bool are_too_many() const { return lengths_.size() > most_steps_; }

  void take(const Sample& next) {
    if (last_.distance > begin_.distance && !reaches(next)) end();
    const double length = next.distance - begin_.distance;
    least_ = least_.max((next.load - begin_.load - 1) / length);
    most_ = most_.min((next.load - begin_.load + 1) / length);
    last_ = next;
  }

  std::vector<double> lengths() && {
    end();
    return std::move(lengths_);
  }

 private:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  bool reaches(const Sample& next) const {
    const double length = next.distance - begin_.distance;
    const Array3d slope = (next.load - begin_.load) / length;
    return length <= (1 + rounding_of_length) * longest_ && (slope >= least_).all() &&
           (slope <= most_).all();
  }

  void end() {
    lengths_.push_back(last_.distance - begin_.distance);
    begin_ = last_;
    least_.setConstant(-unlimited);
    most_.setConstant(unlimited);
  }

  double longest_;
  std::size_t most_steps_;
  Sample begin_, last_;
  Array3d least_ = Array3d::Constant(-unlimited), most_ = Array3d::Constant(unlimited);
  std::vector<double> lengths_;
};

/// Takes samples up to `to`, between which the load is straight within 1.
void sample(const LoadPath& path, const Sample& from, const Sample& to, double longest,
            int halvings, Steps& steps) {
  const double length = to.distance - from.distance;
  const Sample middle = path.after(from, from.distance + length / 2);
  const auto bend_at = [&](const Sample& inside) {
    const double part = (inside.distance - from.distance) / length;
    return (inside.load - from.load - part * (to.load - from.load)).abs().maxCoeff();
  };
  const bool is_straight = bend_at(middle) <= 1 &&
                           bend_at(path.after(from, from.distance + length / 4)) <= 1 &&
                           bend_at(path.after(middle, from.distance + length * 3 / 4)) <= 1;
  const bool is_short = length <= (1 + rounding_of_length) * longest;
  const bool has_middle = from.distance < middle.distance && middle.distance < to.distance;
  if ((is_straight && is_short) || !has_middle || halvings == most_halvings) return steps.take(to);
  sample(path, from, middle, longest, halvings + 1, steps);
  if (!steps.are_too_many()) sample(path, middle, to, longest, halvings + 1, steps);
}

}  // namespace

std::optional<std::vector<double>> straight_steps(const LoadHistory& loads,
                                                  const LoadTolerance& tolerance, double longest,
                                                  std::size_t most) {
  const LoadPath path(loads, tolerance);
  Sample before = path.start();
  Steps steps(before, longest, most);
  for (const double distance : loads.distances()) {
    if (distance <= before.distance) continue;
    const Sample next = path.after(before, distance);
    sample(path, before, next, longest, 0, steps);
    if (steps.are_too_many()) return std::nullopt;
    before = next;
  }
  return std::move(steps).lengths();
}

}  // namespace microslip
