// SPDX-License-Identifier: GPL-3.0-or-later
// Source of the format: user guide of CONTACT, version of 2025, the appendix on the input file.
#include "input_cases.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip {

namespace {

constexpr const char* first_letters = "PBTNFS";
constexpr const char* second_letters = "VLDCMZE";
constexpr const char* third_letters = "XHGIAOWR";

bool is_one_of(int value, std::initializer_list<int> accepted) {
  return std::ranges::find(accepted, value) != accepted.end();
}

bool rolls(const InputCase& read) { return read['T'] == 2 || read['T'] == 3; }

/// How many elements the potential contact has; 0 if they are not known.
double elements_of(const InputCase& read) {
  return read.potential.size() < 3 ? 0 : read.potential[1].value * read.potential[2].value;
}

}  // namespace

std::string name_of_digit(char digit) {
  static const std::map<char, const char*> names{
      {'P', "PVTIME"}, {'B', "BOUND"},  {'T', "TANG"},   {'N', "NORM"},   {'F', "FORCE"},
      {'S', "STRESS"}, {'V', "VARFRC"}, {'L', "FRCLAW"}, {'D', "DISCNS"}, {'C', "INFLCF"},
      {'M', "MATER"},  {'Z', "RZNORM"}, {'E', "EXRHS"},  {'X', "XFLOW"},  {'H', "HEAT"},
      {'G', "GAUSEI"}, {'I', "IESTIM"}, {'A', "MATFIL"}, {'O', "OUTPUT"}, {'W', "FLOW"},
      {'R', "RETURN"}};
  return fmt::format("{} ({})", digit, names.at(digit));
}

void InputCases::refuse(const InputCase& read, char digit, std::string_view accepted) const {
  refuse_input(file(), read.line_of(digit), name_of_digit(digit), std::to_string(read[digit]),
               accepted);
}

void InputCases::unpack(InputCase& read, const InputNumber& word, const std::string& letters) {
  const double most = std::pow(10, letters.size());
  if (word.value < 0 || word.value >= most) {
    refuse_input(file(), word.line, "control digits " + letters, word.text,
                 fmt::format("a number of at most {} digits", letters.size()));
  }
  int rest = static_cast<int>(word.value);
  for (auto letter = letters.rbegin(); letter != letters.rend(); ++letter) {
    read.digits[*letter] = {rest % 10, word.line};
    rest /= 10;
  }
}

bool InputCases::read_module() {
  const std::vector<InputNumber> module = words_.group("#MODULE [#REID #CPID");
  if (module[0].value == 0) return false;
  if (module[0].value != 3) {
    refuse_input(
        file(), module[0].line, "MODULE", module[0].text,
        "3, the basic contact, or 0 behind the last case; module 1 takes profiles of wheel "
        "and rail, which microslip does not");
  }
  element_ = {module.size() > 1 ? static_cast<int>(module[1].value) : 0,
              module.size() > 2 ? static_cast<int>(module[2].value) : 1};
  return true;
}

bool InputCases::read_digits(InputCase& read) {
  unpack(read, words_.group("#PBTNFS")[0], first_letters);
  read.line = words_.line();
  const std::vector<InputNumber> second = words_.group("#LDCMZE [#M2");
  unpack(read, second[0], second_letters);
  bool reads_damping = false;
  if (second.size() > 1) {
    const int both = static_cast<int>(second[1].value);
    if (both < 0 || both > 22 || both % 10 > 2) {
      refuse_input(file(), second[1].line, "M2", second[1].text, "0, 1 or 2");
    }
    read.gap_weights = {both / 10, second[1].line};
    if (both % 10 != 1) read.damping = {both % 10, second[1].line};
    reads_damping = both % 10 == 2;
  }
  unpack(read, words_.group("#HGIAOWR")[0], third_letters);
  if (read['X'] > 0) words_.group("#PSFLCIN [#READLN");
  return reads_damping;
}

void InputCases::require_readable(const InputCase& read, bool is_first) const {
  if (read['T'] > 3) refuse(read, 'T', "1, a shift, 2, a step of rolling, or 3, steady rolling");
  if (read['N'] > 1) refuse(read, 'N', "0 or 1");
  if (read['F'] > 2) refuse(read, 'F', "0, 1 or 2");
  if (read['S'] > 3) refuse(read, 'S', "0 to 3");
  if (!is_one_of(read['V'], {0, 3})) refuse(read, 'V', "0, one friction coefficient");
  if (is_first && read['L'] == 1) refuse(read, 'L', "0 in the first case");
  if (read['D'] > 2) refuse(read, 'D', "0, 1 or 2");
  if (is_first && read['D'] < 2) refuse(read, 'D', "2 in the first case");
  if (is_first && read['C'] < 2) refuse(read, 'C', "2 or 3 in the first case");
  if (read['Z'] == 0 && read['D'] > 0) refuse(read, 'Z', "1 or 2 with a new potential contact");
  if (read['G'] > 5) refuse(read, 'G', "0 to 5");
  if (read['R'] > 3) refuse(read, 'R', "0 to 3");
}

