// SPDX-License-Identifier: GPL-3.0-or-later
// A line contact that rolls forth and back: mirror images, first-order steps of its own, Mindlin's
// cycle, steady rolling, and energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "microslip/reference/fretting_cycle.hpp"
#include "microslip/rolling/transient.hpp"

namespace microslip::turning_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Material material{80000, 0.3};
constexpr double peak = 100, plane_length = 10;
const double unit = compliance(material) * peak;  // creepages are about it

TransientProblem problem_of(const TractionBound& bound, Index elements,
                            double strain_by_pressure = 0) {
  return {.contact = Contact(PlaneKernel(material, plane_length), bound, strain_by_pressure),
          .grid = Grid({.half_width = half_width_of(bound), .elements = elements}),
          .basis = constant_basis(),
          .scheme = Remembered{}};
}

TransientProblem hertz(Index elements) { return problem_of(HertzBound(1, peak), elements); }

TransientProblem skew(Index elements, double sign, double strain_by_pressure = 0) {
  const Eigen::Vector3d h(1, 0.5 * sign, 0.2);
  return problem_of(PolynomialBound(1, peak, h), elements, strain_by_pressure);
}

double full_of(const TransientProblem& problem) {
  return full_sliding_force(problem.contact.bound);
}

/// Something that happens: a step, or a shift if the length is 0.
struct Event {
  double length;
  bool by_force;
  double value;  ///< over the unit of creepage, or over full sliding
};

/// The first event is a step, so that a run that goes the other way begins there.
std::vector<Event> generated_events(unsigned seed, double spacing, int count) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::vector<Event> events;
  double sign = 1, level = 0.3;
  bool by_force = false;
  for (int i = 0; i < count; ++i) {
    if (uniform(0, 1) < 0.15) sign = -sign;
    if (uniform(0, 1) < 0.2) level = uniform(-0.6, 0.6);
    if (uniform(0, 1) < 0.1) by_force = !by_force;
    const double length = sign * spacing * (uniform(0, 1) < 0.5 ? 1 : uniform(0.05, 2.5));
    events.push_back(
        {i > 0 && uniform(0, 1) < 0.05 ? 0 : length, by_force, level * uniform(0.8, 1)});
  }
  return events;
}

void happen(TransientRolling& rolling, const Event& event, double full) {
  const Load load = event.by_force ? Load(PrescribedForce{event.value * full})
                                   : Load(PrescribedCreepage{event.value * unit});
  if (event.length != 0) return rolling.step(event.length, load);
  rolling.shift(event.by_force ? ShiftLoad(PrescribedForce{event.value * full})
                               : ShiftLoad(PrescribedShift{0.05 * event.value * unit}));
}

/// The same in the mirror, x' = -x: forces and shifts change their signs, and creepages do not.
Event mirrored(const Event& event) {
  const bool changes = event.by_force || event.length == 0;
  return {-event.length, event.by_force, changes ? -event.value : event.value};
}

/// \param one, other  the same contact in the mirror; both go through the same events
void expect_mirror_images(const TransientProblem& one, const TransientProblem& other,
                          unsigned seed) {
  const double full = full_of(one);
  TransientRolling forth(one), back(other);
  int turns = 0;
  double before = 1;
  for (const Event& event : generated_events(seed, one.grid.spacing(), 120)) {
    turns += event.length * before < 0 ? 1 : 0;
    if (event.length != 0) before = event.length;
    happen(forth, event, full);
    happen(back, mirrored(event), full);
    const TransientState &a = forth.state(), &b = back.state();
    ASSERT_NEAR(a.distance, -b.distance, 1e-12);
    ASSERT_NEAR(a.force, -b.force, 1e-9 * full);
    ASSERT_NEAR(a.creepage, b.creepage, 1e-7 * unit);
    ASSERT_NEAR(a.mean_force, -b.mean_force, 1e-9 * full);
    ASSERT_NEAR(a.dissipation, b.dissipation, 1e-7 * full * unit);
    ASSERT_LT((a.traction + b.traction.reverse()).cwiseAbs().maxCoeff(), 1e-7 * peak);
    ASSERT_LT((a.slip - b.slip.reverse()).cwiseAbs().maxCoeff(), 1e-6 * unit);
    ASSERT_LT((forth.x() + back.x().reverse()).cwiseAbs().maxCoeff(), 1e-13);
    ASSERT_LT((forth.bound() - back.bound().reverse()).cwiseAbs().maxCoeff(), 1e-11 * peak);
    ASSERT_LT(
        (forth.traction_at_nodes() + back.traction_at_nodes().reverse()).cwiseAbs().maxCoeff(),
        1e-7 * peak);
    ASSERT_LT((forth.displacement() + back.displacement().reverse()).cwiseAbs().maxCoeff(),
              1e-8 * unit);
    ASSERT_EQ(a.adhesion_elements, b.adhesion_elements);
  }
  EXPECT_GT(turns, 3);
}

