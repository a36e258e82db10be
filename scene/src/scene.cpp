// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "columns.hpp"
#include "info.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/sweep.hpp"
#include "microslip/scene/units.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/text.hpp"
#include "number.hpp"

namespace microslip {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Whether a key is about three dimensions, as other programs have them.
bool is_of_three_dimensions(const std::string& key) {
  constexpr std::string_view words[] = {
      "spin_creepage", "creepage_x",  "creepage_y",       "force_x",      "force_y",
      "force_z",       "moment",      "moment_z",         "half_width_y", "half_length",
      "semi_axis_a",   "semi_axis_b", "creepage_lateral", "elements_y",   "force_lateral"};
  const std::string last = key.substr(key.rfind('.') + 1);
  return std::ranges::find(words, last) != std::end(words);
}

/// Refuses the first key that has another program's name for three dimensions.
void refuse_names_of_others(const Scene& scene) {
  for (const std::string& key : scene.keys()) {
    if (scene.known(key) != nullptr || !is_of_three_dimensions(key)) continue;
    throw BadParameter(
        key,
        fmt::format(
            "key '{}': three-dimensional: an ellipse has contact.lateral_half_width or "
            "contact.lateral_radius_2, load.lateral_creepage and load.spin; in a line contact, "
            "'direction lateral' is about the creepage across the rolling",
            shown(key)));
  }
}

/// A key that nobody knows may be the missing one, misspelt.
/// \param names  of the missing key; the first one is what may be misspelt
[[noreturn]] void reject_missing(const Scene& scene, const std::vector<std::string>& names) {
  refuse_names_of_others(scene);
  std::vector<std::string> unknown = scene.keys();
  std::erase_if(unknown, [&](const std::string& key) { return scene.known(key) != nullptr; });
  std::string misspelt = nearest(names.front(), unknown);
  if (misspelt.empty()) misspelt = scene.misspelt();
  if (misspelt.empty()) throw MissingKey("", names, "");
  std::vector<std::string> meant = names;
  std::ranges::copy(names_of(keys_of_scenes()), std::back_inserter(meant));
  throw MissingKey(
      misspelt, names,
      fmt::format("; '{}' is no key{}", shown(misspelt), suggestion(likely_key(misspelt, meant))));
}

/// The known key with an s more or less, as step.ratios of a study; empty if there is none.
std::string in_other_number(const std::string& key, const std::vector<std::string>& known) {
  const std::string other = key.ends_with('s') ? key.substr(0, key.size() - 1) : key + 's';
  return std::ranges::find(known, other) == known.end() ? "" : other;
}

/// Removes all that sweeps a key, alone or together with others, except for one name. Returns how
/// many these were.
template <class Values>
std::size_t remove_swept(Values& values, const std::string& key, const std::string& except = "") {
  return std::erase_if(values, [&](const auto& entry) {
    return entry.first != except && swept_key(entry.first) == key;
  });
}

}  // namespace

Scene Scene::parse(std::istream& in, const std::string& name, const std::string& folder) {
  const auto fail = [](const std::string& place, const std::string& what) {
    throw std::invalid_argument(place + what);
  };
  std::string text;
  try {
    text = plain_text({std::istreambuf_iterator<char>(in), {}});
  } catch (const std::invalid_argument& error) {
    fail(shown(name) + ": ", error.what());
  }
  if (text.size() > most_text) {
    fail(shown(name) + ": ", fmt::format("expected at most {} bytes", most_text));
  }
  Scene scene;
  for (const InfoEntry& entry : read_info(text, name)) {
    const std::string place = place_in(name, entry.line);
    if (const auto found = scene.values_.find(entry.key); found != scene.values_.end()) {
      fail(place, fmt::format("key '{}' is given twice, first in line {}", shown(entry.key),
                              found->second.place.line));
    }
    try {
      scene.put(entry.key, entry.text, {name, entry.line, folder});
    } catch (const std::invalid_argument& error) {
      fail(place, error.what());
    }
  }
  return scene;
}

/// Sets the text of a key; a key that is there already keeps its position in the order.
void Scene::put(const std::string& key, const std::string& text, const Place& place) {
  require_short(key);
  const bool bad_key = std::any_of(key.begin(), key.end(), is_control);
  const auto bad_in_text = [](char c) { return is_control(c) && c != '\t'; };
  if (bad_key || std::any_of(text.begin(), text.end(), bad_in_text)) {
    throw std::invalid_argument(
        bad_key
            ? fmt::format("key '{}': expected no control characters", shown(key))
            : fmt::format("{} = '{}': expected no control characters", shown(key), shown(text)));
  }
  const auto [at, is_new] = values_.try_emplace(key, Value{text, place, next_order_});
  if (is_new) {
    ++next_order_;
  } else {
    at->second.text = text;
    at->second.place = place;
  }
}

