// SPDX-License-Identifier: GPL-3.0-or-later
// Springs alone and layers of them on a half-space: closed forms, limits, and a dense solution that
// shares no code.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "microslip/halfspace/influence.hpp"
#include "microslip/halfspace/leading_edge.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/reference/brush.hpp"
#include "microslip/reference/carter.hpp"
#include "microslip/reference/fastsim.hpp"
#include "microslip/rolling/frequency_response.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/step_jacobian.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::layer_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

const Material material{1, 0.28};
const HertzBound hertz(1.3, 0.7);

SteadyProblem contact(const Kernel& kernel, const TractionBound& bound, Index elements,
                      const Load& load, const SteadyMethod& method = Calibrated{}) {
  return {.contact = {kernel, bound},
          .grid = Grid({.half_width = half_width_of(bound), .elements = elements}),
          .basis = constant_basis(),
          .method = method,
          .load = load};
}

double force(const Kernel& kernel, const TractionBound& bound, Index elements, double creepage) {
  return solve_steady(contact(kernel, bound, elements, PrescribedCreepage{creepage})).force;
}

LayeredKernel layer_on_plane(double compliance) { return {PlaneKernel(material, 40), compliance}; }

TEST(Layer, AddsItsComplianceAtTheSamePlace) {
  const LayeredKernel::HalfSpace strip = StripKernel(material, 2);
  const LayeredKernel layered(strip, 0.4);
  const StripKernel alone(material, 2);
  const ShapeFunction shape = constant_shape();
  for (const double offset : {0.0, 1.0, -3.0}) {
    const double added = offset == 0 ? 0.4 : 0;
    EXPECT_NEAR(influence(layered, shape, 0.1, offset) - influence(alone, shape, 0.1, offset),
                added, 1e-15);
  }
  // Between nodes tractions are linear, for steps of any length.
  for (const double shift : {1e-12, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(influence_difference(WinklerKernel(0.4), shape, 0.1, 0, shift) / (0.4 * shift), 1,
                1e-14);
    EXPECT_NEAR(influence_difference(WinklerKernel(0.4), shape, 0.1, -1, shift) / (-0.4 * shift), 1,
                1e-14);
    EXPECT_EQ(influence_difference(WinklerKernel(0.4), shape, 0.1, 1, shift), 0);
  }
  EXPECT_NEAR(influence_difference(WinklerKernel(1), shape, 0.1, 0, 2.5), 1, 1e-15);
}

// A layer feels functions that are continuous as they are.
TEST(Layer, OfQuadraticFunctionsIsTheirDifference) {
  const WinklerKernel springs(0.4);
  const Basis basis = quadratic_basis();
  for (const ShapeFunction& shape : basis.shapes()) {
    for (const double offset : {-1.0, -0.7, 0.0, 0.2, 1.0}) {
      for (const double shift : {0.1, 0.3, 1.7}) {
        EXPECT_NEAR(influence_difference(springs, shape, 0.1, offset, shift),
                    0.4 * (shape.value(offset) - shape.value(offset + shift)), 1e-15);
      }
    }
  }
}

TEST(Layer, TakesTheLeadingEdgeFromTheHalfSpacesToTheBrushs) {
  const auto offset = [](double softness) {
    return leading_edge_constants(constant_basis(), softness).offset;
  };
  EXPECT_NEAR(offset(1e-9), leading_edge_constants(constant_basis()).offset, 1e-7);
  EXPECT_NEAR(offset(1e9), 1, 1e-8);
  EXPECT_EQ(offset(std::numeric_limits<double>::infinity()), 1);
  for (double softness = 1e-6; softness < 1e6; softness *= 3) {
    EXPECT_LT(offset(softness), offset(3 * softness));
  }
}

// With the edge where it is felt the force is of second order, for any softness of an element; with
// the half-space's, of first order on soft layers.
TEST(Layer, IsOfSecondOrderWithItsOwnEdge) {
  const HertzBound bound(1, 1);
  const double half_space = compliance(material), creepage = 1e-6;
  for (const double softness : {0.003, 0.1, 1.0, 10.0, 300.0}) {  // of an element of 50
    const LayeredKernel kernel = layer_on_plane(softness * half_space / 25);
    const double fine = force(kernel, bound, 3200, creepage);
    const auto error = [&](Index n) { return std::abs(force(kernel, bound, n, creepage) - fine); };
    EXPECT_GT(error(50) / error(100), 3.5) << softness;
    EXPECT_GT(error(100) / error(200), 3.5) << softness;
    const auto misplaced = [&](Index n) {
      SteadyProblem problem = contact(kernel, bound, n, PrescribedCreepage{creepage});
      const double offset = leading_edge_constants(constant_basis()).offset;
      problem.grid = Grid({.half_width = 1,
                           .elements = n,
                           .leading_offset = offset,
                           .trailing_offset = offset - 0.5});
      problem.method = Differences{.mean_bounds = true};
      return std::abs(solve_steady(problem).force - fine);
    };
    if (softness < 1) continue;
    EXPECT_LT(misplaced(100) / misplaced(200), 2.3) << softness;
    EXPECT_GT(misplaced(200), 20 * error(200)) << softness;
  }
}

TEST(Layer, TendsToCarterAndToTheBrush) {
  for (const double load : {0.3, 0.7, 0.95}) {
    const double fmax = full_sliding_force(hertz);
    const Carter carter = Carter::from_force(material, hertz, -load * fmax);
    const auto creepage = [&](double compliance) {
      return solve_steady(
                 contact(layer_on_plane(compliance), hertz, 400, PrescribedForce{-load * fmax}))
          .creepage;
    };
    EXPECT_NEAR(creepage(1e-7) / carter.creepage(), 1, 2e-5);
    const double soft = 1e6;
    EXPECT_NEAR(Brush(soft, hertz).force(creepage(soft)) / (-load * fmax), 1, 2e-5);
  }
}

TEST(Brush, IsSolvedToItsClosedForms) {
  const double compliance = 0.6;
  const Brush brush(compliance, hertz);
  for (const double creepage : {0.05, 0.3, -0.3, 1.0}) {
    const SteadySolution solution =
        solve_steady(contact(WinklerKernel(compliance), hertz, 400, PrescribedCreepage{creepage}));
    EXPECT_NEAR(solution.force, brush.force(creepage), 5e-6 * full_sliding_force(hertz));
    for (Index i = 0; i < solution.x.size(); ++i) {
      // Where it slips, the bound is the mean over an element.
      const bool sticks = solution.zones[static_cast<std::size_t>(i)] == Zone::adhesion;
      const double expected = brush.traction(solution.x[i], creepage);
      if (sticks) {
        EXPECT_NEAR(solution.traction[i] / expected, 1, 1e-9) << creepage << " " << i;
      }
      if (i > 4 && i < 395) {
        EXPECT_NEAR(solution.traction[i], expected, 1e-4 * hertz.peak()) << creepage;
      }
    }
  }
}

// Under a parabola the force is FASTSIM's cubic.
TEST(Brush, UnderAParabolaIsFastsim) {
  const double a = 1, compliance = 0.6;
  const VectorXd x = VectorXd::LinSpaced(4001, -a, a);
  const TabulatedBound parabola(a, x, (1 - x.array().square()).max(0).matrix());
  const double most = full_sliding_force(parabola);
  const Fastsim fastsim(a, most, 2 * a * a / compliance);
  for (const double creepage : {0.1, 0.4, 0.9, 1.3}) {
    EXPECT_NEAR(force(WinklerKernel(compliance), parabola, 400, creepage), fastsim.force(creepage),
                1e-5 * most);
  }
}

/// Material that rolls through, by characteristics: each moves by one cell a step.
class BrushByCells {
 public:
  BrushByCells(double compliance, const HertzBound& bound, Index cells)
      : compliance_(compliance),
        cell_(2 * bound.half_width() / static_cast<double>(cells)),
        traction_(VectorXd::Zero(cells)),
        bound_(VectorXd::NullaryExpr(cells, [&](Index i) {
          return bound(-bound.half_width() + cell_ * (static_cast<double>(i) + 0.5));
        })) {}

  void roll(double distance, double creepage) {
    const Index steps = std::lround(distance / cell_);
    const Index n = traction_.size();
    for (Index k = 0; k < steps; ++k) {
      traction_.head(n - 1) = traction_.tail(n - 1).eval();
      traction_[n - 1] = cell_ * creepage / compliance_ / 2;  // half of a cell has come in
      traction_.array() -= cell_ * creepage / compliance_;
      traction_ = traction_.cwiseMin(bound_).cwiseMax(-bound_);
    }
  }
  double force() const { return cell_ * traction_.sum(); }

 private:
  double compliance_, cell_;
  VectorXd traction_, bound_;
};

TransientRolling rolling(const Kernel& kernel, Index elements, const AdvectionScheme& scheme,
                         const Start& start = Rest{}) {
  return TransientRolling({.contact = {kernel, hertz},
                           .grid = Grid({.half_width = hertz.half_width(), .elements = elements}),
                           .basis = constant_basis(),
                           .scheme = scheme},
                          start);
}

void roll(TransientRolling& contact, double distance, double step, const Load& load) {
  const double end = contact.state().distance + distance;
  while (contact.state().distance < end - 1e-9) {
    contact.step(std::min(step, end - contact.state().distance), load);
  }
}

TEST(Brush, RollsThroughChangesOfTheCreepageAsItsCellsDo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double compliance = 0.6, fmax = full_sliding_force(hertz);
  for (int trial = 0; trial < 4; ++trial) {
    BrushByCells cells(compliance, hertz, 8000);
    TransientRolling remembered = rolling(WinklerKernel(compliance), 200, Remembered{});
    TransientRolling direct = rolling(WinklerKernel(compliance), 800, Direct{});
    const double dx = 2 * hertz.half_width() / 200;
    for (int part = 0; part < 5; ++part) {
      const double creepage = uniform(random);
      const double distance = 0.65 * (0.2 + std::abs(uniform(random)));
      const double whole = std::round(distance / 0.01) * 0.0104;  // of cells
      cells.roll(whole, creepage);
      roll(remembered, whole, 0.7 * dx, PrescribedCreepage{creepage});
      roll(direct, whole, dx / 4, PrescribedCreepage{creepage});
      EXPECT_NEAR(remembered.state().force, cells.force(), 1e-3 * fmax) << trial << " " << part;
      EXPECT_NEAR(direct.state().force, cells.force(), 1e-2 * fmax) << trial << " " << part;
    }
  }
}

// Springs alone take a shift evenly, up to the bound, under which they slip by the rest.
TEST(Brush, IsShiftedEvenly) {
  const double compliance = 0.6, distance = 0.2;
  constexpr int parts = 100000;
  double force = 0, lost = 0;
  for (int i = 0; i < parts; ++i) {
    const double bound = hertz(hertz.half_width() * (2 * (i + 0.5) / parts - 1));
    const double part = 2 * hertz.half_width() / parts;
    force -= part * std::min(bound, distance / compliance);
    lost += part * bound * std::max(0.0, distance - compliance * bound);
  }
  for (const Index n : {50, 51, 200, 800}) {
    TransientRolling contact = rolling(WinklerKernel(compliance), n, Remembered{});
    const Shift shift = contact.shift(PrescribedShift{distance});
    const double coarse = std::pow(50 / static_cast<double>(n), 2);
    EXPECT_NEAR(contact.state().force / force, 1, 3e-5 * coarse) << n;
    EXPECT_NEAR(shift.dissipation / lost, 1, 0.2 * coarse) << n;
  }
}

/// The c = 1 scheme of CONTACT for elements in plane strain under a layer, written down anew:
/// dense, coefficients from the integral of the logarithm, and slip searched element by element.
class DenseLayer {
 public:
  DenseLayer(double layer, double length, Index n) : n_(n), traction_(VectorXd::Zero(n)) {
    const double dx = 2 * hertz.half_width() / static_cast<double>(n);
    const double k = 2 * (1 - material.poisson_ratio) / (pi * material.shear_modulus);
    const auto primitive = [](double z) { return z == 0 ? 0 : z * (std::log(std::abs(z)) - 1); };
    influence_.resize(n + 1, n);  // the last row is one element ahead
    for (Index i = 0; i <= n; ++i) {
      for (Index j = 0; j < n; ++j) {
        const double z = dx * static_cast<double>(i - j);
        influence_(i, j) =
            -k * (primitive(z + dx / 2) - primitive(z - dx / 2) - dx * std::log(length)) +
            (i == j ? layer : 0);
      }
    }
    bound_ = VectorXd::NullaryExpr(n, [&](Index i) {
      return hertz(-hertz.half_width() + dx * (static_cast<double>(i) + 0.5));
    });
    dx_ = dx;
  }

  void step(double creepage) {
    const VectorXd came = (influence_ * traction_).tail(n_);
    std::vector<int> slips(static_cast<std::size_t>(n_), 0);
    for (int round = 0; round < 200; ++round) {
      MatrixXd matrix = influence_.topRows(n_);
      VectorXd right = came.array() - creepage * dx_;
      for (Index i = 0; i < n_; ++i) {
        const int s = slips[static_cast<std::size_t>(i)];
        if (s == 0) continue;
        matrix.row(i).setZero();
        matrix(i, i) = 1;
        right[i] = s * bound_[i];
      }
      traction_ = LuFactors(matrix).solve(right);
      const VectorXd slip =
          influence_.topRows(n_) * traction_ - came + VectorXd::Constant(n_, creepage * dx_);
      bool changed = false;
      for (Index i = 0; i < n_; ++i) {
        int& s = slips[static_cast<std::size_t>(i)];
        if (s == 0 && std::abs(traction_[i]) > bound_[i] * (1 + 1e-12)) {
          s = traction_[i] > 0 ? 1 : -1;
          changed = true;
        } else if (s != 0 && s * slip[i] > 1e-14) {
          s = 0;
          changed = true;
        }
      }
      if (!changed) return;
    }
    FAIL() << "no partition";
  }
  double force() const { return dx_ * traction_.sum(); }

 private:
  Index n_;
  double dx_ = 0;
  MatrixXd influence_;
  VectorXd traction_, bound_;
};

TEST(Layer, RollsAsADenseSolutionDoes) {
  const double length = 40, fmax = full_sliding_force(hertz);
  for (const double layer : {0.02, 0.3, 5.0}) {
    const double creepage = 0.35 * (compliance(material) + layer);
    DenseLayer coarse(layer, length, 60), fine(layer, length, 120);
    TransientRolling remembered =
        rolling(LayeredKernel(PlaneKernel(material, length), layer), 120, Remembered{});
    const double dx = 2 * hertz.half_width() / 60;
    for (int k = 1; k <= 90; ++k) {
      const double w = k <= 60 ? creepage : -creepage;
      coarse.step(w);
      fine.step(w);
      fine.step(w);
      roll(remembered, dx, 0.4 * dx, PrescribedCreepage{w});
      if (k % 10 != 0) continue;
      const double extrapolated = 2 * fine.force() - coarse.force();
      EXPECT_NEAR(remembered.state().force, extrapolated, 3e-3 * fmax) << layer << " " << k;
    }
  }
}

TEST(Layer, HasTheDerivativesOfItsSteps) {
  for (const Kernel& kernel : {Kernel(WinklerKernel(0.6)), Kernel(layer_on_plane(0.3))}) {
    TransientRolling contact = rolling(kernel, 60, Remembered{});
    const double dx = 2 * hertz.half_width() / 60;
    roll(contact, 30 * dx, dx, PrescribedCreepage{0.3});
    StepJacobian jacobian;
    const double length = 0.6 * dx, creepage = 0.28, small = 1e-6;
    contact.attempt(length, PrescribedCreepage{creepage}, jacobian);
    const auto force_at = [&](double h, double w) {
      return contact.attempt(h, PrescribedCreepage{w}).force;
    };
    EXPECT_NEAR(jacobian.by_load.force /
                    ((force_at(length, creepage + small) - force_at(length, creepage - small)) /
                     (2 * small)),
                1, 1e-5);
    const double by_length =
        (force_at(length * (1 + small), creepage) - force_at(length * (1 - small), creepage)) /
        (2 * small * length);
    EXPECT_NEAR(jacobian.by_length.force, by_length, 1e-5 * std::abs(by_length) + 1e-7);
  }
}

/// The message of an error.
template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Layer, IsSolvedByElementsInsteadOfInversion) {
  const SteadySolution solution =
      solve_steady(contact(layer_on_plane(0.3), hertz, 100, PrescribedCreepage{0.1}, Inversion{}));
  EXPECT_EQ(solution.scheme, SteadyScheme::calibrated);
  EXPECT_EQ(solution.fallback, "the kernel is plane with a layer, not a half-space");
  EXPECT_EQ(
      message_of([] {
        solve_steady(contact(layer_on_plane(0.3), hertz, 10, PrescribedCreepage{0.1}, Inversion{}));
      }),
      "elements = 10: expected at least 11, as the kernel is plane with a layer, not a half-space");
}

