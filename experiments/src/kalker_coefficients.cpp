// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/kalker_coefficients.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "kalker_printed.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/patch/patch_response.hpp"
#include "microslip/patch/standard_patch.hpp"
#include "microslip/reference/kalker.hpp"
#include "microslip/support/convergence.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;

namespace {

constexpr std::array<const char*, 4> names{"C11", "C22", "C23", "C33"};
using Coefficients = std::array<double, 4>;

/// C23 is the mean of both that should be equal by reciprocity.
Coefficients coefficients_of(const Eigen::Matrix3d& linear) {
  return {-linear(0, 0), -linear(1, 1), (linear(2, 1) - linear(1, 2)) / 2, -linear(2, 2)};
}

/// As many rows as cells of a row, whatever the aspect.
Coefficients by_rows(double aspect, Index elements, double poisson_ratio) {
  return coefficients_of(
      PatchResponse(JoinedRows(aspect, elements, elements), poisson_ratio).linear());
}

/// Values by Galin's theorem, and their relative errors.
struct Exact {
  Coefficients value, error;
};

Exact by_galin(double aspect, double poisson_ratio, Index order) {
  const auto [value, error] = creep_coefficients(aspect, poisson_ratio, order);
  const double c23 = (value.c23 + value.c32) / 2;
  return {{value.c11, value.c22, c23, value.c33},
          {error.c11 / value.c11, error.c22 / value.c22, error.c23 / c23, error.c33 / value.c33}};
}

Table coefficients_table(const KalkerCoefficientsParameters& p, const Progress& progress,
                         std::size_t steps) {
  Table table("coefficients", "creep coefficients of the ellipse, by Galin's theorem",
              {{"aspect", "1", "a/b, a along the rolling"},
               {"poisson_ratio", "1", "nu"},
               {"coefficient", "1",
                "C11: F_x by creepage; C22: F_y by lateral creepage; C23: F_y "
                "by spin and M_z by lateral creepage; C33: M_z by spin"},
               {"value", "1",
                "F_x = -G c^2 C11 xi, F_y = -G c^2 C22 eta - G c^3 C23 phi, M_z = G "
                "c^3 C23 eta - G c^4 C33 phi, c^2 = a b"},
               {"error", "1", "estimated relative error of the value", 1e-10},
               {"joined", "1", "relative error of joined rows", 1e-6},
               {"printed", "1", "by Kalker (1990), table E3; nan where it has none"},
               {"digit", "1", "a unit of its last digit"},
               {"difference", "1", "of the printed value, relative"},
               {"units", "1", "difference of the printed value in units of its last digit"}});
  for (const double nu : p.poisson_ratios) {
    for (const double aspect : p.aspects) {
      const Exact exact = by_galin(aspect, nu, 48);
      const Coefficients joined = by_rows(aspect, p.elements, nu);
      const auto printed = kalker_printed(aspect, nu);
      for (std::size_t k = 0; k < names.size(); ++k) {
        const double value = printed ? (*printed)[k].value : not_given;
        const double digit = printed ? (*printed)[k].digit : not_given;
        table.add({aspect, nu, names[k], exact.value[k], exact.error[k],
                   std::abs(joined[k] / exact.value[k] - 1), value, digit,
                   value / exact.value[k] - 1, (value - exact.value[k]) / digit});
      }
      progress(table.rows() / names.size(), steps);
    }
  }
  return table;
}

struct Convergence {
  Table errors;
  Table orders;
};

Convergence convergence(const KalkerCoefficientsParameters& p, const Progress& progress,
                        std::size_t steps) {
  std::vector<Column> columns{
      {"scheme", "1", "joined: rows; standard: equal rectangles"},
      {"aspect", "1", "a/b"},
      {"elements", "1", "N: rows, and cells of each; rectangles along and across"},
      {"cells", "1", "number of cells"}};
  for (const char* name : names) {
    columns.push_back({name, "1", "relative error, against Galin's theorem", 1e-6});
  }
  columns.push_back(
      {"reference", "1", "largest estimated relative error of the four by Galin's theorem", 1e-10});
  Convergence found{
      {"errors", "errors of the coefficients against the number of cells", columns},
      {"orders",
       "orders of the errors in the number of cells along an axis, fitted over all of them",
       {{"scheme", "1", "joined: rows; standard: equal rectangles"},
        {"aspect", "1", "a/b"},
        {"order", "1", "of the largest error of the four coefficients", 0.05}}}};
  std::size_t done = p.aspects.size() * p.poisson_ratios.size();
  for (const double aspect : p.converged_aspects) {
    const Exact exact = by_galin(aspect, p.poisson_ratio, 96);
    const auto series = [&](const char* scheme, const std::vector<Index>& sizes,
                            const auto& solve) {
      std::vector<double> sides, errors;
      for (const Index size : sizes) {
        const auto [cells, of] = solve(size);
        std::array<double, 4> error{};
        for (std::size_t k = 0; k < names.size(); ++k) {
          error[k] = std::abs(of[k] / exact.value[k] - 1);
        }
        found.errors.add({scheme, aspect, size, cells, error[0], error[1], error[2], error[3],
                          std::ranges::max(exact.error)});
        sides.push_back(static_cast<double>(size));
        errors.push_back(std::ranges::max(error));
        progress(++done, steps);
      }
      found.orders.add({scheme, aspect, fitted_order(sides, errors)});
    };
    using Solved = std::pair<Index, Coefficients>;
    series("joined", p.sizes, [&](Index size) -> Solved {
      return {size * size, by_rows(aspect, size, p.poisson_ratio)};
    });
    series("standard", p.rectangles, [&](Index size) -> Solved {
      const double root = std::sqrt(aspect);
      const Rectangles rectangles = Rectangles::in_ellipse(root, 1 / root, size, size);
      return {rectangles.size(), coefficients_of(linear_response(rectangles, p.poisson_ratio))};
    });
  }
  return found;
}

/// The largest error of some coefficients over a/b, with at least so many cells along an axis.
double largest_error(const Table& errors, const char* scheme, double elements,
                     const std::vector<const char*>& of = {names.begin(), names.end()}) {
  double largest = not_given;
  for (const char* name : of) {
    largest = std::fmax(largest, extreme(errors, name, false, [&](std::size_t i) {
                          return errors.at(i, "scheme") == Cell(scheme) &&
                                 errors.number(i, "elements") >= elements;
                        }));
  }
  return largest;
}

/// The largest error of Galin's theorem, over the least error that it measures.
double largest_doubt(const Table& errors) {
  double largest = not_given;
  for (const char* name : names) {
    for (std::size_t i = 0; i < errors.rows(); ++i) {
      largest = std::fmax(largest, errors.number(i, "reference") / errors.number(i, name));
    }
  }
  return largest;
}

std::vector<Claim> claims_on_rows(const Table& coefficients, const Convergence& found) {
  const double largest_of_joined =
      extreme(coefficients, "joined", false, [](std::size_t) { return true; });
  return {
      {"Galin's theorem is far more exact than what is measured against it", "none", not_given,
       largest_doubt(found.errors), "1", ours_if({below(0.1)}),
       "largest estimated error of Galin's theorem, over any error of joined rows or of the "
       "standard scheme",
       "kalker_coefficients_error"},
      {"14 x 14 cells in joined rows have Galin's coefficients to half a thousandth for all "
       "printed shapes",
       "none", not_given, largest_of_joined, "1", ours_if({below(5e-4)}),
       "largest relative difference over a/b and nu, by ellipse.elements rows and cells",
       "kalker_coefficients_error"},
      {"5 x 5 cells in joined rows give all coefficients to half a percent", "none", not_given,
       largest_error(found.errors, "joined", 0), "1", ours_if({below(5e-3)}),
       "largest relative error of the coefficients over a/b, for any number of cells",
       "kalker_coefficients_error"},
      {"10 x 10 cells in joined rows give all coefficients to half a thousandth", "none", not_given,
       largest_error(found.errors, "joined", 10), "1", ours_if({below(5e-4)}),
       "largest relative error over a/b, from 10 x 10 cells on", "kalker_coefficients_error"},
      {"on 28 x 28 rectangles the standard scheme is one to three percent off in C11, C22 and "
       "C23",
       "none", not_given, largest_error(found.errors, "standard", 28, {"C11", "C22", "C23"}), "1",
       ours_if({between(0.01, 0.03)}), "largest relative error of the three over a/b",
       "kalker_coefficients_error"},
      {"on 28 x 28 rectangles the standard scheme is more than half off in C33 of a long ellipse",
       "none", not_given, largest_error(found.errors, "standard", 28, {"C33"}), "1",
       ours_if({between(0.5, 0.7)}), "largest relative error of C33 over a/b",
       "kalker_coefficients_error"},
      {"joined rows are of second order", "none", 2,
       least(found.orders, "order", {{"scheme", "joined"}}), "1", ours_if({above(1.7)}),
       "least order over a/b, of the largest error", "kalker_coefficients_error"}};
}

/// A part of the printed values: the largest difference, and how many differ by more than a unit of
/// their last digit.
struct PrintedPart {
  double difference = not_given, units = not_given, share = 0;
};

PrintedPart printed_part(const Table& coefficients, double from, double to) {
  PrintedPart found;
  double all = 0;
  for (std::size_t i = 0; i < coefficients.rows(); ++i) {
    const double aspect = coefficients.number(i, "aspect");
    const double units = std::abs(coefficients.number(i, "units"));
    if (std::isnan(units) || aspect < from || aspect > to) continue;
    found.difference = std::fmax(found.difference, std::abs(coefficients.number(i, "difference")));
    found.units = std::fmax(found.units, units);
    all += 1;
    found.share += units > 1 ? 1 : 0;
  }
  found.share /= all;
  return found;
}

std::vector<Claim> claims_on_table(const Table& coefficients) {
  const PrintedPart near = printed_part(coefficients, 0.7, 1.5);
  const PrintedPart nearer = printed_part(coefficients, 0.75, 1.3);
  const PrintedPart all = printed_part(coefficients, 0, 1e3);
  return {
      {"Kalker's printed coefficients are right to about half a percent where the ellipse is "
       "nearly a circle",
       "none", not_given, near.difference, "1", ours_if({below(6e-3)}),
       "largest relative difference of the printed values, a/b from 0.7 to 1/0.7",
       "kalker_coefficients_printed"},
      {"Kalker's printed coefficients are up to one percent off where the ellipse is slender",
       "none", not_given, all.difference, "1", ours_if({between(5e-3, 0.015)}),
       "largest relative difference of the printed values", "kalker_coefficients_printed"},
      {"Kalker's printed coefficients are right to a unit of their last digit where the ellipse "
       "is nearly a circle",
       "none", not_given, nearer.units, "1", ours_if({below(1)}),
       "largest difference in units of the last digit, a/b from 0.8 to 1/0.8",
       "kalker_coefficients_printed"},
      {"Kalker's printed coefficients are several units of their last digit off where the "
       "ellipse is slender",
       "none", not_given, all.units, "1", ours_if({between(5, 10)}),
       "largest difference in units of the last digit", "kalker_coefficients_digits"},
      {"many of Kalker's printed coefficients are not right in their last digit", "none", not_given,
       all.share, "1", ours_if({above(0.1)}),
       "part of the printed values that differ by more than a unit of their last digit",
       "kalker_coefficients_printed"}};
}

Table claims_of(const Table& coefficients, const Convergence& found) {
  std::vector<Claim> claims = claims_on_rows(coefficients, found);
  for (Claim& claim : claims_on_table(coefficients)) claims.push_back(std::move(claim));
  return claims_table(claims);
}

}  // namespace

