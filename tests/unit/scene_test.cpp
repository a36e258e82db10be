// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/table.hpp"
#include "scene_text.hpp"

namespace microslip::scene_test {

TEST(Scene, ReadsNestedKeys) {
  Scene scene = scene_of("problem steady\ngrid { elements 12 ; comment\n}\nlist \"1 2.5 1e-3\"");
  EXPECT_EQ(scene.word("problem"), "steady");
  EXPECT_EQ(scene.whole("grid.elements"), 12);
  EXPECT_EQ(scene.numbers("list"), (std::vector<double>{1, 2.5, 1e-3}));
  EXPECT_NO_THROW(scene.reject_unread());
}

TEST(Scene, HoldsValuesToTheKeysThatAReaderDeclares) {
  using enum Key::Type;
  static const std::vector<Key> own(
      {{"error.distance", number, "mm", "", above_zero},
       {"part", number, "1", "", inner_fraction},
       {"step.ratios", list, "1", "", range_above(0, 4)},
       {"positions", list, "mm", "", range_from(0)},
       {"grid.elements", whole, "1", "", range(3, 2000), "odd"},
       {"grid.sizes", wholes, "1", "", range(3, 2000)},
       {.name = "basis", .type = word, .words = {"both", "linear"}, .first_is_default = true}});
  const auto said = [](const char* key, const std::string& text, auto read) {
    return message([&] {
      Scene scene;
      if (!text.empty()) scene.set(std::string(key) + '=' + text);
      scene.declare(own);
      read(scene, key);
    });
  };
  const auto read_number = [](Scene& s, const char* key) { s.number(key); };
  const auto read_numbers = [](Scene& s, const char* key) { s.numbers(key); };
  const auto read_whole = [](Scene& s, const char* key) { s.whole(key); };
  const auto read_wholes = [](Scene& s, const char* key) { s.wholes(key); };
  const auto read_word = [](Scene& s, const char* key) { s.word(key); };
  EXPECT_EQ(said("error.distance", "2 cm", read_number), "");
  EXPECT_EQ(said("error.distance", "0", read_number), "error.distance = 0: expected a number > 0");
  EXPECT_NE(said("error.distance", "1e-60", read_number).find("1e-50"), std::string::npos);
  EXPECT_EQ(said("part", "0.999", read_number), "");
  EXPECT_EQ(said("part", "0", read_number), "part = 0: expected a number above 0, below 1");
  EXPECT_EQ(said("part", "1", read_number), "part = 1: expected a number above 0, below 1");
  EXPECT_NE(said("part", "0.5 mm", read_number).find("no unit"), std::string::npos);
  EXPECT_EQ(said("step.ratios", "4 1", read_numbers), "");
  EXPECT_EQ(said("step.ratios", "1 0", read_numbers),
            "step.ratios = 0: expected numbers above 0, at most 4");
  EXPECT_EQ(said("positions", "1 -2 cm", read_numbers), "positions = -20: expected numbers >= 0");
  EXPECT_EQ(said("grid.sizes", "3 2e3", read_wholes), "");
  for (const char* bad : {"2", "2001", "3.5"}) {
    EXPECT_EQ(said("grid.sizes", bad, read_wholes),
              std::string("grid.sizes = ") + bad + ": expected whole numbers 3 ... 2 000");
  }
  EXPECT_EQ(said("grid.elements", "2", read_whole),
            "grid.elements = 2: expected a whole number 3 ... 2 000; odd");
  EXPECT_EQ(said("basis", "linear", read_word), "");
  EXPECT_EQ(said("basis", "constant", read_word), "basis = 'constant': expected both or linear");
  EXPECT_EQ(said("basis", "", [](Scene& s, const char* key) { EXPECT_EQ(s.word(key), "both"); }),
            "");
  EXPECT_THROW(Scene().word("no.key"), std::logic_error);
}

TEST(Scene, TakesTheDefaultsOfKnownKeys) {
  Scene scene = scene_of("a 1");
  EXPECT_EQ(scene.number("grid.leading_offset"), 0.5);
  EXPECT_NE(message([&] { scene.number("contact.half_width"); }), "");
}

TEST(Scene, RecordsDefaultsAmongTheParameters) {
  Scene scene = scene_of("a 1");
  EXPECT_EQ(scene.number("a", 7), 1);
  EXPECT_EQ(scene.number("b", 0.5), 0.5);
  EXPECT_EQ(scene.word("basis"), "constant");
  EXPECT_EQ(scene.parameters(), (Parameters{{"a", "1"}, {"b", "0.5"}, {"basis", "constant"}}));
}

TEST(Scene, AssignmentsWinAndEmptyOnesRemove) {
  Scene scene = scene_of("a 1\nb { c 2 }");
  scene.set("b.c=3");
  scene.set("a=");
  EXPECT_EQ(scene.number("b.c"), 3);
  EXPECT_FALSE(scene.has("a"));
}

TEST(Scene, RemovesNoKeyThatIsNotThere) {
  Scene scene = scene_of("load { force 1 }\nsweep { grid { elements 5 } }");
  const auto answer = [&](const char* assignment) {
    return message([&] { scene.set(assignment); });
  };
  EXPECT_EQ(answer("load.forec="),
            "--set 'load.forec=': expected a key of this scene (did you mean 'load.force'?)");
  EXPECT_EQ(answer("load="),
            "--set 'load=': expected a key of this scene, not a section; its keys are load.force");
  EXPECT_EQ(answer("grid.elements="), "");
  EXPECT_FALSE(scene.has("sweep.grid.elements"));
  EXPECT_NE(answer("grid.elements="), "");
}

TEST(Scene, OverlayReplacesAndAdds) {
  Scene scene = scene_of("a 1\nb 2");
  scene.overlay(scene_of("b 3\nc 4"));
  EXPECT_EQ(scene.number("a") + scene.number("b") + scene.number("c"), 8);
}

TEST(Scene, RejectsTextThatIsNoFiniteDecimalNumber) {
  for (const char* text : {"abc", "1x", "nan", "inf", "1,5", "0x10", "1e400", "1 2", "+-1"}) {
    Scene scene;
    scene.set(std::string("a=") + text);
    EXPECT_NE(message([&] { scene.number("a"); }).find("a = '"), std::string::npos) << text;
  }
}

TEST(Scene, RejectsWholeNumbersThatAreNot) {
  for (const char* text : {"1.5", "1e400", "1e16", "99999999999999999999"}) {
    Scene scene;
    scene.set(std::string("a=") + text);
    EXPECT_NE(message([&] { scene.whole("a"); }), "") << text;
  }
}

TEST(Scene, NamesTheMissingKeyAndANearOne) {
  Scene scene = scene_of("grid { elemnts 5 }");
  EXPECT_EQ(
      message([&] { scene.whole("grid.elements"); }),
      "missing key 'grid.elements'; 'grid.elemnts' is no key (did you mean 'grid.elements'?)");
}

TEST(Scene, NamesTheUnknownKeyAndTheKnownOnes) {
  Scene scene = scene_of("a 1\nextra 2");
  scene.number("a");
  EXPECT_EQ(message([&] { scene.reject_unread(); }), "unknown key 'extra'; known to this model: a");
}

// A key that a reader asked for is known, given or not, and so are all that exclude each other.
TEST(Scene, NamesTheKeysThatWereAskedFor) {
  Scene scene = scene_of("a 1\nextra 2");
  EXPECT_FALSE(scene.has("c"));
  EXPECT_EQ(scene.one_of({"b", "a"}), "a");
  EXPECT_EQ(scene.number("a"), 1);
  EXPECT_EQ(message([&] { scene.reject_unread(); }),
            "unknown key 'extra'; known to this model: a, c, b");
}

TEST(Scene, RejectsRepeatedKeysAndBrokenFiles) {
  EXPECT_NE(message([] { scene_of("a 1\na 2"); }).find("'a' is given twice"), std::string::npos);
  EXPECT_NE(message([] { scene_of("a { b 1"); }).find("test:1: unmatched {"), std::string::npos);
  EXPECT_NE(message([] { scene_of("a 1 { b 2 }"); }).find("'a' has both"), std::string::npos);
  EXPECT_NE(message([] { Scene().set("novalue"); }).find("key=value"), std::string::npos);
}

TEST(Model, AKeyOfTheOtherKernelIsUnknown) {
  Scene scene = scene_of("kernel { type plane\nlength 1\nwidth 2 }");
  read_kernel(scene, {1, 0.28});
  EXPECT_NE(message([&] { scene.reject_unread(); }).find("'kernel.width'"), std::string::npos);
}

TEST(Model, WantsExactlyOneLoad) {
  for (const char* text : {"load { creepage 1\nforce 1 }", "problem steady"}) {
    Scene scene = scene_of(text);
    const std::string said = message([&] {
      read_load(scene, PlaneKernel({1, 0.28}, 10), HertzBound(1, 1));
    });
    EXPECT_NE(said.find("'load.creepage'"), std::string::npos) << text;
    EXPECT_NE(said.find("'load.force'"), std::string::npos) << text;
  }
}

TEST(Table, WritesParametersColumnsAndFullDigits) {
  Table table("t", "what it is", {{"x", "mm", "position"}, {"region", "1", "A or S"}});
  table.add({0.1, "A"});
  std::ostringstream out;
  table.write(out, "prog", {{"grid.elements", "5"}});
  EXPECT_EQ(out.str(),
            "# prog: what it is\n# parameters\n#   grid.elements = 5\n# columns\n"
            "#   x [mm]: position\n#   region [1]: A or S\nx\tregion\n0.10000000000000001\tA\n");
}

TEST(Table, LatestIsTheLastRowWithTheseCells) {
  Table table("t", "", {{"name", "1", ""}, {"x", "mm", ""}, {"y", "1", ""}});
  table.add({"a", 1.0, 10.0});
  table.add({"b", 1.0, 20.0});
  table.add({"a", 1.0, 30.0});
  table.add({"a", 2.0, 40.0});
  EXPECT_EQ(table.latest({{"name", "a"}}, "y"), 40);
  EXPECT_EQ(table.latest({{"name", "a"}, {"x", 1.0}}, "y"), 30);
  EXPECT_TRUE(std::isnan(table.latest({{"name", "b"}, {"x", 2.0}}, "y")));
  EXPECT_THROW(table.latest({{"z", 1.0}}, "y"), std::out_of_range);
}

TEST(Table, RejectsARowOfTheWrongLength) {
  Table table("t", "", {{"x", "mm", ""}});
  EXPECT_THROW(table.add({1.0, 2.0}), std::logic_error);
}

// As in sweeps: the ends, and the numbers between them to 15 digits.
TEST(Scene, ListsHaveRanges) {
  const auto numbers = [](const std::string& key, const std::string& text) {
    Scene scene;
    scene.set(key + "=" + text);
    return scene.numbers(key);
  };
  EXPECT_EQ(numbers("a", "1:2:7"), (std::vector<double>{1, 3, 5, 7}));
  EXPECT_EQ(numbers("a", "5 0:0.1:0.3 8:log4:1"),
            (std::vector<double>{5, 0, 0.1, 0.2, 0.3, 8, 4, 2, 1}));
  EXPECT_EQ(numbers("start.force", "-500:500:500 N/mm"), (std::vector<double>{-500, 0, 500}));
  EXPECT_EQ(numbers("start.force", "1:1:2 kN/m 3N/mm"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(message([&] { numbers("a", "1:4"); }).find("a = '1:4': expected first:step:last"), 0U);
  EXPECT_EQ(message([&] { numbers("a", "x:1:2"); }),
            "a = 'x:1:2': expected finite numbers, separated by blanks");
  Scene scene = scene_of("converge { elements 10:10:40 }");
  EXPECT_EQ(scene.wholes("converge.elements"), (std::vector<Eigen::Index>{10, 20, 30, 40}));
  EXPECT_EQ(scene.parameters().back().second, "10 20 30 40");
}

TEST(Scene, NamesAllMissingKeys) {
  const auto missing = [](const std::string& text) {
    Scene scene = scene_of(text);
    return message([&] { read_model(scene); });
  };
  EXPECT_EQ(missing(""), "missing key 'problem'");
  EXPECT_EQ(missing("problem steady\nkernel { type plane }"),
            "missing keys 'material.shear_modulus' or 'material.youngs_modulus', "
            "'material.poisson_ratio', 'contact.half_width' or 'contact.normal_load', "
            "'contact.peak_traction' or 'contact.bound_file', 'kernel.length', 'grid.elements', "
            "'load.creepage' or 'load.force' or 'load.force_ratio' or 'load.stick_ratio'");
  const std::string contact =
      "problem transient\nmaterial { shear_modulus 1 poisson_ratio 0 }\n"
      "contact { half_width 1 peak_traction 1 }\n";
  // A word decides which keys come behind it.
  EXPECT_EQ(missing(contact), "missing key 'kernel.type'");
  EXPECT_EQ(missing(contact + "kernel { type strip }"),
            "missing keys 'kernel.width', 'grid.elements', 'load.creepage' or 'load.force' or "
            "'load.force_ratio' or 'load.stick_ratio' or 'load.file', 'step.ratio', 'start.type'");
  // If there are two ways, the message names the one that wants fewer further keys.
  const std::string steel = "problem steady\nmaterial { shear_modulus 1 poisson_ratio 0 }\n";
  EXPECT_EQ(missing(steel + "contact { radius_1 1 friction 0.3 }"),
            "missing keys 'contact.half_width' or 'contact.normal_load', 'kernel.type'");
  EXPECT_EQ(missing(contact + "kernel { type strip widht 1 }"),
            missing(contact + "kernel { type strip }") +
                "; 'kernel.widht' is no key (did you mean 'kernel.width'?)");
}

}  // namespace microslip::scene_test
