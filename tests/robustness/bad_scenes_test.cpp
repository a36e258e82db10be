// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input to the built executables: exit status 1, one line on stderr that names the key, no
// file.
#include "robustness/bad_scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace microslip::bad_scenes_test {

TEST_F(BadScenes, TheGoodOneIsSolved) {
  const Outcome outcome = run(good_scene, "");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(out())) files.push_back(entry.path().filename());
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files, (std::vector<std::string>{"provenance.txt", "summary.tsv", "traction.tsv"}));
}

TEST_F(BadScenes, ValuesOutOfRange) {
  expect_rejected(good_scene, "--set kernel.width=-40", "kernel.width = -40: expected");
  expect_rejected(good_scene, "--set kernel.width=0", "kernel.width");
  const std::string standard = "--set leading_edge=standard --set ";
  expect_rejected(good_scene, standard + "step.ratio=0", "step.ratio = 0: expected");
  expect_rejected(good_scene, standard + "step.ratio=-1", "step.ratio = -1: expected");
  expect_rejected(good_scene, "--set material.shear_modulus=0", "material.shear_modulus");
  expect_rejected(good_scene, "--set material.poisson_ratio=0.6", "material.poisson_ratio");
  expect_rejected(good_scene, "--set contact.half_width=-1", "contact.half_width");
  expect_rejected(good_scene, "--set contact.peak_traction=0", "contact.peak_traction");
  expect_rejected(good_scene, "--set grid.elements=0", "grid.elements");
  expect_rejected(good_scene, "--set basis=quadratic", "grid.elements = 20: expected an odd");
  expect_rejected(good_scene, standard + "grid.leading_offset=1.5", "grid.leading_offset = 1.5");
  expect_rejected(good_scene, standard + "grid.trailing_offset=-1", "grid.trailing_offset = -1");
  expect_rejected(good_scene, "--set load.creepage= --set load.force=-2", "load.force = -2");
}

// Products of sizes are doubles.
TEST_F(BadScenes, SizesOutOfRange) {
  for (const char* key :
       {"material.shear_modulus", "contact.half_width", "contact.peak_traction", "kernel.width"}) {
    for (const char* value : {"1e-308", "1e-51", "1e+51", "1e+300"}) {
      expect_rejected(good_scene, "--set " + std::string(key) + "=" + value,
                      std::string(key) + " = " + value + ": expected a number from 1e-50 to 1e+50");
    }
  }
}

TEST_F(BadScenes, UnknownAndMissingKeys) {
  expect_rejected(good_scene, "--set grid.elemnts=5",
                  "unknown key 'grid.elemnts' (did you mean 'grid.elements'?)");
  expect_rejected(good_scene, "--set half_width=1",
                  "unknown key 'half_width' (did you mean 'contact.half_width'?)");
  expect_rejected(good_scene, "--set kernel.length=5", "key 'kernel.length' has no role here");
  expect_rejected(good_scene, "--set grid.elements=", "missing key 'grid.elements'");
  expect_rejected(good_scene, "--set kernel.type=", "missing key 'kernel.type'");
  expect_rejected(good_scene, "--set problem=", "missing key 'problem'");
}

TEST_F(BadScenes, UnknownWords) {
  expect_rejected(good_scene, "--set problem=sliding", "problem = 'sliding'");
  expect_rejected(good_scene, "--set kernel.type=sphere", "kernel.type");
  expect_rejected(good_scene, "--set basis=cubic", "basis = 'cubic'");
}

TEST_F(BadScenes, MethodsOfSteadyRolling) {
  expect_rejected(good_scene, "--set method=spectral", "method = 'spectral': expected collocation");
  expect_rejected(good_scene, "--set leading_edge=sharp", "leading_edge = 'sharp': expected inv");
  expect_rejected(good_scene, "--set method=chebyshev --set leading_edge=standard",
                  "key 'leading_edge' has no role here");
  expect_rejected(good_scene, "--set method=chebyshev --set basis=linear",
                  "key 'basis' has no role here");
  expect_rejected(good_scene, "--set leading_edge=trimmed",
                  "basis = 'constant': expected linear where the last function is trimmed");
  expect_rejected(good_scene, "--set kernel.width=0.01",
                  "kernel.width = 0.01: expected at least 0.02 half-widths");
  expect_rejected(good_scene, "--set kernel.compliance=1e-6 --set grid.elements=4",
                  "grid.elements = 4: expected at least 11, as the kernel is strip with a layer");
  for (const char* method : {"leading_edge=standard", "leading_edge=known_edge", "method=chebyshev",
                             "leading_edge=trimmed --set basis=linear --set grid.elements=21"}) {
    EXPECT_EQ(run(good_scene, "--set " + std::string(method)).error, "") << method;
  }
  const Outcome outcome = run(good_scene, "--set method=chebyshev --set kernel.width=0.1");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.error.find("64 unknowns do not suffice"), std::string::npos) << outcome.error;
}

