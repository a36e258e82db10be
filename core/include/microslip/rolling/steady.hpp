// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "microslip/friction/active_set.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/rolling/contact.hpp"
#include "microslip/rolling/evidence.hpp"

namespace microslip {

/// The difference scheme of the thesis: collocation at the nodes, (3.5)-(3.8),
/// \f[ s_j = w + \frac{((A-A')\,p)_j}{c\,\Delta x} \f]
/// If the displacement u_LE at the leading edge is known, the last equation is
/// s_N = w + ((A p)_N - u_LE) / (leading_offset dx).
/// Accuracy: the force is first order in dx for offsets 1/2, because A' feels the leading edge
/// about 0.825 dx beyond the last node (constant functions, c = 1); 3/2 with u_LE known
/// (tests/order/carter_order_test.cpp).
struct Differences {
  double step_ratio = 1;  ///< c = dq/dx of the difference for du/dx, >= min_step_ratio  [1]
  /// u_LE, (10.6); needs a leading offset > 0  [mm]
  std::optional<double> edge_displacement = std::nullopt;
  /// Bounds are means over the elements, the outermost of which extend to the edges, so that they
  /// sum up to full sliding; or else values at the nodes.
  bool mean_bounds = false;
};

/// Differences over one element, with the edges where the scheme feels them: whole_contact().
struct Calibrated {};

/// Inversion, sampled at the nodes: ten digits for one stick zone, eight for several, and the
/// closed form of a brush. Elements that are graded towards steep places of a table, and towards
/// the ends of zones, replace it for other kernels, for tables of more than 400 rows, and where it
/// finds no zones; under smooth bounds Calibrated elements do. SteadySolution::scheme says which
/// one made the solution.
struct Inversion {};

/// ChebyshevRolling, sampled at the nodes: ten digits. For smooth bounds and one stick zone.
struct ChebyshevCollocation {};

using SteadyMethod = std::variant<Differences, Calibrated, Inversion, ChebyshevCollocation>;

/// Steady rolling in 2D: s = w - du/dx, thesis (3.2). For bodies of different material there may
/// be several zones, of both directions of slip. Inversion takes Hertz's bound alone, and is
/// replaced by Calibrated elements else; ChebyshevCollocation and a known u_LE are refused.
/// Accuracy then: by inversion 1e-8 of the creepage of free rolling without slip; by elements, with
/// beta/mu = 2.88, 5e-6 from N = 200 on, and where all sticks 3e-7 from N = 100 on
/// (tests/unit/unlike_bodies_test.cpp).
struct SteadyProblem {
  Contact contact;
  Grid grid;                       ///< on the same [-a, a] as the bound
  Basis basis = constant_basis();  ///< of elements: no part of inversion and collocation
  SteadyMethod method = Inversion{};
  Load load;
  Solver solver = {};
  Acceptance accepted = {};  ///< for require_evidence
  /// Friction that depends on slip: the contact's bound is that at rest. Inversion is replaced by
  /// Calibrated elements, on which forces are of first order then, with errors of 1e-3 of full sliding
  /// at N = 41 (study falling_friction).
  std::optional<SlipFriction> friction = std::nullopt;
};

/// \throws std::invalid_argument for a contact that is not valid, for bodies of different material
///         if the method does not take them, and for friction that depends on slip likewise
void validate(const SteadyProblem& problem);

/// Differences over one element, with mean bounds, and with the edges where the scheme feels them:
/// tractions that vanish like a square root at the leading edge do so calibrated_offset()
/// elements beyond the last node, and tractions at a trailing edge that sticks are singular half
/// an element less before the first.
/// Accuracy: within 1 % of force and creepage at N = 100 for any bound, kernel and load,
/// tests/property/generated_contacts_test.cpp; second order, with noise from stick-slip points
/// inside elements. The bound has no influence where it is not reached.
///
/// \return the problem with that grid and method
SteadyProblem whole_contact(const SteadyProblem& problem);

/// How a solution was made: by elements over the difference scheme of a grid, over the whole
/// contact, or graded; by inversion or collocation; or in the closed form of a brush.
enum class SteadyScheme { differences, calibrated, inversion, chebyshev, graded, closed_form };
std::string name_of(SteadyScheme scheme);

/// Values at the N nodes, and what follows from them. A positive creepage gives negative tractions.
struct SteadySolution {
  Eigen::VectorXd x;             ///< nodes of the grid, or of whole_contact()  [mm]
  Eigen::VectorXd bound;         ///< at the nodes, or its means if these are used  [N/mm^2]
  Eigen::VectorXd traction;      ///< coefficients of the basis  [N/mm^2]
  Eigen::VectorXd slip;          ///< relative slip s  [1]
  Eigen::VectorXd displacement;  ///< u by the tractions  [mm]
  std::vector<Zone> zones;
  double force;     ///< integral of the traction  [N/mm]
  double creepage;  ///< w  [1]
  /// -w F, energy per mm rolled and mm width: nothing is stored. For bodies of different material,
  /// whose pressure does work, too, -integral of p s  [N/mm]
  double dissipation;
  /// Partitions tried on this grid, or systems solved by Chebyshev collocation; 0 by inversion, the
  /// search of which ends at rounding and so takes more steps on one processor than on another.
  int iterations;
  Evidence evidence;
  double condition;  ///< estimate for the equations in adhesion, in the 1-norm; 1 if all slides
  /// The stick-slip point b, where a method finds it between nodes; a in full sliding  [mm]
  std::optional<double> stick_edge = std::nullopt;
  SteadyScheme scheme = SteadyScheme::differences;
  std::string fallback = "";  ///< why it is not the scheme asked for; empty if it is
  /// Whether a search from fast slip found another solution than one from adhesion, where friction
  /// depends on slip.
  bool has_second = false;

  Eigen::Index adhesion_elements() const;
  Eigen::Index slip_elements() const;
};

/// The creepage under a force, the force under a creepage.
double answer_of(const Load& load, const SteadySolution& solution);

/// The change of answer_of() from a coarse solution to a fine one, over the fine one's  [1]
double change_of_answer(const Load& load, const SteadySolution& coarse, const SteadySolution& fine);

/// Cost: O(N^2) memory; time as the method.
/// \throws std::invalid_argument for a step ratio or load outside its range, for a known u_LE at
///                               a leading offset of 0, for fewer than 11 elements where these must
///                               replace the inversion, and as the method
/// \throws NotConverged          as ActiveSet::solve or the method
SteadySolution solve_steady(const SteadyProblem& problem);

/// The solution by inversion, or the closed form of a brush.
/// \return none where elements have to replace it, and for bodies of different material
/// \throws std::invalid_argument as solve_steady
std::optional<SteadySolution> solve_by_inversion(const SteadyProblem& problem);

}  // namespace microslip
