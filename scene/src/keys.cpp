// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/keys.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <cmath>

#include "microslip/halfspace/basis.hpp"
#include "microslip/halfspace/grid.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/solver.hpp"
#include "microslip/rolling/evidence.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/nearest.hpp"

namespace microslip {

namespace {

using enum Key::Type;

/// In these scenes nodes and edges have places of their own, or steps have a length.
constexpr std::string_view whole_contact =
    "leading_edge standard, known_edge or trimmed, or problem transient or cylinder";

constexpr std::string_view elements = "scenes without method chebyshev and target_error";
constexpr std::string_view with_load = "scenes with contact.normal_load";
constexpr std::string_view with_roughness = "scenes with contact.roughness";
constexpr std::string_view with_friction_law = "scenes with contact.friction_law";
constexpr std::string_view takes_friction_law =
    "problem steady or transient of bodies of one material, without target_error and method "
    "chebyshev, with step.scheme remembered, or direct of a line contact";
constexpr std::string_view half_spaces = "kernel.type strip or plane, or contact.normal_load";
constexpr std::string_view unlike =
    "problem steady or transient with kernel.type plane, without target_error";
constexpr std::string_view rolls = "problem transient or cylinder";
constexpr std::string_view line_contacts = "line contacts";
constexpr std::string_view ellipses = "ellipses";
constexpr std::string_view ellipses_by_shifts = "ellipses with start.type cattaneo";
constexpr std::string_view steady_or_transient = "problem steady or transient";
constexpr std::string_view transient = "problem transient";
constexpr std::string_view by_shifts = "start.type cattaneo";
constexpr std::string_view lateral_radii = "problem steady or transient with contact.normal_load";
constexpr std::string_view response = "microslip response";
constexpr std::string_view converge = "microslip converge";
constexpr std::string_view curve = "microslip curve";
constexpr std::string_view curve_of_ellipse = "ellipses with microslip curve";
constexpr std::string_view along_creepage = "microslip curve along a creepage";
constexpr std::string_view along_spin = "microslip curve with curve.along spin";

constexpr auto keys = std::to_array<Key>({
    {.name = "problem",
     .type = word,
     .meaning = "what is solved",
     .words = {"steady", "transient", "cylinder"}},
    {"material.shear_modulus", number, "N/mm^2",
     "combined shear modulus G; of the driven body if the other body has its own", above_zero, "",
     half_spaces},
    {"material.youngs_modulus", number, "N/mm^2",
     "Young's modulus E, G = E/(2 (1 + nu)), of both bodies or of the driven one", above_zero,
     "instead of material.shear_modulus", half_spaces},
    {"material.poisson_ratio", number, "1",
     "combined Poisson ratio nu; of the driven body if the other body has its own", range(0, 0.5),
     "", half_spaces},
    {"material.shear_modulus_2", number, "N/mm^2", "shear modulus of the other body", above_zero,
     "", unlike},
    {"material.youngs_modulus_2", number, "N/mm^2", "Young's modulus of the other body", above_zero,
     "instead of material.shear_modulus_2", unlike},
    {"material.poisson_ratio_2", number, "1", "Poisson ratio of the other body", range(0, 0.5), "",
     unlike},
    {"material.dundurs_beta", number, "1",
     "Dundurs' beta of bodies with those combined constants; above zero if the driven body is the "
     "stiffer one",
     range(-0.5, 0.5), "instead of material.shear_modulus_2; none where bodies are alike", unlike},
    {.name = "direction",
     .type = word,
     .meaning = "direction of creepage and tractions: along the rolling or across it",
     .role = "problem steady or transient with kernel.type strip or plane",
     .words = {"longitudinal", "lateral"},
     .first_is_default = true},
    {"contact.half_width", number, "mm", "half-width a of the contact", above_zero},
    {"contact.lateral_half_width", number, "mm",
     "half-width b of an ellipse, across the rolling: the contact has three dimensions", above_zero,
     "between a/10 and 1000 a; or contact.lateral_radius_1 or _2", steady_or_transient},
    {"contact.peak_traction", number, "N/mm^2", "peak mu p0 of the Hertzian traction bound",
     above_zero},
    {.name = "contact.normal_load",
     .unit = "N/mm",
     .meaning =
         "normal load, of a line contact per mm of width: with the radii of both bodies, "
         "half-widths and peak follow by Hertz; with half-widths of an ellipse the peak alone",
     .range = above_zero,
     .note = "instead of contact.half_width, contact.peak_traction, contact.bound_polynomial and "
             "contact.bound_file; with contact.lateral_half_width instead of contact.peak_traction",
     .patch_unit = "N"},
    {"contact.radius_1", number, "mm",
     "radius of the one body in the plane of rolling: of a wheel, its rolling radius", above_zero,
     "", with_load},
    {.name = "contact.radius_2",
     .unit = "mm",
     .meaning =
         "radius of the other body in the same plane, as of a roller with a parallel axis; not "
         "the crown radius of a rail, which is a plane along the rolling: then not given",
     .note = "> 0, or negative for a concave body, then larger in size than contact.radius_1",
     .role = with_load},
    {.name = "contact.lateral_radius_1",
     .unit = "mm",
     .meaning = "radius of the first body across the rolling, as of a wheel's profile: the contact "
                "is an ellipse, by Hertz",
     .note = "> 0, or negative for a concave body; flat across the rolling if it is not given",
     .role = lateral_radii},
    {.name = "contact.lateral_radius_2",
     .unit = "mm",
     .meaning = "radius of the other body across the rolling, as the crown radius of a rail",
     .note = "> 0, or negative for a concave body; flat across the rolling if it is not given",
     .role = lateral_radii},
    {"contact.friction", number, "1", "friction coefficient mu", range_above(0, 10), "",
     "scenes with contact.normal_load, or bodies of different material"},
    {.name = "contact.friction_law",
     .type = word,
     .meaning = "fall of friction with the speed of slip s V, from the bound at rest",
     .note = "none: Coulomb's friction",
     .role = takes_friction_law,
     .words = {"linear", "exponential", "rational", "table"}},
    {.name = "contact.kinetic_ratio",
     .meaning = "friction at a high speed of slip over that at rest, mu_k/mu_s",
     .range = fraction,
     .role = "scenes with contact.friction_law, but for a table"},
    {.name = "contact.half_speed",
     .unit = "mm/s",
     .meaning = "speed of slip at which half of the fall is done",
     .range = above_zero,
     .role = "scenes with contact.friction_law, but for a table"},
    {.name = "contact.friction_file",
     .type = file,
     .meaning = "table with columns speed, of slip, and ratio, friction over that at rest; linear "
                "between its rows, constant behind the last one",
     .note = "a file; the first row has speed 0 and ratio 1",
     .role = "contact.friction_law table"},
    {.name = "contact.friction_memory",
     .unit = "mm",
     .meaning = "length of slip over which friction comes to that of the law, but for 1/e",
     .range = range_from(0),
     .note = "none: friction is that of the law at once",
     .role = with_friction_law},
    {.name = "contact.memory_speed",
     .unit = "mm/s",
     .meaning = "least speed with which that length is used up, also where the bodies stick",
     .range = range_from(0),
     .role = "scenes with contact.friction_memory",
     .fallback = 0},
    {.name = "contact.slip_branch",
     .type = word,
     .meaning = "of several solutions, the one that is found from sticking bodies, or from bodies "
                "that slide fast",
     .role = with_friction_law,
     .words = {"least", "most"},
     .first_is_default = true},
    {.name = "contact.bound_polynomial",
     .type = list,
     .meaning =
         "coefficients of h, from the constant up: the bound is peak (1 - (x/a)^2)^(1/2) h(x/a)",
     .note = "1 to 33 numbers, h >= 0; the peak is then 1 if it is not given"},
    {.name = "contact.patch_file",
     .type = file,
     .meaning = "edges of a contact that has three dimensions and need not be an ellipse: columns "
                "y, trailing and leading, and lobe if there are several",
     .note = "a file; instead of contact.half_width",
     .role = steady_or_transient},
    {.name = "contact.bound_file",
     .type = file,
     .meaning = "table with columns x and bound, linear between its rows, to zero at +-a; of an "
                "ellipse or another patch x, y and bound, whose square is linear",
     .note = "a file; instead of contact.peak_traction",
     .role = "scenes without contact.peak_traction and contact.bound_polynomial"},
    {.name = "contact.roughness",
     .meaning =
         "amplitude of a self-affine profile (root of its mean square over the bound), by which "
         "Hertz's bound is multiplied",
     .range = range(0, 10),
     .note = "none: a smooth bound",
     .role = "scenes with contact.peak_traction, without contact.bound_polynomial"},
    {.name = "contact.hurst",
     .meaning = "Hurst exponent of the profile: the smaller, the rougher",
     .range = range_above(0, 1),
     .role = with_roughness,
     .fallback = 0.8},
    {.name = "contact.rows",
     .type = whole,
     .meaning = "rows of the rough bound, with waves down to two rows",
     .range = range(9, 1000001),
     .role = with_roughness,
     .fallback = 2049},
    {.name = "contact.seed",
     .type = whole,
     .meaning = "another profile for each seed",
     .range = range(0, 4294967295),
     .role = with_roughness,
     .fallback = 1},
    {.name = "kernel.type",
     .type = word,
     .meaning = "half-space loaded over a strip, or in plane strain; springs alone; or a kernel by "
                "its symbol",
     .role = line_contacts,
     .words = {"strip", "plane", "winkler", "symbol"}},
    {"kernel.width", number, "mm", "width Dy of the strip", above_zero, "", "kernel.type strip"},
    {"kernel.length", number, "mm",
     "plane strain: distance L0 at which the displacement counts as zero", above_zero,
     "in transients and cylinders above (a + dx)/2, with step.scheme fractional from 3.8 a "
     "on",
     "kernel.type plane"},
    {"kernel.compliance", number, "mm^3/N",
     "C, displacement over the traction at the same place: of springs alone, or of a layer of them "
     "on the half-space",
     above_zero, "no layer on strip and plane without it", "kernel.type strip, plane or winkler"},
    {.name = "kernel.table",
     .type = file,
     .meaning = "table with columns wave_number [1/mm] and symbol [mm^3/N], displacement over "
                "traction of waves p cos(wave_number x)",
     .note = "a file with 2 to 1000 rows, of numbers > 0, wave numbers rising",
     .role = "kernel.type symbol"},
    {"grid.elements", whole, "1", "number N of nodes; of an ellipse, of the cells of each row",
     range(1, Grid::max_elements),
     "20 000 where matrices are dense; of an ellipse 2 ... 100, and the program's choice without "
     "it and grid.rows",
     "scenes without target_error"},
    {"grid.rows", whole, "1", "number M of rows of an ellipse", range(1, 100),
     "the program's choice without it and grid.elements", "ellipses without target_error"},
    {.name = "grid.leading_offset",
     .meaning = "distance from the last node to the leading edge, in elements",
     .range = fraction,
     .role = whole_contact,
     .fallback = 0.5},
    {.name = "grid.trailing_offset",
     .meaning = "distance from the trailing edge to the first node, in elements",
     .range = fraction,
     .role = whole_contact,
     .fallback = 0.5},
    {.name = "method",
     .type = word,
     .meaning = "how steady rolling is solved",
     .role = "problem steady without target_error",
     .words = {"collocation", "chebyshev"},
     .first_is_default = true},
    {.name = "leading_edge",
     .type = word,
     .meaning = "how steady collocation treats its edges",
     .role = "problem steady with method collocation, without target_error",
     .catalogue = &leading_edge_names,
     .first_is_default = true},
    {.name = "basis",
     .type = word,
     .meaning = "traction basis functions",
     .note = "quadratic for odd N",
     .role = elements,
     .catalogue = &basis_names,
     .first_is_default = true},
    {"target_error", number, "1",
     "relative error wanted of the force or creepage of steady rolling; of an ellipse of forces "
     "over full sliding, moment and motions",
     range(1e-11, 0.1), "instead of method, basis and grid", "problem steady"},
    {.name = "load.creepage", .meaning = "relative rigid slip w", .role = steady_or_transient},
    {.name = "load.force",
     .unit = "N/mm",
     .meaning = "force F",
     .note = "less than full sliding; instead of load.creepage",
     .role = steady_or_transient,
     .patch_unit = "N"},
    {.name = "load.force_ratio",
     .meaning = "force over full sliding",
     .note = "above -1, below 1; instead of load.creepage",
     .role = steady_or_transient},
    {.name = "load.stick_ratio",
     .meaning = "part a' of the contact that sticks in Carter's solution; the force is "
                "a'^2 - 1 times full sliding",
     .note = "above 0, below 1, for Hertz's bound in plane strain; instead of load.creepage",
     .role = steady_or_transient},
    {.name = "load.lateral_creepage",
     .meaning = "eta, relative rigid slip across the rolling",
     .note = "0 if none of the component is given",
     .role = ellipses},
    {.name = "load.lateral_force",
     .unit = "N",
     .meaning = "Fy, force across the rolling",
     .note = "less than full sliding; instead of load.lateral_creepage",
     .role = ellipses},
    {.name = "load.lateral_force_ratio",
     .meaning = "Fy over full sliding",
     .note = "above -1, below 1; instead of load.lateral_creepage",
     .role = ellipses},
    {.name = "load.spin",
     .unit = "1/mm",
     .meaning = "phi, angular velocity of spin over the velocity of rolling: the rigid slip is (xi "
                "- phi y, eta + phi x)",
     .note = "0 if none of the component is given",
     .role = ellipses},
    {.name = "load.spin_moment",
     .unit = "N mm",
     .meaning = "Mz, moment about the centre of the contact",
     .note = "less than if all turns about the centre; instead of load.spin",
     .role = ellipses},
    {.name = "load.spin_moment_ratio",
     .meaning = "Mz over its largest value, which is that if all turns about the centre",
     .note = "above -1, below 1; instead of load.spin",
     .role = ellipses},
    {.name = "load.file",
     .type = file,
     .meaning = "a run, linear between its rows: columns q, or t and v; creepage, force or omega; "
                "and of the contact normal_load, half_width, peak_traction, friction; with units "
                "behind them, t [s]; of an ellipse also lateral_creepage or lateral_force, spin or "
                "spin_moment",
     .note = "a file; instead of load.creepage, of an ellipse instead of the keys of its columns",
     .role = transient,
     .patch_role = transient},
    {.name = "load.columns",
     .type = Key::Type::text,
     .meaning = "names of columns of load.file: t = Time, v = Speed [km/h], creepage = Slip",
     .note = "NAME = NAME IN THE FILE, with commas between them; the names of load.file without it",
     .role = "load.file",
     .patch_role = "load.file"},
    {.name = "load.speed",
     .unit = "mm/s",
     .meaning = "speed of rolling V",
     .range = above_zero,
     .role = "scenes with contact.friction_law, but for a load.file with times"},
    {.name = "load.radius",
     .unit = "mm",
     .meaning = "R of the creepage (v - omega R)/v",
     .range = above_zero,
     .role = "load.file with a column omega",
     .patch_role = "load.file with a column omega"},
    {.name = "start.type",
     .type = word,
     .meaning = "start of a transient: no tractions, a shift without rolling, tractions of a file, "
                "or a state that --save wrote",
     .role = transient,
     .words = {"rest", "cattaneo", "file", "state"},
     .patch_role = transient},
    {.name = "start.force",
     .type = list,
     .unit = "N/mm",
     .meaning = "force of the shift; or several, shifted to one after the other",
     .note =
         "each less than full sliding; load.force if neither it nor start.shift is given; of an "
         "ellipse all resultants of the load if no key of a shift is given",
     .role = by_shifts,
     .patch_unit = "N",
     .patch_role = by_shifts},
    {.name = "start.shift",
     .type = list,
     .unit = "mm",
     .meaning =
         "rigid shift, or several, one after the other; a positive one gives a negative force",
     .note = "finite; instead of start.force",
     .role = by_shifts,
     .patch_role = by_shifts},
    {.name = "start.lateral_force",
     .type = list,
     .unit = "N",
     .meaning = "Fy at the end of the shift, or of each of them",
     .note = "less than full sliding, as many numbers as the other components have; instead of "
             "start.lateral_shift",
     .role = ellipses_by_shifts,
     .patch_role = by_shifts},
    {.name = "start.lateral_shift",
     .type = list,
     .unit = "mm",
     .meaning = "rigid shift across the rolling, or several, one after the other",
     .note = "0 if none of the component is given",
     .role = ellipses_by_shifts,
     .patch_role = by_shifts},
    {.name = "start.spin_moment",
     .type = list,
     .unit = "N mm",
     .meaning = "Mz at the end of the shift, or of each of them",
     .note = "less than if all turns about the centre; instead of start.rotation",
     .role = ellipses_by_shifts,
     .patch_role = by_shifts},
    {.name = "start.rotation",
     .type = list,
     .unit = "rad",
     .meaning = "rigid rotation about the normal, or several, one after the other",
     .note = "0 if none of the component is given",
     .role = ellipses_by_shifts,
     .patch_role = by_shifts},
    {.name = "start.file",
     .type = file,
     .meaning =
         "table with columns x and traction, with rows up to the edges of the contact; of an "
         "ellipse or patch columns x, y, traction_x and traction_y",
     .note = "a file",
     .role = "start.type file",
     .patch_role = "start.type file"},
    {.name = "start.state",
     .type = file,
     .meaning = "state of a transient that --save wrote, for the same contact, kernel, grid and "
                "solver; the run continues from its distance",
     .note = "a file",
     .role = "start.type state",
     .patch_role = "start.type state"},
    {.name = "step.ratio",
     .type = list,
     .meaning =
         "c = dq/dx, in an ellipse dx = 2 a/N; of a transient one or more, taken in turn; of a "
         "cylinder a step lasts c dx / v, and near rest the part c dx/a of the period on the "
         "contact or less",
     .range = {.least = min_step_ratio},
     .note = "no default in a transient, except with load.file, where steps end at its rows; with "
             "step.tolerance one, the longest",
     .role = whole_contact,
     .fallback = 1,
     .patch_role = transient},
    {"step.tolerance", number, "1",
     "steps of load.file are as long as the load is straight: the shift (integral of the creepage) "
     "or force to this part of full sliding, half-width and bound to this part of the problem's",
     range(1e-9, 0.1), "off without it", "load.file of a line contact with step.scheme remembered"},
    {.name = "step.scheme",
     .type = word,
     .meaning = "how the previous tractions move with the material; in an ellipse remembered, or "
                "direct or relaxed on equal rectangles",
     .role = rolls,
     .catalogue = &advection_names,
     .first_is_default = true,
     .patch_role = transient},
    {.name = "step.relaxation",
     .meaning = "c* of the relaxed schemes",
     .note = "at least step.ratio",
     .role = "step.scheme relaxed or relaxed_traction",
     .fallback = 1,
     .patch_role = "step.scheme relaxed"},
    {"cylinder.mass", number, "N s^2/mm^2", "m, per mm of width (1 N s^2/mm = 1000 kg)", above_zero,
     "", "problem cylinder"},
    {"cylinder.inertia", number, "N s^2", "I, per mm of width; of a solid cylinder m R^2/2",
     above_zero, "", "problem cylinder"},
    {"cylinder.radius", number, "mm", "R", above_zero, "", "problem cylinder"},
    {"cylinder.slope_force", number, "N/mm", "F_cm, gravity along the slope", above_zero, "",
     "problem cylinder"},
    {.name = "cylinder.velocity",
     .unit = "mm/s",
     .meaning = "v at the start, where it rolls freely",
     .range = {.least = 0},
     .role = "problem cylinder",
     .fallback = 0},
    {.name = "motion.distance",
     .unit = "mm",
     .meaning = "distance rolled; the last step of a transient is shortened to end there",
     .range = above_zero,
     .note = "at most 1e6 steps; with load.file at most its distance, which is the default; with "
             "start.state more than its distance, which is included",
     .role = rolls,
     .patch_role = transient},
    {.name = "motion.instants",
     .type = whole,
     .meaning = "number of instants, evenly spread over the run up to its end, at which tractions "
                "are written, too",
     .range = range(1, 1000),
     .note = "none without it",
     .role = transient,
     .patch_role = transient},
    {.name = "motion.instants_at",
     .type = list,
     .unit = "mm",
     .meaning = "the same at distances rolled; each instant is the end of a step, the nearest one",
     .note = "in rising order, within the run, with ranges as in a sweep; instead of "
             "motion.instants",
     .role = transient,
     .patch_role = transient},
    {.name = "motion.integrator",
     .type = word,
     .meaning = "how motion and contact go together",
     .role = "problem cylinder",
     .words = {"midpoint", "verlet", "leapfrog"},
     .first_is_default = true},
    {"motion.tolerance", number, "1",
     "error of v from the length of time steps, relative to (v^2 + 2 a F_cm/m)^1/2: "
     "steps are shorter than step.ratio asks where it is estimated to be larger",
     range_above(0, 1), "off without it", "problem cylinder with motion.integrator midpoint"},
    {.name = "solver.type",
     .type = word,
     .meaning = "how systems are solved",
     .role = elements,
     .words = {"auto", "dense", "fft"},
     .first_is_default = true},
    {.name = "solver.tolerance",
     .meaning = "largest residual of a result, relative to its terms",
     .range = {.least = 1e-12, .most = 1e-3},
     .role = elements,
     .fallback = Solver{}.tolerance},
    {.name = "solver.violation",
     .meaning = "largest violation of the bound and of the direction of slip that is accepted, "
                "relative to the load",
     .range = {.least = 0, .most = 1, .open = true},
     .role = elements,
     .fallback = Acceptance{}.violation},
    {.name = "solver.condition",
     .meaning = "largest condition number that is accepted",
     .range = {.least = 1},
     .role = elements,
     .fallback = Acceptance{}.condition},
    {"response.shortest", number, "mm", "shortest wavelength", above_zero,
     "0.3 half-lengths of the stick zone without it", response},
    {"response.longest", number, "mm", "longest wavelength", above_zero,
     "300 half-lengths without it", response},
    {.name = "response.wavelengths",
     .type = whole,
     .meaning = "number of wavelengths, evenly spaced in their logarithms",
     .range = {.least = 2, .most = 1e5},
     .role = response,
     .fallback = 60},
    {.name = "curve.along",
     .type = word,
     .meaning = "motion that varies; the others are those of the load",
     .role = curve_of_ellipse,
     .words = {"creepage", "lateral_creepage", "spin"},
     .first_is_default = true},
    {.name = "curve.creepages",
     .type = list,
     .meaning = "creepages of the curve",
     .note = "in rising order, with ranges as in a sweep; evenly spaced without it",
     .role = curve,
     .patch_role = along_creepage},
    {.name = "curve.spins",
     .type = list,
     .unit = "1/mm",
     .meaning = "spins of a curve along spin",
     .note = "in rising order, with ranges as in a sweep; evenly spaced without it",
     .role = curve_of_ellipse,
     .patch_role = along_spin},
    {.name = "curve.points",
     .type = whole,
     .meaning = "number of points, evenly spaced from 0 on; of an ellipse on both sides of 0 where "
                "the curve has no symmetry",
     .range = {.least = 2, .most = 10000},
     .role = curve,
     .fallback = 51},
    {.name = "curve.largest",
     .meaning = "largest creepage of these",
     .range = above_zero,
     .note = "by default a quarter beyond the creepage at 0.999 of full sliding; of an ellipse a "
             "quarter beyond three times full sliding over the slope",
     .role = curve,
     .patch_role = along_creepage},
    {.name = "curve.largest_spin",
     .unit = "1/mm",
     .meaning = "largest spin of these",
     .range = above_zero,
     .note = "by default in the same way",
     .role = curve_of_ellipse,
     .patch_role = along_spin},
    {.name = "curve.beside",
     .type = word,
     .meaning = "laws of creep forces for comparison, one or more; of a line contact fastsim alone",
     .role = curve,
     .words = {"nothing", "fastsim", "fastsim_one", "vermeulen_johnson", "polach"},
     .first_is_default = true},
    {.name = "curve.kalker_factor",
     .meaning = "factor of Kalker's coefficients in these laws, as vehicle dynamics reduce them",
     .range = range_above(0, 1),
     .role = curve_of_ellipse,
     .fallback = 1,
     .patch_role = "microslip curve with curve.beside"},
    {"converge.elements", wholes, "1", "numbers N to try", range(2, 100000),
     "in rising order, 15 31 63 127 255 without it; of an ellipse up to 66", converge},
    {.name = "converge.error",
     .meaning = "relative error of the force or creepage to reach",
     .range = {.least = 0, .most = 1, .open = true},
     .role = converge,
     .fallback = 1e-3},
    {"converge.step_time", number, "s", "time that the longest step of a transient may take",
     above_zero, "off without it", converge},
    {.name = "converge.reference",
     .type = word,
     .meaning = "reference of the errors: the inversion where it holds and otherwise fine, method "
                "chebyshev, or the default scheme with more elements",
     .note = "chebyshev in steady rolling",
     .role = converge,
     .words = {"best", "chebyshev", "fine"},
     .first_is_default = true},
});

/// "1e13", and "4 000 000" of whole numbers.
std::string written(double value, Key::Type type) {
  std::string text = format_short(value);
  if (const std::size_t plus = text.find('+'); plus != std::string::npos) {
    text.erase(plus, text[plus + 1] == '0' ? 2 : 1);
  }
  if (type != whole && type != wholes) return text;
  text = fmt::format("{:.0f}", value);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ' ');
  return text;
}

std::string range_of(const Key& key) {
  const auto [least, most, open, below] = key.range;
  const std::string from = written(least, key.type);
  if (std::isinf(least)) return "";
  if (std::isinf(most)) return (open ? "> " : ">= ") + from;
  const std::string to = written(most, key.type);
  if (!open && !below) return fmt::format("{} ... {}", from, to);
  return fmt::format("{} {}, {} {}", open ? "above" : "at least", from, below ? "below" : "at most",
                     to);
}

}  // namespace

