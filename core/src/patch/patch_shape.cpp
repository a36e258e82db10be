// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/patch_shape.hpp"

#include <fmt/core.h>
#include <math.h>  // Boost 1.74 has isnan without std in pchip.hpp

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "microslip/support/format.hpp"
#include "microslip/support/gauss_points.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// Nodes of a function of sin(psi).
struct Nodes {
  std::vector<double> places, values;
};

/// A monotone cubic function through nodes. Boost's takes four or more, so that few ones get nodes
/// halfway.
std::function<double(double)> through(Nodes nodes) {
  while (nodes.places.size() < 4) {
    Nodes finer;
    for (std::size_t j = 0; j < nodes.places.size(); ++j) {
      if (j > 0) {
        finer.places.push_back((nodes.places[j - 1] + nodes.places[j]) / 2);
        finer.values.push_back((nodes.values[j - 1] + nodes.values[j]) / 2);
      }
      finer.places.push_back(nodes.places[j]);
      finer.values.push_back(nodes.values[j]);
    }
    nodes = finer;
  }
  const double first = nodes.places.front(), last = nodes.places.back();
  const boost::math::interpolators::pchip<std::vector<double>> cubic(std::move(nodes.places),
                                                                     std::move(nodes.values));
  return [=](double at) { return cubic(std::clamp(at, first, last)); };
}

/// The value at a closed end, where A is 0/0, on the line through its two neighbours; at most twice,
/// and at least half the nearer one.
double at_closed_end(double end, double near, double value, double far, double far_value) {
  if (near == far) return value;
  const double extended = value + (value - far_value) * (end - near) / (near - far);
  return std::clamp(extended, value / 2, 2 * value);
}

void require_row(bool accepted, Index row, const char* name, double value, const char* expected) {
  require(accepted, fmt::format("row {}: {}", row + 1, name), value, expected);
}

void require_edges(const VectorXd& y, const VectorXd& trailing, const VectorXd& leading) {
  const Index rows = y.size();
  require(trailing.size() == rows && leading.size() == rows, "number of rows",
          static_cast<double>(rows), "as many values of y, trailing and leading");
  require(rows >= 2, "number of rows", static_cast<double>(rows), "two or more in each lobe");
  for (Index j = 0; j < rows; ++j) {
    constexpr double largest = 1e50;
    for (const auto& [name, value] :
         {std::pair("y", y[j]), {"trailing", trailing[j]}, {"leading", leading[j]}}) {
      require_row(std::abs(value) <= largest, j, name, value, "a number of at most 1e50 mm");
    }
    require_row(j == 0 || y[j] > y[j - 1], j, "y", y[j], "more than in the row before");
    const bool is_end = j == 0 || j == rows - 1;
    require_row(leading[j] > trailing[j] || (is_end && leading[j] == trailing[j]), j, "leading",
                leading[j],
                is_end ? "not less than trailing" : "more than trailing, except at an end in y");
  }
  const bool is_closed = leading[0] == trailing[0] && leading[rows - 1] == trailing[rows - 1];
  require(rows > 2 || !is_closed, "number of rows", static_cast<double>(rows),
          "three or more in a lobe whose edges meet at both ends");
}

}  // namespace

Lobe Lobe::ellipse(double half_width, double lateral_half_width) {
  require_positive("half_width", half_width);
  require_positive("lateral_half_width", lateral_half_width);
  Lobe lobe;
  lobe.height_ = lateral_half_width;
  lobe.middle_of_ = [](double) { return 0.0; };
  lobe.widening_ = [half_width](double) { return half_width; };
  return lobe;
}

Lobe::Lobe(const VectorXd& y, const VectorXd& trailing, const VectorXd& leading) {
  require_edges(y, trailing, leading);
  const Index last = y.size() - 1;
  middle_ = (y[0] + y[last]) / 2;
  height_ = (y[last] - y[0]) / 2;
  require_positive("distance of the ends in y", height_);
  closed_low_ = leading[0] == trailing[0];
  closed_high_ = leading[last] == trailing[last];
  const auto place = [&](Index j) {
    return j == 0 ? -1 : j == last ? 1 : std::clamp((y[j] - middle_) / height_, -1.0, 1.0);
  };
  const auto value = [&](Index j) {
    return (leading[j] - trailing[j]) / 2 / narrowing(std::asin(place(j)));
  };
  const Index first_open = closed_low_ ? 1 : 0, last_open = closed_high_ ? last - 1 : last;
  Nodes middles, widenings;
  for (Index j = 0; j <= last; ++j) {
    middles.places.push_back(place(j));
    middles.values.push_back((leading[j] + trailing[j]) / 2);
    widenings.places.push_back(place(j));
    const Index open = std::clamp(j, first_open, last_open);
    const Index next =
        open == last_open ? std::max(open - 1, first_open) : std::min(open + 1, last_open);
    widenings.values.push_back(
        open == j ? value(j)
                  : at_closed_end(place(j), place(open), value(open), place(next), value(next)));
  }
  middle_of_ = through(std::move(middles));
  widening_ = through(std::move(widenings));
}

double Lobe::narrowing(double psi) const {
  if (closed_low_ && closed_high_) return std::cos(psi);
  if (closed_low_) return std::numbers::sqrt2 * std::sin(psi / 2 + pi / 4);
  if (closed_high_) return std::numbers::sqrt2 * std::cos(psi / 2 + pi / 4);
  return 1;
}

