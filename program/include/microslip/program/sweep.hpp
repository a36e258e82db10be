// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/program/run.hpp"

namespace microslip::program {

/// \file
/// Many scenes in one, for a program whose tables include `summary` with columns quantity, value
/// and unit. In both, argv[1] is the word that chose them.

/// Solves all cases of a scene with a section `sweep` (see Sweep), or a shard of them, on several
/// threads. Each is written when it is done, and cases that are there already are left out, so that
/// an interrupted sweep goes on. All scenes are read before the first is solved. Ends with merge
/// unless a shard was asked for. The files do not depend on threads, shards and interrupts.
/// Returns the exit status: 0; 1 for bad input or a failed write, 2 if a case has no solution, both
/// with one line on stderr. SIGINT, SIGTERM and SIGHUP end it between two files with
/// 130, 143 and 129.
int sweep(const Program& program, int argc, const char* const* argv);

/// Puts the rows of all cases of a sweep into one table, sweep.tsv. Returns the exit status: 0; 1,
/// and nothing is written, if cases are missing; 2 if a case has no solution.
int merge(const Program& program, int argc, const char* const* argv);

}  // namespace microslip::program
