// SPDX-License-Identifier: GPL-3.0-or-later
// Hertz's contacts of an input file of CONTACT.
#include "input_contact.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "microslip/reference/line_contact.hpp"
#include "microslip/reference/point_contact.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"

namespace microslip {

namespace {

using std::numbers::pi;

constexpr double least_elements = 3;  ///< across a contact, below which none is resolved

/// Width over half-width, below which the pressure of a row of elements differs from that of a line
/// contact: by the next term of the kernel's series its half-width is (a/width)^2/2 smaller, 0.8 %.
constexpr double least_row = 8;

double stiffness_of(const Material& material) {
  return material.shear_modulus / (1 - material.poisson_ratio);
}

/// The approach of both bodies over the peak pressure, of an ellipse. K. L. Johnson, Contact
/// Mechanics, 1985, (4.26).
double approach_by_pressure(const Material& material, double a, double b) {
  const double shorter = std::min(a, b), k = shorter / std::max(a, b);
  return shorter * boost::math::ellint_1(std::sqrt(1 - k * k)) / stiffness_of(material);
}

/// The curvature across the rolling over that along it, by the ratio of semi-axes. Source: as
/// PointContact.
double ratio_of_curvatures(double a_over_b) {
  const double k = std::min(a_over_b, 1 / a_over_b);
  const double ratio = boost::math::ellint_rd(0.0, k * k, 1.0) /
                       boost::math::ellint_rd(0.0, 1.0, k * k);  // of the flatter direction
  return a_over_b <= 1 ? ratio : 1 / ratio;
}

/// The potential contact: the least x and y, and the sizes of elements.
struct PotentialContact {
  double x = 0, y = 0, dx = 0, dy = 0;
};

/// Reads the contact of one case.
class InputContactReader {
 public:
  InputContactReader(const InputCase& read, const std::string& file) : read_(read), file_(file) {}

  InputContact contact() {
    read_bodies();
    read_load();
    if (kind() < 0) {
      require_as_formed();
      read_hertz();
    } else {
      read_quadratic();
    }
    return contact_;
  }

 private:
  int kind() const { return static_cast<int>(read_.potential[0].value); }
  const InputNumber& size(std::size_t k) const { return read_.potential[1 + k]; }
  double mx() const { return size(0).value; }
  double my() const { return size(1).value; }

  void require(bool is_accepted, const InputNumber& number, std::string_view name,
               std::string_view accepted) const {
    require_input(is_accepted, file_, number, name, accepted);
  }

  void require_above_zero(const InputNumber& number, std::string_view name) const {
    require(number.value > 0, number, name, "a number > 0");
  }

  void read_bodies() {
    const std::vector<InputNumber>& of = read_.material;
    for (std::size_t body : {0U, 1U}) {
      require(of[body].value >= 0 && of[body].value <= 0.5, of[body],
              body == 0 ? "POISS1" : "POISS2", "a number from 0 to 0.5");
      require_above_zero(of[2 + body], body == 0 ? "GG1" : "GG2");
    }
    const double nu_1 = of[0].value, nu_2 = of[1].value, g_1 = of[2].value, g_2 = of[3].value;
    const double g = 2 / (1 / g_1 + 1 / g_2);
    contact_.material = {g, g * (nu_1 / g_1 + nu_2 / g_2) / 2};
    const double difference = g / 4 * ((1 - 2 * nu_1) / g_1 - (1 - 2 * nu_2) / g_2);
    constexpr double most = 1e-4;  // below which CONTACT neglects it
    if (std::abs(difference) >= most) {
      refuse_input(file_, of[0].line, "K of POISS and GG", format_roughly(difference),
                   "quasi-identical bodies, as equal ones are: |K| < 1e-4");
    }
    require_above_zero(read_.friction[0], "FSTAT");
    require(std::abs(read_.friction[1].value / read_.friction[0].value - 1) <= 1e-3,
            read_.friction[1], "FKIN", "FSTAT, " + read_.friction[0].text);
    contact_.friction = read_.friction[0].value;
  }

  void read_load() {
    require_above_zero(read_.kinematics[0], read_['N'] == 1 ? "FN" : "PEN");
    if (read_['N'] == 1) contact_.load = read_.kinematics[0].value;
    require(mx() >= 1, size(0), "MX", "a whole number > 0");
    require(my() >= 1, size(1), "MY", "a whole number > 0");
  }

