// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a scene, and the places of its keys in it, which messages name.
#include <gtest/gtest.h>

#include "microslip/friction/traction_bound.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/scene.hpp"
#include "microslip/scene/sweep.hpp"
#include "scene_text.hpp"

namespace microslip::scene_places_test {

std::string said(const Scene& scene, const std::function<void(Scene&)>& read) {
  Scene copy = scene;
  return message([&] { with_places(copy, [&] { read(copy); }); });
}

std::string said_of(const std::string& text) {
  return message([&] { scene_of(text); });
}

TEST(ScenePlaces, AreLinesOfKeys) {
  const std::string text =
      "; a comment\n"
      "first 1\n"
      "\n"
      "outer\n"
      "{ inner { key \"{ ; }\" } ; }\n"
      "  after 2 \"quoted key\" \"with \\\" and {\"\n"
      "}  last \"one \" \\ ; goes on\n"
      "  ; not yet\n"
      "  \"two\" empty";
  std::string crlf;
  for (const char c : text) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& same : {text, crlf, "\xEF\xBB\xBF" + text + "\n"}) {
    const Scene scene = scene_of(same);
    EXPECT_EQ(scene.keys(), (std::vector<std::string>{"first", "outer.inner.key", "outer.after",
                                                      "outer.quoted key", "last", "empty"}));
    EXPECT_EQ(scene.place_of("first"), "test:2: ");
    EXPECT_EQ(scene.place_of("outer.inner.key"), "test:5: ");
    EXPECT_EQ(scene.text("outer.inner.key"), "{ ; }");
    EXPECT_EQ(scene.place_of("outer.after"), "test:6: ");
    EXPECT_EQ(scene.text("outer.quoted key"), "with \" and {");
    EXPECT_EQ(scene.place_of("last"), "test:7: ");
    EXPECT_EQ(scene.text("last"), "one two");
    EXPECT_EQ(scene.place_of("empty"), "test:9: ");
    EXPECT_EQ(scene.place_of("other"), "");
  }
}

// A key that is missing may be there, misspelt.
TEST(ScenePlaces, AreThoseOfAKeyThatMayBeMeant) {
  const Scene scene = scene_of("a 1\nload { forse -1 }\n");
  EXPECT_EQ(
      said(scene,
           [](Scene& s) {
             s.one_of({"load.creepage", "load.force_ratio"});
           }),
      "test:2: missing key 'load.creepage' or 'load.force_ratio'; 'load.forse' is no key (did "
      "you mean 'load.force'?)");
}

// Errors of core name arguments; those of a scene name the key that gives the argument.
TEST(ScenePlaces, AreThoseOfTheKeyThatGivesAnArgument) {
  const Scene scene = scene_of("contact {\n half_width -1\n bound_polynomial 1\n}\n");
  const auto of = [&](const std::string& name) {
    return said(scene, [&](Scene&) { require(false, name, -1, "more"); });
  };
  EXPECT_EQ(of("half_width"), "test:2: contact.half_width = -1: expected more");
  EXPECT_EQ(of("least value of coefficients"),
            "test:3: least value of contact.bound_polynomial = -1: expected more");
  EXPECT_EQ(of("length"), "kernel.length = -1: expected more");
  EXPECT_EQ(of("step length"), "step length = -1: expected more");
  EXPECT_EQ(message([] { HertzBound(-1, 1); }), "half_width = -1: expected a number > 0");
}

TEST(ScenePlaces, AreInFrontOfMessages) {
  const Scene scene = scene_of("a {\n b x\n}\nc 1\n");
  EXPECT_EQ(said(scene, [](Scene& s) { s.number("a.b"); }),
            "test:2: a.b = 'x': expected a finite number");
  EXPECT_EQ(said(scene, [](Scene&) { require_positive("c", -1); }),
            "test:4: c = -1: expected a number > 0");
  EXPECT_EQ(said(scene, [](Scene&) { require(false, "least value of c", 1, "more"); }),
            "test:4: least value of c = 1: expected more");
  EXPECT_EQ(said(scene, [](Scene&) { require(false, "d", 1, "more"); }), "d = 1: expected more");
  EXPECT_EQ(said(scene,
                 [](Scene& s) {
                   s.from_columns("c", {{"x", "1"}}, [](const auto&) {});
                 }),
            "test:4: c = '1': expected no file here");
  EXPECT_EQ(said(scene, [](Scene& s) { s.number("a.bb"); }),
            "test:2: missing key 'a.bb'; 'a.b' is no key (did you mean 'a.bb'?)");
  EXPECT_EQ(said(scene, [](Scene& s) { s.number("nothing.like.it"); }),
            "missing key 'nothing.like.it'");
  EXPECT_EQ(said(scene,
                 [](Scene& s) {
                   s.one_of({"a.b", "c"});
                 }),
            "test:4: expected only one of 'a.b' and 'c'");
}

TEST(ScenePlaces, OfAMisspeltKey) {
  const Scene scene = scene_of("a 1\n\nb {\n  cc 2 }");
  EXPECT_EQ(said(scene,
                 [](Scene& s) {
                   s.number("a");
                   s.number("b.c", 1);
                   s.reject_unread();
                 }),
            "test:4: unknown key 'b.cc' (did you mean 'b.c'?)");
}

// The key that would make the contact an ellipse is misspelt, and so units seem to be wrong.
TEST(ScenePlaces, OfAMisspeltKeyComeBeforeThoseOfOthers) {
  const Scene scene = scene_of(
      "problem steady\nmaterial { youngs_modulus 210 GPa\npoisson_ratio 0.28 }\n"
      "contact { normal_load 75 kN\nradius_1 460 mm\nfriction 0.3\n"
      "lateral_raduis_2 300 mm }\nload { creepage 0.001 }");
  EXPECT_EQ(said(scene, [](Scene& s) { read_model(s); }),
            "test:7: unknown key 'contact.lateral_raduis_2' (did you mean "
            "'contact.lateral_radius_2'?)");
}