TEST(Turning, HasMirrorImages) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    expect_mirror_images(hertz(31), hertz(31), seed);
    expect_mirror_images(skew(30, 1), skew(30, -1), seed);
  }
}

// u' = -u and x' = -x: the strain by the pressure is the same.
TEST(Turning, HasMirrorImagesWhereBodiesDiffer) {
  const double strain = 0.3 * compliance(material);
  for (unsigned seed = 11; seed <= 14; ++seed) {
    SCOPED_TRACE(seed);
    expect_mirror_images(skew(30, 1, strain), skew(30, -1, strain), seed);
  }
}

/// Implicit Euler steps of one element on equal elements, whose slip is
///   s = S + u - u',  u' of the material that is at the centre now,
/// by projected Gauss-Seidel relaxation. The tractions before a step are all that it knows.
class SmallSteps {
 public:
  explicit SmallSteps(Index n) : n_(n), spacing_(2.0 / static_cast<double>(n)), influence_(n + 1) {
    const auto antiderivative = [](double z) {
      return z == 0 ? 0 : z * (1 - std::log(std::abs(z) / plane_length));
    };
    const double factor = compliance(material) / std::numbers::pi;
    for (Index i = 0; i <= n; ++i) {
      const double z = static_cast<double>(i) * spacing_;
      influence_[i] =
          factor * (antiderivative(z + spacing_ / 2) - antiderivative(z - spacing_ / 2));
    }
    traction_ = VectorXd::Zero(n);
    bound_ = VectorXd::NullaryExpr(n, [&](Index i) {
      const double x = -1 + (static_cast<double>(i) + 0.5) * spacing_;
      return peak * std::sqrt(1 - x * x);
    });
  }

  double spacing() const { return spacing_; }
  double force() const { return spacing_ * traction_.sum(); }

  /// \param direction  1 forth, -1 back
  void step(int direction, double creepage) {
    VectorXd offset(n_);
    for (Index i = 0; i < n_; ++i) {
      offset[i] = direction * spacing_ * creepage - displacement(i + direction);
    }
    for (int sweep = 0; sweep < 20000; ++sweep) {
      double change = 0;
      for (Index i = 0; i < n_; ++i) {
        const double slip = offset[i] + displacement(i);
        const double relaxed =
            std::clamp(traction_[i] - 1.6 * slip / influence_[0], -bound_[i], bound_[i]);
        change = std::max(change, std::abs(relaxed - traction_[i]));
        traction_[i] = relaxed;
      }
      if (change < 1e-9 * peak) return;
    }
    FAIL() << "relaxation";
  }

 private:
  double displacement(Index at) const {
    double sum = 0;
    for (Index j = 0; j < n_; ++j) sum += influence_[std::abs(at - j)] * traction_[j];
    return sum;
  }

  Index n_;
  double spacing_;
  VectorXd influence_, traction_, bound_;
};

/// The creepage over the way: forth over 1.5 half-widths, back over 3, forth over 1.
double creepage_at(double way) { return 0.55 * unit * std::sin(2.2 * way + 0.4); }
int direction_at(double way) { return way < 1.5 || way > 4.5 ? 1 : -1; }
constexpr int halves = 11;  // forces are compared at so many ends of half a half-width

std::vector<double> forces_by_small_steps(Index n) {
  SmallSteps steps(n);
  std::vector<double> forces;
  for (Index i = 0; i < halves * n / 4; ++i) {
    const double way = (static_cast<double>(i) + 0.5) * steps.spacing();
    steps.step(direction_at(way), creepage_at(way));
    if ((i + 1) % (n / 4) == 0) forces.push_back(steps.force());
  }
  return forces;
}

