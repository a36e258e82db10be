// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "drawing.hpp"
#include "exact_solution.hpp"
#include "microslip/scene/changed_keys.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"

namespace microslip::program {

namespace {

using Names = std::vector<std::string>;

bool rolls(const std::string& kind) {
  return kind == "steady" || kind == "transient" || kind == "cylinder";
}

std::string common_kind(const std::vector<Result>& results) {
  const std::string& first = results.front().kind;
  bool all_roll = rolls(first);
  for (const Result& result : results) {
    if (result.kind == first) continue;
    all_roll = all_roll && rolls(result.kind);
    if (all_roll) continue;
    throw_other_kind(result, results.front());
  }
  const bool same = std::ranges::all_of(results, [&](const auto& r) { return r.kind == first; });
  return same ? first : "tractions";
}

/// Keys of scenes in which not all agree.
Names differing_keys(const std::vector<Parameters>& all) {
  Names keys;
  for (const Parameters& other : all) {
    for (const std::string& key : changed_keys(all.front(), other)) {
      const bool is_new = std::ranges::find(keys, key) == keys.end();
      if (is_new && find_key(key) != nullptr) keys.push_back(key);
    }
  }
  return keys;
}

std::string value_in(const Parameters& parameters, const std::string& key) {
  const auto found = std::ranges::find(parameters, key, &Parameters::value_type::first);
  if (found == parameters.end()) return "";
  const auto is_patch = [](const auto& parameter) { return is_patch_key(parameter.first); };
  const std::string unit = unit_of_key(key, std::ranges::any_of(parameters, is_patch));
  return unit == "1" ? found->second : fmt::format("{} {}", found->second, unit);
}

/// Names of results, with one or two keys in which they differ.
Names labels_of(const std::vector<Result>& results, const std::vector<Parameters>& all) {
  if (results.size() == 1) return {"microslip"};
  constexpr std::size_t most_keys = 2;
  const Names keys = differing_keys(all);
  Names labels;
  for (std::size_t i = 0; i < results.size(); ++i) {
    Names values;
    for (const std::string& key : keys) {
      const std::string value = value_in(all[i], key);
      if (!value.empty()) values.push_back(fmt::format("{} = {}", key, value));
    }
    const bool tells = !values.empty() && keys.size() <= most_keys;
    labels.push_back(tells ? fmt::format("{}: {}", results[i].name, joined(values, ", "))
                           : results[i].name);
  }
  return labels;
}

Table empty_table(const std::string& name, const Names& columns) {
  std::vector<Column> all{{"line", "1", "number of the line"}};
  for (const std::string& column : columns) all.push_back({column, "1", "of the result"});
  return {name, "lines of a figure", all};
}

/// Adds the rows of a table.
/// \param names   of its columns that are taken, in the order of the columns of `table`
/// \param extent  takes the numbers of the first of them
void append(Table& table, std::size_t line, const Table& from, const Names& names, Extent& extent) {
  for (std::size_t i = 0; i < from.rows(); ++i) {
    std::vector<Cell> row{fmt::format("{}", line)};
    for (const std::string& name : names) row.push_back(from.at(i, name));
    extent.include(number_of(row[1]).value_or(NAN));
    table.add(row);
  }
}

/// Adds Carter's solutions, each once, as the last lines.
void add_exact(Drawing& drawing, const std::vector<Parameters>& all) {
  constexpr int points = 400;
  std::vector<Carter> added;
  for (const Parameters& parameters : all) {
    const auto exact = exact_solution(parameters);
    if (!exact) continue;
    const bool is_new = std::ranges::none_of(added, [&](const Carter& other) {
      return other.force() == exact->force() && other.creepage() == exact->creepage() &&
             other.bound().half_width() == exact->bound().half_width();
    });
    if (!is_new) continue;
    added.push_back(*exact);
    drawing.lines.push_back({added.size() == 1 ? "Carter, exact" : "", black, 1, true});
    for (int i = 0; i < points; ++i) {
      const double x =
          -exact->bound().half_width() * std::cos(std::numbers::pi * (i + 0.5) / points);
      drawing.tables.front().add({fmt::format("{}", drawing.lines.size()), x, exact->bound()(x),
                                  exact->traction(x), exact->slip(x)});
    }
  }
}

/// Columns of a kind's history that belong to a step: the first row, the start, has none.
Names motions_of(const std::string& kind) {
  if (kind == "transient") return {"creepage"};
  if (kind == "history") return {"creepage", "lateral_creepage", "spin"};
  return {};
}

/// Columns of a kind's history that are drawn over distance or time.
Names quantities_of(const std::string& kind) {
  if (kind == "transient") return {"force", "creepage"};
  if (kind == "history") {
    return {"force", "lateral_force", "spin_moment", "creepage", "lateral_creepage", "spin"};
  }
  return {"v", "force", "total", "potential", "X"};
}

/// The column of a history that has the distance rolled.
std::string distance_column(const std::string& kind) { return kind == "cylinder" ? "X" : "q"; }

/// Adds the histories of all results, over distance or time.
void add_histories(Drawing& drawing, const std::vector<Result>& results) {
  require_axis_of_run(drawing.over);
  const std::string distance = distance_column(drawing.kind);
  const bool over_time = drawing.over == "t";
  const Names quantities = quantities_of(drawing.kind);
  Names drawn{"over"}, taken{over_time ? "t" : distance};
  drawn.insert(drawn.end(), quantities.begin(), quantities.end());
  taken.insert(taken.end(), quantities.begin(), quantities.end());
  drawing.axes.emplace_back(
      "over", over_time ? "time t [s]" : fmt::format("distance rolled {} [mm]", distance));
  Table all = empty_table("history", drawn);
  bool turns = false;
  for (std::size_t i = 0; i < results.size(); ++i) {
    Table history = table_in(results[i].folder, "history").table;
    if (drawing.kind == "history") history = without_rounding(history, quantities);
    if (over_time && !history.has("t")) throw_no_times(results[i]);
    turns = turns || history.has("shift");
    const std::size_t begin = all.rows();
    append(all, i + 1, history, taken, drawing.history);
    for (const std::string& motion : motions_of(drawing.kind)) {
      if (begin < all.rows()) all.put(begin, motion, "NaN");
    }
  }
  drawing.tables.push_back(all);
  if (turns && !over_time) drawing.axes.back().second = "position q [mm]";
}

}  // namespace

void require_axis_of_run(const std::string& over) {
  if (over.empty() || over == "q" || over == "t") return;
  throw std::invalid_argument(fmt::format("--over '{}': expected q or t", shown(over)));
}

void throw_no_times(const Result& result) {
  throw std::invalid_argument(
      fmt::format("--over t: '{}' has no times: expected a run whose load.file has columns t and v",
                  shown(result.name)));
}

/// The summary, which is short, says whether there is anything to look for.
bool ends_without_contact(const Result& result) {
  const Table summary = table_in(result.folder, "summary").table;
  for (std::size_t i = 0; i < summary.rows(); ++i) {
    if (summary.at(i, "quantity") != Cell("full_sliding_force")) continue;
    return number_of(summary.at(i, "value")) == 0;
  }
  return false;
}

bool ends_backward(const Result& result) {
  if (!std::filesystem::exists(result.folder / "history.tsv")) return false;
  const Table summary = table_in(result.folder, "summary").table;
  bool turns = false;
  for (std::size_t i = 0; i < summary.rows(); ++i) {
    turns = turns || summary.at(i, "quantity") == Cell("position");
  }
  if (!turns) return false;
  const Table history = table_in(result.folder, "history").table;
  const auto place = [&](std::size_t i) { return number_of(history.at(i, "q")).value_or(NAN); };
  std::size_t last = history.rows() - 1;
  while (last > 0 && place(last - 1) == place(last)) --last;
  return last > 0 && place(last) < place(last - 1);
}

Drawing drawing_of_scenes(const std::vector<Result>& results, const std::string& over) {
  Drawing drawing{.kind = common_kind(results)};
  const bool responds = drawing.kind == "response", is_patch = drawing.kind == "history";
  const std::string first = responds ? "response" : "traction";
  const Names columns = responds ? Names{"wavelength_ratio", "size", "phase"}
                                 : Names{"x", "bound", "traction", "slip"};
  std::vector<Parameters> parameters;
  if (!is_patch) drawing.tables.push_back(empty_table(first, columns));
  if (responds) drawing.unit = "1";
  for (std::size_t i = 0; i < results.size(); ++i) {
    const WrittenTable table = table_in(results[i].folder, first);
    parameters.push_back(table.parameters);
    if (!is_patch) append(drawing.tables[0], i + 1, table.table, columns, drawing.horizontal);
  }
  if (!over.empty()) drawing.over = over;
  if (drawing.kind == "transient" || drawing.kind == "cylinder" || is_patch) {
    add_histories(drawing, results);
  }
  for (const std::string& label : labels_of(results, parameters)) {
    drawing.lines.push_back({label, color_of(drawing.lines.size(), results.size())});
  }
  if (drawing.kind == "steady") add_exact(drawing, parameters);
  return drawing;
}

}  // namespace microslip::program
