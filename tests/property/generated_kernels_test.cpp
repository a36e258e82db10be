// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels of springs, layers and tables under bounds and loads that nobody chose: estimates are
// true, and rolling leads to the steady state, which is solved by other equations.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "generated_contacts.hpp"
#include "microslip/rolling/transient.hpp"
#include "property/samples.hpp"

namespace microslip::generated_kernels_test {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Material material{82000, 0.28};

/// Generates springs, layers on strips and in plane strain, and tables of a symbol, in turn; their
/// compliances are of half_width / 1e4 of the half-space's to 1e2.
class KernelGenerator {
 public:
  explicit KernelGenerator(unsigned seed) : random_(seed) {}

  Kernel next() {
    const double softness = half_width * compliance(material) * log_uniform(1e-4, 1e2);
    switch (count_++ % 4) {
      case 0:
        return WinklerKernel(softness);
      case 1:
        return LayeredKernel(PlaneKernel(material, log_uniform(10, 500)), softness);
      case 2:
        return LayeredKernel(StripKernel(material, log_uniform(2, 100)), softness);
      default:
        return table();
    }
  }

 private:
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  double log_uniform(double from, double to) {
    return std::exp(uniform(std::log(from), std::log(to)));
  }

  /// Coatings: stiffer or softer to short waves than to long ones.
  Kernel table() {
    constexpr Index rows = 60;
    const double thickness = log_uniform(0.1, 10), part = log_uniform(0.3, 3);
    VectorXd waves(rows), symbols(rows);
    for (Index i = 0; i < rows; ++i) {
      waves[i] = 1e-3 * std::pow(1e5, static_cast<double>(i) / (rows - 1));
      const double coated = 1 / (1 + std::pow(waves[i] * thickness, 2));
      symbols[i] = compliance(material) / waves[i] * (coated + part * (1 - coated));
    }
    return SymbolKernel(waves, symbols);
  }

  std::mt19937 random_;
  int count_ = 0;
};

TEST(GeneratedKernels, EstimatesOfErrorsHold) {
  const int count = samples(24);
  constexpr double target = 3e-3;
  ContactGenerator contacts(31);
  KernelGenerator kernels(32);
  int held = 0;
  for (int i = 0; i < count; ++i) {
    const auto [kind, generated] = contacts.next();
    const SteadyContact contact{{kernels.next(), generated.bound}, generated.load};
    const EstimatedSteady found = solve_steady_to(contact, target);
    EXPECT_LE(found.error, target);
    EXPECT_LE(found.solution.evidence.residual, 1e-9) << i;
    const Index n = found.solution.x.size();
    const SteadySolution finer = solve_steady(problem_of(contact, 8 * n + 1, Calibrated{}));
    const double error = std::abs(found.solution.creepage / finer.creepage - 1);
    // A closed form is better than these elements, which have an error of their own.
    const bool is_closed = found.solution.scheme == SteadyScheme::closed_form;
    held += error <= (is_closed ? target : found.error) ? 1 : 0;
    EXPECT_LE(error, 3 * target) << i << " " << kind << " " << contact.kernel.name();
  }
  EXPECT_GE(held, count - 1);
}

TEST(GeneratedKernels, RollingLeadsToTheSteadyState) {
  KernelGenerator kernels(33);
  std::mt19937 random(34);
  std::uniform_real_distribution<double> uniform(0, 1);
  const HertzBound bound(half_width, 300);
  const double most = full_sliding_force(bound);
  for (int i = 0; i < samples(16); ++i) {
    const Kernel kernel = kernels.next();
    const Index n = 60 + static_cast<Index>(60 * uniform(random));
    const double force = -most * (0.1 + 0.8 * uniform(random));
    const SteadySolution steady =
        solve_steady(problem_of({{kernel, bound}, PrescribedForce{force}}, n, Calibrated{}));
    TransientRolling rolling({.contact = {kernel, bound},
                              .grid = Grid({.half_width = half_width, .elements = n}),
                              .basis = constant_basis(),
                              .scheme = Remembered{}});
    const double dx = 2 * half_width / static_cast<double>(n);
    // Under a creepage the force of a half-space would be far from steady after that.
    while (rolling.state().distance < 10 * half_width) {
      rolling.step(dx * (0.2 + 2 * uniform(random)), PrescribedForce{force});
    }
    EXPECT_NEAR(rolling.state().creepage / steady.creepage, 1, 3e-4) << i << " " << kernel.name();
    EXPECT_NEAR(rolling.state().dissipation / (-force * steady.creepage), 1, 3e-4) << i;
  }
}

}  // namespace microslip::generated_kernels_test