TEST_F(BadScenes, Solvers) {
  expect_rejected(good_scene, "--set solver.type=magic", "solver.type");
  expect_rejected(good_scene, "--set solver.tolerance=1e-13",
                  "solver.tolerance = 1e-13: expected a number in [1e-12, 1e-3]");
  expect_rejected(good_scene, "--set solver.tolerance=1", "solver.tolerance");
  expect_rejected(good_scene, "--set method=chebyshev --set solver.type=fft", "solver.type");
  expect_rejected(good_scene, "--set solver.type=fft --set basis=quadratic --set grid.elements=21",
                  "solver.type = 'fft': expected auto or dense for the basis quadratic");
  expect_rejected(good_scene, "--set solver.type=fft --set leading_edge=known_edge", "solver.type");
  expect_rejected(good_scene, "--set solver.type=dense --set grid.elements=1000000",
                  "grid.elements = 1e+06: expected at most 20000");
  const auto value_of = [&](const std::string& options, const std::string& quantity) {
    EXPECT_EQ(run(good_scene, options).error, "") << options;
    return summary_value(quantity);
  };
  const double dense = value_of("--set solver.type=dense", "force");
  EXPECT_NEAR(value_of("--set solver.type=fft", "force"), dense, 1e-12);
  EXPECT_LE(value_of("--set solver.type=fft", "residual"), 1e-12);
}

// Exit status 2, and no result, when it is worse than what is accepted.
TEST_F(BadScenes, ResultsWorseThanAccepted) {
  for (const std::string& scene : {good_scene, good_transient}) {
    const Outcome outcome = run(scene, "--set solver.condition=2");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.error.find("condition is "), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("expected at most the accepted condition, 2"), std::string::npos);
    EXPECT_FALSE(fs::exists(out()));
  }
  expect_rejected(good_scene, "--set solver.condition=0.5", "solver.condition = 0.5: expected");
  expect_rejected(good_scene, "--set solver.violation=0", "solver.violation = 0: expected");
  EXPECT_EQ(run(good_scene, "").error, "");
  EXPECT_GT(summary_value("condition"), 1);
  EXPECT_LE(summary_value("bound_violation"), 1e-3);
  EXPECT_LE(summary_value("slip_violation"), 1e-3);
}

TEST_F(BadScenes, TargetErrors) {
  const std::string free = "--set grid.elements= ";
  expect_rejected(good_scene, free + "--target-error 0.5",
                  "target_error = 0.5: expected a number in [1e-11, 0.1]");
  expect_rejected(good_scene, free + "--target-error small", "target_error = 'small'");
  expect_rejected(good_scene, "--target-error 1e-4",
                  "key 'grid.elements' has no role here: it is for scenes without target_error");
  expect_rejected(good_scene, free + "--set basis=linear --target-error 1e-4",
                  "key 'basis' has no role here");
  EXPECT_NE(run(good_transient, "--target-error 1e-4").error.find("it is for problem steady"),
            std::string::npos);
  const std::pair<std::string, std::string> picked[] = {
      {"kernel.width=40", "leading_edge inversion"},
      {"contact.bound_polynomial='0.02 0 4'", "leading_edge inversion"},
      {"kernel.compliance=1e-3", "leading_edge calibrated, basis constant"}};
  for (const auto& [setting, method] : picked) {
    EXPECT_EQ(run(good_scene, free + "--target-error 1e-3 --set " + setting).error, "");
    EXPECT_NE(text_of(out() / "summary.tsv").find("picked: " + method), std::string::npos);
    EXPECT_LE(summary_value("estimated_error"), 1e-3);
  }
}

