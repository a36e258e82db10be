// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "input_problem.hpp"

namespace microslip {

/// Refuses a number of a case unless it is accepted. \throws std::invalid_argument
void require_input(bool is_accepted, const std::string& file, const InputNumber& number,
                   std::string_view name, std::string_view accepted);

/// The contact of a case with elastic half-spaces, whose digits are accepted.
/// \throws std::invalid_argument in one line, as problem_of_input()
InputContact contact_of_input(const InputCase& read, const std::string& file);

}  // namespace microslip
