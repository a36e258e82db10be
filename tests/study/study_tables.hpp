// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/scene/scene.hpp"
#include "microslip/scene/table.hpp"

namespace microslip::experiments {

inline void no_progress(std::size_t, std::size_t) {}

/// The parameters in study.info of a study.
/// \param changes  "key=value", as --set takes them
template <class Read>
auto parameters_of(const std::string& study, Read read,
                   const std::vector<std::string>& changes = {}) {
  std::ifstream file(MICROSLIP_SOURCE "/studies/" + study + "/study.info");
  Scene scene = Scene::parse(file, study);
  for (const std::string& change : changes) scene.set(change);
  return read(scene);
}

/// The tables of a study with these parameters.
template <class Read, class Measure>
std::vector<Table> tables_of(const std::string& study, Read read, Measure measure,
                             const std::vector<std::string>& changes = {}) {
  return measure(parameters_of(study, read, changes), no_progress);
}

inline const Table& table_named(const std::vector<Table>& tables, const std::string& name) {
  for (const Table& table : tables) {
    if (table.name() == name) return table;
  }
  throw std::logic_error("the study has no table " + name);
}

/// The verdicts of a study's claims, in their order.
inline std::vector<std::string> verdicts(const std::vector<Table>& tables) {
  const Table& claims = table_named(tables, "claims");
  std::vector<std::string> all;
  for (std::size_t i = 0; i < claims.rows(); ++i) {
    all.push_back(std::get<std::string>(claims.at(i, "verdict")));
  }
  return all;
}

}  // namespace microslip::experiments
