// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cctype>
#include <string>
#include <string_view>

#include "columns.hpp"
#include "microslip/scene/units.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"
#include "number.hpp"

namespace microslip {

namespace {

constexpr const char* columns_key = "load.columns";

const std::vector<FileColumn> all_columns = {{"q", "mm", false},
                                             {"t", "s", false},
                                             {"v", "mm/s", false},
                                             {"creepage", "1", false},
                                             {"force", "N/mm", false},
                                             {"omega", "rad/s", false},
                                             {"normal_load", "N/mm", false},
                                             {"half_width", "mm", false},
                                             {"peak_traction", "N/mm^2", false},
                                             {"friction", "1", false}};

/// The same of a patch, with the other components.
std::vector<FileColumn> columns_of_patches() {
  std::vector<FileColumn> columns = all_columns;
  for (FileColumn& column : columns) {
    if (column.name == "force" || column.name == "normal_load") column.unit = "N";
  }
  columns.insert(columns.end(), {{"lateral_creepage", "1", false},
                                 {"lateral_force", "N", false},
                                 {"spin", "1/mm", false},
                                 {"spin_moment", "N mm", false}});
  return columns;
}

/// One of the columns, "t = Time": the unit of the file's name is the file's if it has none.
void take_name(Scene& scene, std::vector<FileColumn>& columns, const std::string& part) {
  const std::string& text = scene.text(columns_key);
  const auto fail = [&](const std::string& expected) { reject(columns_key, text, expected); };
  const std::size_t equals = part.find('=');
  std::string name = part.substr(0, equals);
  std::string in_file = equals == std::string::npos ? "" : part.substr(equals + 1);
  boost::algorithm::trim(name);
  boost::algorithm::trim(in_file);
  const auto found = std::ranges::find(columns, name, &FileColumn::name);
  if (in_file.empty()) fail("NAME = NAME IN THE FILE, with commas between them");
  if (found == columns.end()) {
    fail(fmt::format("one of {} before =, not {}{}", joined(names_of(columns), ", "), shown(name),
                     suggestion(nearest(name, names_of(columns)))));
  }
  const auto [plain, unit] = name_with_unit(in_file);
  const bool is_taken = std::ranges::find(columns, plain, &FileColumn::in_file) != columns.end();
  if (is_taken || !found->in_file.empty()) {
    fail(fmt::format("each column once, not {} twice", shown(is_taken ? plain : name)));
  }
  found->in_file = plain;
  found->unit_without = unit;
}

/// Words of a name, in small letters with single blanks between and around them.
std::string words_in(const std::string& name) {
  std::string words = " ";
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) != 0) {
      words += static_cast<char>(std::tolower(byte));
    } else if (words.back() != ' ') {
      words += ' ';
    }
  }
  return words.back() == ' ' ? words : words + ' ';
}

struct Synonym {
  std::string_view words;
  std::string_view column;
};

/// Names that people give to columns of measured runs; the first that fits counts.
constexpr Synonym synonyms[] = {{"angular velocity", "omega"},
                                {"angular speed", "omega"},
                                {"rotational speed", "omega"},
                                {"rotation", "omega"},
                                {"rpm", "omega"},
                                {"omega", "omega"},
                                {"winkelgeschwindigkeit", "omega"},
                                {"drehzahl", "omega"},
                                {"w", "omega"},
                                {"normal load", "normal_load"},
                                {"normal force", "normal_load"},
                                {"vertical load", "normal_load"},
                                {"vertical force", "normal_load"},
                                {"wheel load", "normal_load"},
                                {"axle load", "normal_load"},
                                {"radlast", "normal_load"},
                                {"fz", "normal_load"},
                                {"fn", "normal_load"},
                                {"half width", "half_width"},
                                {"peak traction", "peak_traction"},
                                {"friction", "friction"},
                                {"mu", "friction"},
                                {"lateral slip", "lateral_creepage"},
                                {"lateral creep", "lateral_creepage"},
                                {"lateral creepage", "lateral_creepage"},
                                {"querschlupf", "lateral_creepage"},
                                {"lateral force", "lateral_force"},
                                {"querkraft", "lateral_force"},
                                {"fy", "lateral_force"},
                                {"spin moment", "spin_moment"},
                                {"mz", "spin_moment"},
                                {"spin", "spin"},
                                {"bohrschlupf", "spin"},
                                {"slip", "creepage"},
                                {"creep", "creepage"},
                                {"creepage", "creepage"},
                                {"schlupf", "creepage"},
                                {"slipratio", "creepage"},
                                {"time", "t"},
                                {"zeit", "t"},
                                {"tijd", "t"},
                                {"temps", "t"},
                                {"timestamp", "t"},
                                {"t", "t"},
                                {"speed", "v"},
                                {"velocity", "v"},
                                {"geschwindigkeit", "v"},
                                {"snelheid", "v"},
                                {"vel", "v"},
                                {"v", "v"},
                                {"distance", "q"},
                                {"position", "q"},
                                {"weg", "q"},
                                {"chainage", "q"},
                                {"s", "q"},
                                {"q", "q"},
                                {"fx", "force"},
                                {"force", "force"},
                                {"kraft", "force"}};

