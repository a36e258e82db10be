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
/// tractions and slip that the tables hold, so that each tells which share of the load a violation
/// concerns. A power is the energy per mm rolled  [N/mm].
struct Evidence {
  double residual = 0;    ///< slip left in adhesion, over the largest term of its equations  [1]
  double excess = 0;      ///< force by which tractions exceed the bound  [N/mm]
  double backward = 0;    ///< power gained where slip has the direction of the traction  [N/mm]
  double unresolved = 0;  ///< by how much the force of slipping elements differs from the integral
                          ///< of the bound over them  [N/mm]
  double dissipated = 0;  ///< -integral of p s  [N/mm]
  double load = 0;        ///< |F|; of bodies of different material the integral of |p|  [N/mm]
  double power = 0;       ///< |w F|, which a steady contact dissipates; in a transient, or what it
                          ///< dissipates if that is more; of bodies of different material what they
                          ///< dissipate  [N/mm]
  double full_sliding = 0;  ///< the largest |F| that the bound allows  [N/mm]

  // Relative to the load or to its power; 0 without a load.
  double bound_violation() const;    ///< excess over load  [1]
  double slip_violation() const;     ///< backward over power  [1]
  double bound_resolution() const;   ///< unresolved over load  [1]
  double dissipation_error() const;  ///< of a steady state: |dissipated - power| over power  [1]

  /// The larger of the violations of bound and slip.
  double violation() const;
};

/// The largest of each member, so that over several steps violations are relative to the largest
/// load.
Evidence worst_of(const Evidence& a, const Evidence& b);

/// Values at nodes, each of which stands for an element.
struct ElementValues {
  const Eigen::VectorXd& lengths;   ///< of the elements  [mm]
  const Eigen::VectorXd& bound;     ///< that the tractions kept  [N/mm^2]
  const Eigen::VectorXd& means;     ///< of the bound, over the elements  [N/mm^2]
  const Eigen::VectorXd& traction;  ///< [N/mm^2]
  const Eigen::VectorXd& slip;      ///< relative slip, zero in adhesion  [1]
};

/// Evidence of tractions by elements; the residual is left at 0.
/// Allocates nothing.
/// \param force     F  [N/mm]
/// \param creepage  w  [1]
Evidence evidence_by_elements(const ElementValues& values, double force, double creepage);

/// Evidence of tractions and slip that are functions of the place, by 5 samples in each of n equal
/// parts of the contact, and in each of the slip zones beside the one stick zone by 200.
/// \param stick_edge, stick_end  where that begins and ends  [mm]
Evidence evidence_by_samples(const TractionBound& bound,
                             const std::function<double(double)>& traction,
                             const std::function<double(double)>& slip, double stick_edge,
                             double stick_end, Eigen::Index parts, double force, double creepage);

/// Limits that a result must keep.
struct Acceptance {
  /// Largest residual, relative to the largest term of the equations: Solver::tolerance.
  double residual = Solver{}.tolerance;

  /// Largest violation of the contact conditions, relative to the load, in (0, 1]; a tenth of it is
  /// doubtful.
  double violation = 0.05;

  /// Largest condition number, >= 1: rounding may cost up to 2e-16 times as much.
  double condition = 1e13;
};

/// \throws std::invalid_argument if a number is out of its range
void validate(const Acceptance& accepted);

/// \param condition   of the equations in adhesion, estimate  [1]
/// \param iterations  for the message
/// \throws NotConverged if the evidence is worse than accepted, or impossible; the message names the
///                      residual, its size, and a remedy
void require_evidence(const Evidence& evidence, double condition, int iterations,
                      const Acceptance& accepted);

/// A sentence about an accepted but doubtful residual, if there is one.
/// \param steady  whether power is that which is dissipated
std::optional<std::string> doubt_of(const Evidence& evidence, const Acceptance& accepted,
                                    bool steady);

}  // namespace microslip
