// SPDX-License-Identifier: GPL-3.0-or-later
#include "info.hpp"

#include <algorithm>
#include <boost/property_tree/info_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/units.hpp"
#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

using Tree = boost::property_tree::ptree;
using Store = std::function<bool(const std::string&, const std::string&)>;

constexpr const char* blanks = " \t\v\f\r";

/// Trees are taken down recursively.
constexpr std::ptrdiff_t most_sections = 1000;

/// Rejects what Boost's reader of INFO would take: files that are included, and nesting of any
/// depth. In INFO, whatever begins with # is a directive.
void require_plain(const std::string& line, int number) {
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == std::string::npos || line[first] != '#') return;
  throw std::invalid_argument("line " + std::to_string(number) + ": '" + shown(line.substr(first)) +
                              "': expected ; before comments, and no other files");
}

/// A word of a line, or a string in quotes.
struct Token {
  std::size_t begin;
  std::size_t end;
};

/// Up to a comment, or a string that ends in another line.
std::vector<Token> tokens_of(const std::string& line) {
  std::vector<Token> tokens;
  std::size_t at = line.find_first_not_of(blanks);
  while (at != std::string::npos && line[at] != ';') {
    std::size_t end = at + 1;
    if (line[at] == '"') {
      while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2 : 1;
      if (end >= line.size()) break;
      ++end;
    } else {
      end = std::min(line.size(), line.find_first_of(std::string(blanks) + ';', at));
    }
    tokens.push_back({at, end});
    at = line.find_first_not_of(blanks, end);
  }
  return tokens;
}

/// How many of the words after a number are its unit; one that is alone is meant as one.
std::size_t words_of_unit(const std::string& line, const std::vector<Token>& tokens,
                          std::size_t first) {
  std::size_t end = first;
  while (end < tokens.size() &&
         std::string("{}\"").find(line[tokens[end].begin]) == std::string::npos) {
    ++end;
  }
  for (std::size_t count = end - first; count > 0; --count) {
    const std::size_t begin = tokens[first].begin;
    if (is_unit(line.substr(begin, tokens[first + count - 1].end - begin))) return count;
  }
  return end - first == 1 ? 1 : 0;
}

/// `half_width 1 mm` as `half_width "1 mm"`: in INFO, the next word would be the next key.
std::string with_quoted_units(const std::string& line) {
  const std::vector<Token> tokens = tokens_of(line);
  std::string quoted;
  std::size_t done = 0;
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    const auto [begin, end] = tokens[i];
    if (!finite_number(std::string_view(line).substr(begin, end - begin))) continue;
    const std::size_t words = words_of_unit(line, tokens, i + 1);
    if (words == 0) continue;
    i += words;
    quoted +=
        line.substr(done, begin - done) + '"' + line.substr(begin, tokens[i].end - begin) + '"';
    done = tokens[i].end;
  }
  return quoted + line.substr(done);
}

void flatten(const Tree& tree, const std::string& prefix, const Store& store) {
  for (const auto& [name, child] : tree) {
    const std::string key = prefix + name;
    require_short(key);
    if (!child.data().empty() && !child.empty()) {
      throw std::invalid_argument("key '" + shown(key) + "' has both a value and keys below it");
    }
    if (!child.empty()) {
      flatten(child, key + ".", store);
    } else if (!store(key, child.data())) {
      throw std::invalid_argument("key '" + shown(key) + "' is given twice");
    }
  }
}

Tree tree_of(const std::string& text) {
  std::istringstream lines(text);
  std::string plain;
  int number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    require_plain(line, number);
    plain += with_quoted_units(line);
    if (!lines.eof()) plain += '\n';
  }
  Tree tree;
  std::istringstream in(plain);
  boost::property_tree::read_info(in, tree);
  return tree;
}

}  // namespace

void require_short(const std::string& key) {
  if (key.size() <= longest_key) return;
  throw std::invalid_argument("key '" + shown(key) + "': expected at most " +
                              std::to_string(longest_key) + " characters");
}

void read_info(const std::string& text, const Store& store) {
  if (text.size() > Scene::most_text) {
    throw std::invalid_argument("expected at most " + std::to_string(Scene::most_text) + " bytes");
  }
  if (std::count(text.begin(), text.end(), '{') > most_sections) {
    throw std::invalid_argument("expected at most " + std::to_string(most_sections) +
                                " sections, { ... }");
  }
  try {
    flatten(tree_of(text), "", store);
  } catch (const boost::property_tree::info_parser_error& error) {
    throw std::invalid_argument("line " + std::to_string(error.line()) + ": " + error.message());
  }
}

}  // namespace microslip
