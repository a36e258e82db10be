// SPDX-License-Identifier: GPL-3.0-or-later
#include "ellipse_response_steps.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "microslip/patch/patch_frequency.hpp"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/standard_patch.hpp"

namespace microslip::experiments::ellipse_response_study {

namespace {

using Eigen::Index;
using Eigen::Matrix3cd;
using Eigen::Vector3cd;
using std::numbers::pi;

/// Motions over mu p0/G, so that nothing slips.
constexpr double amplitude = 1e-7;

/// Periods that are rolled before the last one, which is decomposed.
constexpr int periods_before = 1;

const EllipticBound circle(1, 1, 1);

/// The response of each wave, in resultants by the motion.
using Responses = std::vector<Matrix3cd>;

/// Rolls with all waves at once. The motion of a step is the mean of the waves over it, and
/// resultants are those at its end.
/// \param make  makes a scheme at rest
/// \param steps in a period
Responses rolled(const EllipseResponseParameters& p, const auto& make, int steps) {
  Responses found(p.waves.size(), Matrix3cd::Zero());
  const double dq = p.period / steps;
  for (std::size_t j = 0; j < 3; ++j) {
    auto rolling = make();
    for (int s = -periods_before * steps; s < steps; ++s) {
      PatchLoad load{};
      for (const Index number : p.waves) {
        const double angle = 2 * pi * static_cast<double>(number) / steps;
        load[j].value += amplitude * (std::sin(angle * (s + 1)) - std::sin(angle * s)) / angle;
      }
      rolling.roll(dq, load);
      if (s < 0) continue;
      for (std::size_t w = 0; w < p.waves.size(); ++w) {
        const double angle = 2 * pi * static_cast<double>(p.waves[w]) / steps;
        found[w].col(static_cast<Index>(j)) +=
            rolling.resultants() * std::polar(2.0 / steps / amplitude, -angle * (s + 1));
      }
    }
  }
  return found;
}

}  // namespace

std::size_t runs_of_steps(const EllipseResponseParameters& p) { return 2 * p.step_ratios.size(); }

Table steps_table(const EllipseResponseParameters& p, const std::function<void()>& advance) {
  Table table("steps", "errors of transient schemes on a circle, over the steady coefficients",
              {{"scheme", "1", "remembered: joined rows; direct: equal rectangles, as CONTACT"},
               {"step_ratio", "1", "c = dq/dx"},
               {"wavelength", "1", "L/a"},
               {"C11", "1", "size of the error over the steady coefficient", 1e-6},
               {"C22", "1", "the same", 1e-6},
               {"C23", "1", "the same, of F_y by spin", 1e-6},
               {"C33", "1", "the same", 1e-6},
               {"largest", "1", "of the four", 1e-6}});
  const Index N = p.step_elements, M = (3 * N + 2) / 5;
  const Material material{1, p.poisson_ratio};
  const PatchFrequencyResponse exact(JoinedRows(1, p.reference, 5 * p.reference / 3),
                                     p.poisson_ratio);
  const Matrix3cd steady = exact.linear(0);
  std::vector<std::vector<std::vector<Cell>>> found_at(p.waves.size());
  const auto add = [&](const char* scheme, double step_ratio, const auto& make) {
    const auto steps =
        static_cast<int>(std::lround(p.period * static_cast<double>(N) / (2 * step_ratio)));
    const Responses found = rolled(p, make, steps);
    for (std::size_t w = 0; w < p.waves.size(); ++w) {
      const double wavelength = p.period / static_cast<double>(p.waves[w]);
      const Matrix3cd error = found[w] - exact.linear(2 * pi / wavelength);
      const auto of = [&](Index i, Index k) { return std::abs(error(i, k) / steady(i, k)); };
      const std::array<double, 4> each{of(0, 0), of(1, 1), of(1, 2), of(2, 2)};
      found_at[w].push_back({scheme, step_ratio, wavelength, each[0], each[1], each[2], each[3],
                             std::ranges::max(each)});
    }
    advance();
  };
  for (const double c : p.step_ratios) {
    add("remembered", c, [&] {
      return PatchRolling({.material = material, .bound = circle, .rows = M, .elements = N});
    });
  }
  for (const double c : p.step_ratios) {
    add("direct", c, [&] {
      return RectangleRolling({.material = material, .bound = circle, .elements = N, .rows = N});
    });
  }
  for (const auto& rows : found_at) {
    for (const std::vector<Cell>& row : rows) table.add(row);
  }
  return table;
}

}  // namespace microslip::experiments::ellipse_response_study
