// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace microslip {

/// A path that no file can be written to. The message is "cannot write <path>: <reason>".
class NotWritable : public std::invalid_argument {
 public:
  NotWritable(const std::filesystem::path& path, const std::string& reason);

  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

/// Gives the path of the file itself, for a writer that renames a finished file over it. Symbolic
/// links are followed, so that the link stays, and its file is replaced. A link to a file that is
/// not there yet gives the path of that file. Nothing is written, and permissions are not looked
/// at.
/// \throws NotWritable for a path without a name of a file, for a loop of links, and for whatever
///                     exists and is no regular file: a folder, a device, a pipe, a socket
std::filesystem::path writable_target(const std::filesystem::path& path);

}  // namespace microslip
