// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/extremes.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "microslip/rolling/schemes.hpp"
#include "study_tables.hpp"

namespace microslip::experiments::extremes_test {

/// Fewer places than in the study, but those on which the safe ranges rest.
const std::vector<std::string> places{
    "limits.operations=1e8",
    "steps.step_ratios=1e-12 1e-6 1e-3 0.1 0.3 0.7 1 1.5 2 10 1000",
    "steps.sizes=1 2 11 21 51 101",
    "steps.large_step_ratios=1",
    "steps.large_sizes=10001",
    "widths.strip_widths=1e-3 0.1 1 10 1000 1e8",
    "loads.stick_ratios=0 1e-6 1e-3 0.1",
    "loads.sliding=0 1e-12 1e-9 1e-6 1e-3 0.1",
    "bounds.force_ratios=1e-6 1e-3 0.1 0.5 0.9 0.99",
    "kernels.layers=1e-12 1e-3 1 1e3 1e12",
    "kernels.beta_over_mu=1e-12 1e-3 0.3 1 3 1e4",
    "kernels.force_ratios=1e-6 1e-3 0.1 0.5 0.9 0.99",
    "offsets=0 1e-9 0.5 0.8253 1",
    "transient.step_ratios=1e-12 1e-3 0.01 0.1 0.3 0.5 0.8 1 1.3 2 100 1000",
    "transient.sizes=11 25 51",
    "transient.most_steps=2000",
    "endurance.step_ratios=1 0.3",
    "endurance.states=1000 10000",
    "cylinder.force_ratios=0.01 0.1 1.5 10",
    "cylinder.step_ratios=0.3 1 10",
    "scales=1e-12 1e12"};

class Extremes : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    tables_ = new std::vector<Table>(tables_of("extremes", read_extremes, extremes, places));
  }
  static void TearDownTestSuite() { delete tables_; }

  static const Table& table(const std::string& name) { return table_named(*tables_, name); }

  static std::string text(const Table& table, std::size_t row, const std::string& column) {
    return std::get<std::string>(table.at(row, column));
  }

  /// Calls with each row of a scheme.
  template <class Do>
  static void for_rows(const std::string& map, const std::string& scheme, const Do& each) {
    const Table& rows = table(map);
    int found = 0;
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      if (!scheme.empty() && text(rows, i, "scheme") != scheme) continue;
      ++found;
      each(rows, i);
    }
    EXPECT_GT(found, 0) << map << " " << scheme;
  }

 private:
  static inline std::vector<Table>* tables_ = nullptr;
};

TEST_F(Extremes, CalibratedElementsAreSafeUnderAnyLayer) {
  for_rows("kernels", "calibrated", [&](const Table& rows, std::size_t i) {
    EXPECT_EQ(text(rows, i, "verdict"), "ok") << "row " << i;
    EXPECT_LT(rows.number(i, "error"), 0.01) << "row " << i;
  });
}

TEST_F(Extremes, CalibratedElementsAreSafeForUnlikeBodiesUpToNineTenthsOfFullSliding) {
  for_rows("bodies", "calibrated", [&](const Table& rows, std::size_t i) {
    if (std::abs(rows.number(i, "load")) > 0.9) return;
    EXPECT_EQ(text(rows, i, "verdict"), "ok") << "row " << i;
    EXPECT_LT(rows.number(i, "error"), 0.035) << "row " << i;
  });
}

TEST_F(Extremes, ACylinderIsSafeOnAnySlope) {
  for (const char* scheme : {"midpoint", "verlet", "leapfrog"}) {
    for_rows("cylinder", scheme, [&](const Table& rows, std::size_t i) {
      EXPECT_EQ(text(rows, i, "verdict"), "ok") << scheme << " row " << i;
      const double accepted = rows.number(i, "step_ratio") <= 1 ? 0.002 : 0.02;
      EXPECT_LT(rows.number(i, "error"), accepted) << scheme << " row " << i;
      EXPECT_LE(rows.number(i, "residual"), 1e-12) << scheme << " row " << i;
    });
  }
}

