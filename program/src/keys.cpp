// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/keys.hpp"

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "command_line.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/support/shown.hpp"
#include "process.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;

void print_text() {
  std::size_t names = 0, units = 0;
  for (const Key& key : keys_of_scenes()) {
    names = std::max(names, key.name.size());
    units = std::max(units, key.unit.size());
  }
  for (const Key& key : keys_of_scenes()) {
    std::cout << std::left << std::setw(static_cast<int>(names)) << key.name << "  "
              << std::setw(static_cast<int>(units)) << (key.unit == "1" ? "" : key.unit) << "  "
              << key.meaning << ": " << accepted_by(key) << (key.role.empty() ? "" : "; for ")
              << key.role << '\n';
  }
}

/// A word of a text as code if it is the name of a key, and not one of English.
std::string as_code(const std::string& word) {
  const std::size_t end = word.find_last_not_of(",;") + 1;
  const std::string name = word.substr(0, end);
  const bool is_key = find_key(name) != nullptr && name.find_first_of("._") != std::string::npos;
  return is_key ? '`' + name + '`' + word.substr(end) : word;
}

/// ASCII as books print it.
std::string typeset(std::string_view text) {
  std::string all;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) all += (all.empty() ? "" : " ") + as_code(word);
  const std::pair<const char*, const char*> written[] = {
      {"^(1/2)", "^½"}, {"^2", "²"},  {"mu p0", "μ p₀"}, {"ratio nu", "ratio ν"},
      {"L0", "L₀"},     {"Dy", "Δy"}, {"beta", "β"},     {"alpha", "α"},
      {"+-", "±"},      {">=", "≥"},  {"c*", "c\\*"},    {"1e6", "10⁶"}};
  for (const auto& [from, to] : written) boost::algorithm::replace_all(all, from, to);
  return all;
}

void print_markdown() {
  std::cout << "| key | meaning | unit | accepted, [default] | for |\n|---|---|---|---|---|\n";
  for (const Key& key : keys_of_scenes()) {
    const bool is_text = key.type == Key::Type::word || key.type == Key::Type::file;
    std::cout << "| `" << key.name << "` | " << typeset(key.meaning) << " | "
              << (is_text ? "" : typeset(key.unit) + ' ') << "| " << typeset(accepted_by(key, "`"))
              << " | " << (key.role.empty() ? "all" : typeset(key.role)) << " |\n";
  }
}

void print_man() {
  for (const Key& key : keys_of_scenes()) {
    std::string text(key.meaning);
    if (key.unit != "1") text += " (" + std::string(key.unit) + ")";
    text += ". " + accepted_by(key) + ".";
    if (!key.role.empty()) text += " For " + std::string(key.role) + ".";
    boost::algorithm::replace_all(text, "-", "\\-");
    std::cout << ".TP\n.B " << key.name << '\n' << text << '\n';
  }
}

}  // namespace

int keys(const std::string& name, int argc, const char* const* argv) {
  return run_process(name, [&] {
    Options known("Options of keys");
    known.add_options()("format", options::value<std::string>()->default_value("text"),
                        "text, markdown, or man, as the documentation has it")(
        "version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1);
    if (answers(given, known, name + " keys", "lists the keys of scenes")) return 0;
    const std::string format = given["format"].as<std::string>();
    if (format == "text") {
      print_text();
    } else if (format == "markdown") {
      print_markdown();
    } else if (format == "man") {
      print_man();
    } else {
      throw std::invalid_argument("--format '" + shown(format) +
                                  "': expected text, markdown or man");
    }
    return 0;
  });
}

}  // namespace microslip::program
