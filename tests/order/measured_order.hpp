// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "microslip/support/convergence.hpp"

namespace microslip {

/// Appends a line to the file of the running test in the folder MICROSLIP_ORDERS, if there is such
/// a variable of the environment. The first line of a test replaces what the file had.
inline void keep_in_folder(const std::string& line) {
  const char* folder = std::getenv("MICROSLIP_ORDERS");
  if (folder == nullptr) return;
  static std::string running;
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string name = fmt::format("{}.{}", test.test_suite_name(), test.name());
  std::ranges::replace(name, '/', '_');
  std::filesystem::create_directories(folder);
  std::ofstream file(std::filesystem::path(folder) / name,
                     name == running ? std::ios::app : std::ios::trunc);
  file << line;
  running = name;
}

/// Prints a line for tools/accuracy.py, whether the test passes or not: `[   ORDER  ]`, the test's
/// name without its parameter, the problem, pairs of size and error, and the order. They are
/// separated by tabs.
/// \param problem  a row of the test's table in docs/accuracy.md
/// \param sizes, errors  as fitted_order() takes them
/// \return         the order through all of them
inline double measured_order(std::string_view problem, std::span<const double> sizes,
                             std::span<const double> errors) {
  const double order = fitted_order(sizes, errors);
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::string_view suite = test.test_suite_name(), name = test.name();
  // Without the prefix of the suite, and without the parameter.
  std::string line = fmt::format("[   ORDER  ]\t{}.{}\t{}", suite.substr(suite.find('/') + 1),
                                 name.substr(0, name.find('/')), problem);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    line += fmt::format("\t{:g}\t{:.2e}", sizes[i], std::abs(errors[i]));
  }
  line += fmt::format("\t{:.2f}\n", order);
  fmt::print("{}", line);
  keep_in_folder(line);
  return order;
}

}  // namespace microslip
