// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/varying_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "microslip/experiments/bristle_contact.hpp"
#include "microslip/reference/carter.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::varying_load_test {

VaryingLoadParameters parameters() {
  return parameters_of(
      "varying_load", read_varying_load,
      {"material.shear_modulus=1.44", "contact.half_width=2", "contact.peak_traction=3",
       "kernel.length=20", "small.stick_ratios=0.6", "small.wavelengths=5 30", "small.alignments=3",
       "step.ratios=1", "large.amplitude=0.4", "large.wavelengths=5 300", "curve.shortest=1",
       "curve.longest=1000", "curve.points=5"});  // 2 (1 - nu)/G = 1
}

const std::vector<Table>& tables() {
  static const std::vector<Table> all = varying_load(parameters(), no_progress);
  return all;
}

TEST(VaryingLoadStudy, LongWavesAreCartersSolutionOfEachMoment) {
  const Table& curves = table_named(tables(), "curves");
  EXPECT_NEAR(curves.number(4, "size"), 0.4, 0.02);
  EXPECT_NEAR(curves.number(9, "size"), 0.4, 1e-15);
  const Table& means = table_named(tables(), "means");
  const std::size_t longest = means.rows() - 1;
  EXPECT_EQ(means.number(longest, "wavelength_ratio"), 300);
  EXPECT_NEAR(means.number(longest, "force"), 1, 1e-3);
  EXPECT_NEAR(means.number(longest, "swing"), 1, 5e-3);
  EXPECT_LT(means.number(0, "swing"), 0.7);
}

TEST(VaryingLoadStudy, SmallWavesAreOfSecondOrder) {
  const Table& orders = table_named(tables(), "orders");
  for (std::size_t i = 0; i < orders.rows(); ++i) EXPECT_GT(orders.number(i, "order"), 1.7);
  const Table& measured = table_named(tables(), "measured");
  for (std::size_t i = 0; i < measured.rows(); ++i) EXPECT_LE(measured.number(i, "error"), 2e-3);
}

// The stick-slip points of some alignments would leave the contact.
TEST(VaryingLoadStudy, TakesStatesThatNearlyAdhereEverywhere) {
  VaryingLoadParameters nearly = parameters();
  nearly.stick_ratios = {0.995};
  nearly.wavelengths = {5};
  nearly.sizes = {25, 50};
  const std::vector<Table> found = varying_load(nearly, no_progress);
  EXPECT_LT(table_named(found, "measured").number(1, "error"), 0.05);
}

TEST(VaryingLoadStudy, BristlesAnswerSmallWavesAsTheClosedFormDoes) {
  const double creepage = 0.4 * 3, wavelength = 8, amplitude = 0.05;
  const Bristles bristles{HertzBound(2, 3), creepage, 4 / std::numbers::pi};
  BristleContact contact(bristles, 2000);
  const int steps = static_cast<int>(std::lround(wavelength / contact.step()));
  std::complex<double> sum = 0;
  for (int i = 1; i <= 3 * steps; ++i) {
    const double phase = 2 * std::numbers::pi * i / steps;
    contact.roll(std::sqrt(1 + amplitude * std::sin(phase)));
    if (i > 2 * steps) sum += contact.force() * std::polar(1.0, -phase) / double(steps);
  }
  const std::complex<double> measured =
      sum * std::complex<double>(0, 2) / amplitude / full_sliding_force(bristles.bound);
  const std::complex<double> exact = bristles.force_by_normal_load(wavelength);
  EXPECT_NEAR(std::abs(measured - exact) / std::abs(exact), 0, 0.01);
  EXPECT_LT(exact.real(), 0);

  // Slow waves follow the steady force, of another load.
  const auto steady = [&](double load) {
    BristleContact of(bristles, 1000);
    for (int i = 0; i < 5000; ++i) of.roll(std::sqrt(load));
    return of.force();
  };
  const double slope = (steady(1.1) - steady(0.9)) / 0.2 / full_sliding_force(bristles.bound);
  EXPECT_NEAR(bristles.force_by_normal_load(1e6).real() / slope, 1, 0.01);
}

TEST(VaryingLoadStudy, Verdicts) {
  EXPECT_EQ(verdicts(tables()), std::vector<std::string>(5, "ours"));
}

}  // namespace microslip::experiments::varying_load_test
