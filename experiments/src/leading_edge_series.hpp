// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "microslip/experiments/leading_edge.hpp"
#include "microslip/halfspace/basis.hpp"

namespace microslip::experiments::leading_edge_study {

/// One treatment of the leading edge.
struct Scheme {
  std::string name;
  std::function<Basis(double)> basis;  ///< by the leading offset
  bool edge_known = false;
};

struct Setting {
  double offset;
  double trailing_offset;
  double stick_ratio;
  Eigen::Index elements;
};

/// Errors of one scheme, offset and stick ratio over all sizes.
struct Series {
  std::string scheme;
  double offset;
  double trailing_offset;
  double stick_ratio;
  std::vector<double> traction;
  std::vector<double> force;
};

/// Lists all treatments in the order of the tables.
std::vector<Scheme> schemes();

/// Finds the scheme of that name.
Scheme scheme_of(const std::string& name);

/// Tells whether a scheme applies: the thesis's edge function (C.1) needs an element that ends at
/// the edge.
bool applies(const Scheme& scheme, double offset);

Compared solve(const LeadingEdgeParameters& p, const Scheme& scheme, const Setting& setting);

/// Solves by every scheme that applies, for all offsets and stick ratios.
std::vector<Series> solve_all(const LeadingEdgeParameters& p, const Progress& progress);

/// Returns the factors by which each doubling of N reduces the errors.
std::vector<double> reductions(const std::vector<double>& errors);

double mean(const std::vector<double>& values);
double largest(const std::vector<double>& values);

}  // namespace microslip::experiments::leading_edge_study
