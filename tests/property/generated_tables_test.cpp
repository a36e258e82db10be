// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as people export them, from known numbers: they are read as these numbers, or refused in
// one line. Whatever makes a table doubtful allows the refusal; all others are read.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "microslip/support/text.hpp"
#include "scene_text.hpp"

namespace microslip::generated_tables_test {

struct Unit {
  std::string text;
  double size;  ///< in the unit of the column
};

struct Quantity {
  FileColumn column;
  double largest;
  std::vector<Unit> units;
};

const std::vector<Quantity> quantities_of_runs = {
    {{"q", "mm", false}, 3000, {{"", 1}, {"mm", 1}, {"m", 1000}, {"cm", 10}, {"um", 1e-3}}},
    {{"creepage", "1", false}, 0.02, {{"", 1}, {"-", 1}, {"%", 0.01}, {"\u2030", 1e-3}, {"1", 1}}},
    {{"force", "N/mm", false}, 2000, {{"", 1}, {"N/mm", 1}, {"kN/m", 1}, {"N / m", 1e-3}}},
    {{"omega", "rad/s", false}, 400, {{"", 1}, {"rad/s", 1}, {"rpm", 0.10471975511965978}}}};

/// A table of known numbers in one of the ways of writing it.
class Export {
 public:
  explicit Export(unsigned seed) : random_(seed) { make(); }

  std::string text;
  std::vector<FileColumn> wanted;
  std::vector<std::vector<double>> values;  ///< of the wanted columns, in their units
  bool may_be_refused = false;

 private:
  bool chance(double part) { return std::uniform_real_distribution<>(0, 1)(random_) < part; }
  std::size_t index(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  template <class Items>
  auto one_of(const Items& items) {
    return items[index(items.size())];
  }

  bool splits_at_blanks() const { return separator_.find_first_not_of(' ') == std::string::npos; }

  /// Thousands between the digits before the decimal mark.
  std::string with_thousands(std::string number) {
    const std::string mark = decimal_ == ',' ? one_of(std::vector<std::string>{".", " ", "\u202f"})
                                             : one_of(std::vector<std::string>{",", "'", " "});
    const std::size_t begin = number.find_first_of("123456789");
    std::size_t at = std::min(number.size(), number.find_first_of(".,eE"));
    while (begin != std::string::npos && at > begin + 3) number.insert(at -= 3, mark);
    return number;
  }

  std::string written(double value) {
    std::string number = fmt::format(fmt::runtime(format_), value);
    if (std::abs(value) >= 1000 && has_thousands_) {
      number = with_thousands(number);
      may_be_refused = true;
    }
    const std::size_t point = number.rfind('.');
    if (decimal_ == ',' && point != std::string::npos && !has_thousands_) number[point] = ',';
    if (decimal_ == ',' && has_thousands_ && std::abs(value) < 1000) {
      std::ranges::replace(number, '.', ',');
    }
    const std::size_t comma = number.find(',');
    if (comma != std::string::npos) {
      has_comma_ = true;
      const std::size_t end = number.find_first_not_of("0123456789", comma + 1);
      is_clear_ = is_clear_ || std::min(end, number.size()) != comma + 4;
    }
    const bool needs_quotes = number.find(separator_.front()) != std::string::npos ||
                              (splits_at_blanks() && number.find(' ') != std::string::npos);
    return needs_quotes || quotes_all_ ? '"' + number + '"' : number;
  }

  std::string name_of(const std::string& name, const std::string& unit) {
    std::string cell = name;
    if (!unit.empty()) {
      const bool in_brackets = chance(0.6);
      const std::string blank = chance(0.3) ? "" : chance(0.2) ? "\u00a0" : " ";
      cell += blank + (in_brackets ? "[" : "(") + unit + (in_brackets ? "]" : ")");
    }
    return quotes_all_ || (chance(0.1) && !splits_at_blanks()) ? '"' + cell + '"' : cell;
  }

  std::string joined_cells(std::vector<std::string> cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : separator_) + cells[i];
    return line;
  }

