// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "microslip/scene/table.hpp"

namespace microslip::experiments {

/// The table `lines`: line contacts in the place of ellipses, with their half-width along the
/// rolling, the same full sliding, and the width pi b/2, which has the ellipse's area.
/// \param aspects  a/b
/// \param advance  called for each aspect
Table line_contacts_table(const std::vector<double>& aspects, double poisson_ratio,
                          const std::function<void()>& advance);

}  // namespace microslip::experiments
