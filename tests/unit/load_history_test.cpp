// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of steps from rows of a run, against sums over many short parts of the linear functions.
#include "microslip/rolling/load_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>

namespace microslip::load_history_test {

using Eigen::Index;
using Eigen::VectorXd;

double creepage_of(const Load& load) { return std::get<PrescribedCreepage>(load).value; }

VectorXd ascending(Index n, std::mt19937& random) {
  std::exponential_distribution<double> gap(1);
  VectorXd values(n);
  double sum = 3;  // rows need not begin at 0
  for (double& value : values) value = sum += 0.01 + gap(random);
  return values;
}

VectorXd uniform(Index n, double from, double to, std::mt19937& random) {
  std::uniform_real_distribution<double> value(from, to);
  return VectorXd::NullaryExpr(n, [&] { return value(random); });
}

/// Linear between rows.
double value_at(const VectorXd& at, const VectorXd& values, double where) {
  Index i = 0;
  while (i + 2 < at.size() && at[i + 1] <= where) ++i;
  return values[i] + (values[i + 1] - values[i]) * (where - at[i]) / (at[i + 1] - at[i]);
}

/// Distance and shift after each of many short parts of a run.
struct Sums {
  VectorXd distance;
  VectorXd shift;
};

Sums summed(const VectorXd& along, const std::function<double(double)>& speed,
            const std::function<double(double)>& shift_rate) {
  constexpr Index parts = 200000;
  const double part = (along[along.size() - 1] - along[0]) / parts;
  Sums sums{VectorXd::Zero(parts + 1), VectorXd::Zero(parts + 1)};
  for (Index i = 0; i < parts; ++i) {
    const double middle = along[0] + (static_cast<double>(i) + 0.5) * part;
    sums.distance[i + 1] = sums.distance[i] + part * speed(middle);
    sums.shift[i + 1] = sums.shift[i] + part * shift_rate(middle);
  }
  return sums;
}

void expect_mean_creepage(const LoadHistory& history, const Sums& sums, std::mt19937& random) {
  EXPECT_NEAR(history.distance() / sums.distance[sums.distance.size() - 1], 1, 1e-8);
  std::uniform_int_distribution<Index> any(0, sums.distance.size() - 1);
  for (int k = 0; k < 200; ++k) {
    const Index i = any(random), j = any(random);
    if (std::abs(i - j) < 20) continue;
    const Index from = std::min(i, j), to = std::max(i, j);
    const double rolled = sums.distance[to] - sums.distance[from];
    const double expected = (sums.shift[to] - sums.shift[from]) / rolled;
    EXPECT_NEAR(creepage_of(history.between(sums.distance[from],
                                            std::min(sums.distance[to], history.distance()))),
                expected, 1e-5);
  }
}

TEST(LoadHistory, OverDistanceIsTheMeanOfTheCreepage) {
  std::mt19937 random(1);
  RunRows rows;
  rows.distance = ascending(20, random);
  rows.creepage = uniform(20, -0.3, 0.3, random);
  const auto creepage = [&](double q) { return value_at(*rows.distance, *rows.creepage, q); };
  expect_mean_creepage(LoadHistory(rows),
                       summed(
                           *rows.distance, [](double) { return 1.0; }, creepage),
                       random);
}

TEST(LoadHistory, OverTimeIsTheMeanOverTheDistance) {
  std::mt19937 random(2);
  RunRows rows;
  rows.time = ascending(20, random);
  rows.velocity = uniform(20, 0.5, 20, random);
  rows.creepage = uniform(20, -0.3, 0.3, random);
  const auto speed = [&](double t) { return value_at(*rows.time, *rows.velocity, t); };
  const auto rate = [&](double t) { return speed(t) * value_at(*rows.time, *rows.creepage, t); };
  expect_mean_creepage(LoadHistory(rows), summed(*rows.time, speed, rate), random);
}

TEST(LoadHistory, OfVelocitiesIsTheShiftOverTheDistance) {
  std::mt19937 random(3);
  RunRows rows;
  rows.time = ascending(20, random);
  rows.velocity = uniform(20, 5, 20, random);
  rows.angular_velocity = VectorXd(*rows.velocity / 460 + uniform(20, -1e-3, 1e-3, random));
  rows.radius = 460;
  const auto speed = [&](double t) { return value_at(*rows.time, *rows.velocity, t); };
  const auto rate = [&](double t) {
    return speed(t) - 460 * value_at(*rows.time, *rows.angular_velocity, t);
  };
  expect_mean_creepage(LoadHistory(rows), summed(*rows.time, speed, rate), random);
}

TEST(LoadHistory, HasTheForceAtTheEndOfAStep) {
  RunRows rows;
  rows.time = VectorXd::LinSpaced(3, 10, 12);
  rows.velocity = Eigen::Vector3d(2, 4, 4);  // q = 2 t + t^2, 3 after a second
  rows.force = Eigen::Vector3d(-1, -3, 5);
  const LoadHistory history(rows);
  EXPECT_EQ(history.distances(), (std::vector<double>{0, 3, 7}));
  EXPECT_NEAR(std::get<PrescribedForce>(history.between(0.5, 1.25)).value, -2, 1e-14);
  EXPECT_NEAR(std::get<PrescribedForce>(history.between(0.5, 5)).value, 1, 1e-14);
  EXPECT_EQ(std::get<PrescribedForce>(history.at(0)).value, -1);
  EXPECT_EQ(std::get<PrescribedForce>(history.at(7)).value, 5);
  EXPECT_NEAR(history.time_at(1.25).value(), 10.5, 1e-14);
  EXPECT_NEAR(history.time_at(5).value(), 11.5, 1e-14);
}

// No sum over the whole run takes their digits.
TEST(LoadHistory, TinyStepsKeepTheirDigits) {
  RunRows rows;
  rows.distance = VectorXd::LinSpaced(1001, 0, 1e6);
  rows.creepage = VectorXd::LinSpaced(1001, 1e-3, 3e-3);
  const LoadHistory history(rows);
  EXPECT_NEAR(creepage_of(history.between(5e5, 5e5 + 1e-9)) / 2e-3, 1, 1e-14);
  EXPECT_NEAR(creepage_of(history.at(5e5)) / 2e-3, 1, 1e-14);
  EXPECT_NEAR(creepage_of(history.between(0, 1e6)) / 2e-3, 1, 1e-13);
}

TEST(LoadHistory, OfOneLoadIsThatLoad) {
  EXPECT_EQ(creepage_of(LoadHistory(PrescribedCreepage{0.3}).between(7, 1e9)), 0.3);
  const LoadHistory force(PrescribedForce{-4});
  EXPECT_EQ(std::get<PrescribedForce>(force.between(7, 8)).value, -4);
  EXPECT_EQ(force.distance(), std::numeric_limits<double>::infinity());
}

void expect_refused(const RunRows& rows, const std::string& message) {
  try {
    const LoadHistory history(rows);
    ADD_FAILURE() << "accepted: " << message;
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), message);
  }
}

