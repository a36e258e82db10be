// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "command_line.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/sweep.hpp"
#include "microslip/support/checksum.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/text.hpp"

namespace microslip::program {

namespace {

Table table_of(const Sweep& sweep) {
  std::vector<Column> columns{{"case", "1", "number of the case"}};
  for (const SweptKey& swept : sweep.keys()) {
    columns.push_back({swept.key, swept.unit, "swept"});
  }
  Table table("plan", "cases of a sweep; the last key varies fastest", columns);
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    std::vector<Cell> row{std::to_string(i + 1)};
    for (const std::string& value : sweep.values(i)) row.emplace_back(value);
    table.add(row);
  }
  return table;
}

Case read_case(const Program& program, Scene& scene) {
  try {
    const Work work = program.prepare(scene);
    scene.reject_unread();
    return {scene.origin(), work};
  } catch (const NotConverged& error) {  // as if it had failed later: others may have solutions
    return {scene.origin(), [error](const Progress&) -> std::vector<Table> { throw error; }};
  }
}

Parameters common_of(const std::vector<Case>& cases) {
  Parameters common;
  for (const auto& parameter : cases.front().parameters) {
    const bool everywhere = std::all_of(cases.begin(), cases.end(), [&](const Case& one) {
      return std::find(one.parameters.begin(), one.parameters.end(), parameter) !=
             one.parameters.end();
    });
    if (everywhere) common.push_back(parameter);
  }
  return common;
}

}  // namespace

SweepPlan plan_of(const Program& program, Scene scene) {
  std::set<std::pair<std::string, std::string>> checksums;
  scene.read_files_by([&](const std::string& path) {
    std::string text = file_text(path);
    checksums.emplace("checksum of " + path.substr(path.find_last_of('/') + 1), checksum(text));
    return text;
  });
  const Sweep sweep = with_places(scene, [&] { return Sweep(scene); });
  SweepPlan plan{.table = table_of(sweep), .common = {}, .cases = {}};
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    Scene one = sweep.scene(i);
    const auto fail = [&](const std::string& place, const std::exception& error) {
      throw std::invalid_argument(
          fmt::format("{}{}: {}", place, case_label(plan.table, i), error.what()));
    };
    try {
      plan.cases.push_back(read_case(program, one));
    } catch (const BadParameter& error) {
      const BadParameter named = in_keys(error, one);
      fail(one.place_of(named.name()), named);
    } catch (const std::invalid_argument& error) {
      fail("", error);
    }
  }
  plan.common = common_of(plan.cases);
  plan.common.insert(plan.common.end(), checksums.begin(), checksums.end());
  return plan;
}

std::string case_label(const Table& plan, std::size_t index) {
  std::string values;
  for (std::size_t k = 1; k < plan.columns().size(); ++k) {
    const std::string& key = plan.columns()[k].name;
    values += fmt::format("{}{} = {}", k > 1 ? ", " : "", key,
                          std::get<std::string>(plan.at(index, key)));
  }
  return fmt::format("case {} of {} ({})", index + 1, plan.rows(), shown(values, 400));
}

}  // namespace microslip::program
