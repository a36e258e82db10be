// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace microslip {

/// One part of a contact: y lies between two ends, and x between two edges, trailing and leading.
///
/// Places across are y = middle + height sin(psi). An end is closed, where the edges meet, or
/// straight, where they do not. The half-length is w(psi) A(psi), where w = cos(psi) between closed
/// ends, and 1 between straight ones: w is the square root of the distance to a closed end, and A is
/// constant for an ellipse.
class Lobe {
 public:
  /// A row in x, between its edges.
  struct Row {
    double middle, half_length;
  };

  static Lobe ellipse(double half_width, double lateral_half_width);

  /// Makes a lobe from the edges at some y, outermost ones at the ends. Between them, A and the
  /// middle of a row are monotone cubic functions of y (Fritsch and Carlson, 1980).
  /// \param y         rising, two or more, and three or more if both ends are closed
  /// \param trailing  as many as y
  /// \param leading   as many as y, above trailing; an end is closed where both are equal
  /// \throws std::invalid_argument outside the ranges; the message names the row, from 1 on
  Lobe(const Eigen::VectorXd& y, const Eigen::VectorXd& trailing, const Eigen::VectorXd& leading);

  double y(double psi) const;

  /// Inverse of y(), -+pi/2 beyond the ends.
  double psi(double y) const;

  Row row(double psi) const;

  double height() const { return height_; }  ///< half of the distance of the ends
  double low() const { return middle_ - height_; }
  double high() const { return middle_ + height_; }

  /// The integral of f(psi) dy over angles psi, by Gauss's points.
  double integral(double from, double to, const std::function<double(double)>& of) const;

  double area() const;

  /// The same lobe, with all lengths multiplied by a factor > 0.
  Lobe scaled(double factor) const;

  /// The lobe whose trailing edge leads, x' = -x.
  Lobe turned() const;

 private:
  Lobe() = default;
  double narrowing(double psi) const;  ///< w

  double middle_ = 0, height_ = 0, scale_ = 1;
  bool closed_low_ = true, closed_high_ = true;
  std::function<double(double)> middle_of_, widening_;  ///< of sin(psi); the latter is A
};

/// The shape of a contact: one lobe or several.
class PatchShape {
 public:
  /// \throws std::invalid_argument without lobes, and if two of them overlap
  explicit PatchShape(std::vector<Lobe> lobes);

  static PatchShape ellipse(double half_width, double lateral_half_width);

  const std::vector<Lobe>& lobes() const { return lobes_; }

  bool is_ellipse() const { return is_ellipse_; }

  /// Whether the shape is known to be its own mirror image across the rolling.
  bool is_mirrored() const { return is_ellipse_; }

  double area() const { return area_; }

  /// c = (area/pi)^(1/2); of an ellipse (a b)^(1/2).
  double size() const;

  /// Mean length along the rolling over that across it, a/b of an ellipse; of several lobes the mean
  /// by their areas.
  double ratio() const;

  /// Ends of the shape in x and in y.
  double trailing() const { return trailing_; }
  double leading() const { return leading_; }
  double low() const;
  double high() const;

  /// Half of the extent along the rolling and across it; a and b of an ellipse.
  double half_width() const { return (leading_ - trailing_) / 2; }
  double lateral_half_width() const { return (high() - low()) / 2; }

  PatchShape scaled(double factor) const;

  /// The shape whose trailing edges lead, x' = -x.
  PatchShape turned() const;

 private:
  std::vector<Lobe> lobes_;
  bool is_ellipse_ = false;
  double area_ = 0, trailing_ = 0, leading_ = 0;
};

/// The integral of f(lobe, psi, theta) over the area of a shape, x = middle + half-length
/// cos(theta). Errors are of the order 1e-12 for smooth functions.
double integral_over(const PatchShape& shape,
                     const std::function<double(std::size_t, double, double)>& of);

}  // namespace microslip
