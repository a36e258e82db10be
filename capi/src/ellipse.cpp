// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <set>
#include <string>

#include "ellipse_handle.hpp"
#include "jacobian.hpp"
#include "microslip/reference/point_contact.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/parallel.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/text.hpp"
#include "microslip_ellipse.h"
#include "problem.hpp"
#include "text_file.hpp"
#include "zero.hpp"

using namespace microslip::capi;

namespace {

void require_factor(const char* name, double factor, double least, double largest) {
  microslip::require(factor == 0 || (factor >= least && factor <= largest), name, factor, [&] {
    return fmt::format("a number from {} to {}, or 0", microslip::format_short(least),
                       microslip::format_short(largest));
  });
}

void restore(microslip_ellipse& of, const std::string& text) {
  of.rolling.restore({text});
  of.attempt.reset();
}

}  // namespace

microslip_status microslip_hertz_ellipse(const microslip_material* material,
                                         const microslip_bodies* bodies,
                                         microslip_ellipse_contact* contact, char* message,
                                         size_t message_size) {
  return guarded({message, message_size}, [&] {
    const auto& [G, nu] = require_pointer(material, "material");
    const auto& [load, r1, r2, l1, l2, friction] = require_pointer(bodies, "bodies");
    microslip_ellipse_contact& out = require_pointer(contact, "contact");
    microslip::require_positive("normal_load", load);
    microslip::require(friction > 0 && friction <= 10, "friction", friction,
                       "a number above 0, at most 10");
    const microslip::PointContact found(
        {.shear_modulus = G, .poisson_ratio = nu}, load,
        microslip::summed_curvature("radius_1", r1, "radius_2", r2),
        microslip::summed_curvature("lateral_radius_1", l1, "lateral_radius_2", l2));
    out = {.half_width = found.half_width(),
           .lateral_half_width = found.lateral_half_width(),
           .peak_traction = friction * found.peak_pressure()};
  });
}

microslip_status microslip_ellipse_create(const microslip_material* material,
                                          const microslip_ellipse_contact* contact,
                                          const microslip_ellipse_grid* grid,
                                          microslip_ellipse** ellipse, char* message,
                                          size_t message_size) {
  if (ellipse != nullptr) *ellipse = nullptr;
  return guarded({message, message_size}, [&] {
    microslip_ellipse*& made = require_pointer(ellipse, "ellipse");
    made = new microslip_ellipse(make_patch(require_pointer(material, "material"),
                                            require_pointer(contact, "contact"), grid));
    made->warning.say_of_units(doubt_of_units(*material, made->problem.bound.peak()));
  });
}

microslip_status microslip_ellipse_copy(microslip_ellipse* ellipse, microslip_ellipse** copy) {
  if (copy != nullptr) *copy = nullptr;
  return with_ellipse(ellipse, [&](const microslip_ellipse& from) {
    microslip_ellipse*& made = require_pointer(copy, "copy");
    made = new microslip_ellipse(from);
  });
}

microslip_status microslip_ellipse_assign(microslip_ellipse* ellipse, microslip_ellipse* from) {
  if (ellipse == nullptr) return MICROSLIP_BAD_INPUT;
  if (ellipse == from) return MICROSLIP_OK;
  if (from == nullptr) {
    return with_ellipse(ellipse, [&](microslip_ellipse&) { require_pointer(from, "from"); });
  }
  const std::scoped_lock both(ellipse->mutex, from->mutex);
  return guarded({ellipse->message, sizeof ellipse->message}, [&] {
    ellipse->attempt.reset();
    ellipse->rolling = from->rolling;
    ellipse->problem = from->problem;
    ellipse->solver = from->solver;
    ellipse->has_second = from->has_second;
    ellipse->warning = from->warning;
  });
}

void microslip_ellipse_destroy(microslip_ellipse* ellipse) { delete ellipse; }

const char* microslip_ellipse_message(microslip_ellipse* ellipse) {
  return ellipse == nullptr ? "ellipse = null: expected a handle" : ellipse->message;
}

const char* microslip_ellipse_warning(const microslip_ellipse* ellipse) {
  return ellipse == nullptr ? "" : ellipse->warning.text();
}

microslip_status microslip_ellipse_set_contact(microslip_ellipse* ellipse, double size_factor,
                                               double bound_factor) {
  return with_ellipse(ellipse, [&](microslip_ellipse& of) {
    using Ranges = microslip::PatchStepRanges;
    require_factor("size_factor", size_factor, Ranges::least_size, Ranges::largest_size);
    require_factor("bound_factor", bound_factor, Ranges::least_bound, Ranges::largest_bound);
    of.rolling.set_contact({.half_width = size_factor, .bound = bound_factor});
  });
}

microslip_status microslip_ellipse_solve_steady(microslip_ellipse* ellipse,
                                                const microslip_ellipse_load* load,
                                                microslip_ellipse_state* state, double* jacobian) {
  return with_ellipse(ellipse, [&](microslip_ellipse& of) {
    microslip_ellipse_state& out = require_pointer(state, "state");
    out = solve_steady(of, read_load(of, load));
    if (jacobian != nullptr) put_jacobian(jacobian, of.solver->jacobian());
  });
}

microslip_status microslip_ellipse_advance(microslip_ellipse* ellipse, double dq,
                                           const microslip_ellipse_load* load,
                                           microslip_ellipse_state* state) {
  return with_ellipse(ellipse, [&](microslip_ellipse& of) {
    advance(of, dq, read_load(of, load));
    if (state != nullptr) *state = state_of(of.rolling);
  });
}