std::string Scene::place_of(const std::string& key) const {
  const auto found = values_.find(key.substr(key.rfind(' ') + 1));
  if (found == values_.end() || found->second.place.file.empty()) return "";
  return place_in(found->second.place.file, found->second.place.line);
}

void Scene::overlay(const Scene& other) {
  for (const std::string& key : other.keys()) {
    const Value& value = other.value(key);
    put(key, value.text, value.place);
  }
}

Scene Scene::take_section(const std::string& section) {
  Scene taken;
  for (const std::string& key : keys()) {
    if (!key.starts_with(section + '.')) continue;
    const Value& value = values_.at(key);
    taken.put(key.substr(section.size() + 1), value.text, value.place);
    values_.erase(key);
  }
  return taken;
}

void Scene::replace(const std::string& key, const std::string& text) {
  put(key, text, Place(value(key).place));
}

std::vector<std::string> Scene::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, value] : values_) all.push_back(key);
  std::sort(all.begin(), all.end(), [&](const std::string& a, const std::string& b) {
    return values_.at(a).order < values_.at(b).order;
  });
  return all;
}

void Scene::set(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string_view::npos) {
    throw std::invalid_argument(fmt::format("--set '{}': expected key=value", shown(assignment)));
  }
  const std::string key(assignment.substr(0, equals));
  const std::string value(assignment.substr(equals + 1));
  if (value.empty()) {
    remove(key);
  } else {
    remove_swept(values_, swept_key(key).value_or(key), key);
    put(key, value, {});
  }
}

void Scene::remove(const std::string& key) {
  if (values_.erase(key) + remove_swept(values_, key) > 0) return;
  std::vector<std::string> below;
  for (const std::string& one : keys()) {
    if (one.starts_with(key + '.')) below.push_back(one);
  }
  throw std::invalid_argument(
      fmt::format("--set '{}=': expected a key of this scene{}", shown(key),
                  below.empty() ? suggestion(likely_key(key, keys()))
                                : ", not a section; its keys are " + joined(below, ", ")));
}

const Scene::Value& Scene::value(const std::string& key) const {
  const auto found = values_.find(key);
  if (found != values_.end()) return found->second;
  reject_missing(*this, {key});
}

bool Scene::has(const std::string& key) {
  ask(key);
  return std::as_const(*this).has(key);
}

std::string Scene::at_most_one_of(const std::vector<std::string>& keys) {
  for (const std::string& key : keys) ask(key);
  return std::as_const(*this).at_most_one_of(keys);
}

std::string Scene::at_most_one_of(const std::vector<std::string>& keys) const {
  std::string first;
  for (const std::string& key : keys) {
    if (!has(key)) continue;
    if (!first.empty()) {
      throw BadParameter(place_of(key).empty() ? first : key,
                         fmt::format("expected only one of '{}' and '{}'", first, key));
    }
    first = key;
  }
  return first;
}

std::string Scene::one_of(const std::vector<std::string>& keys) {
  const std::string found = at_most_one_of(keys);
  if (!found.empty()) return found;
  reject_missing(*this, keys);
}

void Scene::declare(std::vector<Key> keys) {
  declared_.push_back(std::make_shared<const std::vector<Key>>(std::move(keys)));
}

const Key* Scene::known(std::string_view key) const {
  for (auto keys = declared_.rbegin(); keys != declared_.rend(); ++keys) {
    const auto found = std::ranges::find(**keys, key, &Key::name);
    if (found != (*keys)->end()) return &*found;
  }
  return find_key(key);
}

std::string Scene::unit_of(const std::string& key) const {
  const Key* found = known(key);
  return std::string(found == nullptr ? "1" : microslip::unit_of(*found, has_patch()));
}

bool Scene::has_patch() const {
  return std::ranges::any_of(values_, [](const auto& entry) {
    return is_patch_key(swept_key(entry.first).value_or(entry.first));
  });
}

const Key& Scene::declared(const std::string& key) const {
  const Key* found = known(key);
  if (found == nullptr) throw std::logic_error("no declared key: " + key);
  return *found;
}

void Scene::demand(const std::string& key, double value, bool holds) const {
  require(holds, key, value, [&] { return expected_by(declared(key)); });
}

void Scene::demand_in_range(const std::string& key, double value) const {
  demand(key, value, declared(key).range.holds(value));
}

