// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/scene/model.hpp"

namespace microslip {

/// A scene in words, without the values of its keys; one line each.
struct Explanation {
  std::string title;                      ///< "steady rolling to a prescribed force"
  std::vector<std::string> consequences;  ///< sizes and orders that follow from the keys
  std::vector<std::string> not_modelled;
};

Explanation explain(const Model& model);

}  // namespace microslip
