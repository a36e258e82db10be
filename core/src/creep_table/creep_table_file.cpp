// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/creep_table/creep_table_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/support/checksum.hpp"
#include "microslip/support/netcdf.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Vector3d;

namespace {

using Variable = NetcdfFile::Variable;
using Attributes = std::vector<NetcdfFile::Attribute>;

constexpr const char* title = "microslip table of creep forces 2";
constexpr const char* comment =
    "A contact ellipse with half-widths a along and b across the rolling, c = sqrt(a b), and "
    "Hertz's pressure p0, rolls steadily with creepage xi, lateral creepage eta and spin phi; the "
    "rigid slip is (xi - phi y, eta + phi x). At a node, with X = kp/kx (1 + b/a)^0.25, "
    "E = 1.35 X (1 + b/a)^-0.4, kx = C11/(2 pi/3), ky = C22/(2 pi/3), "
    "kp = hypot(C23, 0.59 sqrt(b/a) C11)/(2 pi/3) and "
    "d = (X sin(polar) sin(azimuth), E sin(polar) cos(azimuth), cos(polar)), the motion is "
    "(xi, eta, phi c) G/(mu p0) = r d/|(kx d1, ky d2, kp d3)| with r = 1.5 t/(1 - t); t = 1 is "
    "full sliding. Fx is odd in xi; all forces are odd in the motion.";

constexpr std::array force_names{"force", "lateral_force", "spin_moment"};
constexpr std::array force_units{"mu F_n", "mu F_n", "mu F_n c"};
constexpr std::array coefficient_names{"C11", "C22", "C23", "C32", "C33"};

Variable axis(const char* name, std::size_t dimension, const char* unit, const char* meaning,
              Index nodes, auto value) {
  Variable found{.name = name,
                 .dimensions = {dimension},
                 .attributes = {{"units", unit}, {"long_name", meaning}}};
  for (Index i = 0; i < nodes; ++i) found.values.push_back(value(i));
  return found;
}

std::string checksum_of(const NetcdfFile& file) { return checksum(file.value_bytes()); }

/// Attributes of errors, each of the three components.
struct ErrorKind {
  const char* name;
  Vector3d CreepTableErrors::*values;
};
constexpr std::array<ErrorKind, 3> error_kinds{
    {{"error_rms_", &CreepTableErrors::rms},
     {"error_99_percent_", &CreepTableErrors::of_99_percent},
     {"error_largest_", &CreepTableErrors::largest}}};

/// Calls take(name, value) for each of them.
void for_errors(auto& errors, const auto& take) {
  for (const auto& [name, values] : error_kinds) {
    for (std::size_t c = 0; c < force_names.size(); ++c) {
      take(std::string(name) + force_names[c], (errors.*values)[static_cast<Index>(c)]);
    }
  }
}

void add_errors(Attributes& to, const CreepTableErrors& errors) {
  if (errors.states == 0) return;
  to.push_back({"error_states", static_cast<double>(errors.states)});
  to.push_back({"error_cells", static_cast<double>(errors.cells)});
  for_errors(errors, [&](const std::string& name, double value) { to.push_back({name, value}); });
}

/// A number that is whole and not negative.
Index whole(const NetcdfFile& file, const std::string& attribute) {
  constexpr double most = 1e9;
  const double value = file.number(attribute);
  require(value >= 0 && value <= most, attribute, value, "a whole number");
  return static_cast<Index>(value);
}

CreepTableErrors errors_of(const NetcdfFile& file) {
  CreepTableErrors errors;
  if (std::ranges::find(file.attributes, "error_states", &NetcdfFile::Attribute::name) ==
      file.attributes.end()) {
    return errors;
  }
  errors.states = whole(file, "error_states");
  errors.cells = whole(file, "error_cells");
  for_errors(errors, [&](const std::string& name, double& value) { value = file.number(name); });
  return errors;
}

}  // namespace