void Scene::hold_to_range(const std::string& key, double value) const {
  const Key* found = known(key);
  if (found == nullptr || found == find_key(key)) return;
  demand_in_range(key, value);
  if (found->range.open && found->range.least == 0) require_positive(key, value);
}

double Scene::number(const std::string& key) {
  const Key* found = known(key);
  if (!has(key) && found != nullptr && !std::isnan(found->fallback)) {
    return number(key, found->fallback);
  }
  const std::string unit = unit_of(key);
  const auto value = quantity(text(key), unit);
  if (!value) {
    reject(key, text(key),
           has_unit(text(key))
               ? "a number in " + accepted_units(unit) + advice_on_width(text(key), unit)
               : "a finite number" + advice(text(key)));
  }
  record(key, format_short(*value));
  hold_to_range(key, *value);
  return *value;
}

double Scene::number(const std::string& key, double fallback) {
  if (has(key)) return number(key);
  record(key, format_short(fallback));
  return fallback;
}

double Scene::positive(const std::string& key) {
  const double value = number(key);
  require_positive(key, value);
  return value;
}

/// Replaces ranges in a list by their numbers, as a sweep has them.
void Scene::expand_ranges(const std::string& key) {
  if (text(key).find(':') == std::string::npos) return;
  replace(key, joined(swept_values(key, text(key)), " "));
}

std::vector<double> Scene::numbers(const std::string& key) {
  expand_ranges(key);
  const std::string unit = unit_of(key);
  std::vector<double> values;
  bool has_units = false;
  std::istringstream words(text(key));
  for (std::string word; words >> word;) {
    if (const auto value = finite_number(word)) {
      values.push_back(*value);
      continue;
    }
    const bool behind = !values.empty() && !converted<double>(word) &&  // it takes nan and inf, too
                        (std::isalpha(static_cast<unsigned char>(word[0])) != 0 || is_unit(word));
    const auto with_units = quantities(text(key), unit);
    if (!behind && !has_unit(word)) {
      reject(key, text(key), fmt::format("finite numbers{}, separated by blanks", advice(word)));
    }
    if (!with_units && unit == "1") {
      reject(key, text(key),
             "finite numbers, separated by blanks, with % or \u2030 behind or none");
    }
    if (!with_units) {
      reject(key, text(key),
             "numbers with a unit behind the last or behind each, " + accepted_units(unit) +
                 advice_on_width(text(key), unit));
    }
    values = *with_units;
    has_units = true;
    break;
  }
  if (values.empty()) reject(key, text(key), "at least one number");
  record(key, has_units || unit != "1" ? joined_numbers(values) : text(key));
  for (const double value : values) hold_to_range(key, value);
  return values;
}

Eigen::Index Scene::whole(const std::string& key) {
  const Key* found = known(key);
  if (!has(key) && found != nullptr && !std::isnan(found->fallback)) {
    record(key, format_short(found->fallback));
    return static_cast<Eigen::Index>(found->fallback);
  }
  const auto value = whole_number(text(key));
  if (!value) reject(key, text(key), "a whole number");
  record(key, std::to_string(*value));
  hold_to_range(key, static_cast<double>(*value));
  return *value;
}

std::vector<Eigen::Index> Scene::wholes(const std::string& key) {
  std::vector<Eigen::Index> values;
  for (const double value : numbers(key)) {
    demand(key, value, value == std::floor(value));
    values.push_back(static_cast<Eigen::Index>(value));
  }
  return values;
}

std::vector<std::optional<Eigen::VectorXd>> Scene::columns(const std::string& key,
                                                           const std::vector<FileColumn>& wanted) {
  const std::string table = file(key);
  ReadColumns read = read_columns(table, wanted);
  if (!read.unused.empty()) {
    warn(
        key, shown(text(key)),
        fmt::format("columns that are not used: {}; known are {}, and a name that begins with _ is "
                    "left out without a warning",
                    shown(joined(read.unused, ", ")), joined(names_of(wanted), ", ")));
  }
  return read.wanted;
}

std::vector<std::string> Scene::column_names(const std::string& key) {
  const std::string table = file(key);
  return microslip::column_names(table);
}

std::string Scene::file(const std::string& key) {
  const Value& file = value(key);
  const std::string& path = file.text;
  if (!read_file_) throw std::invalid_argument("expected no file here");
  std::string text = read_file_(path.starts_with('/') ? path : file.place.folder + path);
  record(key, path);
  return text;
}

std::string Scene::free_text(const std::string& key) {
  record(key, text(key));
  return text(key);
}

