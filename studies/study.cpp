// SPDX-License-Identifier: GPL-3.0-or-later
// The headers of the studies, compiled once: see microslip_precompile() in CMakeLists.txt.
