// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that are no good input, whatever they are about, and what each is answered: exit status 1,
// exactly one line on stderr, no file. And texts that look odd but are accepted. What is wrong with
// values that are well written is in bad_scenes_test.cpp.
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "robustness/executables.hpp"

namespace microslip::bad_inputs_test {

/// A bad input; each test decides what `text` is.
struct BadInput {
  std::string what;
  std::string text;
  std::string says;  ///< without the program's name; SCENE is the path of the scene
};

std::string replaced(std::string text, const std::string& of, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(of, at)) != std::string::npos; at += by.size()) {
    text.replace(at, of.size(), by);
  }
  return text;
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// Each character behind a zero byte, as all of a scene are ASCII.
std::string utf16(const std::string& text) {
  std::string all = "\xFE\xFF";
  for (const char c : text) (all += '\0') += c;
  return all;
}

const std::string bom = "\xEF\xBB\xBF";
const std::string range = " that is 0 or from 5e-324 to 1.7e308 in magnitude";

/// Keys that a line contact in steady rolling may have beside those of the good scene.
const std::string also_known =
    "target_error, material.youngs_modulus, material.dundurs_beta, material.shear_modulus_2, "
    "material.youngs_modulus_2, material.poisson_ratio_2, contact.normal_load, contact.roughness, "
    "contact.bound_polynomial, contact.bound_file, kernel.compliance, load.force, "
    "load.force_ratio, load.stick_ratio, contact.friction_law";

class BadInputs : public Executables {
 protected:
  void expect_answer(const BadInput& bad, const Outcome& outcome) const {
    SCOPED_TRACE(bad.what);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(replaced(outcome.error, scene_file().string(), "SCENE"),
              "microslip: " + bad.says + "\n");
    EXPECT_EQ(outcome.output, "");
    EXPECT_FALSE(fs::exists(out()));
  }

  void expect_rejected_scenes(const std::vector<BadInput>& list) const {
    for (const BadInput& bad : list) {
      expect_answer(bad, run_program("microslip", "", bad.text, ""));
    }
  }

  /// With texts as the values of a key.
  void expect_rejected_values(const std::string& key, const std::vector<BadInput>& list) const {
    for (const BadInput& bad : list) {
      const BadInput value{bad.what, "", key + " = '" + bad.text + "': expected " + bad.says};
      expect_answer(
          value, run_program("microslip", "", good_scene, "--set '" + key + "=" + bad.text + "'"));
    }
  }

  /// With texts as the contents of the file of a bound.
  void expect_rejected_bounds(const std::vector<BadInput>& list) const {
    for (const BadInput& bad : list) {
      std::ofstream(folder_ / "bound.tsv") << bad.text;
      const BadInput file{bad.what, "", "SCENE:5: contact.bound_file = 'bound.tsv': " + bad.says};
      expect_answer(file, run_program("microslip", "", bound_scene(), ""));
    }
  }

  static std::string bound_scene() {
    return replaced(good_scene, "peak_traction 1", "bound_file bound.tsv");
  }

  /// The tractions of a scene that is accepted.
  std::string traction(const std::string& scene, const std::string& options = "",
                       const std::string& before = "") const {
    std::ofstream(scene_file()) << scene;
    const Outcome outcome =
        run_command(before + " " MICROSLIP_BIN "/microslip --scene '" + scene_file().string() +
                    "' --out '" + out().string() + "' " + options);
    EXPECT_EQ(outcome.error, "") << scene << options;
    const std::string text = text_of(out() / "traction.tsv");
    fs::remove_all(out());
    return text;
  }
};

