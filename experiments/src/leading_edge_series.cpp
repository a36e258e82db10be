// SPDX-License-Identifier: GPL-3.0-or-later
#include "leading_edge_series.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "microslip/thesis/edge_displacement.hpp"

namespace microslip::experiments::leading_edge_study {

std::vector<Scheme> schemes() {
  return {{"standard constant", [](double) { return constant_basis(); }},
          {"standard linear", [](double) { return linear_basis(); }},
          {"known edge constant", [](double) { return constant_basis(); }, true},
          {"known edge linear", [](double) { return linear_basis(); }, true},
          {"trimmed linear", [](double offset) { return trimmed_linear_basis(offset); }},
          {"edge function", [](double) { return edge_constant_basis(); }}};
}

Scheme scheme_of(const std::string& name) {
  const std::vector<Scheme> all = schemes();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Scheme& s) { return s.name == name; });
  if (found == all.end()) throw std::logic_error("no such scheme: " + name);
  return *found;
}

bool applies(const Scheme& scheme, double offset) {
  return scheme.name != "edge function" || offset == 0.5;
}

Compared solve(const LeadingEdgeParameters& p, const Scheme& scheme, const Setting& setting) {
  const Carter carter = Carter::from_stick_ratio(p.material, p.bound, setting.stick_ratio);
  const PlaneKernel kernel(p.material, p.length);
  const Grid grid({.half_width = p.bound.half_width(),
                   .elements = setting.elements,
                   .leading_offset = setting.offset,
                   .trailing_offset = setting.trailing_offset});
  SteadyProblem problem{.contact = {kernel, p.bound},
                        .grid = grid,
                        .basis = scheme.basis(setting.offset),
                        .method = Differences{},
                        .load = PrescribedCreepage{carter.creepage()}};
  if (scheme.edge_known) {
    problem.method = Differences{.edge_displacement = edge_displacement(kernel, carter)};
  }
  return compared(problem, truth_of(carter));
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

std::vector<double> reductions(const std::vector<double>& errors) {
  std::vector<double> factors;
  for (std::size_t i = 1; i < errors.size(); ++i) factors.push_back(errors[i - 1] / errors[i]);
  return factors;
}

std::vector<Series> solve_all(const LeadingEdgeParameters& p, const Progress& progress) {
  std::vector<Series> all;
  for (const Scheme& scheme : schemes()) {
    for (const double offset : p.leading_offsets) {
      if (!applies(scheme, offset)) continue;
      for (const double trailing : p.trailing_offsets) {
        for (const double stick_ratio : p.stick_ratios) {
          all.push_back({scheme.name, offset, trailing, stick_ratio, {}, {}});
        }
      }
    }
  }
  std::size_t done = 0;
  for (Series& series : all) {
    const Scheme scheme = scheme_of(series.scheme);
    for (const Eigen::Index n : p.sizes) {
      const Compared solved =
          solve(p, scheme, {series.offset, series.trailing_offset, series.stick_ratio, n});
      series.traction.push_back(solved.traction_error);
      series.force.push_back(solved.force_error);
    }
    progress(++done, all.size());
  }
  return all;
}

}  // namespace microslip::experiments::leading_edge_study
