// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// How the friction coefficient depends on the speed of slip |s V|, over that at rest: 1 at rest,
/// and from there down to the kinetic ratio. With k the kinetic ratio and h the half speed, at
/// which half of the fall is done:
/// - linear:       k + (1 - k) max(0, 1 - s/(2 h))
/// - exponential:  k + (1 - k) 2^(-s/h)
/// - rational:     k + (1 - k)/(1 + s/h)
/// - a table, linear between its rows, and constant behind the last one.
class FrictionLaw {
 public:
  enum class Form { linear, exponential, rational, table };

  /// \param form     but for the table
  /// \param kinetic  k = mu_k/mu_s, in [0, 1]  [1]
  /// \param half     h, in (0, inf)  [mm/s]
  /// \throws std::invalid_argument outside the ranges
  FrictionLaw(Form form, double kinetic, double half);

  /// \param speeds  of slip, rising from 0 on; at least two  [mm/s]
  /// \param ratios  mu/mu_s at these, 1 at first, in [0, 1]  [1]
  /// \throws std::invalid_argument outside the ranges
  FrictionLaw(const Eigen::VectorXd& speeds, const Eigen::VectorXd& ratios);

  /// mu/mu_s at a speed of slip in [0, inf]  [1]
  double operator()(double speed) const;

  /// The largest -d(mu/mu_s)/ds over all speeds  [s/mm]
  double steepest() const;

 private:
  Form form_;
  double kinetic_, half_;
  Eigen::VectorXd speeds_, ratios_;
};

/// Which of several solutions is taken: the one that is found from bodies that stick, or from
/// bodies that slide at any speed.
enum class SlipBranch { least, most };

/// Friction that depends on the speed of slip, of bodies that roll. Without a memory, the law holds
/// at once. With a memory of length d, the ratio r = mu/mu_s of a point of the material follows the
/// law as the point slips:
/// \f[ dr/dt = (law(|s_a|) - r) \max(|s_a|, s_0)/d \f]
/// with the speed of slip s_a = s V. Material comes into the contact with r = 1.
struct SlipFriction {
  FrictionLaw law;
  double speed;              ///< V of rolling, in (0, inf)  [mm/s]
  double memory_length = 0;  ///< d, in [0, inf); 0 for none  [mm]
  double memory_speed = 0;   ///< s_0, in [0, inf)  [mm/s]
  SlipBranch branch = SlipBranch::least;

  bool remembers() const { return memory_length > 0; }

  /// mu/mu_s of a point at the end of a time, in which it slips evenly.
  /// \param before    that at the beginning; not used without a memory
  /// \param distance  slipped, in [0, inf]  [mm]
  /// \param time      [s]
  double ratio_after(double before, double distance, double time) const;

  /// The same, with a memory, of a point whose speed of slip changes; exact if the law's ratio is
  /// linear in the way slipped.
  /// \param from, to  speeds of slip at the beginning and at the end, in [0, inf]  [mm/s]
  double ratio_after(double before, double from, double to, double time) const;
};

/// \throws std::invalid_argument outside the ranges
void validate(const SlipFriction& friction);

}  // namespace microslip