TEST_F(BadScenes, KeysWithoutARole) {
  for (const char* key :
       {"step.ratio=0.01", "step.ratio=1", "grid.leading_offset=0.1", "grid.trailing_offset=0.5"}) {
    const std::string name = std::string(key).substr(0, std::string(key).find('='));
    for (const char* method : {"method=collocation", "method=chebyshev"}) {
      expect_rejected(good_scene, "--set " + std::string(method) + " --set " + key,
                      "key '" + name + "' has no role here: it is for leading_edge standard");
    }
  }
  expect_rejected(good_scene, "--set load.forec=", "--set 'load.forec=': expected a key of this");
  expect_rejected(good_scene, "--set load=", "not a section; its keys are load.creepage");
}

TEST_F(BadScenes, BoundPolynomials) {
  expect_rejected(good_scene, "--set 'contact.bound_polynomial=1 -1.05'",
                  "least value of contact.bound_polynomial = -0.0");
  expect_rejected(good_scene, "--set 'contact.bound_polynomial=0 0'",
                  "contact.bound_polynomial = 0: expected coefficients that are not all zero");
  expect_rejected(good_scene, "--set 'contact.bound_polynomial=1 x'",
                  "contact.bound_polynomial = '1 x': expected finite numbers");
  expect_rejected(good_scene, "--set contact.bound_polynomial=1 --set contact.bound_file=b.tsv",
                  "key 'contact.bound_file' has no role here");
  EXPECT_EQ(run(good_scene, "--set 'contact.bound_polynomial=1 0.3 0.2'").error, "");
  EXPECT_EQ(run(good_scene, "--set contact.peak_traction= --set contact.bound_polynomial=1").error,
            "");
}

TEST_F(BadScenes, BothLoadsOrNeither) {
  expect_rejected(good_scene, "--set load.force=-0.5",
                  "expected only one of 'load.creepage' and 'load.force'");
  expect_rejected(good_scene,
                  "--set load.creepage=", "missing key 'load.creepage' or 'load.force'");
}

TEST_F(BadScenes, BoundFiles) {
  const auto rejected = [&](const std::string& text, const std::string& named) {
    std::ofstream(folder_ / "bound.tsv") << text;
    std::string scene = good_scene;
    scene.replace(scene.find("peak_traction 1"), 15, "bound_file bound.tsv");
    expect_rejected(scene, "", "contact.bound_file = 'bound.tsv': " + named);
  };
  rejected("x\tbound\n0\t1\n0\t2\n", "x = 0: expected ascending positions");
  rejected("x\tbound\n2\t1\n", "x = 2: expected positions from -1 to 1, the half-width");
  rejected("x\tbound\n0\t-1\n", "bound = -1: expected a number >= 0");
  rejected("x\tbound\n0\t0\n", "bound = 0: expected a bound that is not");
  rejected("x\tbound\n0\t1e300\n", "largest of bound = 1e+300: expected a number from 1e-50");
  std::ofstream(folder_ / "bound.tsv") << "x\tbound\n0\t1\n";
  for (const char* method : {"method=chebyshev", "leading_edge=known_edge"}) {
    std::string scene = good_scene;
    scene.replace(scene.find("peak_traction 1"), 15, "bound_file bound.tsv");
    expect_rejected(scene, "--set " + std::string(method),
                    "contact.bound_file: expected no table, because");
  }
  expect_rejected(good_scene, "--set contact.bound_file=b.tsv",
                  "only one of 'contact.peak_traction' and 'contact.bound_file'");
}

TEST_F(BadScenes, TheGoodTransientIsSolvedAndStartsTheNext) {
  for (const std::string load :
       {"", " --set load.force=1.2", " --set step.scheme=direct --set motion.distance=0.3",
        " --set load.force= --set start.force=1 --set load.creepage=-9"}) {
    EXPECT_EQ(run(good_transient, load).error, "");
    EXPECT_TRUE(fs::exists(out() / "history.tsv"));
    const std::string start =
        " --set start.type=file --set start.file='" + (out() / "traction.tsv").string() + "'";
    const bool has_force = load.find("start.force") != std::string::npos;
    EXPECT_EQ(run(good_transient,
                  (has_force ? " --set load.force= --set load.creepage=-9" : load) + start)
                  .error,
              "");
  }
}

