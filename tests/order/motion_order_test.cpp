// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of a cylinder: a small one about rolling against the linear theory, and from rest
// against finer runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hertz_cylinder.hpp"
#include "measured_order.hpp"
#include "microslip/dynamics/cylinder.hpp"
#include "test_name.hpp"

namespace microslip::motion_order_test {

using std::numbers::pi;

const Material material{1.44, 0.28};  // k = 1/pi
constexpr Cylinder solid{.mass = 1, .inertia = 5000, .radius = 100, .slope_force = 0.3};

RollingCylinder rolling_on(Eigen::Index n, const AdvectionScheme& scheme, const Cylinder& body,
                           Integrator integrator, double step_ratio,
                           std::optional<double> tolerance = {}) {
  return hertz_cylinder(material, n, scheme, body, integrator, step_ratio, tolerance);
}

// A cylinder that rolls freely with v0, and on which a small force F_cm acts from then on. With
// lambda = ln(2 L0/a), the modified Bessel functions I0, I1 of sigma, and the distance rolled over
// a,
//   (v - omega R)/v0 = F_cm a/(m v0^2) L^-1 { 1/(sigma (sigma + O H)) },
//   H = 1/(I0/(I0 + I1) + sigma lambda),
//   v/v0 - 1 = F_cm a/(m v0^2) L^-1 { 1/sigma^2 - (m_r/m) O H/(sigma^2 (sigma + O H)) },
//   O = a^2/(k m_r v0^2),
// 1/m_r = 1/m + R^2/I: docs/theory.md. O = 20, lambda = ln 20, by de Hoog's method in 40 digits.
struct Place {
  double distance;     ///< over a
  double slip_speed;   ///< the first of the two over its factor
  double force_pulse;  ///< L^-1 { H/(sigma^2 (sigma + O H)) }
};

constexpr double stiffness = 20;  ///< O
constexpr std::array<Place, 7> exact = {{{0.5, 0.374688367524, 0.00626558162379},
                                         {1, 0.234813630103, 0.0382593184948},
                                         {1.5, -0.177220085552, 0.0838610042776},
                                         {2.5, 0.102251507173, 0.119887424641},
                                         {3, 0.38143884374, 0.130928057813},
                                         {5, 0.137488498098, 0.243125575095},
                                         {6, 0.153089632992, 0.29234551835}}};

struct Errors {
  double velocity = 0;
  double slip_speed = 0;
};

/// The largest, over the factor F_cm a/(m v0).
Errors errors_of_small_motion(Eigen::Index n, const AdvectionScheme& scheme, Integrator integrator,
                              double step_ratio) {
  Cylinder body = solid;
  const double effective = 1 / (1 / body.mass + body.radius * body.radius / body.inertia);
  body.velocity = std::sqrt(pi / (effective * stiffness));
  body.slope_force = 1e-7;
  const double factor = body.slope_force / (body.mass * body.velocity);
  const double step = step_ratio * 2 / static_cast<double>(n);
  RollingCylinder rolling = rolling_on(n, scheme, body, integrator, step_ratio);
  Errors errors;
  for (const Place& at : exact) {
    while (rolling.state().position < at.distance - step / 2) rolling.step();
    EXPECT_NEAR(rolling.state().position, at.distance, 1e-5);
    const double v = rolling.state().velocity;
    const double gained =
        factor * (at.distance - stiffness * effective / body.mass * at.force_pulse);
    const double slip_speed = v - rolling.state().angular_velocity * body.radius;
    errors.velocity = std::max(errors.velocity, std::abs(v - body.velocity - gained) / factor);
    errors.slip_speed = std::max(errors.slip_speed, std::abs(slip_speed / factor - at.slip_speed));
  }
  return errors;
}

constexpr std::array integrators = {Integrator::verlet, Integrator::leapfrog, Integrator::midpoint};

const char* name_of(Integrator integrator) {
  constexpr std::array names = {"Verlet", "leapfrog", "midpoint"};
  return names.at(
      static_cast<std::size_t>(std::ranges::find(integrators, integrator) - integrators.begin()));
}

TEST(SmallMotionOfACylinder, IsSecondOrder) {
  const std::vector<double> sizes = {20, 40, 80};
  for (const Integrator integrator : integrators) {
    for (const double step_ratio : {1.0, 0.25}) {
      std::vector<double> velocity, slip_speed;
      for (const double n : sizes) {
        const Errors errors = errors_of_small_motion(static_cast<Eigen::Index>(n), Remembered{},
                                                     integrator, step_ratio);
        velocity.push_back(errors.velocity);
        slip_speed.push_back(errors.slip_speed);
      }
      const std::string by = fmt::format("{}, c = {:g}", name_of(integrator), step_ratio);
      EXPECT_NEAR(measured_order(by + ": velocity", sizes, velocity), 2, 0.3);
      EXPECT_NEAR(measured_order(by + ": slip speed", sizes, slip_speed), 2, 0.3);
      EXPECT_LT(velocity.back(), step_ratio == 1 ? 5.5e-4 : 5e-5);
      EXPECT_LT(slip_speed.back(), step_ratio == 1 ? 1.7e-3 : 1.5e-4);
    }
  }
}

// The error of the contact, which is of first order, is the larger one in short steps.
TEST(SmallMotionOfACylinder, IsFirstOrderByTheDirectScheme) {
  const std::vector<double> sizes = {40, 80, 160};
  std::vector<double> velocity;
  for (const double n : sizes) {
    velocity.push_back(
        errors_of_small_motion(static_cast<Eigen::Index>(n), Direct{}, Integrator::midpoint, 0.25)
            .velocity);
  }
  EXPECT_NEAR(measured_order("midpoint, c = 0.25: velocity", sizes, velocity), 0.95, 0.15);
}

struct Motion {
  std::vector<CylinderState> states;
  Cylinder body;
};

Motion from_rest(RollingCylinder rolling, const Cylinder& body, double end) {
  Motion motion{{rolling.state()}, body};
  while (motion.states.back().time < end) {
    rolling.step();
    motion.states.push_back(rolling.state());
  }
  return motion;
}

/// Position, velocity and angular velocity times R, by the cubics that have their rates too.
Eigen::Array3d at_time(const Motion& motion, double time) {
  const auto after = std::ranges::lower_bound(motion.states, time, {}, &CylinderState::time);
  const CylinderState& end = *after;
  const CylinderState& begin = *(after - 1);
  const auto values = [&](const CylinderState& s) {
    return Eigen::Array3d(s.position, s.velocity, s.angular_velocity * motion.body.radius);
  };
  const auto rates = [&](const CylinderState& s) {
    return Eigen::Array3d(s.velocity, (motion.body.slope_force + s.force) / motion.body.mass,
                          -motion.body.radius * motion.body.radius * s.force / motion.body.inertia);
  };
  const double step = end.time - begin.time;
  const double s = (time - begin.time) / step;
  const double r = 1 - s;
  return r * r * (1 + 2 * s) * values(begin) + s * s * (1 + 2 * r) * values(end) +
         step * s * r * (r * rates(begin) - s * rates(end));
}

struct Case {
  double slope_force;
  double step_ratio;
  double accepted;  ///< error of omega R, the largest of the three, N = 80
};

// On a gentle slope, where the body swings, on one where it rolls a few elements in a swing, and on
// one where it slides. On the gentle one, errors of the contact and of time are of opposite signs,
// and shorter steps make them alike.
class MotionFromRest : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(
    Slopes, MotionFromRest,
    testing::Values(Case{0.03, 1, 8e-4}, Case{0.3, 1, 4e-4}, Case{3, 1, 7e-5},
                    Case{0.3, 0.37, 5e-5}, Case{3, 0.37, 1.5e-5}),
    [](const auto& of) {
      return test::place({{"slope", of.param.slope_force}, {"c", of.param.step_ratio}});
    });

TEST_P(MotionFromRest, IsSecondOrder) {
  const auto [slope_force, step_ratio, accepted] = GetParam();
  Cylinder body = solid;
  body.slope_force = slope_force;
  const double end = std::sqrt(2 * 2 / (2.0 / 3 * slope_force));  // about 2 mm
  const std::vector<double> sizes = {20, 40, 80};
  const auto motion = [&](double n, Integrator integrator, double c) {
    return from_rest(rolling_on(static_cast<Eigen::Index>(n), Remembered{}, body, integrator, c),
                     body, end);
  };
  const Motion fine = motion(640, Integrator::midpoint, step_ratio / 2);
  const Eigen::Array3d scale = at_time(fine, end);
  for (const Integrator integrator : integrators) {
    std::array<std::vector<double>, 3> errors;
    for (const double n : sizes) {
      const Motion coarse = motion(n, integrator, step_ratio);
      Eigen::Array3d squares = Eigen::Array3d::Zero();
      constexpr int places = 100;
      for (int k = 1; k <= places; ++k) {
        const double time = end * k / places;
        squares += (at_time(coarse, time) - at_time(fine, time)).square() / places;
      }
      for (std::size_t i = 0; i < errors.size(); ++i) {
        const auto of = static_cast<Eigen::Index>(i);
        errors[i].push_back(std::sqrt(squares[of]) / scale[of]);
      }
    }
    for (const std::vector<double>& of : errors) {
      EXPECT_NEAR(fitted_order(sizes, of), 2, 0.25);
      EXPECT_LT(of.back(), accepted);
    }
    const std::string problem =
        fmt::format("F_cm = {:g}, {}, c = {:g}", slope_force, name_of(integrator), step_ratio);
    measured_order(problem, sizes, errors.back());
  }
}

// The error of time steps alone, on one grid, is measured where the body swings, where it rolls a
// few elements in a swing, and where it slides; with tolerances by which most steps are shortened.
TEST(StepsByATolerance, HaveItsErrorAndAreFewerThanEqualOnes) {
  for (const auto& [slope_force, saved] :
       {std::pair{0.05, 1.05}, std::pair{0.3, 1.25}, std::pair{3.0, 1.7}}) {
    Cylinder body = solid;
    body.slope_force = slope_force;
    const double end = std::sqrt(2 * 8 / (2.0 / 3 * slope_force));  // about 8 mm
    const auto motion = [&](double step_ratio, std::optional<double> tolerance) {
      return from_rest(
          rolling_on(60, Remembered{}, body, Integrator::midpoint, step_ratio, tolerance), body,
          end);
    };
    const Motion fine = motion(0.05, {});
    const auto error_of = [&](const Motion& coarse) {
      constexpr int places = 100;
      double squares = 0;
      for (int k = 1; k <= places; ++k) {
        const double time = end * k / places;
        squares += std::pow(at_time(coarse, time)[1] - at_time(fine, time)[1], 2) / places;
      }
      return std::sqrt(squares) / at_time(fine, end)[1];
    };
    const Motion equal = motion(0.5, {});
    const double equal_error = error_of(equal);
    for (const double tolerance : {1e-5, 3e-6}) {
      const Motion controlled = motion(4, tolerance);
      const double error = error_of(controlled);
      EXPECT_LT(error, 2 * tolerance) << slope_force;
      EXPECT_GT(error, 0.06 * tolerance) << slope_force;
      const double equal_steps =
          static_cast<double>(equal.states.size()) * std::sqrt(equal_error / error);
      EXPECT_GT(equal_steps, saved * static_cast<double>(controlled.states.size())) << slope_force;
    }
  }
}

}  // namespace microslip::motion_order_test
