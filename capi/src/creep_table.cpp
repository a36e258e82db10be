// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/creep_table/creep_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "jacobian.hpp"
#include "microslip/creep_table/creep_table_file.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/patch/large_motion.hpp"
#include "microslip/patch/patch_load.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"
#include "microslip_creep_table.h"
#include "problem.hpp"
#include "status.hpp"
#include "zero.hpp"

using namespace microslip::capi;

struct microslip_creep_table {
  microslip::CreepTable table;
  microslip::CreepTableErrors errors;

  explicit microslip_creep_table(const microslip::CreepTableNodes& nodes)
      : table(nodes), errors(nodes.errors) {}
};

namespace {

microslip::CreepTableNodes read_table(const char* path) {
  const std::string shown = microslip::shown(path);
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    throw std::invalid_argument(fmt::format("cannot read {}: expected a table's file", shown));
  }
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  try {
    return microslip::read_creep_table(bytes);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", shown, error.what()));
  }
}

/// nu of a table and of a material may differ by so much: that of steel has two or three digits.
constexpr double same_poisson_ratio = 1e-3;

void require_material(const microslip::CreepTableLayout& layout, const microslip_material& of) {
  microslip::validate(microslip::Material{of.shear_modulus, of.poisson_ratio});
  microslip::require(std::abs(of.poisson_ratio - layout.poisson_ratio) <= same_poisson_ratio,
                     "poisson_ratio", of.poisson_ratio,
                     [&] { return fmt::format("that of the table, {}", layout.poisson_ratio); });
}

/// Refuses what the table does not take, by the names of the arguments.
void reject_argument(const microslip::CreepTable& table, const microslip_ellipse_contact& contact,
                     const double* motion) {
  const double a = contact.half_width, b = contact.lateral_half_width;
  microslip::require_positive("half_width", a);
  microslip::require_positive("lateral_half_width", b);
  microslip::require_positive("peak_traction", contact.peak_traction);
  const double least = table.layout().least_ratio, largest = table.layout().largest_ratio;
  const auto range = [&] {
    return fmt::format(
        "{:.6g} to {:.6g} with lateral_half_width = {:.6g}, as the table has a/b from {:.6g} to "
        "{:.6g}",
        least * b, largest * b, b, least, largest);
  };
  microslip::require(a / b >= least && a / b <= largest, "half_width", a, range);
  constexpr std::array names{"motion[0]", "motion[1]", "motion[2]"};
  for (std::size_t i = 0; i < 3; ++i) {
    microslip::require(true, names[i], motion[i], "a finite number");
  }
  const double size = std::sqrt(a * b);
  const std::array sizes{std::abs(motion[0]), std::abs(motion[1]), size * std::abs(motion[2])};
  const auto worst = static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin());
  microslip::require(false, names[worst], motion[worst],
                     "a motion of at most 1e100 times peak_traction over shear_modulus");
}

/// Writes the resultants of a motion, and their derivatives unless there is no place for them.
void look_up(const microslip::CreepTable& table, double shear_modulus,
             const microslip_ellipse_contact& contact, const double* motion, double* resultants,
             double* jacobian) {
  Eigen::Matrix3d by_motion;
  try {
    const Eigen::Vector3d found = table.resultants(
        shear_modulus, {contact.half_width, contact.lateral_half_width, contact.peak_traction},
        Eigen::Map<const Eigen::Vector3d>(motion), jacobian == nullptr ? nullptr : &by_motion);
    for (Eigen::Index i = 0; i < 3; ++i) resultants[i] = without_sign_of_zero(found[i]);
  } catch (const microslip::BadParameter& error) {
    reject_argument(table, contact, motion);
    throw;
  }
  if (jacobian != nullptr) put_jacobian(jacobian, by_motion);
}

