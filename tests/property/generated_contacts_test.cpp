// SPDX-License-Identifier: GPL-3.0-or-later
// Steady rolling of contacts that nobody chose, against the scheme of the thesis on fine grids: it
// has another grid, other bounds of its elements and another order.
#include "property/generated_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <variant>

#include "microslip/support/format.hpp"
#include "microslip/support/not_converged.hpp"
#include "property/samples.hpp"
#include "property/table_closed_form.hpp"

namespace microslip::generated_contacts_test {

using Eigen::Index;

double creepage(const SteadyContact& contact, Index elements, const SteadyMethod& method) {
  return solve_steady(problem_of(contact, elements, method)).creepage;
}

/// In closed form, for tables and plane strain with one zone of stick and of slip.
std::optional<double> closed_form(const SteadyContact& contact) {
  const auto* table = std::get_if<TabulatedBound>(&contact.bound);
  const Kernel& kernel = contact.kernel;
  if (!kernel.is_plane() || table == nullptr) return std::nullopt;
  const double force = std::get<PrescribedForce>(contact.load).value;
  const auto solution =
      TableClosedForm(PlaneKernel(kernel.material(), *kernel.plane_length()), *table)
          .solve(std::abs(force));
  if (!solution) return std::nullopt;
  return force < 0 ? solution->creepage : -solution->creepage;
}

/// In closed form; or else extrapolated for first order, from two pairs of grids whose nodes lie
/// differently.
struct Truth {
  double creepage;
  double uncertainty;  ///< thrice the last change, or the difference of the two pairs

  explicit Truth(const SteadyContact& contact) {
    if (const auto exact = closed_form(contact)) {
      creepage = *exact;
      uncertainty = 1e-6 * std::abs(creepage);  // of slip at the leading edge
    } else {
      extrapolate(contact);
    }
  }

  void extrapolate(const SteadyContact& contact) {
    const auto of = [&](Index n) {
      return generated_contacts_test::creepage(contact, n, Differences{});
    };
    const double coarse = of(800), fine = of(1600);
    const double other = 2 * of(1893) - of(947);
    creepage = 2 * fine - coarse;
    uncertainty = std::max(3 * std::abs(fine - coarse), std::abs(other - creepage));
  }
};

struct Count {
  int held = 0, broken = 0, refused = 0;
  double worst = 0;  ///< relative error
};

void print(const std::string& what, const std::map<std::string, Count>& counts) {
  for (const auto& [kind, count] : counts) {
    std::cout << what << ", " << kind << ": " << count.held << " held, " << count.broken
              << " broken, " << count.refused << " refused; largest relative error " << count.worst
              << '\n';
  }
}

int total(const std::map<std::string, Count>& counts, int Count::*what) {
  int sum = 0;
  for (const auto& [kind, count] : counts) sum += count.*what;
  return sum;
}

// Two derivations that share nothing.
TEST(GeneratedContacts, ClosedFormIsTheLimitOfTheScheme) {
  ContactGenerator generator(seed_of_tests() + 2000);
  int known = 0;
  for (int i = 0; i < samples(240); ++i) {
    const auto [kind, contact] = generator.next();
    const auto exact = closed_form(contact);
    if (!exact) continue;
    ++known;
    Truth scheme(contact);
    scheme.extrapolate(contact);
    EXPECT_NEAR(scheme.creepage, *exact, scheme.uncertainty + 1e-3 * std::abs(*exact))
        << kind << ", case " << i;
  }
  EXPECT_GT(known, samples(240) / 12);
  std::cout << known << " in closed form\n";
}

// Loads down to a millionth of sliding.
TEST(GeneratedContacts, SmallLoadsAreThoseOfTheClosedForm) {
  ContactGenerator generator(seed_of_tests() + 3000);
  std::map<std::string, Count> counts;
  for (int i = 0; i < samples(480); ++i) {
    auto [kind, contact] = generator.next();
    const double ratio = std::pow(10, -1 - (i / 12) % 6);
    contact.load = PrescribedForce{-ratio * full_sliding_force(contact.bound)};
    const auto exact = closed_form(contact);
    if (!exact) continue;
    Count& count = counts[kind + " " + format_short(ratio)];
    const double error = std::abs(creepage(contact, 100, Inversion{}) / *exact - 1);
    count.worst = std::max(count.worst, error);
    ++(error <= 1e-6 ? count.held : count.broken);
  }
  print("small loads, N = 100", counts);
  EXPECT_EQ(total(counts, &Count::broken), 0);
  EXPECT_GT(total(counts, &Count::held), 20);
}

// The result has the right sign, and is within one and a half times the larger of 1 % and the error
// of the thesis's scheme with as many elements.
TEST(GeneratedContacts, DefaultMethodIsRight) {
  ContactGenerator generator(seed_of_tests());
  std::map<std::string, Count> counts;
  for (int i = 0; i < samples(240); ++i) {
    const auto [kind, contact] = generator.next();
    const Truth truth(contact);
    const auto error = [&](const SteadyMethod& method) {
      return std::abs(creepage(contact, 100, method) - truth.creepage);
    };
    const double size = std::abs(truth.creepage);
    const double found = error(Inversion{});
    const double allowed = 1.5 * std::max(0.01 * size, error(Differences{})) + truth.uncertainty;
    Count& count = counts[kind];
    ++(found <= allowed ? count.held : count.broken);
    count.worst = std::max(count.worst, found / size);
    EXPECT_LE(found, allowed) << kind << ", case " << i << ": " << found / size;
  }
  print("default method, N = 100", counts);
}

// The force leads to a creepage, and that back to the force, by elements or not.
TEST(GeneratedContacts, ForcesAndCreepagesLeadToEachOther) {
  ContactGenerator generator(seed_of_tests() + 10);
  for (int i = 0; i < samples(600); ++i) {
    const auto [kind, contact] = generator.next();
    SteadyProblem problem = problem_of(contact, 200, Inversion{});
    const double force = std::get<PrescribedForce>(contact.load).value;
    problem.load = PrescribedCreepage{solve_steady(problem).creepage};
    EXPECT_NEAR(solve_steady(problem).force / force, 1, 0.02) << kind << ", case " << i;
  }
}

// The estimate is meant to be an upper limit. The truth is known to its uncertainty only. The error
// is never above five times the target.
TEST(GeneratedContacts, EstimatesHold) {
  ContactGenerator generator(seed_of_tests() + 1000);
  std::map<std::string, Count> counts;
  for (int i = 0; i < samples(500); ++i) {
    const auto [kind, contact] = generator.next();
    Count& count = counts[kind];
    try {
      const EstimatedSteady found = solve_steady_to(contact, 1e-3);
      const Truth truth(contact);
      const double size = std::abs(truth.creepage);
      const double error = std::abs(found.solution.creepage - truth.creepage);
      const bool held = error <= found.error * size + truth.uncertainty;
      ++(held ? count.held : count.broken);
      count.worst = std::max(count.worst, error / size);
      EXPECT_LE(error, 0.005 * size + truth.uncertainty) << kind << ", case " << i;
    } catch (const NotConverged&) {
      ++count.refused;
    }
  }
  print("target_error 1e-3", counts);
  EXPECT_GE(total(counts, &Count::held), 100 * total(counts, &Count::broken));
  EXPECT_LE(total(counts, &Count::refused), samples(25));
}

}  // namespace microslip::generated_contacts_test
