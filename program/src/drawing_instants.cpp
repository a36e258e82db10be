// SPDX-License-Identifier: GPL-3.0-or-later
// The tractions of a run at its instants, for small multiples and animations.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include "drawing.hpp"
#include "microslip/support/shown.hpp"

namespace microslip::program {

namespace {

using Numbers = std::vector<double>;

/// The rows of one instant in columns of numbers; slip is 1 and adhesion 0.
using Columns = std::map<std::string, Numbers>;

/// Small multiples beyond these would be too small.
constexpr std::size_t most_panels = 12;

/// The rows of a table by their instants.
std::map<int, Columns> by_instants(const Table& table) {
  std::map<int, Columns> found;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    Columns& columns = found[static_cast<int>(number_of(table.at(i, "instant")).value())];
    for (const Column& column : table.columns()) {
      const Cell& cell = table.at(i, column.name);
      const double slips = cell == Cell("S") ? 1 : 0;
      columns[column.name].push_back(number_of(cell).value_or(slips));
    }
  }
  return found;
}

/// A number of instants of which the last one is the last of all, evenly spread.
std::vector<int> selected(const std::vector<int>& all, std::size_t count) {
  if (all.size() <= count) return all;
  std::vector<int> some;
  for (std::size_t k = 1; k <= count; ++k) some.push_back(all[k * all.size() / count - 1]);
  return some;
}

/// Texts of numbers with as few digits as tell them apart.
std::vector<std::string> told_apart(const Numbers& values) {
  constexpr int least_digits = 3, most_digits = 15;
  const std::size_t different = std::set<double>(values.begin(), values.end()).size();
  std::vector<std::string> texts;
  for (int digits = least_digits; digits <= most_digits; ++digits) {
    texts.clear();
    for (const double value : values) texts.push_back(fmt::format("{:.{}g}", value, digits));
    if (std::set<std::string>(texts.begin(), texts.end()).size() == different) break;
  }
  return texts;
}

/// The title of a panel: place or time.
std::vector<std::string> titles_of(const std::vector<int>& instants,
                                   const std::map<int, Columns>& rows, bool over_time) {
  std::map<std::string, Numbers> at;
  for (const int instant : instants) {
    if (!rows.contains(instant)) continue;
    for (const char* name : {"q", "distance", "t"}) {
      const auto column = rows.at(instant).find(name);
      if (column != rows.at(instant).end()) at[name].push_back(column->second.front());
    }
  }
  std::map<std::string, std::vector<std::string>> texts;
  for (const auto& [name, values] : at) texts[name] = told_apart(values);
  std::vector<std::string> titles;
  std::size_t k = 0;
  for (const int instant : instants) {
    if (!rows.contains(instant)) {
      titles.push_back(fmt::format("instant {}", instant));
      continue;
    }
    std::string title = over_time ? fmt::format("t = {} s", texts["t"][k])
                                  : fmt::format("q = {} mm", texts["q"][k]);
    if (!over_time && at.contains("distance")) {
      title += fmt::format(", rolled {} mm", texts["distance"][k]);
    }
    titles.push_back(title);
    ++k;
  }
  return titles;
}

double largest(const Numbers& numbers) {
  double most = 0;
  for (const double number : numbers) most = std::max(most, std::abs(number));
  return most;
}

std::string file_of(const std::string& kind, std::size_t panel) {
  return fmt::format("{}_{}.tsv", kind, panel);
}

OutputFile line_of(std::size_t panel, const Columns& of) {
  std::string text = "x\tbound\ttraction\tslips\n";
  for (std::size_t i = 0; i < of.at("x").size(); ++i) {
    text += fmt::format("{:.9g}\t{:.9g}\t{:.9g}\t{}\n", of.at("x")[i], of.at("bound")[i],
                        of.at("traction")[i], of.at("region")[i]);
  }
  return {file_of("line", panel), text};
}

/// The cells of a map, row by row, and the sides of its rows.
struct Map {
  const Columns& cells;
  const Columns& edges;
  bool by_rectangles;
  std::size_t elements;  ///< of a row, but for rectangles

