// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_rows.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

std::string named(Index row, const std::string& column) {
  return fmt::format("row {}: {}", row + 1, column);
}

void require_finite(const VectorXd& column, Index rows, const std::string& name) {
  require(column.size() == rows, "number of rows of " + name, static_cast<double>(column.size()),
          [&] { return fmt::format("{}, as of the first column", rows); });
  for (Index i = 0; i < rows; ++i) {
    if (!std::isfinite(column[i])) require(false, named(i, name), column[i], "a finite number");
  }
}

void require_times(const VectorXd& column) {
  for (Index i = 1; i < column.size(); ++i) {
    if (column[i] >= column[i - 1]) continue;
    require(false, named(i, "t"), column[i],
            fmt::format("at least {} of the row before", format_short(column[i - 1])));
  }
}

/// \throws std::invalid_argument unless the columns fit together
void require_columns(const RunRows& rows) {
  if (rows.distance.has_value() == rows.time.has_value()) {
    throw std::invalid_argument("columns: expected either q or t");
  }
  const int loads = int(rows.creepage.has_value()) + int(rows.force.has_value()) +
                    int(rows.angular_velocity.has_value());
  if (loads != 1) {
    throw std::invalid_argument("columns: expected one of creepage, force and omega");
  }
  if (rows.time.has_value() != rows.velocity.has_value()) {
    throw std::invalid_argument("columns: expected v where there is t, and only there");
  }
  if (rows.angular_velocity && rows.distance) {
    throw std::invalid_argument("columns: expected t and v where there is omega");
  }
}

/// Requires columns of the contact that fit together, of numbers >= 0.
void require_contact(const RunRows& rows) {
  if (rows.normal_load && (rows.half_width || rows.peak_traction)) {
    throw std::invalid_argument(
        "columns: expected half_width and peak_traction, or normal_load, from which they follow");
  }
  if (rows.peak_traction && rows.friction) {
    throw std::invalid_argument("columns: expected peak_traction or friction, which it includes");
  }
  const Index n = (rows.time ? rows.time : rows.distance)->size();
  const RunRows::Reference& reference = rows.of_problem;
  sizes(rows.normal_load, n, "normal_load", reference.normal_load);
  sizes(rows.half_width, n, "half_width", reference.half_width);
  sizes(rows.peak_traction, n, "peak_traction", reference.peak_traction);
  sizes(rows.friction, n, "friction", reference.friction);
  for (Index i = 0; rows.friction && i < n; ++i) {
    constexpr double most_friction = 10;
    if ((*rows.friction)[i] <= most_friction) continue;
    require(false, named(i, "friction"), (*rows.friction)[i], "a number from 0 to 10");
  }
}

/// The values of a column at the rows and at turns.
/// \param parts  for each row: where between it and the next one the bodies turn; 0 if they do not
VectorXd with_turns(const VectorXd& column, const std::vector<double>& parts) {
  std::vector<double> values;
  for (Index i = 0; i < column.size(); ++i) {
    values.push_back(column[i]);
    const double part = parts[static_cast<std::size_t>(i)];
    if (part > 0) values.push_back(std::lerp(column[i], column[i + 1], part));
  }
  return VectorXd::Map(values.data(), static_cast<Index>(values.size()));
}

}  // namespace

void require_rows(const RunRows& rows) {
  require_columns(rows);
  const VectorXd& along = rows.time ? *rows.time : *rows.distance;
  const Index n = along.size();
  require(n >= 2, "number of rows", static_cast<double>(n), "at least 2");
  require_finite(along, n, rows.time ? "t" : "q");
  if (rows.time) require_times(along);
  const auto require_all = [&](const std::optional<VectorXd>& column, const std::string& name) {
    if (column) require_finite(*column, n, name);
  };
  require_all(rows.velocity, "v");
  require_all(rows.angular_velocity, "omega");
  require_all(rows.force, rows.force_name);
  require_all(rows.creepage, rows.creepage_name);
  if (rows.angular_velocity) require_positive("radius", rows.radius);
  require_contact(rows);
}

std::vector<double> sizes(const std::optional<VectorXd>& column, Index rows,
                          const std::string& name, double of_problem) {
  if (!column) return {};
  require_positive(name + " of the problem", of_problem);
  require_finite(*column, rows, name);
  for (Index i = 0; i < rows; ++i) {
    if ((*column)[i] < 0) require(false, named(i, name), (*column)[i], "a number >= 0");
  }
  const VectorXd found = *column / of_problem;
  return {found.begin(), found.end()};
}

TurningRows with_turns(const RunRows& rows) {
  TurningRows found{rows, {}};
  const Index n = (rows.time ? rows.time : rows.distance)->size();
  std::vector<double> parts(static_cast<std::size_t>(n), 0);
  for (Index i = 0; rows.velocity && i + 1 < n; ++i) {
    const double here = (*rows.velocity)[i], next = (*rows.velocity)[i + 1];
    if (here * next < 0) parts[static_cast<std::size_t>(i)] = here / (here - next);
  }
  for (std::size_t i = 0, place = 0; i < parts.size(); ++i, ++place) {
    found.of_file.push_back(place);
    if (parts[i] > 0) ++place;
  }
  for (auto* column :
       {&found.rows.distance, &found.rows.time, &found.rows.velocity, &found.rows.creepage,
        &found.rows.force, &found.rows.angular_velocity, &found.rows.normal_load,
        &found.rows.half_width, &found.rows.peak_traction, &found.rows.friction}) {
    if (*column) *column = with_turns(**column, parts);
  }
  if (!rows.velocity) return found;
  for (std::size_t i = 0; i < parts.size(); ++i) {  // 0 but for rounding
    if (parts[i] > 0) (*found.rows.velocity)[static_cast<Index>(found.of_file[i]) + 1] = 0;
  }
  return found;
}

}  // namespace microslip
