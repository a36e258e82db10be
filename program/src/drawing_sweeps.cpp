// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "drawing.hpp"
#include "exact_solution.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"

namespace microslip::program {

namespace {

using Names = std::vector<std::string>;

constexpr std::size_t most_lines = 24;
constexpr std::size_t most_letters = 64;     // of the name of the horizontal axis
constexpr std::size_t heading_letters = 74;  // over the key

std::string text_of(const Cell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text == nullptr ? fmt::format("{}", std::get<double>(cell)) : *text;
}

/// The rows of a sweep, or of curves of creepage and force, that are shown.
class Cases {
 public:
  Cases(const Result& result, const Names& only)
      : is_curve_(result.kind == "curve"), written_(table_in(result.folder, result.kind)) {
    written_.table = without_rounding(written_.table, columns());
    for (const Column& column : written_.table.columns()) {
      if (column.meaning == "swept") swept_.push_back(column.name);
    }
    if (is_curve_) swept_.push_back(along());
    for (std::size_t i = 0; i < written_.table.rows(); ++i) rows_.push_back(i);
    for (const std::string& one : only) keep(one);
  }

  bool is_curve() const { return is_curve_; }

  /// The value of a key of the scene; `fallback` if it has none.
  std::string parameter(const std::string& key, const std::string& fallback) const {
    const auto found = std::ranges::find(written_.parameters, key, &Parameters::value_type::first);
    return found == written_.parameters.end() ? fallback : found->second;
  }

  /// The motion over which a curve is.
  std::string along() const { return parameter("curve.along", "creepage"); }

  const std::vector<std::size_t>& rows() const { return rows_; }
  const Parameters& parameters() const { return written_.parameters; }
  const Names& swept() const { return swept_; }
  Names columns() const { return names_of(written_.table.columns()); }
  std::string text(std::size_t row, const std::string& column) const {
    return text_of(written_.table.at(row, column));
  }
  double number(std::size_t row, const std::string& column) const {
    return number_of(written_.table.at(row, column)).value_or(NAN);
  }

  bool has(const std::string& column) const { return written_.table.has(column); }

  std::string unit(const std::string& column) const {
    return std::ranges::find(written_.table.columns(), column, &Column::name)->unit;
  }

  /// Whether the column has a number in each row.
  bool is_numeric(const std::string& column) const {
    return std::ranges::all_of(rows_, [&](std::size_t row) {
      return number_of(written_.table.at(row, column)).has_value();
    });
  }

  bool has_numbers(const std::string& column) const {
    return std::ranges::any_of(rows_,
                               [&](std::size_t row) { return std::isfinite(number(row, column)); });
  }

  std::size_t values(const std::string& column) const {
    std::set<std::string> all;
    for (const std::size_t row : rows_) all.insert(text(row, column));
    return all.size();
  }

  /// Whether each value of `from` comes with one value of `column` only.
  bool follows(const std::string& column, const std::string& from) const {
    std::map<std::string, std::string> found;
    return std::ranges::all_of(rows_, [&](std::size_t row) {
      const std::string value = text(row, column);
      return found.emplace(text(row, from), value).first->second == value;
    });
  }

  void require_column(const std::string& option, const std::string& name) const {
    if (has(name)) return;
    throw std::invalid_argument(fmt::format("--{} '{}': expected one of {}{}", option, shown(name),
                                            joined(columns(), ", "),
                                            suggestion(nearest(name, columns()))));
  }

 private:
  void keep(const std::string& only) {
    const std::size_t equals = only.find('=');
    const std::string key = only.substr(0, equals);
    if (equals == std::string::npos) {
      throw std::invalid_argument(fmt::format("--only '{}': expected key=value", shown(only)));
    }
    require_column("only", key);
    const std::string value = only.substr(equals + 1);
    const auto wanted = number_of(value);
    std::set<std::string> others;
    std::erase_if(rows_, [&](std::size_t row) {
      const std::string found = text(row, key);
      const bool is_same = wanted ? number_of(found) == wanted : found == value;
      if (!is_same) others.insert(found);
      return !is_same;
    });
    if (rows_.empty()) {
      throw std::invalid_argument(fmt::format("--only '{}': expected a value that is there: {}",
                                              shown(only), shown(joined(others, ", "))));
    }
  }