TEST(LoadHistory, NamesRowAndColumnOfWhatIsWrong) {
  const auto with = [](VectorXd q, VectorXd w) {
    RunRows rows;
    rows.distance = std::move(q);
    rows.creepage = std::move(w);
    return rows;
  };
  const Eigen::Vector3d some(0, 1, 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(with(Eigen::Vector3d(2, 2, 2), some),
                 "distance of the rows = 0: expected a number > 0");
  expect_refused(with(some, Eigen::Vector3d(0, nan, 1)),
                 "row 2: creepage = nan: expected a finite number");
  expect_refused(with(some, Eigen::Vector2d(0, 1)),
                 "number of rows of creepage = 2: expected 3, as of the first column");
  expect_refused(with(VectorXd::Zero(1), VectorXd::Zero(1)),
                 "number of rows = 1: expected at least 2");
  RunRows rows = with(some, some);
  rows.friction = Eigen::Vector3d(0.3, 30, 0.3);
  rows.of_problem.friction = 0.3;
  expect_refused(rows, "row 2: friction = 30: expected a number from 0 to 10");
  rows = with(some, some);
  rows.force = some;
  expect_refused(rows, "columns: expected one of creepage, force and omega");
  rows = with(some, some);
  rows.velocity = some;
  expect_refused(rows, "columns: expected v where there is t, and only there");
  rows.time = some;
  expect_refused(rows, "columns: expected either q or t");
  rows.distance.reset();
  rows.time = Eigen::Vector3d(0, 2, 1);
  rows.velocity = Eigen::Vector3d(1, 2, 3);
  expect_refused(rows, "row 3: t = 1: expected at least 2 of the row before");
  rows.time = some;
  EXPECT_NO_THROW(LoadHistory{rows});
  rows.creepage.reset();
  rows.angular_velocity = some;
  expect_refused(rows, "radius = 0: expected a number > 0");
}

/// A column with some rows once more.
VectorXd repeated(const VectorXd& column, const std::vector<Index>& rows) {
  VectorXd all(static_cast<Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) all[static_cast<Index>(k)] = column[rows[k]];
  return all;
}

void expect_same_loads(const LoadHistory& a, const LoadHistory& b, double accuracy,
                       std::mt19937& random) {
  const double length = a.distance();
  EXPECT_NEAR(b.distance() / length, 1, accuracy);
  std::uniform_real_distribution<double> place(0, length);
  std::vector<double> places = a.distances();
  places.back() = length;
  for (int k = 0; k < 20; ++k) places.push_back(place(random));
  const auto value = [](const Load& load) { return Prescribed(load).value; };
  for (const double from : places) {
    EXPECT_NEAR(value(b.at(from)), value(a.at(from)), 100 * accuracy);
    EXPECT_NEAR(b.contact_at(from).half_width, a.contact_at(from).half_width, 100 * accuracy);
    EXPECT_NEAR(b.contact_at(from).bound, a.contact_at(from).bound, 100 * accuracy);
    for (const double to : places) {
      if (to <= from + 1e-9) continue;
      EXPECT_NEAR(value(b.between(from, to)), value(a.between(from, to)), 100 * accuracy);
    }
  }
}

// Rows at one place, in a run over the distance or the time, of each load.
TEST(LoadHistory, DoesNotFeelAStandstill) {
  std::mt19937 random(4);
  const auto any = [&](int below) {
    return std::uniform_int_distribution<int>(0, below - 1)(random);
  };
  for (int run = 0; run < 200; ++run) {
    const Index n = 2 + any(6);
    RunRows rows;
    const VectorXd along = ascending(n, random);
    VectorXd speed = uniform(n, 0.5, 5, random);
    const bool over_time = any(2) == 0;
    std::vector<Index> all;  // rows of the one that stands, which stops at some
    for (Index i = 0; i < n; ++i) {
      const int times = 1 + any(3);
      if (over_time && times > 1) speed[i] = 0;
      for (int k = 0; k < times; ++k) all.push_back(i);
    }
    if (over_time && n == 2 && speed.sum() == 0) continue;
    const int load = any(over_time ? 3 : 2);
    if (load == 0) rows.force = uniform(n, -3, 3, random);
    if (load == 1) rows.creepage = uniform(n, -0.1, 0.1, random);
    if (load == 2) {
      rows.radius = 460;
      rows.angular_velocity =
          VectorXd(speed.cwiseProduct(uniform(n, 0.9, 1.1, random)) / rows.radius);
    }
    if (any(2) == 0) rows.normal_load = uniform(n, 0.5, 2, random);
    (over_time ? rows.time : rows.distance) = along;
    if (over_time) rows.velocity = speed;
    RunRows standing = rows;
    for (auto* column : {&standing.distance, &standing.velocity, &standing.force,
                         &standing.creepage, &standing.angular_velocity, &standing.normal_load}) {
      if (*column) *column = repeated(**column, all);
    }
    if (over_time) {
      VectorXd times = repeated(along, all);
      double stood = 0;
      for (std::size_t k = 1; k < all.size(); ++k) {
        if (all[k] == all[k - 1]) stood += 0.1 + any(10);
        times[static_cast<Index>(k)] += stood;
      }
      standing.time = times;
    }
    bool stands = false;  // two rows in turn with v = 0, under loads that may change
    for (Index i = 1; i < n; ++i) stands = stands || (over_time && speed[i - 1] + speed[i] == 0);
    if (stands) continue;
    SCOPED_TRACE(run);
    // Next to a stop the time is a root of the distance, of which rounding, 1e-15, leaves 3e-8.
    expect_same_loads(LoadHistory(rows), LoadHistory(standing), over_time ? 1e-7 : 1e-14, random);
  }
}

// Speed and slip grow and end with a root of the distance: their ratio is the creepage all the way.
TEST(LoadHistory, FromAStandstillToAnotherHasItsCreepage) {
  RunRows rows;
  rows.time = Eigen::Vector3d(0, 2, 5);
  rows.velocity = Eigen::Vector3d(0, 4, 0);
  rows.angular_velocity = Eigen::Vector3d(0, 4 * (1 - 0.01) / 460, 0);
  rows.radius = 460;
  const LoadHistory history(rows);
  EXPECT_EQ(history.distance(), 10);
  for (const double q : {0.0, 1e-12, 1.0, 4.0, 7.0, 10 - 1e-9, 10.0}) {
    EXPECT_NEAR(creepage_of(history.at(q)), 0.01, 1e-6) << q;
    if (q < 10) {
      EXPECT_NEAR(creepage_of(history.between(q, 10)), 0.01, 1e-6) << q;
    }
  }
  EXPECT_NEAR(*history.time_at(1), 1, 1e-14);
  EXPECT_NEAR(*history.time_at(10), 5, 1e-14);
}

TEST(LoadHistory, StopsWhereTheContactJumps) {
  RunRows rows;
  rows.distance = Eigen::Vector4d(0, 1, 1, 2);
  rows.creepage = Eigen::Vector4d(0, 0.1, 0.2, 0.2);  // which may jump
  const LoadHistory jumps(rows);
  EXPECT_NEAR(creepage_of(jumps.between(0, 1)), 0.05, 1e-15);
  EXPECT_NEAR(creepage_of(jumps.between(1, 2)), 0.2, 1e-15);
  EXPECT_TRUE(jumps.stops().empty());
  rows.normal_load = Eigen::Vector4d(1, 1, 4, 4);
  const LoadHistory history(rows);
  EXPECT_EQ(history.stops(), std::vector<double>{1});
  EXPECT_EQ(history.contact_at(1).half_width, 1);
  EXPECT_EQ(history.contact_at(1.5).half_width, 2);
  ASSERT_EQ(history.standing_at(1).size(), 1U);
  EXPECT_EQ(history.standing_at(1)[0].contact.half_width, 2);
  EXPECT_EQ(std::get<PrescribedShift>(history.standing_at(1)[0].load).value, 0);
  EXPECT_EQ(history.contact_of_row(2).half_width, 2);
}

TEST(LoadHistory, StopsWhereAForceJumps) {
  RunRows rows;
  rows.distance = VectorXd{{0, 1, 1, 1, 3, 3}};
  rows.force = VectorXd{{1, 2, 5, -3, -1, 2}};
  const LoadHistory history(rows);
  EXPECT_EQ(history.stops(), (std::vector<double>{1, 3}));
  const auto value = [](const auto& load) { return std::get<PrescribedForce>(load).value; };
  EXPECT_EQ(value(history.between(0.5, 1)), 2);  // before the jump
  EXPECT_EQ(value(history.at(1)), -3);           // behind it
  EXPECT_EQ(value(history.between(1, 2)), -2);
  ASSERT_EQ(history.standing_at(1).size(), 2U);
  EXPECT_EQ(value(history.standing_at(1)[0].load), 5);
  EXPECT_EQ(value(history.standing_at(1)[1].load), -3);
  ASSERT_EQ(history.standing_at(3).size(), 1U);
  EXPECT_EQ(value(history.standing_at(3)[0].load), 2);
  EXPECT_TRUE(history.standing_at(2).empty());
  EXPECT_EQ(value(history.of_row(2)), 5);
}

// A run may start without tractions, so that a force which is there from the first row on is a shift.
TEST(LoadHistory, BeginsWithAShiftWhereTheBodiesStandUnderAForce) {
  RunRows rows;
  rows.time = VectorXd{{0, 1, 2, 3}};
  rows.velocity = VectorXd{{0, 0, 0, 2}};
  rows.force = VectorXd::Constant(4, -5);
  EXPECT_TRUE(LoadHistory(rows).stops().empty());
  rows.force_acts_before = false;
  const LoadHistory history(rows);
  EXPECT_EQ(history.stops(), (std::vector<double>{0}));
  const auto standing = history.standing_at(0);
  ASSERT_EQ(standing.size(), 2U);
  EXPECT_TRUE(standing[0].changes);
  EXPECT_EQ(std::get<PrescribedForce>(standing[0].load).value, -5);
  EXPECT_FALSE(standing[1].changes);
  rows.force->setZero();
  EXPECT_TRUE(LoadHistory(rows).stops().empty());
}

TEST(LoadHistory, ShiftsByRotationWhereTheWheelStands) {
  RunRows rows;
  rows.time = VectorXd{{0, 1, 2, 4, 5}};
  rows.velocity = VectorXd{{2, 0, 0, 0, 2}};
  rows.angular_velocity = VectorXd{{1, 0.1, 0.3, 0, 1}};
  rows.radius = 2;
  const LoadHistory history(rows);
  EXPECT_EQ(history.distance(), 2);
  EXPECT_EQ(history.stops(), std::vector<double>{1});
  const auto standing = history.standing_at(1);
  ASSERT_EQ(standing.size(), 2U);
  EXPECT_NEAR(std::get<PrescribedShift>(standing[0].load).value, -2 * 0.2 * 1, 1e-15);
  EXPECT_NEAR(std::get<PrescribedShift>(standing[1].load).value, -2 * 0.15 * 2, 1e-15);
  EXPECT_EQ(standing[0].time, 2);
  EXPECT_EQ(standing[1].time, 4);
  EXPECT_EQ(history.time_at(1), 1);
}

// Positions, shifts and times along the way, against sums over many short parts.
TEST(LoadHistory, TurnsWhereTheVelocityChangesItsSign) {
  std::mt19937 random(5);
  for (int run = 0; run < 10; ++run) {
    RunRows rows;
    rows.time = ascending(12, random);
    rows.velocity = uniform(12, -10, 10, random);
    const bool by_rotation = run % 2 == 0;
    if (by_rotation) {
      rows.angular_velocity = uniform(12, -1, 1, random);
      rows.radius = 7;
    } else {
      rows.creepage = uniform(12, -0.3, 0.3, random);
    }
    const LoadHistory history(rows);
    const auto velocity = [&](double t) { return value_at(*rows.time, *rows.velocity, t); };
    const auto rate = [&](double t) {
      if (!by_rotation) return velocity(t) * value_at(*rows.time, *rows.creepage, t);
      return velocity(t) - 7 * value_at(*rows.time, *rows.angular_velocity, t);
    };
    const auto speed = [&](double t) { return std::abs(velocity(t)); };
    const Sums way = summed(*rows.time, speed, rate);
    const Sums place = summed(*rows.time, velocity, rate);
    EXPECT_NEAR(history.distance() / way.distance[way.distance.size() - 1], 1, 1e-8);

    // All turns, each with a row of its own.
    std::size_t turns = 0;
    for (Index i = 1; i < 12; ++i)
      turns += (*rows.velocity)[i] * (*rows.velocity)[i - 1] < 0 ? 1 : 0;
    EXPECT_EQ(history.stops().size(), turns);
    EXPECT_EQ(history.distances().size(), 12 + turns);
    EXPECT_EQ(history.row_distances().size(), 12U);

    std::vector<double> ends = history.stops();
    ends.insert(ends.begin(), 0);
    ends.push_back(history.distance());
    Index i = 0;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double from = ends[k - 1] + 0.3 * (ends[k] - ends[k - 1]);
      const double to = ends[k] - 0.2 * (ends[k] - ends[k - 1]);
      while (way.distance[i] < from) ++i;
      Index j = i;
      while (way.distance[j] < to) ++j;
      const int direction = history.direction_to(way.distance[j]);
      EXPECT_EQ(direction, place.distance[j] > place.distance[i] ? 1 : -1);
      EXPECT_NEAR(history.position_at(way.distance[j]), place.distance[j], 1e-5);
      const double rolled = place.distance[j] - place.distance[i];
      EXPECT_NEAR(creepage_of(history.between(way.distance[i], way.distance[j])) * rolled,
                  way.shift[j] - way.shift[i], 1e-4);
      const double part = ((*rows.time)[11] - (*rows.time)[0]) / 200000;
      EXPECT_NEAR(*history.time_at(way.distance[j]),
                  (*rows.time)[0] + static_cast<double>(j) * part, 1e-4);
    }
  }
}

TEST(LoadHistory, GoesBackOverDistancesThatDescend) {
  RunRows rows;
  rows.distance = VectorXd{{4, 6, 5, 5, 8}};
  rows.creepage = VectorXd{{0.1, 0.1, 0.3, 0.2, 0.2}};
  const LoadHistory history(rows);
  EXPECT_EQ(history.distances(), (std::vector<double>{0, 2, 3, 3, 6}));
  EXPECT_EQ(history.stops(), (std::vector<double>{2, 3}));
  EXPECT_NEAR(creepage_of(history.between(2, 3)), 0.2, 1e-15);
  EXPECT_EQ(history.direction_to(2), 1);
  EXPECT_EQ(history.direction_to(2.5), -1);
  EXPECT_EQ(history.direction_to(3.5), 1);
  EXPECT_EQ(history.position_at(2.5), 1.5);
  EXPECT_EQ(history.position_at(6), 4);
}

}  // namespace microslip::load_history_test
