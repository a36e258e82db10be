// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace microslip::experiments {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// The numbers that a condition accepts, and the words for them.
struct Range {
  std::optional<double> least = {};
  std::optional<double> most = {};
  bool with_ends = false;
  std::string words;             ///< text after "the measured value"
  double tolerance = not_given;  ///< half the width; none for one bound
};

Range above(double limit);                  ///< without the limit, as below() and between()
Range below(double limit);                  ///< as above()
Range between(double least, double most);   ///< both finite
Range equal_to(double number);              ///< to the last bit
Range within(double tolerance, double of);  ///< with the ends; the tolerance has the unit of `of`
Range within_percent(double percent, double of);  ///< percent of |of|

/// A range for the measured value of a claim, or for another quantity that was measured.
struct Condition {
  Condition(Range accepted) : range(std::move(accepted)) {}
  Condition(std::string name, Range accepted)
      : range(std::move(accepted)), quantity(std::move(name)) {}
  Condition(std::string name, double measured, Range accepted)
      : range(std::move(accepted)), quantity(std::move(name)), value(measured) {}

  Range range;
  std::string quantity = "the measured value";  ///< or a description of another quantity
  std::optional<double> value = {};             ///< of another quantity
};

/// A verdict, and the conditions under which it is given: all of them hold.
struct Ruling {
  std::string verdict;
  std::vector<Condition> conditions;
};

/// Determines the verdict on a claim from measurements: the first ruling whose conditions hold. The
/// verdict and the printed rule come from the same ranges.
struct Rule {
  std::vector<Ruling> rulings;
  std::string otherwise;
  std::string reason = {};  ///< instead of rulings
};

/// "reproduced" if all conditions hold, else "refuted".
Rule holds_if(std::vector<Condition> conditions);

/// "reproduced" if the first hold, else "corrected" if the second conditions hold, else "refuted".
Rule holds_if(std::vector<Condition> conditions, std::vector<Condition> corrected);

/// "corrected" if all conditions hold, else the given verdict.
Rule corrected_if(std::vector<Condition> conditions, std::string otherwise);

/// For a finding that is no claim of the thesis: "ours" if all conditions hold, else "refuted".
Rule ours_if(std::vector<Condition> conditions);

/// "not_comparable" for any measurement.
/// \param reason  text after "not comparable: "
Rule not_comparable(std::string reason);

/// The verdict of a rule; "not_comparable" if the measured value, or another quantity in the rule,
/// is nan, because nothing was measured.
std::string verdict(const Rule& rule, double measured_value);

/// The rule as one clause, with its numbers: "reproduced if the measured value is above 5;
/// otherwise refuted".
/// \throws std::logic_error for a rule that says nothing
std::string sentence(const Rule& rule);

/// Half the width of the range of the first condition, in the unit of the claim; not_given without
/// a condition, or if the range has only one bound.
double tolerance(const Rule& rule);

/// The tolerance of a rule that accepts 0 to rounding, at most 1e-8, because an accepted number is
/// only a rounding error; 0 for other rules.
double rounding_of(const Rule& rule);

}  // namespace microslip::experiments
