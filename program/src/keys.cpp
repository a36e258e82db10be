// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/keys.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "command_line.hpp"
#include "key_list.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"
#include "process.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;

constexpr const char* formats = "text, markdown, man or completion";

/// Largest number of words in a list that is shown completely.
constexpr std::size_t most_words = 8;

/// "", "mm", or the units of a line contact and of an ellipse: "N/mm, N".
std::string units_of(const Key& key) {
  const std::string unit(key.unit == "1" ? "" : key.unit);
  return key.patch_unit.empty() ? unit : fmt::format("{}, {}", unit, key.patch_unit);
}

void print_text(const KeyList& keys) {
  std::size_t names = 0, units = 0;
  for (const auto& [key, value] : keys) {
    names = std::max(names, key.name.size());
    units = std::max(units, units_of(key).size());
  }
  for (const auto& [key, value] : keys) {
    std::cout << std::left << std::setw(static_cast<int>(names)) << key.name << "  "
              << std::setw(static_cast<int>(units)) << units_of(key) << "  " << key.meaning << ": "
              << accepted_by(key, value) << (key.role.empty() ? "" : "; for ") << key.role << '\n';
  }
}

/// ASCII as books print it.
/// \param names  of keys, which are printed as code, unless they may be a word of English
std::string typeset(std::string_view text, const std::set<std::string>& names) {
  std::string all;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    const std::size_t end = word.find_last_not_of(",;") + 1;
    const std::string name = word.substr(0, end);
    const bool is_key = names.contains(name) && name.find_first_of("._") != std::string::npos;
    all += all.empty() ? "" : " ";
    all += is_key ? fmt::format("`{}`{}", name, word.substr(end)) : word;
  }
  const std::pair<const char*, const char*> written[] = {
      {"^(1/2)", "^½"}, {"^2", "²"},    {"^3", "³"},   {"mu p0", "μ p₀"}, {"ratio nu", "ratio ν"},
      {"L0", "L₀"},     {"Dy", "Δy"},   {"beta", "β"}, {"alpha", "α"},    {"+-", "±"},
      {">=", "≥"},      {"c*", "c\\*"}, {"1e6", "10⁶"}};
  for (const auto& [from, to] : written) boost::algorithm::replace_all(all, from, to);
  return all;
}

void print_markdown(const KeyList& keys) {
  std::set<std::string> names;
  bool have_roles = false;
  for (const Key& key : keys_of_scenes()) names.emplace(key.name);
  for (const auto& [key, value] : keys) {
    names.emplace(key.name);
    have_roles = have_roles || !key.role.empty();
  }
  std::cout << "| key | meaning | unit | accepted, [default] |" << (have_roles ? " for |" : "")
            << "\n|---|---|---|---|" << (have_roles ? "---|" : "") << '\n';
  for (const auto& [key, value] : keys) {
    const bool is_text =
        key.type == Key::Type::word || key.type == Key::Type::file || key.type == Key::Type::text;
    std::cout << "| `" << key.name << "` | " << typeset(key.meaning, names) << " | "
              << (is_text ? "" : typeset(key.unit == "1" ? "1" : units_of(key), names) + ' ')
              << "| " << typeset(accepted_by(key, value, "`"), names) << " |";
    if (have_roles)
      std::cout << ' ' << (key.role.empty() ? "all" : typeset(key.role, names)) << " |";
    std::cout << '\n';
  }
}

void print_man(const KeyList& keys) {
  for (const auto& [key, value] : keys) {
    std::string text(key.meaning);
    if (key.unit != "1") text += fmt::format(" ({})", units_of(key));
    text += fmt::format(". {}.", accepted_by(key, value));
    if (!key.role.empty()) text += fmt::format(" For {}.", key.role);
    boost::algorithm::replace_all(text, "-", "\\-");
    std::cout << ".TP\n.B " << key.name << '\n' << text << '\n';
  }
}

/// A list without its middle, with 5e8 in place of 5e+08.
std::string shortened(std::string list) {
  for (const char* sign : {"e+0", "e+"}) boost::algorithm::replace_all(list, sign, "e");
  std::istringstream text(list);
  std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
  if (words.size() <= most_words) return list;
  return fmt::format("{} {} ... {}", words[0], words[1], words.back());
}

/// Each key with its words; of one that names a file with a slash, and of one that is a number with
/// an equals sign and the default, neither of which a word has.
void print_completion(const KeyList& keys) {
  for (const auto& [key, value] : keys) {
    std::cout << key.name << ' ';
    if (key.type == Key::Type::file) {
      std::cout << '/';
    } else if (key.type == Key::Type::word) {
      std::cout << joined(words_of(key), " ");
    } else {
      std::cout << '=' << value;
    }
    std::cout << '\n';
  }
}

}  // namespace

void print_keys(const KeyList& keys, const std::string& format) {
  if (format == "text") {
    print_text(keys);
  } else if (format == "markdown") {
    print_markdown(keys);
  } else if (format == "man") {
    print_man(keys);
  } else if (format == "completion") {
    print_completion(keys);
  } else {
    throw std::invalid_argument(fmt::format("format '{}': expected {}", shown(format), formats));
  }
}

void print_keys_of_study(const Program& study, const std::string& format) {
  Scene scene = built_in_scene(study);
  study.prepare(scene);
  KeyList keys;
  std::vector<std::string> of_scenes;
  for (const auto& [name, value] : scene.parameters()) {
    if (name.find(' ') != std::string::npos) continue;  // it is derived
    const Key* found = scene.known(name);
    if (found == nullptr) throw std::logic_error("no key of scenes or of this study: " + name);
    Key key = *found;
    key.role = "";  // it has one here
    if (format == "markdown" && found == find_key(name)) {
      of_scenes.push_back(fmt::format("`{}` [{}]", name, shortened(value)));
    } else {
      keys.emplace_back(key, shortened(value));
    }
  }
  print_keys(keys, format);
  if (format == "markdown" && !of_scenes.empty()) {
    std::cout << "\nThe study takes keys of [scenes](scenes.md), too: " << joined(of_scenes, ", ")
              << ".\n";
  }
}

int keys(const std::string& name, int argc, const char* const* argv) {
  return run_process(name, [&] {
    Options known("Options of keys");
    known.add_options()("format", options::value<std::string>()->default_value("text"), formats)(
        "version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1);
    if (answers(given, known, name + " keys", "lists the keys of scenes")) return 0;
    KeyList keys;
    for (const Key& key : keys_of_scenes()) keys.emplace_back(key, default_of(key));
    print_keys(keys, given["format"].as<std::string>());
    return 0;
  });
}

}  // namespace microslip::program
