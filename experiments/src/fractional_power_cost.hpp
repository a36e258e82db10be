// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "microslip/experiments/fractional_power.hpp"

namespace microslip::experiments {

/// Limit below which the residual of a Schur method, and its difference to the action, are rounding
/// errors  [1].
inline constexpr double agreement_rounding = 1e-9;

/// Tables of the study fractional_power about the spectrum of C = A^-1 A*, the agreement of its
/// power with a Schur method, and what both cost.
struct CostTables {
  Table eigenvalues{
      "eigenvalues",
      "eigenvalues of C = A^-1 A* for an odd and an even number of elements",
      {{"elements", "1", "N"},
       {"real", "1", "real part"},
       {"imaginary", "1", "imaginary part"},
       {"negative", "1", "1 if on the negative real axis, where powers turn complex"}}};
  Table agreement{
      "agreement",
      "the action of C^c on a unit pulse at the leading edge against a Schur method",
      {{"elements", "1", "N"},
       {"step_ratio", "1", "c"},
       {"negative_eigenvalue", "1", "1 if there is one: N even"},
       {"schur_residual", "1", "largest entry of |C^c C^(1-c) - C|, over the largest of |C|",
        agreement_rounding},
       {"difference", "1", "largest one, over the largest value; nan if N is even",
        agreement_rounding}}};
  Table cost{"cost",
             "work of one step, counted: solves with C + t I, each of O(N)",
             {{"elements", "1", "N"}, {"solves", "1", "number of solves"}}};
  Table timing{"cost_timing",
               "time of one step, measured: least of a few repeats",
               {{"elements", "1", "N"},
                {"setup", "s", "outflow by Durbin's recursion"},
                {"action", "s", "C^c p by shifted solves"},
                {"product", "s", "(A - A') p as a dense product, what a direct step needs"},
                {"schur", "s", "C^c by a Schur method; nan above cost.largest_schur"}}};
};

CostTables measure_cost(const FractionalPowerParameters& parameters);

}  // namespace microslip::experiments
