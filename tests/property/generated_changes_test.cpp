// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts that change their size while they roll, of bounds, kernels and paths that nobody chose:
// against a scheme of first order that shares no code with the program. Its elements are fixed to
// the material, of which those in the contact carry traction, and a projected Gauss-Seidel
// iteration solves for them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <random>
#include <vector>

#include "microslip/rolling/schemes.hpp"
#include "microslip/rolling/transient.hpp"
#include "property/generated_contacts.hpp"
#include "property/samples.hpp"

namespace microslip::generated_changes_test {

constexpr double distance = 3 * half_width;

/// Creepage and size of the contact along the way.
struct Path {
  std::function<double(double)> creepage;
  std::function<ContactScale(double)> scale;
};

/// The integral of the kernel from 0 to z, by closed forms.
double integral_of(const Kernel& kernel, double z) {
  const Material& material = kernel.material();
  const double k = 2 * (1 - material.poisson_ratio) / (std::numbers::pi * material.shear_modulus);
  if (z == 0) return 0;
  if (const auto length = kernel.plane_length()) {
    return -k * z * (std::log(std::abs(z) / *length) - 1);
  }
  const double h = kernel.clear_distance();
  const double plain = 2 * material.poisson_ratio / (std::numbers::pi * material.shear_modulus);
  return k * (z * std::asinh(h / std::abs(z)) + h * std::asinh(z / h)) +
         plain * h * std::asinh(z / h);
}

/// The force at the end, by elements of the material that come to the contact's centre one by one.
double force_by_material(const SteadyContact& contact, const Path& path, int elements) {
  const double dx = 2 * half_width / elements;
  const int steps = static_cast<int>(std::lround(distance / dx));
  const int beyond = 2 * elements;  // the contact may be twice as large
  const int n = steps + 2 * beyond;
  std::vector<double> influence(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    influence[static_cast<std::size_t>(i)] =
        integral_of(contact.kernel, (i + 0.5) * dx) - integral_of(contact.kernel, (i - 0.5) * dx);
  }
  const auto a = [&](int i, int j) { return influence[static_cast<std::size_t>(std::abs(i - j))]; };
  std::vector<double> p(static_cast<std::size_t>(n)), bound(p), before(p);
  for (int step = 1; step <= steps; ++step) {
    const double q = step * dx;
    const ContactScale scale = path.scale(q);
    const double shift = (path.creepage(q) + path.creepage(q - dx)) / 2 * dx;
    int first = n, last = 0;
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double x = (i - beyond + 0.5) * dx - q;
      const bool inside = std::abs(x) < scale.half_width * half_width;
      const double g = std::visit(
          [&](const auto& b) { return b.mean_around(x / scale.half_width, dx / scale.half_width); },
          contact.bound);
      bound[at] = inside ? scale.bound * g : 0;
      if (inside || p[at] != 0) {
        first = std::min(first, i);
        last = std::max(last, i);
      }
    }
    before = p;
    std::vector<double> slip(p.size());  // shift + A (p - p'), kept up to date
    for (int i = first; i <= last; ++i) slip[static_cast<std::size_t>(i)] = shift;
    for (int sweep = 0; sweep < 2000; ++sweep) {
      double largest = 0;
      for (int i = first; i <= last; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double wanted = std::clamp(p[at] - slip[at] / a(0, 0), -bound[at], bound[at]);
        const double change = wanted - p[at];
        if (change == 0) continue;
        p[at] = wanted;
        for (int j = first; j <= last; ++j) slip[static_cast<std::size_t>(j)] += a(i, j) * change;
        largest = std::max(largest, std::abs(change));
      }
      if (largest < 1e-7) break;
    }
  }
  double force = 0;
  for (const double traction : p) force += traction * dx;
  return force;
}

double force_by_memory(const SteadyContact& contact, const Path& path, Eigen::Index elements,
                       double step_ratio) {
  TransientRolling rolling({.contact = contact,
                            .grid = Grid({.half_width = half_width, .elements = elements}),
                            .basis = constant_basis(),
                            .scheme = Remembered{}});
  rolling.set_contact(path.scale(0));
  rolling.start_from(Eigen::VectorXd::Zero(elements));
  const double dx = 2 * half_width / static_cast<double>(elements);
  const int steps = static_cast<int>(std::ceil(distance / (step_ratio * dx)));
  for (int i = 1; i <= steps; ++i) {
    const double from = distance * (i - 1) / steps, to = distance * i / steps;
    rolling.set_contact(path.scale(to));
    rolling.step(to - from, PrescribedCreepage{(path.creepage(from) + path.creepage(to)) / 2});
  }
  return rolling.state().force;
}

// A sine of the half-width with an amplitude up to 0.3 and edges that grow up to 0.8 of rolling.
Path generated_path(std::mt19937& random, double creepage) {
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const double amplitude = uniform(0.05, 0.3), wave = uniform(0.2, 0.8) / (amplitude * half_width);
  const double phase = uniform(0, 6), friction = uniform(0, 0.4), other = uniform(0.05, 0.4);
  const double sway = uniform(0, 1.5);
  return {[=](double q) { return creepage * (1 + sway * std::sin(other * q + phase)); },
          [=](double q) {
            return ContactScale{1 + amplitude * std::sin(wave * q + phase),
                                1 + friction * std::cos(other * q)};
          }};
}

TEST(GeneratedChanges, OfTheContactAreRight) {
  ContactGenerator generator(seed_of_tests() + 5000);
  std::mt19937 random(seed_of_tests() + 5001);
  double worst = 0;
  for (int i = 0; i < samples(40); ++i) {
    const auto [kind, contact] = generator.next();
    const double length = contact.kernel.plane_length().value_or(HUGE_VAL);
    if (!rolls_transiently(contact) || length < 1.6 * half_width) {
      continue;
    }
    const Path path = generated_path(random, steady_creepage(contact));
    const double coarse = force_by_material(contact, path, 60);
    const double fine = force_by_material(contact, path, 120);
    const double truth = 2 * fine - coarse;
    const double force = force_by_memory(contact, path, 100, i % 2 == 0 ? 1 : 0.3);
    const double error = std::abs(force - truth);
    worst = std::max(worst, error / std::abs(truth));
    EXPECT_LE(error, 0.01 * std::abs(truth) + std::abs(fine - coarse))
        << kind << ", case " << i << ": " << error / truth;
  }
  std::cout << "largest relative error, N = 100: " << worst << '\n';
}

}  // namespace microslip::generated_changes_test
