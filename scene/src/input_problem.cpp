// SPDX-License-Identifier: GPL-3.0-or-later
// The problems of cases of an input file of CONTACT that microslip can do.
#include "input_problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "input_contact.hpp"
#include "microslip/support/shown.hpp"

namespace microslip {

namespace {

struct AcceptedDigit {
  char digit;
  std::vector<int> values;
  std::string_view accepted;
};

/// Refuses control digits without a scene, in the order of the file.
void require_digits(const InputCase& read, const std::string& file, bool direct) {
  static const std::vector<AcceptedDigit> rules{
      {'P', {0, 1, 2}, "0, 1 or 2 for a shift or a step"},
      {'B', {0, 2}, "0 or 2, Hertz's contact of elastic half-spaces"},
      {'T', {1, 2, 3}, "1, a shift, 2, a step of rolling, or 3, steady rolling"},
      {'V', {0}, "0, one friction coefficient"},
      {'L', {0}, "0, Coulomb's friction with FSTAT = FKIN"},
      {'C', {2, 3}, "2 or 3, elastic half-spaces"},
      {'M', {0}, "0, elastic bodies"},
      {'Z', {0, 1, 2}, "0, 1 or 2"},
      {'E', {0}, "0, no extra term of the rigid slip"},
      {'H', {0, 1, 3}, "0, 1 or 3"},
      {'R', {0, 1}, "0 or 1; CONTACT does not compute this case"}};
  for (const AcceptedDigit& rule : rules) {
    if (rule.digit == 'P' && read['T'] == 3) continue;  // which has no step before it
    if (std::ranges::find(rule.values, read[rule.digit]) != rule.values.end()) continue;
    refuse_input(file, read.line_of(rule.digit), name_of_digit(rule.digit),
                 std::to_string(read[rule.digit]), rule.accepted);
  }
  const auto refuse = [&](char digit, std::string_view accepted) {
    refuse_input(file, read.line_of(digit), name_of_digit(digit), std::to_string(read[digit]),
                 accepted);
  };
  if (direct && read['B'] != 0) refuse('B', "0 with --scheme direct");
  if (direct && read['C'] != 2) refuse('C', "2 with --scheme direct");
  if (read['B'] == 2 && read.potential[0].value > 0) {
    refuse('B', "0 with a potential contact, IPOTCN > 0");
  }
  if (read['T'] > 1 && read.rolling.empty()) refuse('C', "2 or 3 where rolling begins");
  if (read.damping.value != 0) {
    refuse_input(file, read.damping.line, "M2", "2", "0, without damping");
  }
  if (read.gap_weights.value != 0) {
    refuse_input(file, read.gap_weights.line, "the digit before M2",
                 std::to_string(read.gap_weights.value), "0");
  }
}

/// The name of a number of the kinematics, from 0.
const char* name_of(const InputCase& read, std::size_t k) {
  constexpr std::array motions{"CKSI", "CETA", "CPHI", "SPINXO", "SPINYO"};
  constexpr std::array forces{"FX", "FY"};
  return static_cast<int>(k) < read['F'] ? forces[k] : motions[k];
}

/// The sine of CHI below which a direction is along x but for digits that were left out, as in 3.14.
constexpr double most_turned = 2e-3;

/// Refuses numbers of the motion without a scene.
void require_motion(const InputCase& read, const std::string& file, bool direct) {
  const std::vector<InputNumber>& given = read.kinematics;
  for (std::size_t k = 3; k + 1 < given.size(); ++k) {
    require_input(given[k + 1].value == 0, file, given[k + 1], name_of(read, k),
                  "0: spin about x = y = 0");
  }
  double square = 0;
  for (std::size_t k = 0; static_cast<int>(k) < read['F']; ++k) {
    square += std::pow(given[1 + k].value, 2);
    require_input(square < 1, file, given[1 + k], name_of(read, k),
                  "a force below full sliding: FX^2 + FY^2 < 1, in units of FSTAT FN");
  }
  if (read['T'] == 1) return;
  const std::vector<InputNumber>& rolling = read.rolling;
  require_input(std::abs(std::sin(rolling[0].value)) < most_turned, file, rolling[0], "CHI",
                "0 or 180d, rolling along x");
  require_input(rolling[1].value > 0, file, rolling[1], "DQ", "a number > 0");
  if (direct && rolling.size() > 3) {
    require_input(std::abs(rolling[3].value - 1.0 / 6) < 1e-3, file, rolling[3], "FACPHI",
                  "1/6 with --scheme direct");
  }
}

bool rolls_backwards(const InputCase& read) {
  return read['T'] > 1 && std::cos(read.rolling[0].value) < 0;
}

/// Whether the direction of rolling is one of x but for digits that were left out.
bool is_rounded_direction(const InputCase& read) {
  return read['T'] > 1 && std::abs(std::sin(read.rolling[0].value)) > 1e-6;
}

/// Forces are over mu FN.
/// \param backwards  whether x and y of the scene are opposite to those of the case
PatchLoad load_of(const InputCase& read, bool backwards) {
  PatchLoad load;
  for (std::size_t j = 0; j < load.size(); ++j) {
    const double value = read.kinematics[1 + j].value;
    const bool turns = backwards && j < 2 && value != 0;
    load[j] = {static_cast<int>(j) < read['F'], turns ? -value : value};
  }
  return load;
}

/// The case and those before it that it continues, the first one first.
std::vector<const InputCase*> continued(const std::vector<InputCase>& cases, std::size_t index,
                                        const std::string& file) {
  std::vector<const InputCase*> all{&cases[index]};
  for (;;) {
    const InputCase& last = *all.back();
    if (last['T'] == 3 || last['P'] != 0 || last.previous < 0) break;
    const InputCase& before = cases[static_cast<std::size_t>(last.previous)];
    if (before['T'] == 0) break;  // which leaves no tractions
    if (before['T'] == 3) {
      refuse_input(file, last.line_of('P'), name_of_digit('P'), "0",
                   "2, a start at rest, behind steady rolling");
    }
    all.push_back(&before);
  }
  std::ranges::reverse(all);
  return all;
}

bool is_same(const InputContact& one, const InputContact& other) {
  const auto close = [](double p, double q) { return std::abs(p - q) <= 1e-9 * std::abs(q); };
  return one.is_ellipse == other.is_ellipse && close(one.friction, other.friction) &&
         close(one.load, other.load) && close(one.half_width, other.half_width) &&
         close(one.lateral, other.lateral) &&
         close(one.material.shear_modulus, other.material.shear_modulus) &&
         close(one.material.poisson_ratio, other.material.poisson_ratio);
}

/// Refuses a step with another load or length than the step before it.
void require_same_step(const InputCase& step, const InputCase& before, const std::string& file) {
  if (step['F'] != before['F']) {
    refuse_input(file, step.line_of('F'), name_of_digit('F'), std::to_string(step['F']),
                 fmt::format("{}, as in the case that it continues", before['F']));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const InputNumber &now = step.kinematics[1 + j], &then = before.kinematics[1 + j];
    require_input(
        now.value == then.value, file, now, name_of(step, j),
        fmt::format("{} as in the step before: a scene has one load over all steps", then.text));
  }
  require_input(step.rolling[1].value == before.rolling[1].value, file, step.rolling[1], "DQ",
                fmt::format("{} as in the step before", before.rolling[1].text));
  require_input(rolls_backwards(step) == rolls_backwards(before), file, step.rolling[0], "CHI",
                fmt::format("{} as in the step before", before.rolling[0].text));
}

/// Adds a case to a run of shifts and steps.
/// \param backwards  whether the run rolls towards -x
void add(InputProblem& problem, bool backwards, const InputCase& next, const InputCase* before,
         const std::string& file) {
  const bool is_shift = next['T'] == 1;
  if (is_shift && problem.steps > 0) {
    refuse_input(file, next.line_of('T'), name_of_digit('T'), "1",
                 "2 behind a step of rolling, or P = 2, a start at rest");
  }
  if (!is_shift) {
    if (problem.steps > 0) require_same_step(next, *before, file);
    problem.kind = InputProblem::Kind::steps;
    problem.load = load_of(next, backwards);
    problem.step = next.rolling[1].value;
    ++problem.steps;
    return;
  }
  if (before != nullptr && next['F'] != (*before)['F']) {
    refuse_input(file, next.line_of('F'), name_of_digit('F'), std::to_string(next['F']),
                 fmt::format("{}, as in the shift before", (*before)['F']));
  }
  problem.kind = InputProblem::Kind::shift;
  problem.shifts.push_back(load_of(next, backwards));
}

/// Refuses motions that one row of elements does not have.
void require_row(const InputProblem& problem, const InputCase& read, const std::string& file) {
  require_input(read.kinematics[3].value == 0, file, read.kinematics[3], "CPHI",
                "0 with one row of elements");
  const std::size_t other = problem.across() ? 0 : 1;
  require_input(read.kinematics[1 + other].value == 0, file, read.kinematics[1 + other],
                name_of(read, other),
                problem.across() ? "0 with one row of elements that is loaded across"
                                 : "0 with one row of elements that is loaded along");
}

void add_notes(InputProblem& problem, const InputCase& read, const std::string& file) {
  const auto note = [&](char digit, std::string_view text) {
    problem.notes.push_back(fmt::format("{}:{}: {} = {}: {}", shown(file), read.line_of(digit),
                                        name_of_digit(digit), read[digit], text));
  };
  if (is_rounded_direction(read)) {
    problem.notes.push_back(fmt::format("{}:{}: CHI = {}: taken as {}, rolling along x",
                                        shown(file), read.rolling[0].line, read.rolling[0].text,
                                        rolls_backwards(read) ? "180d" : "0"));
  }
  if (rolls_backwards(read)) {
    problem.notes.push_back(
        fmt::format("{}:{}: CHI = {}: x and y of the scene are opposite to those of the case, and "
                    "so are the signs "
                    "of creepages and forces; spin and moment are the same",
                    shown(file), read.rolling[0].line, read.rolling[0].text));
  }
  if (read['S'] > 0) note('S', "stresses below the surface are left out");
  if (read['H'] > 0) note('H', "temperatures are left out; tractions do not depend on them here");
  if (read['N'] == 0) note('N', "the load follows from the approach PEN by Hertz");
}

}  // namespace

bool InputProblem::across() const {
  if (contact.is_ellipse) return false;
  const auto is_across = [](const PatchLoad& one) { return one[1].value != 0; };
  return is_across(load) || std::ranges::any_of(shifts, is_across);
}

std::string InputProblem::description() const {
  const char* of = contact.is_ellipse ? "an ellipse" : across() ? "a strip, across" : "a strip";
  const auto count = [](std::size_t number, const char* what) {
    return number == 1 ? fmt::format("a {}", what) : fmt::format("{} {}s", number, what);
  };
  if (kind == Kind::steady) return fmt::format("steady rolling of {}", of);
  const std::string rolled = count(static_cast<std::size_t>(steps), "step");
  if (shifts.empty()) return fmt::format("{} of {} from rest", rolled, of);
  const std::string shifted = count(shifts.size(), "shift");
  if (kind == Kind::shift) return fmt::format("{} of {}", shifted, of);
  return fmt::format("{} and {} of {}", shifted, rolled, of);
}

InputProblem problem_of_input(const std::vector<InputCase>& cases, std::size_t index,
                              const std::string& file, bool direct) {
  require_digits(cases[index], file, direct);
  const std::vector<const InputCase*> run = continued(cases, index, file);
  InputProblem problem;
  problem.first = run.front()->number;
  problem.last = run.back()->number;
  problem.line = run.back()->line;
  for (const InputCase* one : run) {
    require_digits(*one, file, direct);
    require_motion(*one, file, direct);
  }
  const bool backwards = rolls_backwards(*run.back());
  const InputCase* before = nullptr;
  for (const InputCase* one : run) {
    const InputContact contact = contact_of_input(*one, file);
    if (before != nullptr && !is_same(contact, problem.contact)) {
      throw std::invalid_argument(
          fmt::format("{}:{}: case {} continues case {} with another contact: expected the same "
                      "load, friction, "
                      "bodies and curvatures, or P = 2, a start at rest",
                      shown(file), one->line, one->number, before->number));
    }
    problem.contact = contact;
    if ((*one)['T'] == 3) {
      problem.load = load_of(*one, backwards);
      // Other solvers of CONTACT take DX in the place of DQ.
      if ((*one)['G'] == 2) problem.step = one->rolling[1].value;
    } else {
      add(problem, backwards, *one, before, file);
    }
    before = one;
  }
  for (const InputCase* one : run) {
    if (!problem.contact.is_ellipse) require_row(problem, *one, file);
  }
  add_notes(problem, *run.back(), file);
  return problem;
}

}  // namespace microslip