/// The text of a key that has words, or its first word where that is the default.
std::string Scene::text_of_words(const std::string& key) const {
  const Key& found = declared(key);
  const bool is_default = !has(key) && found.first_is_default;
  return is_default ? std::string(words_of(found).front()) : text(key);
}

void Scene::require_word(const std::string& key, const std::string& word) const {
  const std::vector<std::string_view> accepted = words_of(declared(key));
  if (std::ranges::find(accepted, word) == accepted.end()) {
    reject(key, word, joined(accepted, " or "));
  }
}

std::string Scene::word(const std::string& key) {
  const std::string chosen = text_of_words(key);
  require_word(key, chosen);
  record(key, chosen);
  return chosen;
}

std::vector<std::string> Scene::words(const std::string& key) {
  const std::string chosen = text_of_words(key);
  std::vector<std::string> all;
  std::istringstream in(chosen);
  for (std::string word; in >> word;) {
    require_word(key, word);
    all.push_back(word);
  }
  if (all.empty()) require_word(key, chosen);
  record(key, chosen);
  return all;
}

/// Records a parameter, once even if it is read several times.
void Scene::record(const std::string& key, const std::string& value) {
  const bool is_new =
      std::ranges::find(parameters_, key, &Parameters::value_type::first) == parameters_.end();
  if (is_new) parameters_.emplace_back(key, value);
}

void Scene::ask(const std::string& key) {
  if (std::ranges::find(asked_, key) == asked_.end()) asked_.push_back(key);
}

std::string Scene::misspelt() const {
  for (const std::string& key : keys()) {
    const bool is_known = known(key) != nullptr || key.starts_with("sweep.");
    if (!is_known && !likely_key(key).empty()) return key;
  }
  return "";
}

/// Those that were read, then those that were asked for and are not given.
std::vector<std::string> Scene::keys_with_a_part() const {
  std::vector<std::string> all;
  for (const auto& [key, text] : parameters_) {
    if (key.find(' ') == std::string::npos) all.push_back(key);  // others are derived
  }
  const std::size_t read = all.size();
  for (const std::string& key : asked_) {
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(read);
    if (!has(key) && std::find(all.begin(), end, key) == end) all.push_back(key);
  }
  return all;
}

void Scene::reject_unread() const {
  const auto role_of = [&](const Key& key) -> std::string {
    const std::string role(key.role.empty() ? "scenes" : key.role);
    if (role.starts_with("ellipses") && !has_patch()) {
      return fmt::format("{}; {} makes the contact one", role, joined(patch_keys, " or "));
    }
    if (!has_patch()) return role;
    if (!key.patch_role.empty()) return std::string(key.patch_role);
    return role + (has("contact.patch_file") ? ", not for this patch" : ", not for this ellipse");
  };
  refuse_names_of_others(*this);
  const std::vector<std::string> all = keys_with_a_part();
  for (const auto& [key, value] : values_) {
    if (std::find(all.begin(), all.end(), key) != all.end()) continue;
    const Key* elsewhere = find_key(key);
    std::string likely = elsewhere == nullptr ? likely_key(key, all) : in_other_number(key, all);
    if (elsewhere == nullptr && likely.empty()) likely = likely_key(key);
    const std::string why = elsewhere == nullptr
                                ? fmt::format("unknown key '{}'", shown(key)) + suggestion(likely)
                                : fmt::format("key '{}' has no role here{}: it is for {}", key,
                                              suggestion(likely), role_of(*elsewhere));
    const std::string list =
        likely.empty() ? fmt::format("; known to this model: {}", joined(all, ", ")) : "";
    throw BadParameter(key, why + list);
  }
}

void Scene::derive(const std::string& key, double value) {
  record("derived " + key, format_short(value));
}

void Scene::warn(const std::string& key, double value, const std::string& doubt) {
  warn(key, fmt::format("{:.6g}", value), doubt);
}

void Scene::warn(const std::string& key, const std::string& value, const std::string& doubt) {
  const std::string line = fmt::format("{} = {}: {}", key, value, doubt);
  const bool is_new = std::ranges::find(warnings_, line, &Warning::line) == warnings_.end();
  if (is_new) warnings_.push_back({key, line});
}

std::string kind_of_warning(const std::string& line) {
  std::string kind;
  for (const char c : line) {
    const bool is_of_number = std::string_view("0123456789.+-e").find(c) != std::string_view::npos;
    if (!is_of_number) kind += c;
  }
  return kind;
}

Parameters Scene::origin() const {
  Parameters origin = parameters_;
  for (const Warning& warning : warnings_) origin.emplace_back("warning", warning.line);
  return origin;
}

}  // namespace microslip
