// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/changed_keys.hpp"

#include <gtest/gtest.h>

namespace microslip::changed_keys_test {

using Keys = std::vector<std::string>;

TEST(ChangedKeys, AreThoseWithOtherValues) {
  const Parameters before{{"a", "1"}, {"b", "dense"}, {"c", "1 2 3"}};
  EXPECT_EQ(changed_keys(before, before), Keys{});
  EXPECT_EQ(changed_keys(before, {{"a", "2"}, {"b", "dense"}, {"c", "1 2 4"}}), (Keys{"a", "c"}));
  EXPECT_EQ(changed_keys(before, {{"a", "1"}, {"b", "fft"}, {"c", "1 2"}}), (Keys{"b", "c"}));
  EXPECT_EQ(changed_keys({{"a", "1"}}, {{"a", "1.0000000000000002"}}), Keys{"a"});
}

TEST(ChangedKeys, AreThoseOfOneOnly) {
  EXPECT_EQ(changed_keys({{"a", "1"}, {"b", "2"}}, {{"a", "1"}, {"c", "2"}}), (Keys{"b", "c"}));
}

TEST(ChangedKeys, AreNoneForAnotherOrderOrAnotherWayToWriteAValue) {
  EXPECT_EQ(changed_keys({{"a", "1"}, {"b", "2"}}, {{"b", "2"}, {"a", "1"}}), Keys{});
  EXPECT_EQ(changed_keys({{"a", "1 0.5 1e-3"}}, {{"a", "1.0\t+.5  0.001"}}), Keys{});
}

}  // namespace microslip::changed_keys_test