  bool is_curve_;
  WrittenTable written_;
  Names swept_;
  std::vector<std::size_t> rows_;
};

/// The columns and keys by which a sweep is shown.
struct Axes {
  std::string over;
  std::string value;
  Names families;  ///< keys of which each combination is a line
  Names together;  ///< other swept keys of several values, which follow the running one
};

/// The swept key that has most values and is a number, the last of several; else the last one.
std::string running_key(const Cases& cases) {
  if (cases.is_curve()) return cases.along();
  std::string best = cases.swept().back();
  std::size_t most = 1;
  for (const std::string& key : cases.swept()) {
    const std::size_t values = cases.values(key);
    if (values >= most && values > 1 && cases.is_numeric(key)) {
      most = values;
      best = key;
    }
  }
  return best;
}

/// Returns the quantity that the load does not prescribe.
std::string answer(const Cases& cases) {
  if (cases.is_curve()) return cases.along() == "creepage" ? "force" : "lateral_force";
  const auto under_force = [](const std::string& key) {
    return key == "load.force" || key == "load.force_ratio" || key == "load.stick_ratio";
  };
  const bool is_common = std::ranges::any_of(
      cases.parameters(), [&](const auto& parameter) { return under_force(parameter.first); });
  const bool forced = is_common || std::ranges::any_of(cases.swept(), under_force);
  return forced && cases.has("creepage") ? "creepage" : "force";
}

Axes axes_of(const Cases& cases, const SweepView& view) {
  Axes axes{.over = view.over, .value = view.value, .families = {}, .together = {}};
  if (!axes.over.empty()) cases.require_column("over", axes.over);
  if (!axes.value.empty()) cases.require_column("value", axes.value);
  std::string running = running_key(cases);
  if (axes.over.empty()) axes.over = running;
  if (std::ranges::find(cases.swept(), axes.over) != cases.swept().end()) running = axes.over;
  if (axes.value.empty()) axes.value = answer(cases);
  if (!cases.has_numbers(axes.value)) {
    throw std::invalid_argument(fmt::format(
        "--value '{}': expected a column with numbers, of which there are none", axes.value));
  }
  for (const std::string& key : cases.swept()) {
    if (key == running) continue;
    if (!cases.follows(key, running)) {
      axes.families.push_back(key);
    } else if (axes.over == running && cases.values(key) > 1) {
      axes.together.push_back(key);
    }
  }
  if (view.by.empty()) return axes;
  const auto by = std::ranges::find(axes.families, view.by);
  if (by == axes.families.end()) {
    throw std::invalid_argument(
        fmt::format("--by '{}': expected a swept key that has several values{}", shown(view.by),
                    axes.families.empty() ? "" : ", of " + joined(axes.families, ", ")));
  }
  std::rotate(axes.families.begin(), by, by + 1);
  return axes;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit == "1" ? name : fmt::format("{} [{}]", name, unit);
}

/// One combination of values of the families.
struct Family {
  std::string label;   ///< keys and their values
  std::string values;  ///< of the keys, in their order
  std::string first;   ///< value of the first key
  std::vector<std::size_t> rows;
};

/// The values of a key as a legend has them, by their texts: with six digits, unless two values are
/// then the same.
std::map<std::string, std::string> legend_values(const Cases& cases, const std::string& key) {
  std::map<std::string, std::string> values;
  std::set<std::string> different;
  for (const std::size_t row : cases.rows()) {
    const std::string text = cases.text(row, key);
    std::string& value = values[text];
    value = cases.is_numeric(key) ? fmt::format("{:.6g}", cases.number(row, key)) : text;
    different.insert(value);
  }
  if (different.size() < values.size()) {
    for (auto& [text, value] : values) value = text;
  }
  return values;
}

std::vector<Family> families_of(const Cases& cases, const Axes& axes) {
  std::vector<Family> families;
  std::map<std::string, std::size_t> known;
  std::map<std::string, std::map<std::string, std::string>> shown;
  for (const std::string& key : axes.families) shown[key] = legend_values(cases, key);
  for (const std::size_t row : cases.rows()) {
    Family family;
    for (const std::string& key : axes.families) {
      const std::string value = shown[key][cases.text(row, key)];
      const std::string unit = cases.unit(key);
      family.label += fmt::format("{}{} = {}{}", family.label.empty() ? "" : ", ", key, value,
                                  unit == "1" ? "" : " " + unit);
      family.values += fmt::format("{}{}{}", family.values.empty() ? "" : ", ", value,
                                   unit == "1" ? "" : " " + unit);
      if (&key == &axes.families.front()) family.first = value;
    }
    const auto [at, is_new] = known.emplace(family.label, families.size());
    if (is_new) families.push_back(family);
    families[at->second].rows.push_back(row);
  }
  return families;
}

void require_few_lines(std::size_t lines, const Cases& cases, const Axes& axes) {
  if (lines <= most_lines) return;
  const std::string& key = axes.families.back();
  throw std::invalid_argument(
      fmt::format("--only: expected fewer than {} lines, at most {}; one value of a key is shown "
                  "by --only {}={}",
                  lines, most_lines, key, cases.text(cases.rows().front(), key)));
}

/// Places on the horizontal axis: numbers, or for words the order of the rows.
class Places {
 public:
  Places(const Cases& cases, const std::string& over)
      : over_(over), words_(!cases.is_numeric(over)) {
    if (!words_) return;
    for (const std::size_t row : cases.rows()) {
      const std::string word = cases.text(row, over);
      if (std::ranges::find(all_, word) == all_.end()) all_.push_back(word);
    }
  }

