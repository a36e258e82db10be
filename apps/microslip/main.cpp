// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <string>

#include "microslip/experiments/converge_scene.hpp"
#include "microslip/experiments/curve_scene.hpp"
#include "microslip/experiments/response_scene.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/program/memory.hpp"
#include "microslip/program/run_joined.hpp"
#include "microslip/program/sweep.hpp"
#include "solver.hpp"
#include "templates.hpp"

namespace {

using namespace microslip;

constexpr const char* for_many = "for many see 'microslip sweep --help'";

program::Work prepare(Scene& scene) {
  reject_sweep(scene, for_many);
  return solver_of(scene);
}

/// The scene, which then ends with a whole step if only rounding is in between.
template <class Steps>
Steps with_whole_steps(Steps scene) {
  const double end = end_of_whole_steps(scene.distance, scene.step_lengths());
  if (end <= scene.loads.distance()) scene.distance = end;
  return scene;
}

/// Saves the state at the end of a scene with steps.
struct PrepareToSave {
  Scene& scene;
  std::string& state;

  program::Work operator()(const TransientScene& read) const {
    return work(read, read.problem.scheme);
  }
  program::Work operator()(const PatchTransient& read) const { return work(read, read.scheme); }
  template <class Other>
  program::Work operator()(const Other&) const {
    throw BadParameter("problem", fmt::format("problem = '{}': expected transient with --save",
                                              scene.text("problem")));
  }

 private:
  template <class Steps>
  program::Work work(const Steps& read, const AdvectionScheme& scheme) const {
    if (!std::holds_alternative<Remembered>(scheme)) {
      reject("step.scheme", scene.text("step.scheme"), "remembered with --save");
    }
    if (!read.loads.stops().empty()) {
      reject("load.file", scene.text("load.file"),
             "rows that neither turn nor shift the bodies with --save");
    }
    program::require_memory("grid.elements", elements_of(read), memory_needed(read));
    return [whole = with_whole_steps(read), &saved = state](const Progress& progress) {
      return experiments::scene_tables(whole, progress,
                                       [&](auto& rolling) { saved = rolling.save(); });
    };
  }
};

/// \param state  in which the scene ends, filled by the work
program::Work prepare_to_save(Scene& scene, std::string& state) {
  reject_sweep(scene, for_many);
  return std::visit(PrepareToSave{scene, state}, read_model(scene));
}

program::Work prepare_response(Scene& scene) {
  reject_sweep(scene, for_many);
  return [read = experiments::read_response(scene)](const Progress& progress) {
    return experiments::response_tables(read, progress);
  };
}

program::Work prepare_converge(Scene& scene) {
  reject_sweep(scene, for_many);
  const experiments::ConvergeScene read = experiments::read_converge(scene);
  program::require_memory("converge.elements", read.elements.back(), read.memory);
  return [read](const Progress& progress) { return experiments::converge_tables(read, progress); };
}

program::Work prepare_curve(Scene& scene) {
  if (scene.has_patch()) return patch_curve_of(scene);
  const experiments::CurveScene read = experiments::read_curve(scene);
  program::require_memory("grid.elements", read.problem.grid.size(), memory_needed(read.problem));
  return [read](const Progress& progress) { return experiments::curve_tables(read, progress); };
}

program::Preview preview(Scene& scene) {
  const Model model = read_model(scene);
  return {explain(model), work_needed(model), memory_needed(model)};
}

}  // namespace

