// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/halfspace/kernel.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"
#include "microslip/support/progress.hpp"

namespace microslip::experiments {

/// Is the leading edge the cause of first-order convergence, and how much does a better treatment
/// gain? Thesis chapter 10 and appendix C, on the Carter-Fromm problem in plane strain with c = 1.
struct LeadingEdgeParameters {
  Material material;
  double length = 0;  ///< L0 of the plane kernel  [mm]
  HertzBound bound;
  std::vector<Eigen::Index> sizes{};       ///< N, each twice its predecessor, at least two
  std::vector<double> leading_offsets{};   ///< the thesis's alpha, each in (0, 1]  [dx]
  std::vector<double> trailing_offsets{};  ///< each in [0, 1]  [dx]
  std::vector<double> stick_ratios{};      ///< a', each in (0, 1)
  Eigen::Index profile_elements = 0;       ///< N of the tractions shown
  double profile_stick_ratio = 0;  ///< a' of the tractions shown, and of the thesis's numbers
  double profile_offset = 0;       ///< leading offset of the trimmed hat shown, thesis Fig. 10.3
};

/// The keys that `leading_edge --print-keys` lists, each checked against its listed range.
LeadingEdgeParameters read_leading_edge(Scene& scene);

/// Tables: errors (one row per scheme, offset, stick ratio and N), reductions (the factors per
/// doubling), summary (their distributions), settings (which settings come closest to the thesis's
/// numbers), profile (tractions, Figs. 10.1 and 10.3), hats (Fig. 10.2), claims.
std::vector<Table> leading_edge(const LeadingEdgeParameters& parameters, const Progress& progress);

}  // namespace microslip::experiments
