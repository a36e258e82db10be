// SPDX-License-Identifier: GPL-3.0-or-later
#include "instants.hpp"

#include <algorithm>
#include <string>

namespace microslip::experiments {

namespace {

Table empty_instants(const Table& of_instant, const RunPlace& place, bool turns) {
  const std::string name = of_instant.name() == "traction" ? "instants" : "instants_edges";
  std::vector<Column> columns{{"instant", "1", "number of the instant, which is the end of a step"},
                              {"q", "mm", turns ? "where the bodies are" : "distance rolled"}};
  if (turns) columns.push_back({"distance", "mm", "distance rolled, forth and back"});
  if (place.time) columns.push_back({"t", "s", "time"});
  const std::vector<Column>& own = of_instant.columns();
  columns.insert(columns.end(), own.begin(), own.end());
  return {name, "transient rolling, the table " + of_instant.name() + " at instants of the run",
          columns};
}

}  // namespace

bool InstantTables::wants(std::size_t step) const {
  return std::ranges::binary_search(steps_, step);
}

void InstantTables::take(std::size_t step, const RunPlace& place,
                         const std::vector<Table>& tables) {
  if (pending_ && pending_->step != step) write_pending();
  pending_ = Pending{step, place, tables};
}

void InstantTables::write_pending() {
  const auto& [step, place, tables] = *pending_;
  ++written_;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const Table& of_instant = tables[k];
    if (tables_.size() <= k) tables_.push_back(empty_instants(of_instant, place, turns_));
    for (std::size_t i = 0; i < of_instant.rows(); ++i) {
      std::vector<Cell> row{written_, place.position};
      if (turns_) row.emplace_back(place.distance);
      if (place.time) row.emplace_back(*place.time);
      for (const Column& column : of_instant.columns())
        row.push_back(of_instant.at(i, column.name));
      tables_[k].add(std::move(row));
    }
  }
}

void InstantTables::add_to(std::vector<Table>& tables) {
  if (pending_) write_pending();
  pending_.reset();
  for (Table& table : tables_) tables.push_back(std::move(table));
  tables_.clear();
}

}  // namespace microslip::experiments
