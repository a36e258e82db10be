// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/cattaneo_to_carter.hpp"

#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"

namespace microslip::experiments {

TransientProblem CattaneoToCarter::problem(const AdvectionScheme& scheme) const {
  return {
      .contact = {kernel, bound}, .grid = grid, .basis = basis, .scheme = scheme, .solver = solver};
}

TransientRolling CattaneoToCarter::rolled(const AdvectionScheme& scheme, double step_ratio,
                                          double elements) const {
  TransientRolling rolling(problem(scheme), CattaneoShift{force});
  rolling.roll(elements * grid.spacing(), {step_ratio * grid.spacing()}, PrescribedForce{force},
               [](const TransientState&) {});
  return rolling;
}

TransientRolling CattaneoToCarter::refined(double elements, Eigen::Index refinement) const {
  CattaneoToCarter fine = *this;
  fine.grid = Grid({.half_width = grid.half_width(), .elements = refinement * grid.size()});
  return fine.rolled(Direct{}, 1, elements * grid.spacing() / fine.grid.spacing());
}

CattaneoToCarter read_cattaneo_to_carter(Scene& scene) {
  using enum Key::Type;
  scene.declare({{.name = "basis",
                  .type = word,
                  .meaning = "traction basis functions",
                  .words = {"constant", "linear"},
                  .first_is_default = true}});

  const Material material = read_material(scene);
  const HertzBound bound = read_hertz_bound(scene);
  const Kernel kernel = read_kernel(scene, material);
  const Grid grid({.half_width = bound.half_width(), .elements = scene.whole("grid.elements")});
  const Basis basis = make_basis(scene.word("basis"));
  return {.kernel = kernel,
          .bound = bound,
          .grid = grid,
          .basis = basis,
          .force = scene.number("load.force")};
}

}  // namespace microslip::experiments
