// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/smoothing.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/experiments/claims.hpp"
#include "microslip/experiments/profile.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/support/format.hpp"
#include "microslip/thesis/symbol.hpp"
#include "rolled_tables.hpp"
#include "study_keys.hpp"

namespace microslip::experiments {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Parameters = SmoothingParameters;

/// A^-1 A' for steps of any length.
class Transport {
 public:
  Transport(const Parameters& p, Basis basis)
      : kernel_(p.rolling.kernel),
        basis_(std::move(basis)),
        spacing_(p.rolling.grid.spacing()),
        size_(p.pulse_elements),
        factors_(influence_matrix(kernel_, basis_, spacing_, size_)) {}

  MatrixXd matrix(double step_ratio) const {
    const MatrixXd difference =
        influence_difference_matrix(kernel_, basis_, spacing_, size_, step_ratio);
    return MatrixXd::Identity(size_, size_) - factors_.solve_columns(difference);
  }

  /// Moves a unit pulse from the middle over a distance in elements; the last step is shortened.
  VectorXd pulse(double step_ratio, double distance) const {
    VectorXd traction = VectorXd::Unit(size_, size_ / 2);
    const double full_steps = std::floor(distance / step_ratio * (1 + 1e-12));
    const MatrixXd step = matrix(step_ratio);
    for (double k = 0; k < full_steps; ++k) traction = step * traction;
    const double rest = distance - full_steps * step_ratio;
    if (rest > 1e-9 * step_ratio) traction = matrix(rest) * traction;
    return traction;
  }

