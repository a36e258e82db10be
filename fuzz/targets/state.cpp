// SPDX-License-Identifier: GPL-3.0-or-later
// A saved state without its last line, the checksum, which the target adds. A state that is read
// must be saved as one that reads the same, and a step from it must end or be rejected.
#include <fmt/core.h>

#include "microslip/rolling/transient.hpp"
#include "microslip/support/checksum.hpp"
#include "reader.hpp"

MICROSLIP_READER(state) {
  using namespace microslip;
  static const TransientProblem problem{.contact = {PlaneKernel({1, 0.28}, 10), HertzBound(1, 1)},
                                        .grid = Grid({.half_width = 1, .elements = 5}),
                                        .basis = constant_basis(),
                                        .scheme = Remembered{}};
  const std::string members = fuzz::text_of(data, size);
  fuzz::accepts_or_rejects([&] {
    TransientRolling rolling(
        problem, SavedState{fmt::format("{}checksum {}\n", members, checksum(members))});
    const std::string saved = rolling.save();
    const std::string again = TransientRolling(problem, SavedState{saved}).save();
    fuzz::require_that(again == saved, saved, again);
    rolling.step(0.3, PrescribedCreepage{0.1});
    rolling.shift(PrescribedShift{0.1});
  });
  return 0;
}
