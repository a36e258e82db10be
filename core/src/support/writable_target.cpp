// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/writable_target.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "microslip/support/shown.hpp"

namespace microslip {

namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // as many as Linux follows

std::string reason_of(fs::file_type type) {
  if (type == fs::file_type::directory) return std::strerror(EISDIR);
  const char* kind = type == fs::file_type::character || type == fs::file_type::block ? "a device"
                     : type == fs::file_type::fifo                                    ? "a pipe"
                     : type == fs::file_type::socket                                  ? "a socket"
                                                     : "something else";
  return fmt::format("it is {}, expected a regular file", kind);
}

/// Follows links by their texts. The links of /proc have texts that are no paths.
fs::path followed(const fs::path& path) {
  fs::path at = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(at)); ++links) {
    if (links == most_links) throw NotWritable(path, std::strerror(ELOOP));
    at = at.parent_path() / fs::read_symlink(at);
  }
  return at;
}

}  // namespace

NotWritable::NotWritable(const fs::path& path, const std::string& reason)
    : std::invalid_argument(fmt::format("cannot write {}: {}", shown(path.string()), reason)),
      reason_(reason) {}

fs::path writable_target(const fs::path& path) {
  if (!path.has_filename()) throw NotWritable(path, "expected the name of a file");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const bool is_there = fs::exists(status);
  if (error && status.type() != fs::file_type::not_found) throw NotWritable(path, error.message());
  if (is_there && !fs::is_regular_file(status)) throw NotWritable(path, reason_of(status.type()));
  try {
    const fs::path target = followed(path);
    if (!target.has_filename()) throw NotWritable(path, std::strerror(EISDIR));
    // Another process may replace a file that is no link in the meantime.
    const bool is_link = target != path;
    if (is_link && is_there && !(fs::exists(target) && fs::equivalent(target, path))) {
      throw NotWritable(path, "its link leads to a file without a name");
    }
    return target;
  } catch (const fs::filesystem_error& failed) {
    throw NotWritable(path, failed.code().message());
  }
}

}  // namespace microslip