std::span<const Key> keys_of_scenes() { return keys; }

const Key* find_key(std::string_view name) {
  const auto found = std::ranges::find(keys, name, &Key::name);
  return found == keys.end() ? nullptr : &*found;
}

std::string likely_key(const std::string& key, const std::vector<std::string>& known) {
  const auto last_name = [](const std::string& name) { return name.substr(name.rfind('.') + 1); };
  const std::string small = boost::algorithm::to_lower_copy(key);
  std::vector<std::string> elsewhere;
  for (const std::string& name : known) {
    if (name == small && name != key) return name;
    if (last_name(name) == last_name(small)) elsewhere.push_back(name);
  }
  return elsewhere.empty() ? nearest(small, known) : nearest(small, elsewhere, key.size());
}

std::string likely_key(const std::string& key) {
  return likely_key(key, names_of(keys_of_scenes()));
}

bool is_patch_key(std::string_view key) {
  return std::ranges::find(patch_keys, key) != patch_keys.end();
}

std::string_view unit_of(const Key& key, bool in_patch) {
  return in_patch && !key.patch_unit.empty() ? key.patch_unit : key.unit;
}

std::string unit_of_key(std::string_view key, bool in_patch) {
  const Key* found = find_key(key);
  return std::string(found == nullptr ? "1" : unit_of(*found, in_patch));
}

