// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/model.hpp"

#include <stdexcept>

#include "microslip/support/require.hpp"

namespace microslip {

Material read_material(Scene& scene) {
  const Material material{.shear_modulus = scene.number("material.shear_modulus"),
                          .poisson_ratio = scene.number("material.poisson_ratio")};
  validate(material);
  return material;
}

Kernel read_kernel(Scene& scene, const Material& material) {
  if (scene.word("kernel.type", {"strip", "plane"}) == "strip") {
    return StripKernel(material, scene.number("kernel.width"));
  }
  return PlaneKernel(material, scene.number("kernel.length"));
}

HertzBound read_hertz_bound(Scene& scene) {
  const double half_width = scene.number("contact.half_width");
  return {half_width, scene.number("contact.peak_traction")};
}

TractionBound read_bound(Scene& scene) {
  if (!scene.has_second("contact.peak_traction", "contact.bound_file")) {
    return read_hertz_bound(scene);
  }
  const double half_width = scene.number("contact.half_width");
  return scene.from_columns("contact.bound_file", {"x", "bound"}, [&](const auto& table) {
    return TabulatedBound(half_width, table[0], table[1]);
  });
}

Grid read_grid(Scene& scene, double half_width) {
  return Grid({.half_width = half_width,
               .elements = scene.whole("grid.elements"),
               .leading_offset = scene.number("grid.leading_offset", 0.5),
               .trailing_offset = scene.number("grid.trailing_offset", 0.5)});
}

Basis read_basis(Scene& scene) {
  return make_basis(scene.word_or_first("basis", {"constant", "linear", "quadratic"}));
}

ShapeFunction read_shape(Scene& scene) {
  return make_basis(scene.word_or_first("basis", {"constant", "linear"})).shapes().front();
}

Load read_load(Scene& scene) {
  if (scene.has_second("load.creepage", "load.force")) {
    return PrescribedForce{scene.number("load.force")};
  }
  return PrescribedCreepage{scene.number("load.creepage")};
}

SteadyProblem read_steady(Scene& scene) {
  return read_steady(scene, scene.number("step.ratio", 1));
}

SteadyProblem read_steady(Scene& scene, double step_ratio) {
  const Material material = read_material(scene);
  const TractionBound bound = read_bound(scene);
  const Kernel kernel = read_kernel(scene, material);
  const Grid grid = read_grid(scene, half_width_of(bound));
  const Basis basis = read_basis(scene);
  require(basis.name() != "quadratic" || grid.size() % 2 == 1, "grid.elements",
          static_cast<double>(grid.size()), "an odd number for quadratic functions");
  return {.kernel = kernel,
          .bound = bound,
          .grid = grid,
          .basis = basis,
          .step_ratio = step_ratio,
          .load = read_load(scene)};
}

}  // namespace microslip