TEST(Layer, IsRefusedWhereOnlyHalfSpacesHaveASolution) {
  const LayeredKernel::HalfSpace strip = StripKernel(material, 2);
  const Kernel layered = LayeredKernel(strip, 0.3);
  const std::string expected =
      "kernel = 'strip with a layer': expected strip or plane without a "
      "layer for ";
  EXPECT_EQ(
      message_of([&] {
        solve_steady(contact(layered, hertz, 50, PrescribedCreepage{0.1}, ChebyshevCollocation{}));
      }),
      expected + "Chebyshev collocation");
  EXPECT_EQ(message_of([&] { FrequencyResponse(layered, -1, 1, 0.1); }),
            expected + "the frequency response");
  EXPECT_EQ(message_of([&] {
              TransientRolling contact = rolling(layered, 50, Remembered{});
              contact.set_contact({.half_width = 0.9, .bound = 1});
            }),
            expected + "a contact that changes its half-width");
  EXPECT_EQ(message_of([&] {
              SteadyProblem problem = contact(layered, hertz, 50, PrescribedCreepage{0.1});
              problem.contact.pressure_strain = 0.1;
              solve_steady(problem);
            }),
            "kernel = 'strip with a layer': expected plane for bodies of different material");
  EXPECT_EQ(message_of([&] {
              SteadyProblem problem = contact(layered, hertz, 51, PrescribedCreepage{0.1});
              problem.basis = quadratic_basis();
              solve_steady(problem);
            }),
            "basis = 'quadratic': expected constant or linear");
  EXPECT_TRUE(message_of([&] {
                rolling(WinklerKernel(1), 51, Fractional{});
              }).starts_with("scheme = 'fractional': expected another scheme"));
}