  /// Refuses another load or material than those with which the potential contact was formed that
  /// the case keeps: it is too small or too large then, and so are curvatures by semi-axes.
  void require_as_formed() const {
    if (read_['D'] > 0) return;
    const InputNumber& load = read_.kinematics[0];
    const char* name = read_['N'] == 1 ? "FN" : "PEN";
    const std::string accepted =
        read_.formed_load.text + " as before, or D = 2, a new potential contact";
    require(read_['N'] == read_.formed_norm && load.value == read_.formed_load.value, load, name,
            accepted);
    constexpr std::array names{"POISS1", "POISS2", "GG1", "GG2"};
    for (std::size_t k = 0; k < names.size(); ++k) {
      const InputNumber &now = read_.material[k], &then = read_.formed_material[k];
      require(now.value == then.value, now, names[k],
              then.text + " as before, or D = 2, a new potential contact");
    }
  }

  /// Sets the semi-axes by the curvatures, and the load by the approach.
  void set_radii(double along, double across) {
    contact_.radius = 1 / along;
    contact_.lateral_radius = 1 / across;
    if (read_['N'] == 0) {
      const PointContact unit(contact_.material, 1, along, across);
      const double approach =
          unit.peak_pressure() *
          approach_by_pressure(contact_.material, unit.half_width(), unit.lateral_half_width());
      contact_.load = std::pow(read_.kinematics[0].value / approach, 1.5);
    }
    const PointContact found(contact_.material, contact_.load, along, across);
    contact_.half_width = found.half_width();
    contact_.lateral = found.lateral_half_width();
  }

  void set_semi_axes(double a, double b) {
    contact_.half_width = a;
    contact_.lateral = b;
    if (read_['N'] == 1) return;
    contact_.load = read_.kinematics[0].value / approach_by_pressure(contact_.material, a, b) * 2 *
                    pi * a * b / 3;
  }

  void require_row_digits() const {
    if (read_['C'] != 2) {
      refuse_input(file_, read_.line_of('C'), name_of_digit('C'), std::to_string(read_['C']),
                   "2 for one row of elements, MY = 1");
    }
    if (read_['N'] == 1) return;
    refuse_input(file_, read_.line_of('N'), name_of_digit('N'), "0",
                 "1, FN, for one row of elements, MY = 1");
  }

  /// IPOTCN = -1 to -5.
  void read_hertz() {
    const InputNumber &first = size(2), &second = size(3), &scale = size(4);
    const bool is_row = kind() == -4 || kind() == -5;
    require(kind() != -6, read_.potential[0], "IPOTCN",
            "-1, -2 or -3, an ellipse, -4 or -5, a line contact with MY = 1, or 1 to 4");
    const bool by_curvature = kind() != -3 && kind() != -5;
    require_above_zero(first, by_curvature ? "A1" : "AA");
    require_above_zero(second, kind() == -1 ? "B1" : kind() == -2 ? "AOB" : "BB");
    require(scale.value > 1 - 1e-9, scale, "SCALE", "1 or more");
    const double along = 2 * first.value;  // of a body that is a quadratic distance
    if (is_row) {
      require(
          my() == 1, size(1), "MY",
          "1 with IPOTCN = -4 or -5: microslip has one row of elements, with the same tractions "
          "over the width");
      require_row_digits();
      set_row(by_curvature ? along : 0, first.value, 2 * second.value);
    } else if (kind() == -3) {
      set_semi_axes(first.value, second.value);
    } else {
      set_radii(along, kind() == -1 ? 2 * second.value : along * ratio_of_curvatures(second.value));
    }
    const double a = contact_.half_width, b = contact_.lateral, part = scale.value;
    set_elements({-part * a, -part * b, 2 * part * a / mx(), 2 * part * b / my()});
  }

  /// \param along  the curvature; 0 if the half-width is given
  void set_row(double along, double half_width, double width) {
    contact_.is_ellipse = false;
    contact_.lateral = width / 2;
    contact_.half_width = half_width;
    if (along > 0) {
      contact_.radius = 1 / along;
      contact_.half_width =
          LineContact(contact_.material, contact_.load / width, along).half_width();
    }
    const double least = least_row * contact_.half_width;
    require(width >= least, size(kind() < 0 ? 3 : 5),
            kind() < 0    ? "BB"
            : kind() == 2 ? "YH"
                          : "DY",
            fmt::format("a width of {} mm or more, 8 half-widths, for a line contact",
                        format_roughly(least)));
  }

