// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of creep forces through the C interface: against steady solutions of an ellipse, ranges,
// errors, and bad input.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "microslip_creep_table.h"

namespace microslip::creep_table_c_test {

using Table = std::unique_ptr<microslip_creep_table, void (*)(microslip_creep_table*)>;

const std::string path = std::string(MICROSLIP_SOURCE) + "/tables/creep_forces.nc";
const microslip_material steel{82000, 0.28};
const microslip_ellipse_contact contact{6, 4.5, 300};

Table opened() {
  microslip_creep_table* table = nullptr;
  char message[512] = "";
  EXPECT_EQ(microslip_creep_table_open(path.c_str(), &table, message, sizeof message), MICROSLIP_OK)
      << message;
  return {table, microslip_creep_table_close};
}

TEST(CCreepTable, HasTheForcesOfAnEllipse) {
  const Table table = opened();
  microslip_ellipse* ellipse = nullptr;
  ASSERT_EQ(microslip_ellipse_create(&steel, &contact, nullptr, &ellipse, nullptr, 0),
            MICROSLIP_OK);
  const double c = std::sqrt(6 * 4.5);
  for (const auto& motion : {std::array{1e-3, 0.0, 0.0}, std::array{1e-3, -2e-3, 3e-4},
                             std::array{0.0, 1e-3, -5e-4}, std::array{-3e-3, 1e-3, 1e-4}}) {
    microslip_ellipse_load load{};
    for (int i = 0; i < 3; ++i) load.value[i] = motion[static_cast<std::size_t>(i)];
    microslip_ellipse_state state{};
    std::array<double, 9> expected{}, jacobian{};
    std::array<double, 3> found{};
    ASSERT_EQ(microslip_ellipse_solve_steady(ellipse, &load, &state, expected.data()),
              MICROSLIP_OK);
    ASSERT_EQ(microslip_creep_table_forces(table.get(), &steel, &contact, motion.data(),
                                           found.data(), jacobian.data(), nullptr, 0),
              MICROSLIP_OK);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(found[i], state.resultants[i], 0.006 * state.full_sliding * (i < 2 ? 1 : c));
    }
    EXPECT_NEAR(jacobian[0] / expected[0], 1, 0.2);
    EXPECT_NEAR(jacobian[4] / expected[4], 1, 0.2);
  }
  microslip_ellipse_destroy(ellipse);
}

TEST(CCreepTable, HasRangesAndErrors) {
  microslip_creep_table_info info{};
  ASSERT_EQ(microslip_creep_table_get_info(opened().get(), &info, nullptr, 0), MICROSLIP_OK);
  EXPECT_EQ(info.poisson_ratio, 0.28);
  EXPECT_NEAR(info.least_ratio, 0.1, 1e-12);
  EXPECT_NEAR(info.largest_ratio, 10, 1e-12);
  EXPECT_GT(info.states, 1000);
  for (int i = 0; i < 3; ++i) {
    EXPECT_GT(info.error_rms[i], 0);
    EXPECT_LT(info.error_rms[i], info.error_of_99_percent[i]);
    EXPECT_LT(info.error_of_99_percent[i], info.error_largest[i]);
  }
}

TEST(CCreepTable, HasTheSameForcesOfManyContacts) {
  const Table table = opened();
  constexpr std::size_t count = 500;
  std::mt19937 random(1);
  const auto between = [&](double least, double largest) {
    return std::uniform_real_distribution<>(least, largest)(random);
  };
  std::vector<microslip_ellipse_contact> contacts(count);
  std::vector<double> motions(3 * count), found(3 * count), jacobians(9 * count);
  for (std::size_t k = 0; k < count; ++k) {
    const double half_width = between(2, 9);
    contacts[k] = {half_width, half_width / std::pow(10, between(-0.99, 0.99)), between(10, 500)};
    for (std::size_t i = 0; i < 3; ++i) {
      motions[3 * k + i] = k % 7 == i ? 0 : between(-1, 1) * std::pow(10, between(-6, -2));
    }
  }
  ASSERT_EQ(microslip_creep_table_forces_many(table.get(), &steel, contacts.data(), motions.data(),
                                              count, found.data(), jacobians.data(), nullptr, 0),
            MICROSLIP_OK);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<double, 3> expected{};
    std::array<double, 9> jacobian{};
    ASSERT_EQ(microslip_creep_table_forces(table.get(), &steel, &contacts[k], &motions[3 * k],
                                           expected.data(), jacobian.data(), nullptr, 0),
              MICROSLIP_OK);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(found[3 * k + i], expected[i]) << k;
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(jacobians[9 * k + i], jacobian[i]) << k;
  }
  const std::vector<double> with_jacobians = found;
  ASSERT_EQ(microslip_creep_table_forces_many(table.get(), &steel, contacts.data(), motions.data(),
                                              count, found.data(), nullptr, nullptr, 0),
            MICROSLIP_OK);
  EXPECT_EQ(found, with_jacobians);
  EXPECT_EQ(microslip_creep_table_forces_many(table.get(), &steel, nullptr, nullptr, 0, nullptr,
                                              nullptr, nullptr, 0),
            MICROSLIP_OK);
}