  /// Where each row begins among the cells, and where the last one ends.
  std::vector<std::size_t> begins() const {
    std::vector<std::size_t> rows{0};
    const Numbers& y = cells.at("y");
    for (std::size_t i = 1; i < y.size(); ++i) {
      if (by_rectangles ? y[i] != y[i - 1] : i % elements == 0) rows.push_back(i);
    }
    rows.push_back(y.size());
    return rows;
  }

  /// Colours are tractions over their bound, or beyond 1 where it slips.
  double colour(std::size_t cell) const {
    constexpr double slips = 1.2;
    const double size = std::hypot(cells.at("traction_x")[cell], cells.at("traction_y")[cell]);
    return cells.at("zone")[cell] > 0 ? slips : size / cells.at("bound")[cell];
  }
};

/// Strips of cells, each with both of its sides, from the leading edge on.
OutputFile cells_of(std::size_t panel, const Map& map) {
  std::string text;
  const std::vector<std::size_t> begins = map.begins();
  const Numbers &lobe = map.edges.at("lobe"), &row = map.edges.at("row");
  for (std::size_t side = 0; side + 1 < lobe.size(); ++side) {
    if (lobe[side + 1] != lobe[side] || (map.by_rectangles && row[side + 1] != row[side])) continue;
    const auto k = static_cast<std::size_t>(row[side]) - 1;
    const std::size_t count = begins[k + 1] - begins[k];
    const bool rises = count > 1 && map.cells.at("x")[begins[k]] < map.cells.at("x")[begins[k] + 1];
    for (const std::size_t at : {side, side + 1}) {
      const double trailing = map.edges.at("trailing")[at], leading = map.edges.at("leading")[at];
      for (std::size_t j = 0; j <= count; ++j) {
        const double part = static_cast<double>(j) / static_cast<double>(count);
        const double place = map.by_rectangles ? 1 - 2 * part : std::cos(std::numbers::pi * part);
        const std::size_t from_leading = std::min(j, count - 1);
        const std::size_t cell = begins[k] + (rises ? count - 1 - from_leading : from_leading);
        text += fmt::format("{:.6g}\t{:.6g}\t{:.4g}\n",
                            (trailing + leading) / 2 + (leading - trailing) / 2 * place,
                            map.edges.at("y")[at], map.colour(cell));
      }
      text += '\n';
    }
    text += '\n';
  }
  return {file_of("cells", panel), text};
}

/// The outline of each lobe.
OutputFile outline_of(std::size_t panel, const Columns& edges) {
  std::string text;
  const Numbers& lobe = edges.at("lobe");
  const auto point = [&](const char* edge, std::size_t i) {
    text += fmt::format("{:.6g}\t{:.6g}\n", edges.at(edge)[i], edges.at("y")[i]);
  };
  for (std::size_t first = 0, end = 0; first < lobe.size(); first = end) {
    while (end < lobe.size() && lobe[end] == lobe[first]) ++end;
    for (std::size_t i = first; i < end; ++i) point("trailing", i);
    for (std::size_t i = end; i > first; --i) point("leading", i - 1);
    point("trailing", first);
    text += '\n';
  }
  return {file_of("outline", panel), text};
}

/// Tractions as arrows.
/// \param every  rows, and cells of a row, for each arrow
/// \param scale  length of an arrow for a traction of 1  [mm]
OutputFile arrows_of(std::size_t panel, const Map& map, std::size_t every, double scale) {
  const std::vector<std::size_t> begins = map.begins();
  const Numbers &x = map.cells.at("x"), &y = map.cells.at("y");
  std::string text;
  for (std::size_t k = every / 2; k + 1 < begins.size(); k += every) {
    // Rectangles are counted from the middle, so that arrows stand below one another.
    const std::size_t count = begins[k + 1] - begins[k];
    const std::size_t first = map.by_rectangles ? count / 2 % every : every / 2;
    for (std::size_t j = first; j < count; j += every) {
      const std::size_t i = begins[k] + j;
      text +=
          fmt::format("{:.6g}\t{:.6g}\t{:.6g}\t{:.6g}\n", x[i], y[i],
                      scale * map.cells.at("traction_x")[i], scale * map.cells.at("traction_y")[i]);
    }
  }
  return {file_of("arrows", panel), text};
}

/// Ranges of the axes that have all instants.
struct Frame {
  Extent x = {}, y = {};
  double bound = 0;       ///< the largest one
  double area = 0;        ///< of the largest map  [mm^2]
  std::size_t cells = 0;  ///< of it