KalkerCoefficientsParameters read_kalker_coefficients(Scene& scene) {
  using P = KalkerCoefficientsParameters;
  const StudyKeys<P> keys(
      scene, {{&P::aspects, "ellipse.aspects", "a/b, a along the rolling", range(0.05, 20)},
              {&P::poisson_ratios, "ellipse.poisson_ratios", "nu", range(0, 0.5)},
              {&P::elements, "ellipse.elements", "joined rows, and cells of each", range(8, 40)},
              {&P::converged_aspects, "convergence.aspects", "a/b", range(0.2, 5)},
              {&P::poisson_ratio, "convergence.poisson_ratio", "nu", range(0, 0.5)},
              {&P::sizes, "convergence.sizes", "joined rows, and cells of each", range(5, 50),
               two_or_more_rising},
              {&P::rectangles, "convergence.rectangles",
               "N of the standard scheme, along the longest row and across", range(5, 50),
               two_or_more_rising}});
  return keys.read({});
}

std::vector<Table> kalker_coefficients(const KalkerCoefficientsParameters& p,
                                       const Progress& progress) {
  const std::size_t steps = p.aspects.size() * p.poisson_ratios.size() +
                            p.converged_aspects.size() * (p.sizes.size() + p.rectangles.size());
  const Table coefficients = coefficients_table(p, progress, steps);
  const Convergence found = convergence(p, progress, steps);
  return {coefficients, found.errors, found.orders, claims_of(coefficients, found)};
}

}  // namespace microslip::experiments
