// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a patch that rolls by steps, against closed forms, steady rolling and the other scheme.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "microslip/experiments/scene_tables.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/not_converged.hpp"
#include "scene_text.hpp"

namespace microslip::patch_transient_tables_test {

const std::string circle = R"(
material { shear_modulus 80 GPa
  poisson_ratio 0.28 }
contact { half_width 5 mm
  lateral_half_width 5 mm
  peak_traction 400 MPa }
grid { rows 12
  elements 12 }
)";

using Settings = std::vector<std::string>;

class PatchTables {
 public:
  /// \param state  of the file of start.state, from which the run continues
  explicit PatchTables(const Settings& settings, const std::string& rows = "",
                       const std::string& state = "") {
    Scene scene = scene_of(circle);
    scene.read_files_by([&](const std::string& name) { return name == "state" ? state : rows; });
    for (const std::string& setting : settings) scene.set(setting);
    const Model model = read_model(scene);
    scene.reject_unread();
    const Progress none = [](std::size_t, std::size_t) {};
    if (const auto* rolls = std::get_if<PatchTransient>(&model)) {
      tables_ = experiments::scene_tables(
          *rolls, none, [&](const PatchRolling& rolling) { state_ = rolling.save(); });
    } else {
      tables_ = std::visit([&](const auto& read) { return experiments::scene_tables(read, none); },
                           model);
    }
  }

  const std::string& state() const { return state_; }

  const Table& named(const std::string& name) const {
    return *std::ranges::find_if(tables_, [&](const Table& table) { return table.name() == name; });
  }

  double of(const std::string& quantity) const {
    const Table& summary = named("summary");
    for (std::size_t i = 0; i < summary.rows(); ++i) {
      if (std::get<std::string>(summary.at(i, "quantity")) == quantity) {
        return summary.number(i, "value");
      }
    }
    return NAN;
  }

 private:
  std::vector<Table> tables_;
  std::string state_;
};

constexpr double full = 2.0 / 3 * 3.14159265358979324 * 25 * 400;

