// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "microslip/scene/scene.hpp"

namespace microslip {

inline Scene scene_of(const std::string& text, const std::string& folder = "") {
  std::istringstream in(text);
  return Scene::parse(in, "test", folder);
}

/// The message of the exception that an action throws; empty if it throws none.
inline std::string message(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// The same in the keys of scenes, without places.
inline std::string message_in_keys(const std::function<void()>& action) {
  return message([&] {
    try {
      action();
    } catch (const BadParameter& error) {
      throw in_keys(error);
    }
  });
}

}  // namespace microslip
