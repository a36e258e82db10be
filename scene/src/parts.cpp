// SPDX-License-Identifier: GPL-3.0-or-later
// Readers of material, contact, kernel, grid and solver, for all kinds of scenes.
#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "hertz.hpp"
#include "microslip/friction/rough_bound.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

/// The driven body's constants have no number.
void refuse_first_body(const Scene& scene) {
  for (const std::string& key : scene.keys()) {
    if (!key.starts_with("material.") || !key.ends_with("_1")) continue;
    const std::string name = key.substr(0, key.size() - 2);
    if (find_key(name) == nullptr) continue;
    throw BadParameter(key, fmt::format("key '{}': expected '{}' for the driven body "
                                        "where the other one has its own",
                                        key, name));
  }
}

Material read_second_body(Scene& scene) {
  const std::string modulus =
      scene.one_of({"material.shear_modulus_2", "material.youngs_modulus_2"});
  const double value = scene.positive(modulus);
  const double nu = scene.number("material.poisson_ratio_2");
  require(nu >= 0 && nu <= 0.5, "material.poisson_ratio_2", nu, "a number in [0, 0.5]");
  const double shear_modulus =
      modulus == "material.shear_modulus_2" ? value : value / (2 * (1 + nu));
  warn_of_large_modulus(scene, modulus, shear_modulus);
  return {.shear_modulus = shear_modulus, .poisson_ratio = nu};
}

}  // namespace

Material read_material(Scene& scene) {
  refuse_first_body(scene);
  if (scene.one_of({"material.shear_modulus", "material.youngs_modulus"}) ==
      "material.shear_modulus") {
    const Material material{.shear_modulus = scene.number("material.shear_modulus"),
                            .poisson_ratio = scene.number("material.poisson_ratio")};
    validate(material);
    return material;
  }
  const double youngs_modulus = scene.positive("material.youngs_modulus");
  const double nu = scene.number("material.poisson_ratio");
  validate({.shear_modulus = youngs_modulus, .poisson_ratio = nu});  // before nu = -1 divides
  const Material material{.shear_modulus = youngs_modulus / (2 * (1 + nu)), .poisson_ratio = nu};
  validate(material);
  scene.derive("material.shear_modulus", material.shear_modulus);
  return material;
}

namespace {

/// Read where the kernel is read: parameters keep their order.
bool is_of_half_space(const Scene& scene) {
  const std::string type = scene.has("kernel.type") ? scene.text("kernel.type") : "";
  return type != "winkler" && type != "symbol";
}

bool has_material(const Scene& scene) {
  return is_of_half_space(scene) || scene.has("contact.normal_load");
}

}  // namespace

Material read_material_if_any(Scene& scene) {
  return has_material(scene) ? read_material(scene) : Material{1, 0};
}

Bodies read_bodies(Scene& scene) {
  if (!has_material(scene)) return {read_material_if_any(scene)};
  const Material first = read_material(scene);
  const std::string given = scene.at_most_one_of(
      {"material.dundurs_beta", "material.shear_modulus_2", "material.youngs_modulus_2"});
  if (given.empty() && !scene.has("material.poisson_ratio_2")) return {first};
  if (given == "material.dundurs_beta") {
    const double beta = scene.number(given);
    require(std::abs(beta) <= 0.5, given, beta, "a number in [-0.5, 0.5]");
    return {first, beta};
  }
  const Bodies bodies = combined(first, read_second_body(scene));
  scene.derive("material.shear_modulus of both", bodies.combined.shear_modulus);
  scene.derive("material.poisson_ratio of both", bodies.combined.poisson_ratio);
  scene.derive("material.dundurs_beta", bodies.dundurs_beta);
  return bodies;
}

Material read_tangential(Scene& scene, const Material& material) {
  if (!is_of_half_space(scene)) return material;
  return scene.word("direction") == "lateral" ? lateral(material) : material;
}

double read_friction(Scene& scene) {
  constexpr double most_friction = 10;
  const double friction = scene.positive("contact.friction");
  require(friction <= most_friction, "contact.friction", friction,
          "a number above 0, at most " + format_short(most_friction));
  return friction;
}

namespace {

SymbolKernel read_symbol(Scene& scene) {
  const std::vector<FileColumn> wanted = {{"wave_number", "1/mm"}, {"symbol", "mm^3/N"}};
  return scene.from_columns("kernel.table", wanted, [](const auto& columns) {
    return SymbolKernel(*columns[0], *columns[1]);
  });
}

LayeredKernel::HalfSpace read_half_space(Scene& scene, const std::string& type,
                                         const Material& material) {
  if (type == "strip") return StripKernel(material, scene.number("kernel.width"));
  return PlaneKernel(material, scene.number("kernel.length"));
}

}  // namespace

