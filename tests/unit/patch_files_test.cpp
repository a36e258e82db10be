// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of any shape as scenes give them: tables of edges and of the bound, and what is refused.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include "microslip/scene/explanation.hpp"
#include "microslip/scene/model.hpp"
#include "scene_text.hpp"

namespace microslip::patch_files_test {

using std::numbers::pi;

const std::string head = R"(
problem steady
material { shear_modulus 80 GPa
  poisson_ratio 0.3 }
load { spin 0.2 1/m }
)";

const std::string diamond =
    "y\ttrailing\tleading\n-4\t0\t0\n-2\t-2\t2\n0\t-3\t3\n2\t-2\t2\n4\t0\t0\n";
const std::string peaked =
    "x [mm]\ty [mm]\tbound "
    "[MPa]\n-1\t-2\t50\n0\t-2\t60\n1\t-2\t50\n-2\t0\t80\n-1\t0\t90\n0\t0\t100\n"
    "1\t0\t90\n2\t0\t80\n-1\t2\t50\n0\t2\t60\n1\t2\t50\n";

/// A scene whose files are texts.
Scene with_files(const std::string& contact, const std::map<std::string, std::string>& files) {
  Scene scene = scene_of(head + "contact {\n" + contact + "}\n", "folder/");
  scene.read_files_by([=](const std::string& path) -> std::string {
    const auto found = files.find(path);
    if (found == files.end()) throw std::invalid_argument("there is no such file");
    return found->second;
  });
  return scene;
}

SteadyPatch read(Scene& scene) {
  const Model model = read_model(scene);
  scene.reject_unread();
  return std::get<SteadyPatch>(model);
}

/// Both tables, in the folder of the scene.
Scene with_tables(const std::string& edges, const std::string& bound = peaked) {
  return with_files("patch_file edges\nbound_file bound\n",
                    {{"folder/edges", edges}, {"folder/bound", bound}});
}

std::string refusal(Scene scene) {
  return message_in_keys([&] { read(scene); });
}

TEST(PatchFiles, HaveEdgesAndBound) {
  Scene scene = with_tables(diamond);
  const SteadyPatch patch = read(scene);
  EXPECT_EQ(patch.bound.peak(), 100);
  EXPECT_EQ(patch.bound.half_width(), 3);
  EXPECT_EQ(patch.bound.lateral_half_width(), 4);
  EXPECT_GE(patch.rows * patch.elements, 250);
  EXPECT_EQ(explain(Model(patch)).title,
            "steady rolling of a patch under a creepage along the rolling, a creepage across it, a "
            "spin about the normal");
}

TEST(PatchFiles, ConvertUnits) {
  Scene scene =
      with_tables("leading [cm],trailing [cm],y [m]\n0,0,-0.004\n0.3,-0.3,0\n0,0,0.004\n");
  EXPECT_EQ(read(scene).bound.half_width(), 3);
}

TEST(PatchFiles, HaveLobesByOrderOrByNumber) {
  const std::string bound =
      "x y bound\n-1 -3 5\n0 -3 5\n1 -3 5\n0 -4 5\n0 -2 5\n"
      "9 -3 4\n10 -3 4\n11 -3 4\n10 -4 4\n10 -2 4\n";
  Scene by_order = with_tables(
      "y trailing leading\n-5 0 0\n-3 -2 2\n-1 0 0\n-5 10 10\n-3 8 12\n-1 10 10\n", bound);
  Scene by_number = with_tables(
      "lobe y trailing leading\n1 -5 0 0\n2 -5 10 10\n1 -3 -2 2\n2 -3 8 12\n1 -1 0 0\n2 -1 10 10\n",
      bound);
  Scene behind =
      with_tables("y trailing leading\n-5 0 0\n-3 -2 2\n-1 0 0\n1 10 10\n3 8 12\n5 10 10\n",
                  bound + "9 3 4\n10 3 4\n11 3 4\n10 4 4\n10 2 4\n");
  const SteadyPatch one = read(by_order), other = read(by_number), third = read(behind);
  EXPECT_EQ(one.bound.shape().lobes().size(), 2U);
  EXPECT_EQ(other.bound.shape().lobes().size(), 2U);
  EXPECT_EQ(third.bound.shape().lobes().size(), 2U);
  EXPECT_EQ(one.bound.total(), other.bound.total());
  EXPECT_NEAR(one.bound.total(), third.bound.total(), 1e-12 * one.bound.total());
  EXPECT_TRUE(by_order.warnings().size() >= 1);  // few rows of the bound
}

TEST(PatchFiles, TakeAPeakOrALoad) {
  Scene scene =
      with_files("patch_file edges\npeak_traction 300 MPa\n", {{"folder/edges", diamond}});
  EXPECT_EQ(read(scene).bound.peak(), 300);
  Scene loaded = with_files("patch_file edges\nnormal_load 80 kN\nfriction 0.3\n",
                            {{"folder/edges", diamond}});
  EXPECT_NEAR(read(loaded).bound.total(), 24000, 1e-6);
}

TEST(PatchFiles, GiveAnEllipseABound) {
  Scene scene = with_files("half_width 3\nlateral_half_width 4\nbound_file bound\n",
                           {{"folder/bound", peaked}});
  const SteadyPatch patch = read(scene);
  EXPECT_EQ(patch.bound.peak(), 100);
  EXPECT_NEAR(patch.bound.size(), std::sqrt(12), 1e-12);
}

