// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include "creep_tables_data.hpp"
#include "creep_tables_states.hpp"

namespace microslip::experiments {

using Eigen::Index;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr std::array<double, 5> table_ratios{0.2, 0.5, 1, 2, 5};
constexpr std::array<double, 4> table_spins{0, 0.5, 1, 2};
constexpr Index table_angles = 7;  ///< from -90 to 90 degrees, evenly spaced
constexpr std::array<double, 23> table_magnitudes{
    0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9, 1.1, 1.4, 1.7, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9, 10, 12};

/// Size of the printed motions, which are over mu c/rho and mu/rho, over mu p0/G and mu p0/(G c).
/// By Hertz's theory with equal bodies, E* = G/(1 - nu), the sum of curvatures 1/Rx + 1/Ry is
/// 2 p0 E(e)/(E* d), d the smaller half-width, E(e) the complete elliptic integral; and 1/rho is a quarter
/// of that sum, as the printed rho have it: 2700, 2075 and 1772 for a = b = 9, b = 2a = 12 and b = 5a = 20
/// with F_n = G. So c/rho = (1 - nu)/2 E(e) c/d p0/G.
double unit_of_motion(double ratio) {
  const double slenderness = std::min(ratio, 1 / ratio);
  const double eccentricity = std::sqrt(1 - slenderness * slenderness);
  return (1 - poisson_ratio_of_creep_tables) / 2 * std::comp_ellint_2(eccentricity) /
         std::sqrt(slenderness);
}

std::vector<Vector3d> printed_results() {
  std::istringstream lines{std::string(contact_table_bytes())};
  std::vector<Vector3d> found;
  std::string line;
  while (std::getline(lines, line)) {
    if (line.starts_with('#')) continue;
    std::istringstream numbers(line);
    Vector3d& forces = found.emplace_back();
    if (!(numbers >> forces[0] >> forces[1] >> forces[2])) break;
  }
  if (found.size() !=
      table_ratios.size() * table_spins.size() * table_angles * table_magnitudes.size()) {
    throw std::logic_error("contact_11.tsv: expected 3220 rows of three numbers");
  }
  return found;
}

}  // namespace

std::vector<std::vector<ContactTableCase>> contact_table_cases(Index every) {
  const std::vector<Vector3d> printed = printed_results();
  std::vector<std::vector<ContactTableCase>> rows;
  std::size_t at = 0;
  for (const double ratio : table_ratios) {
    const double unit = unit_of_motion(ratio);
    for (const double spin : table_spins) {
      for (Index j = 0; j < table_angles; ++j) {
        const double angle = pi / 6 * static_cast<double>(j - table_angles / 2);
        const double along = j % (table_angles - 1) == 0 ? 0 : std::cos(angle);
        const bool is_mirrored = spin == 0 && angle < 0;
        std::vector<ContactTableCase> row;
        for (std::size_t m = 0; m < table_magnitudes.size(); ++m, ++at) {
          const double size = table_magnitudes[m];
          const bool is_repeated = size == 0 && (spin == 0 || angle != 0);
          if (is_mirrored || is_repeated || m % static_cast<std::size_t>(every) != 0) continue;
          const Vector3d motion(size * along, size * std::sin(angle), spin);
          row.push_back({ratio, unit * motion, printed[at]});
        }
        if (!row.empty()) rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

}  // namespace microslip::experiments