void InputCases::read_solver(const InputCase& read) {
  const int solver = read['G'];
  if (solver == 1) return;
  words_.group("#MAXGS #MAXIN #MAXNR #MAXOUT EPS");
  if (solver == 2 || solver == 3) words_.group("OMEGAH OMEGAS #INISLP OMGSLP");
  if (solver == 4) words_.group("#INISLP OMGSLP");
  if (solver == 5) words_.group("FDECAY BETATH #KDOWFB D_IFC D_LIN D_CNS D_SLP POW_S");
}

void InputCases::read_friction(InputCase& read, int rows) {
  const int law = read['L'];
  const auto names = [&]() -> const char* {
    switch (law) {
      case 0:
        return "FSTAT FKIN";
      case 2:
        return "FKIN FLIN1 SABSH1 FLIN2 SABSH2";
      case 3:
        return "FKIN FRAT1 SABSH1 FRAT2 SABSH2";
      case 4:
        return "FKIN FEXP1 SABSH1 FEXP2 SABSH2";
      case 6:
        return "FREF TREF DFHEAT DTHEAT";
      default:
        refuse(read, 'L', "0, Coulomb's friction with FSTAT = FKIN");
    }
  }();
  for (int row = 0; row < rows; ++row) read.friction = words_.group(names);
  if (law != 0) words_.group("MEMDST MEM_S0");
}

void InputCases::read_material(InputCase& read) {
  const int influence = read['C'];
  if (!is_one_of(influence, {2, 3, 4, 9})) refuse(read, 'C', "2 or 3, elastic half-spaces");
  if (rolls(read)) read.rolling = words_.group("<CHI DQ VELOC [FACPHI");
  if (influence == 4) {
    const std::vector<InputNumber> angles = words_.group("#IF_METH #VARIANT #NN");
    words_.skip("ALPHA", 2 * angles[2].value);
  }
  if (influence == 9) words_.skip("CFNAME", 1);
  read.material = words_.group("POISS1 POISS2 GG1 GG2");
  if (read['B'] == 1) words_.group("FLXZ");
  switch (read['M']) {
    case 1:
      words_.group("FG1 FG2 TC1 TC2");
      break;
    case 2:
      words_.group("FLX K0_MF ALFAMF BETAMF");
      break;
    case 3:
    case 5:
      words_.group("K0_MF ALFAMF BETAMF");
      break;
    case 4:
      words_.group("GG3 LAYTHK TAU_C0 K_TAU");
      break;
    case 0:
    case 6:
    case 7:
      break;
    default:
      refuse(read, 'M', "0, elastic bodies");
  }
}

void InputCases::read_potential(InputCase& read) {
  const InputNumber kind = words_.group("#IPOTCN")[0];
  const auto names = [&]() -> const char* {
    switch (static_cast<int>(kind.value)) {
      case -1:
        return "#MX #MY A1 B1 SCALE";
      case -2:
        return "#MX #MY A1 AOB SCALE";
      case -3:
        return "#MX #MY AA BB SCALE";
      case -4:
        return "#MX #MY A1 BB SCALE";
      case -5:
        return "#MX #MY AA BB SCALE";
      case -6:
        return "#MX #MY AA BNEG BPOS SCALE";
      case 1:
        return "#MX #MY XL YL DX DY";
      case 2:
        return "#MX #MY XL YL XH YH";
      case 3:
        return "#MX #MY XC1 YC1 DX DY";
      case 4:
        return "#MX #MY XC1 YC1 XCM YCM";
      default:
        refuse_input(file(), kind.line, "IPOTCN", kind.text,
                     "-1 to -5, Hertz's contact, or 1 to 4, a potential contact");
    }
  }();
  read.potential = {kind};
  for (const InputNumber& number : words_.group(names)) read.potential.push_back(number);
  if (kind.value < 0) read.geometry.clear();
}

