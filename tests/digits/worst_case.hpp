// SPDX-License-Identifier: GPL-3.0-or-later
// Errors against values in many digits, the worst of which is part of a test's name.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "test_name.hpp"

namespace microslip::test {

using Digits50 = boost::multiprecision::cpp_bin_float_50;
using Digits100 = boost::multiprecision::cpp_bin_float_100;

/// |value - exact| / scale. Scales are those of the terms that make the value up, where it vanishes
/// by symmetry or by their cancelling; the value itself elsewhere.
template <class Digits>
double relative_error(double value, const Digits& exact, const Digits& scale) {
  if (!std::isfinite(value)) return HUGE_VAL;
  const Digits error = abs(Digits(value) - exact);
  return error == 0 ? 0 : static_cast<double>(Digits(error / abs(scale)));
}

template <class Digits>
double relative_error(double value, const Digits& exact) {
  return relative_error(value, exact, exact);
}

/// How far a value lies beyond those that are exact for neighbours of the arguments: what a
/// rounding of an argument changes is no error of the function. Relative to the largest of them.
/// \param exact  at the arguments first, and at neighbours
template <class Digits>
double error_beyond(double value, const std::vector<Digits>& exact) {
  const auto [least, most] = std::minmax_element(exact.begin(), exact.end());
  const Digits nearest = std::clamp(Digits(value), *least, *most);
  return relative_error(value, nearest, std::max(Digits(abs(*least)), Digits(abs(*most))));
}

/// The largest of the errors met.
class WorstCase {
 public:
  void meet(double error, const std::string& where) {
    places_.push_back(where);
    if (places_.size() > 1 && error <= error_) return;
    error_ = error;
    where_ = where;
  }

  double error() const { return error_; }
  const std::string& where() const { return where_; }
  bool has_met(const std::string& where) const {
    return std::find(places_.begin(), places_.end(), where) != places_.end();
  }

 private:
  double error_ = 0;
  std::string where_;
  std::vector<std::string> places_;
};

/// The worst case as a test's name states it: the error rounded up to one digit, and its place.
struct Stated {
  std::string subject;
  double error;
  std::string where;

  std::string name() const { return subject + "_worst_" + in_a_name(error) + "_at_" + where; }
};

inline std::ostream& operator<<(std::ostream& out, const Stated& stated) {
  return out << stated.name();
}

/// Other machines round otherwise: up to twice the stated error is accepted, and a rounding of the
/// result. A name that states far more than there is, or a place that is not met any longer, is out
/// of date.
inline void expect_as_stated(const Stated& stated, const WorstCase& worst) {
  const auto met = [&] {
    return "met " + in_a_name(worst.error()) + " at " + worst.where() + ", stated " + stated.name();
  };
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  EXPECT_LE(worst.error(), 2 * stated.error + rounding) << met();
  EXPECT_GE(worst.error() + rounding, stated.error / 10) << met();
  EXPECT_TRUE(worst.has_met(stated.where)) << met();
}

/// For INSTANTIATE_TEST_SUITE_P, of parameters derived from Stated.
inline constexpr auto case_name = [](const auto& info) { return info.param.name(); };

}  // namespace microslip::test
