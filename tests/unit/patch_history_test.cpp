// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of a patch that change: each component as a load of a line contact.
#include "microslip/rolling/patch_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_text.hpp"

namespace microslip::patch_history_test {

using Eigen::VectorXd;

RunRows rows() {
  RunRows found;
  found.distance = VectorXd{{0, 2, 4}};
  return found;
}

TEST(PatchHistory, IsConstantWithoutRows) {
  const PatchLoad load{{{false, 0.1}, {true, 5}, {true, -7}}};
  const PatchHistory constant(load);
  EXPECT_EQ(constant.at(3), load);
  EXPECT_EQ(constant.between(1, 1e6), load);
  EXPECT_TRUE(std::isinf(constant.distance()));
  EXPECT_TRUE(constant.distances().empty());
}

// The creepage is 0 to 2 and back, so that its mean over [1, 4] is that of its three parts.
TEST(PatchHistory, TakesMeansOfMotionsAndResultantsAtTheEnd) {
  RunRows along = rows(), across = rows(), about = rows();
  along.creepage = VectorXd{{0, 2, 0}};
  across.force = VectorXd{{1, 3, 7}};
  about.creepage = VectorXd{{1, 1, 1}};
  const PatchHistory history({LoadHistory(along), LoadHistory(across), LoadHistory(about)});
  const PatchLoad load = history.between(1, 4);
  EXPECT_FALSE(load[0].by_resultant);
  EXPECT_NEAR(load[0].value, (1.5 + 2) / 3, 1e-15);
  EXPECT_EQ(load[1], (PatchComponent{true, 7}));
  EXPECT_NEAR(load[2].value, 1, 1e-15);
  EXPECT_EQ(history.at(1)[1], (PatchComponent{true, 2}));
  EXPECT_EQ(history.distance(), 4);
}

TEST(PatchHistory, HasTheContactOfItsFirstComponent) {
  RunRows along = rows(), across = rows(), about = rows();
  along.creepage = across.creepage = about.creepage = VectorXd{{0, 0, 0}};
  const PatchHistory constant({LoadHistory(along), LoadHistory(across), LoadHistory(about)});
  EXPECT_FALSE(constant.changes_contact());
  EXPECT_FALSE(constant.changes_size());
  EXPECT_EQ(constant.contact_at(1), ContactScale{});
  along.point_contact = true;
  along.normal_load = VectorXd{{8, 64, 8}};
  along.friction = VectorXd{{0.3, 0.3, 0.6}};
  along.of_problem = {.normal_load = 8, .friction = 0.3};
  const PatchHistory loaded({LoadHistory(along), LoadHistory(across), LoadHistory(about)});
  EXPECT_TRUE(loaded.changes_size());
  EXPECT_NEAR(loaded.contact_at(2).half_width, 2, 1e-15);
  EXPECT_NEAR(loaded.contact_at(2).bound, 2, 1e-15);
  EXPECT_NEAR(loaded.contact_at(1).half_width, std::cbrt(4.5), 1e-15);
  EXPECT_NEAR(loaded.contact_at(4).bound, 2, 1e-15);
  along.normal_load.reset();
  const PatchHistory slippery({LoadHistory(along), LoadHistory(across), LoadHistory(about)});
  EXPECT_TRUE(slippery.changes_contact());
  EXPECT_FALSE(slippery.changes_size());
}

TEST(PatchHistory, NamesTheColumnOfAnError) {
  RunRows across = rows();
  across.force = VectorXd{{1, NAN, 7}};
  across.force_name = "lateral_force";
  EXPECT_EQ(message([&] { LoadHistory{across}; }),
            "row 2: lateral_force = nan: expected a finite number");
}

}  // namespace microslip::patch_history_test