double Lobe::y(double psi) const { return middle_ + height_ * std::sin(psi); }

double Lobe::psi(double y) const {
  return std::asin(std::clamp((y - middle_) / height_, -1.0, 1.0));
}

Lobe::Row Lobe::row(double psi) const {
  const double place = std::sin(psi);
  return {scale_ * middle_of_(place), scale_ * narrowing(psi) * widening_(place)};
}

double Lobe::integral(double from, double to, const std::function<double(double)>& of) const {
  double sum = 0;
  for_gauss_points<10>(from, to, [&](double psi, double weight) {
    sum += weight * height_ * std::cos(psi) * of(psi);
  });
  return sum;
}

namespace {

/// Parts of a lobe's height, and of a row, over which a whole shape is integrated.
constexpr int panels = 24;

}  // namespace

double Lobe::area() const {
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    sum += integral(pi * i / panels - pi / 2, pi * (i + 1) / panels - pi / 2,
                    [&](double psi) { return 2 * row(psi).half_length; });
  }
  return sum;
}

Lobe Lobe::scaled(double factor) const {
  Lobe lobe = *this;
  lobe.middle_ *= factor;
  lobe.height_ *= factor;
  lobe.scale_ *= factor;
  return lobe;
}

Lobe Lobe::turned() const {
  Lobe lobe = *this;
  lobe.middle_of_ = [of = middle_of_](double sine) { return 0 - of(sine); };
  return lobe;
}

namespace {

/// Places at which lobes are compared.
constexpr int samples = 200;

/// Requires that no row of one lobe has a part of a row of the other one.
void require_apart(const Lobe& one, const Lobe& other) {
  const double low = std::max(one.low(), other.low()), high = std::min(one.high(), other.high());
  for (int i = 1; i < samples && low < high; ++i) {
    const double y = low + (high - low) * i / samples;
    const Lobe::Row first = one.row(one.psi(y)), second = other.row(other.psi(y));
    const double lengths = first.half_length + second.half_length;
    if (std::abs(first.middle - second.middle) >= (1 - 1e-9) * lengths) continue;
    throw std::invalid_argument(fmt::format(
        "two lobes overlap at y = {} mm: expected lobes that are apart", format_short(y)));
  }
}

}  // namespace

PatchShape::PatchShape(std::vector<Lobe> lobes) : lobes_(std::move(lobes)) {
  if (lobes_.empty()) throw std::invalid_argument("expected a lobe or more");
  for (std::size_t i = 0; i < lobes_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) require_apart(lobes_[i], lobes_[j]);
  }
  trailing_ = std::numeric_limits<double>::infinity();
  leading_ = -trailing_;
  for (const Lobe& lobe : lobes_) {
    area_ += lobe.area();
    for (int i = 0; i <= samples; ++i) {
      const Lobe::Row row = lobe.row(pi * i / samples - pi / 2);
      trailing_ = std::min(trailing_, row.middle - row.half_length);
      leading_ = std::max(leading_, row.middle + row.half_length);
    }
  }
}

PatchShape PatchShape::ellipse(double half_width, double lateral_half_width) {
  PatchShape shape({Lobe::ellipse(half_width, lateral_half_width)});
  shape.is_ellipse_ = true;
  shape.area_ = pi * half_width * lateral_half_width;
  return shape;
}

double PatchShape::size() const { return std::sqrt(area_ / pi); }

double PatchShape::ratio() const {
  double sum = 0;
  for (const Lobe& lobe : lobes_) {
    const double area = lobe.area();
    sum += area * area / (pi * lobe.height() * lobe.height());
  }
  return sum / area_;
}

double PatchShape::low() const { return std::ranges::min_element(lobes_, {}, &Lobe::low)->low(); }

double PatchShape::high() const {
  return std::ranges::max_element(lobes_, {}, &Lobe::high)->high();
}

PatchShape PatchShape::scaled(double factor) const {
  PatchShape shape = *this;
  for (Lobe& lobe : shape.lobes_) lobe = lobe.scaled(factor);
  shape.area_ *= factor * factor;
  shape.trailing_ *= factor;
  shape.leading_ *= factor;
  return shape;
}

PatchShape PatchShape::turned() const {
  PatchShape shape = *this;
  for (Lobe& lobe : shape.lobes_) lobe = lobe.turned();
  shape.trailing_ = -leading_;
  shape.leading_ = -trailing_;
  return shape;
}

double integral_over(const PatchShape& shape,
                     const std::function<double(std::size_t, double, double)>& of) {
  double sum = 0;
  for (std::size_t l = 0; l < shape.lobes().size(); ++l) {
    const Lobe& lobe = shape.lobes()[l];
    for (int i = 0; i < panels; ++i) {
      for_gauss_points<6>(
          pi * i / panels - pi / 2, pi * (i + 1) / panels - pi / 2, [&](double psi, double of_row) {
            const double breadth =
                of_row * lobe.height() * std::cos(psi) * lobe.row(psi).half_length;
            for (int j = 0; j < panels; ++j) {
              for_gauss_points<6>(pi * j / panels, pi * (j + 1) / panels,
                                  [&](double theta, double of_cell) {
                                    sum += breadth * of_cell * std::sin(theta) * of(l, psi, theta);
                                  });
            }
          });
    }
  }
  return sum;
}

}  // namespace microslip
