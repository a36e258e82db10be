// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "microslip/experiments/cattaneo_to_carter.hpp"

namespace microslip::experiments {

/// What becomes of the elements at the edges: see EdgeElements; and the grid of the contact.
inline constexpr std::array treatments = {"at_node", "cell_mean", "cut", "direct"};

/// The creepage over one element's travel.
struct Noise {
  int steps;         ///< in it: 1/c, rounded up
  double mean;       ///< [1]
  double deviation;  ///< standard deviation over the mean
  double largest;    ///< the largest deviation over an element's travel, of four or so elements
  double drift;      ///< change of the mean from the element's travel before, over the mean
  double noise;      ///< the deviation without the drift
  double adhesion;   ///< part of the contact in adhesion, at the end
};

/// Rolls from the shift and measures the last steps. Those before, up to four elements from the
/// end, are at least 0.1 dx long, which changes the deviation by less than 2e-4.
/// \param rolling     with a whole number of elements
/// \param distance    in elements, >= 4
/// \param step_ratio  c, in (0, 1]
Noise creepage_noise(const CattaneoToCarter& rolling, const std::string& treatment, double distance,
                     double step_ratio);

/// What `noise` of "at_node" is to be for small elements. Near the trailing edge the bound is
/// g = peak sqrt(2 x/a), so that the force of whole elements with the bound of their nodes differs
/// from that of the contact by sqrt(2/a) peak dx^(3/2) zeta(-1/2, t), where t dx is the distance
/// of the last node from the edge. The adhesion area must make up for it at once: the creepage is
/// its compliance to a force at the trailing edge, in plane strain and with adhesion up to the
/// leading edge, times the change of the force, over the step.
double predicted_noise(const CattaneoToCarter& rolling, const Noise& measured, double distance,
                       double step_ratio);

/// Tractions after rolling a whole number of elements, a value an element of the contact.
Eigen::VectorXd rolled_traction(const CattaneoToCarter& rolling, const std::string& treatment,
                                Eigen::Index distance, double step_ratio);

}  // namespace microslip::experiments
