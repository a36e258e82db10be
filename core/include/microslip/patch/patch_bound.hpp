// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "microslip/friction/elliptic_bound.hpp"
#include "microslip/patch/patch_shape.hpp"

namespace microslip {

struct PointRow;

/// A traction bound that is known at points of a shape.
///
/// Points of one y are a row. Within a row, and from row to row along lines of equal s = (x -
/// middle)/half-length, the **square** of the bound is linear; from the outermost points and rows it
/// is linear to zero at the edges and ends. So the bound vanishes there like a square root, as that
/// of smooth bodies does, unless points on an edge say otherwise.
class BoundTable {
 public:
  /// Whether a table has points of the value 0: no bound of a contact has them, and an estimate of what
  /// leaving them out changes keeps them.
  enum class Zeros { left_out, kept };

  /// \param x, y, values  coordinates [mm] and bounds >= 0 [N/mm^2], in any order; points outside the
  ///                      shape are left out, and so are those of the value 0 next to an edge
  /// \throws std::invalid_argument if a point is there twice, or 0 between others, and where a
  ///         lobe has less than three rows or no row with three points, or a third of its height
  ///         without a row; the message names the row, from 1 on, or the place
  BoundTable(const PatchShape& shape, const Eigen::VectorXd& x, const Eigen::VectorXd& y,
             const Eigen::VectorXd& values, Zeros zeros = Zeros::left_out);

  double operator()(const PatchShape& shape, std::size_t lobe, double psi, double theta) const;

  double peak() const { return peak_; }

  /// Points outside the shape, of a value above 0.
  Eigen::Index left_out() const { return left_out_; }

  /// The same table with every second row, and every second point of rows, for an estimate of the
  /// error; nullptr if there are too few.
  std::unique_ptr<BoundTable> half() const;

  /// The table on the turned shape.
  BoundTable turned() const;

 private:
  struct Row {
    double y;
    std::vector<double> places, squares;  ///< by s, rising from -1 to 1
  };
  using Rows = std::vector<Row>;

  BoundTable() = default;
  std::optional<Row> row_of(const PointRow& row, const Eigen::VectorXd& values, Zeros zeros);
  static double square_of(const Row& row, double s);

  std::vector<Rows> lobes_;
  double peak_ = 0;
  Eigen::Index left_out_ = 0;
};

/// A contact patch and its traction bound: an ellipse with Hertz's, or any shape.
class PatchBound {
 public:
  PatchBound(const EllipticBound& bound);

  /// Semi-ellipses in each row as high as the row is long, peak (a(y)^2 - (x - middle)^2)^(1/2) over
  /// the largest a(y): Hertz's bound on an ellipse, and that of Kik and Piotrowski (1996) otherwise.
  /// \param peak  > 0  [N/mm^2]
  PatchBound(const PatchShape& shape, double peak);

  PatchBound(const PatchShape& shape, const BoundTable& table);

  const PatchShape& shape() const { return shape_; }

  /// Whether it is Hertz's on an ellipse.
  bool is_hertz() const { return shape_.is_ellipse() && table_ == nullptr; }

  /// The bound at x = middle + half-length cos(theta) of the row psi of a lobe  [N/mm^2]
  double operator()(std::size_t lobe, double psi, double theta) const;

  double peak() const { return peak_; }            ///< [N/mm^2]
  double size() const { return shape_.size(); }    ///< c  [mm]
  double ratio() const { return shape_.ratio(); }  ///< of the shape  [1]
  double total() const { return total_; }          ///< the force of full sliding  [N]
  /// The moment if all turns about x = y = 0  [N mm]
  double turning_moment() const { return turning_moment_; }

  double half_width() const { return shape_.half_width(); }                  ///< [mm]
  double lateral_half_width() const { return shape_.lateral_half_width(); }  ///< [mm]

  /// The bound on the turned shape, g(-x, y).
  PatchBound turned() const;

 private:
  void integrate();

  PatchShape shape_;
  std::shared_ptr<const BoundTable> table_ = nullptr;
  double peak_, longest_ = 1, total_ = 0, turning_moment_ = 0;
};

}  // namespace microslip
