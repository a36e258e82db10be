// SPDX-License-Identifier: GPL-3.0-or-later
// The headers of those who read scenes, compiled once: see microslip_precompile() in CMakeLists.txt.