 private:
  Kernel kernel_;
  Basis basis_;
  double spacing_;
  Index size_;
  LuFactors factors_;
};

struct Tables {
  Table pulse{"pulse",
              "A^-1 A' on a unit pulse, thesis Figs. 4.1 and 4.2",
              {{"basis", "1", "traction functions"},
               {"step_ratio", "1", "c = dq/dx"},
               {"distance", "dx", "travelled: one step, or the distance of the scene"},
               {"position", "dx", "from where the pulse started"},
               {"traction", "1", "what has become of the pulse"}}};
  Table pulse_summary{"pulse_summary",
                      "the shape of the pulse; exact: all of it at -distance",
                      {{"basis", "1", "traction functions"},
                       {"step_ratio", "1", "c = dq/dx"},
                       {"distance", "dx", "travelled"},
                       {"sum", "1", "sum of the column; exact: 1"},
                       {"peak", "1", "largest value; exact: 1"},
                       {"peak_position", "dx", "from where the pulse started"},
                       {"width", "dx", "at half the peak; of one element: 1"},
                       {"least", "1", "smallest value; exact: 0", 1e-12},
                       {"total_variation", "1", "sum of rises and falls; exact: 2"}}};
  Table amplification{
      "amplification",
      "what a step does to the traction exp(i theta k) in adhesion",
      {{"basis", "1", "traction functions"},
       {"step_ratio", "1", "c = dq/dx"},
       {"frequency", "1", "theta / pi, below 1, which would alternate from node to node"},
       {"magnitude", "1", "|g| of one step; exact: 1"},
       {"damping", "1", "|g|^(1/c), the factor of one element travelled; exact: 1"},
       {"speed", "1", "arg g / (c theta); exact: 1"}}};
};

void add_pulse(Tables& tables, const std::string& basis, double step_ratio, double distance,
               const VectorXd& values) {
  const auto start = static_cast<double>(values.size() / 2);
  for (Index i = 0; i < values.size(); ++i) {
    tables.pulse.add({basis, step_ratio, distance, static_cast<double>(i) - start, values[i]});
  }
  const Peak peak = peak_of(values);
  tables.pulse_summary.add({basis, step_ratio, distance, values.sum(), peak.height,
                            peak.position - start, peak.width, values.minCoeff(),
                            total_variation(values)});
}

void add_amplification(Tables& tables, const Parameters& p, const Basis& basis, double c) {
  constexpr double lowest = 1.0 / 32;
  const Amplification g(p.rolling.kernel, basis.shapes().front(), p.rolling.grid.spacing(), c);
  for (Index k = 1; k < p.frequencies; ++k) {
    const double frequency = static_cast<double>(k) / static_cast<double>(p.frequencies);
    if (frequency < lowest) continue;
    const double exact_phase = c * frequency * std::numbers::pi;
    const std::complex<double> value = g(frequency * std::numbers::pi);
    const double phase = exact_phase + std::arg(value * std::polar(1.0, -exact_phase));
    const double magnitude = std::abs(value);
    tables.amplification.add(
        {basis.name(), c, frequency, magnitude, std::pow(magnitude, 1 / c), phase / exact_phase});
  }
}

void add_pulses(Tables& tables, const Parameters& p, const Basis& basis) {
  const Transport transport(p, basis);
  for (const double c : p.step_ratios) {
    add_pulse(tables, basis.name(), c, c, transport.pulse(c, c));
    add_pulse(tables, basis.name(), c, p.distance, transport.pulse(c, p.distance));
    add_amplification(tables, p, basis, c);
  }
}

/// Judges the thesis's statements on A^-1 A', with constant functions and the thesis's step ratios.
std::vector<Claim> pulse_claims(const Parameters& p) {
  const Transport transport(p, constant_basis());
  const MatrixXd unit = transport.matrix(1);
  const Index n = unit.rows();
  const double off_shift =
      (unit.rightCols(n - 1) - MatrixXd::Identity(n, n).leftCols(n - 1)).cwiseAbs().maxCoeff();
  double worst_sum = 1;
  for (const double c : {0.8, 0.5, 0.2, 0.05}) {
    const double sum = transport.pulse(c, c).sum();
    if (std::abs(sum - 1) > std::abs(worst_sum - 1)) worst_sum = sum;
  }
  const auto after = [&](double c) { return transport.pulse(c, p.distance); };
  const auto motion = [&](double c) {
    return static_cast<double>(n / 2) - peak_of(after(c)).position;
  };
  const double fast = motion(0.8), even = motion(0.5), slow = motion(0.2);
  const double highest = std::max(peak_of(after(0.8)).height, peak_of(after(0.5)).height);
  const VectorXd wiggly = after(0.05);
  const auto motion_at = [&](double c) {
    return fmt::format("motion at c = {} in dx of the peak after {} dx", c,
                       format_short(p.distance));
  };
  return {
      {"c = 1: A^-1 A' has a one before the diagonal and zeros elsewhere, except for a column", "4",
       0, off_shift, "1", holds_if({within(1e-9, 0)}), "largest deviation from that",
       "smoothing_pulse"},
      {"the columns of A^-1 A' sum up to one for all c", "4", 1, worst_sum, "1",
       holds_if({within(1e-6, 1)}), "of the middle column, the c furthest from one", no_figure},
      {"smoothing appears whenever c is not an integer", "4", not_given, highest, "1",
       holds_if({below(0.5), {"the height for c = 1", peak_of(after(1)).height, within(1e-9, 1)}}),
       "largest height of a unit pulse after the distance, c = 0.8 or 0.5; 1 for c = 1",
       "smoothing_pulse"},
      {"c > 1/2: the forward motion is overestimated", "4", not_given, fast, "dx",
       holds_if({above(p.distance + 0.5)}), motion_at(0.8), "smoothing_pulse"},
      {"c = 1/2: the forward motion is overestimated", "4", not_given, even, "dx",
       holds_if({above(p.distance + 0.01)}, {within(0.01, p.distance)}),
       motion_at(0.5) + ": by symmetry all frequencies travel at the right speed",
       "smoothing_pulse"},
      {"c < 1/2: the forward motion is underestimated", "4", not_given, slow, "dx",
       holds_if({below(p.distance - 0.5)}), motion_at(0.2), "smoothing_pulse"},
      {"a small c may even add or amplify wiggles", "4", not_given, total_variation(wiggly), "1",
       holds_if({above(2),
                 {"the number of its local extrema",
                  static_cast<double>(turning_points(wiggly, 1e-3)), above(5)}}),
       "total variation of a unit pulse at c = 0.05 after the distance; at the start 2",
       "smoothing_pulse"}};
}

Table claims_of(const Parameters& p, const Table& summary) {
  std::vector<Claim> claims = pulse_claims(p);
  double fast = 0, slow = 0;
  for (std::size_t i = 0; i < summary.rows(); ++i) {
    const double c = summary.number(i, "step_ratio");
    const double motion = summary.number(i, "flank_motion");
    if (c > 0.5 && c < 1) fast = std::max(fast, motion);
    if (c < 0.5) slow = std::min(slow, motion);
  }
  claims.push_back({"Cattaneo to Carter looks very similar", "4", not_given, slow, "dx",
                    holds_if({below(-0.5), {"that for c > 1/2", fast, above(0.5)}}),
                    fmt::format("the flank is ahead of the reference by this for c < 1/2, by {} "
                                "dx for c > 1/2",
                                format_short(std::round(100 * fast) / 100)),
                    "smoothing_traction"});
  return claims_table(claims);
}

}  // namespace

SmoothingParameters read_smoothing(Scene& scene) {
  using P = SmoothingParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::step_ratios, "step.ratios", "c; the first is a whole number",
        range_from(min_step_ratio)},
       {&P::distance, "motion.elements_rolled", "distance, in elements", above_zero},
       {&P::pulse_elements, "pulse.elements", "N of the pulse, which starts in the middle",
        range(3, 2001), odd},
       {&P::frequencies, "spectrum.frequencies", "of the amplification factor", range(8, 1000)},
       {&P::refinement, "reference.refinement", "elements of the reference for each one",
        range(2, 1000)}});
  return keys.read({.rolling = read_cattaneo_to_carter(scene)});
}

std::vector<Table> smoothing(const SmoothingParameters& p, const Progress& progress) {
  Tables tables;
  const std::size_t total = p.step_ratios.size() + 2;
  for (const Basis& basis : {constant_basis(), linear_basis()}) {
    add_pulses(tables, p, basis);
  }
  progress(2, total);
  RolledTables rolled(p.rolling, p.refinement);
  for (const double c : p.step_ratios) {
    rolled.add("direct", Direct{}, c, p.distance);
    progress(2 + rolled.summary().rows(), total);
  }
  return {
      tables.pulse,       tables.pulse_summary, tables.amplification,          rolled.traction(),
      rolled.reference(), rolled.summary(),     claims_of(p, rolled.summary())};
}

}  // namespace microslip::experiments
