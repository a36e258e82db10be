// SPDX-License-Identifier: GPL-3.0-or-later
// Contact patches of scenes: one that rolls step by step, and steady rolling under many loads.
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>

#include "ellipse_handle.hpp"
#include "error.hpp"
#include "interface.hpp"
#include "microslip/patch/large_motion.hpp"
#include "microslip/program/memory.hpp"
#include "microslip/scene/cost.hpp"
#include "microslip/scene/unloaded.hpp"
#include "microslip/support/parallel.hpp"
#include "microslip/support/require.hpp"
#include "patch_tables.hpp"
#include "problem.hpp"
#include "scene.hpp"

using namespace microslip;
using namespace microslip::python;

struct microslip_py_patch {
  PatchOfScene read;
  std::string warnings;
  std::mutex mutex = {};
  std::optional<SteadyPatchSolver> solver = {};  ///< made by the first steady solution

  /// A solver that has solved nothing.
  SteadyPatchSolver fresh_solver() {
    const std::lock_guard lock(mutex);
    if (!solver) solver.emplace(read.patch);
    return *solver;
  }
};

int microslip_py_has_patch(const microslip_py_scene* scene) {
  int found = -1;
  python::status_of([&] { found = scene_of(*scene).has_patch() ? 1 : 0; });
  return found;
}

microslip_py_patch* microslip_py_patch_read(const microslip_py_scene* scene) {
  return or_null([&] {
    Scene given = scene_of(*scene);
    const PatchOfScene read = placed(given, [&] { return patch_of(given); });
    program::require_memory("grid.elements", read.patch.elements, memory_needed(read.patch));
    return new microslip_py_patch{.read = read, .warnings = lines_of(given.warnings())};
  });
}

void microslip_py_patch_destroy(microslip_py_patch* patch) { delete patch; }

const char* microslip_py_patch_warnings(const microslip_py_patch* patch) {
  return patch->warnings.c_str();
}

std::size_t microslip_py_patch_rows(const microslip_py_patch* patch) {
  return static_cast<std::size_t>(patch->read.patch.rows);
}

std::size_t microslip_py_patch_elements(const microslip_py_patch* patch) {
  return static_cast<std::size_t>(patch->read.patch.elements);
}

double microslip_py_patch_full_sliding(const microslip_py_patch* patch) {
  return patch->read.patch.bound.total();
}

const char* microslip_py_patch_edges(const microslip_py_patch* patch) {
  return text_or_null([&] {
    std::ostringstream text;
    experiments::patch_edges_table(patch->read.patch).write(text, "microslip", {});
    return text.str();
  });
}

const char* microslip_py_patch_doubt(const microslip_py_patch* patch, int component,
                                     double motion) {
  return text_or_null([&] {
    return doubt_of_large_motion(static_cast<std::size_t>(component), motion, patch->read.patch);
  });
}

const char* microslip_py_motion_doubt(int component, double motion, double size, double strain) {
  return text_or_null([&] {
    return doubt_of_large_motion(static_cast<std::size_t>(component), motion, size, strain);
  });
}

const char* microslip_py_units_doubt(double shear_modulus, double traction) {
  return text_or_null([&] {
    return microslip::capi::doubt_of_units({.shear_modulus = shear_modulus, .poisson_ratio = 0},
                                           traction);
  });
}

microslip_ellipse* microslip_py_patch_ellipse(const microslip_py_patch* patch) {
  return or_null([&] {
    const auto& [problem, scheme] = patch->read;
    if (scheme != "remembered") {
      reject("step.scheme", scheme, "remembered in microslip.Patch; microslip.solve has others");
    }
    return new microslip_ellipse(problem);
  });
}

int microslip_py_ellipse_contact(const microslip_ellipse* ellipse, double* factors) {
  return python::status_of([&] {
    const std::lock_guard lock(ellipse->mutex);
    const ContactScale& contact = ellipse->rolling.contact();
    factors[0] = contact.half_width;
    factors[1] = contact.bound;
  });
}

int microslip_py_patch_steady(microslip_py_patch* patch, const microslip_ellipse_load* loads,
                              std::size_t count, int threads,
                              const microslip_py_patch_solutions* solutions) {
  return python::status_of([&] {
    const microslip_py_patch_solutions& out = *solutions;
    const std::size_t size = microslip_py_patch_rows(patch) * microslip_py_patch_elements(patch);
    for_each_case(count, threads, [&](std::size_t i) {
      out.statuses[i] = capi::guarded({out.messages + i * out.room, out.room}, [&] {
        SteadyPatchSolver solver = patch->fresh_solver();
        const SteadyPatchSolution solution = solver.solve(capi::load_of(loads[i]));
        require_evidence(solution.evidence, solution.condition, solution.iterations,
                         patch->read.patch.accepted);
        out.states[i] = capi::state_of(solution, patch->read.patch.bound.total());
        out.changes[i] = solution.evidence.change;
        capi::put_cells({solution.x, solution.y, solution.area, solution.bound, solution.traction,
                         solution.slip, solution.slips},
                        capi::cells_from(out.cells, i * size));
      });
    });
  });
}
