// SPDX-License-Identifier: GPL-3.0-or-later
#include "provenance.hpp"

#include <fftw3.h>
#include <fmt/core.h>
#include <gnu/libc-version.h>
#include <gsl/gsl_version.h>
#include <sys/resource.h>

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

std::string libraries() {
  return fmt::format("Eigen {}.{}.{}, Boost {}, fmt {}.{}.{}, {}, GSL {}, C library {}",
                     EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
                     BOOST_LIB_VERSION, FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                     FMT_VERSION % 100, fftw_version, gsl_version, gnu_get_libc_version());
}

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

/// The most memory that this process has had  [bytes]
double peak_memory() {
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024.0 * static_cast<double>(usage.ru_maxrss) : 0;
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
      "\ncompiler: {}\nlibraries: {}\nprocessor: {}\nwall time: {:.3g} s\npeak memory: {:.3g} MB\n",
      compiler, libraries(), processor(), wall_time.count(), peak_memory() / 1e6);
  return text.str();
}

}  // namespace microslip::program