std::vector<double> forces_by_remembering(Index n) {
  TransientRolling rolling(hertz(n));
  std::vector<double> forces;
  const double dx = 2.0 / static_cast<double>(n);
  for (Index i = 0; i < halves * n / 4; ++i) {
    const double way = (static_cast<double>(i) + 0.5) * dx;
    rolling.step(direction_at(way) * dx, PrescribedCreepage{creepage_at(way)});
    if ((i + 1) % (n / 4) == 0) forces.push_back(rolling.state().force);
  }
  return forces;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// The small steps are of first order, 24, 48 and 96 elements.
TEST(Turning, HasTheLimitOfSmallSteps) {
  const double full = full_of(hertz(8));
  const auto a = forces_by_small_steps(24), b = forces_by_small_steps(48),
             c = forces_by_small_steps(96);
  std::vector<double> twice, limit;
  for (std::size_t i = 0; i < a.size(); ++i) {
    twice.push_back(2 * b[i] - a[i]);
    limit.push_back(2 * c[i] - b[i]);
  }
  const std::vector<double> fine = forces_by_remembering(192);
  const double of_one = largest_difference(b, fine) / largest_difference(c, fine);
  EXPECT_GT(of_one, 1.8);
  EXPECT_LT(of_one, 2.7);
  EXPECT_LT(largest_difference(twice, fine), 1e-3 * full);
  EXPECT_LT(largest_difference(limit, fine), 3e-4 * full);  // the forces go up to 0.22 full
  const double coarse = largest_difference(forces_by_remembering(24), fine),
               finer = largest_difference(forces_by_remembering(48), fine);
  EXPECT_LT(finer, 5e-4 * full);
  EXPECT_GT(coarse / finer,
            3);  // the second order, beside a reference with four times the elements
}

/// Rolls forth, to partial slip.
TransientRolling rolled_forth(Index n) {
  TransientRolling rolling(hertz(n));
  const double dx = 2.0 / static_cast<double>(n);
  for (Index i = 0; i < n; ++i) {
    rolling.step(dx, PrescribedCreepage{0.4 * unit * std::cos(static_cast<double>(i) * dx)});
  }
  return rolling;
}

// To turn, and to turn again at once, changes tractions by interpolation alone.
TEST(Turning, ChangesNextToNothingOnTheSpot) {
  std::vector<double> changes, largest;
  for (const Index n : {40, 80, 160, 320}) {
    TransientRolling rolling = rolled_forth(n);
    const VectorXd before = rolling.traction_at_nodes();
    const double force = rolling.state().force;
    for (const double length : {-1e-9, 1e-9}) {
      rolling.step(length, PrescribedCreepage{0});
      EXPECT_NEAR(rolling.state().force, force, 1e-6 * full_of(hertz(n)));
    }
    const VectorXd change = rolling.traction_at_nodes() - before;
    changes.push_back(change.cwiseAbs().mean() / peak);
    largest.push_back(change.cwiseAbs().maxCoeff() / peak);
  }
  EXPECT_LT(changes[0], 4e-3);
  EXPECT_LT(changes[3], 1.5e-4);  // the order 1.7
  EXPECT_LT(largest[0], 0.05);
  EXPECT_LT(largest[3], 0.015);  // next to the stick-slip point, where tractions have a root
}

// Steps forth and back that are short leave shifts alone: the force goes to F* and back to -F*.
TEST(Turning, TendsToMindlinsCycle) {
  std::vector<double> tractions, shifts;
  for (const Index n : {40, 80, 160}) {
    const TransientProblem problem = hertz(n);
    const double end = 0.6 * full_of(problem);
    TransientRolling rolling(problem);
    double shift = rolling.shift(PrescribedForce{end}).distance, lost = 0, sign = 1;
    const FrettingCycle exact(material, HertzBound(1, peak), end);
    constexpr int steps = 10;
    constexpr double dq = 1e-6;
    double of_tractions = 0, of_shift = 0;
    for (int i = 1; i <= steps; ++i) {
      const double force = end * (1 - 2.0 * i / steps);
      sign = -sign;
      rolling.step(sign * dq, PrescribedForce{force});
      shift += sign * dq * rolling.state().creepage;
      lost += dq * rolling.state().dissipation;
      EXPECT_GE(rolling.state().dissipation * dq, -5e-3 * exact.dissipation());
      const VectorXd at = rolling.traction_at_nodes();
      for (Index j = 0; j < n; ++j) {
        of_tractions +=
            std::abs(at[j] - exact.traction(rolling.x()[j], force)) / peak / static_cast<double>(n);
      }
      of_shift = std::max(of_shift, std::abs(shift - exact.shift(force, plane_length)));
    }
    EXPECT_NEAR(lost / (exact.dissipation() / 2), 1, 0.05);
    tractions.push_back(of_tractions / steps);
    shifts.push_back(of_shift / std::abs(exact.shift(-end, plane_length)));
  }
  EXPECT_LT(tractions[0], 0.008);
  EXPECT_LT(tractions[2], 0.0011);
  EXPECT_LT(shifts[0], 3e-3);
  EXPECT_LT(shifts[2], 2.5e-4);
}

// The steady state is the mirror image of that of rolling forth.
TEST(Turning, TendsToSteadyRollingBackward) {
  for (const double value : {0.2, 0.5}) {
    TransientRolling forth(hertz(40)), back = rolled_forth(40);
    const PrescribedCreepage creepage{value * unit};
    for (int i = 0; i < 4000; ++i) forth.step(0.05, creepage);
    for (int i = 0; i < 4000; ++i) back.step(-0.05, creepage);
    EXPECT_NEAR(back.state().force, -forth.state().force, 1e-7 * full_of(hertz(40)));
    EXPECT_GT(back.state().force, 0);
    EXPECT_LT((back.state().traction + forth.state().traction.reverse()).cwiseAbs().maxCoeff(),
              1e-6 * peak);
    EXPECT_GT(back.state().slip.maxCoeff(), 0);  // as the creepage, and tractions are above 0
    EXPECT_NEAR(back.state().dissipation, back.state().force * value * unit,
                1e-5 * back.state().dissipation);
  }
}

// The work of the force is the loss and the change of the stored energy, but for the turns, where
// the stored energy changes by interpolation.
TEST(Turning, LosesEnergyOverAClosedCycle) {
  std::vector<double> left;
  for (const Index n : {40, 80, 160}) {
    TransientRolling rolling(hertz(n));
    const double dx = 2.0 / static_cast<double>(n);
    double work = 0, lost = 0, before = 0;
    for (int cycle = 0; cycle < 4; ++cycle) {
      if (cycle == 3) before = rolling.elastic_energy(), work = lost = 0;
      for (const double sign : {1.0, -1.0}) {
        for (Index i = 0; i < n / 2; ++i) {
          const double force =
              0.6 * sign *
              std::sin(2 * std::numbers::pi * static_cast<double>(i + 1) / static_cast<double>(n)) *
              full_of(hertz(n));
          rolling.step(sign * dx, PrescribedForce{force});
          const TransientState& state = rolling.state();
          work -= state.mean_force * state.creepage * sign * dx;
          lost += state.dissipation * dx;
          EXPECT_GT(state.dissipation, -1e-3 * peak * unit) << n << ' ' << i;
        }
      }
    }
    const double stored = rolling.elastic_energy() - before;
    left.push_back(std::abs(work - lost - stored) / lost);
  }
  EXPECT_LT(left[0], 2e-4);
  EXPECT_LT(left[2], 2e-5);
}

TEST(Turning, HasDerivatives) {
  for (const bool by_force : {false, true}) {
    for (const bool turns : {true, false}) {
      TransientRolling rolling = rolled_forth(40);
      if (!turns) rolling.step(-0.13, PrescribedCreepage{0.1 * unit});
      const double full = full_of(hertz(40)), length = -0.037;
      const double value = by_force ? -0.1 * full : 0.25 * unit;
      const auto load = [&](double of) {
        return by_force ? Load(PrescribedForce{of}) : Load(PrescribedCreepage{of});
      };
      StepJacobian jacobian;
      rolling.attempt(length, load(value), jacobian);
      const double dv = 1e-5 * (by_force ? full : unit), dl = 1e-6;
      const TransientState a = rolling.attempt(length, load(value - dv)),
                           b = rolling.attempt(length, load(value + dv)),
                           c = rolling.attempt(length - dl, load(value)),
                           d = rolling.attempt(length + dl, load(value));
      const auto compare = [&](const StepSlopes& slopes, const TransientState& low,
                               const TransientState& high, double change, double input) {
        const auto near = [&](double slope, double difference, double size) {
          EXPECT_NEAR(slope * input, difference / (2 * change) * input, 1e-4 * size)
              << by_force << turns;
        };
        near(slopes.force, high.force - low.force, full);
        near(slopes.mean_force, high.mean_force - low.mean_force, full);
        near(slopes.creepage, high.creepage - low.creepage, unit);
        near(slopes.dissipation, high.dissipation - low.dissipation, full * unit);
      };
      compare(jacobian.by_load, a, b, dv, by_force ? full : unit);
      compare(jacobian.by_length, c, d, dl, length);
    }
  }
}

// An attempt to turn changes nothing, and so does a step that fails; a copy goes on alike.
TEST(Turning, IsTriedWithoutATrace) {
  TransientRolling rolling = rolled_forth(40), other = rolling;
  const VectorXd x = rolling.x(), tractions = rolling.traction_at_nodes();
  const TransientState tried = rolling.attempt(-0.1, PrescribedCreepage{0.1 * unit});
  EXPECT_THROW(rolling.step(-0.1, PrescribedForce{2 * full_of(hertz(40))}), std::invalid_argument);
  EXPECT_EQ(rolling.x(), x);
  EXPECT_EQ(rolling.traction_at_nodes(), tractions);
  TransientRolling back = rolling;
  back.step(-0.1, PrescribedCreepage{0.1 * unit});
  EXPECT_EQ(back.state().traction, tried.traction);
  EXPECT_EQ(back.x(), -x.reverse());
  EXPECT_NEAR(back.state().distance, rolling.state().distance - 0.1, 1e-14);
  rolling.step(0.05, PrescribedCreepage{0.1 * unit});
  other.step(0.05, PrescribedCreepage{0.1 * unit});
  EXPECT_LT((rolling.state().traction - other.state().traction).cwiseAbs().maxCoeff(), 1e-9 * peak);
}

// Full sliding has no element that sticks, and turns as well.
TEST(Turning, TurnsFromFullSliding) {
  TransientRolling rolling(hertz(40));
  const double full = full_of(hertz(40));
  for (int i = 0; i < 40; ++i) rolling.step(0.5, PrescribedCreepage{20 * unit});
  EXPECT_NEAR(rolling.state().force, -full, 1e-9 * full);
  rolling.step(-1e-6, PrescribedCreepage{0});
  EXPECT_NEAR(rolling.state().force, -full, 2e-3 * full);
  for (int i = 0; i < 40; ++i) rolling.step(-0.5, PrescribedCreepage{20 * unit});
  EXPECT_NEAR(rolling.state().force, full, 1e-9 * full);
}

TEST(Turning, TakesAContactThatChangesOrIsLost) {
  TransientRolling forth(hertz(40)), back(hertz(40));
  const std::vector<ContactScale> scales{{1.1, 0.9}, {0.7, 1.2}, {0, 0}, {0.9, 1}, {1, 1}};
  double sign = 1;
  for (int i = 0; i < 40; ++i) {
    if (i % 3 == 2) sign = -sign;
    for (TransientRolling* one : {&forth, &back}) {
      one->set_contact(scales[static_cast<std::size_t>(i / 2) % scales.size()]);
      one->step((one == &forth ? sign : -sign) * 0.08, PrescribedCreepage{0.3 * unit});
    }
    EXPECT_NEAR(forth.state().force, -back.state().force, 1e-9 * full_of(hertz(40))) << i;
    EXPECT_LT((forth.x() + back.x().reverse()).cwiseAbs().maxCoeff(), 1e-13) << i;
  }
}

TEST(Turning, IsOfTheSchemeRememberedAlone) {
  TransientProblem problem = hertz(20);
  problem.scheme = Direct{};
  TransientRolling rolling(problem);
  try {
    rolling.step(-0.1, PrescribedCreepage{0.1 * unit});
    FAIL() << "is taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "step_ratio = -1: expected a number > 0; the scheme 'remembered' alone rolls back, by "
        "ratios below 0");
  }
}

}  // namespace microslip::turning_test
