// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/scene.hpp"

#include <algorithm>
#include <boost/property_tree/info_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <cmath>
#include <iterator>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "columns.hpp"
#include "microslip/scene/text.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

using Tree = boost::property_tree::ptree;

/// Of characters; the names of sections before it are part of a key.
constexpr std::size_t longest_key = 200;

/// Trees are taken down recursively.
constexpr std::ptrdiff_t most_sections = 1000;

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

void require_short(const std::string& key) {
  if (key.size() <= longest_key) return;
  throw std::invalid_argument("key '" + shown(key) + "': expected at most " +
                              std::to_string(longest_key) + " characters");
}

/// Rejects what Boost's reader of INFO would take: files that are included, and nesting of any
/// depth. In INFO, whatever begins with # is a directive.
void require_plain_info(const std::string& text) {
  if (text.size() > Scene::most_text) {
    throw std::invalid_argument("expected at most " + std::to_string(Scene::most_text) + " bytes");
  }
  if (std::count(text.begin(), text.end(), '{') > most_sections) {
    throw std::invalid_argument("expected at most " + std::to_string(most_sections) +
                                " sections, { ... }");
  }
  std::istringstream lines(text);
  int number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\v\f\r");
    if (first == std::string::npos || line[first] != '#') continue;
    throw std::invalid_argument("line " + std::to_string(number) + ": '" +
                                shown(line.substr(first)) +
                                "': expected ; before comments, and no other files");
  }
}

/// \param store  takes key and text; false if the key is there already
template <class Store>
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

[[noreturn]] void reject(const std::string& key, const std::string& text,
                         const std::string& accepted) {
  throw std::invalid_argument(key + " = '" + shown(text) + "': expected " + accepted);
}

std::string listed(std::initializer_list<std::string_view> words) {
  std::string all;
  for (const std::string_view word : words) {
    if (!all.empty()) all += " or ";
    all += word;
  }
  return all;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// " (did you mean 'x'?)" if one of the candidates is within three edits.
template <class Candidates>
std::string suggestion(const std::string& key, const Candidates& candidates) {
  std::size_t best = 4;
  std::string nearest;
  for (const auto& [candidate, value] : candidates) {
    const std::size_t distance = edit_distance(key, candidate);
    if (distance == 0 || distance >= best) continue;
    best = distance;
    nearest = candidate;
  }
  return nearest.empty() ? "" : " (did you mean '" + shown(nearest) + "'?)";
}

}  // namespace

Scene Scene::parse(std::istream& in, const std::string& name, const std::string& folder) {
  Tree tree;
  try {
    const std::string text = plain_text({std::istreambuf_iterator<char>(in), {}});
    require_plain_info(text);
    std::istringstream plain(text);
    boost::property_tree::read_info(plain, tree);
  } catch (const boost::property_tree::info_parser_error& error) {
    throw std::invalid_argument(name + ": line " + std::to_string(error.line()) + ": " +
                                error.message());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
  Scene scene;
  flatten(tree, "", [&](const std::string& key, const std::string& text) {
    return scene.put(key, text, folder);
  });
  return scene;
}

/// Replaces the text of a key that is there, at its place. False if it was.
bool Scene::put(const std::string& key, const std::string& text, const std::string& folder) {
  require_short(key);
  const bool bad_key = std::any_of(key.begin(), key.end(), is_control);
  const auto bad_in_text = [](char c) { return is_control(c) && c != '\t'; };
  if (bad_key || std::any_of(text.begin(), text.end(), bad_in_text)) {
    throw std::invalid_argument(
        (bad_key ? "key '" + shown(key) : shown(key) + " = '" + shown(text)) +
        "': expected no control characters");
  }
  const auto [at, is_new] = values_.try_emplace(key, Value{text, folder, next_place_});
  if (is_new) {
    ++next_place_;
  } else {
    at->second.text = text;
    at->second.folder = folder;
  }
  return is_new;
}

void Scene::overlay(const Scene& other) {
  for (const std::string& key : other.keys()) {
    const Value& value = other.value(key);
    put(key, value.text, value.folder);
  }
}

Scene Scene::take_section(const std::string& section) {
  Scene taken;
  for (const std::string& key : keys()) {
    if (!key.starts_with(section + '.')) continue;
    const Value& value = values_.at(key);
    taken.put(key.substr(section.size() + 1), value.text, value.folder);
    values_.erase(key);
  }
  return taken;
}

void Scene::replace(const std::string& key, const std::string& text) {
  put(key, text, value(key).folder);
}

std::vector<std::string> Scene::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, value] : values_) all.push_back(key);
  std::sort(all.begin(), all.end(), [&](const std::string& a, const std::string& b) {
    return values_.at(a).place < values_.at(b).place;
  });
  return all;
}

