// SPDX-License-Identifier: GPL-3.0-or-later
// Every study reads every key of its scene strictly.
#include <sstream>
#include <string>

#include "microslip/scene/scene.hpp"
#include "robustness/executables.hpp"

namespace microslip {
namespace {

class Studies : public Executables {
 protected:
  std::string program(const std::string& study) const {
    return std::string(MICROSLIP_BIN) + "/" + study;
  }

  Outcome set(const std::string& study, const std::string& assignment) const {
    return run_command(program(study) + " --quick --set '" + assignment + "' --out '" +
                       out().string() + "'");
  }
};

TEST_F(Studies, RejectATextThatIsNoValueOfAnyKey) {
  int keys = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(MICROSLIP_SOURCE) / "studies")) {
    if (!entry.is_directory()) continue;
    const std::string study = entry.path().filename();
    std::istringstream text(run_command(program(study) + " --print-scene").output);
    for (const std::string& key : Scene::parse(text, study).keys()) {
      SCOPED_TRACE(study + " " + key);
      const Outcome outcome = set(study, key + "=,");
      EXPECT_EQ(outcome.status, 1);
      EXPECT_TRUE(outcome.error.starts_with(study + ": " + key + " = ','")) << outcome.error;
      EXPECT_EQ(outcome.error.find('\n') + 1, outcome.error.size());
      EXPECT_FALSE(fs::exists(out()));
      ++keys;
    }
  }
  EXPECT_GT(keys, 150);
}

// Keys of their own have units, too; and a distance in elements takes none.
TEST_F(Studies, TakeUnits) {
  EXPECT_EQ(set("energy_balance", "error.distance=2 cm").error.find("error.distance"),
            std::string::npos);
  const Outcome furlongs = set("energy_balance", "error.distance=2 furlong");
  EXPECT_EQ(furlongs.status, 1);
  EXPECT_NE(furlongs.error.find("expected a number in mm or another of its kind"),
            std::string::npos)
      << furlongs.error;
  const Outcome elements = set("open_problems", "motion.distance=5 mm");
  EXPECT_EQ(elements.status, 1);
  EXPECT_NE(elements.error.find("expected a number in no unit"), std::string::npos)
      << elements.error;
}

}  // namespace
}  // namespace microslip
