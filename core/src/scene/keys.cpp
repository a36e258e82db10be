// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/keys.hpp"

#include <algorithm>
#include <array>

namespace microslip {

namespace {

/// Where nodes and edges have places of their own, or steps a length.
constexpr std::string_view whole_contact =
    "leading_edge standard, exact or trimmed, or problem transient or cylinder";

constexpr std::string_view elements = "scenes without method chebyshev and target_error";

constexpr auto keys = std::to_array<Key>({
    {"problem", "1", "what is solved", "steady, transient, cylinder", ""},
    {"material.shear_modulus", "N/mm^2", "combined shear modulus G", "> 0", ""},
    {"material.poisson_ratio", "1", "combined Poisson ratio nu", "0 ... 0.5", ""},
    {"contact.half_width", "mm", "half-width a of the contact", "> 0", ""},
    {"contact.peak_traction", "N/mm^2", "peak mu p0 of the Hertzian traction bound", "> 0", ""},
    {"contact.bound_polynomial", "1",
     "coefficients of h, from the constant up: the bound is peak (1 - (x/a)^2)^(1/2) h(x/a)",
     "1 to 33 numbers, h >= 0; the peak is then [1]", ""},
    {"contact.bound_file", "1",
     "table with columns x and bound, linear between its rows, to zero at +-a",
     "a file; instead of contact.peak_traction",
     "scenes without contact.peak_traction and contact.bound_polynomial"},
    {"kernel.type", "1", "half-space loaded over a strip, or plane strain", "strip, plane", ""},
    {"kernel.width", "mm", "width Dy of the strip", "> 0", "kernel.type strip"},
    {"kernel.length", "mm", "plane strain: distance L0 at which the displacement counts as zero",
     "> 0", "kernel.type plane"},
    {"grid.elements", "1", "number N of nodes", "1 ... 4 000 000; 20 000 where matrices are dense",
     "scenes without target_error"},
    {"grid.leading_offset", "1", "beta: the leading edge lies beta dx beyond the last node",
     "0 ... 1 [0.5]", whole_contact},
    {"grid.trailing_offset", "1", "alpha: the trailing edge lies alpha dx before the first node",
     "0 ... 1 [0.5]", whole_contact},
    {"method", "1", "how steady rolling is solved", "collocation, chebyshev [collocation]",
     "problem steady without target_error"},
    {"leading_edge", "1", "how steady collocation treats its edges",
     "inversion, calibrated, standard, exact, trimmed [inversion]",
     "problem steady with method collocation, without target_error"},
    {"basis", "1", "traction basis functions", "constant, linear, quadratic (odd N) [constant]",
     elements},
    {"target_error", "1", "relative error wanted of the force or creepage of steady rolling",
     "1e-11 ... 0.1; instead of method, basis and grid", "problem steady"},
    {"load.creepage", "1", "relative rigid slip w", "finite", "problem steady or transient"},
    {"load.force", "N/mm", "force F", "less than full sliding; instead of load.creepage",
     "problem steady or transient"},
    {"start.type", "1",
     "start of a transient: no tractions, those of a shift without rolling, or those of a file",
     "rest, cattaneo, file", "problem transient"},
    {"start.force", "N/mm", "force of the shift", "less than full sliding [load.force]",
     "start.type cattaneo"},
    {"start.file", "1", "table with columns x and traction", "a file", "start.type file"},
    {"step.ratio", "1",
     "c = dq/dx; of a transient one or more, taken in turn; of a cylinder a step lasts c dx / v",
     ">= 1e-15 [1, but none for a transient]", whole_contact},
    {"step.scheme", "1", "how the previous tractions move with the material",
     "material, direct, relaxed, relaxed_traction, fractional [material]",
     "problem transient or cylinder"},
    {"step.relaxation", "1", "c* of the relaxed schemes", ">= step.ratio [1]",
     "step.scheme relaxed or relaxed_traction"},
    {"cylinder.mass", "N s^2/mm^2", "m, per mm of width (1 N s^2/mm = 1000 kg)", "> 0",
     "problem cylinder"},
    {"cylinder.inertia", "N s^2", "I, per mm of width; of a solid cylinder m R^2/2", "> 0",
     "problem cylinder"},
    {"cylinder.radius", "mm", "R", "> 0", "problem cylinder"},
    {"cylinder.slope_force", "N/mm", "F_cm, gravity along the slope", "> 0", "problem cylinder"},
    {"motion.distance", "mm", "distance rolled", "> 0, at most 1e6 steps",
     "problem transient or cylinder"},
    {"motion.integrator", "1", "how motion and contact go together",
     "midpoint, verlet, leapfrog [midpoint]", "problem cylinder"},
    {"solver.type", "1", "how systems are solved", "auto, dense, fft [auto]", elements},
    {"solver.tolerance", "1", "largest residual of a result, relative to its terms",
     "1e-12 ... 1e-3 [1e-10]", elements},
    {"solver.violation", "1",
     "largest violation of the bound and of the direction of slip that is accepted, relative to "
     "the load",
     "above 0, at most 1 [0.05]", elements},
    {"solver.condition", "1", "largest condition number that is accepted", ">= 1 [1e13]", elements},
});

}  // namespace

std::span<const Key> keys_of_scenes() { return keys; }

const Key* find_key(std::string_view name) {
  const auto found = std::ranges::find(keys, name, &Key::name);
  return found == keys.end() ? nullptr : &*found;
}

std::string unit_of_key(std::string_view key) {
  const Key* found = find_key(key);
  return std::string(found == nullptr ? "1" : found->unit);
}

}  // namespace microslip
