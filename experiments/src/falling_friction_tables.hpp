// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/experiments/falling_friction.hpp"

namespace microslip::experiments::falling_friction_study {

/// Differences of this size are rounding.
inline constexpr double up_to_rounding = 1e-7;

struct Tables {
  Table steady{
      "steady",
      "steady rolling against the number of elements",
      {{"memory", "mm", "length of the memory of friction"},
       {"elements", "1", "N"},
       {"force_ratio", "1", "force over full sliding at rest"},
       {"adhesion", "1", "part of the elements that stick"},
       {"second_solution", "1", "1 if fast slip leads to another solution"},
       {"difference", "1", "force from fast slip less that from adhesion, in size", up_to_rounding},
       {"error", "1", "force ratio less that of the largest N, in size"}}};
  Table curve{"curve",
              "steady force against the creepage",
              {{"speed", "mm/s", "of rolling"},
               {"creepage", "1", "size of w"},
               {"force_ratio", "1", "force over full sliding at rest"},
               {"second_solution", "1", "1 if fast slip leads to another solution"}}};
  Table steps{"steps",
              "single steps from steady rolling, after a small change of the creepage",
              {{"length", "mm", "dq"},
               {"branch", "1", "least: found from adhesion; most: from fast slip"},
               {"force_ratio", "1", "force over full sliding at rest"},
               {"fastest", "mm/s", "largest speed of slip"},
               {"second_solution", "1", "1 if both differ"}}};
  Table runs{"runs",
             "runs after steady rolling, by steps of several lengths",
             {{"memory", "mm", "length of the memory of friction"},
              {"branch", "1", "least or most"},
              {"step_ratio", "1", "c = dq/dx"},
              {"settled", "1", "1 if all steps have a solution"},
              {"force_ratio", "1", "force at the end over full sliding at rest"},
              {"mean_ratio", "1", "its mean over the second half"},
              {"swing", "1", "its largest less its least value in the second half"},
              {"doubled", "1", "part of the steps with a second solution"}}};
  Table limits{"limits",
               "unique solutions by linear theory, from steady rolling on",
               {{"memory", "mm", "length of the memory of friction; 0 for none"},
                {"limit", "mm", "shortest memory; without a memory, shortest step"},
                {"load", "1", "limit over memory: below 1 a short step has one solution"}}};
  Table tractions{"tractions",
                  "tractions in runs",
                  {{"memory", "mm", "length of the memory of friction"},
                   {"branch", "1", "least or most"},
                   {"step_ratio", "1", "c = dq/dx"},
                   {"x", "1", "position over the half-width"},
                   {"bound", "1", "bound over its peak at rest"},
                   {"traction", "1", "over the peak of the bound at rest"}}};
  Table contact{"contact",
                "CONTACT's example: its grid, and the bound by its way of solving the pressure",
                {{"state", "1", "steady, or a step from sticking or from sliding bodies"},
                 {"force_ratio", "1", "force over full sliding at rest"},
                 {"contact_ratio", "1", "the same, as CONTACT prints it"},
                 {"adhesion_elements", "1", "elements in adhesion"}}};
  Table ellipse{"ellipse",
                "runs of an ellipse after steady rolling, by steps of several lengths; forces are "
                "over full sliding at rest",
                {{"memory", "mm", "length of the memory of friction; 0 for none"},
                 {"step_ratio", "1", "c = dq/dx"},
                 {"settled", "1", "1 if all steps have a solution"},
                 {"steady_ratio", "1", "force of steady rolling"},
                 {"mean_ratio", "1", "mean force over the second half"},
                 {"swing", "1", "largest less least force in the second half"},
                 {"doubled", "1", "part of the steps with a second solution"}}};
};

Table claims_of(const FallingFrictionParameters& parameters, const Tables& tables);

}  // namespace microslip::experiments::falling_friction_study
