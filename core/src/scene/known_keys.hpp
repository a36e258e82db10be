// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "microslip/scene/scene.hpp"

namespace microslip {

/// \file
/// Values of the keys in keys_of_scenes(), with the words and the defaults that stand there.
/// \throws std::logic_error if the key is none of them, or has none

/// The first of the words if the key is not given and that is its default.
std::string known_word(Scene& scene, std::string_view key);

/// The default if the key is not given.
double known_number(Scene& scene, std::string_view key);

}  // namespace microslip
