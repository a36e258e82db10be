// SPDX-License-Identifier: GPL-3.0-or-later
// A file with a bound, with tractions to start from at the nodes, and at any positions.
#include <fmt/core.h>

#include <sstream>

#include "microslip/support/text.hpp"
#include "models.hpp"

namespace {

constexpr const char* line_contact = R"(
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

MICROSLIP_READER(columns) {
  using namespace microslip;
  for (const char* scheme : {"direct", "remembered"}) {
    for (const bool is_bound : {true, false}) {
      std::istringstream text(line_contact);
      Scene scene = Scene::parse(text, "line_contact");
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
