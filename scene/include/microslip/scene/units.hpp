// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// \file
/// Units of numbers in scenes. A unit is a product of powers of
///   um mm cm m km in, N kN MN, Pa kPa MPa GPa, g kg t, ms s min h, rad deg rev, rpm, %, ‰
/// with blanks, * or a centred dot between factors. Powers are mm2, mm^2 or a superscript. The
/// factors after a single / are the denominator: "kN/m", "N s^2/mm^2". A pure number has no unit,
/// or the unit 1.

/// Converts a number, with or without a unit, to a unit of the same kind: both "2 cm" and "20" in
/// mm are 20. Powers of ten are not rounded twice: "0.3 um" in mm is exactly the double 0.0003.
/// \param text  a decimal number as for Scene::number; then, after optional blanks, an optional
///              unit
/// \param unit  the unit of the result, and of a number without a unit
/// \return none if the number is not finite, or the unit is unknown or of another kind
std::optional<double> quantity(std::string_view text, std::string_view unit);

/// The unit behind a number, or behind the last number of a range, "50:50:200 mm"; empty if there
/// is none.
std::string_view unit_behind(std::string_view item);

/// The items of a list that is separated by blanks, each with its unit: numbers, or ranges of
/// sweeps. A single unit after the last item applies to all items: "5 10 mm" is "5 mm" and "10 mm".
/// Otherwise either each item has a unit, or no item has one. All lists with units follow this
/// rule.
/// \return none if some items have a unit and others have none
std::optional<std::vector<std::string>> list_items(std::string_view text);

/// Converts the numbers of a list, see list_items(): "-0.5 0.5 kN/mm" in N/mm is -500 and 500.
/// \param text  one or more numbers, each as for quantity()
/// \param unit  as for quantity()
/// \return none if a number is not finite, if a unit is unknown or of another kind, or if
///         list_items() returns none
std::optional<std::vector<double>> quantities(std::string_view text, std::string_view unit);

/// Whether the text is a unit.
bool is_unit(std::string_view text);

/// Whether the text is a number followed by a unit, or by a word that may be meant as a unit.
bool has_unit(std::string_view text);

/// For messages, what is wrong with the unit of a text if the key is about a mm of width and the
/// unit is not, as 80 kN for a key in N/mm; empty otherwise.
std::string advice_on_width(std::string_view text, std::string_view unit);

/// "mm or another of its kind (um, cm, m, in)", for messages; "no unit, or in % or ‰" for pure
/// numbers.
std::string accepted_units(const std::string& unit);

}  // namespace microslip