  void include(const Columns& of, const Columns* edges) {
    bound = std::max(bound, largest(of.at("bound")));
    const Columns& places = edges == nullptr ? of : *edges;
    for (const char* name : {"x", "trailing", "leading"}) {
      if (!places.contains(name)) continue;
      for (const double value : places.at(name)) x.include(value);
    }
    if (edges == nullptr) return;
    for (const double value : places.at("y")) y.include(value);
    area = std::max(area, std::accumulate(of.at("area").begin(), of.at("area").end(), 0.0));
    cells = std::max(cells, of.at("x").size());
  }
};

/// A quantity of the summary.
std::string in_summary(const Result& result, const std::string& quantity) {
  const Table summary = table_in(result.folder, "summary").table;
  for (std::size_t i = 0; i < summary.rows(); ++i) {
    if (summary.at(i, "quantity") == Cell(quantity)) {
      return std::get<std::string>(summary.at(i, "value"));
    }
  }
  return "";
}

}  // namespace

std::vector<OutputFile> files_of_instants(const Result& result, bool over_time, bool animated) {
  const Table table = table_in(result.folder, "instants").table;
  if (over_time && !table.has("t")) throw_no_times(result);
  const std::map<int, Columns> rows = by_instants(table);
  if (rows.empty()) {
    throw std::invalid_argument(
        fmt::format("'{}': expected contact at an instant, to draw it", shown(result.name)));
  }
  const bool is_map = table.has("zone");
  std::map<int, Columns> edges;
  if (is_map) edges = by_instants(table_in(result.folder, "instants_edges").table);
  std::vector<int> all;
  for (int k = 1; k <= rows.rbegin()->first; ++k) all.push_back(k);
  const std::vector<int> shown = animated ? all : selected(all, most_panels);
  const std::vector<std::string> titles = titles_of(shown, rows, over_time);

  Frame frame;
  for (const auto& [k, of] : rows) frame.include(of, is_map ? &edges.at(k) : nullptr);
  // There are at most some hundred arrows, and those of the largest bound are nearly as long as the
  // distance between them.
  constexpr double most_arrows = 120, part_of_distance = 0.9;
  const auto cells = static_cast<double>(frame.cells);
  const double every = std::ceil(std::sqrt(cells / most_arrows));
  const double longest = part_of_distance * every * std::sqrt(frame.area / cells);
  const std::string method = in_summary(result, "method");
  const bool by_rectangles = method == "direct" || method == "relaxed";
  const auto elements =
      static_cast<std::size_t>(is_map ? std::stoul(in_summary(result, "elements")) : 0);

  std::vector<OutputFile> files;
  Table panels("panels", "panels of a figure",
               {{"panel", "1", "number"},
                {"contact", "1", "whether there is any"},
                {"title", "1", "place or time"}});
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const std::size_t panel = k + 1;
    const auto found = rows.find(shown[k]);
    const bool touches = found != rows.end() && largest(found->second.at("bound")) > 0;
    panels.add({panel, touches ? 1 : 0, titles[k]});
    if (!touches) continue;
    if (!is_map) {
      files.push_back(line_of(panel, found->second));
      continue;
    }
    const Map map{found->second, edges.at(shown[k]), by_rectangles, elements};
    files.push_back(cells_of(panel, map));
    files.push_back(outline_of(panel, map.edges));
    files.push_back(arrows_of(panel, map, static_cast<std::size_t>(every), longest / frame.bound));
  }
  const auto number = [](double value) { return fmt::format("{:.9g}", value); };
  files.push_back(output_of(panels, "figure",
                            {{"map", is_map ? "1" : "0"},
                             {"animated", animated ? "1" : "0"},
                             {"instants", fmt::format("{}", all.size())},
                             {"turns", table.has("distance") ? "1" : "0"},
                             {"left", number(frame.x.least)},
                             {"right", number(frame.x.most)},
                             {"low", number(is_map ? frame.y.least : 0)},
                             {"high", number(is_map ? frame.y.most : 0)},
                             {"bound", number(frame.bound)}}));
  return files;
}

}  // namespace microslip::program