/// Why a look-up is doubtful: by its motion, or its units; empty if it is not.
std::string doubt_of(const microslip_material& material, const microslip_ellipse_contact& contact,
                     const double* motion) {
  const double size = std::sqrt(contact.half_width * contact.lateral_half_width);
  const double mean_strain = contact.peak_traction / (1.5 * material.shear_modulus);
  const microslip::PatchLoad names{};
  for (std::size_t j = 0; j < names.size(); ++j) {
    const std::string doubt = microslip::doubt_of_large_motion(j, motion[j], size, mean_strain);
    if (!doubt.empty()) return fmt::format("{} = {:.6g}: {}", name_of(names, j), motion[j], doubt);
  }
  return doubt_of_units(material, contact.peak_traction);
}

}  // namespace

microslip_status microslip_creep_table_open(const char* path, microslip_creep_table** table,
                                            char* message, size_t message_size) {
  if (table != nullptr) *table = nullptr;
  return guarded({message, message_size}, [&] {
    microslip_creep_table*& made = require_pointer(table, "table");
    made = new microslip_creep_table(read_table(&require_pointer(path, "path")));
  });
}

void microslip_creep_table_close(microslip_creep_table* table) { delete table; }

microslip_status microslip_creep_table_get_info(const microslip_creep_table* table,
                                                microslip_creep_table_info* info, char* message,
                                                size_t message_size) {
  return guarded({message, message_size}, [&] {
    const auto& [found, errors] = require_pointer(table, "table");
    microslip_creep_table_info& out = require_pointer(info, "info");
    const microslip::CreepTableLayout& layout = found.layout();
    out = {};
    out.poisson_ratio = layout.poisson_ratio;
    out.least_ratio = layout.least_ratio;
    out.largest_ratio = layout.largest_ratio;
    out.states = static_cast<int>(errors.states);
    for (Eigen::Index i = 0; i < 3; ++i) {
      out.error_rms[i] = errors.rms[i];
      out.error_of_99_percent[i] = errors.of_99_percent[i];
      out.error_largest[i] = errors.largest[i];
    }
  });
}

microslip_status microslip_creep_table_forces(const microslip_creep_table* table,
                                              const microslip_material* material,
                                              const microslip_ellipse_contact* contact,
                                              const double motion[3], double resultants[3],
                                              double* jacobian, char* message,
                                              size_t message_size) {
  const Message said{message, message_size};
  return guarded(said, [&] {
    const microslip::CreepTable& from = require_pointer(table, "table").table;
    const microslip_material& of = require_pointer(material, "material");
    const microslip_ellipse_contact& one = require_pointer(contact, "contact");
    const double* moved = &require_pointer(motion, "motion");
    double* out = &require_pointer(resultants, "resultants");
    require_material(from.layout(), of);
    look_up(from, of.shear_modulus, one, moved, out, jacobian);
    if (message == nullptr) return;
    const std::string doubt = doubt_of(of, one, moved);
    said.say(doubt.empty() ? "" : "warning: " + doubt);
  });
}

microslip_status microslip_creep_table_forces_many(const microslip_creep_table* table,
                                                   const microslip_material* material,
                                                   const microslip_ellipse_contact* contacts,
                                                   const double* motions, size_t count,
                                                   double* resultants, double* jacobians,
                                                   char* message, size_t message_size) {
  const Message said{message, message_size};
  return guarded(said, [&] {
    const microslip::CreepTable& from = require_pointer(table, "table").table;
    const microslip_material& of = require_pointer(material, "material");
    require_material(from.layout(), of);
    std::string warning;
    said.say(warning);
    if (count == 0) return;
    require_pointer(contacts, "contacts");
    require_pointer(motions, "motions");
    require_pointer(resultants, "resultants");
    std::size_t k = 0;
    try {
      for (; k < count; ++k) {
        look_up(from, of.shear_modulus, contacts[k], motions + 3 * k, resultants + 3 * k,
                jacobians == nullptr ? nullptr : jacobians + 9 * k);
        if (message == nullptr || !warning.empty()) continue;
        const std::string doubt = doubt_of(of, contacts[k], motions + 3 * k);
        if (!doubt.empty()) warning = fmt::format("warning: contacts[{}]: {}", k, doubt);
      }
      said.say(warning);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("contacts[{}]: {}", k, error.what()));
    }
  });
}
