// SPDX-License-Identifier: GPL-3.0-or-later
// Carter's and Cattaneo's solutions from the smallest to the largest loads, up to the edges.
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "digits/reference_kernel.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/reference/cattaneo.hpp"
#include "microslip/support/sine.hpp"
#include "microslip/thesis/edge_displacement.hpp"

namespace microslip::closed_form_test {

using namespace test;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// a, G and peak: each from 1e-12 to 1e12
struct Scale {
  double half_width;
  double modulus;
  double peak;

  Material material() const { return {modulus, 0.28}; }
  HertzBound bound() const { return {half_width, peak}; }
  double sliding() const { return compliance(material()) * peak; }
  Digits100 exact_sliding() const { return 2 * (1 - Digits100(0.28)) / Digits100(modulus) * peak; }
  Digits100 exact_total() const {
    return boost::math::constants::half_pi<Digits100>() * half_width * peak;
  }
};

const std::vector<Scale> scales = {
    {1, 1, 1}, {3.3, 8.1e4, 700}, {1e-12, 1e12, 1e12}, {1e12, 1e-12, 1e-12}};

/// Returns the root of a square, and zero below zero.
Digits100 root(const Digits100& square) {
  return square > 0 ? Digits100(sqrt(square)) : Digits100(0);
}

// ------------------------------------------------------------------------------------- Carter

enum class By { creepage, force, stick_ratio };

/// (10.1); differences of squares as products, so that they vanish where they should
struct ExactCarter {
  Digits100 stick_ratio, half_width, peak, sliding;

