// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a contact that is no ellipse: its edges, and its bound.
#include "patch_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t most_lobes = 8;

/// Rows of the lobes in a table of edges.
std::vector<std::vector<Index>> rows_by_number(const VectorXd& numbers) {
  std::vector<double> names;
  std::vector<std::vector<Index>> lobes;
  for (Index i = 0; i < numbers.size(); ++i) {
    const auto found = std::ranges::find(names, numbers[i]);
    const auto l = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) {
      names.push_back(numbers[i]);
      lobes.emplace_back();
    }
    lobes[l].push_back(i);
  }
  return lobes;
}

std::vector<std::vector<Index>> rows_by_order(const VectorXd& y, const VectorXd& trailing,
                                              const VectorXd& leading) {
  std::vector<std::vector<Index>> lobes;
  bool ends = true;
  for (Index i = 0; i < y.size(); ++i) {
    const bool is_first = ends || y[i] <= y[i - 1];
    if (is_first) lobes.emplace_back();
    lobes.back().push_back(i);
    ends = !is_first && trailing[i] == leading[i];
  }
  return lobes;
}

Lobe lobe_of(const std::vector<Index>& rows, const VectorXd& y, const VectorXd& trailing,
             const VectorXd& leading) {
  return {y(rows), trailing(rows), leading(rows)};
}

/// Lobes of a table; messages say which lobe they mean if there are several.
PatchShape shape_of(const std::vector<std::vector<Index>>& lobes, const VectorXd& y,
                    const VectorXd& trailing, const VectorXd& leading) {
  require(lobes.size() <= most_lobes, "number of lobes", static_cast<double>(lobes.size()),
          [&] { return fmt::format("at most {}; y rises within a lobe", most_lobes); });
  std::vector<Lobe> found;
  for (std::size_t l = 0; l < lobes.size(); ++l) {
    try {
      found.push_back(lobe_of(lobes[l], y, trailing, leading));
    } catch (const std::invalid_argument& error) {
      if (lobes.size() == 1) throw;
      throw std::invalid_argument(
          fmt::format("lobe {} from row {} on: {}", l + 1, lobes[l].front() + 1, error.what()));
    }
  }
  return PatchShape(std::move(found));
}

/// Warns of a bound of which every second row and point has another force.
void warn_of_coarse_table(Scene& scene, const PatchBound& bound, const BoundTable& table) {
  constexpr double doubtful = 0.01;
  const std::unique_ptr<BoundTable> half = table.half();
  if (!half) {
    scene.warn(bound_file, scene.text(bound_file),
               "fewer than five y with a bound in a lobe: too few to say how well they show it");
    return;
  }
  // Errors fall with the square of the distance of points.
  const double error = std::abs(PatchBound(bound.shape(), *half).total() / bound.total() - 1) / 3;
  if (error <= doubtful) return;
  scene.warn(bound_file, scene.text(bound_file),
             fmt::format("the table is coarse: full sliding is known to some {} of it, as every "
                         "second row and point of it say",
                         format_roughly(error)));
}

/// Refuses zeros within the edges that take much of the bound away, and warns of others.
/// \param whole  the table with them
void require_few_zeros(Scene& scene, const PatchBound& bound, const BoundTable& whole) {
  constexpr double doubtful = 0.02, most = 0.1;  // of full sliding
  const double part = 1 - PatchBound(bound.shape(), whole).total() / bound.total();
  if (part <= doubtful) return;
  const std::string left_out =
      fmt::format("its zeros within the edges are left out, and would take {} of full sliding away",
                  format_roughly(part));
  if (part > most) {
    reject(bound_file, scene.text(bound_file),
           "edges where the bound ends, by contact.patch_file, of several lobes if it is 0 between "
           "them; " +
               left_out);
  }
  scene.warn(bound_file, scene.text(bound_file),
             left_out + "; edges belong where the bound ends, by contact.patch_file");
}

}  // namespace

PatchShape read_shape(Scene& scene) {
  const std::vector<FileColumn> wanted = {
      {"y", "mm"}, {"trailing", "mm"}, {"leading", "mm"}, {"lobe", "1", false}};
  return scene.from_columns(patch_file, wanted, [](const auto& table) {
    const VectorXd &y = *table[0], &trailing = *table[1], &leading = *table[2];
    return shape_of(table[3] ? rows_by_number(*table[3]) : rows_by_order(y, trailing, leading), y,
                    trailing, leading);
  });
}

PatchBound read_bound_table(Scene& scene, const PatchShape& shape) {
  const std::vector<FileColumn> wanted = {{"x", "mm"}, {"y", "mm"}, {"bound", "N/mm^2"}};
  const auto [table, whole] = scene.from_columns(bound_file, wanted, [&](const auto& columns) {
    const auto made = [&](BoundTable::Zeros zeros) {
      return BoundTable(shape, *columns[0], *columns[1], *columns[2], zeros);
    };
    const BoundTable without = made(BoundTable::Zeros::left_out);
    const bool has_zeros = columns[2]->minCoeff() == 0;
    return std::pair(without,
                     has_zeros ? std::optional(made(BoundTable::Zeros::kept)) : std::nullopt);
  });
  if (table.left_out() > 0) {
    scene.warn(bound_file, scene.text(bound_file),
               fmt::format("{} of its points with a bound are outside the contact, and left out",
                           table.left_out()));
  }
  const PatchBound bound(shape, table);
  if (whole) require_few_zeros(scene, bound, *whole);
  warn_of_coarse_table(scene, bound, table);
  return bound;
}

TractionTable read_start_tractions(Scene& scene, const PatchBound& bound,
                                   const ContactScale& contact) {
  const double size = contact.half_width;
  const std::vector<FileColumn> wanted = {
      {"x", "mm"}, {"y", "mm"}, {"traction_x", "N/mm^2"}, {"traction_y", "N/mm^2"}};
  const TractionTable table = scene.from_columns("start.file", wanted, [&](const auto& columns) {
    Eigen::MatrixX2d tractions(columns[2]->size(), 2);
    tractions << *columns[2], *columns[3];
    return TractionTable(bound, *columns[0] / size, *columns[1] / size, tractions / contact.bound);
  });
  if (table.left_out() > 0) {
    scene.warn("start.file", scene.text("start.file"),
               fmt::format("{} of its points with tractions are outside the contact, and left out",
                           table.left_out()));
  }
  return table;
}

}  // namespace microslip
