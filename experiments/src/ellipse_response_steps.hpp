// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "microslip/experiments/ellipse_response.hpp"

namespace microslip::experiments::ellipse_response_study {

/// Numbers of runs of steps_table().
std::size_t runs_of_steps(const EllipseResponseParameters& parameters);

/// Errors of transient schemes on a circle, which roll under small waves of one creepage or of spin,
/// against the response of the reference.
/// \param advance  is called after each run
Table steps_table(const EllipseResponseParameters& parameters,
                  const std::function<void()>& advance);

}  // namespace microslip::experiments::ellipse_response_study