// Results have residuals of rounding wherever there is one, and no other exception than bad input
// and no solution comes out.
TEST_F(Extremes, WhatIsReturnedMeetsTheContactConditions) {
  for (const char* map : {"steps", "widths", "loads", "offsets", "transient", "endurance"}) {
    for_rows(map, "", [&](const Table& rows, std::size_t i) {
      const double residual = rows.number(i, "residual");
      if (std::isnan(residual)) return;
      EXPECT_LE(residual, 1e-12) << map << " row " << i;
      // Where the stick-slip point goes back, what is remembered slips back by as much.
      const bool remembered = text(rows, i, "scheme") == "remembered";
      EXPECT_LE(rows.number(i, "violation"), remembered ? 0.03 : 1e-9) << map << " row " << i;
      EXPECT_TRUE(std::isfinite(rows.number(i, "error"))) << map << " row " << i;
    });
  }
}

TEST_F(Extremes, ResultsAreScaleInvariantToRounding) {
  const Table& scales = table("scales");
  EXPECT_EQ(scales.rows(), 8 * 4 * 2U);
  for (std::size_t i = 0; i < scales.rows(); ++i) {
    EXPECT_LE(scales.number(i, "deviation"), 1e-12)
        << text(scales, i, "scheme") << " " << text(scales, i, "scaled");
  }
}

TEST_F(Extremes, AllOfTheCataloguesTakePart) {
  for (const SteadyEntry& entry : steady_schemes()) {
    for_rows("steps", std::string(entry.name), [](const Table&, std::size_t) {});
  }
  for (const AdvectionEntry& entry : advection_schemes()) {
    for_rows("transient", std::string(entry.name), [](const Table&, std::size_t) {});
  }
}

// The ranges of which the scene reader warns: safe inside, and not much further.
TEST_F(Extremes, SteadyDifferencesAreSafeWhereTheReaderSaysSo) {
  const SafeRange safe_difference = steady_scheme("standard").safe_steps.value();
  for (const std::string_view basis : basis_names()) {
    const std::string scheme = basis == "constant" ? "standard" : fmt::format("standard {}", basis);
    const SafeRange elements = safe_elements(make_basis(basis));
    for_rows("steps", scheme, [&](const Table& rows, std::size_t i) {
      const double c = rows.number(i, "step_ratio");
      const double n = rows.number(i, "elements");
      const std::string verdict = text(rows, i, "verdict");
      if (verdict == "not_run") return;
      if (safe_difference.holds(c) && elements.holds(n)) {
        EXPECT_EQ(verdict, "ok") << scheme << " " << c << " " << n;
      }
      if (n <= 2 || (n == 51 && (c <= 0.3 || c >= 2))) {
        EXPECT_NE(verdict, "ok") << scheme << " " << c << " " << n;
      }
    });
  }
}

TEST_F(Extremes, TransientsAreSafeWhereTheReaderSaysSo) {
  for (const AdvectionEntry& entry : advection_schemes()) {
    const std::string name(entry.name);
    const SafeRange& safe = entry.safe_steps;
    for (const char* map : {"transient", "endurance"}) {
      for_rows(map, name, [&](const Table& rows, std::size_t i) {
        const double c = rows.number(i, "step_ratio");
        const std::string verdict = text(rows, i, "verdict");
        if (verdict == "not_run") return;
        if (safe.holds(c)) {
          EXPECT_EQ(verdict, "ok") << map << " " << name << " " << c;
        } else if (c >= 100) {
          EXPECT_EQ(verdict, "inaccurate") << name << " " << c;
        }
      });
    }
  }
  EXPECT_EQ(table("ranges").latest(
                {{"map", "transient"}, {"scheme", "direct"}, {"parameter", "step_ratio"}}, "most"),
            1.3);
}