void Scene::set(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string_view::npos) {
    throw std::invalid_argument("--set '" + shown(assignment) + "': expected key=value");
  }
  const std::string key(assignment.substr(0, equals));
  const std::string value(assignment.substr(equals + 1));
  if (value.empty()) {
    values_.erase(key);
  } else {
    values_.erase("sweep." + key);
    put(key, value, "");
  }
}

const Scene::Value& Scene::value(const std::string& key) const {
  const auto found = values_.find(key);
  if (found != values_.end()) return found->second;
  throw std::invalid_argument("missing key '" + key + "'" + suggestion(key, values_));
}

bool Scene::has_second(const std::string& first, const std::string& second) const {
  const bool both = has(first) && has(second);
  if (both || (!has(first) && !has(second))) {
    throw std::invalid_argument(std::string(both ? "expected only one of" : "missing key") + " '" +
                                first + (both ? "' and '" : "' or '") + second + "'" +
                                (both ? "" : suggestion(first, values_)));
  }
  return has(second);
}

double Scene::number(const std::string& key) {
  const auto value = finite_number(text(key));
  if (!value) reject(key, text(key), "a finite number" + advice(text(key)));
  parameters_.emplace_back(key, format_short(*value));
  return *value;
}

double Scene::number(const std::string& key, double fallback) {
  if (has(key)) return number(key);
  parameters_.emplace_back(key, format_short(fallback));
  return fallback;
}

double Scene::positive(const std::string& key) {
  const double value = number(key);
  require_positive(key, value);
  return value;
}

std::vector<double> Scene::numbers(const std::string& key) {
  std::vector<double> values;
  std::istringstream words(text(key));
  for (std::string word; words >> word;) {
    const auto value = finite_number(word);
    if (!value) {
      reject(key, text(key), "finite numbers" + advice(word) + ", separated by blanks");
    }
    values.push_back(*value);
  }
  if (values.empty()) reject(key, text(key), "at least one number");
  parameters_.emplace_back(key, text(key));
  return values;
}

Eigen::Index Scene::whole(const std::string& key) {
  const auto value = whole_number(text(key));
  if (!value) reject(key, text(key), "a whole number");
  parameters_.emplace_back(key, std::to_string(*value));
  return *value;
}

std::vector<Eigen::Index> Scene::wholes(const std::string& key, Eigen::Index least,
                                        Eigen::Index most) {
  std::vector<Eigen::Index> values;
  for (const double value : numbers(key)) {
    require(value >= static_cast<double>(least) && value <= static_cast<double>(most) &&
                value == std::floor(value),
            key, value,
            "whole numbers from " + std::to_string(least) + " to " + std::to_string(most));
    values.push_back(static_cast<Eigen::Index>(value));
  }
  return values;
}

std::vector<Eigen::VectorXd> Scene::columns(const std::string& key,
                                            const std::vector<std::string>& names) {
  const Value& file = value(key);
  const std::string& path = file.text;
  if (!read_file_) throw std::invalid_argument("expected no file here");
  std::istringstream in(read_file_(path.starts_with('/') ? path : file.folder + path));
  parameters_.emplace_back(key, path);
  return read_columns(in, names);
}

std::string Scene::word(const std::string& key, std::initializer_list<std::string_view> accepted) {
  const std::string& value = text(key);
  if (std::find(accepted.begin(), accepted.end(), value) == accepted.end()) {
    reject(key, value, listed(accepted));
  }
  parameters_.emplace_back(key, value);
  return value;
}

std::string Scene::word_or_first(const std::string& key,
                                 std::initializer_list<std::string_view> accepted) {
  if (has(key)) return word(key, accepted);
  parameters_.emplace_back(key, *accepted.begin());
  return parameters_.back().second;
}

void Scene::reject_unread() const {
  for (const auto& [key, value] : values_) {
    const auto read = [&key = key](const auto& parameter) { return parameter.first == key; };
    if (std::any_of(parameters_.begin(), parameters_.end(), read)) continue;
    throw std::invalid_argument("unknown key '" + shown(key) + "'" + suggestion(key, parameters_) +
                                "; known to this model: " + known_keys());
  }
}

void Scene::warn(const std::string& line) {
  const bool is_new = std::find(warnings_.begin(), warnings_.end(), line) == warnings_.end();
  if (is_new) warnings_.push_back(line);
}

Parameters Scene::origin() const {
  Parameters origin = parameters_;
  for (const std::string& line : warnings_) origin.emplace_back("warning", line);
  return origin;
}

std::string Scene::known_keys() const {
  std::string keys;
  for (const auto& [key, value] : parameters_) keys += (keys.empty() ? "" : ", ") + key;
  return keys;
}

}  // namespace microslip
