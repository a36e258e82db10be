// SPDX-License-Identifier: GPL-3.0-or-later
// Contact ellipses through the C interface: against the C++ library, by invariances, and bad input.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "c99.h"
#include "microslip/patch/patch_rolling.hpp"
#include "microslip/patch/steady_patch.hpp"
#include "microslip_ellipse.h"

namespace microslip::ellipse_test {

using Ellipse = std::unique_ptr<microslip_ellipse, void (*)(microslip_ellipse*)>;
using Load = microslip_ellipse_load;
using State = microslip_ellipse_state;

const microslip_material steel{82000, 0.28};

/// The arguments of microslip_ellipse_create(), for an ordinary case.
struct Parts {
  microslip_ellipse_contact contact{6, 4, 300};
  microslip_ellipse_grid grid{6, 8};
};

microslip_status create(const Parts& parts, Ellipse& ellipse, std::string& message) {
  microslip_ellipse* made = nullptr;
  char text[512] = "";
  const microslip_status status =
      microslip_ellipse_create(&steel, &parts.contact, &parts.grid, &made, text, sizeof text);
  ellipse.reset(made);
  message = text;
  return status;
}

Ellipse created(const Parts& parts = {}) {
  Ellipse ellipse(nullptr, microslip_ellipse_destroy);
  std::string message;
  EXPECT_EQ(create(parts, ellipse, message), MICROSLIP_OK) << message;
  return ellipse;
}

Ellipse copy_of(const Ellipse& ellipse) {
  microslip_ellipse* made = nullptr;
  EXPECT_EQ(microslip_ellipse_copy(ellipse.get(), &made), MICROSLIP_OK);
  return {made, microslip_ellipse_destroy};
}

Load motion(double xi, double eta, double phi) { return {{0, 0, 0}, {xi, eta, phi}}; }

State advanced(const Ellipse& ellipse, double dq, const Load& load) {
  State state{};
  EXPECT_EQ(microslip_ellipse_advance(ellipse.get(), dq, &load, &state), MICROSLIP_OK)
      << microslip_ellipse_message(ellipse.get());
  return state;
}

State steady(const Ellipse& ellipse, const Load& load, double* jacobian = nullptr) {
  State state{};
  EXPECT_EQ(microslip_ellipse_solve_steady(ellipse.get(), &load, &state, jacobian), MICROSLIP_OK)
      << microslip_ellipse_message(ellipse.get());
  return state;
}

void expect_same(const State& one, const State& other) {
  for (int j = 0; j < 3; ++j) {
    EXPECT_EQ(one.resultants[j], other.resultants[j]) << j;
    EXPECT_EQ(one.motion[j], other.motion[j]) << j;
  }
  EXPECT_EQ(one.distance, other.distance);
  EXPECT_EQ(one.dissipation, other.dissipation);
  EXPECT_EQ(one.slip_share, other.slip_share);
}

SteadyPatch patch_of(const Parts& parts) {
  const auto& [a, b, peak] = parts.contact;
  return {.material = {steel.shear_modulus, steel.poisson_ratio},
          .bound = EllipticBound(a, b, peak),
          .rows = parts.grid.rows,
          .elements = parts.grid.elements};
}

Load generated(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  return motion(3e-3 * any(random), 3e-3 * any(random), 3e-4 * any(random));
}

TEST(CEllipse, HasTheAnswersOfTheLibrary) {
  std::mt19937 random(1);
  const Parts parts;
  const Ellipse ellipse = created(parts);
  PatchRolling rolling(patch_of(parts));
  for (int i = 0; i < 8; ++i) {
    const Load load = generated(random);
    PatchLoad same;
    for (std::size_t j = 0; j < 3; ++j) same[j].value = load.value[j];
    const State state = advanced(ellipse, 0.4 + 0.3 * (i % 2), load);
    rolling.roll(0.4 + 0.3 * (i % 2), same);
    SteadyPatch patch = patch_of(parts);
    patch.load = same;
    const SteadyPatchSolution alone = solve_steady(patch);
    const State in_c = steady(ellipse, load);
    for (int j = 0; j < 3; ++j) {
      EXPECT_EQ(state.resultants[j], rolling.resultants()[j]);
      EXPECT_NEAR(in_c.resultants[j], alone.resultants[j],
                  1e-6 * in_c.full_sliding * (j < 2 ? 1 : 5));
    }
    EXPECT_EQ(state.dissipation, rolling.dissipation());
    EXPECT_NEAR(in_c.dissipation, alone.dissipation, 1e-8 * in_c.full_sliding);
    EXPECT_NEAR(state.full_sliding, patch.bound.total(), 1e-9 * state.full_sliding);
  }
  const std::size_t n = microslip_ellipse_size(ellipse.get());
  ASSERT_EQ(n, 48U);
  std::vector<double> x(n), area(n), p(n), q(n), bound(n), slip(n);
  std::vector<int> slips(n);
  const microslip_ellipse_cells cells{.x = x.data(),
                                      .y = nullptr,
                                      .area = area.data(),
                                      .bound = bound.data(),
                                      .traction_x = p.data(),
                                      .traction_y = q.data(),
                                      .slip_x = slip.data(),
                                      .slip_y = nullptr,
                                      .slips = slips.data()};
  ASSERT_EQ(microslip_ellipse_get_cells(ellipse.get(), &cells), MICROSLIP_OK);
  double all = 0;
  for (std::size_t i = 0; i < n; ++i) {
    all += area[i];
    EXPECT_LE(std::hypot(p[i], q[i]), bound[i] * (1 + 1e-6));
    EXPECT_TRUE(slips[i] == 1 || slip[i] == 0);
  }
  EXPECT_NEAR(all, 24 * 3.14159265, 1e-5);
  EXPECT_GT(x.front(), 0);
}

// The equations of steps and of steady rolling are different ones: they have the same limit as rows
// and elements become many.
TEST(CEllipse, HoldsResultantsAndTendsToSteadyRolling) {
  const Load load{{MICROSLIP_RESULTANT, MICROSLIP_MOTION, MICROSLIP_RESULTANT}, {-6000, 5e-4, 500}};
  const auto expect = [&](int rows, int elements, double error) {
    const Ellipse ellipse = created({{6, 4, 300}, {rows, elements}});
    State state{};
    for (int i = 0; i < 120; ++i) state = advanced(ellipse, 0.5, load);
    const State at_last = steady(ellipse, load);
    EXPECT_NEAR(state.resultants[0], -6000, 1e-5);
    EXPECT_NEAR(state.resultants[2], 500, 1e-4);
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(state.motion[j] / at_last.motion[j], 1, error) << rows;
    EXPECT_NEAR(4.9 * state.motion[2], 4.9 * at_last.motion[2], error * at_last.motion[0]) << rows;
    EXPECT_NEAR(state.dissipation / at_last.dissipation, 1, 10 * error) << rows;
    EXPECT_EQ(at_last.distance, 0);
  };
  expect(6, 8, 1e-2);
  expect(12, 16, 3e-3);
}

TEST(CEllipse, HasDerivativesOfSteadyRollingAndOfSteps) {
  const Ellipse ellipse = created();
  advanced(ellipse, 2, motion(5e-4, 2e-4, 5e-5));
  const Load load = motion(9e-4, -4e-4, 1e-4);
  const std::array<double, 3> steps{1e-8, 1e-8, 1e-9};
  const auto expect = [&](const std::function<State(const Load&, double*)>& solve) {
    double jacobian[9];
    const State at = solve(load, jacobian);
    for (std::size_t j = 0; j < 3; ++j) {
      Load more = load;
      more.value[j] += steps[j];
      const State beside = solve(more, nullptr);
      for (std::size_t i = 0; i < 3; ++i) {
        const double slope = (beside.resultants[i] - at.resultants[i]) / steps[j];
        const double scale = at.full_sliding / 1e-3 * (i == 2 ? 5 : 1) * (j == 2 ? 5 : 1);
        EXPECT_NEAR(jacobian[3 * i + j], slope, 1e-3 * scale) << i << j;
      }
    }
  };
  expect([&](const Load& of, double* jacobian) { return steady(ellipse, of, jacobian); });
  expect([&](const Load& of, double* jacobian) {
    State state{};
    EXPECT_EQ(microslip_ellipse_attempt(ellipse.get(), 1, &of, &state, jacobian), MICROSLIP_OK);
    return state;
  });
}

TEST(CEllipse, AttemptsAreMadeWithTheSameBits) {
  std::mt19937 random(2);
  const Ellipse ellipse = created(), other = created();
  for (int i = 0; i < 10; ++i) {
    const Load load = generated(random), rejected = generated(random);
    State before{}, tried{}, after{};
    microslip_ellipse_get_state(ellipse.get(), &before);
    EXPECT_EQ(microslip_ellipse_attempt(ellipse.get(), 0.7, &rejected, &tried, nullptr),
              MICROSLIP_OK);
    microslip_ellipse_get_state(ellipse.get(), &after);
    expect_same(before, after);
    EXPECT_EQ(microslip_ellipse_attempt(ellipse.get(), 0.5, &load, &tried, nullptr), MICROSLIP_OK);
    const State made = advanced(ellipse, 0.5, load);
    expect_same(made, tried);
    expect_same(made, advanced(other, 0.5, load));
  }
}

TEST(CEllipse, CopiesSavedStatesAndMemoryGoOnWithTheSameBits) {
  std::mt19937 random(3);
  const Ellipse ellipse = created();
  ASSERT_EQ(microslip_ellipse_set_contact(ellipse.get(), 1.1, 1.05), MICROSLIP_OK);
  for (int i = 0; i < 3; ++i) advanced(ellipse, 0.6, generated(random));
  const Ellipse copy = copy_of(ellipse), assigned = created(), restored = created(),
                from_memory = created();
  EXPECT_EQ(microslip_ellipse_assign(assigned.get(), ellipse.get()), MICROSLIP_OK);
  const std::string path =
      (std::filesystem::temp_directory_path() / ("microslip_ellipse_" + std::to_string(::getpid())))
          .string();
  ASSERT_EQ(microslip_ellipse_save(ellipse.get(), path.c_str()), MICROSLIP_OK);
  EXPECT_EQ(microslip_ellipse_restore(restored.get(), path.c_str()), MICROSLIP_OK)
      << microslip_ellipse_message(restored.get());
  std::filesystem::remove(path);
  std::size_t needed = 0;
  ASSERT_EQ(microslip_ellipse_save_to_memory(ellipse.get(), nullptr, 0, &needed), MICROSLIP_OK);
  std::vector<char> text(needed);
  EXPECT_EQ(microslip_ellipse_save_to_memory(ellipse.get(), text.data(), needed - 1, nullptr),
            MICROSLIP_BAD_INPUT);
  ASSERT_EQ(microslip_ellipse_save_to_memory(ellipse.get(), text.data(), needed, nullptr),
            MICROSLIP_OK);
  EXPECT_EQ(microslip_ellipse_restore_from_memory(from_memory.get(), text.data()), MICROSLIP_OK);
  for (int i = 0; i < 3; ++i) {
    const Load load = generated(random);
    const State expected = advanced(ellipse, 0.6, load);
    for (const Ellipse* one : {&copy, &assigned, &restored, &from_memory}) {
      expect_same(advanced(*one, 0.6, load), expected);
    }
  }
}

TEST(CEllipse, ContactThatGrowsIsThatOfALargerEllipse) {
  const Load load = motion(6e-4, 3e-4, 5e-5);
  const double factor = std::cbrt(2.0);
  const Ellipse grown = created();
  ASSERT_EQ(microslip_ellipse_set_contact(grown.get(), factor, factor), MICROSLIP_OK);
  Parts larger;
  larger.contact = {6 * factor, 4 * factor, 300 * factor};
  const State one = steady(grown, load), other = steady(created(larger), load);
  for (int j = 0; j < 3; ++j) EXPECT_NEAR(one.resultants[j] / other.resultants[j], 1, 1e-9);
  EXPECT_NEAR(one.full_sliding / other.full_sliding, 1, 1e-12);
}

TEST(CEllipse, WarnsOfCreepagesInPercentAndOfSpinInMetres) {
  const Ellipse ellipse = created();
  const auto warning = [&] { return std::string(microslip_ellipse_warning(ellipse.get())); };
  EXPECT_STREQ(microslip_ellipse_warning(nullptr), "");
  steady(ellipse, motion(0.199, -0.1, 1e-3));
  EXPECT_EQ(warning(), "");
  steady(ellipse, motion(0.1, -0.5, 0));
  EXPECT_EQ(warning().find("lateral_creepage = -0.5: creepages above 0.2 are not small"), 0U)
      << warning();
  advanced(ellipse, 1, motion(0, 0, 0.2));
  EXPECT_EQ(warning().find("spin = 0.2: the slip by this spin"), 0U) << warning();
  const Load forces{{1, 1, 0}, {1, 1, 0}};  // they are no motions
  steady(ellipse, forces);
  EXPECT_EQ(warning(), "");
  const Load wrong{{0, 0, 7}, {5, 0, 0}};
  State state{};
  EXPECT_EQ(microslip_ellipse_attempt(ellipse.get(), 1, &wrong, &state, nullptr),
            MICROSLIP_BAD_INPUT);
  EXPECT_EQ(warning(), "");
}

TEST(CEllipse, WarnsOfModuliInOtherUnitsUntilAMotionIsDoubtful) {
  const Parts parts;
  const auto of_modulus = [&](double modulus) {
    const microslip_material material{modulus, 0.28};
    microslip_ellipse* made = nullptr;
    EXPECT_EQ(microslip_ellipse_create(&material, &parts.contact, &parts.grid, &made, nullptr, 0),
              MICROSLIP_OK);
    return Ellipse(made, microslip_ellipse_destroy);
  };
  const auto warning = [](const Ellipse& of) {
    return std::string(microslip_ellipse_warning(of.get()));
  };
  const std::string units = "; numbers are in N, mm and N/mm^2";
  EXPECT_EQ(warning(of_modulus(82000)), "");
  EXPECT_EQ(warning(of_modulus(1)), "");
  const std::string strain =
      "the largest traction, 300 N/mm^2, is 3.7 of the shear modulus, 82 N/mm^2, and strains have "
      "to be small";
  EXPECT_EQ(warning(of_modulus(82)), strain + units);
  const std::string modulus =
      "a shear modulus of 8.2e+10 N/mm^2, which is more than that of any solid" + units;
  const Ellipse pascal = of_modulus(8.2e10);
  EXPECT_EQ(warning(pascal), modulus);
  advanced(pascal, 1, motion(1e-9, 0, 0));
  EXPECT_EQ(warning(pascal), modulus);
  advanced(pascal, 1, motion(0.3, 0, 0));
  EXPECT_EQ(warning(pascal).find("creepage = 0.3: "), 0U);
  microslip_ellipse* copy = nullptr;
  ASSERT_EQ(microslip_ellipse_copy(pascal.get(), &copy), MICROSLIP_OK);
  const Ellipse copied(copy, microslip_ellipse_destroy);
  advanced(copied, 1, motion(1e-9, 0, 0));
  EXPECT_EQ(warning(copied), modulus);
}

TEST(CEllipse, LosesItsContactAndTouchesAnew) {
  const Ellipse ellipse = created(), fresh = created();
  const Load load = motion(6e-4, 3e-4, 5e-5);
  advanced(ellipse, 2, load);
  ASSERT_EQ(microslip_ellipse_set_contact(ellipse.get(), 0, 0), MICROSLIP_OK);
  const State lost = advanced(ellipse, 2, load);
  for (const double resultant : lost.resultants) EXPECT_EQ(resultant, 0);
  EXPECT_EQ(lost.full_sliding, 0);
  EXPECT_EQ(lost.slip_share, 0);
  State state{};
  EXPECT_EQ(microslip_ellipse_solve_steady(ellipse.get(), &load, &state, nullptr),
            MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_ellipse_message(ellipse.get()),
               "size_factor = 0: expected a number > 0 for steady rolling");
  const Load held{{1, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(microslip_ellipse_advance(ellipse.get(), 1, &held, &state), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_ellipse_message(ellipse.get()),
               "force = 1: expected 0 where bodies do not touch, or have no friction");
  ASSERT_EQ(microslip_ellipse_set_contact(ellipse.get(), 1, 1), MICROSLIP_OK);
  const Load still = motion(0, 0, 0);
  ASSERT_EQ(microslip_ellipse_shift(ellipse.get(), &still, nullptr), MICROSLIP_OK);
  const State one = advanced(ellipse, 3, load), other = advanced(fresh, 3, load);
  for (int j = 0; j < 3; ++j) {
    EXPECT_NEAR(one.resultants[j], other.resultants[j], 1e-9 * other.full_sliding);
  }
  EXPECT_NEAR(one.distance, 7, 1e-12);
}

TEST(CEllipse, ManyRollAsOneByOne) {
  constexpr std::size_t count = 7;
  std::mt19937 random(4);
  std::vector<Ellipse> many, alone;
  std::vector<microslip_ellipse*> handles;
  for (std::size_t i = 0; i < count; ++i) {
    Parts parts;
    parts.contact.half_width = 4 + static_cast<double>(i);
    many.push_back(created(parts));
    alone.push_back(created(parts));
    handles.push_back(many.back().get());
  }
  for (int step = 0; step < 4; ++step) {
    std::vector<double> dq;
    std::vector<Load> loads;
    for (std::size_t i = 0; i < count; ++i) {
      dq.push_back(0.4 + 0.1 * static_cast<double>(i));
      loads.push_back(generated(random));
    }
    std::vector<State> states(count);
    EXPECT_EQ(microslip_ellipse_advance_all(handles.data(), count, dq.data(), loads.data(),
                                            states.data(), 3),
              MICROSLIP_OK);
    for (std::size_t i = 0; i < count; ++i) {
      expect_same(states[i], advanced(alone[i], dq[i], loads[i]));
    }
  }
  const std::vector<double> dq{0.4, 1e-30, 0.4};
  const std::vector<Load> loads(3, motion(1e-4, 0, 0));
  EXPECT_EQ(microslip_ellipse_advance_all(handles.data(), 3, dq.data(), loads.data(), nullptr, 2),
            MICROSLIP_BAD_INPUT);
  EXPECT_EQ(std::string(microslip_ellipse_message(handles[1])).find("dq = 1e-30: expected"), 0U);
  EXPECT_EQ(microslip_ellipse_advance_all(handles.data(), 3, dq.data(), loads.data(), nullptr, 0),
            MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_ellipse_message(handles[0]), "threads = 0: expected 1 ... 1000");
  const std::vector<microslip_ellipse*> twice{handles[0], handles[0]};
  EXPECT_EQ(microslip_ellipse_advance_all(twice.data(), 2, dq.data(), loads.data(), nullptr, 2),
            MICROSLIP_BAD_INPUT);
}

TEST(CEllipse, OfTwoBodiesIsThatOfHertz) {
  // A sphere on a plane: a^3 = 3 P R (1 - nu)/(4 G), p0 = 3 P/(2 pi a^2).
  const microslip_bodies sphere{1000, 50, 0, 50, 0, 0.3};
  microslip_ellipse_contact contact{};
  ASSERT_EQ(microslip_hertz_ellipse(&steel, &sphere, &contact, nullptr, 0), MICROSLIP_OK);
  const double a = std::cbrt(3 * 1000 * 50 * 0.72 / (4 * 82000));
  EXPECT_NEAR(contact.half_width / a, 1, 1e-12);
  EXPECT_NEAR(contact.lateral_half_width / a, 1, 1e-12);
  EXPECT_NEAR(contact.peak_traction / (0.3 * 1.5 * 1000 / (3.14159265358979 * a * a)), 1, 1e-12);
  const auto expect_refused = [&](const microslip_bodies& bodies, const std::string& error) {
    char text[512] = "";
    EXPECT_EQ(microslip_hertz_ellipse(&steel, &bodies, &contact, text, sizeof text),
              MICROSLIP_BAD_INPUT);
    EXPECT_EQ(std::string(text).find(error), 0U) << text;
  };
  expect_refused({0, 50, 0, 50, 0, 0.3}, "normal_load = 0: expected");
  expect_refused({1000, 50, -40, 50, 0, 0.3},
                 "radius_2 = -40: expected a number > 0, or for a concave body one below -50, as "
                 "its radius is larger than radius_1");
  expect_refused({1000, -46, 0, 50, 0, 0.3},
                 "radius_1 = -46: expected a number > 0, as the other body is flat, by radius_2");
  expect_refused({1000, 50, 0, -40, -50, 0.3},
                 "lateral_radius_1 = -40: expected a number > 0, as the other body is concave, by "
                 "lateral_radius_2");
  expect_refused({1000, 50, 0, 0, 0, 0.3},
                 "lateral_radius_1 = 0: expected a number > 0, as the other body is flat");
  expect_refused({1000, 1e60, 0, 50, 0, 0.3}, "radius_1 = 1e+60: expected a number from 1e-50");
  expect_refused({1000, 50, 0, 50, 0, 0}, "friction = 0: expected");
}

// a/b is 10, but for rounding.
TEST(CEllipse, MayBeOfTheLongestRatioButForRounding) {
  const double root = std::sqrt(10.0);
  Ellipse ellipse(nullptr, microslip_ellipse_destroy);
  std::string message;
  EXPECT_EQ(create({{5 * root, 5 / root, 300}, {6, 8}}, ellipse, message), MICROSLIP_OK) << message;
  EXPECT_EQ(create({{5.00001 * root, 5 / root, 300}, {6, 8}}, ellipse, message),
            MICROSLIP_BAD_INPUT);
}

TEST(CEllipse, RefusesBadInput) {
  const auto expect_not_made = [](const Parts& parts, const std::string& error) {
    Ellipse ellipse(nullptr, microslip_ellipse_destroy);
    std::string message;
    EXPECT_EQ(create(parts, ellipse, message), MICROSLIP_BAD_INPUT) << error;
    EXPECT_EQ(message.find(error), 0U) << message;
    EXPECT_EQ(ellipse.get(), nullptr);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_not_made({{-6, 4, 300}, {6, 8}}, "half_width = -6: expected");
  expect_not_made({{6, nan, 300}, {6, 8}}, "lateral_half_width = nan: expected");
  expect_not_made({{6, 0.5, 300}, {6, 8}}, "lateral_half_width = 0.5: expected a number between");
  expect_not_made({{6, 4, 0}, {6, 8}}, "peak_traction = 0: expected");
  expect_not_made({{6, 4, 300}, {0, 8}}, "rows = 0: expected a whole number 1 ... 100");
  expect_not_made({{6, 4, 300}, {101, 8}}, "rows = 101: expected");
  expect_not_made({{6, 4, 300}, {6, 1}}, "elements = 1: expected a whole number 2 ... 100");
  const Ellipse ellipse = created();
  const auto expect_refused = [&](double dq, const Load& load, const std::string& error) {
    State state{};
    EXPECT_EQ(microslip_ellipse_advance(ellipse.get(), dq, &load, &state), MICROSLIP_BAD_INPUT);
    EXPECT_EQ(std::string(microslip_ellipse_message(ellipse.get())).find(error), 0U)
        << microslip_ellipse_message(ellipse.get());
    EXPECT_EQ(microslip_ellipse_get_state(ellipse.get(), &state), MICROSLIP_OK);
    EXPECT_EQ(state.distance, 0);
  };
  expect_refused(0, motion(1e-3, 0, 0), "dq = 0: expected a length");
  expect_refused(nan, motion(1e-3, 0, 0), "dq = nan: expected a length");
  expect_refused(1, motion(nan, 0, 0), "creepage = nan: expected a finite number");
  expect_refused(1, {{1, 0, 0}, {1e9, 0, 0}}, "force = 1e+09: expected less than full sliding");
  expect_refused(1, {{0, 0, 2}, {0, 0, 0}}, "prescribed[2] = 2: expected MICROSLIP_MOTION or");
  EXPECT_EQ(microslip_ellipse_advance(ellipse.get(), 1, nullptr, nullptr), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_ellipse_message(ellipse.get()), "load = null: expected a pointer");
  State state{};
  const Load huge = motion(0, -1e308, 0), large = motion(0, -1e90, 0);
  EXPECT_EQ(microslip_ellipse_solve_steady(ellipse.get(), &huge, &state, nullptr),
            MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_ellipse_message(ellipse.get()),
               "lateral_creepage = -1e+308: expected a motion of at most 1e100 times that by the "
               "bound's strain");
  EXPECT_EQ(microslip_ellipse_solve_steady(ellipse.get(), &large, &state, nullptr), MICROSLIP_OK);
  EXPECT_NEAR(state.resultants[1], state.full_sliding, 1e-9 * state.full_sliding);
  EXPECT_EQ(microslip_ellipse_set_contact(ellipse.get(), 1e-5, 1), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_ellipse_message(ellipse.get()),
               "size_factor = 1e-05: expected a number from 1e-04 to 100, or 0");
  EXPECT_EQ(microslip_ellipse_restore_from_memory(ellipse.get(), "no state"), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_ellipse_restore(ellipse.get(), "/nowhere/state"), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_ellipse_assign(ellipse.get(), nullptr), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_ellipse_advance(nullptr, 1, nullptr, nullptr), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_ellipse_size(nullptr), 0U);
  EXPECT_STREQ(microslip_ellipse_message(nullptr), "ellipse = null: expected a handle");
  microslip_ellipse_destroy(nullptr);
}

TEST(CEllipse, IsOfUseInC99) {
  const Ellipse ellipse = created({{6, 4, 300}, {0, 0}});
  EXPECT_EQ(microslip_ellipse_size(ellipse.get()), 14U * 19);
  EXPECT_EQ(lateral_force_of_spin_in_c99(1e-4), steady(ellipse, motion(0, 0, 1e-4)).resultants[1]);
}

}  // namespace microslip::ellipse_test
