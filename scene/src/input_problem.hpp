// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "input_cases.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/patch/patch_load.hpp"

namespace microslip {

/// The contact of a case of CONTACT: Hertz's, of an ellipse, or of one row of elements.
struct InputContact {
  bool is_ellipse = true;
  Material material{};
  double friction = 0;
  double load = 0;            ///< [N]
  double half_width = 0;      ///< a  [mm]
  double lateral = 0;         ///< b; of a row half its width  [mm]
  double radius = 0;          ///< along the rolling; 0 if the case gives semi-axes  [mm]
  double lateral_radius = 0;  ///< the same across it, of an ellipse  [mm]
  double elements = 0;        ///< of CONTACT in 2 a, need not be whole
  double rows = 0;            ///< the same in 2 b
  bool fits = false;          ///< whether whole elements of CONTACT fill the box 2 a by 2 b
};

/// The problem of a case, or of the cases that a run of steps consists of, as a scene can say it.
struct InputProblem {
  enum class Kind { shift, steps, steady };

  Kind kind = Kind::steady;
  InputContact contact;
  std::vector<PatchLoad> shifts;  ///< of cases with T = 1; forces over mu FN
  PatchLoad load;                 ///< of steps or of steady rolling; forces over mu FN
  double step = 0;                ///< DQ, 0 in steady rolling by a solver that takes DX  [mm]
  int steps = 0;
  int first = 0, last = 0;  ///< numbers of the first and the last of its cases
  int line = 0;             ///< of the last one
  std::vector<std::string> notes;

  bool across() const;              ///< whether the row of elements is loaded across the rolling
  std::string description() const;  ///< as "steady rolling of an ellipse"
};

/// The problem of a case and of those before it that it continues.
/// \throws std::invalid_argument in one line with file, line, name and value and what is accepted
InputProblem problem_of_input(const std::vector<InputCase>& cases, std::size_t index,
                              const std::string& file, bool direct);

}  // namespace microslip
