// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a scene. Whatever file it names holds the same table.
#include <sstream>

#include "models.hpp"

MICROSLIP_READER(scene) {
  using namespace microslip;
  fuzz::accepts_or_rejects([&] {
    std::istringstream in(fuzz::text_of(data, size));
    Scene scene = Scene::parse(in, "scene.info", "folder/");
    scene.read_files_by(
        [](const std::string&) { return "x\tbound\ttraction\n-0.5\t1\t0\n0.5\t1\t0.1\n"; });
    fuzz::read_models(scene);
  });
  return 0;
}