  PotentialContact potential() const {
    const double x = size(2).value, y = size(3).value;
    if (kind() == 1 || kind() == 3) {
      require_above_zero(size(4), "DX");
      require_above_zero(size(5), "DY");
      const double dx = size(4).value, dy = size(5).value, shift = kind() == 3 ? 0.5 : 0;
      return {x - shift * dx, y - shift * dy, dx, dy};
    }
    const bool to_sides = kind() == 2;
    require(size(4).value > x, size(4), to_sides ? "XH" : "XCM", "more than the least x");
    require(size(5).value > y || (my() == 1 && !to_sides), size(5), to_sides ? "YH" : "YCM",
            "more than the least y");
    if (to_sides) return {x, y, (size(4).value - x) / mx(), (size(5).value - y) / my()};
    require(mx() > 1, size(0), "MX", "2 or more with IPOTCN = 4");
    require(my() > 1, size(1), "MY", "2 or more with IPOTCN = 4, which gives no width to one row");
    const double dx = (size(4).value - x) / (mx() - 1), dy = (size(5).value - y) / (my() - 1);
    return {x - dx / 2, y - dy / 2, dx, dy};
  }

  /// IPOTCN = 1 to 4, with a quadratic distance.
  void read_quadratic() {
    const std::vector<InputNumber>& of = read_.geometry;
    if (of.empty()) {
      refuse_input(file_, read_.line_of('Z'), name_of_digit('Z'), std::to_string(read_['Z']),
                   "2 with a new potential contact");
    }
    require(of[0].value == 1, of[0], "IBASE", "1, a quadratic distance");
    require(of[1].value == 1, of[1], "IPLAN", "1, without a planform");
    constexpr const char* names[] = {"B1", "B2", "B3", "B4", "B5", "B6"};
    for (const std::size_t k : {1U, 3U, 4U, 5U}) {
      require(of[2 + k].value == 0, of[2 + k], names[k], "0: a contact about x = y = 0");
    }
    require_above_zero(of[2], "B1");
    const PotentialContact in = potential();
    if (my() == 1) {
      require(of[4].value == 0, of[4], "B3", "0 with one row of elements, MY = 1");
      require_row_digits();
      set_row(2 * of[2].value, 0, in.dy);
      set_elements({in.x, -in.dy / 2, in.dx, in.dy});
    } else {
      require(of[4].value > 0, of[4], "B3", "a number > 0: an ellipse, or MY = 1, a line contact");
      set_radii(2 * of[2].value, 2 * of[4].value);
      set_elements(in);
    }
    require_inside(in);
  }

  /// Refuses a potential contact that does not hold the contact.
  void require_inside(const PotentialContact& in) const {
    constexpr double part = 0.1;  // of an element
    const double a = contact_.half_width + part * -in.dx, b = contact_.lateral + part * -in.dy;
    require(in.x <= -a && in.x + mx() * in.dx >= a, size(2), "XL or XC1",
            fmt::format("a potential contact around |x| <= {}, which is Hertz's half-width",
                        format_roughly(contact_.half_width)));
    if (!contact_.is_ellipse) return;
    require(in.y <= -b && in.y + my() * in.dy >= b, size(3), "YL or YC1",
            fmt::format("a potential contact around |y| <= {}, which is Hertz's half-width",
                        format_roughly(contact_.lateral)));
  }

  void set_elements(const PotentialContact& in) {
    const auto is_whole = [](double count) { return std::abs(count - std::round(count)) < 1e-3; };
    contact_.elements = 2 * contact_.half_width / in.dx;
    contact_.rows = contact_.is_ellipse ? 2 * contact_.lateral / in.dy : 1;
    require(std::round(contact_.elements) >= least_elements, size(0), "MX",
            "3 or more elements in the length of the contact");
    require(!contact_.is_ellipse || std::round(contact_.rows) >= least_elements, size(1), "MY",
            "3 or more elements in the width of an ellipse");
    contact_.fits = is_whole(contact_.elements) && is_whole(contact_.rows) &&
                    is_whole((-contact_.half_width - in.x) / in.dx) &&
                    (!contact_.is_ellipse || is_whole((-contact_.lateral - in.y) / in.dy));
  }

  const InputCase& read_;
  const std::string& file_;
  InputContact contact_;
};

}  // namespace

void require_input(bool is_accepted, const std::string& file, const InputNumber& number,
                   std::string_view name, std::string_view accepted) {
  if (!is_accepted) refuse_input(file, number.line, name, number.text, accepted);
}

InputContact contact_of_input(const InputCase& read, const std::string& file) {
  try {
    return InputContactReader(read, file).contact();
  } catch (const BadParameter& error) {  // of Hertz's formulas
    throw std::invalid_argument(fmt::format("{}:{}: case {} has no contact by Hertz: {}",
                                            shown(file), read.kinematics[0].line, read.number,
                                            error.what()));
  }
}

}  // namespace microslip
