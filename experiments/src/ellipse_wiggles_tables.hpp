// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/experiments/ellipse_wiggles.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments::ellipse_wiggles_study {

/// Names in the columns `scheme`.
inline constexpr const char* schemes =
    "remembered: joined rows; direct and relaxed, with c* = 1 or c: equal rectangles; contact: "
    "CONTACT's own results";

struct Tables {
  Table wiggles{
      "wiggles",
      "deviation of tractions and forces from the reference, which remembers on more cells",
      {{"load", "1", "creepage, held force: after a shift by 0.6 of full sliding; spin: from rest"},
       {"scheme", "1", schemes},
       {"step_ratio", "1", "c = dq/dx"},
       {"distance", "1", "q/a"},
       {"wave", "1",
        "largest wave from element to element in adhesion, (d- - 2 d + d+)/4 of the deviation d, "
        "over mu p0",
        1e-6},
       {"deviation", "1", "mean deviation in adhesion in the row at the centre, over mu p0", 1e-6},
       {"peak", "1", "largest traction in adhesion over that of the reference"},
       {"force", "1", "along, over full sliding; lateral force under spin"},
       {"force_error", "1", "its deviation", 1e-7},
       {"moment_error", "1", "of the moment, over full sliding times a", 1e-7},
       {"creepage", "1", "along, in the step that ends here"}}};
  Table dependence{
      "dependence",
      "largest differences from the shortest steps, over all longer ones",
      {{"load", "1", "as in wiggles"},
       {"scheme", "1", "remembered, direct or relaxed"},
       {"distance", "1", "q/a"},
       {"force", "1", "of a force over full sliding, or the moment over it and a", 1e-8},
       {"traction", "1", "root of the mean square over all cells, over mu p0", 1e-7},
       {"largest", "1", "largest one of a cell, over mu p0", 1e-7}}};
  Table tractions{"tractions",
                  "tractions of the row at the centre under a creepage after the shift",
                  {{"scheme", "1", "remembered, direct, relaxed or reference"},
                   {"step_ratio", "1", "c = dq/dx"},
                   {"x", "mm", "position"},
                   {"traction", "1", "-p_x over mu p0"},
                   {"bound", "1", "over mu p0"}}};
  Table creepages{"creepages",
                  "creepage under a held force, in the middle of each step",
                  {{"scheme", "1", "remembered, direct, relaxed or reference"},
                   {"step_ratio", "1", "c = dq/dx"},
                   {"q", "mm", "distance at the middle of the step"},
                   {"creepage", "1", "mean over the step"}}};
  Table noise{
      "noise",
      "noise of the creepage under a held force",
      {{"scheme", "1", "remembered, direct or relaxed"},
       {"step_ratio", "1", "c = dq/dx"},
       {"noise", "1",
        "root of the mean square of (w- - 2 w + w+)/4 over the mean creepage, from q = a/2 "
        "on",
        1e-7},
       {"settled_noise", "1", "the same from q = 2 a on, when the peak has left", 1e-7},
       {"error", "1", "root of the mean square of its deviation from the reference, over the mean",
        1e-7}}};
  Table map{"map",
            "tractions and slip under spin from rest, on joined rows",
            {{"distance", "1", "q/a"},
             {"x", "mm", "centre of a cell"},
             {"y", "mm", "the same"},
             {"x_low", "mm", "end of the cell, at y"},
             {"x_high", "mm", "the same"},
             {"y_low", "mm", "the same, across"},
             {"y_high", "mm", "the same"},
             {"p_x", "1", "traction along, over mu p0"},
             {"p_y", "1", "traction across, over mu p0"},
             {"part", "1", "size of the traction over the bound"},
             {"slips", "1", "1 if the cell slips"}}};
};

/// Judges the claims.
/// \param from_contact  largest difference of a traction of the standard scheme from CONTACT's
Table claims_of(const EllipseWigglesParameters& p, const Tables& tables, double from_contact);

}  // namespace microslip::experiments::ellipse_wiggles_study
