// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/units.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/sweep.hpp"
#include "scene_text.hpp"

namespace microslip::units_test {

TEST(Units, ConvertWithinAKind) {
  EXPECT_EQ(quantity("20", "mm"), 20);
  EXPECT_EQ(quantity("20 mm", "mm"), 20);
  EXPECT_EQ(quantity("2cm", "mm"), 20);
  EXPECT_EQ(quantity("-1e-3 m", "mm"), -1);
  EXPECT_EQ(quantity("1 in", "mm"), 25.4);
  EXPECT_EQ(quantity("82 GPa", "N/mm^2"), 82000);
  EXPECT_EQ(quantity("300 N/mm2", "N/mm^2"), 300);
  EXPECT_EQ(quantity("300 N / mm\u00b2", "N/mm^2"), 300);
  EXPECT_EQ(quantity("3e8 Pa", "N/mm^2"), 300);
  EXPECT_EQ(quantity("1500 kN/m", "N/mm"), 1500);
  EXPECT_EQ(quantity("5500 kg/m", "N s^2/mm^2"), 0.0055);
  EXPECT_EQ(quantity("5.5 N*s\u00b2/m^2", "N s^2/mm^2"), 5.5e-6);
  EXPECT_EQ(quantity("0.77 kg\u00b7m", "N s^2"), 0.77);
  EXPECT_EQ(quantity("0.5 m/s", "mm/s"), 500);
  EXPECT_EQ(quantity("0.2 %", "1"), 0.002);
}

TEST(Units, OfAListAreBehindTheLastOrBehindEach) {
  const std::vector<double> forces{-500, 500};
  for (const char* text : {"-500 500", " -500\t500 ", "-0.5 0.5 kN/mm", "-.5kN/mm +0.5 kN / mm",
                           "-500 N/mm 500e3 N/m", "-500 500N/mm"}) {
    EXPECT_EQ(quantities(text, "N/mm"), forces) << text;
  }
  EXPECT_EQ(quantities("2 cm", "mm"), (std::vector<double>{20}));
  EXPECT_EQ(quantities("1 1 N s^2/mm^2", "N s^2/mm^2"), (std::vector<double>{1, 1}));
  EXPECT_EQ(quantities("", "mm"), std::vector<double>());
  for (const char* text : {"0 1 2 1/m", "0 1/m 1 1/m 2 1/m", "0/m 1/m 2/m", "0 1 2/m"}) {
    EXPECT_EQ(quantities(text, "1/mm"), (std::vector<double>{0, 0.001, 0.002})) << text;
  }
  EXPECT_EQ(quantities("1/m 2/m", "1/mm"), (std::vector<double>{0.001, 0.002}));
  for (const char* text : {"0 1/m 2/m", "1/m 2 1/m", "0 1/m 2"}) {
    EXPECT_FALSE(quantities(text, "1/mm")) << text;
  }
  for (const char* text : {"1 mm 2", "1 mm 2 3 mm", "1 2 N", "mm 1", "1 x", "1 nan", "1 1e400",
                           "1 2 mm mm", "1, 2", "1 1e306 km"}) {
    EXPECT_FALSE(quantities(text, "mm")) << text;
  }
}

// A power of ten divides or multiplies once: 0.009 and not 0.009000000000000001 = 9 * 0.001.
TEST(Units, PowersOfTenAreExact) {
  EXPECT_EQ(quantity("9 um", "mm"), 0.009);
  EXPECT_EQ(quantity("9 \u00b5m", "mm"), 0.009);
  EXPECT_EQ(quantity("9 \u03bcm", "mm"), 0.009);
  EXPECT_EQ(quantity("0.1 kPa", "N/mm^2"), 1e-4);
}

TEST(Units, RejectsOtherKindsAndWhatIsNoUnit) {
  for (const char* text :
       {"1 N", "1 mm^2", "1 furlong", "1 mm/mm", "1 mm/s/s", "1 /mm", "1 mm/", "1 mm^", "1 mm^0",
        "1 mm^10", "1 %", "1 mm mm", "mm", "", "1 2", "1e400 mm", "1e306 km", "nan mm", "1,5 mm"}) {
    EXPECT_FALSE(quantity(text, "mm")) << text;
  }
  EXPECT_FALSE(quantity("1 mm", "1"));
}

// A word behind a number is meant as a unit, but not a letter as other notations of numbers have it.
TEST(Units, OfOtherLettersAreToldFromNumbers) {
  for (const char* text : {"80KN", "80 KN", "0.1 1/M", "0.1 1/Mm", "80kilonewton", "3Gpa", "2M"}) {
    EXPECT_TRUE(has_unit(text)) << text;
    EXPECT_FALSE(quantity(text, "N")) << text;
  }
  for (const char* text : {"0x10", "1.5d3", "1.5e", "1,5", "1 2", "80", "KN", "1,000.5"}) {
    EXPECT_FALSE(has_unit(text)) << text;
  }
  Scene scene =
      scene_of("contact { normal_load 80KN lateral_half_width 5 }\nload { creepage 1 permille }");
  EXPECT_EQ(message([&] { scene.number("contact.normal_load"); }),
            "contact.normal_load = '80KN': expected a number in N or another of its kind (kN, MN)");
  EXPECT_EQ(message([&] { scene.number("load.creepage"); }),
            "load.creepage = '1 permille': expected a number in no unit, or in % or \u2030");
}

TEST(Units, NeedNoQuotesInScenes) {
  Scene scene = scene_of(
      "contact { half_width 0.5 cm peak_traction 300 MPa } ; 1 mm\n"
      "cylinder { mass 5500 kg / m\n inertia \"0.77 N s^2\" }\n"
      "a 1 b 2\nname \"2 mm\" \"c\" 3\nlist \"1 2\"");
  EXPECT_EQ(scene.number("contact.half_width"), 5);
  EXPECT_EQ(scene.number("contact.peak_traction"), 300);
  EXPECT_EQ(scene.number("cylinder.mass"), 0.0055);
  EXPECT_EQ(scene.number("cylinder.inertia"), 0.77);
  EXPECT_EQ(scene.whole("a"), 1);
  EXPECT_EQ(scene.whole("b"), 2);
  EXPECT_EQ(scene.text("name"), "2 mm");
  EXPECT_EQ(scene.whole("c"), 3);
  EXPECT_EQ(scene.numbers("list").size(), 2u);
}

// Tables of a scene do not show in which units it was written.
TEST(Units, ParametersAreInTheUnitOfTheKey) {
  Scene scene = scene_of("kernel { width 2 cm }");
  scene.number("kernel.width");
  EXPECT_EQ(scene.parameters(), (Parameters{{"kernel.width", "20"}}));
  Scene list = scene_of("start { force \"-1 0.5 kN/mm\" }");
  EXPECT_EQ(list.numbers("start.force"), (std::vector<double>{-1000, 500}));
  EXPECT_EQ(list.parameters(), (Parameters{{"start.force", "-1000 500"}}));
}

TEST(Units, SweptValuesAreNumbersInTheUnitOfTheKey) {
  EXPECT_EQ(swept_values("kernel.width", "5 mm | 1 cm | 20"),
            (std::vector<std::string>{"5", "10", "20"}));
  EXPECT_EQ(swept_values("start.force", "1 -1 kN/mm | 1 2 | 1e1 | 5 N/m 7 mm"),
            (std::vector<std::string>{"1000 -1000", "1 2", "1e1", "5 N/m 7 mm"}));
  EXPECT_EQ(swept_values("start.file", "3 mm|b"), (std::vector<std::string>{"3 mm", "b"}));
}

TEST(Keys, UnitsAreUnits) {
  for (const Key& key : keys_of_scenes()) {
    EXPECT_TRUE(is_unit(key.unit)) << key.name;
    EXPECT_EQ(unit_of_key(key.name), key.unit);
    EXPECT_EQ(accepted_units(std::string(key.unit)).starts_with("no unit"), key.unit == "1")
        << key.name;
  }
  EXPECT_EQ(unit_of_key("no.such.key"), "1");
}

// 1/min of a wheel is one revolution a minute for some and one radian for others.
TEST(Units, OfAnAngularVelocityNameTheAngle) {
  const double pi = std::numbers::pi;
  EXPECT_DOUBLE_EQ(*quantity("30 rad/min", "rad/s"), 0.5);
  EXPECT_DOUBLE_EQ(*quantity("30 rpm", "rad/s"), pi);
  EXPECT_DOUBLE_EQ(*quantity("30 rev/min", "rad/s"), pi);
  EXPECT_DOUBLE_EQ(*quantity("0.5 rev/s", "rad/s"), pi);
  EXPECT_DOUBLE_EQ(*quantity("180 deg/s", "rad/s"), pi);
  for (const char* text : {"30 1/min", "30 1/s", "30 rad", "30 rad2/s", "30 s/rad", "30 1"}) {
    EXPECT_FALSE(quantity(text, "rad/s")) << text;
  }
  EXPECT_FALSE(quantity("30 rad/s", "1"));
  // A spin is an angle a length; other lengths to a power have no angle.
  EXPECT_DOUBLE_EQ(*quantity("0.2 rad/m", "1/mm"), 2e-4);
  EXPECT_DOUBLE_EQ(*quantity("18 deg/m", "1/mm"), pi / 1e4);
  EXPECT_EQ(quantities("0 1 2 rad/m", "1/mm"), (std::vector<double>{0, 0.001, 0.002}));
  for (const char* text : {"0.2 rad", "0.2 rad2/m", "0.2 rad/s", "0.2 m/rad", "0.2 rev"}) {
    EXPECT_FALSE(quantity(text, "1/mm")) << text;
  }
  EXPECT_FALSE(quantity("2 rad mm", "mm"));
  Scene scene = scene_of("load { file run.tsv }");
  scene.read_files_by([](const std::string&) { return "omega [1/min]\n461\n"; });
  EXPECT_EQ(
      message([&] {
        scene.from_columns("load.file", {{"omega", "rad/s"}}, [](const auto&) { return 0; });
      }),
      "load.file = 'run.tsv': line 1: column 'omega': unit '1/min': expected rad/s or another "
      "of its kind (rad/min, deg/s, rev/s, rev/min, rpm)");
}

}  // namespace microslip::units_test