TEST_F(BadInputs, Numbers) {
  const std::string lengths = "a number in mm or another of its kind (um, cm, m, in)";
  expect_rejected_values(
      "kernel.width",
      {{"a word", "wide", "a finite number"},
       {"too large", "1e400", "a finite number" + range},
       {"too large, negative", "-1e400", "a finite number" + range},
       {"too small, which would be 0", "1e-400", "a finite number" + range},
       {"hexadecimal", "0x10", "a finite number"},
       {"a decimal comma", "1,5", "a finite number with a decimal point"},
       {"a comma behind", "1,", "a finite number"},
       {"thousands", "1,000.5", "a finite number"},
       {"no exponent", "1.5e", "a finite number"},
       {"Fortran's exponent", "1.5d3", "a finite number"},
       {"only a sign", "+", "a finite number"},
       {"two signs", "+-5", "a finite number"},
       {"a minus of typography", "\u22125", "a finite number with the minus sign -"},
       {"two numbers", "1 2", "a finite number"},
       {"an area", "40 mm^2", lengths},
       {"a force", "40N", lengths},
       {"a unit in other letters", "40MM", lengths},
       {"a unit in other letters, apart", "40 Mm", lengths},
       {"a word for a unit", "40millimetres", lengths},
       {"a unit of length that is not known", "40 furlong", lengths},
       {"two lengths", "40 mm 2 mm", lengths},
       {"too large in mm", "1e306 m", lengths},
       {"a blank", " ", "a finite number"},
       {"not a number", "nan", "a finite number"},
       {"infinite", "inf", "a finite number"},
       {"infinite, written out", "Infinity", "a finite number"},
       {"infinite, negative", "-inf", "a finite number"}});
}

TEST_F(BadInputs, WholeNumbers) {
  expect_rejected_values("grid.elements",
                         {{"a word", "many", "a whole number"},
                          {"a fraction", "10.5", "a whole number"},
                          {"a small number", "1e-3", "a whole number"},
                          {"too large", "1e400", "a whole number"},
                          {"beyond exact", "1e16", "a whole number"},
                          {"beyond 64 bits", "99999999999999999999", "a whole number"},
                          {"hexadecimal", "0x14", "a whole number"},
                          {"a comma", "2,0", "a whole number"}});
}

TEST_F(BadInputs, ListsOfNumbers) {
  const std::string numbers = "finite numbers";
  expect_rejected_values(
      "contact.bound_polynomial",
      {{"commas between", "1, 0.5", numbers + ", separated by blanks"},
       {"a decimal comma", "1 0,5", numbers + " with a decimal point, separated by blanks"},
       {"too small", "1 1e-400", numbers + range + ", separated by blanks"},
       {"brackets", "[1 2]", numbers + ", separated by blanks"},
       {"a unit", "1 permille", numbers + ", separated by blanks, with % or \u2030 behind or none"},
       {"nothing", " ", "at least one number"}});
}

TEST_F(BadInputs, NumbersThatAreAccepted) {
  const std::string plain = traction(good_scene);
  EXPECT_NE(plain, "");
  for (const char* width : {"40.0", "4e1", "4E+1", "+40", ".4e2", "40.", "0040", "400e-1"}) {
    EXPECT_EQ(traction(good_scene, std::string("--set kernel.width=") + width), plain) << width;
  }
  for (const char* elements : {"20.0", "2e1", "+20", "020", "200e-1"}) {
    EXPECT_EQ(traction(good_scene, std::string("--set grid.elements=") + elements), plain);
  }
}