std::string likely_column(const std::string& name, const std::vector<FileColumn>& wanted) {
  const std::string words = words_in(name);
  for (const auto& [meant, column] : synonyms) {
    if (std::ranges::find(wanted, column, &FileColumn::name) == wanted.end()) continue;
    if (words.find(fmt::format(" {} ", meant)) != std::string::npos) return std::string(column);
  }
  return "";
}

/// Which names may be meant for columns that are not found, as load.columns has them: "t = Time".
std::vector<std::string> likely_columns(const std::vector<std::string>& names,
                                        const std::vector<FileColumn>& wanted) {
  std::vector<std::string> likely, taken;
  for (const FileColumn& column : wanted) {
    if (std::ranges::find(names, column.name) != names.end()) taken.push_back(column.name);
  }
  for (const std::string& name : names) {
    const std::string column = likely_column(name, wanted);
    if (column.empty() || std::ranges::find(taken, column) != taken.end()) continue;
    if (name.find_first_of(",=\"") != std::string::npos) continue;
    taken.push_back(column);
    likely.push_back(fmt::format("{} = {}", column, name));
  }
  return likely;
}

/// Fails with the names that the file has, and says which of them may be meant.
[[noreturn]] void fail_with_names(Scene& scene, const std::vector<FileColumn>& wanted,
                                  const std::string& expected) {
  const std::vector<std::string> names = scene.column_names("load.file");
  const auto is_number = [](const std::string& name) { return finite_number(name).has_value(); };
  if (std::ranges::all_of(names, is_number)) {
    throw std::invalid_argument(fmt::format(
        "expected names of columns in the first line that does not begin with #, found numbers: {}",
        shown(joined(names, ", "))));
  }
  const std::vector<std::string> likely = likely_columns(names, wanted);
  const std::string advice = likely.empty()
                                 ? ""
                                 : fmt::format("; {} \"{}\" names what may be meant", columns_key,
                                               shown(joined(likely, ", "), 300));
  throw std::invalid_argument(fmt::format("columns: expected {}; found {}{}", expected,
                                          shown(joined(names, ", ")), advice));
}

}  // namespace

std::vector<FileColumn> run_columns(Scene& scene) {
  std::vector<FileColumn> columns = scene.has_patch() ? columns_of_patches() : all_columns;
  if (!scene.has(columns_key)) return columns;
  const std::string text = scene.free_text(columns_key);
  std::vector<std::string> parts;
  boost::algorithm::split(parts, text, boost::algorithm::is_any_of(","));
  for (const std::string& part : parts) take_name(scene, columns, part);
  return columns;
}

namespace {

/// The names of columns that a file has.
class FoundColumns {
 public:
  FoundColumns(const std::vector<FileColumn>& wanted,
               const std::vector<std::optional<Eigen::VectorXd>>& found) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (found[i]) names_.push_back(wanted[i].name);
    }
  }

  bool has(std::string_view name) const { return std::ranges::find(names_, name) != names_.end(); }

  int count(const std::vector<std::string>& names) const {
    return static_cast<int>(
        std::ranges::count_if(names, [&](const auto& one) { return has(one); }));
  }

 private:
  std::vector<std::string> names_;
};

void require_places(Scene& scene, const std::vector<FileColumn>& wanted,
                    const FoundColumns& found) {
  if (found.has("q") == found.has("t")) fail_with_names(scene, wanted, "either q or t");
}

void require_speeds(Scene& scene, const std::vector<FileColumn>& wanted,
                    const FoundColumns& found) {
  if (found.has("t") != found.has("v")) {
    fail_with_names(scene, wanted, "v where there is t, and only there");
  }
}

}  // namespace

void require_run(Scene& scene, const std::vector<FileColumn>& wanted,
                 const std::vector<std::optional<Eigen::VectorXd>>& columns) {
  const FoundColumns found(wanted, columns);
  require_places(scene, wanted, found);
  if (found.count({"creepage", "force", "omega"}) != 1) {
    fail_with_names(scene, wanted, "one of creepage, force and omega");
  }
  require_speeds(scene, wanted, found);
}

void require_patch_run(Scene& scene, const std::vector<FileColumn>& wanted,
                       const std::vector<std::optional<Eigen::VectorXd>>& columns) {
  const FoundColumns found(wanted, columns);
  require_places(scene, wanted, found);
  int components = 0;
  for (const std::vector<std::string>& component :
       {std::vector<std::string>{"creepage", "force", "omega"},
        {"lateral_creepage", "lateral_force"},
        {"spin", "spin_moment"}}) {
    const int count = found.count(component);
    if (count > 1) fail_with_names(scene, wanted, "only one of " + joined(component, ", "));
    components += count;
  }
  if (components == 0) {
    fail_with_names(scene, wanted,
                    "creepage, force, omega, lateral_creepage, lateral_force, spin or spin_moment");
  }
  require_speeds(scene, wanted, found);
}

}  // namespace microslip
