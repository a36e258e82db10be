// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "command_line.hpp"
#include "microslip/support/checksum.hpp"
#include "microslip/support/text.hpp"
#include "sweep_plan.hpp"

namespace microslip::program {

namespace {

namespace fs = std::filesystem;

constexpr const char* plan_name = "plan.tsv";

/// How the line of a text begins in which it differs from another one.
std::string first_difference(const std::string& text, const std::string& other) {
  std::istringstream in(text);
  std::istringstream in_other(other);
  std::string line, other_line;
  while (line == other_line && std::getline(in, line)) {
    if (!std::getline(in_other, other_line)) other_line.clear();
  }
  std::replace(line.begin(), line.end(), '\t', ' ');
  return line.substr(0, 80);
}

std::string status_in(const WrittenTable& row) {
  return std::get<std::string>(row.table.at(0, "status"));
}

/// Adds the columns that are not known yet, each behind the one that precedes it.
void add_columns(std::vector<Column>& known, const std::vector<Column>& columns) {
  auto before = known.begin();
  for (const Column& column : columns) {
    auto found = std::ranges::find(known, column.name, &Column::name);
    if (found == known.end()) found = known.insert(before, column);
    before = found + 1;
  }
}

/// Returns a row's cells in some columns, which the table may lack.
std::vector<Cell> cells_in(const Table& table, std::size_t row,
                           const std::vector<Column>& columns) {
  std::vector<Cell> cells;
  for (const Column& column : columns) {
    cells.push_back(table.has(column.name) ? table.at(row, column.name) : Cell("nan"));
  }
  return cells;
}

}  // namespace

SweepFolder::SweepFolder(fs::path path, std::string program, WrittenTable plan,
                         const std::string& plan_text)
    : path_(std::move(path)),
      program_(std::move(program)),
      plan_(std::move(plan.table)),
      common_(std::move(plan.parameters)),
      checksum_(checksum(plan_text)) {}

SweepFolder SweepFolder::begin(const fs::path& path, const std::string& program, const Table& plan,
                               const Parameters& common) {
  const OutputFile file = output_of(plan, program, common);
  if (!fs::exists(path / plan_name)) write_files(path, {file});
  // Read back, as the shard of another sweep may have been faster.
  const std::string there = file_text(path / plan_name);
  if (there != file.content) {
    throw std::invalid_argument(fmt::format(
        "--out {}: holds another sweep; its {} has '{}', not '{}'", path.string(), plan_name,
        first_difference(there, file.content), first_difference(file.content, there)));
  }
  return {path, program, {plan, common}, file.content};
}

SweepFolder SweepFolder::open(const fs::path& path, const std::string& program) {
  if (!fs::exists(path / plan_name)) {
    throw std::invalid_argument(
        fmt::format("--out {}: expected a sweep; there is no {}", path.string(), plan_name));
  }
  const std::string text = file_text(path / plan_name);
  try {
    return {path, program, read_table("plan", text), text};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", (path / plan_name).string(), error.what()));
  }
}

std::string SweepFolder::name_of(std::size_t index) const {
  return fmt::format("{:0{}}", index + 1, std::to_string(plan_.rows()).size());
}

fs::path SweepFolder::file_of(std::size_t index) const {
  return folder_of(index).replace_extension(".tsv");
}

fs::path SweepFolder::folder_of(std::size_t index) const {
  return path_ / "cases" / name_of(index);
}

Parameters SweepFolder::head_of(std::size_t index, const Parameters& parameters) const {
  Parameters head{{"case", fmt::format("{} of {}", index + 1, plan_.rows())}, {"sweep", checksum_}};
  head.insert(head.end(), parameters.begin(), parameters.end());
  return head;
}

Table SweepFolder::row_of(std::size_t index, const CaseResult& result) const {
  std::vector<Column> columns = plan_.columns();
  std::vector<Cell> cells = cells_in(plan_, index, columns);
  for (const Table& table : result.tables) {
    if (table.name() != "summary") continue;
    for (std::size_t i = 0; i < table.rows(); ++i) {
      columns.push_back({std::get<std::string>(table.at(i, "quantity")),
                         std::get<std::string>(table.at(i, "unit")), "of the case's summary",
                         table.rounding(i, "value")});
      cells.push_back(table.at(i, "value"));
    }
  }
  columns.push_back({"status", "1", "ok, or why there is no solution"});
  cells.emplace_back(result.status);
  Table row(name_of(index), "a case of a sweep", columns);
  row.add(cells);
  return row;
}

std::optional<WrittenTable> SweepFolder::read(std::size_t index) const {
  const fs::path file = file_of(index);
  if (!fs::exists(file)) return std::nullopt;
  try {
    WrittenTable row = read_table(name_of(index), file_text(file));
    if (row.table.rows() == 1 && row.table.columns().back().name == "status") return row;
  } catch (const std::invalid_argument&) {  // damaged, which is as good as missing
  }
  return std::nullopt;
}

std::optional<std::string> SweepFolder::finished(std::size_t index, const Parameters& parameters,
                                                 bool with_tables) const {
  const auto row = read(index);
  if (!row) return std::nullopt;
  if (row->parameters != head_of(index, parameters)) {
    throw std::invalid_argument(file_of(index).string() +
                                ": not a case of this sweep; remove it, or take another --out");
  }
  const std::string status = status_in(*row);
  if (with_tables && status == "ok" && !fs::exists(folder_of(index))) return std::nullopt;
  return status;
}

void SweepFolder::finish(std::size_t index, const Parameters& parameters, const CaseResult& result,
                         bool with_tables) const {
  const Parameters head = head_of(index, parameters);
  if (with_tables && !result.tables.empty()) {
    std::vector<OutputFile> files;
    for (const Table& table : result.tables) files.push_back(output_of(table, program_, head));
    write_folder(folder_of(index), files);
  }
  write_files(folder_of(index).parent_path(), {output_of(row_of(index, result), program_, head)});
}

std::vector<WrittenTable> SweepFolder::rows() const {
  std::vector<WrittenTable> rows;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < plan_.rows(); ++i) {
    auto row = read(i);
    if (!row) {
      missing.push_back(i);
      continue;
    }
    const Parameters head = head_of(i, {});
    const Parameters& there = row->parameters;
    if (std::mismatch(head.begin(), head.end(), there.begin(), there.end()).first != head.end()) {
      throw std::invalid_argument(file_of(i).string() + ": not a case of this sweep; remove it");
    }
    rows.push_back(std::move(*row));
  }
  if (!missing.empty()) {
    throw std::invalid_argument(fmt::format("{}: {} of {} cases are missing, the first is {}",
                                            path_.string(), missing.size(), plan_.rows(),
                                            case_label(plan_, missing.front())));
  }
  return rows;
}

MergedSweep SweepFolder::merged() const {
  const std::vector<WrittenTable> all = rows();
  std::vector<Column> columns;
  for (const WrittenTable& row : all) add_columns(columns, row.table.columns());
  MergedSweep merged{
      .table = {"sweep", "all cases of a sweep; the last key varies fastest", columns},
      .parameters = common_,
      .statuses = {}};
  for (const WrittenTable& row : all) {
    merged.table.add(cells_in(row.table, 0, columns));
    merged.statuses.push_back(status_in(row));
  }
  return merged;
}

}  // namespace microslip::program
