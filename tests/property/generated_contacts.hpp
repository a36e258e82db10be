// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "microslip/rolling/target_error.hpp"

namespace microslip {

inline constexpr double half_width = 5;  ///< of generated contacts  [mm]

/// A contact and a load that nobody chose.
struct GeneratedContact {
  std::string kind;  ///< of its bound
  SteadyContact contact;
};

/// Generates contacts: bounds of six kinds in turn, kernels, and forces from 1e-5 of full sliding
/// to 0.98 of it.
class ContactGenerator {
 public:
  explicit ContactGenerator(unsigned seed) : random_(seed) {}

  GeneratedContact next() {
    const int i = count_++;
    const Kernel kernel = i % 2 == 0 ? Kernel(StripKernel(material, log_uniform(2, 100)))
                                     : Kernel(PlaneKernel(material, log_uniform(5, 500)));
    const double ratio = i % 3 == 0 ? uniform(0.05, 0.98) : log_uniform(1e-5, 0.98);
    const auto [kind, bound] = make_bound((i / 2) % 6);
    const double force = (i % 5 == 0 ? 1 : -1) * ratio * full_sliding_force(bound);
    return {kind, {{kernel, bound}, PrescribedForce{force}}};
  }

 private:
  using VectorXd = Eigen::VectorXd;
  using Index = Eigen::Index;
  struct Bound {
    std::string kind;
    TractionBound bound;
  };

  static constexpr double peak = 300;
  static constexpr Material material{82000, 0.28};

  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  double log_uniform(double from, double to) {
    return std::exp(uniform(std::log(from), std::log(to)));
  }

  Bound make_bound(int kind) {
    switch (kind) {
      case 0:
        return {"smooth", smooth()};
      case 1:
        return {"humps", humps()};
      case 2:
        return {"kinks", kinks()};
      case 3:
        return {"jumps", jumps()};
      case 4:
        return {"noise", noise()};
      default:
        return {"finite edges", finite_edges()};
    }
  }

  /// Hertz's times a cubic polynomial, nowhere below a twentieth of its middle.
  TractionBound smooth() {
    for (;;) {
      const Eigen::Vector4d h(1, uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      const VectorXd x = VectorXd::LinSpaced(201, -1, 1);
      const auto value = [&](double at) { return h[0] + at * (h[1] + at * (h[2] + at * h[3])); };
      if (x.unaryExpr(value).minCoeff() >= 0.05) return PolynomialBound(half_width, peak, h);
    }
  }

  /// Hertz's times a square and a little: several maxima, and next to no bound between.
  TractionBound humps() {
    const Eigen::Vector4d root =
        Eigen::Vector4d::NullaryExpr([&](Index) { return uniform(-1, 1); });
    VectorXd h = VectorXd::Zero(7);
    for (Index i = 0; i < 4; ++i) {
      for (Index j = 0; j < 4; ++j) h[i + j] += root[i] * root[j];
    }
    h[0] += 0.03;
    return PolynomialBound(half_width, peak, h);
  }

  TractionBound table(const std::vector<double>& x, const std::vector<double>& values) {
    const auto rows = static_cast<Index>(x.size());
    return TabulatedBound(half_width, Eigen::Map<const VectorXd>(x.data(), rows),
                          Eigen::Map<const VectorXd>(values.data(), rows));
  }

  /// Three to eight rows.
  TractionBound kinks() {
    const int rows = 3 + static_cast<int>(uniform(0, 6));
    std::vector<double> x{-half_width}, values{0};
    for (int i = 0; i < rows; ++i) {
      x.push_back(half_width * (2 * (i + 0.5 + uniform(-0.4, 0.4)) / rows - 1));
      values.push_back(uniform(5, peak));
    }
    x.push_back(half_width);
    values.push_back(0);
    return table(x, values);
  }

  /// Two to five levels.
  TractionBound jumps() {
    const int levels = 2 + static_cast<int>(uniform(0, 4));
    std::vector<double> x{-half_width}, values{0};
    for (int i = 0; i < levels; ++i) {
      const double level = uniform(10, peak);
      x.push_back(half_width * (2.0 * i / levels - 1) + (i == 0 ? 0.5 : 1e-3));
      x.push_back(half_width * (2.0 * (i + 1) / levels - 1) - (i + 1 == levels ? 0.5 : 0));
      values.insert(values.end(), 2, level);
    }
    x.push_back(half_width);
    values.push_back(0);
    return table(x, values);
  }

  /// Hertz's in 50 to 400 rows, each off by up to a share of 2 to 60 %.
  TractionBound noise() {
    const Index rows = 50 + static_cast<Index>(uniform(0, 350));
    const double share = uniform(0.02, 0.6);
    const VectorXd x = VectorXd::LinSpaced(rows, -half_width, half_width);
    const HertzBound hertz(half_width, peak);
    return TabulatedBound(half_width, x, x.unaryExpr([&](double at) {
      return hertz(at) * (1 + share * uniform(-1, 1));
    }));
  }

  /// Two to five rows, the outermost at the edges.
  TractionBound finite_edges() {
    const Index rows = 2 + static_cast<Index>(uniform(0, 4));
    const VectorXd x = VectorXd::LinSpaced(rows, -half_width, half_width);
    return TabulatedBound(half_width, x, x.unaryExpr([&](double) { return uniform(10, peak); }));
  }

  std::mt19937 random_;
  int count_ = 0;
};

/// Fixed in CI, so that a failure is that of a change; another one from MICROSLIP_SEED.
inline unsigned seed_of_tests() {
  const char* given = std::getenv("MICROSLIP_SEED");
  return given == nullptr ? 1 : static_cast<unsigned>(std::atoi(given));
}

/// Transients need plane strain in which no load yields against itself.
inline bool rolls_transiently(const SteadyContact& contact) {
  return contact.kernel.plane_length().value_or(HUGE_VAL) >= 2 * half_width;
}

/// By 100 elements.
inline double steady_creepage(const SteadyContact& contact) {
  const Grid grid({.half_width = half_width, .elements = 100});
  return solve_steady(whole_contact({.contact = contact,
                                     .grid = grid,
                                     .basis = constant_basis(),
                                     .load = contact.load}))
      .creepage;
}

}  // namespace microslip
