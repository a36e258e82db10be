// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace microslip::capi {

/// The file that a writer of a path replaces, see writable_target().
/// \throws std::invalid_argument that names the path, as `path`
std::filesystem::path target_of(const std::string& path);

/// Writes a text under a temporary name, which is this process's own, and renames it: on a failure
/// what was there before stays, and nothing is left behind.
/// \throws std::invalid_argument that names the path
void write_text(const std::string& path, const std::string& text);

}  // namespace microslip::capi