TEST_F(BadScenes, Transients) {
  expect_rejected(good_transient, "--set start.type=", "missing key 'start.type'");
  expect_rejected(good_transient, "--set start.type=hertz", "start.type = 'hertz': expected rest");
  expect_rejected(good_transient, "--set start.type=rest --set start.force=1",
                  "key 'start.force' has no role here");
  expect_rejected(good_transient, "--set start.force=-2",
                  "microslip: start.force = -2: expected an absolute value");
  expect_rejected(good_transient + "start { force -2 }", "",
                  "scene.info:14: start.force = -2: expected an absolute value");
  expect_rejected(good_transient, "--set start.force='1 -1 2'",
                  "microslip: start.force = 2: expected an absolute value below full sliding, 1.5");
  expect_rejected(good_transient, "--set start.force='1 nan'",
                  "start.force = '1 nan': expected finite numbers, separated by blanks");
  expect_rejected(good_transient, "--set start.force='1 0,5'",
                  "start.force = '1 0,5': expected finite numbers with a decimal point, separated");
  expect_rejected(good_transient, "--set start.force=' '", "expected at least one number");
  const std::string units =
      "': expected numbers with a unit behind the last or behind each, N/mm or another of its "
      "kind (N/m, kN/m)";
  for (const std::string force :
       {"1 N/m 2", "1 N/m 2 3 N/m", "1 2 mm", "1 furlong", "1 2 N/mm mm", "1mm 2"}) {
    expect_rejected(good_transient, "--set start.force='" + force + "'", force + units);
  }
  expect_rejected(good_transient, "--set start.force='1 2' --set start.shift=1",
                  "expected only one of 'start.force' and 'start.shift'");
  expect_rejected(good_transient, "--set start.shift='1 inf'", "start.shift = '1 inf': expected");
  expect_rejected(good_transient, "--set start.type=rest --set start.shift=1",
                  "key 'start.shift' has no role here: it is for start.type cattaneo");
  std::string slides = good_transient;
  slides.replace(slides.find("force -1"), 8, "force -2");
  expect_rejected(slides, "", "scene.info:13: load.force = -2: expected an absolute value");
  expect_rejected(good_transient, "--set load.force= --set load.creepage=0.1",
                  "missing key 'start.force'");
  expect_rejected(good_transient, "--set step.ratio=", "missing key 'step.ratio'");
  expect_rejected(good_transient, "--set step.ratio='0 0'",
                  "step.ratio = 0: expected at least one");
  expect_rejected(good_transient, "--set step.ratio='1 -1'", "step.ratio = -1: expected numbers");
  expect_rejected(good_transient, "--set step.scheme=exact", "step.scheme = 'exact': expected");
  expect_rejected(good_transient, "--set step.relaxation=1",
                  "key 'step.relaxation' has no role here");
  expect_rejected(good_transient, "--set step.scheme=relaxed --set step.relaxation=0.7",
                  "step.ratio = 1: expected at most the relaxation, 0.7");
  expect_rejected(good_transient, "--set step.scheme=relaxed --set step.relaxation=0",
                  "step.relaxation = 0: expected");
  expect_rejected(good_transient, "--set step.scheme=fractional",
                  "grid.elements = 20: expected an odd number");
  expect_rejected(good_transient,
                  "--set step.scheme=fractional --set basis=quadratic --set grid.elements=21",
                  "basis = 'quadratic': expected equal functions");
  expect_rejected(good_transient, "--set basis=linear", "basis = 'linear': expected constant");
  expect_rejected(good_transient, "--set grid.leading_offset=1",
                  "grid.leading_offset = 1: expected 0.5");
  const std::string short_plane =
      "--set kernel.width= --set kernel.type=plane --set kernel.length=0.52";
  expect_rejected(good_transient, short_plane,
                  "kernel.length = 0.52: expected more than (half_width + dx)/2 = 0.55 mm");
  expect_rejected(good_transient,
                  "--set step.scheme=fractional --set grid.elements=21 --set kernel.width= "
                  "--set kernel.type=plane --set kernel.length=2",
                  "step.scheme = 'fractional': expected another scheme, or in plane strain a");
  expect_rejected(good_transient, "--set motion.distance=0", "motion.distance = 0: expected");
  expect_rejected(good_transient, "--set step.ratio=1e-12",
                  "motion.distance = 0.33: expected at most");
}

