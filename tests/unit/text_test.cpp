// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "microslip/support/format.hpp"
#include "microslip/support/shown.hpp"
#include "scene_text.hpp"

namespace microslip::text_test {

TEST(Format, TellsTwoNumbersApart) {
  using Two = std::pair<std::string, std::string>;
  EXPECT_EQ(format_apart(24.06, 23.99), Two("24.1", "24"));
  EXPECT_EQ(format_apart(0.00015234, 0.00015), Two("0.000152", "0.00015"));
  EXPECT_EQ(format_apart(4, 0.39), Two("4", "0.39"));
  EXPECT_EQ(format_apart(1, 1), Two("1", "1"));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> digits(-15, 0), logs(-5, 5);
  for (int i = 0; i < 2000; ++i) {
    const double b = std::pow(10, logs(random)), a = b * (1 + std::pow(10, digits(random)));
    const auto [above, below] = format_apart(a, b);
    EXPECT_GT(std::stod(above), b);
    EXPECT_LT(std::stod(below), a);
  }
}

TEST(Format, PercentIsWrittenOut) {
  EXPECT_EQ(format_percent(1.2345), "123 %");
  EXPECT_EQ(format_percent(0.996), "100 %");
  EXPECT_EQ(format_percent(-0.1807), "-18 %");
  EXPECT_EQ(format_percent(1.234e-4), "0.012 %");
}

TEST(PlainText, HasOneKindOfLineEndAndNoMark) {
  EXPECT_EQ(plain_text("a\r\nb\n\r\n"), "a\nb\n\n");
  EXPECT_EQ(plain_text("\xEF\xBB\xBF"
                       "a"),
            "a");
  EXPECT_EQ(plain_text("a\rb\r"), "a\rb\r");
  EXPECT_EQ(plain_text(""), "");
}

TEST(PlainText, RejectsWhatIsNoText) {
  EXPECT_EQ(message([] {
              plain_text(
                  std::string("\xFF\xFE"
                              "a\0",
                              4));
            }),
            "line 1: expected text in UTF-8, not UTF-16");
  EXPECT_EQ(message([] { plain_text(std::string("a\nb\nc\0\n", 7)); }),
            "line 3: expected text in UTF-8, not a NUL byte");
}

TEST(Shown, EscapesWhatIsNotPrintable) {
  EXPECT_EQ(shown("plain: \xC3\xA4 \xE2\x88\x92"), "plain: \xC3\xA4 \xE2\x88\x92");
  EXPECT_EQ(shown("a\n\t\x1b[31m\x7f"), "a\\x0a\\x09\\x1b[31m\\x7f");
  EXPECT_EQ(shown(std::string("\0", 1)), "\\x00");
  EXPECT_EQ(shown("l\xE4nge \xC3"), "l\\xe4nge \\xc3");
  EXPECT_EQ(shown("\xC2\x9B"
                  "31m"),
            "\\xc2\\x9b31m");
  EXPECT_EQ(shown("\xE2\x80\xA8"), "\\xe2\\x80\\xa8");
}

TEST(Shown, ShortensBetweenCharacters) {
  EXPECT_EQ(shown("abcde", 5), "abcde");
  EXPECT_EQ(shown("abcdef", 5), "abcde... (6 characters)");
  EXPECT_EQ(shown("\n\n\n\n", 5), "\\x0a\\x0a... (4 characters)");
  EXPECT_EQ(shown("a\xC3\xA4\xC3\xA4", 2), "a\xC3\xA4... (5 characters)");
}

}  // namespace microslip::text_test