Settings transient(const Settings& more) {
  Settings all{"problem=transient", "start.type=rest", "step.ratio=1", "motion.distance=100"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// Steady rolling is another solution, of other equations. With steps of one cell the moment differs
// by 5e-4 of full sliding times a, and forces by less.
TEST(PatchTransientTables, EndInTheSteadyState) {
  const Settings load{"load.creepage=0.002", "load.lateral_force=3 kN", "load.spin=0.3 1/m"};
  Settings steady = load;
  steady.emplace_back("problem=steady");
  const PatchTables rolled(transient(load)), at_once(steady);
  for (const char* quantity : {"force", "lateral_force"}) {
    EXPECT_NEAR(rolled.of(quantity), at_once.of(quantity), 5e-4 * full) << quantity;
  }
  EXPECT_NEAR(rolled.of("spin_moment"), at_once.of("spin_moment"), 1e-3 * full * 5);
  EXPECT_NEAR(rolled.of("lateral_creepage"), at_once.of("lateral_creepage"), 2e-5);
  EXPECT_NEAR(rolled.of("slip_share"), at_once.of("slip_share"), 0.03);
  EXPECT_EQ(rolled.named("history").rows(), 121U);
}

// Two like bodies that stick on a circle: delta = F (2 - nu)/(4 G a), Mindlin (1949). The force is so
// small that slip at the edge has a part of 1e-3, and the cells an error of 2e-3.
TEST(PatchTransientTables, BeginWithMindlinsShift) {
  const PatchTables shifted(transient(
      {"start.type=cattaneo", "start.lateral_force=-20", "load.creepage=0", "motion.distance=1"}));
  const Table& shifts = shifted.named("shifts");
  ASSERT_EQ(shifts.rows(), 2U);
  EXPECT_NEAR(shifts.number(1, "lateral_shift"), 20 * (2 - 0.28) / (4 * 8e4 * 5), 5e-3 * 2e-5);
  EXPECT_EQ(shifts.number(1, "lateral_force"), -20);
  EXPECT_EQ(shifted.named("history").number(0, "lateral_force"), -20);
}

// The scheme direct has an error of first order: on 24 x 24 rectangles forces differ by 8e-3.
TEST(PatchTransientTables, AgreeWithTheStandardScheme) {
  const Settings load =
      transient({"load.creepage=0.002", "load.lateral_creepage=0.001", "motion.distance=8"});
  Settings direct = load;
  direct.insert(direct.end(), {"step.scheme=direct", "grid.rows=24", "grid.elements=24"});
  const PatchTables one(load), other(direct);
  EXPECT_NEAR(one.of("force"), other.of("force"), 0.012 * full);
  EXPECT_NEAR(one.of("lateral_force"), other.of("lateral_force"), 0.012 * full);
  EXPECT_GT(std::abs(one.of("force")), 0.3 * full);
  EXPECT_EQ(other.named("history").columns().size(), one.named("history").columns().size());
  EXPECT_GT(other.named("traction").rows(), 400U);
  EXPECT_EQ(other.named("edges").rows(), 48U);
}

/// The tractions of a table, as a file has them.
std::string tractions_in(const Table& table) {
  std::string rows = "x,y,traction_x,traction_y\n";
  for (std::size_t i = 0; i < table.rows(); ++i) {
    rows += fmt::format("{},{},{},{}\n", table.number(i, "x"), table.number(i, "y"),
                        table.number(i, "traction_x"), table.number(i, "traction_y"));
  }
  return rows;
}

// A run goes on from its own tractions, on the same grid and on rectangles: 2 mm change the force by
// 3 % of full sliding. Tractions that slip begins to raise above their bound are cut off in a table.
TEST(PatchTransientTables, GoOnFromTheirOwnTractions) {
  const Settings load = transient({"load.creepage=0.002", "motion.distance=10"});
  Settings longer = load, more = load;
  longer.back() = "motion.distance=12";
  const PatchTables before(load), whole(longer);
  ASSERT_GT(std::abs(whole.of("force") - before.of("force")), 0.025 * full);
  more.insert(more.end(), {"start.type=file", "start.file=tractions", "motion.distance=2"});
  const PatchTables after(more, tractions_in(before.named("traction")));
  const Table& history = after.named("history");
  EXPECT_NEAR(history.number(0, "force"), before.of("force"), 2e-3 * full);
  EXPECT_EQ(history.number(0, "creepage"), 0);
  EXPECT_NEAR(after.of("force"), whole.of("force"), 1e-3 * full);
  EXPECT_LT(after.of("change"), 0.05);
  Settings relaxed = more;
  relaxed.insert(relaxed.end(), {"step.scheme=relaxed", "step.ratio=0.5"});
  const PatchTables rectangles(relaxed, tractions_in(before.named("traction")));
  EXPECT_NEAR(rectangles.of("force"), whole.of("force"), 1e-2 * full);
}

TEST(PatchTransientTables, FollowAFileAsTheConstantLoadThatItHas) {
  const Settings load{"load.creepage=0.002", "motion.distance=8"};
  const PatchTables constant(transient(load));
  const PatchTables file(transient({"load.file=run", "motion.distance=8"}),
                         "q,creepage\n0,0.002\n3,0.002\n8,0.002\n");
  EXPECT_EQ(file.of("force"), constant.of("force"));
}

const Settings by_load{"contact.peak_traction=", "contact.normal_load=70 kN",
                       "contact.friction=0.3"};

Settings loaded(const Settings& more) {
  Settings all = by_load;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// Means of the spin, which has no column, have rounding.
TEST(PatchTransientTables, AreTheSameWithAContactThatStays) {
  const Settings load{"load.creepage=0.002", "load.spin=0.2 1/m", "motion.distance=8"};
  const PatchTables constant(transient(loaded(load)));
  const PatchTables file(
      transient(loaded({"load.file=run", "load.spin=0.2 1/m", "motion.distance=8"})),
      "q,creepage,normal_load [kN],friction\n0,0.002,70,0.3\n3,0.002,70,0.3\n8,0.002,70,0.3\n");
  for (const char* quantity : {"force", "lateral_force", "spin_moment", "dissipated_energy"}) {
    const double value = constant.of(quantity);
    EXPECT_NEAR(file.of(quantity), value, 1e-11 * std::abs(value)) << quantity;
  }
  const Table& history = file.named("history");
  EXPECT_EQ(history.number(0, "half_width"), 5);
  EXPECT_NEAR(history.number(3, "full_sliding"), 21e3, 1e-8);
  EXPECT_EQ(history.columns().size(), constant.named("history").columns().size() + 3);
}

// The contact is lost at 3 mm and returns from 6 mm on: there a run begins anew that starts at rest.
// A step ends in each of these rows.
TEST(PatchTransientTables, StartAtRestWhereAContactReturns) {
  const Settings all =
      transient(loaded({"load.file=run", "load.lateral_creepage=-0.001", "load.spin=0.2 1/m",
                        "step.ratio=0.7", "motion.distance="}));
  const std::string behind = "0,0.002,0\n4,0.002,70\n12,0.001,35\n";
  const std::string columns = "q,creepage,normal_load [kN]\n";
  const PatchTables lost(all,
                         columns + "0,0.002,70\n3,0.002,0\n6,0.002,0\n10,0.002,70\n18,0.001,35\n");
  const PatchTables fresh(all, columns + behind);
  EXPECT_GT(std::abs(fresh.of("force")), 1e3);
  EXPECT_EQ(lost.of("distance"), 18);
  const Table& history = lost.named("history");
  int rows = 0;
  for (std::size_t i = 0; i < history.rows(); ++i) {
    const double q = history.number(i, "q");
    if (q < 3 || q > 6) {
      EXPECT_GT(history.number(i, "full_sliding"), 0) << q;
      continue;
    }
    ++rows;
    for (const char* none : {"force", "lateral_force", "spin_moment", "half_width", "slip_share"}) {
      EXPECT_EQ(history.number(i, none), 0) << q << ' ' << none;
    }
    EXPECT_NEAR(history.number(i, "creepage"), 0.002, 1e-15);
  }
  EXPECT_GE(rows, 5);
  for (const char* quantity : {"force", "lateral_force", "spin_moment"}) {
    const double scale = fresh.of("full_sliding_force") * (quantity[0] == 's' ? 5 : 1);
    EXPECT_NEAR(lost.of(quantity), fresh.of(quantity), 0.01 * scale) << quantity;
  }
  EXPECT_EQ(lost.of("half_width"), fresh.of("half_width"));
}

// Both parts of a run that is divided while the contact is lost.
TEST(PatchTransientTables, ContinueWhereTheContactIsLost) {
  const std::string rows =
      "q,creepage,normal_load [kN]\n0,0.002,70\n3,0.002,0\n6,0.002,0\n12,0.002,70\n";
  const auto settings = [](const Settings& more) {
    Settings all = transient(loaded({"load.file=run", "step.ratio=0.6", "motion.distance="}));
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const PatchTables whole(settings({}), rows), first(settings({"motion.distance=4.5"}), rows);
  EXPECT_EQ(first.of("full_sliding_force"), 0);
  EXPECT_EQ(first.of("force_ratio"), 0);
  const PatchTables second(settings({"start.type=state", "start.state=state"}), rows,
                           first.state());
  EXPECT_NEAR(second.of("force"), whole.of("force"), 1e-9 * full);
}

TEST(PatchTransientTables, LoseTheContactWhileTheBodiesStand) {
  const PatchTables jumped(
      transient(loaded({"load.file=run", "step.ratio=0.7", "motion.distance="})),
      "q,creepage,normal_load [kN]\n0,0.002,70\n3,0.002,70\n3,0.002,0\n"
      "3,0.002,70\n9,0.002,70\n");
  const PatchTables fresh(
      transient(loaded({"load.file=run", "step.ratio=0.7", "motion.distance="})),
      "q,creepage,normal_load [kN]\n0,0.002,70\n6,0.002,70\n");
  EXPECT_NEAR(jumped.of("force"), fresh.of("force"), 5e-3 * full);
}

// The normal load rises to twice and stays; steady rolling of that contact is another solution.
TEST(PatchTransientTables, EndInTheSteadyStateOfTheLoadThatStays) {
  const PatchTables rolled(
      transient(loaded({"load.file=run", "load.lateral_creepage=-0.001", "load.spin=0.2 1/m",
                        "step.ratio=0.5"})),
      "q,creepage,normal_load [kN]\n0,0.002,70\n10,0.002,140\n100,0.002,140\n");
  const double size = std::cbrt(2.0);
  const std::string side = std::to_string(5 * size);
  Settings steady{"problem=steady", "load.creepage=0.002", "load.lateral_creepage=-0.001",
                  "load.spin=0.2 1/m"};
  for (const std::string& more :
       {std::string("contact.peak_traction="), std::string("contact.friction=0.3"),
        std::string("contact.normal_load=140 kN"), "contact.half_width=" + side,
        "contact.lateral_half_width=" + side}) {
    steady.push_back(more);
  }
  const PatchTables at_once(steady);
  const double all = 0.3 * 140e3;
  EXPECT_GT(std::abs(at_once.of("force")), 0.2 * all);
  EXPECT_NEAR(rolled.of("force"), at_once.of("force"), 1e-3 * all);
  EXPECT_NEAR(rolled.of("lateral_force"), at_once.of("lateral_force"), 1e-3 * all);
  EXPECT_NEAR(rolled.of("spin_moment"), at_once.of("spin_moment"), 1e-3 * all * 5 * size);
  EXPECT_NEAR(rolled.of("full_sliding_force"), all, 1e-8 * all);
  EXPECT_NEAR(rolled.of("half_width"), 5 * size, 1e-12);
  EXPECT_NEAR(rolled.of("lateral_half_width"), 5 * size, 1e-12);
  const Table& edges = rolled.named("edges");
  double widest = 0;
  for (std::size_t i = 0; i < edges.rows(); ++i) {
    widest = std::max(widest, edges.number(i, "leading"));
  }
  EXPECT_NEAR(widest, 5 * size, 0.02 * size);
  const Table &traction = rolled.named("traction"), &steadily = at_once.named("traction");
  ASSERT_EQ(traction.rows(), steadily.rows());
  for (std::size_t i = 0; i < traction.rows(); ++i) {
    EXPECT_NEAR(traction.number(i, "x"), steadily.number(i, "x"), 1e-5);
    EXPECT_NEAR(traction.number(i, "area"), steadily.number(i, "area"), 1e-5);
    EXPECT_NEAR(traction.number(i, "bound"), steadily.number(i, "bound"), 1e-3);
  }
}

// From rest to tractions that are gone again, all work is lost: the stored energy is 0 at both
// ends. The work is by the histories of motions and resultants. A force of 1.6e-3 of full sliding is left
// at the end, which stores 1e-6 of the work.
TEST(PatchTransientTables, LoseTheWorkThatIsNotStored) {
  const PatchTables rolled(
      transient({"load.file=run", "motion.distance=60", "step.ratio=0.5"}),
      "q,creepage,lateral_creepage,spin [1/m]\n0,0,0,0\n5,0.003,0.001,0.1\n15,0.003,-0.001,0.3\n"
      "20,0,0,0\n60,0,0,0\n");
  const Table& history = rolled.named("history");
  double work = 0, lost = 0, half_way = 0;
  for (std::size_t i = 1; i < history.rows(); ++i) {
    const double dq = history.number(i, "q") - history.number(i - 1, "q");
    for (const auto& [motion, resultant] : {std::pair{"creepage", "force"},
                                            {"lateral_creepage", "lateral_force"},
                                            {"spin", "spin_moment"}}) {
      work -= dq * history.number(i, motion) *
              (history.number(i, resultant) + history.number(i - 1, resultant)) / 2;
    }
    lost += dq * history.number(i, "dissipation");
    if (history.number(i, "q") < 3) half_way = work - lost;
  }
  EXPECT_LT(std::abs(rolled.of("force")), 2e-3 * full);
  EXPECT_GT(work, 100);
  EXPECT_GT(half_way, 3e-3 * work);  // is stored
  EXPECT_NEAR(lost, work, 1e-5 * work);
  EXPECT_NEAR(rolled.of("dissipated_energy"), lost, 1e-10 * work);
  EXPECT_EQ(history.number(0, "dissipation"), 0);
  EXPECT_GT(rolled.of("condition"), 1);
}

// Shifts there and back are a cycle of Mindlin and Deresiewicz (1953).
TEST(PatchTransientTables, LoseEnergyInShifts) {
  const PatchTables shifted(transient({"start.type=cattaneo", "start.force=10 kN -10 kN 10 kN",
                                       "load.creepage=0", "motion.distance=1"}));
  const Table& shifts = shifted.named("shifts");
  ASSERT_EQ(shifts.rows(), 4U);
  double sum = 0;
  for (std::size_t i = 0; i < shifts.rows(); ++i) sum += shifts.number(i, "dissipation");
  EXPECT_EQ(shifts.number(0, "dissipation"), 0);
  EXPECT_NEAR(shifted.of("shift_dissipated_energy"), sum, 1e-12 * sum);
  // Johnson, Contact Mechanics, section 7.4, for like bodies: with f = F/(mu P) and b^3 = 1 - f a
  // cycle loses 9 (mu P)^2/(10 a) 2 (2 - nu)/G (1 - b^5 - 5/6 f (1 + b^2)).
  // These cells lose 6 % less.
  const double f = 10e3 / full, b = std::cbrt(1 - f);
  const double cycle =
      1.8 * full * full / (5 * 8e4) * (2 - 0.28) * (1 - std::pow(b, 5) - 5.0 / 6 * f * (1 + b * b));
  EXPECT_NEAR(shifts.number(2, "dissipation") + shifts.number(3, "dissipation"), cycle,
              0.08 * cycle);
}

/// The rows of a table as numbers, but for its words.
void expect_same_rows(const Table& one, std::size_t first, const Table& other, std::size_t of_other,
                      std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (const Column& column : one.columns()) {
      if (column.name == "zone") continue;
      EXPECT_EQ(one.number(first + i, column.name), other.number(of_other + i, column.name))
          << column.name << " of row " << i;
    }
  }
}

TEST(PatchTransientTables, ContinueARunAsIfItWereOne) {
  const std::string rows =
      "q,creepage,lateral_force [kN],half_width\n0,0.001,1,5\n4,0.002,-1,6\n9,0,0,4.5\n";
  const Settings run{"load.file=run", "load.spin=0.2 1/m", "step.ratio=0.7 1"};
  const auto to = [&](const std::string& distance, const Settings& more = {}) {
    Settings all = transient(run);
    all.push_back("motion.distance=" + distance);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const PatchTables whole(to("9"), rows), first(to("4.25"), rows);
  const PatchTables second(to("9", {"start.type=state", "start.state=state"}), rows, first.state());
  const Table &all = whole.named("history"), &begun = first.named("history"),
              &rest = second.named("history");
  ASSERT_EQ(begun.rows() + rest.rows() - 1, all.rows());
  expect_same_rows(begun, 0, all, 0, begun.rows());
  expect_same_rows(rest, 0, all, begun.rows() - 1, rest.rows());
  expect_same_rows(second.named("traction"), 0, whole.named("traction"), 0, 144);
  EXPECT_TRUE(std::isnan(second.of("change")));
  EXPECT_GT(whole.of("change"), 0);
  EXPECT_EQ(first.of("steps") + second.of("steps"), whole.of("steps"));
  EXPECT_EQ(message([&] {
              PatchTables(to("4", {"start.type=state", "start.state=state"}), rows, first.state());
            }).find("motion.distance = 4: expected more than the distance of start.state, 4.25"),
            0U);
}

// Forces and moment that friction does not carry together are found out at a step alone.
TEST(PatchTransientTables, NameTheStepThatHasNoSolution) {
  const auto settings = transient({"load.file=run", "motion.distance="});
  const std::string rows = "q force spin_moment\n0 0 0\n1 -4000 0\n2 -20500 20000\n";
  std::string found;
  try {
    const PatchTables tables(settings, rows);
  } catch (const NotConverged& error) {
    found = error.what();
  }
  EXPECT_EQ(found.find("step to q = "), 0U) << found;
  EXPECT_NE(found.find(" N, spin_moment "), std::string::npos) << found;
  EXPECT_NE(found.find(" N mm: stick and slip of the step are not found"), std::string::npos)
      << found;
}

}  // namespace microslip::patch_transient_tables_test