  Digits100 traction(const Digits100& x) const {
    const Digits100 r = x / half_width;
    return -peak * (root((1 - r) * (1 + r)) - root((1 - r) * (r - 1 + 2 * stick_ratio)));
  }
  Digits100 slip(const Digits100& x) const {
    const Digits100 r = x / half_width;
    return sliding * root((1 - r) * (1 - 2 * stick_ratio - r));
  }
  Digits100 creepage() const { return sliding * (1 - stick_ratio); }
  Digits100 force() const {
    return -boost::math::constants::half_pi<Digits100>() * half_width * peak *
           (1 - stick_ratio * stick_ratio);
  }
};

struct CarterCase : Stated {
  By by;
  std::function<double(const Carter&, double x)> value;
  std::function<Digits100(const ExactCarter&, const Digits100& x)> exact;
  bool along;  ///< whether it depends on x
};

/// \param load  relative to full sliding; the stick ratio itself
Carter carter_by(By by, const Scale& s, double load) {
  if (by == By::stick_ratio) return Carter::from_stick_ratio(s.material(), s.bound(), load);
  if (by == By::force) return Carter::from_force(s.material(), s.bound(), load);
  return Carter::from_creepage(s.material(), s.bound(), load);
}

Digits100 exact_stick_ratio(By by, const Scale& s, const Digits100& load) {
  if (by == By::stick_ratio) return load;
  const Digits100 left =
      by == By::force ? 1 + load / s.exact_total() : 1 - load / s.exact_sliding();
  return by == By::force ? Digits100(sqrt(left)) : left;
}

/// Next to the edges, to the stick-slip point, and in between
std::vector<double> places(double half_width, double stick_ratio, double slip_ratio) {
  std::vector<double> all = {0, half_width, -half_width};
  for (const double inwards : {1e-15, 1e-12, 1e-6, 0.3, stick_ratio, 2 * stick_ratio * (1 - 1e-9),
                               2 * stick_ratio * (1 + 1e-9), 2 * stick_ratio}) {
    if (inwards < 2) all.push_back(half_width * (1 - inwards));
  }
  for (const double inwards : {1e-15, 1e-12, 1e-6, 0.3, slip_ratio, 2 * slip_ratio * (1 - 1e-9),
                               2 * slip_ratio * (1 + 1e-9), 2 * slip_ratio}) {
    if (inwards < 2) all.push_back(half_width * (inwards - 1));
  }
  return all;
}

/// x, and as far from the nearer edge except for a rounding
std::vector<Digits100> neighbours(double x, double half_width) {
  const Digits100 step = (Digits100(half_width) - std::abs(x)) * epsilon;
  return {x, x - step, x + step};
}

class CarterDigits : public testing::TestWithParam<CarterCase> {};

// Creepage and force are known up to a rounding, and so are distances from the nearer edge.
TEST_P(CarterDigits, AgreesWith100Digits) {
  const CarterCase& c = GetParam();
  WorstCase worst;
  for (const Scale& s : scales) {
    for (const double ratio : {1e-12, 1e-9, 1e-6, 1e-3, 0.4, 0.7, 1 - 1e-3, 1 - 1e-6, 1 - 1e-12}) {
      const double load = c.by == By::stick_ratio ? ratio
                          : c.by == By::force     ? -ratio * s.bound().total()
                                                  : ratio * s.sliding();
      const Carter carter = carter_by(c.by, s, load);
      std::vector<ExactCarter> exact;
      for (const int steps : {0, -1, 1}) {
        if (steps != 0 && c.by == By::stick_ratio) continue;
        const Digits100 stick_ratio =
            exact_stick_ratio(c.by, s, Digits100(load) * (1 + steps * Digits100(epsilon)));
        exact.push_back({stick_ratio, s.half_width, s.peak, s.exact_sliding()});
      }
      const auto stick = static_cast<double>(exact[0].stick_ratio);
      const auto slip = static_cast<double>(Digits100(1 - exact[0].stick_ratio));
      for (const double x : c.along ? places(s.half_width, stick, slip) : std::vector{0.0}) {
        std::vector<Digits100> around;
        for (const ExactCarter& e : exact) {
          for (const Digits100& near : neighbours(x, s.half_width)) {
            around.push_back(c.exact(e, near));
          }
        }
        worst.meet(error_beyond(c.value(carter, x), around),
                   place({{"load", ratio}, {"x", x / s.half_width}, {"G", s.modulus}}));
      }
    }
  }
  expect_as_stated(c, worst);
  EXPECT_LE(worst.error(), 2e-15);
}

std::vector<CarterCase> carter_cases(const std::vector<Stated>& stated) {
  std::vector<CarterCase> all;
  for (const Stated& s : stated) {
    const std::size_t end = s.subject.find("_by_");
    const std::string function = s.subject.substr(0, end);
    const std::string given = s.subject.substr(end + 4);
    CarterCase c{s,
                 given == "force"      ? By::force
                 : given == "creepage" ? By::creepage
                                       : By::stick_ratio,
                 {},
                 {},
                 function == "traction" || function == "slip"};
    if (function == "traction") {
      c.value = &Carter::traction;
      c.exact = &ExactCarter::traction;
    } else if (function == "slip") {
      c.value = &Carter::slip;
      c.exact = &ExactCarter::slip;
    } else if (function == "creepage") {
      c.value = [](const Carter& carter, double) { return carter.creepage(); };
      c.exact = [](const ExactCarter& e, const Digits100&) { return e.creepage(); };
    } else if (function == "force") {
      c.value = [](const Carter& carter, double) { return carter.force(); };
      c.exact = [](const ExactCarter& e, const Digits100&) { return e.force(); };
    } else {
      c.value = [](const Carter& carter, double) { return carter.stick_ratio(); };
      c.exact = [](const ExactCarter& e, const Digits100&) { return e.stick_ratio; };
    }
    all.push_back(c);
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Digits, CarterDigits,
                         testing::ValuesIn(carter_cases({
                             {"traction_by_creepage", 2e-16, "load_0p999_x_0p998_G_1em12"},
                             {"traction_by_force", 2e-16, "load_0p7_x_m0p0954451_G_1em12"},
                             {"traction_by_stick_ratio", 2e-16, "load_1em6_x_1_G_1"},
                             {"slip_by_creepage", 1e-16, "load_1em12_x_m1_G_81000"},
                             {"slip_by_force", 2e-16, "load_0p001_x_m1_G_81000"},
                             {"slip_by_stick_ratio", 3e-16, "load_0p4_x_m1_G_1"},
                             {"creepage_by_creepage", 0, "load_1em12_x_0_G_1"},
                             {"creepage_by_force", 0, "load_1em12_x_0_G_1"},
                             {"creepage_by_stick_ratio", 1e-16, "load_1em6_x_0_G_81000"},
                             {"force_by_creepage", 2e-16, "load_0p999999_x_0_G_81000"},
                             {"force_by_force", 0, "load_1em12_x_0_G_1"},
                             {"force_by_stick_ratio", 2e-16, "load_1em12_x_0_G_81000"},
                             {"stick_ratio_by_creepage", 2e-16, "load_0p001_x_0_G_1"},
                             {"stick_ratio_by_force", 5e-17, "load_1em12_x_0_G_1"},
                         })),
                         case_name);

// ----------------------------------------------------------------------------------- Cattaneo

struct Single : Stated {};

class CattaneoTraction : public testing::TestWithParam<Single> {};
class CattaneoDisplacement : public testing::TestWithParam<Single> {};

constexpr std::array force_ratios = {1e-12, 1e-9, 1e-4, 0.3, 0.64, 1 - 1e-4, 1 - 1e-9, 1 - 1e-12};

TEST_P(CattaneoTraction, AgreesWith100Digits) {
  WorstCase worst;
  for (const Scale& s : scales) {
    for (const double ratio : force_ratios) {
      const double force = ratio * s.bound().total();
      const Cattaneo cattaneo(s.material(), s.bound(), force);
      const double k = cattaneo.stick_ratio();
      for (const double inwards : {0.0, 1e-15, 1e-9, 0.3, 1.0, 1 - k, (1 - k) * (1 - 1e-9),
                                   (1 - k) * (1 + 1e-9), 1 - k / 2, ratio / 2, ratio}) {
        const double x = s.half_width * (inwards - 1);
        std::vector<Digits100> around;
        for (const int steps : {0, -1, 1}) {
          const Digits100 held = 1 - force * (1 + steps * Digits100(epsilon)) / s.exact_total();
          for (const Digits100& near : neighbours(x, s.half_width)) {
            const Digits100 r = near / s.half_width;
            around.push_back(s.peak * (root((1 - r) * (1 + r)) - root(held - r * r)));
          }
        }
        worst.meet(error_beyond(cattaneo.traction(x), around),
                   place({{"force", ratio}, {"x", inwards - 1}, {"G", s.modulus}}));
      }
    }
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), 2e-15);
}

INSTANTIATE_TEST_SUITE_P(Digits, CattaneoTraction,
                         testing::Values(Single{
                             {"traction", 2e-16, "force_0p9999_x_m0p01_G_1e12"}}),
                         case_name);

// The displacement in the middle, by quadrature of the kernel over the traction.
TEST_P(CattaneoDisplacement, AgreesWith50Digits) {
  WorstCase worst;
  boost::math::quadrature::tanh_sinh<Digits50> integrator;
  for (const double ratio : force_ratios) {
    for (const double length : {1e-6, 0.5, 200.0, 1e12}) {
      const double force = ratio * HertzBound(1, 1).total();
      const Cattaneo cattaneo({1.44, 0.28}, HertzBound(1, 1), force);
      const Digits50 held = 1 - force / boost::math::constants::half_pi<Digits50>();
      const ReferenceKernel<Digits50> kernel{0.28, 0, length, 1.44};
      const auto under_ellipse = [&](const Digits50& k) {
        return Digits50(2 * integrator.integrate(
                                [&](const Digits50& x) {
                                  return Digits50(sqrt((k - x) * (k + x)) * kernel.displacement(x));
                                },
                                Digits50(0), k));
      };
      const Digits50 exact = under_ellipse(1) - under_ellipse(sqrt(held));
      const Digits50 logarithm = abs(log(2 * Digits50(length)));
      worst.meet(relative_error(cattaneo.displacement(length), exact,
                                Digits50(ratio * std::max(Digits50(1), logarithm) / 2)),
                 place({{"force", ratio}, {"L0", length}}));
    }
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), 2e-15);
}