TEST_F(BadInputs, Scenes) {
  const std::string directive = "expected ; before comments, and no other files";
  expect_rejected_scenes(
      {{"empty", "", "missing key 'problem'"},
       {"only a comment", "; nothing", "missing key 'problem'"},
       {"a section that does not end", "grid { elements 20", "SCENE:1: unmatched {"},
       {"a section that does not begin", "a 1\n}", "SCENE:2: unmatched }"},
       {"a string that does not end", "a 1\nb \"x\n", "SCENE:2: unexpected end of line"},
       {"an unknown escape", "a \"\\q\"", "SCENE:1: unknown escape sequence"},
       {"a key that is there", "grid { elements 20 }\ngrid { elements 21 }",
        "SCENE:2: key 'grid.elements' is given twice, first in line 1"},
       {"a value and keys", "grid 5 { elements 20 }",
        "SCENE:1: key 'grid' has both a value and keys below it"},
       {"a comment of shells", "problem steady\n # steady\n", "SCENE:2: '# steady': " + directive},
       {"another file", "#include \"/etc/passwd\"\n",
        "SCENE:1: '#include \"/etc/passwd\"': " + directive},
       {"an endless tower of itself", "#include \"" + scene_file().string() + "\"",
        "SCENE:1: '#include \"SCENE\"': " + directive},
       {"nested deeply", repeated("a {", 100000),
        "SCENE:1: key '" + repeated("a.", 80) +
            "... (201 characters)': expected at most 200 characters"},
       {"nested for long names", repeated("abc {", 100) + "b 1\n" + repeated("}", 100),
        "SCENE:1: key '" + repeated("abc.", 40) +
            "... (203 characters)': expected at most 200 characters"},
       {"UTF-16", utf16(good_scene), "--scene SCENE: line 1: expected text in UTF-8, not UTF-16"},
       {"a NUL byte", "a 1\nb x" + std::string(1, '\0') + "y",
        "--scene SCENE: line 2: expected text in UTF-8, not a NUL byte"},
       {"a NUL byte, escaped", "a \"x\\0y\"",
        "SCENE:1: a = 'x\\x00y': expected no control characters"},
       {"a line's end in a value", "a \"x\\ny\"",
        "SCENE:1: a = 'x\\x0ay': expected no control characters"},
       {"a terminal's commands in a key", "\"\\b\\b\" 1",
        "SCENE:1: key '\\x08\\x08': expected no control characters"},
       {"a key of Latin-1", "problem steady\nl\xE4nge 1\n" + good_contact + "load { creepage 1 }",
        "SCENE:2: unknown key 'l\\xe4nge'; known to this model: problem, method, leading_edge, "
        "material.shear_modulus, material.poisson_ratio, direction, contact.half_width, "
        "contact.peak_traction, kernel.type, kernel.width, grid.elements, basis, load.creepage, "
        "solver.type, solver.tolerance, "
        "solver.violation, "
        "solver.condition, " +
            also_known},
       {"a long value", "problem " + repeated("x", 1000000),
        "SCENE:1: problem = '" + repeated("x", 160) +
            "... (1000000 characters)': expected steady or transient or cylinder"},
       {"a long key", repeated("x", 1000000) + " 1",
        "SCENE:1: key '" + repeated("x", 160) +
            "... (1000000 characters)': expected at most 200 characters"},
       {"too much", repeated("; a comment\n", 100000),
        "--scene SCENE: expected at most 1048576 bytes"}});
}

// Whatever is about a key of the scene begins with its file and line, and nothing else does.
TEST_F(BadInputs, PlacesOfKeys) {
  expect_rejected_scenes(
      {{"no number", replaced(good_scene, "width 40", "width x"),
        "SCENE:7: kernel.width = 'x': expected a finite number"},
       {"with another line's end",
        replaced(replaced(good_scene, "width 40", "width x"), "\n", "\r\n"),
        "SCENE:7: kernel.width = 'x': expected a finite number"},
       {"of a value that a model rejects", replaced(good_scene, "width 40", "width -1"),
        "SCENE:7: kernel.width = -1: expected a number > 0"},
       {"misspelt, and so missing", replaced(good_scene, "poisson_ratio", "poison_ratio"),
        "SCENE:3: missing key 'material.poisson_ratio'; 'material.poison_ratio' is no key (did you "
        "mean 'material.poisson_ratio'?)"},
       {"one of two", good_scene + "load { force -1 }\n",
        "SCENE:10: expected only one of 'load.creepage' and 'load.force'; --set KEY= takes one "
        "away"},
       {"without a role", good_scene + "\nstep { ratio 1 }\n",
        "SCENE:11: key 'step.ratio' has no role here: it is for leading_edge standard, known_edge "
        "or "
        "trimmed, or problem transient or cylinder; known to this model: problem, method, "
        "leading_edge, material.shear_modulus, material.poisson_ratio, direction, "
        "contact.half_width, "
        "contact.peak_traction, kernel.type, kernel.width, grid.elements, basis, load.creepage, "
        "solver.type, solver.tolerance, solver.violation, solver.condition, " +
            also_known},
       {"for a sweep", good_scene + "sweep { basis \"constant\" }",
        "SCENE:10: key 'sweep.basis': expected a scene without a sweep; for many see 'microslip "
        "sweep --help'"}});
  const std::string set = "--set kernel.type=sphere";
  expect_answer({"of a key that --set gives", "",
                 "kernel.type = 'sphere': expected strip or plane or winkler or symbol"},
                run_program("microslip", "", good_scene, set));
  expect_answer(
      {"in a case of a sweep", "",
       "SCENE:11: case 2 of 2 (basis = cubic): basis = 'cubic': expected constant or "
       "linear or quadratic"},
      run_program("microslip", "sweep", good_scene + "sweep {\n basis \"constant cubic\" }", ""));
  expect_answer({"of a list", "", "SCENE:10: sweep.basis = '': expected at least one value"},
                run_program("microslip", "sweep", good_scene + "sweep { basis }", ""));
}

