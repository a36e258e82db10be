// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>

#include "microslip/scene/units.hpp"
#include "microslip/support/text.hpp"
#include "outputs.hpp"

namespace microslip::program {

namespace {

namespace fs = std::filesystem;

using Rgb = std::array<int, 3>;  // 0 to 255

/// From dark to light; the lightest still shows on white.
std::string on_scale(double part) {
  constexpr std::array<Rgb, 5> stops{
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {214, 186, 0}}};
  const double place = part * static_cast<double>(stops.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  std::string mixed = "#";
  for (std::size_t i = 0; i < stops[k].size(); ++i) {
    const double between = place - static_cast<double>(k);
    mixed += fmt::format("{:02x}", std::lround(std::lerp(stops[k][i], stops[k + 1][i], between)));
  }
  return mixed;
}

/// The byte at which a letter begins, at or before a place.
std::size_t letter_at(const std::string& text, std::size_t place) {
  const auto is_inside = [&] { return (static_cast<unsigned char>(text[place]) & 0xc0U) == 0x80U; };
  while (place > 0 && place < text.size() && is_inside()) --place;
  return place;
}

/// The length of what all texts begin with, up to the begin of a word or folder.
std::size_t common_begin(const std::vector<std::string>& texts) {
  std::size_t length = texts.front().size();
  for (const std::string& text : texts) {
    const auto ends = std::ranges::mismatch(texts.front(), text);
    length = std::min(length, static_cast<std::size_t>(ends.in1 - texts.front().begin()));
  }
  const std::size_t end = texts.front().substr(0, length).find_last_of(" /");
  return end == std::string::npos ? 0 : end + 1;
}

/// Labels that have room: those of results without the folders that all have in common, if one of
/// them is too long, and then without its middle. Labels that have become the same have numbers.
void fit_labels(std::vector<Line>& lines) {
  std::vector<std::string> named;
  bool is_long = false;
  for (const Line& line : lines) {
    if (line.label.empty() || line.is_exact) continue;
    named.push_back(line.label);
    is_long = is_long || line.label.size() > label_letters;
  }
  if (!is_long) return;
  const std::size_t common = named.size() > 1 ? common_begin(named) : 0;
  std::map<std::string, int> found;
  for (Line& line : lines) {
    if (line.label.size() <= common || line.is_exact) continue;
    const std::string rest = common > 3 ? "…" + line.label.substr(common) : line.label;
    line.label = fitted(rest, label_letters);
    if (const int number = ++found[line.label]; number > 1) {
      line.label = fitted(fmt::format("{}: {}", number, line.label), label_letters);
    }
  }
}

Table list_of(const std::vector<Line>& lines) {
  Table table("lines", "lines of a figure",
              {{"line", "1", "number"},
               {"color", "1", "of the line"},
               {"dash", "1", "type of dashes"},
               {"exact", "1", "whether it is an exact solution"},
               {"label", "1", "for the key"}});
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Line& line = lines[k];
    table.add({fmt::format("{}", k + 1), line.color, fmt::format("{}", line.dash),
               line.is_exact ? "1" : "0", line.label});
  }
  return table;
}

}  // namespace

Table without_rounding(Table table, const std::vector<std::string>& columns) {
  for (const std::string& column : columns) {
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const auto value = number_of(table.at(i, column));
      if (value && std::abs(*value) <= table.rounding(i, column)) table.put(i, column, "0");
    }
  }
  return table;
}

WrittenTable table_in(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / (name + ".tsv");
  try {
    return read_table(name, file_text(file));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", shown(file.string()), error.what()));
  }
}

std::optional<double> number_of(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return quantity(std::get<std::string>(cell), "1");
}

void throw_other_kind(const Result& result, const Result& first) {
  throw std::invalid_argument(fmt::format("'{}': expected a result of the kind of '{}', {}, not {}",
                                          shown(result.name), shown(first.name), first.kind,
                                          result.kind));
}

void Extent::include(double value) {
  if (!std::isfinite(value)) return;
  least = std::min(least, value);
  most = std::max(most, value);
  values.insert(value);
}

std::size_t Extent::count(double from, double to) const {
  return static_cast<std::size_t>(std::distance(values.lower_bound(from), values.upper_bound(to)));
}

std::string color_of(std::size_t i, std::size_t count) {
  constexpr std::array<const char*, 6> few{"#0072b2", "#d55e00", "#009e73",
                                           "#cc79a7", "#e69f00", "#56b4e9"};  // Okabe and Ito
  if (count <= few.size()) return few[i];
  return on_scale(static_cast<double>(i) / static_cast<double>(count - 1));
}

std::string fitted(const std::string& text, std::size_t letters) {
  if (text.size() <= letters) return text;
  const std::size_t begin = letter_at(text, letters / 3);
  const std::size_t end = letter_at(text, text.size() - (letters - letters / 3 - 1));
  return text.substr(0, begin) + "…" + text.substr(end);
}

void write_drawing(const Drawing& drawing, const fs::path& folder) {
  std::vector<Line> lines = drawing.lines;
  fit_labels(lines);
  std::vector<OutputFile> files{output_of(list_of(lines), "figure", drawing.axes)};
  for (const Table& table : drawing.tables) {
    files.push_back(output_of(table, "figure", drawing.axes));
  }
  write_files(folder, files);
}

}  // namespace microslip::program
