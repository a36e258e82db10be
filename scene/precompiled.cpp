// SPDX-License-Identifier: GPL-3.0-or-later
// This source stands for the headers of those who read scenes: see microslip_precompile() in CMakeLists.txt.