TEST_F(BadInputs, ScenesThatAreAccepted) {
  const std::string plain = traction(good_scene);
  const std::string commented = replaced(good_scene, "\n", " ; d\xC3\xBC or d\xFC: # { \"\n");
  for (const std::string& scene : {replaced(good_scene, "\n", "\r\n"), bom + good_scene, commented,
                                   good_scene.substr(0, good_scene.size() - 1),
                                   bom + replaced(good_scene, "\n", "\r\n") + "; no line's end"}) {
    EXPECT_EQ(traction(scene), plain) << scene;
  }
}

TEST_F(BadInputs, Columns) {
  expect_rejected_bounds(
      {{"empty", "", "expected a line of column names, found none"},
       {"comments only", "# x\n\n", "expected a line of column names, found none"},
       {"a column twice", "x\tbound\tbound\n0\t1\t2\n",
        "line 1: expected one column 'bound', found more of that name"},
       {"another column twice", "# 1\na\tx\tbound\ta\n0\t0\t1\t2\n",
        "line 2: expected one column 'a', found more of that name"},
       {"another column", "x\tg\n0\t1\n",
        "line 1: expected a column 'bound' among the names in the first line, which are: x g"},
       {"a long line of names", repeated("abcdefg ", 1000),
        "line 1: expected a column 'x' among the names in the first line, which are: " +
            repeated("abcdefg ", 20) + "... (7999 characters)"},
       {"a word", "# comment\nx\tbound\n0\tone\n",
        "line 3: column 'bound': 'one' is not a finite number"},
       {"too large", "x\tbound\n0\t1e400\n",
        "line 2: column 'bound': '1e400' is not a finite number" + range},
       {"not a number", "x\tbound\n0\tnan\n",
        "line 2: column 'bound': 'nan' is not a finite number"},
       {"a cell that is missing", "x\tbound\n0\t1\n0.5\n", "line 3: expected 2 values, found 1"},
       {"no rows", "x\tbound\n", "line 1: expected at least one row below the names"},
       {"a comment behind", "x\tbound\n0\t1 # one\n",
        "line 2: column 'bound': '1 # one' is not a finite number"},
       {"commas in the rows alone", "x\tbound\n0,1\n", "line 2: expected 2 values, found 1"},
       {"tabs in the rows alone", "x,bound\n0\t1\n", "line 2: expected 2 values, found 1"},
       {"control characters", "x\tbound\n0\t\x1b[31m\n",
        "line 2: column 'bound': '\\x1b[31m' is not a finite number"},
       {"a NUL byte", "x\tbound\n0\t1" + std::string(1, '\0'),
        "line 2: expected text in UTF-8, not a NUL byte"},
       {"UTF-16", utf16("x\tbound\n0\t1\n"), "line 1: expected text in UTF-8, not UTF-16"}});
}

TEST_F(BadInputs, ColumnsThatAreAccepted) {
  const std::string text = "# comment\nx\tbound\n-0.5\t1\n0.5\t0.5\n";
  std::ofstream(folder_ / "bound.tsv") << text;
  const std::string plain = traction(bound_scene());
  for (const std::string& same :
       {replaced(text, "\n", "\r\n"), bom + text, text.substr(0, text.size() - 1),
        replaced(text, "\t", "   "), replaced(text, "\t", ","), replaced(text, "\t", " ; "),
        replaced(text, "\n", "\n\n# more\n"), replaced(text, "0.5", "0,5"),
        std::string("x\tword\tbound\n-.5\tnan\t+1\n+.5\ta,b\t5e-1")}) {
    std::ofstream(folder_ / "bound.tsv") << same;
    EXPECT_EQ(traction(bound_scene()), plain) << same;
  }
}

