// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/scene/units.hpp"
#include "scene_text.hpp"

namespace microslip::sweep_test {

using Texts = std::vector<std::string>;

Texts values(const std::string& text) { return swept_values("sweep.key", text); }

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

// As in other lists, one unit behind the last value is that of all; between | each value has its
// own.
TEST(SweptValues, HaveUnitsAsOtherLists) {
  const auto in_mm = [](const std::string& values) {
    return swept_values("sweep.kernel.width", values);
  };
  EXPECT_EQ(in_mm("5 1"), (Texts{"5", "1"}));
  EXPECT_EQ(in_mm("5mm 1cm"), (Texts{"5", "10"}));
  EXPECT_EQ(in_mm("5 mm 1 cm"), (Texts{"5", "10"}));
  EXPECT_EQ(in_mm("5 mm | 1 cm | 20"), (Texts{"5", "10", "20"}));
  EXPECT_EQ(in_mm("5 10 cm"), (Texts{"50", "100"}));
  EXPECT_EQ(in_mm("1:1:3 cm"), (Texts{"10", "20", "30"}));
  EXPECT_EQ(in_mm("1:1:2 5 cm"), (Texts{"10", "20", "50"}));
  EXPECT_EQ(in_mm("1:log3:100um"), (Texts{"0.001", "0.01", "0.1"}));
  EXPECT_EQ(in_mm("1:1:2 cm | 7"), (Texts{"10", "20", "7"}));
  EXPECT_EQ(swept_values("sweep.load.creepage", "0.1 0.2 %"), (Texts{"0.001", "0.002"}));
  for (const char* text : {"5 10 cm", "-1 2 3 um", "7 mm 1 m", "8", "1 in"}) {
    const std::vector<double> numbers = *quantities(text, "mm");
    const Texts swept = in_mm(text);
    ASSERT_EQ(swept.size(), numbers.size()) << text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_EQ(std::stod(swept[i]), numbers[i]) << text;
    }
  }
  const auto says = [&](const std::string& values) { return message([&] { in_mm(values); }); };
  const std::string begin = "sweep.kernel.width = '";
  EXPECT_EQ(says("5 | 1 cm"),
            begin + "5 | 1 cm': expected a unit behind each value, or behind none");
  for (const std::string text : {"5 cm 10", "5mm 10 3cm", "1:1:3 mm 5"}) {
    EXPECT_EQ(
        says(text),
        begin + text + "': expected a unit behind each value, or one behind the last for all");
  }
}

TEST(Sweep, NamesWhatItRejects) {
  EXPECT_EQ(message([] { Sweep(scene_of("a 1")); }).rfind("missing section 'sweep'", 0), 0U);
  EXPECT_EQ(message([] { Sweep(scene_of("sweep { a \"1:1:1000\"\nb \"1:1:1000\" }")); }),
            "sweep: expected at most 100000 cases, not 1000000 with sweep.b");
}

Sweep with_table(const std::string& table, const std::string& text, const std::string& set = "") {
  Scene scene = scene_of(text);
  if (!set.empty()) scene.set(set);
  scene.read_files_by([table](const std::string&) { return table; });
  return Sweep(scene);
}

/// The values of all cases.
std::vector<Texts> cases(const Sweep& sweep) {
  std::vector<Texts> all;
  for (std::size_t i = 0; i < sweep.size(); ++i) all.push_back(sweep.values(i));
  return all;
}

TEST(Sweep, KeysTogetherTakeTheirValuesRowByRow) {
  const Sweep sweep(
      scene_of("sweep { a \"x y\"\n together { b { c \"1:1:3\" }\n d \"7 8 9\" }\n"
               "together_2 { e \"5 mm | 6 mm\" } }"));
  ASSERT_EQ(sweep.size(), 12U);
  EXPECT_EQ(sweep.keys()[1].key, "b.c");
  EXPECT_EQ(sweep.keys()[3].key, "e");
  EXPECT_EQ(sweep.values(0), (Texts{"x", "1", "7", "5 mm"}));
  EXPECT_EQ(sweep.values(1), (Texts{"x", "1", "7", "6 mm"}));
  EXPECT_EQ(sweep.values(2), (Texts{"x", "2", "8", "5 mm"}));
  EXPECT_EQ(sweep.values(11), (Texts{"y", "3", "9", "6 mm"}));
  Scene scene = sweep.scene(5);
  EXPECT_EQ(scene.number("b.c"), 3);
  EXPECT_EQ(scene.number("d"), 9);
}

