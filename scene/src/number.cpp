// SPDX-License-Identifier: GPL-3.0-or-later
#include "number.hpp"

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>

#include "microslip/support/format.hpp"
#include "microslip/support/nearest.hpp"

namespace microslip {

std::optional<Eigen::Index> whole_number(std::string_view text) {
  constexpr double exact = 9007199254740992;
  if (const auto value = converted<Eigen::Index>(text)) return value;
  const auto value = finite_number(text);
  if (!value || *value != std::floor(*value) || std::abs(*value) > exact) return std::nullopt;
  return static_cast<Eigen::Index>(*value);
}

std::string joined_numbers(const std::vector<double>& values) {
  std::vector<std::string> texts(values.size());
  std::ranges::transform(values, texts.begin(), format_short);
  return joined(texts, " ");
}

std::string advice(const std::string& text) {
  const auto is_number_with = [&](const char* instead, const char* of) {
    return finite_number(boost::algorithm::replace_all_copy(text, of, instead)).has_value();
  };
  double value = 0;
  const std::string_view digits = without_plus(text);
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range && stop == digits.data() + digits.size()) {
    return " that is 0 or from 5e-324 to 1.7e308 in magnitude";
  }
  if (!text.ends_with(',') && is_number_with(".", ",")) return " with a decimal point";
  if (is_number_with("-", "\u2212")) return " with the minus sign -";
  return "";
}

}  // namespace microslip
