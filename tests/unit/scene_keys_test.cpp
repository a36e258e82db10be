// SPDX-License-Identifier: GPL-3.0-or-later
// Which key has a role in which scene: each key is typed into each scene, and is either accepted or
// refused by name. Values that are the defaults make no difference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "good_scene.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/nearest.hpp"
#include "scene_text.hpp"

namespace microslip::scene_keys_test {

using Settings = std::vector<std::string>;

const Settings steady = {"problem=steady", "load.creepage=0.4", "grid.elements=21"};
const Settings transient = {"problem=transient",   "grid.elements=21", "start.type=cattaneo",
                            "motion.distance=0.3", "load.force=-1",    "step.ratio=1"};
const Settings cylinder = {
    "problem=cylinder",     "grid.elements=21",         "cylinder.mass=1",    "cylinder.radius=100",
    "cylinder.inertia=5e3", "cylinder.slope_force=0.3", "motion.distance=0.3"};

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

const Settings plane = with(steady, {"kernel.width=", "kernel.type=plane", "kernel.length=10"});

const Settings ellipse =
    with(steady, {"kernel.type=", "kernel.width=", "contact.lateral_half_width=0.7", "grid.rows=5",
                  "load.spin=0.1"});

const Settings patch = with(
    ellipse, {"contact.lateral_half_width=", "contact.half_width=", "contact.patch_file=edges"});

const Settings steps =
    with(ellipse, {"problem=transient", "load.creepage=", "start.type=cattaneo",
                   "step.scheme=remembered", "step.ratio=1", "motion.distance=0.3"});

const Settings without_material =
    with(steady, {"kernel.width=", "material.shear_modulus=", "material.poisson_ratio="});

const Settings falling = with(steady, {"contact.friction_law=linear", "contact.kinetic_ratio=0.6",
                                       "contact.half_speed=1e-3", "load.speed=1"});

/// In each, all that has to be there, and the choices that its name says.
const std::map<std::string, Settings> scenes = {
    {"calibrated", steady},
    {"plane", plane},
    {"unlike", with(plane, {"material.shear_modulus_2=2", "material.poisson_ratio_2=0.3",
                            "contact.friction=0.3"})},
    {"youngs_2", with(plane, {"material.youngs_modulus_2=2", "material.poisson_ratio_2=0.3",
                              "contact.friction=0.3"})},
    {"dundurs", with(plane, {"material.dundurs_beta=0.1", "contact.friction=0.3"})},
    {"layer", with(plane, {"kernel.compliance=0.1"})},
    {"winkler", with(without_material, {"kernel.type=winkler", "kernel.compliance=0.1"})},
    {"symbol", with(without_material, {"kernel.type=symbol", "kernel.table=symbol"})},
    {"polynomial", with(steady, {"contact.bound_polynomial=1 0.3"})},
    {"table", with(steady, {"contact.peak_traction=", "contact.bound_file=bound"})},
    {"rough", with(steady, {"contact.roughness=0.3"})},
    {"youngs", with(steady, {"material.shear_modulus=", "material.youngs_modulus=2.56"})},
    {"hertz",
     with(steady, {"contact.half_width=", "contact.peak_traction=", "contact.normal_load=0.01",
                   "contact.radius_1=100", "contact.friction=0.3"})},
    {"force_ratio", with(steady, {"load.creepage=", "load.force_ratio=-0.5"})},
    {"chebyshev", with(steady, {"method=chebyshev"})},
    {"target_error", with(steady, {"grid.elements=", "target_error=1e-3"})},
    {"standard", with(steady, {"leading_edge=standard"})},
    {"known_edge", with(steady, {"leading_edge=known_edge"})},
    {"trimmed", with(steady, {"leading_edge=trimmed", "basis=linear"})},
    {"remembered", transient},
    {"direct", with(transient, {"step.scheme=direct"})},
    {"relaxed", with(transient, {"step.scheme=relaxed"})},
    {"relaxed_traction", with(transient, {"step.scheme=relaxed_traction"})},
    {"fractional", with(transient, {"step.scheme=fractional"})},
    {"rest", with(transient, {"start.type=rest"})},
    {"file", with(transient, {"start.type=file", "start.file=traction"})},
    {"state", with(transient, {"start.type=state", "start.state=state"})},
    {"creepage", with(transient, {"load.force=", "load.creepage=0.1", "start.force=-1"})},
    {"run", with(transient, {"load.force=", "start.type=rest", "load.file=run", "load.radius=460",
                             "step.ratio=", "motion.distance="})},
    {"falling", falling},
    {"falling_table", with(falling, {"contact.friction_law=table", "contact.kinetic_ratio=",
                                     "contact.half_speed=", "contact.friction_file=law"})},
    {"falling_memory", with(transient, {"start.type=rest", "contact.friction_law=rational",
                                        "contact.kinetic_ratio=0.6", "contact.half_speed=1e-3",
                                        "load.speed=1", "contact.friction_memory=1"})},
    {"ellipse", ellipse},
    {"ellipse_target", with(ellipse, {"grid.rows=", "grid.elements=", "target_error=1e-3"})},
    {"loaded_ellipse",
     with(ellipse, {"contact.half_width=", "contact.peak_traction=", "contact.normal_load=0.01",
                    "contact.radius_1=100", "contact.friction=0.3",
                    "contact.lateral_half_width=", "contact.lateral_radius_1=80"})},
    {"ellipse_table", with(ellipse, {"contact.peak_traction=", "contact.bound_file=points"})},
    {"patch", patch},
    {"patch_table", with(patch, {"contact.peak_traction=", "contact.bound_file=points"})},
    {"steps", with(steps, {"load.force=-1"})},
    {"steps_run", with(steps, {"load.file=run", "load.radius=460", "start.type=rest"})},
    {"cylinder", cylinder},
    {"cylinder_relaxed", with(cylinder, {"step.scheme=relaxed", "motion.integrator=verlet"})}};

Scene scene_with(const Settings& settings);

/// Returns the saved state of the transient before it rolls.
std::string saved_state() {
  Scene scene = scene_with(with(transient, {"start.type=rest"}));
  return TransientRolling(read_transient(scene).problem).save();
}

Scene scene_with(const Settings& settings) {
  Scene scene = scene_of(good_contact);
  for (const std::string& setting : settings) scene.set(setting);
  scene.read_files_by([](const std::string& path) {
    return path == "bound"    ? "x bound\n0 1\n"
           : path == "run"    ? "t v omega\n0 1 0.002\n1 1 0.002\n"
           : path == "law"    ? "speed ratio\n0 1\n1 0.5\n"
           : path == "state"  ? saved_state()
           : path == "symbol" ? "wave_number symbol\n0.1 10\n10 0.2\n"
           : path == "edges"  ? "y trailing leading\n-1 0 0\n0 -1 1\n1 0 0\n"
           : path == "points" ? "x y bound\n-0.5 0 1\n0 0 1\n0.5 0 1\n0 -0.4 1\n0 0.4 1\n"
                              : "x traction\n-1 0\n-0.5 -0.1\n0 -0.1\n0.5 -0.1\n1 0\n";
  });
  return scene;
}

std::string answer(const Settings& settings) {
  return message_in_keys([&] {
    Scene scene = scene_with(settings);
    read_model(scene);
    scene.reject_unread();
  });
}

std::set<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

struct Role {
  std::string key;
  std::string value;   ///< the default, if it has one
  std::string scenes;  ///< where it has a role, by their names
};

const std::string unlike = "unlike youngs_2 dundurs ";
const std::string by_elements = unlike +
                                "layer winkler symbol calibrated plane polynomial table rough "
                                "youngs hertz force_ratio standard known_edge trimmed falling "
                                "falling_table ";
const std::string steady_scenes = by_elements + "chebyshev ";
const std::string with_target = steady_scenes + "target_error ";
const std::string differences = "standard known_edge trimmed ";
const std::string transients =
    "remembered direct relaxed relaxed_traction fractional rest file state creepage run "
    "falling_memory ";
const std::string cylinders = "cylinder cylinder_relaxed ";
const std::string strips =
    "calibrated polynomial table rough youngs hertz force_ratio chebyshev target_error standard "
    "known_edge trimmed falling falling_table " +
    transients + cylinders;
const std::string half_spaces = unlike + "plane layer " + strips;
const std::string lines = half_spaces + "winkler symbol ";
const std::string patch_steps = "steps steps_run ";
const std::string ellipses_by_grid =
    "ellipse loaded_ellipse ellipse_table patch patch_table " + patch_steps;
const std::string ellipses = "ellipse_target " + ellipses_by_grid;
const std::string shifted = "remembered direct relaxed relaxed_traction fractional creepage steps";
const std::string all = lines + ellipses;
const std::string hertzian = unlike +
                             "layer winkler symbol plane calibrated rough youngs force_ratio "
                             "chebyshev target_error standard known_edge trimmed falling "
                             "falling_table " +
                             transients + cylinders;
const std::string with_friction_law = "falling falling_table falling_memory";

/// In a choice between keys, the key that is not in a scene is refused with the others' names.
const std::vector<Role> roles = {
    {"problem", "", all},
    {"material.shear_modulus", "1", half_spaces + ellipses},
    {"material.poisson_ratio", "0.28", half_spaces + ellipses},
    {"material.youngs_modulus", "2.56", half_spaces + ellipses},
    {"material.shear_modulus_2", "2", "unlike youngs_2"},
    {"material.youngs_modulus_2", "2", "unlike youngs_2"},
    {"material.poisson_ratio_2", "0.3", "unlike youngs_2"},
    {"material.dundurs_beta", "0.1", unlike},
    {"direction", "longitudinal",
     unlike +
         "plane layer chebyshev target_error calibrated polynomial table rough youngs hertz "
         "force_ratio standard known_edge trimmed falling falling_table " +
         transients},
    {"contact.half_width", "1", all},
    {"contact.lateral_half_width", "0.7", ellipses},
    {"contact.lateral_radius_1", "80", ellipses},
    {"contact.lateral_radius_2", "80", ellipses},
    {"contact.peak_traction", "1", all},
    {"contact.normal_load", "0.01", all},
    {"contact.radius_1", "100", "hertz loaded_ellipse"},
    {"contact.radius_2", "100", "hertz loaded_ellipse"},
    {"contact.friction", "0.3", "hertz loaded_ellipse " + unlike},
    {"contact.friction_law", "linear",
     "layer winkler symbol calibrated plane polynomial table rough youngs hertz force_ratio "
     "standard known_edge trimmed remembered direct rest file state creepage run " +
         with_friction_law},
    {"contact.kinetic_ratio", "0.6", "falling falling_memory"},
    {"contact.half_speed", "1e-3", "falling falling_memory"},
    {"contact.friction_file", "law", "falling_table"},
    {"contact.friction_memory", "1", with_friction_law},
    {"contact.memory_speed", "0", "falling_memory"},
    {"contact.slip_branch", "least", with_friction_law},
    {"contact.bound_polynomial", "1", lines},
    {"contact.patch_file", "edges", "patch patch_table"},
    {"contact.bound_file", "bound", "table ellipse_table patch_table"},
    {"contact.roughness", "0.3", hertzian},
    {"contact.hurst", "0.8", "rough"},
    {"contact.rows", "2049", "rough"},
    {"contact.seed", "1", "rough"},
    {"kernel.type", "plane", lines},
    {"kernel.width", "40", strips},
    {"kernel.length", "10", "plane layer " + unlike},
    {"kernel.compliance", "0.1", half_spaces + "winkler "},
    {"kernel.table", "symbol", "symbol"},
    {"grid.elements", "21", steady_scenes + transients + cylinders + ellipses_by_grid},
    {"grid.rows", "5", ellipses_by_grid},
    {"grid.leading_offset", "0.5", differences + transients + cylinders},
    {"grid.trailing_offset", "0.5", differences + transients + cylinders},
    {"method", "collocation", steady_scenes},
    {"leading_edge", "calibrated", by_elements},
    {"basis", "constant", by_elements + transients + cylinders},
    {"target_error", "1e-3",
     with_target + "ellipse_target ellipse loaded_ellipse ellipse_table patch patch_table "},
    {"load.creepage", "0.4", with_target + transients + ellipses},
    {"load.force", "-1", with_target + transients + ellipses},
    {"load.force_ratio", "-0.5", with_target + transients + ellipses},
    {"load.lateral_creepage", "0.1", ellipses},
    {"load.lateral_force", "0.001", ellipses},
    {"load.lateral_force_ratio", "0.1", ellipses},
    {"load.spin", "0.1", ellipses},
    {"load.spin_moment", "0.1", ellipses},
    {"load.spin_moment_ratio", "0.1", ellipses},
    {"load.stick_ratio", "0.6", with_target + transients},
    {"load.file", "run", transients + patch_steps},
    {"load.columns", "t = t", "run steps_run"},
    {"load.speed", "1", with_friction_law},
    {"load.radius", "460", "run steps_run"},
    {"start.type", "rest", transients + patch_steps},
    {"start.force", "-1", shifted},
    {"start.shift", "0.1", shifted},
    {"start.lateral_force", "0.1", "steps"},
    {"start.lateral_shift", "0.1", "steps"},
    {"start.spin_moment", "0.1", "steps"},
    {"start.rotation", "0.1", "steps"},
    {"start.file", "traction", "file"},
    {"start.state", "state", "state"},
    {"step.ratio", "1", differences + transients + cylinders + patch_steps},
    {"step.tolerance", "1e-3", "run"},
    {"step.scheme", "relaxed_traction", transients + cylinders + patch_steps},
    {"step.relaxation", "1", "relaxed relaxed_traction cylinder_relaxed"},
    {"cylinder.mass", "1", cylinders},
    {"cylinder.inertia", "5e3", cylinders},
    {"cylinder.radius", "100", cylinders},
    {"cylinder.slope_force", "0.3", cylinders},
    {"cylinder.velocity", "0", cylinders},
    {"motion.distance", "0.3", transients + cylinders + patch_steps},
    {"motion.instants", "2", transients + patch_steps},
    {"motion.instants_at", "0.1 0.3", transients + patch_steps},
    {"motion.integrator", "midpoint", cylinders},
    {"motion.tolerance", "1e-4", "cylinder"},
    {"solver.type", "auto", by_elements + transients + cylinders},
    {"solver.tolerance", "1e-10", by_elements + transients + cylinders},
    {"solver.violation", "1e-3", by_elements + transients + cylinders},
    {"solver.condition", "1e13", by_elements + transients + cylinders},
    {"response.shortest", "1", ""},
    {"response.longest", "100", ""},
    {"response.wavelengths", "60", ""},
    {"converge.elements", "15 31", ""},
    {"converge.error", "1e-3", ""},
    {"converge.step_time", "1e-4", ""},
    {"converge.reference", "fine", ""},
    {"curve.creepages", "0.001 0.002", ""},
    {"curve.points", "51", ""},
    {"curve.largest", "0.01", ""},
    {"curve.beside", "fastsim", ""},
    {"curve.along", "spin", ""},
    {"curve.spins", "0.1 0.2", ""},
    {"curve.largest_spin", "0.1", ""},
    {"curve.kalker_factor", "0.6", ""}};

TEST(KeysOfScenes, AreAllInTheTableOfRoles) {
  std::vector<std::string> in_table, in_scenes;
  for (const Role& role : roles) in_table.push_back(role.key);
  for (const Key& key : keys_of_scenes()) in_scenes.emplace_back(key.name);
  std::ranges::sort(in_table);
  std::ranges::sort(in_scenes);
  EXPECT_EQ(in_table, in_scenes);
  for (const auto& [name, settings] : scenes) EXPECT_EQ(answer(settings), "") << name;
}

// A key that is in the scene keeps its value; target_error wants other keys away and has tests of
// its own.
TEST(KeysOfScenes, HaveARoleOrAreRefused) {
  for (const auto& [key, value, where] : roles) {
    const std::set<std::string> accepting = words(where);
    for (const auto& [name, settings] : scenes) {
      SCOPED_TRACE(key + " in " + name);
      const bool there = scene_with(settings).has(key);
      const bool has_role = accepting.contains(name);
      EXPECT_TRUE(has_role || !there);
      if (there || (key == "target_error" && has_role)) continue;
      // A line contact with one of these is an ellipse, to which its other keys do not belong.
      if (is_patch_key(key) && !has_role) continue;
      const std::string said = answer(with(settings, {key + "=" + value}));
      const bool by_choice = said.starts_with("expected only one of") ||
                             (key == "contact.bound_polynomial" && name == "table" &&
                              said.starts_with("key 'contact.bound_file' has no role"));
      // A state is of one scheme, and of one bound to the bit.
      const bool is_layer = key == "kernel.compliance";
      const bool does_not_fit =
          ((key == "contact.bound_polynomial" || key == "contact.roughness" ||
            key == "step.scheme" || is_layer) &&
           name == "state" && said.starts_with("start.state = 'state': ")) ||
          (key == "step.scheme" && name == "falling_memory" &&
           said.starts_with("key 'contact.friction_law' has no role")) ||
          said.find(": expected no table, because Chebyshev") != std::string::npos ||
          (is_layer && said.find("strip or plane without a layer for ") != std::string::npos);
      // Bodies of different material want several keys, and a method and kernel that take them.
      const bool is_of_bodies =
          key.starts_with("material.") && (key.ends_with("_2") || key.ends_with("beta"));
      const bool takes_more =
          (is_of_bodies || key == "contact.friction_law" || accepting.contains("unlike")) &&
          (said.starts_with("missing key") ||
           said.find(" for bodies of different") != std::string::npos);
      if (has_role || by_choice || takes_more) {
        EXPECT_TRUE(said.empty() || by_choice || does_not_fit || takes_more) << said;
      } else {
        EXPECT_TRUE(said.starts_with("key '" + key + "' has no role here: it is for ")) << said;
      }
    }
  }
}

/// The keys that a message lists behind "known to this model".
std::set<std::string> listed(std::string said) {
  const std::string begin = "known to this model: ";
  const std::size_t at = said.find(begin);
  if (at == std::string::npos) return {};
  said.erase(0, at + begin.size());
  std::ranges::replace(said, ',', ' ');
  return words(said);
}

// Keys that a scene does not give are in the list, too, by the table of roles: each that a scene
// takes beside its own, without an answer.
TEST(KeysOfScenes, AreAllListedForAnUnknownKey) {
  for (const auto& [name, settings] : scenes) {
    const std::set<std::string> known = listed(answer(with(settings, {"zzzz=1"})));
    EXPECT_FALSE(known.empty()) << name;
    for (const auto& [key, value, where] : roles) {
      const bool has_role = words(where).contains(name);
      if (!has_role || !answer(with(settings, {key + "=" + value})).empty()) continue;
      EXPECT_TRUE(known.contains(key)) << key << " in " << name;
    }
  }
}

TEST(KeysOfScenes, OfNearlyTheNameAreProposedWhetherTheyAreGivenOrNot) {
  EXPECT_EQ(answer(with(scenes.at("loaded_ellipse"), {"grid.rwos=5"})),
            "unknown key 'grid.rwos' (did you mean 'grid.rows'?)");
  EXPECT_EQ(answer(with(ellipse, {"grid.rows=", "grid.elements=", "grid.rwos=5"})),
            "unknown key 'grid.rwos' (did you mean 'grid.rows'?)");
}

/// Counts the scenes that reject a value of a key, where the key has a role; others have reasons of
/// their own besides, as a scheme that takes no offsets.
std::size_t rejecting(const Key& key, double value) {
  const auto role = std::ranges::find(roles, std::string(key.name), &Role::key);
  const std::string name(key.name);
  const auto rejects = [&](const std::string& scene) {
    const std::string said = answer(with(scenes.at(scene), {name + "=" + format_short(value)}));
    return said.starts_with(name + " = ");
  };
  return static_cast<std::size_t>(std::ranges::count_if(words(role->scenes), rejects));
}

TEST(KeysOfScenes, HaveTheRangesThatReadersHoldThemTo) {
  for (const Key& key : keys_of_scenes()) {
    SCOPED_TRACE(key.name);
    const auto [least, most, open, below] = key.range;
    ASSERT_FALSE(below);  // in none of scenes, or else this test has to try it
    const double unit = key.type == Key::Type::whole ? 1 : 0;
    const auto role = std::ranges::find(roles, std::string(key.name), &Role::key);
    const std::size_t all_scenes = words(role->scenes).size();
    if (all_scenes == 0) continue;  // it is for another command
    const auto beside = [&](double value, int side) {
      return unit > 0 || value == 0 ? value + side * std::max(unit, 1e-9)
                                    : value + side * 1e-9 * std::abs(value);
    };
    if (std::isfinite(least)) {
      EXPECT_GT(rejecting(key, open ? least : beside(least, -1)), 0U);
      EXPECT_LT(rejecting(key, open ? beside(least, 1) : least), all_scenes);
    }
    if (std::isfinite(most)) {
      EXPECT_GT(rejecting(key, beside(most, 1)), 0U);
      EXPECT_LT(rejecting(key, most), all_scenes);
    }
  }
}

TEST(KeysOfScenes, HaveTheWordsThatReadersTake) {
  for (const Key& key : keys_of_scenes()) {
    SCOPED_TRACE(key.name);
    EXPECT_EQ(key.type == Key::Type::word, !words_of(key).empty());
    if (key.type != Key::Type::word) continue;
    const auto role = std::ranges::find(roles, std::string(key.name), &Role::key);
    const std::set<std::string> in = words(role->scenes);
    if (in.empty()) continue;  // it is for another command
    const std::string name(key.name), scene = *in.begin();
    for (const std::string_view word : words_of(key)) {
      const std::string said = answer(with(scenes.at(scene), {name + "=" + std::string(word)}));
      EXPECT_FALSE(said.starts_with(name + " = ")) << said;
    }
    EXPECT_EQ(answer(with(scenes.at(scene), {name + "=other"})),
              name + " = 'other': expected " + joined(words_of(key), " or "));
  }
  EXPECT_EQ(words_of(*find_key("basis")), basis_names());
}

TEST(KeysOfScenes, SayWhatTheyAccept) {
  const auto said = [](const char* name) {
    const Key& key = *find_key(name);
    return accepted_by(key, default_of(key));
  };
  EXPECT_EQ(said("basis"), "constant, linear, quadratic [constant]; quadratic for odd N");
  EXPECT_EQ(said("kernel.width"), "> 0");
  EXPECT_EQ(said("grid.elements"),
            "1 ... 4 000 000; 20 000 where matrices are dense; of an ellipse 2 ... 100, and the "
            "program's choice without it and grid.rows");
  EXPECT_EQ(said("grid.leading_offset"), "0 ... 1 [0.5]");
  EXPECT_EQ(said("solver.violation"), "above 0, at most 1 [0.05]");
  EXPECT_EQ(said("solver.condition"), ">= 1 [1e13]");
  EXPECT_EQ(said("step.relaxation"), "at least step.ratio [1]");
  EXPECT_EQ(said("load.creepage"), "finite");
  EXPECT_EQ(accepted_by(*find_key("kernel.type"), "", "`"),
            "`strip`, `plane`, `winkler`, `symbol`");
}

TEST(KeysOfScenes, SayWhereTheyHaveARole) {
  EXPECT_TRUE(
      answer(with(steady, {"step.ratio=0.01"}))
          .starts_with("key 'step.ratio' has no role here: it is for leading_edge standard, "
                       "known_edge or trimmed, or problem transient or cylinder; known to"));
}

}  // namespace microslip::scene_keys_test
