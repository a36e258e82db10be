// SPDX-License-Identifier: GPL-3.0-or-later
#include "columns.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

/// The words of the next line that is neither empty nor a comment; none at the end.
std::vector<std::string> next_words(std::istream& in, int& line_number) {
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    if (line.starts_with('#')) continue;
    std::istringstream stream(line);
    std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    if (!words.empty()) return words;
  }
  return {};
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

/// The first name that stands twice; empty if none does.
std::string repeated(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto found = std::adjacent_find(names.begin(), names.end());
  return found == names.end() ? "" : *found;
}

}  // namespace

std::vector<Eigen::VectorXd> read_columns(std::istream& in, const std::vector<std::string>& names) {
  int line = 0;
  const auto fail = [&](const std::string& what) {
    throw std::invalid_argument("line " + std::to_string(line) + ": " + what);
  };
  const std::vector<std::string> header = next_words(in, line);
  if (header.empty()) throw std::invalid_argument("expected a line of column names, found none");
  std::vector<std::size_t> places;
  for (const std::string& name : names) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) {
      fail("expected a column '" + name +
           "' among the names in the first line, which are: " + shown(joined(header)));
    }
    places.push_back(static_cast<std::size_t>(found - header.begin()));
  }
  if (const std::string name = repeated(header); !name.empty()) {
    fail("expected one column '" + shown(name) + "', found more of that name");
  }
  std::vector<std::vector<double>> values(names.size());
  for (auto words = next_words(in, line); !words.empty(); words = next_words(in, line)) {
    if (words.size() != header.size()) {
      fail("expected " + std::to_string(header.size()) + " values, found " +
           std::to_string(words.size()));
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto value = finite_number(words[places[k]]);
      if (!value) {
        const std::string& word = words[places[k]];
        fail("column '" + names[k] + "': '" + shown(word) + "' is not a finite number" +
             advice(word));
      }
      values[k].push_back(*value);
    }
  }
  if (!names.empty() && values.front().empty()) fail("expected at least one row below the names");
  std::vector<Eigen::VectorXd> columns;
  for (const std::vector<double>& column : values) {
    columns.emplace_back(
        Eigen::Map<const Eigen::VectorXd>(column.data(), static_cast<Eigen::Index>(column.size())));
  }
  return columns;
}

}  // namespace microslip
