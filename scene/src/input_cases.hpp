// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input_words.hpp"

namespace microslip {

/// A control digit of a case, and its line.
struct InputDigit {
  int value = 0;
  int line = 0;
};

/// A case of module 3 of an input file of CONTACT, with all that it keeps from the case before.
struct InputCase {
  int number = 0;     ///< from 1, in the order of the file
  int line = 0;       ///< of its first control word
  int previous = -1;  ///< index of the case that it may continue; -1 for none

  /// P B T N F S, V L D C M Z E and X H G I A O W R. L, C and E that keep those of the case before
  /// have its value.
  std::map<char, InputDigit> digits;
  InputDigit damping;      ///< M2, 0 without
  InputDigit gap_weights;  ///< the digit before M2

  // Groups of numbers; empty before the first is read.
  std::vector<InputNumber> kinematics;  ///< FN, CKSI, CETA, CPHI, and perhaps SPINXO, SPINYO
  std::vector<InputNumber> friction;    ///< FSTAT, FKIN if L = 0
  std::vector<InputNumber> rolling;     ///< CHI, DQ, VELOC, and perhaps FACPHI
  std::vector<InputNumber> material;    ///< POISS1, POISS2, GG1, GG2
  std::vector<InputNumber> potential;   ///< IPOTCN, MX, MY and what follows them
  std::vector<InputNumber> geometry;    ///< IBASE, IPLAN and what follows them

  // The potential contact was formed with these, when D was last 1 or 2.
  int formed_norm = 1;      ///< N
  InputNumber formed_load;  ///< FN or PEN
  std::vector<InputNumber> formed_material;

  int operator[](char digit) const { return digits.at(digit).value; }
  int line_of(char digit) const { return digits.at(digit).line; }
};

/// Reads an input file of CONTACT case by case: all numbers of module 3, also those of cases that
/// have no scene, as others follow them.
class InputCases {
 public:
  InputCases(std::string_view text, const std::string& file) : words_(text, file) {}

  /// Reads the next case. \return false behind the last one, where MODULE is 0
  /// \throws std::invalid_argument in one line
  bool next();

  /// Checks that a case or the end follows the last case that was read, so that the file was not
  /// cut in it. \throws std::invalid_argument in one line
  void require_more();

  const std::vector<InputCase>& cases() const { return cases_; }
  const std::string& file() const { return words_.file(); }

 private:
  bool read_module();
  bool read_digits(InputCase& read);  ///< \return whether parameters of damping follow
  void read_bodies(InputCase& read, bool reads_damping);
  /// Refuses digits on which depends what follows, where that is not known.
  void require_readable(const InputCase& read, bool is_first) const;
  void read_solver(const InputCase& read);
  void read_friction(InputCase& read, int rows);
  void read_material(InputCase& read);
  void read_potential(InputCase& read);
  void read_geometry(InputCase& read);
  void read_subsurface(const InputCase& read);
  void unpack(InputCase& read, const InputNumber& word, const std::string& letters);
  [[noreturn]] void refuse(const InputCase& read, char digit, std::string_view accepted) const;

  InputWords words_;
  std::vector<InputCase> cases_;
  std::pair<int, int> element_{0, 1};             ///< result element and contact patch
  std::map<std::pair<int, int>, int> last_case_;  ///< of each of them, by index
  bool stays_ = false;                            ///< whether the next case follows without MODULE
};

/// Long names of control digits, for messages: "T (TANG)".
std::string name_of_digit(char digit);

}  // namespace microslip