TEST(Sweep, RowsOfATableAreCasesInTheUnitsOfTheKeys) {
  const std::string text = "sweep { load { force \"-1 -2\" }\n table t.tsv }";
  const Sweep sweep = with_table(
      "# comment\ncontact.half_width [cm] load.creepage[%]  kernel.type case\n"
      "0.3 0.1 strip 1\n\n0.5 0.2 plane 2\n",
      text);
  EXPECT_EQ(cases(sweep), (std::vector<Texts>{{"-1", "3", "0.001", "strip"},
                                              {"-1", "5", "0.002", "plane"},
                                              {"-2", "3", "0.001", "strip"},
                                              {"-2", "5", "0.002", "plane"}}));
  const Scene scene = sweep.scene(1);
  EXPECT_EQ(scene.text("contact.half_width"), "5");
  EXPECT_FALSE(scene.has("sweep.table"));
  EXPECT_FALSE(scene.has("table"));
}

TEST(Sweep, CellsBetweenTabsMayHaveBlanks) {
  const Sweep sweep =
      with_table("step.ratio\tstart.file\n1 0.5\ta b.tsv\n 2 \tc\n", "sweep { table t.tsv }");
  EXPECT_EQ(cases(sweep), (std::vector<Texts>{{"1 0.5", "a b.tsv"}, {"2", "c"}}));
}

TEST(Sweep, ASetKeyIsSweptNoMore) {
  Scene scene = scene_of("sweep { together { a \"1 2\"\n b \"3 4\" }\n c \"5 6 7\" }");
  scene.set("a=9");
  EXPECT_EQ(Sweep(scene).keys().size(), 2U);
  EXPECT_EQ(Sweep(scene).size(), 6U);
  EXPECT_EQ(Sweep(scene).scene(0).text("a"), "9");
  scene.set("sweep.b=1 2 3");  // alone now
  EXPECT_EQ(Sweep(scene).size(), 9U);
  scene.set("b=");
  EXPECT_EQ(Sweep(scene).size(), 3U);
  scene.set("sweep.together.c=1 2");
  EXPECT_EQ(Sweep(scene).size(), 2U);

  const std::string table = "grid.elements load.force\n10 1\n20 2\n";
  const std::string text = "sweep { table t.tsv }\ngrid.elements 5";
  EXPECT_EQ(with_table(table, text).keys().size(), 2U);  // the file does not fix it
  const Sweep fixed = with_table(table, text, "grid.elements=7");
  EXPECT_EQ(cases(fixed), (std::vector<Texts>{{"1"}, {"2"}}));
  EXPECT_EQ(fixed.scene(1).text("grid.elements"), "7");
}

TEST(Sweep, NamesWhatItRejectsOfGroupsAndTables) {
  const auto says = [](const std::string& text) { return message([&] { Sweep(scene_of(text)); }); };
  EXPECT_EQ(says("sweep { together { a \"1 2\"\n b \"1 2 3\" } }"),
            "sweep.together.b = '1 2 3': expected as many values as a has, which are 2");
  EXPECT_EQ(says("sweep { a 1\n together { a \"1 2\" } }"),
            "sweep.together.a: expected one list of values of a, found more of them");
  EXPECT_EQ(says("sweep { together { a \"1:2\" } }").rfind("sweep.together.a = '1:2': expected", 0),
            0U);
  const auto of_table = [](const std::string& table, const std::string& more = "") {
    return message([&] { with_table(table, "sweep { " + more + "\n table t.tsv }"); });
  };
  const std::string file = "sweep.table = 't.tsv': ";
  EXPECT_EQ(of_table(""), file + "expected a line of column names, found none");
  EXPECT_EQ(of_table("grid.elements\n"),
            file + "line 1: expected at least one row below the names");
  EXPECT_EQ(of_table("grid.elemnts\n1\n"),
            file +
                "column 'grid.elemnts': expected the name of a key (did you mean "
                "'grid.elements'?)");
  EXPECT_EQ(of_table("grid.elements load.force\n1\n"), file + "line 2: expected 2 values, found 1");
  EXPECT_EQ(of_table("load.force load.force\n1 2\n"),
            file + "line 1: expected one column 'load.force', found more of that name");
  EXPECT_EQ(of_table("load.force [mm]\n1\n"), file +
                                                  "column 'load.force': unit 'mm': expected "
                                                  "N/mm or another of its kind (N/m, kN/m)");
  EXPECT_EQ(of_table("load.force\tload.creepage\n1\t\n"),
            file + "line 2: column 'load.creepage': expected a value");
  EXPECT_EQ(of_table("load.force\n1\n", "load.force 3"),
            "sweep.table: expected one list of values of load.force, found more of them");
}

}  // namespace microslip::sweep_test