// Displacements bend at the stick-slip point; steps much shorter than an element are taken well,
// too.
TEST(Layer, KeepsItsConditionsInShortSteps) {
  const double force = -0.5 * full_sliding_force(hertz);
  for (const Kernel& kernel : {Kernel(WinklerKernel(0.6)), Kernel(layer_on_plane(0.3))}) {
    for (const double step : {0.05, 0.4}) {
      TransientRolling contact = rolling(kernel, 50, Remembered{}, CattaneoShift{force});
      const double dx = 2 * hertz.half_width() / 50;
      for (double q = 0; q < 3 * hertz.half_width(); q += step * dx) {
        contact.step(step * dx, PrescribedForce{force});
        EXPECT_LT(contact.state().evidence.violation(), 5e-3) << kernel.name() << " " << q;
      }
    }
  }
}

// A change of the bound alone is no change of the half-width.
TEST(Brush, RollsOnAsItsBoundChanges) {
  TransientRolling contact = rolling(WinklerKernel(0.6), 50, Remembered{});
  contact.set_contact({.half_width = 1, .bound = 0.5});
  roll(contact, 6 * hertz.half_width(), 0.1, PrescribedCreepage{2});
  const HertzBound half(hertz.half_width(), hertz.peak() / 2);
  EXPECT_NEAR(contact.state().force, Brush(0.6, half).force(2), 1e-3 * full_sliding_force(half));
}

}  // namespace microslip::layer_test
