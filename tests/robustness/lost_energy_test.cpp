// SPDX-License-Identifier: GPL-3.0-or-later
// The energy that a run loses where its force changes suddenly: right, or warned of with the size
// of the error. The oracle is the scheme of the thesis with c = 1 on fine grids, extrapolated,
// which sums up tractions and slip of elements and resolves the change.
#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <random>
#include <utility>

#include "property/samples.hpp"
#include "robustness/executables.hpp"

namespace microslip::lost_energy_test {

constexpr double full_sliding = 2356.194490192345;  // pi/2 300 N/mm^2 5 mm

class LostEnergy : public Executables {
 protected:
  /// A force that changes on a short way, and rolls on.
  struct Change {
    double from, to;  ///< [N/mm]
    double way;       ///< [mm]
  };

  void write(const Change& change) const {
    std::ofstream(folder_ / "run.tsv") << fmt::format("q force\n0 {}\n{} {}\n2 {}\n", change.from,
                                                      change.way, change.to, change.to);
  }

  Outcome run(const Change& change, int elements, double step_ratio,
              const std::string& scheme) const {
    return run_program(
        "microslip", "",
        fmt::format("problem transient\nmaterial {{ shear_modulus 82 GPa\n poisson_ratio "
                    "0.28 }}\ncontact {{ half_width 5\n peak_traction 300 }}\nkernel {{ "
                    "type strip width 10 }}\ngrid {{ elements {} }}\nstart {{ type "
                    "cattaneo force {} }}\nload {{ file \"{}\" }}\nstep {{ ratio {} "
                    "scheme {} }}\n",
                    elements, change.from, (folder_ / "run.tsv").string(), step_ratio, scheme),
        "");
  }

  double lost(const Change& change, int elements) const {
    EXPECT_EQ(run(change, elements, 1, "direct").status, 0);
    return summary_value("dissipated_energy");
  }
};

TEST_F(LostEnergy, IsWarnedOfWhereTheForceChangesSuddenly) {
  std::mt19937 random(1);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  int warned = 0, right = 0;
  const int changes = samples(40, 12);
  for (int i = 0; i < changes; ++i) {
    const double from = uniform(-0.95, 0.95);
    const double to = i % 2 == 0 ? from * uniform(0.02, 1) : uniform(-0.95, 0.95);
    const int elements = static_cast<int>(20 * std::pow(10, uniform(0, 0.9)));
    const double ratio = std::pow(10, uniform(-1.3, 0.2));
    const Change change{from * full_sliding, to * full_sliding, ratio * 10 / elements};
    write(change);
    const Outcome outcome = run(change, elements, ratio, "remembered");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const double ours = summary_value("dissipated_energy");
    const double fine = lost(change, 801);
    const double truth = 2 * fine - lost(change, 401);
    const double error = std::abs(ours - truth);
    const auto at = outcome.error.find("uncertain by ");
    if (at == std::string::npos) {
      const bool is_silent = outcome.error.empty();
      EXPECT_LT(is_silent ? error : 0, 0.1 * truth) << i;
      continue;
    }
    ++warned;
    if (error < 0.01 * truth) ++right;
    if (outcome.error.find("the dissipated energy is") == std::string::npos) continue;
    const double uncertain = std::stod(outcome.error.substr(at + 13));
    EXPECT_LT(error, 2 * uncertain + std::abs(fine - truth)) << i << ": " << truth;
  }
  EXPECT_LT(warned, 4 * changes / 5);
  EXPECT_LT(right, changes / 5);
}

TEST_F(LostEnergy, IsNotWarnedOfWhereTheForceIsConstantOrChangesSlowly) {
  for (const auto& [from, to] : {std::pair{-1200.0, -1200.0}, {-500.0, -1500.0}}) {
    const Change change{from, to, 1.99};
    write(change);
    for (const double ratio : {0.1, 0.5, 1.0}) {
      EXPECT_EQ(run(change, 51, ratio, "remembered").error, "") << from << ' ' << ratio;
    }
  }
}

}  // namespace microslip::lost_energy_test
