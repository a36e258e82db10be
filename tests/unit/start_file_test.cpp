// SPDX-License-Identifier: GPL-3.0-or-later
// Tables to start from: the same for all schemes of transients, and no tractions beyond their rows.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "scene_text.hpp"

namespace microslip::start_file_test {

using Eigen::VectorXd;

constexpr double half_width = 5;
constexpr const char* schemes[] = {"remembered", "direct", "relaxed", "fractional"};

TransientScene scene_from(const std::string& scheme, const std::string& rows) {
  Scene scene = scene_of(R"(
material { shear_modulus 82000
  poisson_ratio 0.28 }
contact { half_width 5
  peak_traction 300 }
kernel { type strip
  width 10 }
grid { elements 101 }
load { force -1500 }
start { type file
  file s.tsv }
step { ratio 1 }
motion { distance 1 }
)");
  scene.set("step.scheme=" + scheme);
  scene.read_files_by([&](const std::string&) { return "x\ttraction\n" + rows; });
  return read_transient(scene);
}

double force_from(const std::string& scheme, const std::string& rows) {
  const TransientScene scene = scene_from(scheme, rows);
  return TransientRolling(scene.problem, scene.start).state().force;
}

/// The bound times a ratio, negative, at n places from first to last.
std::string rows(double first, double last, Eigen::Index n, double ratio) {
  std::string text;
  for (const double x : VectorXd::LinSpaced(n, first, last)) {
    text += format_full(x) + '\t' + format_full(-ratio * HertzBound(half_width, 300)(x)) + '\n';
  }
  return text;
}

std::string refusal(const std::string& scheme, const std::string& rows) {
  return message([&] { scene_from(scheme, rows); });
}

TEST(StartFile, IsTakenAsItIsWhateverTheRowsAreWithin) {
  const double all = HertzBound(half_width, 300).total();
  for (const char* scheme : schemes) {
    // Elements of a coarse and of a fine grid, and rows up to the edges and beyond them.
    EXPECT_NEAR(force_from(scheme, rows(-4.75, 4.75, 20, 0.4)), -0.4 * all, 1e-3 * all) << scheme;
    EXPECT_NEAR(force_from(scheme, rows(-4.98, 4.98, 250, 0.4)), -0.4 * all, 1e-3 * all) << scheme;
    EXPECT_NEAR(force_from(scheme, rows(-5, 5, 41, 0.4)), -0.4 * all, 1e-3 * all) << scheme;
    EXPECT_NEAR(force_from(scheme, rows(-6, 6, 41, 0.4)), -0.4 * all, 1e-3 * all) << scheme;
  }
}

// It once was continued to the edges, whatever was left: -785 N/mm of one row, -1178 instead of
// -298.
TEST(StartFile, ThatLeavesPartOfTheContactOutIsRefused) {
  for (const char* scheme : schemes) {
    EXPECT_EQ(refusal(scheme, "0\t-100\n"),
              "start.file = 's.tsv': x = 0: expected rows up to the edges: the node at " +
                  format_short(scene_from(scheme, rows(-5, 5, 41, 0.4)).problem.grid.nodes()[0]) +
                  " is farther from this one than the next row, 0 mm");
    EXPECT_NE(refusal(scheme, "-4.95\t0\n").find("x = -4.95: expected rows up to the edges"),
              std::string::npos);
    EXPECT_NE(refusal(scheme, "4.95\t0\n").find("x = 4.95: expected rows up to the edges"),
              std::string::npos);
    EXPECT_NE(refusal(scheme, rows(-1, 1, 21, 0.5)).find("x = -1: expected rows up to the edges"),
              std::string::npos);
    EXPECT_NE(refusal(scheme, rows(-5, 1, 21, 0.5)).find("x = 1: expected rows up to the edges"),
              std::string::npos);
    EXPECT_NE(refusal(scheme, rows(-1, 5, 21, 0.5)).find("x = -1: expected rows up to the edges"),
              std::string::npos);
    EXPECT_EQ(refusal(scheme, rows(-4.6, 4.6, 24, 0.5)), "");  // every 0.4 mm
    EXPECT_NE(refusal(scheme, rows(-4.5, 4.5, 46, 0.5)), "");  // every 0.2 mm
  }
}

}  // namespace microslip::start_file_test
