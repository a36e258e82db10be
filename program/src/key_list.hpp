// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "microslip/program/run.hpp"
#include "microslip/scene/keys.hpp"

namespace microslip::program {

/// Keys, each with its default as text, which may be empty.
using KeyList = std::vector<std::pair<Key, std::string>>;

/// Prints keys as text, as Markdown or man pages have them, or for completion: a line a key, with
/// its words behind it, a slash if it names a file, or =DEFAULT if it is a number.
/// \throws std::invalid_argument for another format
void print_keys(const KeyList& keys, const std::string& format);

/// Prints the keys that a study reads in its built-in scene, with the values there as defaults. In
/// Markdown, keys of scenes are only named.
void print_keys_of_study(const Program& study, const std::string& format);

}  // namespace microslip::program
