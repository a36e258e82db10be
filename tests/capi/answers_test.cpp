// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface answers as TransientRolling does, to the bit.
#include <gtest/gtest.h>

#include <cstdio>
#include <thread>

#include "c99.h"
#include "handle.hpp"
#include "microslip/reference/fretting_cycle.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::answers_test {

constexpr Material material{1, 0.28};

struct Case {
  std::string name;
  Parts parts;
  TransientProblem problem;
  Load load;
};

const double table_x[] = {-0.5, 0, 0.8};
const double table_value[] = {0.5, 1.5, 0.2};

Case make_case(const std::string& name, const microslip_contact& contact, TractionBound bound,
               const microslip_kernel& kernel_parts, Kernel kernel, const microslip_grid& grid,
               Load load) {
  AdvectionScheme scheme = Remembered{};
  if (grid.scheme == MICROSLIP_DIRECT) scheme = Direct{};
  return {.name = name,
          .parts = {.contact = contact, .kernel = kernel_parts, .grid = grid},
          .problem = {.contact = {kernel, bound},
                      .grid = Grid({.half_width = 1, .elements = grid.elements}),
                      .basis = constant_basis(),
                      .scheme = scheme},
          .load = load};
}

std::vector<Case> cases() {
  const microslip_contact hertz{1, 2, nullptr, nullptr, 0};
  const microslip_contact table{1, 0, table_x, table_value, 3};
  const Eigen::VectorXd x = Eigen::Map<const Eigen::Vector3d>(table_x);
  const Eigen::VectorXd values = Eigen::Map<const Eigen::Vector3d>(table_value);
  const microslip_kernel plane{MICROSLIP_PLANE, 200}, strip{MICROSLIP_STRIP, 3};
  return {
      make_case("creepage", hertz, HertzBound(1, 2), plane, PlaneKernel(material, 200),
                {41, MICROSLIP_REMEMBERED}, PrescribedCreepage{-5}),
      make_case("fft", hertz, HertzBound(1, 2), strip, StripKernel(material, 3),
                {150, MICROSLIP_REMEMBERED}, PrescribedForce{1.5}),
      make_case("table", table, TabulatedBound(1, x, values), strip, StripKernel(material, 3),
                {60, MICROSLIP_REMEMBERED}, PrescribedForce{-1}),
      make_case("direct", hertz, HertzBound(1, 2), strip, StripKernel(material, 3),
                {40, MICROSLIP_DIRECT}, PrescribedCreepage{0.4}),
      make_case("lateral", hertz, HertzBound(1, 2), {MICROSLIP_STRIP_LATERAL, 3},
                StripKernel(lateral(material), 3), {41, MICROSLIP_REMEMBERED}, PrescribedForce{1}),
      make_case("plane", table, TabulatedBound(1, x, values), plane, PlaneKernel(material, 200),
                {50, MICROSLIP_REMEMBERED}, PrescribedForce{-1})};
}

class EveryCase : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Contacts, EveryCase, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

void set_load(const Handle& handle, const Load& load) {
  const auto* force = std::get_if<PrescribedForce>(&load);
  const microslip_status status =
      force != nullptr ? microslip_set_force(handle.get(), force->value)
                       : microslip_set_creepage(handle.get(), std::get<0>(load).value);
  ASSERT_EQ(status, MICROSLIP_OK) << microslip_message(handle.get());
}

std::vector<double> library_numbers(const TransientState& s) {
  return {s.distance,
          s.force,
          s.mean_force,
          s.creepage,
          s.dissipation,
          s.evidence.residual,
          s.evidence.violation(),
          static_cast<double>(s.adhesion_elements),
          static_cast<double>(s.slip_elements),
          static_cast<double>(s.iterations)};
}

