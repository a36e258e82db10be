// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/ellipse_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "ellipse_response_steps.hpp"
#include "microslip/experiments/claims.hpp"
#include "microslip/halfspace/material.hpp"
#include "microslip/patch/patch_frequency.hpp"
#include "microslip/reference/kalker.hpp"
#include "microslip/rolling/frequency_response.hpp"
#include "microslip/support/convergence.hpp"
#include "study_keys.hpp"
#include "table_values.hpp"

namespace microslip::experiments {

using Eigen::Index;
using std::numbers::pi;
using Complex = std::complex<double>;

namespace {

constexpr std::array<const char*, 4> names{"C11", "C22", "C23", "C33"};
using Coefficients = std::array<Complex, 4>;

constexpr double up_to_rounding = 1e-7;

/// C23 is the mean of both that should be equal by reciprocity.
Coefficients coefficients_of(const Eigen::Matrix3cd& linear) {
  return {-linear(0, 0), -linear(1, 1), (linear(2, 1) - linear(1, 2)) / 2.0, -linear(2, 2)};
}

PatchFrequencyResponse response_of(double aspect, Index rows, double poisson_ratio) {
  const auto elements = static_cast<Index>(std::lround(5.0 * static_cast<double>(rows) / 3));
  return {JoinedRows(aspect, rows, elements), poisson_ratio};
}

/// An ellipse, for wavelengths over its half-width along the rolling; its size is 1.
struct Waves {
  double half_width;

  explicit Waves(double aspect) : half_width(std::sqrt(aspect)) {}
  double number(double wavelength) const { return 2 * pi / (wavelength * half_width); }
};

/// Resultants of a rigid shift without rolling, over G, in the ellipse with a b = 1: by a shift
/// along, and across. Both are stiffnesses of a flat punch that does not slip.
std::array<double, 2> shift_stiffness(double aspect, double nu) {
  const double a = std::sqrt(aspect), b = 1 / a;
  constexpr int points = 4000;
  std::array<double, 2> compliance{};
  for (int i = 0; i < points; ++i) {  // a periodic function
    const double alpha = (i + 0.5) * pi / points;
    const double x = a * std::cos(alpha), y = b * std::sin(alpha), length2 = x * x + y * y;
    const double weight = pi / points / std::sqrt(length2) / (2 * pi);
    compliance[0] += weight * (1 - nu + nu * x * x / length2);
    compliance[1] += weight * (1 - nu + nu * y * y / length2);
  }
  return {1 / compliance[0], 1 / compliance[1]};
}

/// Turns of a circle without slip, over the angle: 8/3 G a^3 for two bodies (Reissner and Sagoci).
constexpr double turn_stiffness = 8.0 / 3;

/// The response of one ellipse by the reference.
struct Reference {
  double aspect;
  PatchFrequencyResponse rows, coarser;
  Coefficients steady;

  Reference(double of, const EllipseResponseParameters& p)
      : aspect(of),
        rows(response_of(of, p.reference, p.poisson_ratio)),
        coarser(response_of(of, p.reference * 2 / 3, p.poisson_ratio)),
        steady(coefficients_of(rows.linear(0))) {}