TEST_F(BadScenes, Cylinders) {
  const std::string good = "problem cylinder" + good_contact + R"(
cylinder { mass 1
  inertia 5000
  radius 100
  slope_force 0.3 }
motion { distance 0.33 }
)";
  EXPECT_EQ(run(good, "").error, "");
  fs::remove_all(out());
  expect_rejected(good, "--set cylinder.mass=0", "cylinder.mass = 0: expected a number > 0");
  expect_rejected(good, "--set cylinder.radius=-1", "cylinder.radius = -1");
  expect_rejected(good, "--set cylinder.slope_force=1e-12",
                  "cylinder.slope_force = 1e-12: expected a force that rolls 0.33 mm in "
                  "at most 1e+06 steps, not about ");
  expect_rejected(good, "--set cylinder.slope_force=1e-16",
                  "cylinder.slope_force = 1e-16: expected a force that moves the cylinder by");
  expect_rejected(good, "--set cylinder.slope_force=", "missing key 'cylinder.slope_force'");
  expect_rejected(good, "--set cylinder.velocity=-1", "cylinder.velocity = -1: expected a number");
  expect_rejected(good, "--set motion.tolerance=0",
                  "motion.tolerance = 0: expected a number above 0, at most 1");
  expect_rejected(good, "--set motion.tolerance=1e-4 --set motion.integrator=verlet",
                  "key 'motion.tolerance' has no role here: it is for problem cylinder with "
                  "motion.integrator midpoint");
  expect_rejected(good, "--set motion.integrator=euler", "motion.integrator = 'euler': expected");
  expect_rejected(good, "--set load.force=-1", "key 'load.force' has no role here");
  expect_rejected(good, "--set step.ratio=-1", "step.ratio = -1: expected a number >= 1e-15");
  expect_rejected(good, "--set basis=linear", "basis = 'linear': expected constant");
  expect_rejected(good, "--set grid.leading_offset=1", "grid.leading_offset = 1: expected 0.5");
  expect_rejected(good, "--set kernel.width= --set kernel.type=plane --set kernel.length=0.4",
                  "kernel.length = 0.4: expected more than (half_width + dx)/2 = 0.55 mm");
  expect_rejected(good,
                  "--set step.scheme=direct --set cylinder.slope_force=0.003 "
                  "--set cylinder.inertia=1e6 --set motion.distance=5",
                  "the cylinder stalls or rolls backwards");
}

TEST_F(BadScenes, StartFiles) {
  const auto rejected = [&](const std::string& scheme, const std::string& text,
                            const std::string& named) {
    std::ofstream(folder_ / "start.tsv") << "x\ttraction\n" + text;
    expect_rejected(good_transient,
                    "--set grid.elements=2 --set start.type=file --set start.file='" +
                        (folder_ / "start.tsv").string() + "' --set step.scheme=" + scheme,
                    "start.tsv': " + named);
  };
  for (const char* scheme : {"remembered", "direct"}) {
    rejected(scheme, "-0.5\t0\n", "x = -0.5: expected rows up to the edges: the node at 0.5");
    rejected(scheme, "-0.3\t0\n-0.2\t0\n", "x = -0.3: expected rows up to the edges");
    rejected(scheme, "-0.5\t0\n0.5\t1\n", "traction = 1: expected at most the bound, 0.866");
    rejected(scheme, "-0.5\t0\n0.6\t1.01\n", "traction = 1.01: expected at most the bound, 0.99");
    rejected(scheme, "0.5\t0\n0.4\t0\n", "x = 0.4: expected ascending positions");
    rejected(scheme, "1.5\t0\n2\t0\n", "number of rows = 0: expected at least one where");
  }
}

TEST_F(BadScenes, Options) {
  expect_rejected(good_scene, "--set grid.elements", "key=value");
  expect_rejected(good_scene, "--colour", "--colour");
  expect_rejected(good_scene, "--%canonical_option%",
                  "option '--%canonical_option%': expected one");
  expect_rejected(good_scene, "another.info", "'--scene' cannot be specified more than once");
}

TEST_F(BadScenes, AnUnwritableFolderLeavesNothing) {
  std::ofstream(out()) << "a file where a folder should be";
  const Outcome outcome = run(good_scene, "");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  EXPECT_TRUE(fs::is_regular_file(out()));
}

TEST_F(BadScenes, StudiesAnswerAlike) {
  const Outcome outcome = run(good_scene, "--quiet", "carter");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("carter: missing key 'step.ratios'"), std::string::npos);
  EXPECT_FALSE(fs::exists(out()));
}

}  // namespace microslip::bad_scenes_test