std::vector<double> library_answers(const TransientRolling& rolling) {
  std::vector<double> all = library_numbers(rolling.state());
  all.push_back(rolling.elastic_energy());
  for (const Eigen::VectorXd& values :
       {Eigen::VectorXd(rolling.x()), rolling.traction_at_nodes(), rolling.bound_at_nodes(),
        rolling.state().slip, rolling.displacement()}) {
    all.insert(all.end(), values.begin(), values.end());
  }
  for (const Zone zone : rolling.state().zones) all.push_back(static_cast<double>(zone));
  return all;
}

TEST_P(EveryCase, IsThatOfTheLibraryToTheBit) {
  const Case& c = GetParam();
  const Handle handle = created(c.parts);
  TransientRolling rolling(c.problem);
  expect_same(answers(handle), library_answers(rolling));
  double shift = 0;
  const double force = -0.3;
  ASSERT_EQ(microslip_start_from_shift(handle.get(), force, &shift), MICROSLIP_OK);
  EXPECT_EQ(shift, rolling.start_from_shift({force}));
  set_load(handle, c.load);
  for (const double ratio : {1.0, 0.3, 1e-3, 1e-9, 2.7, 0.01, 0.5, 1.0, 1.0}) {
    const double dq = ratio * c.problem.grid.spacing();
    microslip_state tried{};
    ASSERT_EQ(microslip_attempt(handle.get(), dq, &tried), MICROSLIP_OK);
    expect_same(numbers(tried), library_numbers(rolling.attempt(dq, c.load)));
    ASSERT_EQ(microslip_advance(handle.get(), dq), MICROSLIP_OK);
    rolling.step(dq, c.load);
    expect_same(answers(handle), library_answers(rolling));
  }
  EXPECT_GT(state_of(handle).slip_elements, 0);
}

// A step that was tried is part of it; the load is not.
TEST(CAnswers, GoOnFromAFileToTheBit) {
  const std::string file = testing::TempDir() + "microslip_answers.state";
  const Parts parts{.grid = {50, MICROSLIP_REMEMBERED}};
  const Handle handle = created(parts), other = created(parts);
  roll(handle, 37, 0.04);
  microslip_state tried{};
  ASSERT_EQ(microslip_attempt(handle.get(), 0.013, &tried), MICROSLIP_OK);
  ASSERT_EQ(microslip_save(handle.get(), file.c_str()), MICROSLIP_OK);
  ASSERT_EQ(microslip_restore(other.get(), file.c_str()), MICROSLIP_OK)
      << microslip_message(other.get());
  expect_same(answers(other), answers(handle));
  EXPECT_EQ(microslip_advance(other.get(), 0.013), MICROSLIP_BAD_INPUT);
  ASSERT_EQ(microslip_set_creepage(other.get(), std::sin(0.3 * 36)), MICROSLIP_OK);
  for (const Handle* of : {&handle, &other}) {
    ASSERT_EQ(microslip_advance(of->get(), 0.013), MICROSLIP_OK);
    roll(*of, 50, 0.04);
  }
  expect_same(answers(other), answers(handle));
  std::remove(file.c_str());
}

std::vector<double> numbers_of_shift(const microslip_shift& s) {
  return {s.distance, s.force, s.dissipation, s.work};
}

// At standstill, between two ways of rolling, and after them.
TEST_P(EveryCase, IsShiftedLikeTheLibraryToTheBit) {
  const Case& c = GetParam();
  const Handle handle = created(c.parts);
  TransientRolling rolling(c.problem);
  set_load(handle, c.load);
  const auto expect_shift = [&](const ShiftLoad& load) {
    const auto* by = std::get_if<PrescribedShift>(&load);
    microslip_shift shift{};
    ASSERT_EQ(by != nullptr
                  ? microslip_shift_by_distance(handle.get(), by->value, &shift)
                  : microslip_shift_to_force(handle.get(), std::get<1>(load).value, &shift),
              MICROSLIP_OK)
        << microslip_message(handle.get());
    const Shift expected = rolling.shift(load);
    expect_same(numbers_of_shift(shift),
                {expected.distance, rolling.state().force, expected.dissipation, expected.work});
    expect_same(answers(handle), library_answers(rolling));
  };
  for (const double ratio : {0.3, 2.7, 0.01}) {
    expect_shift(PrescribedForce{0.7});
    expect_shift(PrescribedShift{0.5 * ratio});
    expect_shift(PrescribedForce{-0.4});
    const double dq = ratio * c.problem.grid.spacing();
    ASSERT_EQ(microslip_advance(handle.get(), dq), MICROSLIP_OK);
    rolling.step(dq, c.load);
    expect_same(answers(handle), library_answers(rolling));
  }
  ASSERT_EQ(microslip_shift_to_force(handle.get(), 0.2, nullptr), MICROSLIP_OK);
  rolling.shift(PrescribedForce{0.2});
  expect_same(answers(handle), library_answers(rolling));
}

