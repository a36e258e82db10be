// SPDX-License-Identifier: GPL-3.0-or-later
#include "joined_sweep.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "microslip/support/not_converged_at.hpp"
#include "sweep_plan.hpp"

namespace microslip::program {

namespace {

/// Columns of a table of all cases.
std::vector<Column> joined_columns(const Table& plan, const Table& table) {
  std::vector<Column> columns(plan.columns().begin() + 1, plan.columns().end());
  columns.insert(columns.end(), table.columns().begin(), table.columns().end());
  return columns;
}

/// Adds the rows of a case, behind its swept values.
void append(Table& joined, const Table& plan, std::size_t index, const Table& table) {
  if (joined.columns().size() + 1 != plan.columns().size() + table.columns().size()) {
    throw std::invalid_argument(
        fmt::format("{}: expected the same columns of {} as in the first case",
                    case_label(plan, index), table.name()));
  }
  for (std::size_t i = 0; i < table.rows(); ++i) {
    std::vector<Cell> row;
    for (std::size_t k = 1; k < plan.columns().size(); ++k) {
      row.push_back(plan.at(index, plan.columns()[k].name));
    }
    std::optional<Rounding> rounding;
    for (const Column& column : table.columns()) {
      row.push_back(table.at(i, column.name));
      const double bound = table.rounding(i, column.name);
      if (bound > column.rounding) rounding = Rounding{column.name, bound};
    }
    rounding ? joined.add(row, *rounding) : joined.add(row);
  }
}

std::vector<Table> tables_of(const SweepPlan& plan, const Progress& progress) {
  std::vector<Table> joined;
  const std::size_t cases = plan.cases.size();
  for (std::size_t index = 0; index < cases; ++index) {
    const auto in_case = [&](std::size_t done, std::size_t total) {
      progress(index * total + done, cases * total);
    };
    std::vector<Table> tables;
    try {
      tables = with_keys([&] { return plan.cases[index].work(in_case); });
    } catch (const NotConverged& error) {
      throw NotConvergedAt(case_label(plan.table, index), error);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(
          fmt::format("{}: {}", case_label(plan.table, index), error.what()));
    }
    for (std::size_t k = 0; k < tables.size(); ++k) {
      const Table& table = tables[k];
      if (index == 0) {
        joined.emplace_back(table.name(), "all cases of a sweep",
                            joined_columns(plan.table, table));
      }
      append(joined.at(k), plan.table, index, table);
    }
  }
  return joined;
}

}  // namespace

bool has_sweep(const Scene& scene) {
  const std::vector<std::string> keys = scene.keys();
  return std::ranges::any_of(keys,
                             [](const std::string& key) { return key.starts_with("sweep."); });
}

JoinedSweep joined_sweep(const Program& program, const Scene& scene) {
  if (program.check_sweep) with_places(scene, [&] { program.check_sweep(scene); });
  const auto plan = std::make_shared<const SweepPlan>(plan_of(program, scene));
  return {plan->common, [plan](const Progress& progress) { return tables_of(*plan, progress); }};
}

}  // namespace microslip::program
