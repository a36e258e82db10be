// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_text.hpp"

namespace microslip {
namespace {

using Texts = std::vector<std::string>;

Texts values(const std::string& text) { return swept_values("key", text); }

TEST(SweptValues, ListsKeepTheirTexts) {
  EXPECT_EQ(values("0.10 1e-3\t7"), (Texts{"0.10", "1e-3", "7"}));
  EXPECT_EQ(values("calibrated standard"), (Texts{"calibrated", "standard"}));
  EXPECT_EQ(values("C:bound.tsv"), (Texts{"C:bound.tsv"}));
  EXPECT_EQ(values("1 | 1  0.5 |0.1:0.1:0.2"), (Texts{"1", "1 0.5", "0.1", "0.2"}));
}

TEST(SweptValues, LinearRangesAreDecimal) {
  EXPECT_EQ(values("0.1:0.1:0.5"), (Texts{"0.1", "0.2", "0.3", "0.4", "0.5"}));
  EXPECT_EQ(values("-0.3:0.1:0.3"), (Texts{"-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(values("10:-4:1"), (Texts{"10", "6", "2"}));
  EXPECT_EQ(values("1:0.12345678912:1.2"), (Texts{"1", "1.12345678912"}));
  EXPECT_EQ(values("50:50:100 400"), (Texts{"50", "100", "400"}));
  EXPECT_EQ(values("2:1:2"), (Texts{"2"}));
  EXPECT_EQ(values("0:1e-3:1").size(), 1001U);
  EXPECT_EQ(values("0:1e-3:1").back(), "1");
}

TEST(SweptValues, LogarithmicRangesHaveEqualRatios) {
  EXPECT_EQ(values("15:log5:240"), (Texts{"15", "30", "60", "120", "240"}));
  EXPECT_EQ(values("-1000:log3:-10"), (Texts{"-1000", "-100", "-10"}));
  const Texts decade = values("1e-4:log13:1e-2");
  ASSERT_EQ(decade.size(), 13U);
  for (std::size_t i = 1; i < decade.size(); ++i) {
    EXPECT_NEAR(std::stod(decade[i]) / std::stod(decade[i - 1]), std::pow(100, 1.0 / 12), 1e-12);
  }
}

TEST(SweptValues, NameWhatTheyReject) {
  for (const char* text :
       {"1:0:2", "1:-1:2", "1:2", "1:1:2:3", "1:x:2", "1:1:x", "0:log5:1", "-1:log5:1", "1:log1:2",
        "1:log2.5:2", "1:log:2", "0:1e-9:1", "1:nan:2", "1:", "1:log1000000:2"}) {
    const std::string what = message([&] { values(text); });
    EXPECT_EQ(what.rfind("sweep.key = '" + std::string(text) + "': expected first:step:last", 0),
              0U)
        << what;
  }
  EXPECT_EQ(message([] { values(""); }), "sweep.key = '': expected at least one value");
  EXPECT_EQ(message([] { values("1 | "); }),
            "sweep.key = '1 | ': expected a value on both sides of |");
}

TEST(Sweep, HasAllCombinationsAndTheLastKeyVariesFastest) {
  const Sweep sweep(
      scene_of("sweep { z \"1 2\"\n solver { type \"auto dense fft\" } }\nz 7\nother 3"));
  ASSERT_EQ(sweep.size(), 6U);
  EXPECT_EQ(sweep.keys()[0].key, "z");
  EXPECT_EQ(sweep.keys()[1].key, "solver.type");
  EXPECT_EQ(sweep.values(0), (Texts{"1", "auto"}));
  EXPECT_EQ(sweep.values(1), (Texts{"1", "dense"}));
  EXPECT_EQ(sweep.values(5), (Texts{"2", "fft"}));
  Scene scene = sweep.scene(4);
  EXPECT_EQ(scene.number("z"), 2);
  EXPECT_EQ(scene.word("solver.type"), "dense");
  EXPECT_EQ(scene.number("other"), 3);
  EXPECT_NO_THROW(scene.reject_unread());
}

TEST(Sweep, TheLastAssignmentOfAKeyWins) {
  Scene scene = scene_of("sweep { a \"1 2\"\n b \"1 2\" }");
  scene.set("a=5");
  EXPECT_EQ(Sweep(scene).size(), 2U);
  scene.set("sweep.a=1 2 3");
  EXPECT_EQ(Sweep(scene).size(), 6U);
  scene.set("sweep.b=");
  EXPECT_EQ(Sweep(scene).size(), 3U);
}

TEST(Sweep, FilesStayRelativeToTheScene) {
  const Sweep sweep(scene_of("sweep { file \"a.tsv b.tsv\" }", "folder/"));
  Scene scene = sweep.scene(1);
  std::string read;
  scene.read_files_by([&](const std::string& path) {
    read = path;
    return "x\n1\n";
  });
  scene.from_columns("file", {{"x", "1"}}, [](const auto& columns) { return columns.size(); });
  EXPECT_EQ(read, "folder/b.tsv");
}

TEST(Sweep, NamesWhatItRejects) {
  EXPECT_EQ(message([] { Sweep(scene_of("a 1")); }).rfind("missing section 'sweep'", 0), 0U);
  EXPECT_EQ(message([] { Sweep(scene_of("sweep { a \"1:1:1000\"\nb \"1:1:1000\" }")); }),
            "sweep: expected at most 100000 cases, not 1000000 with sweep.b");
}

}  // namespace
}  // namespace microslip
