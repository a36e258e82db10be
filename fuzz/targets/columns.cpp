// SPDX-License-Identifier: GPL-3.0-or-later
// A file with a bound, with tractions to start from at the nodes, and at any positions.
#include <fmt/core.h>

#include <sstream>

#include "microslip/support/text.hpp"
#include "models.hpp"

namespace {

constexpr const char* good = R"(
material { shear_modulus 1
  poisson_ratio 0.28 }
contact { half_width 1 }
kernel { type plane
  length 10 }
grid { elements 4 }
load { creepage 0.4 }
step { ratio 1 }
motion { distance 1 }
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace microslip;
  for (const char* scheme : {"direct", "remembered"}) {
    for (const bool is_bound : {true, false}) {
      std::istringstream text(good);
      Scene scene = Scene::parse(text, "good");
      scene.set(fmt::format("step.scheme={}", scheme));
      scene.set(is_bound ? "contact.bound_file=b.tsv" : "contact.peak_traction=1");
      scene.set(is_bound ? "start.type=rest" : "start.type=file");
      if (!is_bound) scene.set("start.file=s.tsv");
      scene.read_files_by(
          [&](const std::string&) { return plain_text(fuzz::text_of(data, size)); });
      fuzz::accepts_or_rejects([&] { read_transient(scene); });
    }
  }
  return 0;
}