TEST_F(BadInputs, FilesThatAreNone) {
  const auto run_with = [&](const std::string& options) {
    return run_command(MICROSLIP_BIN "/microslip --out '" + out().string() + "' " + options);
  };
  const std::string nul = "line 1: expected text in UTF-8, not a NUL byte";
  const std::vector<std::pair<std::string, std::string>> list{
      {"/nowhere.info", "cannot read it: No such file or directory"},
      {"/", "cannot read it: Is a directory"},
      {"/proc/self/mem", "cannot read it: Input/output error"},
      {"/dev/zero", nul}};
  std::ofstream(scene_file()) << bound_scene();
  for (const auto& [path, says] : list) {
    expect_answer({"scene", "", "--scene " + path + ": " + says}, run_with("--scene " + path));
    expect_answer(
        {"bound", "", "contact.bound_file = '" + path + "': " + says},
        run_with("--scene '" + scene_file().string() + "' --set contact.bound_file=" + path));
  }
  expect_answer({"endless text", "", "--scene /dev/stdin: expected at most 1048576 bytes"},
                run_command("yes 'a 1' | " MICROSLIP_BIN "/microslip --scene /dev/stdin --out '" +
                            out().string() + "'"));
}

TEST_F(BadInputs, Lists) {
  const std::string form =
      "expected first:step:last with a step towards last, or first:logN:last with N >= 2 and both "
      "of one sign, and at most 100000 values";
  for (const auto& [what, text, says] :
       {BadInput{"ratio beyond doubles", "1e-300:log3:1e300", form},
        BadInput{"count beyond integers", "1:log99999999999:2", form},
        BadInput{"steps beyond integers", "0:1e-300:1", form},
        BadInput{"a decimal comma", "0:0,1:1", form}}) {
    expect_answer(
        {what, "", "sweep.load.creepage = '" + text + "': " + says},
        run_program("microslip", "sweep", good_scene, "--set 'sweep.load.creepage=" + text + "'"));
  }
  const std::string many = repeated("0:1:99999 ", 2000);
  expect_answer(
      {"many ranges", "",
       "sweep.load.creepage = '" + many.substr(0, 160) +
           "... (20000 characters)': expected at most 100000 values"},
      run_program("microslip", "sweep", good_scene, "--set 'sweep.load.creepage=" + many + "'"));
  const std::string shard = "expected i/n with i from 1 to n, and n up to 100000";
  for (const std::string text : {"5/18446744073709551615", "1/100001", "1e0/2", "1,2"}) {
    expect_answer({"shard", "", "--shard '" + text + "': " + shard},
                  run_program("microslip", "sweep", good_scene, "--shard " + text));
  }
}

TEST_F(BadInputs, TablesWithOtherLineEndsAreMerged) {
  const std::string scene = good_scene + "sweep { grid { elements \"10 20\" } }";
  ASSERT_EQ(run_program("microslip", "sweep", scene, "").status, 0);
  const std::string once = text_of(out() / "sweep.tsv");
  for (const char* name : {"plan.tsv", "cases/1.tsv", "cases/2.tsv"}) {
    const std::string text = text_of(out() / name);
    std::ofstream(out() / name) << bom + replaced(text, "\n", "\r\n");
  }
  fs::remove(out() / "sweep.tsv");
  const std::string merge = MICROSLIP_BIN "/microslip merge --out '" + out().string() + "'";
  EXPECT_EQ(run_command(merge).error, "");
  EXPECT_EQ(text_of(out() / "sweep.tsv"), once);
  const std::string row = text_of(out() / "cases/1.tsv");
  for (const std::string& damaged : {std::string(), replaced(row, "status", "state"), "x" + row,
                                     replaced(row, "#", std::string(1, '\0'))}) {
    std::ofstream(out() / "cases/1.tsv") << damaged;
    EXPECT_EQ(run_command(merge).error,
              "microslip: " + out().string() +
                  ": 1 of 2 cases are missing, the first is case 1 of 2 (grid.elements = 10)\n");
  }
}

TEST_F(BadInputs, TheLocaleHasNoRole) {
  const std::string plain = traction(good_scene);
  for (const char* locale : {"de_DE.UTF-8", "tr_TR.UTF-8", "C", "none"}) {
    EXPECT_EQ(traction(good_scene, "", std::string("LC_ALL=") + locale), plain) << locale;
  }
  // As the locales may be missing here: nothing that could take one from the environment is called.
  for (const char* program : {"microslip", "carter"}) {
    const std::string binary = text_of(fs::path(MICROSLIP_BIN) / program);
    EXPECT_NE(binary.find("_ZNSo"), std::string::npos) << program;
    EXPECT_EQ(binary.find("setlocale"), std::string::npos) << program;
    EXPECT_EQ(binary.find("_ZNSt6localeC1EPKc"), std::string::npos) << program;
  }
}

}  // namespace microslip::bad_inputs_test
