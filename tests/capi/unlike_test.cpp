// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of different material through C.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "handle.hpp"
#include "microslip/rolling/steady.hpp"

namespace microslip::unlike_test {

microslip_status create(const Parts& parts, const microslip_unlike& unlike, Handle& handle,
                        std::string& why) {
  microslip_rolling* made = nullptr;
  char text[512] = "";
  const microslip_status status =
      microslip_create_unlike(&parts.material, &unlike, &parts.contact, &parts.kernel, &parts.grid,
                              &made, text, sizeof text);
  handle.reset(made);
  why = text;
  return status;
}

Handle created(const Parts& parts, const microslip_unlike& unlike) {
  Handle handle(nullptr, microslip_destroy);
  std::string why;
  EXPECT_EQ(create(parts, unlike, handle, why), MICROSLIP_OK) << why;
  return handle;
}

TEST(UnlikeInC, RollFreelyWithACreepage) {
  const Material material{1, 0.28};
  const HertzBound bound(1, 1);
  const double expected = solve_steady({.contact = {PlaneKernel(material, 200), bound,
                                                    pressure_strain({material, 0.15}, 0.05)},
                                        .grid = Grid({.half_width = 1, .elements = 101}),
                                        .load = PrescribedForce{0}})
                              .creepage;
  for (const int scheme : {MICROSLIP_REMEMBERED, MICROSLIP_DIRECT}) {
    Parts parts;
    parts.grid = {100, scheme};
    const Handle handle = created(parts, {0.15, 0.05});
    ASSERT_EQ(microslip_set_force(handle.get(), 0), MICROSLIP_OK);
    for (int i = 0; i < 400; ++i) ASSERT_EQ(microslip_advance(handle.get(), 0.02), MICROSLIP_OK);
    EXPECT_NEAR(state_of(handle).creepage / expected, 1, 2e-3);
    EXPECT_GT(state_of(handle).dissipation, 0);
  }
}

TEST(UnlikeInC, AreLikeBodiesToTheBitWithoutBeta) {
  const Handle alike = microslip::created();
  const Handle other = created(Parts{}, {0, 0.3});
  roll(alike, 30, 0.05);
  roll(other, 30, 0.05);
  expect_same(answers(alike), answers(other));
}

TEST(UnlikeInC, SayWhatIsWrong) {
  const auto why = [](const Parts& parts, const microslip_unlike& unlike) {
    Handle handle(nullptr, microslip_destroy);
    std::string text;
    EXPECT_EQ(create(parts, unlike, handle, text), MICROSLIP_BAD_INPUT);
    EXPECT_EQ(handle.get(), nullptr);
    return text;
  };
  EXPECT_EQ(why({}, {0.6, 0.1}), "dundurs_beta = 0.6: expected a number in [-0.5, 0.5]");
  EXPECT_EQ(why({}, {std::nan(""), 0.1}), "dundurs_beta = nan: expected a number in [-0.5, 0.5]");
  EXPECT_EQ(why({}, {0.1, 0}), "friction = 0: expected a number above 0, at most 10");
  Parts strip;
  strip.kernel = {MICROSLIP_STRIP, 2};
  EXPECT_EQ(why(strip, {0.1, 0.1}),
            "kernel type = 0: expected 1, plane strain, for bodies of different material");
  const Handle handle = created(Parts{}, {0.1, 0.1});
  EXPECT_EQ(microslip_set_contact(handle.get(), 1, 1), MICROSLIP_OK);
  EXPECT_EQ(microslip_set_contact(handle.get(), 1.1, 1), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(std::string(microslip_message(handle.get())),
            "contact: expected one that stays as it is, as bodies differ in material");
  Parts parts;
  microslip_rolling* made = nullptr;
  EXPECT_EQ(microslip_create_unlike(&parts.material, nullptr, &parts.contact, &parts.kernel,
                                    &parts.grid, &made, nullptr, 0),
            MICROSLIP_BAD_INPUT);
}

}  // namespace microslip::unlike_test
