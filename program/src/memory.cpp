// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/program/memory.hpp"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip::program {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

double page() { return static_cast<double>(sysconf(_SC_PAGESIZE)); }

/// The memory that this process uses, as two limits count it  [bytes]
struct Usage {
  double addresses;  ///< of RLIMIT_AS
  double data;       ///< of RLIMIT_DATA
};

Usage usage() {
  std::ifstream in("/proc/self/statm");
  double total = 0, resident = 0, shared = 0, text = 0, unused = 0, data = 0;
  if (!(in >> total >> resident >> shared >> text >> unused >> data)) return {0, 0};
  return {total * page(), data * page()};
}

/// Without swapping, and with what the system can give back of its caches.
double available_on_machine() {
  std::ifstream in("/proc/meminfo");
  for (std::string name; in >> name;) {
    double kilobytes = 0;
    if (name == "MemAvailable:" && in >> kilobytes) return 1024 * kilobytes;
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * page();
}

double left_of(decltype(RLIMIT_AS) resource, double used) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

}  // namespace

double available_memory() {
  const Usage used = usage();
  return std::min({available_on_machine(), left_of(RLIMIT_AS, used.addresses),
                   left_of(RLIMIT_DATA, used.data)});
}

void require_memory(const std::string& key, Eigen::Index value, double bytes) {
  const double available = available_memory();
  if (bytes <= available) return;
  const auto [needed, left] = format_apart(bytes / 1e9, available / 1e9);
  throw BadParameter(key, fmt::format("{} = {}: would take about {} GB, and {} GB are available",
                                      key, value, needed, left));
}

void limit_memory() {
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  const double most = usage().data + available_on_machine();
  if (most >= static_cast<double>(limit.rlim_cur)) return;
  limit.rlim_cur = static_cast<rlim_t>(most);
  setrlimit(RLIMIT_DATA, &limit);  // if it fails, as without
}

}  // namespace microslip::program