std::vector<std::string_view> words_of(const Key& key) {
  if (key.catalogue != nullptr) return key.catalogue();
  return {key.words.begin(), std::ranges::find(key.words, "")};
}

std::string default_of(const Key& key) {
  if (key.first_is_default) return std::string(words_of(key)[0]);
  return std::isnan(key.fallback) ? "" : written(key.fallback, key.type);
}

std::string accepted_by(const Key& key, const std::string& fallback, const std::string& quote) {
  const std::string of_words = key.type == word ? quote : "";
  std::string text =
      key.type == word
          ? fmt::format("{0}{1}{0}", quote, joined(words_of(key), fmt::format("{0}, {0}", quote)))
          : range_of(key);
  if (text.empty()) text = key.note.empty() ? "finite" : key.note;
  const bool has_note_behind = !key.note.empty() && !text.starts_with(key.note);
  if (!fallback.empty()) text += fmt::format(" [{0}{1}{0}]", of_words, fallback);
  return has_note_behind ? fmt::format("{}; {}", text, key.note) : text;
}

std::string expected_by(const Key& key) {
  const char* kind = key.type == whole    ? "a whole number "
                     : key.type == list   ? "numbers "
                     : key.type == wholes ? "whole numbers "
                                          : "a number ";
  return kind + accepted_by(key, "");
}

}  // namespace microslip
