// SPDX-License-Identifier: GPL-3.0-or-later
// Headers that most sources include, compiled once. No source relies on them: each includes what it
// uses, and builds with MICROSLIP_PRECOMPILE=OFF.
#pragma once

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "../core/src/linalg/dense_kernels.hpp"
