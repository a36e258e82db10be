// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/basis_convergence.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "microslip/experiments/claims.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/convergence.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

namespace {

/// A basis for the displacements, and a basis whose weights integrate the traction. The two differ
/// for (B.30), whose slip is in the influence coefficients, while the traction follows (B.7).
struct Variant {
  Basis basis;
  Basis traction;
};

std::vector<Variant> variants() {
  return {{constant_basis(), constant_basis()},
          {linear_basis(), linear_basis()},
          {quadratic_basis(), quadratic_basis()},
          {quadratic_basis_as_printed(), quadratic_basis()}};
}

struct Errors {
  std::vector<double> sizes;
  std::vector<double> force;
  std::vector<double> point;
  std::vector<double> mean;
};

/// nan without errors, as where the point slips: its traction is the bound.
double order_if_any(const std::vector<double>& sizes, const std::vector<double>& errors) {
  const bool has_errors = std::ranges::all_of(errors, [](double error) { return error > 0; });
  return has_errors ? fitted_order(sizes, errors) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

BasisConvergenceParameters read_basis_convergence(Scene& scene) {
  using P = BasisConvergenceParameters;
  const StudyKeys<P> keys(
      scene, {{&P::length, "kernel.length"},
              {&P::sizes, "grid.sizes", "numbers N of nodes", range(3, 10000),
               Demand("two or more, odd, so that a node lies at the centre", is_odd, nullptr, 2)},
              {&P::leading_offset, "grid.leading_offset"},
              {&P::trailing_offset, "grid.trailing_offset"},
              {&P::step_ratio, "step.ratio"},
              {&P::stick_ratio, "load.stick_ratio", "part a' of the contact that sticks",
               inner_fraction}});
  return keys.read({.material = read_material(scene), .bound = read_hertz_bound(scene)});
}

std::vector<Table> basis_convergence(const BasisConvergenceParameters& p,
                                     const Progress& progress) {
  const Carter exact = Carter::from_stick_ratio(p.material, p.bound, p.stick_ratio);
  Table errors("errors", "errors against Carter for rising N",
               {{"basis", "1", "traction functions"},
                {"elements", "1", "number of nodes N"},
                {"force_error", "1", "|force / exact - 1|, by the functions' own weights"},
                {"point_error", "N/mm^2", "|traction - exact| at x = 0; 0 if it slips"},
                {"mean_error", "N/mm^2", "mean over the nodes of |traction - exact|"},
                {"iterations", "1", "linear systems factorised"}});
  std::map<std::string, Errors> found;
  const std::vector<Variant> all = variants();
  for (const auto& [basis, traction] : all) {
    Errors& series = found[basis.name()];
    for (const Eigen::Index n : p.sizes) {
      const Grid grid({.half_width = p.bound.half_width(),
                       .elements = n,
                       .leading_offset = p.leading_offset,
                       .trailing_offset = p.trailing_offset});
      const SteadySolution s =
          solve_steady({.contact = {PlaneKernel(p.material, p.length), p.bound},
                        .grid = grid,
                        .basis = basis,
                        .method = Differences{.step_ratio = p.step_ratio},
                        .load = PrescribedCreepage{exact.creepage()}});
      const double force = traction.weights(grid.spacing(), n).dot(s.traction);
      const Eigen::VectorXd difference =
          s.traction - s.x.unaryExpr([&](double x) { return exact.traction(x); });
      series.sizes.push_back(static_cast<double>(n));
      series.force.push_back(std::abs(force / exact.force() - 1));
      series.point.push_back(std::abs(difference[n / 2]));
      series.mean.push_back(difference.cwiseAbs().mean());
      errors.add({basis.name(), n, series.force.back(), series.point.back(), series.mean.back(),
                  s.iterations});
      progress(errors.rows(), all.size() * p.sizes.size());
    }
  }
  Table orders("orders", "orders fitted over all N",
               {{"basis", "1", "traction functions"},
                {"force_order", "1", "of force_error"},
                {"point_order", "1", "of point_error; nan if that is 0"},
                {"mean_order", "1", "of mean_error"}});
  for (const Variant& variant : all) {
    const Errors& series = found.at(variant.basis.name());
    orders.add({variant.basis.name(), fitted_order(series.sizes, series.force),
                order_if_any(series.sizes, series.point), fitted_order(series.sizes, series.mean)});
  }
  const auto last = [&](const std::string& basis) { return found.at(basis).force.back(); };
  const auto order = [&](const std::string& basis) {
    return fitted_order(found.at(basis).sizes, found.at(basis).force);
  };
  const std::string printed = "quadratic as printed";
  const auto& stalled = found.at(printed).force;
  const double last_gain = stalled[stalled.size() - 2] / stalled.back();
  const double best = last("quadratic") / last("linear");
  const std::string at_last = fmt::format("force at N = {}", p.sizes.back());
  const Table claims = claims_table(
      {{"linear functions have a slightly lower error than constant ones", "6.4.1", not_given,
        last("linear") / last("constant"), "1", holds_if({below(1)}),
        at_last + ": error of linear over the error of constant functions",
        "basis_convergence_error"},
       {"linear functions converge no faster than constant ones", "6.4.1", not_given,
        order("linear") - order("constant"), "1", holds_if({within(0.1, 0)}),
        "difference of the fitted orders of the force", "basis_convergence_error"},
       {"quadratic functions: after some refinement no more improvement", "6.4.1", not_given,
        last_gain, "1", holds_if({below(1.1)}),
        "reduction of the force error in the last doubling, limits as printed in (B.30)",
        "basis_convergence_error"},
       {"quadratic functions make the convergence worse", "6.4.1", not_given, best, "1",
        holds_if({above(1)}),
        at_last +
            ": error of quadratic over the error of linear functions, limits corrected to +-2",
        "basis_convergence_error"}});
  return {errors, orders, claims};
}

}  // namespace microslip::experiments
