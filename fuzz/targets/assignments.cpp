// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of key=value as --set takes them, over a good scene.
#include <sstream>

#include "good_scene.hpp"
#include "models.hpp"

MICROSLIP_READER(assignments) {
  using namespace microslip;
  std::istringstream text(good_contact + "load { creepage 0.4 }\n");
  Scene scene = Scene::parse(text, "good");
  std::istringstream lines(fuzz::text_of(data, size));
  fuzz::accepts_or_rejects([&] {
    for (std::string line; std::getline(lines, line);) scene.set(line);
    fuzz::read_models(scene);
  });
  return 0;
}
