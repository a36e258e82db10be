// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "microslip/reference/kalker.hpp"

namespace microslip {

struct PatchState;
class UnitPatch;

/// Results are means of two solutions, on `cells` and on one cell more, as errors where contacts slip
/// alternate with the number of cells.
inline constexpr std::size_t grids_of_mean = 2;

/// The nodes of a table of creep forces.
///
/// A motion (xi, eta, phi c)/(mu p0/G) has the size r = |(kx xi, ky eta, kp phi c)|, with factors by
/// which forces grow with the motion, so that sliding begins at about r = 3 for all directions; and
/// t = r/(r + 1.5), from 0 at rest to 1 in full sliding. Its direction (xi/X, eta/E, phi c) has a
/// polar angle from pure spin, 0 ... 90 degrees, and an azimuth from pure lateral creepage, 0 ... 180
/// degrees. Other motions follow by symmetry. Definitions: docs/creep_tables.md.
struct CreepTableLayout {
  double poisson_ratio = 0.28;                   ///< nu, in [0, 0.5]
  double least_ratio = 0.1, largest_ratio = 10;  ///< a/b
  Eigen::Index ratios = 19;                      ///< nodes of ln(a/b), evenly spaced, >= 4
  Eigen::Index steps = 33;                       ///< nodes of t, evenly spaced, >= 4
  Eigen::Index polar = 25;                       ///< polar angles, closer near pure spin, >= 3
  Eigen::Index azimuths = 17;                    ///< azimuths, evenly spaced, >= 3
  /// Nodes are means of solutions on so many rows and elements of a circle, 4 ... 40, and on one more.
  Eigen::Index cells = 12;

  double ratio(Eigen::Index i) const;    ///< a/b
  double step(Eigen::Index i) const;     ///< t
  double angle(Eigen::Index j) const;    ///< polar angle  [rad]
  double azimuth(Eigen::Index k) const;  ///< [rad]

  /// The place of a value among the nodes, from 0 to one less than their number.
  double place_of_ratio(double ratio) const;
  double place_of_angle(double angle) const;
  double slope_of_place(double angle) const;  ///< of place_of_angle()

  std::size_t nodes() const;
};

/// \throws std::invalid_argument if a number is out of its range
void validate(const CreepTableLayout& layout);

/// Factors of a shape that make motions and their directions comparable.
struct MotionScales {
  Eigen::Vector3d sizes;       ///< kx, ky, kp
  Eigen::Vector3d directions;  ///< X, E, 1

  MotionScales(double ratio, const CreepCoefficients& coefficients);

  /// The motion of a direction in which r is 1.
  Eigen::Vector3d unit_motion(double angle, double azimuth) const;
};

/// r by which t is half.
inline constexpr double half_step_size = 1.5;

/// r of t, below 1.
double size_of_motion(double t);

/// Forces while all sticks, over mu F_n and mu F_n c, by the motion over mu p0/G.
Eigen::Matrix3d linear_creep_forces(const CreepCoefficients& coefficients);

/// Errors of a table, measured against solutions on more cells that had no part in it. Each has the
/// components of Fx and Fy over mu F_n, and Mz over mu F_n c.
struct CreepTableErrors {
  Eigen::Index states = 0;  ///< random motions and ratios; 0 if none were measured
  Eigen::Index cells = 0;   ///< rows and elements of a circle, on which they were solved
  Eigen::Vector3d rms = Eigen::Vector3d::Zero(), of_99_percent = rms, largest = rms;
};

/// Solutions at the nodes.
struct CreepTableNodes {
  CreepTableLayout layout;
  std::vector<CreepCoefficients> coefficients;  ///< by ratio
  /// Fx and Fy over mu F_n, Mz over mu F_n c: by ratio, step, polar angle, azimuth and component.
  std::vector<double> forces;
  CreepTableErrors errors = {};

  std::size_t at(Eigen::Index ratio, Eigen::Index step, Eigen::Index angle,
                 Eigen::Index azimuth) const;
};

/// Solves the nodes of a layout, ratio by ratio.
class CreepTableMaker {
 public:
  /// \throws as validate
  explicit CreepTableMaker(const CreepTableLayout& layout);

  /// A part of the work: one ratio and one polar angle. Parts are independent.
  std::size_t parts() const;

  /// The number of results of a part.
  std::size_t values_of(std::size_t part) const;

  /// The results of a part, by azimuth, step and component. Calls from several threads are fine. A
  /// motion that has no solution on one of the two grids is solved on two cells more.
  /// \throws NotConverged with the motion that has no solution
  std::vector<double> solve(std::size_t part) const;

  /// \param parts  as many as parts()
  CreepTableNodes joined(const std::vector<std::vector<double>>& parts) const;

 private:
  struct Shape;
  const UnitPatch& patch(std::size_t ratio, std::size_t grid) const;
  Eigen::Vector3d solve_on(std::size_t ratio, std::size_t grid, const Eigen::Vector3d& motion,
                           std::optional<PatchState>& state) const;

  CreepTableLayout layout_;
  std::vector<CreepCoefficients> coefficients_;
  std::shared_ptr<std::vector<Shape>> shapes_;
};

}  // namespace microslip