microslip_status microslip_ellipse_attempt(microslip_ellipse* ellipse, double dq,
                                           const microslip_ellipse_load* load,
                                           microslip_ellipse_state* state, double* jacobian) {
  return with_ellipse(ellipse, [&](microslip_ellipse& of) {
    microslip_ellipse_state& out = require_pointer(state, "state");
    attempt(of, dq, read_load(of, load));
    out = state_of(of.trial);
    if (jacobian != nullptr) put_jacobian(jacobian, of.trial.jacobian());
  });
}

microslip_status microslip_ellipse_shift(microslip_ellipse* ellipse,
                                         const microslip_ellipse_load* load,
                                         microslip_ellipse_state* state) {
  return with_ellipse(ellipse, [&](microslip_ellipse& of) {
    const microslip::PatchLoad wanted = load_of(require_pointer(load, "load"));
    of.attempt.reset();
    of.rolling.shift(wanted);
    if (state != nullptr) *state = state_of(of.rolling);
  });
}

microslip_status microslip_ellipse_advance_all(microslip_ellipse* const* ellipses, size_t count,
                                               const double* dq,
                                               const microslip_ellipse_load* loads,
                                               microslip_ellipse_state* states, int threads) {
  microslip_status first = MICROSLIP_OK;
  char why[512] = "";
  const microslip_status status = guarded({why, sizeof why}, [&] {
    if (count == 0) return;
    require_pointer(ellipses, "ellipses");
    require_pointer(dq, "dq");
    require_pointer(loads, "loads");
    microslip::require(threads >= 1 && threads <= 1000, "threads", threads, "1 ... 1000");
    const std::set<const microslip_ellipse*> different(ellipses, ellipses + count);
    microslip::require(different.size() == count, "ellipses", static_cast<double>(count),
                       "handles of which no two are alike");
    std::vector<microslip_status> all(count);
    microslip::for_each_case(count, threads, [&](std::size_t i) {
      all[i] = microslip_ellipse_advance(ellipses[i], dq[i], &loads[i],
                                         states == nullptr ? nullptr : &states[i]);
    });
    for (const microslip_status one : all) {
      if (first == MICROSLIP_OK) first = one;
    }
  });
  if (status != MICROSLIP_OK && ellipses != nullptr && ellipses[0] != nullptr) {
    const std::lock_guard lock(ellipses[0]->mutex);
    Message{ellipses[0]->message, sizeof ellipses[0]->message}.say(why);
  }
  return status != MICROSLIP_OK ? status : first;
}

microslip_status microslip_ellipse_get_state(microslip_ellipse* ellipse,
                                             microslip_ellipse_state* state) {
  return with_ellipse(ellipse, [&](const microslip_ellipse& of) {
    require_pointer(state, "state") = state_of(of.rolling);
  });
}

size_t microslip_ellipse_size(const microslip_ellipse* ellipse) {
  if (ellipse == nullptr) return 0;
  const std::lock_guard lock(ellipse->mutex);
  return static_cast<std::size_t>(ellipse->problem.rows * ellipse->problem.elements);
}

microslip_status microslip_ellipse_get_cells(microslip_ellipse* ellipse,
                                             const microslip_ellipse_cells* cells) {
  return with_ellipse(ellipse, [&](const microslip_ellipse& of) {
    put_cells({of.rolling.x(), of.rolling.y(), of.rolling.areas(), of.rolling.bound(),
               of.rolling.tractions(), of.rolling.slip(), of.rolling.slips()},
              require_pointer(cells, "cells"));
  });
}

microslip_status microslip_ellipse_get_elastic_energy(microslip_ellipse* ellipse, double* energy) {
  return with_ellipse(ellipse, [&](const microslip_ellipse& of) {
    require_pointer(energy, "energy") = of.rolling.elastic_energy();
  });
}

microslip_status microslip_ellipse_save(microslip_ellipse* ellipse, const char* path) {
  return with_ellipse(ellipse, [&](const microslip_ellipse& of) {
    const std::string name = &require_pointer(path, "path");
    write_text(name, of.rolling.save());
  });
}

microslip_status microslip_ellipse_restore(microslip_ellipse* ellipse, const char* path) {
  return with_ellipse(ellipse, [&](microslip_ellipse& of) {
    const std::string name = &require_pointer(path, "path");
    try {
      restore(of, microslip::file_text(name));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(
          fmt::format("path = '{}': {}", microslip::shown(name), error.what()));
    }
  });
}

microslip_status microslip_ellipse_save_to_memory(microslip_ellipse* ellipse, char* text,
                                                  size_t size, size_t* needed) {
  return with_ellipse(ellipse, [&](const microslip_ellipse& of) {
    const std::string saved = of.rolling.save();
    if (needed != nullptr) *needed = saved.size() + 1;
    if (text == nullptr) return;
    microslip::require(size > saved.size(), "size", static_cast<double>(size),
                       [&] { return fmt::format("at least {}", saved.size() + 1); });
    std::memcpy(text, saved.c_str(), saved.size() + 1);
  });
}

microslip_status microslip_ellipse_restore_from_memory(microslip_ellipse* ellipse,
                                                       const char* text) {
  return with_ellipse(ellipse,
                      [&](microslip_ellipse& of) { restore(of, &require_pointer(text, "text")); });
}
