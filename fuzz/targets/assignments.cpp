// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of key=value as --set takes them, over a good scene.
#include <sstream>

#include "models.hpp"

namespace {

constexpr const char* good = R"(
material { shear_modulus 1
  poisson_ratio 0.28 }
contact { half_width 1
  peak_traction 1 }
kernel { type strip
  width 40 }
grid { elements 20 }
load { creepage 0.4 }
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace microslip;
  std::istringstream text(good);
  Scene scene = Scene::parse(text, "good");
  std::istringstream lines(fuzz::text_of(data, size));
  fuzz::accepts_or_rejects([&] {
    for (std::string line; std::getline(lines, line);) scene.set(line);
    fuzz::read_models(scene);
  });
  return 0;
}
