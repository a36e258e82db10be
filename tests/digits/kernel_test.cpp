// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "digits/reference_kernel.hpp"

namespace microslip::kernel_test {

using namespace test;
using Reference = ReferenceKernel<Digits100>;

constexpr double documented = 1e-15;

/// One of a kernel's functions, its value in 100 digits, and the scale that its error is held
/// against: the value, where nothing cancels, and the sum of the terms' sizes where they do.
struct KernelFunction : Stated {
  bool plane;
  std::function<double(const Kernel&, double z)> value;
  std::function<Digits100(const Reference&, const Digits100& z)> exact;
  std::function<Digits100(const Reference&, const Digits100& z)> scale;
};

template <class Member>
auto of(Member member) {
  return [member](const Kernel& kernel, double z) {
    return visit_half_space([&](const auto& k) { return member(k, z); }, kernel);
  };
}

const auto displacement = of([](const auto& k, double z) { return k.displacement(z); });
const auto decay = of([](const auto& k, double z) { return k.decay(z); });
const auto regular_displacement =
    of([](const auto& k, double z) { return k.regular_displacement(z); });
const auto regular_decay = of([](const auto& k, double z) { return k.regular_decay(z); });
const auto integral = of([](const auto& k, double z) { return k.integral(z); });
const auto double_integral = of([](const auto& k, double z) { return k.double_integral(z); });

Digits100 exact_regular_displacement(const Reference& r, const Digits100& z) {
  return r.displacement(z) + r.log_factor() * log(z);
}

Digits100 exact_regular_decay(const Reference& r, const Digits100& z) {
  return r.width == 0 ? Digits100(0) : Digits100(r.decay(z) - r.log_factor() / z);
}

Digits100 exact_integral(const Reference& r, const Digits100& z) { return r.moments(z)[0]; }

/// By parts, z int K - int K z, from 0
Digits100 exact_double_integral(const Reference& r, const Digits100& z) {
  const auto m = r.moments(z);
  return z * m[0] - m[1] + r.moments(0)[1];
}

/// The logarithm and the factor that it is multiplied by: its argument is rounded.
Digits100 of_logarithm(const Reference& r, const Digits100& z) {
  const Digits100 size = abs(log(z / r.length));
  return r.log_factor() * (size > 1 ? size : Digits100(1));
}

/// Boussinesq's and Cerruti's part of a regular displacement
Digits100 of_regular_displacement(const Reference& r, const Digits100& z) {
  const Digits100 b = r.width / 2, radius = sqrt(z * z + b * b);
  const Digits100 size = abs(log(b + radius));
  return r.log_factor() * ((size > 1 ? size : Digits100(1)) + r.nu / (1 - r.nu) * b / radius);
}

Digits100 of_regular_decay(const Reference& r, const Digits100& z) {
  const Digits100 b = r.width / 2, radius = sqrt(z * z + b * b);
  return r.log_factor() * z / radius *
         (r.nu / (1 - r.nu) * b / (radius * radius) + 1 / (b + radius));
}

/// Returns the size of the terms of ln(b / z) or ln(z / L0), integrated n times.
template <int n>
Digits100 of_integral(const Reference& r, const Digits100& z) {
  return of_logarithm(r, z) * pow(z, n);
}

Digits100 of_plane_regular(const Reference& r, const Digits100&) {
  const Digits100 size = abs(log(r.length));
  return r.log_factor() * (size > 1 ? size : Digits100(1));
}

class KernelDigits : public testing::TestWithParam<KernelFunction> {};

// From 1e-12 to 1e12 widths or L0, and next to where a logarithm or an integral of it vanishes.
TEST_P(KernelDigits, AgreesWith100Digits) {
  const KernelFunction& f = GetParam();
  WorstCase worst;
  for (const double nu : {0.0, 0.25, 1.0 / 3, 0.5}) {
    for (const double length : {1e-12, 2.3, 1e12}) {
      for (const double modulus : {1e-12, 0.7, 1e12}) {
        const Kernel kernel = kernel_of({modulus, nu}, f.plane ? 0 : length, f.plane ? length : 0);
        const Reference reference{nu, f.plane ? 0 : length, length, modulus};
        std::vector<double> ratios;
        for (int power = -12; power <= 12; ++power) {
          for (const double mantissa : {1.0, 3.7}) ratios.push_back(mantissa * std::pow(10, power));
        }
        for (const double zero : {1.0, std::numbers::e, std::exp(1.5), 0.5}) {
          for (const double away : {-1e-3, -1e-9, -1e-15, 1e-15, 1e-6}) {
            ratios.push_back(zero * (1 + away));
          }
        }
        for (const double ratio : ratios) {
          const double z = ratio * length;
          const double value = f.value(kernel, z);
          const Digits100 exact = f.exact(reference, z);
          worst.meet(relative_error(value, exact, f.scale ? f.scale(reference, z) : exact),
                     place({{"z", ratio}, {"nu", nu}, {"length", length}, {"G", modulus}}));
        }
      }
    }
  }
  expect_as_stated(f, worst);
  EXPECT_LE(worst.error(), documented);
}

INSTANTIATE_TEST_SUITE_P(
    Digits, KernelDigits,
    testing::Values(
        KernelFunction{{"strip_displacement", 4e-16, "z_1e6_nu_0p25_length_2p3_G_1e12"},
                       false,
                       displacement,
                       &Reference::displacement,
                       nullptr},
        KernelFunction{{"strip_decay", 6e-16, "z_4p47721_nu_0p333333_length_1e12_G_1em12"},
                       false,
                       decay,
                       &Reference::decay,
                       nullptr},
        KernelFunction{
            {"strip_regular_displacement", 5e-16, "z_0p037_nu_0p333333_length_1em12_G_0p7"},
            false,
            regular_displacement,
            exact_regular_displacement,
            of_regular_displacement},
        KernelFunction{{"strip_regular_decay", 6e-16, "z_1em6_nu_0_length_1em12_G_1e12"},
                       false,
                       regular_decay,
                       exact_regular_decay,
                       of_regular_decay},
        KernelFunction{{"strip_integral", 5e-16, "z_1_nu_0p333333_length_1em12_G_0p7"},
                       false,
                       integral,
                       exact_integral,
                       nullptr},
        KernelFunction{{"strip_double_integral", 5e-16, "z_1em8_nu_0p333333_length_2p3_G_1e12"},
                       false,
                       double_integral,
                       exact_double_integral,
                       nullptr},
        KernelFunction{{"plane_displacement", 4e-16, "z_2p71828_nu_0p333333_length_1em12_G_0p7"},
                       true,
                       displacement,
                       &Reference::displacement,
                       of_logarithm},
        KernelFunction{{"plane_decay", 3e-16, "z_3p7em12_nu_0p333333_length_2p3_G_0p7"},
                       true,
                       decay,
                       &Reference::decay,
                       nullptr},
        KernelFunction{
            {"plane_regular_displacement", 2e-16, "z_1em12_nu_0p333333_length_1e12_G_0p7"},
            true,
            regular_displacement,
            exact_regular_displacement,
            of_plane_regular},
        KernelFunction{{"plane_regular_decay", 0, "z_1em12_nu_0_length_1em12_G_1em12"},
                       true,
                       regular_decay,
                       exact_regular_decay,
                       nullptr},
        KernelFunction{{"plane_integral", 6e-16, "z_0p37_nu_0p333333_length_1e12_G_1e12"},
                       true,
                       integral,
                       exact_integral,
                       of_integral<1>},
        KernelFunction{{"plane_double_integral", 6e-16, "z_0p37_nu_0p333333_length_2p3_G_0p7"},
                       true,
                       double_integral,
                       exact_double_integral,
                       of_integral<2>}),
    case_name);

}  // namespace microslip::kernel_test
