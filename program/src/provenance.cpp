// SPDX-License-Identifier: GPL-3.0-or-later
#include "provenance.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "version.hpp"

namespace microslip::program {

namespace {

std::filesystem::path folder_of_executable() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

/// The revision lies among the shared files, not in the executable, so that a commit alone changes
/// no program and reruns no study.
std::string revision() {
  std::ifstream file(share_folder() / "revision.txt");
  std::string line;
  return std::getline(file, line) && !line.empty() ? line : "unknown";
}

}  // namespace

std::filesystem::path share_folder() {
  return folder_of_executable().parent_path() / "share/microslip";
}

std::string version_line(const std::string& program) {
  return fmt::format("{} (microslip) {}, revision {}", program, version, revision());
}

std::string provenance(const std::string& program, int argc, const char* const* argv,
                       std::chrono::duration<double> wall_time) {
  std::ostringstream text;
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  text << version_line(program) << "\ndate: " << std::put_time(&utc, "%F %T UTC") << "\ncommand:";
  for (int i = 0; i < argc; ++i) text << ' ' << std::quoted(argv[i], '\'');
  text << fmt::format(
      "\ncompiler: {}\nlibraries: Eigen {}.{}.{}, Boost {}, fmt {}.{}.{}\nwall time: {:.3g} s\n",
      __VERSION__, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, BOOST_LIB_VERSION,
      FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100, wall_time.count());
  return text.str();
}

}  // namespace microslip::program
