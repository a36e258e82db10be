// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "microslip/scene/model.hpp"
#include "reader.hpp"

namespace microslip::fuzz {

/// Reads a scene as each of the models; nothing is solved except for what a model itself needs.
inline void read_models(const Scene& scene) {
  const auto read_by = [&](auto read) {
    accepts_or_rejects([&] {
      Scene copy = scene;
      with_places(copy, [&] {
        if (copy.has("problem")) copy.word("problem");
        read(copy);
        copy.reject_unread();
      });
    });
  };
  read_by([](Scene& from) { read_steady(from); });
  read_by([](Scene& from) { read_steady_target(from); });
  read_by([](Scene& from) { read_steady_patch(from); });
  read_by([](Scene& from) { read_transient(from); });
  read_by([](Scene& from) { read_cylinder(from); });
}

}  // namespace microslip::fuzz