TEST(ScenePlaces, OfAKeyInOtherLetters) {
  const Scene scene = scene_of("a 1\nLOAD {\n SPIN 2 }");
  EXPECT_EQ(said(scene,
                 [](Scene& s) {
                   s.number("a");
                   s.reject_unread();
                 }),
            "test:3: unknown key 'LOAD.SPIN' (did you mean 'load.spin'?)");
  EXPECT_EQ(said(scene, [](Scene& s) { s.number("load.spin"); }),
            "test:3: missing key 'load.spin'; 'LOAD.SPIN' is no key (did you mean 'load.spin'?)");
  EXPECT_EQ(likely_key("CONTACT.SPIN"), "load.spin");
  EXPECT_EQ(likely_key("Load.Crepage"), "load.creepage");
}

// What is there under its right name is not the one that is missing.
TEST(ScenePlaces, OfAKeyInTheWrongSection) {
  const Scene scene = scene_of("load { spin 0.1\n creepage 0 }\ncontact { speed 3 m/s }");
  EXPECT_EQ(said(scene, [](Scene& s) { s.number("load.speed"); }),
            "test:3: missing key 'load.speed'; 'contact.speed' is no key (did you mean "
            "'load.speed'?)");
}

TEST(ScenePlaces, AreThoseOfTheSceneThatWins) {
  std::istringstream more("\nb x\nc x");
  Scene scene = scene_of("a x\nb 2\nd x");
  scene.overlay(Scene::parse(more, "quick.info"));
  scene.set("c=y");
  const auto number = [&](const char* key) {
    return said(scene, [&](Scene& s) { s.number(key); });
  };
  EXPECT_EQ(number("a"), "test:1: a = 'x': expected a finite number");
  EXPECT_EQ(number("b"), "quick.info:2: b = 'x': expected a finite number");
  EXPECT_EQ(number("c"), "c = 'y': expected a finite number");
  EXPECT_EQ(said(scene,
                 [](Scene& s) {
                   s.one_of({"d", "c"});
                 }),
            "test:3: expected only one of 'd' and 'c'");
}

TEST(ScenePlaces, OfASweep) {
  const Scene scene = scene_of("a 1\nsweep {\n a \"2 x\"\n b \"1:0:2\" }");
  EXPECT_TRUE(said(scene, [](Scene& s) { Sweep{s}; }).starts_with("test:4: sweep.b = '1:0:2': "));
  Scene good = scene;
  good.set("sweep.b=1");
  EXPECT_EQ(said(Sweep(good).scene(1), [](Scene& s) { s.number("a"); }),
            "test:3: a = 'x': expected a finite number");
}

TEST(ScenePlaces, OfTextThatIsNoScene) {
  EXPECT_EQ(said_of("a 1\nb {\n c {\n }\n"), "test:2: unmatched {");
  EXPECT_EQ(said_of("a 1\n}"), "test:2: unmatched }");
  EXPECT_EQ(said_of("a 1\n{"), "test:2: key 'a' has both a value and keys below it");
  EXPECT_EQ(said_of("\n{ a 1 }"), "test:2: unexpected {");
  EXPECT_EQ(said_of("a {} { b 1 }"), "test:1: unexpected {");
  EXPECT_EQ(said_of("a \"x"), "test:1: unexpected end of line");
  EXPECT_EQ(said_of("a \"x\\\"\n"), "test:1: unexpected end of line");
  EXPECT_EQ(said_of("a \\q"), "test:1: unknown escape sequence");
  EXPECT_EQ(said_of("a x\\"), "test:1: character expected after backslash");
  EXPECT_EQ(said_of("a \"x\" \\ y"), "test:1: expected end of line after \\");
  EXPECT_EQ(said_of("a \"x\" \\\ny"), "test:2: expected \" after \\ in previous line");
  EXPECT_EQ(said_of("\n#include \"x\""),
            "test:2: '#include \"x\"': expected ; before comments, and no other files");
  EXPECT_EQ(said_of("a {\n b 1\n}\na.b 2"), "test:4: key 'a.b' is given twice, first in line 2");
  EXPECT_EQ(said_of("\na \"\\a\""), "test:2: a = '\\x07': expected no control characters");
}

TEST(ScenePlaces, ASectionWithoutKeysIsAKeyWithoutAValue) {
  const Scene scene = scene_of("a {\n}\nb { c { } d 1 }");
  EXPECT_EQ(scene.keys(), (std::vector<std::string>{"a", "b.c", "b.d"}));
  EXPECT_EQ(scene.text("b.c"), "");
  EXPECT_EQ(scene.place_of("b.c"), "test:3: ");
}

TEST(ScenePlaces, AUnitNeedsNoQuotes) {
  const Scene scene = scene_of(
      "a 1 mm b 2  N s^2 / mm^2 ; kg\nc { d 3 m } e -4e1 x\nf 5 g 6 h\ni 7 kg m \"j\" k\nl 8 ; m");
  const std::vector<std::pair<std::string, std::string>> values{
      {"a", "1 mm"}, {"b", "2  N s^2 / mm^2"}, {"c.d", "3 m"}, {"e", "-4e1 x"}, {"f", "5 g"},
      {"6", "h"},    {"i", "7 kg m"},          {"j", "k"},     {"l", "8"}};
  for (const auto& [key, text] : values) EXPECT_EQ(scene.text(key), text) << key;
  EXPECT_EQ(scene.keys().size(), values.size());
}

}  // namespace microslip::scene_places_test