  void make() {
    separator_ = one_of(std::vector<std::string>{",", ";", "\t", " ", "   ", "; ", ", "});
    decimal_ = chance(0.4) ? ',' : '.';
    quotes_all_ = chance(0.15);
    has_thousands_ = chance(0.1);
    format_ = one_of(std::vector<std::string>{"{:.17g}", "{:.6f}", "{:.4e}", "{:.8E}", "{:+.7g}",
                                              "{:.0f}", "{:.3f}", "{:.2f}", "{:g}"});
    if (splits_at_blanks() && quotes_all_) may_be_refused = true;
    const std::string end = chance(0.4) ? "\r\n" : "\n";
    const bool has_end = separator_ != " " && separator_ != "   " && chance(0.2);
    const std::string trailing = has_end ? separator_ + (chance(0.5) ? separator_ : "") : "";
    const bool has_index = !splits_at_blanks() && chance(0.15);
    const bool has_other = chance(0.4);

    std::vector<Quantity> chosen = quantities_of_runs;
    std::ranges::shuffle(chosen, random_);
    chosen.erase(chosen.begin() + 2 + static_cast<std::ptrdiff_t>(index(3)), chosen.end());
    std::vector<std::string> names;
    std::vector<double> sizes;
    if (has_index) names.emplace_back();
    for (const Quantity& quantity : chosen) {
      const Unit unit = one_of(quantity.units);
      names.push_back(name_of(quantity.column.name, unit.text));
      sizes.push_back(unit.size);
      wanted.push_back(quantity.column);
    }
    if (has_other) names.emplace_back(splits_at_blanks() ? "_note" : "\"_note, long; of\trows\"");
    values.resize(chosen.size());

    if (chance(0.2)) text += "\xEF\xBB\xBF";
    if (chance(0.3)) text += "# exported, by: a program" + end;
    if (chance(0.1) && separator_ == ";") text += "sep=;" + end;
    text += joined_cells(names) + (has_end && chance(0.7) ? trailing : "") + end;
    const std::size_t rows = 1 + index(30);
    for (std::size_t i = 0; i < rows; ++i) {
      std::vector<std::string> cells;
      if (has_index) cells.push_back(std::to_string(i));
      for (std::size_t k = 0; k < chosen.size(); ++k) {
        const double value =
            chosen[k].largest / sizes[k] * std::uniform_real_distribution<>(-1, 1)(random_);
        const std::string number = fmt::format(fmt::runtime(format_), value);
        values[k].push_back(std::stod(number) * sizes[k]);
        cells.push_back(written(std::stod(number)));
      }
      if (has_other) cells.emplace_back(splits_at_blanks() ? "7,5" : "\"1,2; x\ty\"");
      text += joined_cells(cells) + (chance(0.9) ? trailing : "") + end;
      if (chance(0.03)) text += "# a remark" + end;
      if (chance(0.03)) text += end;
      if (chance(0.03) && !splits_at_blanks()) text += separator_ + separator_ + end;
    }
    if (has_comma_ && !is_clear_) may_be_refused = true;  // 1,234 may be 1234
    if (chance(0.2)) text.resize(text.size() - end.size());
    if (chance(0.05)) damage();
  }

  /// Another character in the place of a digit of the last row.
  void damage() {
    const std::size_t at = text.find_last_of("0123456789");
    text[at] = chance(0.5) ? 'x' : ' ';
    may_be_refused = true;
    is_damaged_ = true;
  }

  std::mt19937 random_;
  std::string separator_, format_;
  char decimal_ = '.';
  bool quotes_all_ = false, has_thousands_ = false, is_damaged_ = false;
  bool has_comma_ = false, is_clear_ = false;

 public:
  /// Whether there is no telling the numbers: another digit, or 1.234 for 1234 with nothing that
  /// says so, which is read with a decimal point.
  bool has_other_numbers() const {
    return is_damaged_ || (has_thousands_ && decimal_ == ',' && !has_comma_);
  }
};

struct Answer {
  std::vector<std::optional<Eigen::VectorXd>> columns;
  std::string refusal;
};

Answer read(const Export& table) {
  Answer answer;
  answer.refusal = message([&] {
    Scene scene = scene_of("load { file table }");
    scene.read_files_by([&](const std::string&) { return plain_text(table.text); });
    answer.columns =
        scene.from_columns("load.file", table.wanted, [](const auto& found) { return found; });
  });
  return answer;
}

/// Whether all numbers are those of the table.
bool is_right(const Export& table, const Answer& answer) {
  for (std::size_t k = 0; k < table.wanted.size(); ++k) {
    const auto& found = answer.columns[k];
    if (!found || static_cast<std::size_t>(found->size()) != table.values[k].size()) return false;
    for (std::size_t i = 0; i < table.values[k].size(); ++i) {
      const double expected = table.values[k][i];
      const double difference = (*found)[static_cast<Eigen::Index>(i)] - expected;
      if (std::abs(difference) > 1e-14 * std::abs(expected)) return false;
    }
  }
  return true;
}

TEST(GeneratedTables, AreReadAsTheirNumbersOrRefused) {
  constexpr unsigned tables = 20000;
  unsigned refused = 0, needless = 0, wrong = 0, doubtful = 0;
  for (unsigned seed = 0; seed < tables; ++seed) {
    const Export table(seed);
    const Answer answer = read(table);
    doubtful += table.may_be_refused ? 1 : 0;
    if (!answer.refusal.empty()) {
      ++refused;
      EXPECT_EQ(answer.refusal.find('\n'), std::string::npos) << answer.refusal;
      if (table.may_be_refused) continue;
      if (++needless <= 3) ADD_FAILURE() << seed << ": " << answer.refusal << "\n" << table.text;
      continue;
    }
    if (table.has_other_numbers() || is_right(table, answer)) continue;
    if (++wrong <= 3) ADD_FAILURE() << seed << ": read as other numbers\n" << table.text;
  }
  std::cout << fmt::format("{} tables, {} of them doubtful: {} refused, {} needlessly, {} wrong\n",
                           tables, doubtful, refused, needless, wrong);
  EXPECT_GT(tables - refused, tables / 2);
}

}  // namespace microslip::generated_tables_test
