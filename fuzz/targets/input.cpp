// SPDX-License-Identifier: GPL-3.0-or-later
// An input file of CONTACT: its cases have scenes that microslip takes, or one line says why not.
#include <sstream>

#include "microslip/scene/contact_input.hpp"
#include "microslip/scene/model.hpp"
#include "reader.hpp"

MICROSLIP_READER(input) {
  using namespace microslip;
  const std::string text = fuzz::text_of(data, size);
  for (const bool direct : {false, true}) {
    for (int number = 0; number < 4; ++number) {
      fuzz::accepts_or_rejects([&] {
        const ImportedScene imported =
            scene_of_input(text, "a.inp", {.number = number, .direct = direct});
        for (const std::string& note : imported.notes) fuzz::require_one_line(note);
        std::istringstream in(imported.text);
        Scene scene = Scene::parse(in, "scene");
        const Model model = read_model(scene);
        scene.reject_unread();
      });
    }
    const InputList list = cases_of_input(text, "a.inp", direct);
    for (const std::string& line : list.lines) fuzz::require_one_line(line);
    if (!list.error.empty()) fuzz::require_one_line(list.error);
  }
  return 0;
}