  Coefficients at(double wavelength) const {
    return coefficients_of(rows.linear(Waves(aspect).number(wavelength)));
  }
};

struct Tables {
  Table coefficients{
      "coefficients",
      "Kalker's coefficients over the wavelength of creepage and spin",
      {{"aspect", "1", "a/b, a along the rolling"},
       {"wavelength", "1", "L/a"},
       {"coefficient", "1",
        "C11: F_x by creepage; C22: F_y by lateral creepage; C23: F_y by spin and M_z by lateral "
        "creepage; C33: M_z by spin"},
       {"real", "1",
        "F_x = -G c^2 C11 xi, F_y = -G c^2 C22 eta - G c^3 C23 phi, M_z = G c^3 C23 eta - G c^4 "
        "C33 phi, c^2 = a b; in phase with the creepage"},
       {"imaginary", "1", "a quarter of a wave earlier, of creepages exp(2 pi i q/L)"},
       {"size", "1", "modulus, over that of the steady coefficient"},
       {"phase", "degrees", "of the coefficient"},
       {"error", "1", "estimate: 4/5 of the change from two thirds of the rows and cells", 1e-6}}};
  Table curves{"curves",
               "the same over the steady coefficients, for curves",
               {{"aspect", "1", "a/b"},
                {"wavelength", "1", "L/a"},
                {"coefficient", "1", "C11, C22, C23 or C33"},
                {"real", "1", "real part over the steady coefficient"},
                {"imaginary", "1", "imaginary part over it"}}};
  Table errors{
      "errors",
      "errors against the reference, over the steady coefficients",
      {{"aspect", "1", "a/b"},
       {"rows", "1", "M"},
       {"elements", "1", "N"},
       {"wavelength", "1", "L/a"},
       {"cells_a_wave", "1", "L over the longest cell of the longest row"},
       {"C11", "1", "size of the error over the steady coefficient", up_to_rounding},
       {"C22", "1", "the same", up_to_rounding},
       {"C23", "1", "the same", up_to_rounding},
       {"C33", "1", "the same", up_to_rounding},
       {"largest", "1", "of the four", up_to_rounding},
       {"own", "1", "the largest error over the coefficient at that wavelength", up_to_rounding}}};
  Table orders{"orders",
               "orders of the errors in the number of cells along an axis",
               {{"aspect", "1", "a/b"},
                {"order", "1",
                 "of the largest error of the four over L/a from convergence.resolved on, fitted "
                 "over all rows",
                 0.05}}};
  Table lines{
      "lines",
      "the response of a line contact in the place of an ellipse, over its steady slope",
      {{"aspect", "1", "a/b"},
       {"wavelength", "1", "L/a"},
       {"coefficient", "1", "C11 or C22"},
       {"ellipse_real", "1", "of the coefficient over the steady one"},
       {"ellipse_imaginary", "1", "the same"},
       {"strip_real", "1", "of a strip of the width pi b/2, which has the area of the ellipse"},
       {"strip_imaginary", "1", "the same"},
       {"difference", "1", "size of the difference"}}};
  Table limits{"limits",
               "long waves and short ones",
               {{"aspect", "1", "a/b"},
                {"coefficient", "1", "C11, C22, C23 or C33"},
                {"steady", "1", "by the reference, for an infinite wavelength"},
                {"steady_error", "1", "relative, against Galin's theorem", 1e-6},
                {"wavelength", "1", "L/a, the shortest"},
                {"short_stiffness", "1", "2 pi c/L times the size of the coefficient there"},
                {"short_phase", "degrees", "its phase"},
                {"punch", "1", "its limit, a flat punch that sticks; nan where not given"},
                {"most_size", "1", "largest size of the coefficient over the steady one"},
                {"most_wavelength", "1", "L/a where it is largest"},
                {"least_real", "1", "least real part over the steady coefficient"},
                {"reciprocity", "1", "largest size of C23 - C32, over C23 of long waves", 1e-6}}};
};

double degrees(const Complex& value) { return std::arg(value) * 180 / pi; }

void add_reference(Tables& tables, const EllipseResponseParameters& p, const Reference& of) {
  const Waves waves(of.aspect);
  for (const double wavelength : p.wavelengths) {
    const Coefficients found = of.at(wavelength);
    const Coefficients coarse = coefficients_of(of.coarser.linear(waves.number(wavelength)));
    for (std::size_t j = 0; j < names.size(); ++j) {
      tables.coefficients.add({of.aspect, wavelength, names[j], found[j].real(), found[j].imag(),
                               std::abs(found[j] / of.steady[j]), degrees(found[j]),
                               0.8 * std::abs(found[j] - coarse[j])});
    }
  }
  std::array<double, 4> most{}, where{}, least{};
  double reciprocity = 0;
  std::array<std::vector<std::vector<Cell>>, 4> curves;
  for (Index i = 0; i < p.points; ++i) {
    const double wavelength = log_spaced(p.shortest, p.longest, i, p.points);
    const Eigen::Matrix3cd linear = of.rows.linear(waves.number(wavelength));
    const Coefficients found = coefficients_of(linear);
    reciprocity = std::max(reciprocity, std::abs((linear(1, 2) + linear(2, 1)) / of.steady[2]));
    for (std::size_t j = 0; j < names.size(); ++j) {
      const Complex over_steady = found[j] / of.steady[j];
      curves[j].push_back(
          {of.aspect, wavelength, names[j], over_steady.real(), over_steady.imag()});
      least[j] = std::min(least[j], over_steady.real());
      if (std::abs(over_steady) <= most[j]) continue;
      most[j] = std::abs(over_steady);
      where[j] = wavelength;
    }
  }
  for (const auto& rows : curves) {
    for (const std::vector<Cell>& row : rows) tables.curves.add(row);
  }
  const CreepCoefficients exact = creep_coefficients(of.aspect, p.poisson_ratio).value;
  const std::array<double, 4> steady{exact.c11, exact.c22, (exact.c23 + exact.c32) / 2, exact.c33};
  const std::array<double, 2> shift = shift_stiffness(of.aspect, p.poisson_ratio);
  const std::array<double, 4> punch{shift[0], shift[1], not_given,
                                    of.aspect == 1 ? turn_stiffness : not_given};
  const Coefficients at_shortest = of.at(p.wavelengths.front());
  for (std::size_t j = 0; j < names.size(); ++j) {
    tables.limits.add(
        {of.aspect, names[j], of.steady[j].real(), std::abs(of.steady[j].real() / steady[j] - 1),
         p.wavelengths.front(), waves.number(p.wavelengths.front()) * std::abs(at_shortest[j]),
         degrees(at_shortest[j]), punch[j], most[j], where[j], least[j], reciprocity});
  }
}

void add_errors(Tables& tables, const EllipseResponseParameters& p, const Reference& of,
                const auto& advance) {
  const Waves waves(of.aspect);
  std::vector<double> sizes, resolved;
  std::vector<std::vector<std::vector<Cell>>> found_at(p.wavelengths.size());
  for (const Index rows : p.rows) {
    const PatchFrequencyResponse response = response_of(of.aspect, rows, p.poisson_ratio);
    const Index elements = response.rows().elements();
    double most = 0;
    for (std::size_t w = 0; w < p.wavelengths.size(); ++w) {
      const double wavelength = p.wavelengths[w];
      const Coefficients exact = of.at(wavelength);
      const Coefficients found = coefficients_of(response.linear(waves.number(wavelength)));
      std::array<double, 4> error{};
      double own = 0;
      for (std::size_t j = 0; j < names.size(); ++j) {
        error[j] = std::abs((found[j] - exact[j]) / of.steady[j]);
        own = std::max(own, std::abs(found[j] / exact[j] - 1.0));
      }
      const double largest = std::ranges::max(error);
      const double cells = wavelength * static_cast<double>(elements) / pi;
      found_at[w].push_back({of.aspect, rows, elements, wavelength, cells, error[0], error[1],
                             error[2], error[3], largest, own});
      if (wavelength >= p.resolved) most = std::max(most, largest);
    }
    sizes.push_back(static_cast<double>(rows));
    resolved.push_back(most);
    advance();
  }
  for (const auto& rows : found_at) {
    for (const std::vector<Cell>& row : rows) tables.errors.add(row);
  }
  tables.orders.add({of.aspect, fitted_order(sizes, resolved)});
}

/// The strip of the area of the ellipse, as in the study ellipse_convergence.
void add_lines(Tables& tables, const EllipseResponseParameters& p, const Reference& of) {
  const double a = std::sqrt(of.aspect), b = 1 / a;
  for (std::size_t j = 0; j < 2; ++j) {
    const Material material{1, p.poisson_ratio};
    const StripKernel kernel(j == 0 ? material : lateral(material), pi * b / 2);
    const FrequencyResponse line(kernel, -a, a, p.wavelengths.front() * a);
    for (const double wavelength : p.wavelengths) {
      const Complex ellipse = of.at(wavelength)[j] / of.steady[j];
      const Complex strip = line.slope(wavelength * a) / line.steady_slope();
      tables.lines.add({of.aspect, wavelength, names[j], ellipse.real(), ellipse.imag(),
                        strip.real(), strip.imag(), std::abs(ellipse - strip)});
    }
  }
}

/// Values on a circle, nu = 1/4, by two other methods: scaled rows, and rectangles with differences,
/// made for this project. They agree to 2e-4 of the steady coefficients; C33 has three digits.
struct OtherMethods {
  double wavelength;
  Coefficients value;
};
const std::array<OtherMethods, 3> other_methods{
    {{100, {{{4.0814, -.3716}, {3.6478, -.2871}, {1.4540, -.1552}, {1.189, .018}}}},
     {10, {{{2.2376, -2.1853}, {2.2750, -1.9179}, {.6585, -.9806}, {1.446, -.098}}}},
     {2.5, {{{.0653, -.9431}, {.0670, -.9547}, {-.3006, -.1009}, {.682, -1.062}}}}}};

/// The largest difference from them, over the steady coefficients.
double from_other_methods(const EllipseResponseParameters& p) {
  const PatchFrequencyResponse rows = response_of(1, p.rows.back(), 0.25);
  const Coefficients steady = coefficients_of(rows.linear(0));
  double largest = 0;
  for (const OtherMethods& of : other_methods) {
    const Coefficients found = coefficients_of(rows.linear(Waves(1).number(of.wavelength)));
    for (std::size_t j = 0; j < names.size(); ++j) {
      largest = std::max(largest, std::abs((found[j] - of.value[j]) / steady[j]));
    }
  }
  return largest;
}

/// The order of a scheme in the step, of its largest error over all waves; and that error by c.
struct StepErrors {
  std::vector<double> errors;
  double order;

