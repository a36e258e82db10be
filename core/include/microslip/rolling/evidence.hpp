// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/linalg/solver.hpp"

namespace microslip {

/// Residuals of the contact conditions in a result. Forces and powers are integrals of the
/// tractions and slip in the tables, so that each one tells the share of the load that a violation
/// concerns. A power is the energy per mm rolled  [N/mm].
struct Evidence {
  double residual = 0;    ///< slip left in adhesion, over the largest term of the equations  [1]
  double excess = 0;      ///< force by which tractions exceed the bound  [N/mm]
  double backward = 0;    ///< power gained where slip has the direction of the traction  [N/mm]
  double unresolved = 0;  ///< difference between the force of slipping elements and the integral of
                          ///< the bound over these elements; and the force of elements in adhesion
                          ///< at places where a table is below their traction  [N/mm]
  double dissipated = 0;  ///< -integral of p s  [N/mm]
  double load = 0;        ///< |F|; for bodies of different material, the integral of |p|  [N/mm]
  double power = 0;       ///< |w F|, which equals the dissipation in steady rolling; in a
                          ///< transient, the larger of |w F| and the dissipation; for bodies of
                          ///< different material, the dissipation  [N/mm]
  double full_sliding = 0;  ///< the largest |F| that the bound allows  [N/mm]
  /// For bodies of different material: the force that the bound allows in zones of one element,
  /// over the rest of |F| to full sliding  [1]
  double one_element = 0;
  /// The relative change of the creepage, or of the force under a prescribed creepage, from
  /// elements that are twice as long; of tables of the bound  [1]
  double change = 0;

  // Violations relative to the load or to the power; 0 without a load.
  double bound_violation() const;    ///< excess over load  [1]
  double slip_violation() const;     ///< backward over power  [1]
  double bound_resolution() const;   ///< unresolved over load  [1]
  double dissipation_error() const;  ///< in a steady state: |dissipated - power| over power  [1]

  /// The larger one of bound_violation() and slip_violation().
  double violation() const;
};

/// The larger value of each member. Over several steps, violations are thus relative to the largest
/// load.
Evidence worst_of(const Evidence& a, const Evidence& b);

/// Values at nodes; each node stands for an element.
struct ElementValues {
  const Eigen::VectorXd& lengths;   ///< of the elements  [mm]
  const Eigen::VectorXd& bound;     ///< the bound in the contact conditions  [N/mm^2]
  const Eigen::VectorXd& means;     ///< element means of the bound  [N/mm^2]
  const Eigen::VectorXd& traction;  ///< [N/mm^2]
  const Eigen::VectorXd& slip;      ///< relative slip, zero in adhesion  [1]
};

/// Evidence of tractions on elements; the residual is left at 0. The function allocates nothing.
/// \param force     F  [N/mm]
/// \param creepage  w  [1]
Evidence evidence_by_elements(const ElementValues& values, double force, double creepage);

/// Evidence of tractions and slip that are functions of the position. Samples are taken at 5 points
/// in each of `parts` equal intervals of the contact, and at 200 points in each slip zone beside
/// the one stick zone.
/// \param stick_edge, stick_end  ends of the stick zone  [mm]
Evidence evidence_by_samples(const TractionBound& bound,
                             const std::function<double(double)>& traction,
                             const std::function<double(double)>& slip, double stick_edge,
                             double stick_end, Eigen::Index parts, double force, double creepage);

/// Limits that a result must keep.
struct Acceptance {
  /// Largest residual, relative to the largest term of the equations; by default Solver::tolerance.
  double residual = Solver{}.tolerance;

  /// Largest violation of the contact conditions, relative to the load, in (0, 1]. A violation
  /// above a tenth of this limit is doubtful.
  double violation = 0.05;

  /// Largest condition number, >= 1. The relative error due to rounding is up to 2e-16 times the
  /// condition number.
  double condition = 1e13;
};

/// \throws std::invalid_argument if a number is out of its range
void validate(const Acceptance& accepted);

/// \param condition   estimate, for the equations in adhesion  [1]
/// \param iterations  for the message
/// \throws NotConverged if the evidence is worse than accepted, or impossible; the message names
///                      the residual, its size and a remedy
void require_evidence(const Evidence& evidence, double condition, int iterations,
                      const Acceptance& accepted);

/// A sentence about a residual that is accepted but doubtful; none if no residual is.
/// \param steady  whether the power has to equal the dissipation
std::optional<std::string> doubt_of(const Evidence& evidence, const Acceptance& accepted,
                                    bool steady);

}  // namespace microslip