TEST(PatchFiles, AreDoubted) {
  const auto warning = [](Scene scene) -> std::string {
    read(scene);
    return scene.warnings().empty() ? "" : scene.warnings().front().line;
  };
  EXPECT_THAT(warning(with_tables(diamond)), testing::HasSubstr("fewer than five y"));
  EXPECT_THAT(warning(with_tables(diamond, peaked + "9\t0\t10\n")),
              testing::HasSubstr("1 of its points with a bound are outside the contact"));
  std::string far = "y trailing leading\n";
  for (const char* row : {"96 0 0\n", "100 -3 3\n", "104 0 0\n"}) far += row;
  Scene away = with_files("patch_file edges\npeak_traction 300\n", {{"folder/edges", far}});
  EXPECT_THAT(warning(away), testing::HasSubstr("mm from x = y = 0, about which spin"));
}

/// Hertz's bound on a grid of points, by half-widths of 3 and 4 mm.
/// \param is_zero  where the bound is 0
std::string hertz_table(const std::function<bool(double, double)>& is_zero) {
  std::string table = "x y bound\n";
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      const double x = 0.3 * i, y = 0.4 * j, square = 1 - x * x / 9 - y * y / 16;
      const double bound = square > 0 && !is_zero(x, y) ? 100 * std::sqrt(square) : 0;
      table += fmt::format("{} {} {}\n", x, y, bound);
    }
  }
  return table;
}

// Zeros within the edges are no bound that a contact has: they are left out, and edges belong there.
TEST(PatchFiles, WithZerosThatMatterAreRefused) {
  const auto with_zeros = [](const std::function<bool(double, double)>& is_zero) {
    return with_files("half_width 3\nlateral_half_width 4\nbound_file bound\n",
                      {{"folder/bound", hertz_table(is_zero)}});
  };
  const std::string refused = "contact.bound_file = 'bound': expected edges where the bound ends";
  EXPECT_EQ(refusal(with_zeros([](double, double) { return false; })), "");
  EXPECT_EQ(refusal(with_zeros([](double x, double) { return x < -1.2; })).find(refused), 0U);
  EXPECT_EQ(refusal(with_zeros([](double, double y) { return std::abs(y) < 0.5; })).find(refused),
            0U);
  EXPECT_NE(refusal(with_zeros([](double, double y) { return y > 1.5; })), "");
  Scene few = with_zeros([](double x, double) { return x < -2; });
  read(few);
  const std::string told = few.warnings().front().line;
  EXPECT_THAT(told,
              testing::HasSubstr("its zeros within the edges are left out, and would take 0.0"));
}

TEST(PatchFiles, AreRefusedInOneLine) {
  using testing::HasSubstr;
  using testing::StartsWith;
  const std::string names = "y trailing leading\n";
  EXPECT_EQ(refusal(with_tables(diamond)), "");
  EXPECT_THAT(refusal(with_tables("")), HasSubstr("expected a line of column names, found none"));
  EXPECT_THAT(refusal(with_tables(names)), HasSubstr("expected at least one row below the names"));
  EXPECT_THAT(refusal(with_tables("y trailing\n1 2\n")), HasSubstr("expected a column 'leading'"));
  EXPECT_THAT(refusal(with_tables(names + "0 -1 1\n")),
              StartsWith("contact.patch_file = 'edges': number of rows = 1: expected two or more"));
  EXPECT_THAT(refusal(with_tables(names + "0 -1 nan\n")),
              HasSubstr("line 2: column 'leading': 'nan' is not a finite number"));
  EXPECT_THAT(refusal(with_tables(names + "-1 0 0\n0 2 1\n1 0 0\n")),
              HasSubstr("row 2: leading = 1: expected more than trailing"));
  EXPECT_THAT(refusal(with_tables(names + "-1 0 0\n0 -1 1\n0.5 -1 1\n0.2 -1 1\n1 0 0\n")),
              HasSubstr("lobes overlap"));
  EXPECT_THAT(refusal(with_tables(names + "-100 0 0\n0 -0.01 0.01\n100 0 0\n")),
              HasSubstr("expected a number from 0.001 to 10"));
  EXPECT_THAT(refusal(with_tables(names + "0 -1 1\n0 -1 1\n0 -1 1\n")),
              HasSubstr("lobe 1 from row 1"));
  EXPECT_THAT(refusal(with_tables(diamond, "x y bound\n0 0 1\n")),
              HasSubstr("number of y with a bound > 0 = 1: expected three or more"));
  EXPECT_THAT(refusal(with_tables(diamond, "x y\n0 0\n")), HasSubstr("expected a column 'bound'"));
  EXPECT_THAT(refusal(with_tables(diamond, peaked + "0\t0\t100\n")),
              StartsWith("contact.bound_file = 'bound': row 12: x = 0: expected a point that"));
  const std::map<std::string, std::string> edges{{"folder/edges", diamond}};
  EXPECT_THAT(refusal(with_files("patch_file edges\n", edges)), HasSubstr("contact.bound_file"));
  EXPECT_THAT(refusal(with_files("patch_file edges\nhalf_width 3\npeak_traction 1\n", edges)),
              HasSubstr("contact.half_width"));
  EXPECT_THAT(refusal(with_files("patch_file edges\npeak_traction 1\nbound_file b\n", edges)),
              HasSubstr("contact.peak_traction"));
}

}  // namespace microslip::patch_files_test