  StepErrors(const Table& steps, const char* scheme, const std::vector<double>& ratios) {
    std::vector<double> steps_a_length;
    for (const double c : ratios) {
      errors.push_back(most(steps, "largest", {{"scheme", scheme}, {"step_ratio", c}}));
      steps_a_length.push_back(1 / c);
    }
    order = fitted_order(steps_a_length, errors);
  }
};

Table claims_of(const EllipseResponseParameters& p, const Tables& tables, const Table& steps) {
  constexpr double rows = 12, cells_a_wave = 6;
  const char *by_error = "ellipse_response_error", *by_size = "ellipse_response_bode",
             *by_plane = "ellipse_response_nyquist";
  const auto is_force = [&](std::size_t i) {
    return has(tables.limits, i, {{"coefficient", "C11"}}) ||
           has(tables.limits, i, {{"coefficient", "C22"}});
  };
  double from_punch = 0, phase = 0;
  for (std::size_t i = 0; i < tables.limits.rows(); ++i) {
    if (!is_force(i)) continue;
    const Table& of = tables.limits;
    from_punch =
        std::max(from_punch, std::abs(of.number(i, "short_stiffness") / of.number(i, "punch") - 1));
    phase = std::max(phase, std::abs(of.number(i, "short_phase") + 90));
  }
  const StepErrors remembered(steps, "remembered", p.step_ratios);
  const StepErrors direct(steps, "direct", p.step_ratios);
  return claims_table(
      {{"12 rows of 20 cells have all coefficients to a thousandth of the steady ones, for waves "
        "as long as the half-width or longer",
        "none", not_given, most(tables.errors, "largest", {{"rows", rows}}), "1",
        ours_if({below(1e-3)}), "largest error over a/b and wavelength", by_error},
       {"errors of joined rows fall at least in second order", "none", not_given,
        least(tables.orders, "order", {}), "1", ours_if({above(1.85)}),
        "least order over a/b, of the largest error over the wavelengths from convergence.resolved "
        "on",
        by_error},
       {"six cells a wave are enough for two percent of each coefficient", "none", not_given,
        extreme(
            tables.errors, "own", false,
            [&](std::size_t i) { return tables.errors.number(i, "cells_a_wave") >= cells_a_wave; }),
        "1", ours_if({below(0.02)}),
        "largest error over the coefficient at its wavelength; cells are the longest ones",
        by_error},
       {"long waves have Kalker's coefficients", "none", not_given,
        most(tables.limits, "steady_error", {}), "1", ours_if({below(1e-4)}),
        "largest relative error against Galin's theorem", by_error},
       {"two other methods have the same values", "none", not_given, from_other_methods(p), "1",
        ours_if({below(8e-4)}),
        "largest difference over the steady coefficients, on a circle, L/a = 100, 10 and 2.5; "
        "their C33 has three digits",
        by_plane},
       {"the response is reciprocal: C23 is C32 at all wavelengths", "none", not_given,
        most(tables.limits, "reciprocity", {}), "1", ours_if({below(1e-3)}),
        "largest difference over the steady coefficient", no_figure},
       {"short waves shift the bodies like a flat punch that does not roll", "none", not_given,
        from_punch, "1", ours_if({below(0.03)}),
        "largest relative difference of 2 pi c/L C11 and C22 at the shortest wavelength of the "
        "table from the stiffness of a shift",
        by_size},
       {"forces by short waves come a quarter of a wave after the creepage", "none", not_given,
        phase, "degrees", ours_if({below(4)}), "largest difference of the phase from -90 degrees",
        by_size},
       {"spin that oscillates has a larger moment than steady spin", "none", not_given,
        most(tables.limits, "most_size", {{"coefficient", "C33"}, {"aspect", 1.0}}), "1",
        ours_if({between(1.25, 1.4)}), "largest C33 over the steady one, on a circle", by_size},
       {"on long ellipses the moment of oscillating spin is many times that of steady spin", "none",
        not_given, most(tables.limits, "most_size", {{"coefficient", "C33"}}), "1",
        ours_if({above(5)}), "largest C33 over the steady one, over a/b", by_size},
       {"short waves of spin turn the lateral force round", "none", not_given,
        most(tables.limits, "least_real", {{"coefficient", "C23"}}), "1", ours_if({below(-0.1)}),
        "least real part of C23 over the steady one; the largest over a/b", by_plane},
       {"steps of half a cell that remember have one percent or less", "none", not_given,
        most(steps, "largest", {{"scheme", "remembered"}, {"step_ratio", 0.5}}), "1",
        ours_if({below(0.01)}), "largest error over the steady coefficient, on a circle",
        "ellipse_response_steps"},
       {"steps that remember converge", "none", not_given, remembered.order, "1",
        ours_if({above(1.4)}), "order of the largest error in the step", "ellipse_response_steps"},
       {"the standard scheme has several percent at steps of one element", "none", not_given,
        direct.errors.front(), "1", ours_if({above(0.03)}), "largest error, of C33",
        "ellipse_response_steps"},
       {"short steps make the standard scheme worse", "none", not_given,
        direct.errors.back() / direct.errors.front(), "1", ours_if({above(2)}),
        "largest error at the shortest step over that at the longest", "ellipse_response_steps"},
       {"a strip of the same area follows longitudinal creepages to a twentieth", "none", not_given,
        most(tables.lines, "difference", {{"coefficient", "C11"}}), "1", ours_if({below(0.05)}),
        "largest difference of the responses over their steady ones", "ellipse_response_bode"}});
}

}  // namespace

EllipseResponseParameters read_ellipse_response(Scene& scene) {
  using P = EllipseResponseParameters;
  const StudyKeys<P> keys(
      scene,
      {{&P::aspects, "ellipse.aspects", "a/b, a along the rolling", range(0.1, 10)},
       {&P::poisson_ratio, "ellipse.poisson_ratio", "nu", range(0, 0.5)},
       {&P::wavelengths, "waves.lengths", "L/a of the table of coefficients", range(0.3, 1000),
        two_or_more_rising},
       {&P::shortest, "curve.shortest", "L/a of curves", range(0.3, 10)},
       {&P::longest, "curve.longest", "L/a of curves", range(20, 10000)},
       {&P::points, "curve.points", "numbers of L/a of curves", range(2, 1000)},
       {&P::rows, "convergence.rows", "M; each row has 5/3 M cells", range(3, 30),
        two_or_more_rising},
       {&P::reference, "convergence.reference", "M of the reference", range(6, 40),
        "above convergence.rows"},
       {&P::resolved, "convergence.resolved", "least L/a of errors and orders in claims",
        range(0.3, 1000)},
       {&P::period, "step.period", "half-widths, in which all waves return", range(2, 100)},
       {&P::waves, "step.numbers", "of waves in it, all at once", range(1, 20), rising},
       {&P::step_elements, "step.elements",
        "cells of a row, of three fifths as many rows; N of the standard scheme", range(5, 40)},
       {&P::step_ratios, "step.ratios", "c = dq/dx; dx is the mean length of a cell",
        range(0.02, 2), falling}});
  const P p = keys.read({});
  scene.demand("convergence.reference", static_cast<double>(p.reference),
               p.reference > p.rows.back());
  return p;
}

std::vector<Table> ellipse_response(const EllipseResponseParameters& p, const Progress& progress) {
  const std::size_t steps =
      p.aspects.size() * (p.rows.size() + 1) + ellipse_response_study::runs_of_steps(p);
  std::size_t done = 0;
  const auto advance = [&] { progress(++done, steps); };
  Tables tables;
  for (const double aspect : p.aspects) {
    const Reference reference(aspect, p);
    add_reference(tables, p, reference);
    advance();
    add_errors(tables, p, reference, advance);
    add_lines(tables, p, reference);
  }
  const Table by_steps = ellipse_response_study::steps_table(p, advance);
  return {tables.coefficients,
          tables.curves,
          tables.errors,
          tables.orders,
          by_steps,
          tables.lines,
          tables.limits,
          claims_of(p, tables, by_steps)};
}

}  // namespace microslip::experiments