TEST_P(EveryCase, RollOnContactsThatChange) {
  const Case& c = GetParam();
  const Handle handle = created(c.parts);
  const bool changes = c.parts.grid.scheme == MICROSLIP_REMEMBERED;
  EXPECT_EQ(microslip_set_contact(handle.get(), 1.2, 0.9),
            changes ? MICROSLIP_OK : MICROSLIP_BAD_INPUT);
  if (!changes) return;
  TransientRolling rolling(c.problem);
  ASSERT_EQ(microslip_set_creepage(handle.get(), 0.2), MICROSLIP_OK);
  for (const double size : {1.2, 0.7, 0.9, 0.0, 0.0, 1.1, 1.0}) {
    ASSERT_EQ(microslip_set_contact(handle.get(), size, size), MICROSLIP_OK);
    ASSERT_EQ(microslip_advance(handle.get(), 0.05), MICROSLIP_OK)
        << microslip_message(handle.get());
    rolling.set_contact({size, size});
    rolling.step(0.05, PrescribedCreepage{0.2});
    expect_same(answers(handle), library_answers(rolling));
  }
  ASSERT_EQ(microslip_set_contact(handle.get(), 0, 0), MICROSLIP_OK);
  ASSERT_EQ(microslip_set_force(handle.get(), 0.1), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_message(handle.get()),
               "force = 0.1: expected 0 where bodies do not touch");
  EXPECT_EQ(microslip_set_contact(handle.get(), -1, 1), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_message(handle.get()), "half_width_factor = -1: expected a number >= 0");
}

TEST_P(EveryCase, ACopyGoesOnAlikeAndByItself) {
  const Case& c = GetParam();
  const double spacing = c.problem.grid.spacing();
  const Handle handle = created(c.parts);
  roll(handle, 30, spacing);
  microslip_rolling* other = nullptr;
  ASSERT_EQ(microslip_copy(handle.get(), &other), MICROSLIP_OK);
  const Handle copy(other, microslip_destroy);
  const std::vector<double> before = answers(handle);
  expect_same(answers(copy), before);
  roll(copy, 30, spacing);
  expect_same(answers(handle), before);
  roll(handle, 30, spacing);
  expect_same(answers(copy), answers(handle));
  EXPECT_NE(answers(copy), before);
}

std::vector<double> numbers_of(const auto& jacobian) {
  std::vector<double> all;
  for (const auto& slopes : {jacobian.by_load, jacobian.by_length}) {
    all.insert(all.end(), {slopes.force, slopes.mean_force, slopes.creepage, slopes.dissipation});
  }
  return all;
}

TEST(CInterface, HasTheJacobianOfTheLibrary) {
  const Case c = cases().back();
  const Handle handle = created(c.parts);
  TransientRolling rolling(c.problem);
  for (const Load& load : {Load(PrescribedForce{-1}), Load(PrescribedCreepage{0.3})}) {
    set_load(handle, load);
    for (const double dq : {0.03, 0.1}) {
      microslip_state state{};
      microslip_jacobian jacobian{};
      ASSERT_EQ(microslip_attempt_with_jacobian(handle.get(), dq, &state, &jacobian), MICROSLIP_OK);
      StepJacobian expected;
      expect_same(numbers(state), library_numbers(rolling.attempt(dq, load, expected)));
      expect_same(numbers_of(jacobian), numbers_of(expected));
      ASSERT_EQ(microslip_advance(handle.get(), dq), MICROSLIP_OK);
      rolling.step(dq, load);
    }
  }
}