int main(int argc, char** argv) {
  const program::Program solver{
      .name = "microslip",
      .question = "solves a scene: microslip SCENE.info --out FOLDER",
      .scene = "",
      .quick = "",
      .default_out = "out",
      .key_options = {{"target-error", "target_error",
                       "largest relative error of the force or creepage of steady rolling, of an "
                       "ellipse of forces, moment and motions; picks method and grid"}},
      .prepare = prepare,
      .prepare_to_save = prepare_to_save};
  const program::Program response{
      .name = solver.name,
      .command = "response",
      .question = "computes how the force of a scene follows a small oscillation of the creepage",
      .scene = "",
      .quick = "",
      .default_out = "out",
      .key_options = {{"shortest", "response.shortest",
                       "shortest wavelength [mm] (default: 0.3 half-lengths of the stick zone)"},
                      {"longest", "response.longest",
                       "longest wavelength (default: 300 half-lengths)"},
                      {"wavelengths", "response.wavelengths",
                       "number of wavelengths, evenly spaced in their logarithms (default: 60)"}},
      .prepare = prepare_response};
  const program::Program converge{
      .name = solver.name,
      .command = "converge",
      .question = "measures the cost of an accuracy in a scene, for every scheme and several N",
      .scene = "",
      .quick = "",
      .default_out = "out",
      .key_options = {{"elements", "converge.elements", "numbers N (default: 15 31 63 127 255)"},
                      {"error", "converge.error", "relative error wanted (default: 1e-3)"},
                      {"step-time", "converge.step_time",
                       "time that a step of a transient may take, as '0.1 ms'"},
                      {"reference", "converge.reference",
                       "best, chebyshev or fine (default: best)"}},
      .prepare = prepare_converge};
  const program::Program curve{
      .name = solver.name,
      .command = "curve",
      .question = "computes the creepage-force curve of a scene, or of all cases of a sweep",
      .scene = "",
      .quick = "",
      .default_out = "out",
      .key_options =
          {{"along", "curve.along",
            "creepage, lateral_creepage or spin: the motion of an ellipse that varies"},
           {"creepages", "curve.creepages",
            "numbers and ranges, as '0:1e-4:5e-3' (default: 51 up to full sliding)"},
           {"spins", "curve.spins", "the same of spins [1/mm], with --along spin"},
           {"points", "curve.points", "number of points, evenly spaced (default: 51)"},
           {"largest", "curve.largest", "largest creepage"},
           {"largest-spin", "curve.largest_spin", "largest spin [1/mm]"},
           {"half-widths", "sweep.contact.half_width",
            "numbers and ranges, a curve for each; for other keys use --set sweep.KEY=..."},
           {"beside", "curve.beside",
            "fastsim, and for ellipses fastsim_one, vermeulen_johnson, polach: adds their curves; "
            "several in quotes, with blanks between them"},
           {"kalker-factor", "curve.kalker_factor",
            "factor of Kalker's coefficients in these (default: 1)"}},
      .prepare = prepare_curve,
      .check_sweep = reject_sweep_of_varied};
  using Arguments = const char* const*;
  const std::vector<program::Command> commands{
      {"init", "writes a commented scene to start from",
       [&](int n, Arguments words) { return program::init(solver.name, templates, n, words); }},
      {"import", "makes a scene of a case of an input file of CONTACT",
       [&](int n, Arguments words) { return program::import_case(solver.name, n, words); }},
      {"keys", "lists the keys of scenes, with units and accepted values",
       [&](int n, Arguments words) { return program::keys(solver.name, n, words); }},
      {"explain", "describes the model of a scene, its limits and its cost",
       [&](int n, Arguments words) { return program::explain(solver, preview, n, words); }},
      {"response", "computes how the force follows a small oscillation of the creepage",
       [&](int n, Arguments words) { return program::run(response, n, words); }},
      {"curve", "computes creepage-force curves",
       [&](int n, Arguments words) { return program::run_joined(curve, n, words); }},
      {"converge", "measures the cost of an accuracy in a scene, for every scheme",
       [&](int n, Arguments words) { return program::run(converge, n, words); }},
      {"table", "makes a table of creep forces of contact ellipses",
       [&](int n, Arguments words) { return program::creep_table(solver.name, n, words); }},
      {"plot", "draws the figures of a result, or of a study",
       [&](int n, Arguments words) { return program::plot(solver.name, n, words); }},
      {"sweep", "solves many scenes: all combinations of lists of values",
       [&](int n, Arguments words) { return program::sweep(solver, n, words); }},
      {"merge", "puts the results of a sweep's shards together",
       [&](int n, Arguments words) { return program::merge(solver, n, words); }}};
  return program::dispatch(solver, commands, argc, argv);
}