  double of(const Cases& cases, std::size_t row) const {
    if (!words_) return cases.number(row, over_);
    const auto found = std::ranges::find(all_, cases.text(row, over_));
    return static_cast<double>(found - all_.begin()) + 1;
  }

  /// As gnuplot wants them; empty for numbers.
  std::string tics() const {
    std::string text;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      std::string word = fitted(all_[k], most_letters);
      std::erase_if(word, [](char c) { return c == '"' || c == '\\'; });
      text += fmt::format("{}\"{}\" {}", k == 0 ? "(" : ", ", word, k + 1);
    }
    if (text.empty()) return "";
    return (height() > 0 ? "rotate by 90 right offset 0,0 " : "") + text + ")";
  }

  /// Pixels that words take below the axis, beyond those of a line: more than none if they stand
  /// upright, because side by side they would overlap.
  std::size_t height() const {
    constexpr std::size_t letter = 9, width = 450;
    std::size_t longest = 0;
    for (const std::string& word : all_) longest = std::max(longest, word.size());
    if ((longest + 1) * letter * all_.size() <= width) return 0;
    return letter * std::min(longest, most_letters);
  }

 private:
  static constexpr std::size_t most_letters = 24;
  std::string over_;
  bool words_;
  Names all_;
};

/// A quantity of Carter's solution of a row; nan if there is none.
double exact_value(const Cases& cases, std::size_t row, const std::string& value) {
  Parameters parameters;
  for (const auto& parameter : cases.parameters()) {
    if (!cases.is_curve() || !parameter.first.starts_with("load.")) parameters.push_back(parameter);
  }
  for (const std::string& key : cases.swept()) {
    parameters.emplace_back(key == cases.along() ? "load." + key : key, cases.text(row, key));
  }
  const auto exact = exact_solution(parameters);
  if (!exact) return NAN;
  return value == "force"      ? exact->force()
         : value == "creepage" ? exact->creepage()
                               : exact->force() / exact->bound().total();
}

bool has_exact(const std::string& value) {
  return value == "force" || value == "creepage" || value == "force_ratio";
}

/// Several lines, and how far they reach.
struct Lines {
  std::vector<Line> lines;
  Table table{"cases",
              "lines of a figure",
              {{"line", "1", "number of the line"}, {"x", "1", "place"}, {"y", "1", "value"}}};
  Extent x, y;
  std::string heading = {};  ///< of the key: names of keys, where labels have no room for them