INSTANTIATE_TEST_SUITE_P(Digits, CattaneoDisplacement,
                         testing::Values(Single{{"displacement", 6e-16, "force_1_L0_0p5"}}),
                         case_name);

// -------------------------------------------------------------------------- edge displacement

struct EdgeCase : Stated {
  std::vector<double> widths;  ///< 0 for plane strain
};

class EdgeDisplacement : public testing::TestWithParam<EdgeCase> {};

// The thesis's integrals (10.5) as they stand, singular at the edge.
TEST_P(EdgeDisplacement, AgreesWith50Digits) {
  WorstCase worst;
  boost::math::quadrature::tanh_sinh<Digits50> integrator;
  for (const double width : GetParam().widths) {
    for (const double length : width > 0 ? std::vector{1.0} : std::vector{1e-6, 0.5, 7.0, 1e12}) {
      const ReferenceKernel<Digits50> kernel{0.28, width, length, 1};
      const auto under_ellipse = [&](const Digits50& r) {
        const auto integrand = [&](const Digits50& z) {
          return Digits50(sqrt(z * (2 * r - z)) * kernel.displacement(z));
        };
        // The kernel changes its scale at the strip's half-width.
        const Digits50 split = width > 0 && width < r ? Digits50(width) : r;
        return Digits50(integrator.integrate(integrand, Digits50(0), split) +
                        integrator.integrate(integrand, split, Digits50(2 * r)));
      };
      const Digits50 whole = under_ellipse(1);
      for (const double stick : {1e-9, 1e-3, 0.4, 0.6, 0.95, 1 - 1e-6, 1 - 1e-12}) {
        const Carter carter = Carter::from_stick_ratio({1, 0.28}, HertzBound(1, 1), stick);
        const Digits50 exact = -(whole - under_ellipse(stick));
        const Digits50 logarithm = abs(log(Digits50(2) * length));
        const Digits50 scale =
            width > 0 ? exact : Digits50((1 - Digits50(stick)) * std::max(Digits50(1), logarithm));
        worst.meet(relative_error(edge_displacement(kernel_of({1, 0.28}, width, length), carter),
                                  exact, scale),
                   place({{"stick_ratio", stick}, {"width", width}, {"L0", length}}));
      }
    }
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(
    Digits, EdgeDisplacement,
    testing::Values(EdgeCase{{"plane", 4e-16, "stick_ratio_1_width_0_L0_0p5"}, {0}},
                    EdgeCase{{"strip", 5e-16, "stick_ratio_0p95_width_0p01_L0_1"},
                             {0.01, 1, 40, 1e6}}),
    case_name);

// ---------------------------------------------------------------------------------- x - sin x

class SineDigits : public testing::TestWithParam<Single> {};

TEST_P(SineDigits, AgreesWith100Digits) {
  WorstCase worst;
  for (double x = 1e-12; x < 7; x *= 1.07) {
    const Digits100 exact = Digits100(x) - sin(Digits100(x));
    worst.meet(relative_error(x_minus_sine(x), exact), place({{"x", x}}));
  }
  expect_as_stated(GetParam(), worst);
  EXPECT_LE(worst.error(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Digits, SineDigits,
                         testing::Values(Single{{"x_minus_sine", 3e-16, "x_2p37837em6"}}),
                         case_name);

}  // namespace microslip::closed_form_test
