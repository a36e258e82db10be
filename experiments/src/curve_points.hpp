// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "microslip/scene/scene.hpp"

namespace microslip::experiments {

/// Rounds a number above zero up to two digits.
double rounded_up(double value);

/// \param points  >= 2
std::vector<double> evenly_spaced(double least, double largest, int points);

/// Reads curve.points.
int read_curve_points(Scene& scene);

/// Reads curve.beside: the laws whose curves are wanted, each once.
std::vector<std::string> read_laws_beside(Scene& scene);

}  // namespace microslip::experiments
