// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/patch/rectangle_pressure.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <numbers>

#include "microslip/support/not_converged.hpp"

namespace microslip {

using Eigen::ArrayXXd;
using Eigen::Index;
using std::numbers::pi;

namespace {

constexpr int most_pressure_iterations = 1000;
constexpr double pressure_accuracy = 1e-11;  ///< of pressures, over the largest one

/// The integral of p/R by pressures on a grid.
class NormalDisplacement {
 public:
  explicit NormalDisplacement(const Rectangles& all)
      : convolution_(all.columns(), all.rows()),
        symbol_(convolution_.symbol(RectangleKernels(all, 0).near)) {}

  ArrayXXd operator()(const ArrayXXd& pressure) const {
    RealFft& fft = convolution_.fft();
    fft.values().setZero();
    for (Index k = 0; k < pressure.cols(); ++k) {
      fft.values().segment(convolution_.place(0, k), pressure.rows()) = pressure.col(k);
    }
    fft.forward();
    fft.spectrum().array() *= symbol_.array();
    fft.backward();
    ArrayXXd displacement(pressure.rows(), pressure.cols());
    for (Index k = 0; k < pressure.cols(); ++k) {
      displacement.col(k) = fft.values().segment(convolution_.place(0, k), pressure.rows());
    }
    return displacement;
  }

 private:
  PlaneConvolution convolution_;
  Eigen::VectorXcd symbol_;
};

double sum_where(const Rectangles::Mask& mask, const ArrayXXd& values) {
  return mask.select(values, 0).sum();
}

}  // namespace

RectanglePressure pressure_of_rectangles(double a, double b, Index elements, Index rows) {
  const Rectangles ellipse = Rectangles::in_ellipse(a, b, elements, rows);
  const Rectangles all(ellipse.dx(), ellipse.dy(),
                       Rectangles::Mask::Constant(elements, rows, true));
  const NormalDisplacement displacement(all);
  // Hertz's pressure with the peak 1 makes the integral of p/R a paraboloid.
  using boost::math::ellint_rd, boost::math::ellint_rf;
  const double along = pi * a * b / 3 * ellint_rd(0, b * b, a * a);
  const double across = pi * a * b / 3 * ellint_rd(0, a * a, b * b);
  const double hertz_approach = pi * a * b * ellint_rf(0, a * a, b * b);
  ArrayXXd profile(all.columns(), all.rows()), p = profile;
  for (Index e = 0; e < all.size(); ++e) {
    const double x = all.x(e), y = all.y(e);
    profile(all.column(e), all.row(e)) = along * x * x + across * y * y;
    p(all.column(e), all.row(e)) = std::sqrt(std::max(0.0, 1 - x * x / (a * a) - y * y / (b * b)));
  }
  const double force = 2 * pi / 3 * a * b / all.area();
  p *= force / p.sum();
  ArrayXXd direction = ArrayXXd::Zero(p.rows(), p.cols());
  double former_square = 1;
  bool keeps_direction = false;
  for (int iteration = 1; iteration <= most_pressure_iterations; ++iteration) {
    const Rectangles::Mask touches = p > 0;
    const auto number = static_cast<double>(touches.count());
    ArrayXXd gap = displacement(p) + profile;
    const double approach = sum_where(touches, gap) / number;
    gap -= approach;
    const double square = sum_where(touches, gap.square());
    direction = touches.select(gap + (keeps_direction ? square / former_square : 0) * direction,
                               ArrayXXd::Zero(p.rows(), p.cols()));
    former_square = square;
    ArrayXXd response = displacement(direction);
    response -= sum_where(touches, response) / number;
    const double length = sum_where(touches, gap * direction) /
                          std::max(sum_where(touches, response * direction), 1e-300);
    const ArrayXXd former = p;
    p = (p - length * direction).max(0);
    const Rectangles::Mask overlaps = p <= 0 && gap < 0;
    keeps_direction = !overlaps.any();
    p = overlaps.select(p - length * gap, p);
    p *= force / p.sum();
    if ((p - former).abs().maxCoeff() > pressure_accuracy) continue;
    const Rectangles contact(all.dx(), all.dy(), p > 0);
    Eigen::VectorXd pressure(contact.size());
    for (Index e = 0; e < contact.size(); ++e) pressure[e] = p(contact.column(e), contact.row(e));
    return {contact, pressure, approach / hertz_approach, iteration};
  }
  throw NotConverged("the pressure of rectangles does not converge", most_pressure_iterations,
                     pressure_accuracy);
}

}  // namespace microslip
