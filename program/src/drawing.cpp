// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "microslip/scene/text.hpp"
#include "microslip/scene/units.hpp"
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
}

std::string color_of(std::size_t i, std::size_t count) {
  constexpr std::array<const char*, 6> few{"#0072b2", "#d55e00", "#009e73",
                                           "#cc79a7", "#e69f00", "#56b4e9"};  // Okabe and Ito
  if (count <= few.size()) return few[i];
  return on_scale(static_cast<double>(i) / static_cast<double>(count - 1));
}

void write_drawing(const Drawing& drawing, const fs::path& folder) {
  std::vector<OutputFile> files{output_of(list_of(drawing.lines), "figure", drawing.axes)};
  for (const Table& table : drawing.tables) {
    files.push_back(output_of(table, "figure", drawing.axes));
  }
  write_files(folder, files);
}

}  // namespace microslip::program