// Ours are safe everywhere, with errors that say so.
TEST_F(Extremes, InversionAndChebyshevHoldFromFullSlidingToFullStick) {
  for (const std::string scheme : {"inversion", "chebyshev"}) {
    for_rows("loads", scheme, [&](const Table& rows, std::size_t i) {
      if (rows.number(i, "stuck") == 0) {
        EXPECT_EQ(text(rows, i, "verdict"), "refused");  // a force of full sliding
      } else {
        EXPECT_LE(rows.number(i, "error"), 3e-8) << scheme << " row " << i;
      }
    });
  }
  for_rows("offsets", "inversion",
           [](const Table& rows, std::size_t i) { EXPECT_LE(rows.number(i, "error"), 1e-14); });
  // Between its nodes a traction is linear. The shift leaves roots (2 a d)^(1/2) at both ends of
  // the contact and of the stick zone, of the half-lengths a = 1 and 0.6. Over an element of the
  // length h, a line misses h^(3/2)/6 of the integral of d^(1/2).
  for_rows("transient", "remembered", [](const Table& rows, std::size_t i) {
    const double missed = std::pow(2 / rows.number(i, "elements"), 1.5) / 6;
    const double ends = 2 * (std::sqrt(2 * 1) + std::sqrt(2 * 0.6));
    const double force = 0.64 * HertzBound(1, 1).total();
    EXPECT_LE(rows.number(i, "error"), 1.14 * ends * missed / force) << "row " << i;
  });
}

// Small loads, bounds that are not smooth (1 to 3), two stick zones (4), and bounds that are rough
// at all scales (5, 6). Where a bound is reached at many places, elements replace the inversion.
TEST_F(Extremes, InversionHoldsUnderAnyBound) {
  for_rows("bounds", "inversion", [](const Table& rows, std::size_t i) {
    const double bound = rows.number(i, "bound");
    if (bound > 4) return;
    const bool one_zone = bound == 2 || bound == 3 || rows.number(i, "load") <= 0.1;
    EXPECT_LE(rows.number(i, "error"), one_zone ? 1e-9 : 0.02) << "row " << i;
  });
  for (const std::string scheme : {"calibrated", "inversion"}) {
    for_rows("bounds", scheme, [](const Table& rows, std::size_t i) {
      if (rows.number(i, "bound") > 5) return;  // gaps shorter than elements: warned of
      EXPECT_LE(rows.number(i, "error"), rows.number(i, "bound") > 4 ? 0.05 : 0.02) << "row " << i;
    });
  }
}

// Next to full stick, where the displacement at the edge is a difference, too.
TEST_F(Extremes, DifferencesHoldFromFullSlidingToFullStick) {
  for (const std::string scheme : {"standard", "standard linear", "known_edge"}) {
    for_rows("loads", scheme, [&](const Table& rows, std::size_t i) {
      if (text(rows, i, "verdict") == "refused") return;
      EXPECT_LE(rows.number(i, "error"), 0.07) << scheme << " row " << i;
    });
  }
}

// After 300 elements or more, rolling is steady: more steps, or steps of another length, change
// nothing. What is left is the error of the elements, less than on the grid of the contact.
TEST_F(Extremes, ManyStepsDoNotDrift) {
  const auto error = [](const char* scheme, double c, double steps) {
    return table("endurance")
        .latest({{"scheme", scheme}, {"step_ratio", c}, {"steps", steps}}, "error");
  };
  const double steady = error("remembered", 1, 1000);
  EXPECT_LT(steady, error("direct", 1, 1000));
  for (const double c : {1.0, 0.3}) {
    for (const double steps : {1000.0, 10000.0}) {
      EXPECT_NEAR(error("remembered", c, steps), steady, 1e-8 * steady) << c << ' ' << steps;
    }
  }
}

TEST_F(Extremes, ClaimsHold) {
  const Table& claims = table("claims");
  ASSERT_EQ(claims.rows(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(text(claims, i, "verdict"), "reproduced");
}

}  // namespace microslip::experiments::extremes_test
