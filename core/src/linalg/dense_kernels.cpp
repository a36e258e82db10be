// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense_kernels.hpp"

MICROSLIP_DENSE_KERNELS()
