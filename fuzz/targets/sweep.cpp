// SPDX-License-Identifier: GPL-3.0-or-later
// A scene with a section sweep; and a text as one list of values.
#include "microslip/scene/sweep.hpp"

#include <sstream>

#include "reader.hpp"

MICROSLIP_READER(sweep) {
  using namespace microslip;
  const std::string text = fuzz::text_of(data, size);
  fuzz::accepts_or_rejects([&] { swept_values("key", text); });
  fuzz::accepts_or_rejects([&] {
    std::istringstream in(text);
    const Sweep sweep(Scene::parse(in, "sweep.info"));
    for (const std::size_t index : {std::size_t{0}, sweep.size() - 1}) {
      const Scene scene = sweep.scene(index);
      for (const SweptKey& swept : sweep.keys()) {
        fuzz::require_that(scene.has(swept.key), "a swept key in the case", swept.key);
      }
    }
  });
  return 0;
}
