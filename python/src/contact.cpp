// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of scenes: what rolls step by step, and steady rolling under many loads.
#include <mutex>

#include "error.hpp"
#include "handle.hpp"
#include "interface.hpp"
#include "microslip/reference/fastsim.hpp"
#include "microslip/support/parallel.hpp"
#include "microslip/support/require.hpp"
#include "scene.hpp"
#include "steady.hpp"
#include "text_file.hpp"
#include "zero.hpp"

using namespace microslip;
using namespace microslip::python;

microslip_rolling* microslip_py_rolling(const microslip_py_scene* scene) {
  return or_null([&] { return new microslip_rolling(rolling_of(scene_of(*scene))); });
}

const char* microslip_py_save(microslip_rolling* rolling) {
  return text_or_null([&] {
    const std::lock_guard lock(rolling->mutex);
    return rolling->contact->save();
  });
}

int microslip_py_restore(microslip_rolling* rolling, const char* text) {
  return python::status_of([&] {
    const std::lock_guard lock(rolling->mutex);
    rolling->contact->restore({text});
  });
}

int microslip_py_contact(const microslip_rolling* rolling, double* factors) {
  return python::status_of([&] {
    const std::lock_guard lock(rolling->mutex);
    const ContactScale& contact = rolling->contact->contact();
    factors[0] = contact.half_width;
    factors[1] = contact.bound;
  });
}

const char* microslip_py_writable_target(const char* path) {
  return text_or_null([&] { return capi::target_of(path).string(); });
}

struct microslip_py_steady {
  SteadyProblem problem;
  std::string warnings;
};

microslip_py_steady* microslip_py_steady_read(const microslip_py_scene* scene) {
  return or_null([&] {
    Scene read = scene_of(*scene);
    const SteadyProblem problem = steady_of(read);
    return new microslip_py_steady{problem, lines_of(read.warnings())};
  });
}

void microslip_py_steady_destroy(microslip_py_steady* steady) { delete steady; }

std::size_t microslip_py_steady_size(const microslip_py_steady* steady) {
  return static_cast<std::size_t>(steady->problem.grid.size());
}

double microslip_py_full_sliding(const microslip_py_steady* steady) {
  return full_sliding_force(steady->problem.contact.bound);
}

int microslip_py_fastsim(const microslip_py_steady* steady, double slope, const double* creepages,
                         std::size_t count, double* forces) {
  return python::status_of([&] {
    const TractionBound& bound = steady->problem.contact.bound;
    if (steady->problem.contact.has_unlike_bodies()) {
      reject("beside", "fastsim", "None for bodies of different material");
    }
    const Fastsim fastsim(half_width_of(bound), full_sliding_force(bound), slope);
    for (std::size_t i = 0; i < count; ++i)
      forces[i] = capi::without_sign_of_zero(fastsim.force(creepages[i]));
  });
}

const char* microslip_py_steady_warnings(const microslip_py_steady* steady) {
  return steady->warnings.c_str();
}

const char* microslip_py_steady_doubt(const microslip_py_steady* steady, int load_type,
                                      const double* loads, std::size_t count) {
  return text_or_null(
      [&] { return capi::doubt_of_loads(steady->problem, load_type, loads, count); });
}

int microslip_py_steady_solve(const microslip_py_steady* steady, int load_type, const double* loads,
                              std::size_t count, int threads, microslip_steady* states,
                              const microslip_steady_nodes* nodes, char* messages,
                              std::size_t room) {
  return python::status_of([&] {
    capi::require_load_type(load_type);
    const std::size_t size = microslip_py_steady_size(steady);
    for_each_case(count, threads, [&](std::size_t i) {
      states[i] = capi::solve_load(steady->problem, load_type, loads[i],
                                   capi::NodesOut(nodes, i, size), {messages + i * room, room});
    });
  });
}
