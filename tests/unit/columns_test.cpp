// SPDX-License-Identifier: GPL-3.0-or-later
// How tables of other programs are read: names and units, separators, decimal commas.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "microslip/scene/model.hpp"
#include "microslip/support/text.hpp"
#include "scene_text.hpp"

namespace microslip::columns_test {

const std::vector<FileColumn> wanted = {{"x", "mm"}, {"bound", "N/mm^2"}};

Scene scene_with(const std::string& table) {
  Scene scene = scene_of("file table");
  scene.read_files_by([table](const std::string&) { return plain_text(table); });
  return scene;
}

/// The numbers of x and bound, row by row.
std::vector<double> numbers_in(const std::string& table) {
  return scene_with(table).from_columns("file", wanted, [](const auto& columns) {
    std::vector<double> all;
    for (Eigen::Index i = 0; i < columns[0]->size(); ++i) {
      all.push_back((*columns[0])[i]);
      all.push_back((*columns[1])[i]);
    }
    return all;
  });
}

std::string refusal(const std::string& table) {
  const std::string text = message([&] { numbers_in(table); });
  const std::string begin = "file = 'table': ";
  EXPECT_TRUE(text.starts_with(begin)) << text;
  return text.substr(std::min(text.size(), begin.size()));
}

TEST(Columns, HaveUnitsInBracketsOrParentheses) {
  const std::vector<double> same{1, 2000, 10, 3000};
  for (const char* names :
       {"x [mm] bound [GPa]", "x[mm]\tbound [GPa]", "x (mm),bound (GPa)", "x(mm) bound(GPa)",
        "\"x [mm]\";\"bound (GPa)\"", "x [mm] bound (kN / mm^2)", "x\u00a0[mm];bound [GPa]"}) {
    const std::string text = names;
    const char* separator = text.find(',') != std::string::npos   ? ","
                            : text.find(';') != std::string::npos ? ";"
                                                                  : "\t";
    EXPECT_EQ(numbers_in(text + "\n1" + separator + "2\n10" + separator + "3\n"), same) << names;
  }
  EXPECT_EQ(numbers_in("x bound (f) f(y) (2x)\n1 2 3 4 5\n"), (std::vector<double>{1, 2}));
  EXPECT_EQ(refusal("x (s),bound\n1,2\n"),
            "line 1: column 'x': unit 's': expected mm or another of its kind (um, cm, m, in)");
}

TEST(Columns, HaveDecimalCommasIfAllHave) {
  const std::vector<double> same{-0.5, 1.25, 0.5, 2};
  EXPECT_EQ(numbers_in("x;bound\n-0,5;1,25\n0,5;2\n"), same);
  EXPECT_EQ(numbers_in("x\tbound\n-,5\t1,25E+00\n+0,5\t2,0\n"), same);
  EXPECT_EQ(numbers_in("x bound\n-0,5 1,25\n0,5 2\n"), same);
  EXPECT_EQ(numbers_in("x,bound\n\"-0,5\",\"1,25\"\n\"0,5\",2\n"), same);
  EXPECT_EQ(numbers_in("sep=;\r\nx;bound\r\n-0,5;1,25\r\n0,5;2\r\n;\r\n"), same);
  EXPECT_EQ(numbers_in("x;bound\n0,5;1,234\n"), (std::vector<double>{0.5, 1.234}));
  const std::string mixed =
      "expected the same decimal mark in all numbers, and none between "
      "thousands";
  EXPECT_EQ(refusal("x;bound\n0.5;1\n1;1,5\n"),
            "line 3: column 'bound': '1,5' has a comma, and '0.5' in line 2 a point: " + mixed);
  EXPECT_EQ(refusal("x;bound\n1,5;1\n2;1.234\n"),
            "line 2: column 'x': '1,5' has a comma, and '1.234' in line 3 a point: " + mixed);
  EXPECT_EQ(refusal("x;bound\n1;1,234\n"),
            "line 2: column 'bound': '1,234' may be 1.234 or 1234: expected a decimal point, or "
            "commas of which one can only be a decimal one");
  EXPECT_EQ(refusal("x;bound\n1;1.234,5\n"),
            "line 2: column 'bound': '1.234,5' is not a finite number without separators of "
            "thousands");
  EXPECT_EQ(refusal("x,bound\n1,\"1,234.5\"\n"),
            "line 2: column 'bound': '1,234.5' is not a finite number without separators of "
            "thousands");
  EXPECT_EQ(refusal("x,bound\n0,5,1,5\n"), "line 2: expected 2 values, found 4");
}

TEST(Columns, MayBeEmptyIfNobodyWantsThem) {
  const std::vector<double> same{1, 2, 3, 4};
  EXPECT_EQ(numbers_in(",x,bound\n0,1,2\n1,3,4\n"), same);        // an index
  EXPECT_EQ(numbers_in("x,,,bound,,\n1,,,2,,\n3,,7,4\n"), same);  // columns without a name
  EXPECT_EQ(numbers_in("x\tnote\tbound\n1\ta b\t2\n3\t\t4\t\n"), same);
  EXPECT_EQ(refusal("x;bound;\n1;2;5\n"),
            "line 2: expected a name for column 3, which has the value '5'");
  EXPECT_EQ(refusal("x;bound\n1;\n"), "line 2: column 'bound': '' is not a finite number");
  EXPECT_EQ(refusal("x\tbound\n1\n"), "line 2: expected 2 values, found 1");
}

// Version 1.0 read these tables: blanks where the names have tabs, quotes that are part of a word.
TEST(Columns, SeparatedByBlanksOrTabsAreTheSame) {
  const std::vector<double> same{1, 2, 3, 4};
  EXPECT_EQ(numbers_in("x\tbound\n1 2\n3 4\n"), same);
  EXPECT_EQ(numbers_in("x bound\n1\t2\n3\t4\n"), same);
  EXPECT_EQ(numbers_in("x [mm]\tbound\n1 2\n3\t4\n"), same);
  EXPECT_EQ(numbers_in("x\tbound\n1\t2\n3 4\n"), same);
  EXPECT_EQ(numbers_in("x a\tbound\n1\t5\"\t2\n3\t\"u\t4\n"), same);
  EXPECT_EQ(numbers_in("x;bound;Load, vertical\n1;2;0\n3;4;0\n"), same);
}

TEST(Columns, SayWhichUnitsAndNamesMayBeMeant) {
  EXPECT_EQ(refusal("t;x;bound\ns;mm;MPa\n0;1;2\n"),
            "line 2: column 'x': 'mm' is not a finite number; a unit stands behind its name, as in "
            "t [s]");
  EXPECT_EQ(refusal("X;Bound\n0;1\n"),
            "line 1: expected a column 'x' among the names in the first line, which are: X Bound "
            "(did you mean 'X'?)");
}

const std::string transient =
    "problem transient\nmaterial { shear_modulus 1\n poisson_ratio 0.28 }\ncontact { half_width 1\n"
    "peak_traction 1 }\nkernel { type plane\n length 10 }\ngrid { elements 20 }\nstart { type rest "
    "}\nload { file table";

/// The run of a table, whose name the scene has.
std::string refused_run(const std::string& table, const std::string& load = "") {
  return message([&] {
    Scene scene = scene_of(transient + load + " }");
    scene.read_files_by([&](const std::string&) { return plain_text(table); });
    read_transient(scene);
  });
}

TEST(RunColumns, ThatAreMissingAreNamedAsTheFileMayHaveThem) {
  const std::string begin = "load.file = 'table': columns: expected ";
  const std::string rows = "\n0;20;0.1\n1;21;0.1\n";
  EXPECT_EQ(refused_run("Time [s];Speed [km/h];Slip" + rows),
            begin +
                "either q or t; found Time, Speed, Slip; load.columns \"t = Time, v = Speed, "
                "creepage = Slip\" names what may be meant");
  EXPECT_EQ(refused_run("t (s);Train speed (km/h);creepage" + rows),
            begin +
                "v where there is t, and only there; found t, Train speed, creepage; "
                "load.columns \"v = Train speed\" names what may be meant");
  EXPECT_EQ(refused_run("a;b;c" + rows), begin + "either q or t; found a, b, c");
  EXPECT_EQ(refused_run("# t v creepage\n0 20 0.1\n1 21 0.1\n"),
            "load.file = 'table': expected names of columns in the first line that does not begin "
            "with #, found numbers: 0, 20, 0.1");
  EXPECT_EQ(refused_run("t;v;Normal load;creepage\n0;1;2;0\n1;1;2;0\n"),
            "load.file = 'table': line 1: unknown column 'Normal load' (did you mean "
            "'normal_load'?); one that is not to be read has a name that begins with _");
}

TEST(RunColumns, AreThoseThatTheSceneNames) {
  const auto run = [](const std::string& table, const std::string& columns) {
    Scene scene = scene_of(transient + "\ncolumns \"" + columns + "\" }");
    scene.read_files_by([&](const std::string&) { return plain_text(table); });
    return std::get<TransientScene>(read_model(scene));
  };
  const TransientScene expected = run("t v creepage\n0 2 0.1\n1 4 0.2\n", "t = t");
  for (const auto& [names, columns] : std::vector<std::pair<std::string, std::string>>{
           {"Time [s];Speed [mm/s];Slip", "t = Time, v = Speed, creepage = Slip"},
           {"Time;Speed;Slip", "t=Time [s],v=Speed [mm/s],creepage=Slip"},
           {"Time (s);Speed;Slip (-)", " t = Time (s) , v = Speed , creepage = Slip [-]"},
           {"time since start;v;Slip (mean)", "t = time since start, creepage = Slip (mean)"}}) {
    const TransientScene found = run(names + "\n0;2;0,1\n1;4;0,2\n", columns);
    EXPECT_EQ(found.distance, expected.distance) << names;
    EXPECT_EQ(std::get<PrescribedCreepage>(found.loads.between(0, 3)).value,
              std::get<PrescribedCreepage>(expected.loads.between(0, 3)).value)
        << names;
  }
  const std::string table = "Time [s];Speed [m/s];Slip\n0;2;0,1\n1;4;0,2\n";
  const auto refused = [&](const std::string& columns, const std::string& end) {
    const std::string text = refused_run(table, "\ncolumns \"" + columns + "\"");
    EXPECT_TRUE(text.ends_with(end)) << text;
  };
  refused("t = Tme, v = Speed, creepage = Slip",
          "expected a column 'Tme' among the names in the first line, which are: Time Speed Slip "
          "(did you mean 'Time'?)");
  refused("t = Time, v = Speed [km/h], creepage = Slip",
          "column 'Speed': unit 'm/s' in the file, 'km/h' in the scene");
  refused("time = Time",
          "expected one of q, t, v, creepage, force, omega, normal_load, "
          "half_width, peak_traction, friction before =, not time (did you mean 't'?)");
  refused("t = Time, t = Slip", "expected each column once, not t twice");
  refused("t = Time, q = Time", "expected each column once, not Time twice");
  refused("t", "expected NAME = NAME IN THE FILE, with commas between them");
  refused("t = Time, ", "expected NAME = NAME IN THE FILE, with commas between them");
}

TEST(RunColumns, ThatAreForcesArePerWidth) {
  const std::string text = refused_run("q;force [kN]\n0;0\n1;0\n");
  EXPECT_TRUE(
      text.ends_with("column 'force': unit 'kN': expected N/mm or another of its kind "
                     "(N/m, kN/m), per mm of width: divide by the width"))
      << text;
}

}  // namespace microslip::columns_test
