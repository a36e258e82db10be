// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "microslip/experiments/cattaneo_to_carter.hpp"

namespace microslip::experiments {

/// Treatments of the elements at the edges, see EdgeElements, and the grid of the contact.
inline constexpr std::array treatments = {"at_node", "cell_mean", "cut", "direct"};

/// The creepage over one element's travel.
struct Noise {
  int steps;         ///< number of steps: 1/c, rounded up
  double mean;       ///< [1]
  double deviation;  ///< standard deviation over the mean
  double largest;    ///< the largest deviation over one element's travel, among about four elements
  double drift;      ///< change of the mean from the previous element's travel, over the mean
  double noise;      ///< the deviation minus the contribution of the drift
  double adhesion;   ///< stick ratio at the end
};

/// Rolls from the shift and measures the last steps. Steps up to four elements before the end are
/// at least 0.1 dx long, which changes the deviation by less than 2e-4.
/// \param rolling     with a whole number of elements
/// \param distance    in elements, >= 4
/// \param step_ratio  c, in (0, 1]
Noise creepage_noise(const CattaneoToCarter& rolling, const std::string& treatment, double distance,
                     double step_ratio);

/// The theoretical `noise` of "at_node" for small elements. Near the trailing edge the bound is g =
/// peak sqrt(2 x/a), so that the force of whole elements with the bound at their nodes differs from
/// the force of the contact by sqrt(2/a) peak dx^(3/2) zeta(-1/2, t), where t dx is the distance of
/// the last node from the edge. The adhesion area must balance this difference at once. The
/// creepage due to it is the compliance of the adhesion area to a force at the trailing edge, in
/// plane strain and with adhesion up to the leading edge, times the change of the force, over the
/// step.
double predicted_noise(const CattaneoToCarter& rolling, const Noise& measured, double distance,
                       double step_ratio);

/// Tractions after rolling a whole number of elements, one value per element of the contact.
Eigen::VectorXd rolled_traction(const CattaneoToCarter& rolling, const std::string& treatment,
                                Eigen::Index distance, double step_ratio);

}  // namespace microslip::experiments