void InputCases::read_geometry(InputCase& read) {
  read.geometry = words_.group("#IBASE #IPLAN");
  const auto add = [&](const std::vector<InputNumber>& numbers) {
    read.geometry.insert(read.geometry.end(), numbers.begin(), numbers.end());
  };
  const InputNumber base = read.geometry[0], planform = read.geometry[1];
  switch (static_cast<int>(base.value)) {
    case 1:
      add(words_.numbers("B1 to B6", 6));
      break;
    case 2: {
      const std::vector<InputNumber> circles = words_.group("#NN XM RM Y1 DY1");
      words_.skip("B(1) to B(NN)", circles[0].value);
      break;
    }
    case 3:
      add(words_.numbers("B1 to B8", 8));
      break;
    case 9:
      words_.skip("H of each element", elements_of(read));
      break;
    default:
      refuse_input(file(), base.line, "IBASE", base.text, "1, a quadratic distance");
  }
  switch (static_cast<int>(planform.value)) {
    case 1:
      break;
    case 2:
      words_.skip("PL1 to PL6", 6);
      break;
    case 3:
      words_.skip("XL1 to YH2", 8);
      break;
    case 4: {
      const double patches = std::clamp(words_.group("#NPATCH")[0].value, 1.0, 100.0);
      words_.skip("XL, XH, YL, YH", 4 * patches);
      words_.skip("FAC", patches * (patches - 1) / 2);
      break;
    }
    default:
      refuse_input(file(), planform.line, "IPLAN", planform.text, "1, without a planform");
  }
}

void InputCases::read_subsurface(const InputCase& read) {
  if (read['S'] < 2) return;
  words_.group("#MATFIL #OUTPUT");
  if (read['S'] == 2) return;
  const auto skip_all = [&](const std::vector<InputNumber>& counts) {
    for (const InputNumber& count : counts) words_.skip("points below the surface", count.value);
  };
  for (;;) {
    const InputNumber kind = words_.group("#ISUBS")[0];
    if (kind.value <= 0) return;
    const int points = static_cast<int>(kind.value);
    if (!is_one_of(points, {1, 2, 3, 5, 6, 7, 9})) {
      refuse_input(file(), kind.line, "ISUBS", kind.text, "1, 2, 3, 5, 6, 7 or 9");
    }
    if (points == 9) {
      skip_all(words_.group("#NX #NY #NZ"));
      continue;
    }
    if (is_one_of(points, {2, 6})) {
      words_.group("#IXL #IXINC #IXH");
      words_.group("#IYL #IYINC #IYH");
    }
    if (is_one_of(points, {3, 7})) skip_all(words_.group("#NX #NY"));
    if (points <= 3) {
      words_.group("#NZ ZL DZ");
    } else {
      skip_all(words_.group("#NZ"));
    }
  }
}

void InputCases::read_bodies(InputCase& read, bool reads_damping) {
  if (read['L'] != 1 && read['V'] == 0) read_friction(read, 1);
  if (read['C'] > 1) read_material(read);
  if (reads_damping) words_.group("CDAMPN CDAMPT DFNMAX DFTMAX");
  if (read['H'] == 3) {
    for (int body = 0; body < 2; ++body) words_.group("BKTEMP HEATCP LAMBDA DENS");
    if (read['M'] == 4) words_.group("BETAPL");
  }
}

bool InputCases::next() {
  if (!stays_ && !read_module()) return false;
  InputCase read;
  const auto last = last_case_.find(element_);
  if (last != last_case_.end()) {
    read = cases_[static_cast<std::size_t>(last->second)];
    read.previous = last->second;
  }
  const std::map<char, InputDigit> before = read.digits;
  read.number = static_cast<int>(cases_.size()) + 1;
  const bool reads_damping = read_digits(read);
  require_readable(read, before.empty());
  read_solver(read);
  constexpr std::array kinematics{"CKSI CETA", "FX CETA", "FX FY"};
  read.kinematics =
      words_.group(fmt::format("{} {} CPHI [SPINXO SPINYO", read['N'] == 1 ? "FN" : "PEN",
                               kinematics[static_cast<std::size_t>(read['F'])]));
  read_bodies(read, reads_damping);
  if (read['D'] == 2) read_potential(read);
  if (read['D'] > 0) {
    read.formed_norm = read['N'];
    read.formed_load = read.kinematics[0];
    read.formed_material = read.material;
  }
  if (read['Z'] > 1 && read.potential[0].value > 0) read_geometry(read);
  if (read['L'] != 1 && read['V'] == 3)
    read_friction(read, static_cast<int>(read.potential[2].value));
  if (read['E'] == 9) words_.skip("EXRHS", 2 * elements_of(read));
  read_subsurface(read);
  stays_ = read['R'] == 0 || read['R'] == 2;

  const auto keep = [&](char digit) {
    const auto found = before.find(digit);
    if (found != before.end()) read.digits[digit] = found->second;
  };
  if (read['L'] == 1) keep('L');
  if (read['C'] < 2) keep('C');
  if (read['E'] == 1) keep('E');
  last_case_[element_] = read.number - 1;
  cases_.push_back(std::move(read));
  return true;
}

void InputCases::require_more() { words_.group(stays_ ? "#PBTNFS" : "#MODULE"); }

}  // namespace microslip