Kernel read_kernel(Scene& scene, const Material& material) {
  const std::string type = scene.word("kernel.type");
  if (type == "symbol") return read_symbol(scene);
  if (type == "winkler") return WinklerKernel(scene.number("kernel.compliance"));
  const LayeredKernel::HalfSpace half_space = read_half_space(scene, type, material);
  if (scene.has("kernel.compliance")) {
    return LayeredKernel(half_space, scene.number("kernel.compliance"));
  }
  return std::visit([](const auto& of) { return Kernel(of); }, half_space);
}

HertzBound read_hertz_bound(Scene& scene) {
  const double half_width = scene.number("contact.half_width");
  return {half_width, scene.number("contact.peak_traction")};
}

PolynomialBound read_polynomial_bound(Scene& scene) {
  const double half_width = scene.number("contact.half_width");
  const std::vector<double> h = scene.numbers("contact.bound_polynomial");
  return {half_width, scene.number("contact.peak_traction", 1),
          Eigen::Map<const Eigen::VectorXd>(h.data(), static_cast<Eigen::Index>(h.size()))};
}

TabulatedBound read_rough_bound(Scene& scene) {
  for (const char* other :
       {"contact.bound_polynomial", "contact.bound_file", "contact.normal_load"}) {
    scene.at_most_one_of({"contact.roughness", other});
  }
  const Eigen::Index seed = scene.whole("contact.seed");
  scene.demand("contact.seed", static_cast<double>(seed),
               seed >= 0 && seed <= std::numeric_limits<unsigned>::max());
  return rough_bound(read_hertz_bound(scene), {.amplitude = scene.number("contact.roughness"),
                                               .hurst = scene.number("contact.hurst"),
                                               .seed = static_cast<unsigned>(seed),
                                               .rows = scene.whole("contact.rows")});
}

TractionBound read_bound(Scene& scene) {
  if (scene.has("contact.roughness")) return read_rough_bound(scene);
  if (scene.has("contact.bound_polynomial")) return read_polynomial_bound(scene);
  if (scene.one_of({"contact.peak_traction", "contact.bound_file"}) == "contact.peak_traction") {
    return read_hertz_bound(scene);
  }
  const double half_width = scene.number("contact.half_width");
  const std::vector<FileColumn> wanted = {{"x", "mm"}, {"bound", "N/mm^2"}};
  return scene.from_columns("contact.bound_file", wanted, [&](const auto& table) {
    return TabulatedBound(half_width, *table[0], *table[1]);
  });
}

TractionBound read_bound(Scene& scene, const Material& material) {
  if (scene.one_of({"contact.half_width", "contact.normal_load"}) == "contact.half_width") {
    return read_bound(scene);
  }
  return read_loaded_contact(scene, material);
}

Grid read_grid(Scene& scene, double half_width) {
  return Grid({.half_width = half_width,
               .elements = scene.whole("grid.elements"),
               .leading_offset = scene.number("grid.leading_offset"),
               .trailing_offset = scene.number("grid.trailing_offset")});
}

Basis read_basis(Scene& scene, const Grid& grid) {
  const Basis basis = make_basis(scene.word("basis"));
  const bool alternates = basis.pattern() == Basis::Pattern::alternating;
  require(!alternates || grid.size() % 2 == 1, "grid.elements", static_cast<double>(grid.size()),
          [&] { return fmt::format("an odd number for {} functions", basis.name()); });
  return basis;
}

Solver read_solver(Scene& scene) {
  const std::string type = scene.word("solver.type");
  const Solver solver{.type = type == "dense" ? Solver::Type::dense
                              : type == "fft" ? Solver::Type::fft
                                              : Solver::Type::automatic,
                      .tolerance = scene.number("solver.tolerance")};
  validate(solver);
  return solver;
}

Acceptance read_acceptance(Scene& scene) {
  const Acceptance accepted{.residual = scene.number("solver.tolerance"),
                            .violation = scene.number("solver.violation"),
                            .condition = scene.number("solver.condition")};
  validate(accepted);
  return accepted;
}

Load read_load(Scene& scene, const Kernel& kernel, const TractionBound& bound) {
  const std::string key = scene.one_of(load_keys);
  const double value = scene.number(key);
  if (key == "load.creepage") {
    warn_of_large_creepage(scene, key, value, bound);
    return PrescribedCreepage{value};
  }
  if (key == "load.force") return PrescribedForce{value};
  double ratio = value;
  if (key == "load.force_ratio") {
    require(std::abs(value) < 1, key, value, "a number above -1, below 1");
  } else {
    require(std::holds_alternative<HertzBound>(bound), key, value,
            "Hertz's bound, as it is Carter's; for others there is load.force_ratio");
    require(kernel.is_plane(), key, value,
            "kernel.type plane without a layer, as it is Carter's; for others there is "
            "load.force_ratio");
    require(value > 0 && value < 1, key, value,
            "a number above 0, which is full sliding, and below 1, which is no load");
    ratio = -(1 - value) * (1 + value);  // the sign of a positive creepage
  }
  const double force = ratio * full_sliding_force(bound);
  scene.derive("load.force", force);
  return PrescribedForce{force};
}

}  // namespace microslip
