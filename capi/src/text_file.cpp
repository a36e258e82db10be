// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "microslip/support/shown.hpp"
#include "microslip/support/writable_target.hpp"

namespace microslip::capi {

namespace {

namespace fs = std::filesystem;

std::invalid_argument cannot_write(const std::string& path, const std::string& why) {
  return std::invalid_argument(fmt::format("path = '{}': cannot write it: {}", shown(path), why));
}

}  // namespace

fs::path target_of(const std::string& path) {
  try {
    return writable_target(path);
  } catch (const NotWritable& error) {
    throw cannot_write(path, error.reason());
  }
}

void write_text(const std::string& path, const std::string& text) {
  const fs::path target = target_of(path);
  const fs::path part =
      target.parent_path() /
      fmt::format(".{}.{}.part", target.filename().string(), std::random_device{}());
  std::error_code error, ignored;
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  if (out) {
    fs::rename(part, target, error);
  } else {
    error.assign(errno, std::generic_category());
  }
  if (!error) return;
  fs::remove(part, ignored);
  throw cannot_write(path, error.message());
}

}  // namespace microslip::capi
