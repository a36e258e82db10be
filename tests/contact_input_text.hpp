// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

// Input files in the format of CONTACT, made for these tests.

namespace microslip {

/// A text in which the first `from` is `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("not there: " + from);
  return text.replace(at, from.size(), to);
}

/// A case of steady rolling, one group a line: lines 2 to 12.
inline const std::string good_case = R"( 3  MODULE   % a comment
 203100    P-B-T-N-F-S   PVTIME, BOUND, TANG, NORM, FORCE, STRESS
 022020    L-D-C-M-Z-E
 0000541   H-G-I-A-O-W-R
  999 100 30 1 1d-6          MAXGS, MAXIN, MAXNR, MAXOUT, EPS
  1.0  0.07  0.02  -0.01     FN, CKSI, CETA, CPHI
  0.3  0.3                   FSTAT, FKIN
  0.0  0.1  1000.            CHI, DQ, VELOC
  0.28 0.28 1.0 1.0          POISS, GG
  -3                         IPOTCN
  20 20  1.0 2.0 1.0         MX, MY, AA, BB, SCALE
)";
inline const std::string good_end = " 0  MODULE\n";
inline const std::string good_input = "% a file\n" + good_case + good_end;

/// One row of elements, by a quadratic distance: lines 2 to 14.
inline const std::string good_row = "% a file\n" +
                                    good_case.substr(0, good_case.find("  1.0  0.07")) +
                                    R"( 1789. 0.001 0. 0.          FN, CKSI, CETA, CPHI
  0.3 0.3
  0.0 0.04 1000.
  0.28 0.28 82000. 82000.
  1                          IPOTCN
  60 1 -1.2 -5. 0.04 10.     MX, MY, XL, YL, DX, DY
  1 1                        IBASE, IPLAN
  0.001 0 0 0 0 0            B1 to B6
)" + good_end;

/// A shift, then three steps of one load: lines 2, 12, 19 and 24 on.
inline const std::string good_run = "% a file\n" +
                                    replaced(replaced(good_case, "203100", "201110"),
                                             "  0.0  0.1  1000.            CHI, DQ, VELOC\n", "") +
                                    R"( 3 MODULE
 002110
 102000
 0101541
  1.0  0.07  0.02  -0.01
  0.0  0.1  1000.
  0.28 0.28 1.0 1.0
 3 MODULE
 002110
 100000
 0101541
  1.0  0.07  0.02  -0.01
 3 MODULE
 002110
 100000
 0101541
  1.0  0.07  0.02  -0.01
)" + good_end;

}  // namespace microslip
