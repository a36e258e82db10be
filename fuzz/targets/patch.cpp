// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a contact of any shape: its edges up to a line "=", and its bound behind the line, as a
// patch and as an ellipse with a bound.
#include <sstream>
#include <string>
#include <vector>

#include "microslip/support/text.hpp"
#include "models.hpp"

namespace {

constexpr const char* half_spaces = R"(
problem steady
material { shear_modulus 1
  poisson_ratio 0.28 }
load { creepage 0.4 }
)";

}  // namespace

MICROSLIP_READER(patch) {
  using namespace microslip;
  const std::string text = fuzz::text_of(data, size);
  const std::size_t end = text.find("=\n");
  const std::string bound = end == std::string::npos ? "" : text.substr(end + 2);
  const auto read = [&](const std::vector<const char*>& settings) {
    std::istringstream in(half_spaces);
    Scene scene = Scene::parse(in, "half_spaces");
    for (const char* setting : settings) scene.set(setting);
    scene.read_files_by([&](const std::string& path) {
      return plain_text(path == "edges.tsv" ? text.substr(0, end) : bound);
    });
    fuzz::accepts_or_rejects([&] { read_steady_patch(scene); });
  };
  read({"contact.patch_file=edges.tsv", "contact.bound_file=bound.tsv"});
  read({"contact.patch_file=edges.tsv", "contact.peak_traction=1"});
  read({"contact.half_width=2", "contact.lateral_half_width=3", "contact.bound_file=bound.tsv"});
  return 0;
}