// dissipation dq + mean_force w dq + the change of elastic energy, over some of the terms.
TEST(CInterface, BalancesEnergy) {
  const Handle handle = created();
  double before = 0, sum = 0, dissipated = 0;
  for (int k = 0; k < 100; ++k) {
    const double dq = 0.05 * std::exp(2 * std::sin(1.7 * k) - 2), creepage = 20 * std::sin(0.1 * k);
    ASSERT_EQ(microslip_set_creepage(handle.get(), creepage), MICROSLIP_OK);
    ASSERT_EQ(microslip_advance(handle.get(), dq), MICROSLIP_OK);
    const microslip_state state = state_of(handle);
    double elastic = 0;
    microslip_get_elastic_energy(handle.get(), &elastic);
    sum += (state.dissipation + state.mean_force * creepage) * dq + elastic - before;
    dissipated += state.dissipation * dq;
    before = elastic;
  }
  EXPECT_GT(dissipated, 0.1);
  EXPECT_NEAR(sum / dissipated, 0, 1e-13);
}

// Mindlin's, in closed form: the way back, and what a cycle loses.
TEST(CInterface, FretsLikeMindlinFromC99) {
  constexpr int points = 8;
  const HertzBound bound(1, 1);
  for (const int scheme : {MICROSLIP_REMEMBERED, MICROSLIP_DIRECT}) {
    // Orders 2 and 3/2; on the grid of the contact edges are not where they are felt.
    const double accuracy = scheme == MICROSLIP_DIRECT ? 1e-4 : 1e-5;
    for (const double tau : {0.3, 0.6, 0.9}) {
      SCOPED_TRACE(std::to_string(scheme) + ' ' + std::to_string(tau));
      const double force = tau * bound.total();
      const FrettingCycle exact(material, bound, force);
      std::vector<double> shift(points + 1);
      const double loss = loss_of_a_cycle_in_c99(scheme, 400, force, points, shift.data());
      for (int i = 0; i <= points; ++i) {
        EXPECT_NEAR(shift[static_cast<std::size_t>(i)],
                    exact.shift(force * (1 - 2.0 * i / points), 20),
                    accuracy * std::abs(exact.shift(force, 20)));
      }
      EXPECT_NEAR(loss / exact.dissipation(), 1, scheme == MICROSLIP_DIRECT ? 3e-3 : 1e-3);
    }
  }
}

// Transforms of few sizes, planned and used by all threads at once.
TEST(CInterface, HandlesOfDifferentThreadsDoNotFeelEachOther) {
  constexpr int threads = 4;
  const auto work = [](int thread) {
    const int elements = 100 + 130 * (thread % 3);
    const Handle handle = created({.grid = {elements, MICROSLIP_REMEMBERED}});
    roll(handle, 40, 2.0 / elements);
    return answers(handle);
  };
  std::vector<std::vector<double>> at_once(threads);
  std::vector<std::thread> running;
  for (int i = 0; i < threads; ++i) {
    running.emplace_back([&, i] { at_once[static_cast<std::size_t>(i)] = work(i); });
  }
  for (std::thread& thread : running) thread.join();
  for (int i = 0; i < threads; ++i) expect_same(at_once[static_cast<std::size_t>(i)], work(i));
}

TEST(CInterface, WorksFromC99) {
  TransientRolling rolling({.contact = {StripKernel(material, 4), HertzBound(1, 1)},
                            .grid = Grid({.half_width = 1, .elements = 20}),
                            .basis = constant_basis(),
                            .scheme = Remembered{}});
  rolling.step(0.07, PrescribedCreepage{0.5});
  EXPECT_EQ(force_after_a_step_in_c99(), rolling.state().force);
}

}  // namespace microslip::answers_test