TEST(CCreepTable, WarnsOfLargeMotionsAndOfOtherUnits) {
  const Table table = opened();
  std::array<double, 6> found{};
  const auto warning = [&](double modulus, const std::array<double, 3>& motion) {
    const microslip_material material{modulus, 0.28};
    char message[512] = "of before";
    EXPECT_EQ(microslip_creep_table_forces(table.get(), &material, &contact, motion.data(),
                                           found.data(), nullptr, message, sizeof message),
              MICROSLIP_OK);
    return std::string(message);
  };
  EXPECT_EQ(warning(82000, {1e-3, 0, 0}), "");
  EXPECT_EQ(warning(82000, {0.5, 0, 0}).find("warning: creepage = 0.5: creepages above 0.2"), 0U);
  EXPECT_EQ(warning(82000, {0, 0, 0.2}).find("warning: spin = 0.2: the slip by this spin"), 0U);
  EXPECT_EQ(warning(8.2e10, {0, 0, 0}).find("warning: a shear modulus of 8.2e+10 N/mm^2"), 0U);
  EXPECT_EQ(warning(82, {0, 0, 0}).find("warning: the largest traction, "), 0U);
  const std::array contacts{contact, contact};
  const std::array<double, 6> motions{0, 0, 0, 0, 0.3, 0};
  char message[512] = "";
  ASSERT_EQ(microslip_creep_table_forces_many(table.get(), &steel, contacts.data(), motions.data(),
                                              2, found.data(), nullptr, message, sizeof message),
            MICROSLIP_OK);
  EXPECT_EQ(std::string(message).find("warning: contacts[1]: lateral_creepage = 0.3: "), 0U)
      << message;
}

TEST(CCreepTable, SaysWhichOfManyContactsFailed) {
  const Table table = opened();
  char message[512] = "";
  std::array<microslip_ellipse_contact, 3> contacts{contact, contact, contact};
  std::array<double, 9> motions{1e-3, 0, 0, 1e-3, 0, 0, 1e-3, 0, 0}, found{};
  const auto status = [&](const microslip_material& material, double* resultants) {
    return microslip_creep_table_forces_many(table.get(), &material, contacts.data(),
                                             motions.data(), 3, resultants, nullptr, message,
                                             sizeof message);
  };
  contacts[1].half_width = 56.25;
  EXPECT_EQ(status(steel, found.data()), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(
      message,
      "contacts[1]: half_width = 56.25: expected 0.45 to 45 with lateral_half_width = 4.5, as "
      "the table has a/b from 0.1 to 10");
  EXPECT_LT(found[0], 0);
  EXPECT_EQ(found[3], 0);
  contacts[1] = contact;
  motions[8] = std::nan("");
  EXPECT_EQ(status(steel, found.data()), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(message, "contacts[2]: motion[2] = nan: expected a finite number");
  EXPECT_EQ(found[3], found[0]);
  motions[8] = 0;
  motions[6] = -1e100;
  EXPECT_EQ(status(steel, found.data()), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(message,
               "contacts[2]: motion[0] = -1e+100: expected a motion of at most 1e100 times "
               "peak_traction over shear_modulus");
  contacts[1].peak_traction = 0;
  EXPECT_EQ(status(steel, found.data()), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(message, "contacts[1]: peak_traction = 0: expected a number > 0");
  contacts[1] = contact;
  EXPECT_EQ(status({82000, 0.3}, found.data()), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(message, "poisson_ratio = 0.3: expected that of the table, 0.28");
  EXPECT_EQ(status(steel, nullptr), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(message, "resultants = null: expected a pointer");
}

TEST(CCreepTable, RefusesBadInputInOneLine) {
  const Table table = opened();
  char message[512] = "";
  const std::array<double, 3> motion{1e-3, 0, 0};
  std::array<double, 3> found{};
  const auto refused = [&](const microslip_material& material,
                           const microslip_ellipse_contact& of) {
    return microslip_creep_table_forces(table.get(), &material, &of, motion.data(), found.data(),
                                        nullptr, message, sizeof message) == MICROSLIP_BAD_INPUT;
  };
  EXPECT_TRUE(refused({82000, 0.3}, contact));
  EXPECT_STREQ(message, "poisson_ratio = 0.3: expected that of the table, 0.28");
  EXPECT_TRUE(refused({-1, 0.28}, contact));
  EXPECT_TRUE(refused(steel, {50, 4, 300}));
  EXPECT_STREQ(
      message,
      "half_width = 50: expected 0.4 to 40 with lateral_half_width = 4, as the table has a/b "
      "from 0.1 to 10");
  EXPECT_EQ(microslip_creep_table_forces(nullptr, &steel, &contact, motion.data(), found.data(),
                                         nullptr, message, sizeof message),
            MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(message, "table = null: expected a pointer");
  microslip_creep_table* none = nullptr;
  EXPECT_EQ(microslip_creep_table_open("/nowhere.nc", &none, message, sizeof message),
            MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(message, "cannot read /nowhere.nc: expected a table's file");
  EXPECT_EQ(none, nullptr);
  microslip_creep_table_close(nullptr);
}

}  // namespace microslip::creep_table_c_test
