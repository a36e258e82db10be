// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "microslip/scene/table.hpp"
#include "tolerances.hpp"

namespace microslip::tools {

/// A large table is kept as `kept` of its rows, evenly spaced from the first to the last; a first
/// parameter "rows" says of how many. Smaller ones are kept as they are, which alone keep bounds of
/// rounding that belong to a row.
WrittenTable thinned(const WrittenTable& whole, std::size_t kept);

/// Numbers that are nothing but rounding have no reference: the word "rounding" takes their place.
WrittenTable without_rounding(const WrittenTable& whole);

enum class Verdict { identical, agrees, differs };

struct Comparison {
  Verdict verdict;
  std::string text;  ///< in words, with column, row and both values of the largest difference
};

/// Compares parameters, columns, rows and cells. Numbers, those in sentences too, may differ within
/// the tolerances, and by their bound of rounding; all other text may not. Where the reference says
/// "rounding" the number must be rounding according to its own table, too.
/// \param name  "study/table", for the tolerances
Comparison compare(const std::string& name, const WrittenTable& table,
                   const WrittenTable& reference, const Tolerances& tolerances);

}  // namespace microslip::tools