  template <class Value>
  void add(const Line& line, const Cases& cases, const Family& family, const Places& places,
           Value value) {
    std::vector<std::pair<double, double>> points;
    for (const std::size_t row : family.rows) {
      points.emplace_back(places.of(cases, row), value(row));
    }
    if (std::ranges::none_of(points, [](const auto& p) { return std::isfinite(p.second); })) return;
    lines.push_back(line);
    for (const auto& [place, number] : points) {
      const Cell y_cell = std::isfinite(number) ? Cell(number) : Cell("NaN");  // a gap
      table.add({fmt::format("{}", lines.size()), place, y_cell});
      x.include(place);
      y.include(number);
    }
  }
};

/// Whether numbers want a logarithmic axis.
bool spans(const Extent& extent, double ratio) {
  return extent.least > 0 && extent.most >= ratio * extent.least;
}

/// A law of creep forces beside curves.
struct Law {
  const char* column;  ///< the columns of its resultants begin so
  const char* name;
};

constexpr Law laws[] = {{"fastsim", "FASTSIM"},
                        {"fastsim_one", "FASTSIM, one flexibility"},
                        {"vermeulen_johnson", "Vermeulen-Johnson"},
                        {"polach", "Polach"}};

/// Adds the curves of laws, and says how far off they are, over the largest value that is drawn.
/// \param drawn  lines of the families
void add_laws(Lines& lines, const Cases& cases, const std::vector<Family>& families,
              const std::vector<Line>& drawn, const std::string& value, const Places& places) {
  const bool is_alone = drawn.size() == 1;  // then colours tell the laws apart
  const std::string factor = cases.parameter("curve.kalker_factor", "1");
  const std::string reduced = factor == "1" ? "" : ", coefficients x " + factor;
  std::size_t number = 0;
  for (const auto& [prefix, name] : laws) {
    const std::string column = fmt::format("{}_{}", prefix, value);
    if (!cases.has(column)) continue;
    double most = 0, error = 0;
    for (const std::size_t row : cases.rows()) {
      most = std::max(most, std::abs(cases.number(row, value)));
      error = std::max(error, std::abs(cases.number(row, column) - cases.number(row, value)));
    }
    ++number;
    for (std::size_t k = 0; k < families.size(); ++k) {
      Line line = drawn[k];
      line.label = k == 0 && most > 0 ? fmt::format("{}{}: off by up to {}", name, reduced,
                                                    format_percent(error / most))
                                      : "";
      line.dash = static_cast<int>(number) + 1;
      if (is_alone) line.color = color_of(number, std::size(laws) + 1);
      lines.add(line, cases, families[k], places,
                [&](std::size_t row) { return cases.number(row, column); });
    }
  }
}

void add_lines(Lines& lines, const Result& result, const Cases& cases, const Axes& axes,
               std::size_t of_result, std::size_t results) {
  const std::vector<Family> families = families_of(cases, axes);
  require_few_lines(families.size() * results, cases, axes);
  Names firsts;
  for (const Family& family : families) {
    if (std::ranges::find(firsts, family.first) == firsts.end()) firsts.push_back(family.first);
  }
  std::map<std::string, int> drawn_in;  // colours, how many lines
  const Places places(cases, axes.over);
  const auto number = [&](std::size_t row) { return cases.number(row, axes.value); };
  const bool is_long = std::ranges::any_of(
      families, [](const Family& family) { return family.label.size() > label_letters; });
  const bool has_heading = is_long && results == 1;
  if (has_heading) lines.heading = fitted(joined(axes.families, ", "), heading_letters);
  std::vector<Line> drawn;
  for (const Family& family : families) {
    const auto color =
        static_cast<std::size_t>(std::ranges::find(firsts, family.first) - firsts.begin());
    const std::string label = family.label.empty() ? axes.value
                              : has_heading        ? family.values
                                                   : family.label;
    const std::string drawn_color =
        results > 1 ? color_of(of_result, results) : color_of(color, firsts.size());
    const Line line{.label = results > 1 ? fmt::format("{}: {}", result.name, label) : label,
                    .color = drawn_color,
                    .dash = ++drawn_in[drawn_color]};
    lines.add(line, cases, family, places, number);
    drawn.push_back(line);
  }
  add_laws(lines, cases, families, drawn, axes.value, places);
  if (!has_exact(axes.value)) return;
  bool is_first = true;
  for (const Family& family : families) {
    const std::size_t before = lines.lines.size();
    lines.add({is_first ? "Carter, exact" : "", black, 1, true}, cases, family, places,
              [&](std::size_t row) { return exact_value(cases, row, axes.value); });
    is_first = is_first && lines.lines.size() == before;
  }
}

}  // namespace

Drawing drawing_of_sweeps(const std::vector<Result>& results, const SweepView& view) {
  const std::string& kind = results.front().kind;
  Lines lines;
  Drawing drawing{.kind = kind};
  SweepView common = view;
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (results[k].kind != kind) throw_other_kind(results[k], results.front());
    const Cases cases(results[k], view.only);
    const Axes axes = axes_of(cases, common);
    common.over = axes.over;  // of all others, too
    common.value = axes.value;
    add_lines(lines, results[k], cases, axes, k, results.size());
    if (k > 0) continue;
    const Places places(cases, axes.over);
    drawing.unit = cases.unit(axes.over);
    const std::string others =
        axes.together.empty() ? "" : ", with its own " + joined(axes.together, ", ");
    drawing.axes = {{"x_label", fitted(with_unit(axes.over, drawing.unit) + others, most_letters)},
                    {"y_label", with_unit(axes.value, cases.unit(axes.value))},
                    {"x_tic_height", fmt::format("{}", places.height())},
                    {"x_tics", places.tics()}};
  }
  constexpr double wide = 30, very_wide = 1000;
  const bool has_words = !drawing.axes.back().second.empty();
  drawing.axes.emplace_back("x_log", !has_words && spans(lines.x, wide) ? "1" : "0");
  drawing.axes.emplace_back("key_heading", lines.heading);
  drawing.axes.emplace_back("y_log", spans(lines.y, very_wide) ? "1" : "0");
  drawing.lines = lines.lines;
  drawing.tables.push_back(lines.table);
  drawing.horizontal = lines.x;
  return drawing;
}

}  // namespace microslip::program
