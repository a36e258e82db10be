// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// This executable takes the place of the C library's malloc and its relatives, where operator new,
// Eigen and FFTW end up, too.

// By functions: a compiler takes it that malloc changes no variable.
long allocations();                 ///< so far
void fail_allocation(long number);  ///< that one; 0 for none
