// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/cost.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "good_scene.hpp"
#include "microslip/scene/explanation.hpp"
#include "microslip/support/work.hpp"
#include "scene_text.hpp"

namespace microslip::cost_test {

/// Counted operations that a model takes.
double work_of(const Model& model) {
  const WorkCount count;
  if (const auto* steady = std::get_if<SteadyProblem>(&model)) {
    solve_steady(*steady);
  } else if (const auto* transient = std::get_if<TransientScene>(&model)) {
    TransientRolling rolling(transient->problem, transient->start);
    for (const ShiftLoad& shift : transient->shifts) rolling.shift(shift);
    std::vector<double> lengths = transient->step_ratios;
    for (double& length : lengths) length *= transient->problem.grid.spacing();
    rolling.roll(transient->distance, lengths, transient->loads, [](const TransientState&) {});
  } else if (const auto* scene = std::get_if<CylinderScene>(&model)) {
    RollingCylinder body(scene->problem, scene->cylinder, scene->integrator, scene->step_ratio);
    while (body.state().position < scene->distance) body.step();
  }
  return count.operations();
}

void expect_foreseen(const std::string& text, int elements, double factor = 3) {
  Scene scene = scene_of(good_contact + text);
  scene.set("grid.elements=" + std::to_string(elements));
  const Model model = read_model(scene);
  const double ratio = work_of(model) / work_needed(model);
  EXPECT_LT(ratio, factor) << text << elements;
  EXPECT_GT(ratio, 1 / factor) << text << elements;
}

TEST(LongRunsOfCosts, OfSteadyRollingAreForeseenWithinAFactorOfThree) {
  for (const std::string load : {"load { force -1 }\n", "load { creepage 0.3 }\n"}) {
    const std::string steady = "problem steady\n" + load;
    for (const int n : {101, 801, 6401}) {
      expect_foreseen(steady, n);
      expect_foreseen(steady + "kernel { length 200 }\n", n);
      expect_foreseen(steady + "leading_edge standard\n", n);
      expect_foreseen(steady + "leading_edge standard\nstep { ratio 0.1 }\n", n);
      expect_foreseen(steady + "method chebyshev\n", n);
    }
    for (const int n : {101, 401, 801}) {
      expect_foreseen(steady + "leading_edge standard\nsolver { type dense }\n", n);
    }
  }
}

TEST(LongRunsOfCosts, OfTransientsAreForeseenWithinAFactorOfThree) {
  const std::string transient =
      "problem transient\nload { force -1 }\nstart { type cattaneo }\n"
      "motion { distance 0.25 }\n";
  for (const int n : {101, 401, 801}) {
    for (const std::string c : {"1", "0.2"}) {
      const std::string scene = transient + "step { ratio " + c + "\n scheme ";
      expect_foreseen(scene + "remembered }", n);
      expect_foreseen(scene + "direct }", n);
      if (n < 500) expect_foreseen(scene + "direct }\nsolver { type dense }", n);
      if (n < 500) expect_foreseen(scene + "fractional }", n);
    }
  }
}

TEST(LongRunsOfCosts, OfTheRowsOfATableAreForeseenWithinAFactorOfThree) {
  for (const int rows : {129, 2049}) {
    for (const double force_ratio : {0.05, 0.5, 0.9}) {
      const std::string text = fmt::format(
          "problem steady\ncontact {{ roughness 0.02\n hurst 0.5\n rows {} }}\n"
          "load {{ force_ratio {} }}\n",
          rows, force_ratio);
      for (const int n : {51, 801}) expect_foreseen(text, n);
    }
  }
}

// By remembered a long step is solved in parts.
TEST(LongRunsOfCosts, OfLongStepsAreForeseenWithinAFactorOfThree) {
  for (const std::string scheme : {"remembered", "direct"}) {
    for (const int n : {101, 401}) {
      expect_foreseen(
          "problem transient\nload { creepage 0.3 }\nmotion { distance 8 }\n"
          "start { type rest }\nstep { ratio 20\n scheme " +
              scheme + " }",
          n);
    }
  }
}

TEST(LongRunsOfCosts, OfContactsThatChangeAreForeseenWithinAFactorOfThree) {
  const Eigen::Vector3d q(0, 4, 8);
  RunRows rows;
  rows.distance = q;
  rows.creepage = Eigen::Vector3d::Constant(0.3);
  rows.half_width = Eigen::Vector3d(0.8, 1.2, 0.9);
  const LoadHistory loads(rows);
  for (const bool plane : {false, true}) {
    for (const int n : {51, 101, 401}) {
      const std::string text =
          "problem transient\nload { creepage 0.3 }\nmotion { distance 8 }\n"
          "start { type rest }\nstep { ratio 5 }\n";
      Scene scene = scene_of(good_contact + text);
      scene.set("grid.elements=" + std::to_string(n));
      TransientScene model = std::get<TransientScene>(read_model(scene));
      if (plane) model.problem.contact.kernel = PlaneKernel({1, 0.28}, 40);
      model.loads = loads;
      const double ratio = work_of(model) / work_needed(model);
      EXPECT_LT(ratio, 3) << plane << n;
      EXPECT_GT(ratio, 1 / 3.0) << plane << n;
    }
  }
}

// How far a search goes along the path, and how often, is not foreseen.
TEST(LongRunsOfCosts, OfShiftsAreForeseenWithinAFactorOfEight) {
  for (const std::string forces : {"1.4 -1.4 1.4", "0.7 -0.7 0.7 -0.7", "0.2 -0.2 0.2 -0.2"}) {
    for (const int n : {101, 201, 401}) {
      for (const std::string scheme : {"remembered", "direct"}) {
        expect_foreseen(
            "problem transient\nload { force -1 }\nmotion { distance 0.01 }\n"
            "start { type cattaneo\n force \"" +
                forces + "\" }\nstep { ratio 1\n scheme " + scheme + " }",
            n, 8);
      }
    }
  }
}

TEST(Cost, StepsAreThoseOfTheWay) {
  Scene scene = scene_of(good_contact +
                         "problem transient\nload { force -1 }\nstart { type rest }\n"
                         "motion { distance 0.25 }\nstep { ratio \"1 0.5\" }");
  EXPECT_EQ(steps_needed(read_model(scene)), 3);  // 0.1, 0.05 and 0.1
}

TEST(Cost, StepsAreAMillionAtMost) {
  const auto model = [](const std::string& distance) {
    Scene scene = scene_of(good_contact +
                           "problem transient\nload { force -1 }\nstart { type rest }\n"
                           "step { ratio 1 }\nmotion { distance " +
                           distance + " }");
    return read_model(scene);
  };
  EXPECT_EQ(steps_needed(model("99999")), 999990);
  EXPECT_NE(message([&] { model("100001"); }).find("at most 1e+06 steps"), std::string::npos);
}

TEST(Cost, WithATargetIsNotKnown) {
  Scene scene = scene_of(good_contact + "problem steady\nload { force -1 }\ntarget_error 1e-3");
  scene.set("grid.elements=");
  EXPECT_TRUE(std::isnan(work_needed(read_model(scene))));
}

// The finest grid takes the most memory.
TEST(Cost, OfAPatchWithATargetIsThatOfItsFinestGrid) {
  Scene scene = scene_of(
      "problem steady\nmaterial { shear_modulus 1\n poisson_ratio 0.3 }\n"
      "contact { half_width 2\n lateral_half_width 1\n peak_traction 1 }\n"
      "load { creepage 0.1 }\ntarget_error 1e-3");
  const auto target = std::get<PatchTarget>(read_model(scene));
  EXPECT_GT(target.patch.rows * target.patch.elements, 800);
  EXPECT_LE(target.patch.rows * target.patch.elements, 1700);
  EXPECT_EQ(memory_needed(target), memory_needed(target.patch));
  EXPECT_EQ(steps_needed(target), 0);
  EXPECT_NE(explain(target).consequences[2].find("until the estimate of the error is below 0.001"),
            std::string::npos);
}

TEST(Explanation, ComparesRowsWithElements) {
  Scene scene = scene_of(good_contact +
                         "problem steady\nload { force -1 }\ncontact { roughness 0.1\n rows 201 }");
  EXPECT_EQ(
      explain(read_model(scene)).consequences[3],
      "the bound is a table of 203 rows, about 0.0099 mm apart; an element is as long as 10 of "
      "these distances");
}

TEST(Explanation, SaysWhatIsNotModelled) {
  Scene scene = scene_of(good_contact + "problem steady\nload { force -1 }");
  const Explanation explanation = explain(read_model(scene));
  EXPECT_EQ(explanation.title, "steady rolling under a force");
  EXPECT_EQ(explanation.not_modelled.size(), 3u);
  EXPECT_EQ(explanation.consequences[1], "20 elements of 0.1 mm");
}

}  // namespace microslip::cost_test
