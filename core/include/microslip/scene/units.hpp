// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// \file
/// Units of what scenes hold. Products and powers of
///   um mm cm m km in, N kN MN, Pa kPa MPa GPa, g kg t, ms s min h, rad, %
/// with blanks, * or a centred dot between them, powers as mm2, mm^2 or with a superscript, and
/// what follows one / below it: "kN/m", "N s^2/mm^2". No unit is that of a pure number, as is 1.

/// A number, perhaps with a unit, in another unit of the same kind: "2 cm" in mm is 20, "20" too.
/// Powers of ten do not round twice: "0.3 um" in mm is 0.0003.
/// \param text  a decimal number as Scene::number takes it; then, perhaps after blanks, a unit
/// \param unit  in which the result is, and a number without one
/// \return nothing if it is no finite number, or the unit is unknown or of another kind
std::optional<double> quantity(std::string_view text, std::string_view unit);

/// Numbers separated by blanks, in another unit: "-0.5 0.5 kN/mm" in N/mm is -500 and 500. One unit
/// after the last number is that of all; else each number has its own, or none has.
/// \param text  as many numbers as quantity() takes one of
/// \param unit  as for quantity()
/// \return nothing if one of them is no finite number, if a unit is unknown or of another kind, or
///         if some numbers have one and others, except for one unit after the last, have none
std::optional<std::vector<double>> quantities(std::string_view text, std::string_view unit);

/// Whether it reads as a unit.
bool is_unit(std::string_view text);

/// Whether a number is followed by a unit, or by a word that may be meant as one.
bool has_unit(std::string_view text);

/// "mm or another unit of its kind (um, cm, m, in)", for messages; "no unit" of pure numbers.
std::string accepted_units(const std::string& unit);

}  // namespace microslip
