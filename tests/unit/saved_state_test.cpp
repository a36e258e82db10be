// SPDX-License-Identifier: GPL-3.0-or-later
// Saved states that do not fit are refused; runs in parts are those in one go.
// tests/property/generated_states_test.cpp has what goes on to the bit.
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/rolling/transient.hpp"
#include "microslip/support/checksum.hpp"
#include "microslip/support/not_converged.hpp"

namespace microslip::saved_state_test {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Material steel{82000, 0.28};
constexpr double dx = 0.25;

TransientProblem problem(Index elements = 40) {
  return {.contact = {StripKernel(steel, 10), HertzBound(5, 300)},
          .grid = Grid({.half_width = 5, .elements = elements}),
          .basis = constant_basis(),
          .scheme = Remembered{}};
}

const LoadHistory load = PrescribedCreepage{0.002};

TransientRolling rolled(double distance, const TransientProblem& of = problem()) {
  TransientRolling rolling(of, CattaneoShift{-500});
  rolling.roll(distance, {dx, 0.4 * dx}, load, [](const TransientState&) {});
  return rolling;
}

/// Why a text is refused; empty if it is not.
std::string refusal(const std::string& text, const TransientProblem& of = problem()) {
  try {
    TransientRolling(of, SavedState{text});
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// The text with its right checksum, whatever it says.
std::string sealed(std::string text) {
  text.erase(text.rfind("checksum "));
  return text + "checksum " + checksum(text) + "\n";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(SavedState, ThatIsDamagedIsRefused) {
  const std::string text = rolled(3).save();
  ASSERT_EQ(refusal(text), "");
  for (std::size_t length = 0; length < text.size(); length += 50) {
    EXPECT_NE(refusal(text.substr(0, length)), "") << length;
  }
  for (std::size_t at = 0; at < text.size(); at += 37) {
    std::string flipped = text;
    flipped[at] = static_cast<char>(flipped[at] ^ 1);
    EXPECT_NE(refusal(flipped), "") << at;
  }
  EXPECT_NE(refusal(text + "\n"), "");
  EXPECT_NE(refusal("x\ttraction\n0\t0\n").find("expected a state that microslip has saved"),
            std::string::npos);
}

TEST(SavedState, OfAnotherVersionIsRefused) {
  const std::string other = replaced(rolled(3).save(), "microslip state 4", "microslip state 1");
  EXPECT_EQ(refusal(sealed(other)),
            "version = '1': expected 4, the version of this program's states");
}

TEST(SavedState, OfAPatchIsRefused) {
  const std::string other =
      replaced(rolled(3).save(), "microslip state 4", "microslip state of a patch 3");
  EXPECT_EQ(refusal(sealed(other)),
            "expected 'microslip state 4' in the first line, not 'microslip state of a patch 3', "
            "which is a state of another kind of contact");
}

TEST(SavedState, OfAnotherProblemIsRefused) {
  const std::string text = rolled(3).save();
  const auto expect_refused = [&](const std::string& named,
                                  const std::function<void(TransientProblem&)>& change) {
    TransientProblem other = problem();
    change(other);
    EXPECT_EQ(refusal(text, other).substr(0, named.size()), named);
    EXPECT_THROW(distance_of({text}, other), std::invalid_argument);
  };
  expect_refused("scheme = 'direct': expected 'remembered'",
                 [](TransientProblem& of) { of.scheme = Direct{}; });
  expect_refused("kernel.type = 'plane': expected 'strip'",
                 [](TransientProblem& of) { of.contact.kernel = PlaneKernel(steel, 100); });
  expect_refused("kernel.width = 11: expected 10",
                 [](TransientProblem& of) { of.contact.kernel = StripKernel(steel, 11); });
  expect_refused("material.shear_modulus = 81000: expected 82000", [](TransientProblem& of) {
    of.contact.kernel = StripKernel({81000, 0.28}, 10);
  });
  expect_refused("material.poisson_ratio = 0.3: expected 0.28", [](TransientProblem& of) {
    of.contact.kernel = StripKernel({82000, 0.3}, 10);
  });
  expect_refused("grid.elements = 41: expected 40",
                 [](TransientProblem& of) { of.grid = Grid({.half_width = 5, .elements = 41}); });
  expect_refused("contact.half_width = 6: expected 5", [](TransientProblem& of) {
    of.grid = Grid({.half_width = 6, .elements = 40});
    of.contact.bound = HertzBound(6, 300);
  });
  expect_refused("bound of element 1 = ",
                 [](TransientProblem& of) { of.contact.bound = HertzBound(5, 301); });
  expect_refused("solver.type = 'fft': expected 'dense'",
                 [](TransientProblem& of) { of.solver.type = Solver::Type::fft; });
  expect_refused("solver.tolerance = 1e-09: expected 1e-10",
                 [](TransientProblem& of) { of.solver.tolerance = 1e-9; });
}

TEST(SavedState, OfAnotherSchemeIsNotMade) {
  TransientProblem direct = problem();
  direct.scheme = Direct{};
  EXPECT_THROW(TransientRolling(direct).save(), std::invalid_argument);
}

TEST(SavedState, ThatIsRefusedChangesNothing) {
  TransientRolling rolling = rolled(3), same = rolling;
  EXPECT_THROW(rolling.restore({"nothing"}), std::invalid_argument);
  EXPECT_EQ(rolling.save(), same.save());
  same.restore({rolled(4).save()});
  EXPECT_EQ(same.state().distance, 4);
}

// Words of it replaced by other ones, under a right checksum: refused, or a state like any other.
TEST(SavedState, ThatIsForgedDoesNotEndTheProgram) {
  const std::vector<std::string> words{"",    "-1", "0",           "1",   "39",
                                       "40",  "41", "99999999999", "nan", "-",
                                       "inf", "1p", "-1p+3",       "x",   "1p+2000"};
  int refused = 0;
  for (const Index elements : {40, 110}) {
    const std::string text = rolled(3, problem(elements)).save();
    const std::size_t from = text.find("\ndistance "), to = text.rfind("checksum ");
    std::mt19937 random(static_cast<unsigned>(elements));
    for (int i = 0; i < 400; ++i) {
      std::size_t at = std::uniform_int_distribution<std::size_t>(from + 1, to - 2)(random);
      // Every other one in a line of few words, where a list of many would hide it.
      if (i % 2 == 0) at = text.rfind('\n', at) + 1;
      const std::size_t begin = text.find(' ', at) + 1;
      const std::size_t end = text.find_first_of(" \n", begin);
      if (begin >= to || end >= to) continue;
      std::string other = text;
      other.replace(begin, end - begin, words[static_cast<std::size_t>(i) % words.size()]);
      try {
        TransientRolling rolling(problem(elements), SavedState{sealed(other)});
        for (int k = 0; k < 5; ++k) rolling.step(dx, PrescribedCreepage{-0.001 * k});
      } catch (const std::invalid_argument&) {
        ++refused;
      } catch (const NotConverged&) {
      }
    }
  }
  EXPECT_GT(refused, 300);
}

TEST(SavedState, KnowsItsDistance) { EXPECT_EQ(distance_of({rolled(3).save()}, problem()), 3); }

/// The states of a run from a saved one, or from the start.
std::vector<double> creepages(TransientRolling& rolling, double distance,
                              const std::vector<double>& lengths, const LoadHistory& loads) {
  std::vector<double> all;
  rolling.roll_to(distance, lengths, loads, [&](const TransientState& state) {
    all.insert(all.end(), {state.distance, state.creepage, state.force, state.dissipation});
  });
  return all;
}

TEST(SavedState, OfEachStepOfARunGoesOnLikeTheRun) {
  RunRows rows;
  rows.distance = VectorXd::LinSpaced(7, 2, 14);
  rows.force = VectorXd::LinSpaced(7, -200, -1300);
  const LoadHistory loads(rows);
  const std::vector<double> lengths{dx, 0.4 * dx, 0.07};
  TransientRolling run(problem(), CattaneoShift{-200});
  const std::vector<double> all = creepages(run, 9.3, lengths, loads);
  const std::size_t steps = number_of_steps(9.3, lengths);
  ASSERT_EQ(all.size(), 4 * steps);
  for (std::size_t k = 1; k < steps; k += 5) {
    TransientRolling first(problem(), CattaneoShift{-200});
    // Printed with few digits, as scenes have it.
    const double printed = std::stod(std::to_string(all[4 * (k - 1)]));
    const double end = end_of_whole_steps(
        std::abs(printed - all[4 * (k - 1)]) < 1e-11 ? printed : all[4 * (k - 1)], lengths);
    EXPECT_EQ(end, all[4 * (k - 1)]);
    std::vector<double> parts = creepages(first, end, lengths, loads);
    TransientRolling second(problem(), SavedState{first.save()});
    EXPECT_EQ(number_of_steps(9.3, lengths, end), steps - k);
    const std::vector<double> rest = creepages(second, 9.3, lengths, loads);
    parts.insert(parts.end(), rest.begin(), rest.end());
    EXPECT_EQ(parts, all) << "step " << k;
    EXPECT_EQ(second.save(), run.save());
  }
}

// From within a step, the first one is what is left of it.
TEST(SavedState, BetweenStepsGoesOnToTheNextEnd) {
  TransientRolling rolling = rolled(1.1), stepped = rolling;
  stepped.step(1.5 - 1.1, PrescribedCreepage{0.002});
  std::vector<double> ends;
  rolling.roll_to(2.2, {0.5}, load, [&](const TransientState& state) {
    if (ends.empty()) {
      EXPECT_EQ(state.force, stepped.state().force);
    }
    ends.push_back(state.distance);
  });
  EXPECT_EQ(ends, (std::vector<double>{1.5, 2, 2.2}));
  EXPECT_EQ(end_of_whole_steps(2.2, {0.5}), 2.2);
  EXPECT_THROW(number_of_steps(1, {0.5}, 1), std::invalid_argument);
}

}  // namespace microslip::saved_state_test
