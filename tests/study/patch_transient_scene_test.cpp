// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a patch that rolls by steps, against closed forms, steady rolling and the other scheme.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "microslip/experiments/scene_tables.hpp"
#include "microslip/scene/model.hpp"
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
  explicit PatchTables(const Settings& settings, const std::string& rows = "") {
    Scene scene = scene_of(circle);
    scene.read_files_by([rows](const std::string&) { return rows; });
    for (const std::string& setting : settings) scene.set(setting);
    const Model model = read_model(scene);
    scene.reject_unread();
    tables_ = std::visit(
        [](const auto& read) {
          return experiments::scene_tables(read, [](std::size_t, std::size_t) {});
        },
        model);
  }

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

TEST(PatchTransientTables, FollowAFileAsTheConstantLoadThatItHas) {
  const Settings load{"load.creepage=0.002", "motion.distance=8"};
  const PatchTables constant(transient(load));
  const PatchTables file(transient({"load.file=run", "motion.distance=8"}),
                         "q,creepage\n0,0.002\n3,0.002\n8,0.002\n");
  EXPECT_EQ(file.of("force"), constant.of("force"));
}

}  // namespace microslip::patch_transient_tables_test
