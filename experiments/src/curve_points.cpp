// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_points.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/scene/keys.hpp"

namespace microslip::experiments {

double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit * (1 - 1e-12)) * unit;
}

std::vector<double> evenly_spaced(double least, double largest, int points) {
  std::vector<double> values;
  for (int i = 0; i < points; ++i) {
    const double part = static_cast<double>(i) / (points - 1);
    values.push_back(i == points - 1 ? largest : least + part * (largest - least));
  }
  return values;
}

int read_curve_points(Scene& scene) {
  const double points = scene.number("curve.points");
  scene.demand("curve.points", points,
               find_key("curve.points")->range.holds(points) && std::floor(points) == points);
  return static_cast<int>(points);
}

std::vector<std::string> read_laws_beside(Scene& scene) {
  std::vector<std::string> laws;
  for (const std::string& law : scene.words("curve.beside")) {
    if (law == "nothing" || std::ranges::find(laws, law) != laws.end()) continue;
    laws.push_back(law);
  }
  return laws;
}

}  // namespace microslip::experiments