std::string file_of(const CreepTableNodes& nodes, const std::string& history) {
  const CreepTableLayout& of = nodes.layout;
  const auto length = [](Index number) { return static_cast<std::size_t>(number); };
  NetcdfFile file;
  file.dimensions = {{"ratio", length(of.ratios)},
                     {"t", length(of.steps)},
                     {"polar", length(of.polar)},
                     {"azimuth", length(of.azimuths)}};
  constexpr double degrees = 180 / std::numbers::pi;
  file.variables.push_back(
      axis("ratio", 0, "1", "a/b", of.ratios, [&](Index i) { return of.ratio(i); }));
  file.variables.push_back(axis("t", 1, "1", "size of the motion, r/(r + 1.5)", of.steps,
                                [&](Index i) { return of.step(i); }));
  file.variables.push_back(axis("polar", 2, "degree", "angle of the direction from pure spin",
                                of.polar, [&](Index i) { return degrees * of.angle(i); }));
  file.variables.push_back(axis("azimuth", 3, "degree",
                                "angle of the direction from pure lateral creepage", of.azimuths,
                                [&](Index i) { return degrees * of.azimuth(i); }));
  for (std::size_t c = 0; c < coefficient_names.size(); ++c) {
    file.variables.push_back(
        axis(coefficient_names[c], 0, "1", "Kalker's coefficient", of.ratios,
             [&](Index i) { return nodes.coefficients[length(i)].values()[c]; }));
  }
  for (std::size_t c = 0; c < force_names.size(); ++c) {
    Variable forces{.name = force_names[c],
                    .dimensions = {0, 1, 2, 3},
                    .attributes = {{"units", force_units[c]}},
                    .is_single = true};
    for (std::size_t i = c; i < nodes.forces.size(); i += 3) {
      forces.values.push_back(nodes.forces[i]);
    }
    file.variables.push_back(std::move(forces));
  }
  file.attributes = {{"title", title},
                     {"comment", comment},
                     {"history", history},
                     {"poisson_ratio", of.poisson_ratio},
                     {"cells", static_cast<double>(of.cells)},
                     {"checksum", checksum_of(file)}};
  add_errors(file.attributes, nodes.errors);
  return file.bytes();
}

CreepTableNodes read_creep_table(const std::string& bytes) {
  const NetcdfFile file = read_netcdf(bytes);
  const auto text = [&](const char* name) {
    const auto found = std::ranges::find(file.attributes, name, &NetcdfFile::Attribute::name);
    const auto* value =
        found == file.attributes.end() ? nullptr : std::get_if<std::string>(&found->value);
    return value == nullptr ? std::string() : *value;
  };
  if (text("title") != title) {
    throw std::invalid_argument(
        fmt::format("not a table of creep forces: expected the title '{}'", title));
  }
  const auto length = [&](const char* name) { return static_cast<Index>(file.length(name)); };
  CreepTableNodes nodes;
  nodes.layout = {.poisson_ratio = file.number("poisson_ratio"),
                  .least_ratio = file.variable("ratio").values.front(),
                  .largest_ratio = file.variable("ratio").values.back(),
                  .ratios = length("ratio"),
                  .steps = length("t"),
                  .polar = length("polar"),
                  .azimuths = length("azimuth"),
                  .cells = whole(file, "cells")};
  validate(nodes.layout);
  if (text("checksum") != checksum_of(file)) {
    throw std::invalid_argument("a damaged table: expected values of another checksum");
  }
  nodes.coefficients.resize(static_cast<std::size_t>(nodes.layout.ratios));
  const auto values = [&](const char* name, std::size_t size) -> const std::vector<double>& {
    const std::vector<double>& found = file.variable(name).values;
    if (found.size() != size) {
      throw std::invalid_argument(fmt::format("{}: expected {} values in the table", name, size));
    }
    return found;
  };
  for (std::size_t i = 0; i < nodes.coefficients.size(); ++i) {
    std::array<double, 5> of{};
    for (std::size_t c = 0; c < of.size(); ++c) {
      of[c] = values(coefficient_names[c], nodes.coefficients.size())[i];
    }
    nodes.coefficients[i] = CreepCoefficients::of(of);
  }
  nodes.forces.resize(3 * nodes.layout.nodes());
  for (std::size_t c = 0; c < force_names.size(); ++c) {
    const std::vector<double>& from = values(force_names[c], nodes.layout.nodes());
    for (std::size_t i = 0; i < from.size(); ++i) nodes.forces[3 * i + c] = from[i];
  }
  nodes.errors = errors_of(file);
  return nodes;
}

}  // namespace microslip
