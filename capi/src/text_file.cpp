// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_file.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "microslip/support/shown.hpp"

namespace microslip::capi {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = std::size_t{1} << 30;

std::invalid_argument failed(const std::string& path, const std::string& doing,
                             const std::string& why) {
  return std::invalid_argument("path = '" + shown(path) + "': cannot " + doing + " it: " + why);
}

}  // namespace

void write_text(const std::string& path, const std::string& text) {
  const fs::path target(path);
  if (!target.has_filename()) throw failed(path, "write", "expected the name of a file");
  if (fs::is_directory(target)) throw failed(path, "write", std::strerror(EISDIR));
  const std::string own = "." + std::to_string(std::random_device{}()) + ".part";
  const fs::path part = target.parent_path() / ("." + target.filename().string() + own);
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
  throw failed(path, "write", error.message());
}

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  for (std::array<char, 1 << 16> part; in.read(part.data(), part.size()) || in.gcount() > 0;) {
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > most_bytes) throw failed(path, "read", "expected at most 1 GB");
  }
  if (in.bad() || !in.is_open()) throw failed(path, "read", std::strerror(errno));
  return text;
}

}  // namespace microslip::capi
