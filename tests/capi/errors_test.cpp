// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface answers with an error where something is wrong, and nothing has happened then.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

#include "handle.hpp"
#include "microslip/support/format.hpp"
#include "status.hpp"

namespace microslip::errors_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const double two[] = {-0.5, 0.5};
const double falling[] = {0.5, -0.5};

TEST(CErrors, OfCreateNameKeyValueAndRange) {
  const std::vector<std::pair<std::string, std::function<void(Parts&)>>> cases{
      {"shear_modulus = 0: expected a number > 0", [](Parts& p) { p.material.shear_modulus = 0; }},
      {"poisson_ratio = 0.6: expected a number in [0, 0.5]",
       [](Parts& p) { p.material.poisson_ratio = 0.6; }},
      {"half_width = nan: expected a number > 0", [](Parts& p) { p.contact.half_width = nan; }},
      {"peak_traction = -1: expected a number > 0", [](Parts& p) { p.contact.peak_traction = -1; }},
      {"peak_traction = 1: expected 0 with a table of the bound",
       [](Parts& p) {
         p.contact = {1, 1, two, two, 2};
       }},
      {"bound_value = null: expected a pointer",
       [](Parts& p) {
         p.contact = {1, 0, two, nullptr, 2};
       }},
      {"bound_rows = 2: expected 0 without a table of the bound",
       [](Parts& p) { p.contact.bound_rows = 2; }},
      {"bound_rows = 0: expected at least one row of the table",
       [](Parts& p) {
         p.contact = {1, 0, two, two, 0};
       }},
      {"contact, table of the bound: bound = -0.5: expected a number >= 0",
       [](Parts& p) {
         p.contact = {1, 0, two, two, 2};
       }},
      {"contact, table of the bound: x = -0.5: expected ascending positions",
       [](Parts& p) {
         p.contact = {1, 0, falling, falling, 2};
       }},
      {"kernel type = 7: expected 0 for a strip, 1 for plane strain, 2 or 3 for these with loads "
       "across the rolling",
       [](Parts& p) { p.kernel.type = 7; }},
      {"length = inf: expected a number > 0", [](Parts& p) { p.kernel.length = infinity; }},
      {"length = 0.5: expected more than (half_width + dx)/2 = 0.524390243902439 mm, from "
       "where on plane strain resists displacements; below, a creepage would drive the force the "
       "wrong way. Steady rolling takes any length",
       [](Parts& p) {
         p.kernel = {MICROSLIP_PLANE, 0.5};
       }},
      {"elements = -3: expected a whole number in [1, 4000000]",
       [](Parts& p) { p.grid.elements = -3; }},
      {"scheme = 2: expected 0 for remembered or 1 for direct",
       [](Parts& p) { p.grid.scheme = 2; }}};
  for (const auto& [expected, spoil] : cases) {
    Parts parts;
    spoil(parts);
    Handle handle(nullptr, microslip_destroy);
    std::string message;
    EXPECT_EQ(create(parts, handle, &message), MICROSLIP_BAD_INPUT);
    EXPECT_EQ(message, expected);
    EXPECT_EQ(handle, nullptr);
  }
}

TEST(CErrors, OfCreateAreCutToTheRoomThereIs) {
  const Parts p;
  char text[8] = "xxxxxxx";
  microslip_rolling* made = nullptr;
  const auto create = [&](const microslip_material* material, microslip_rolling** rolling,
                          std::size_t size) {
    return microslip_create(material, &p.contact, &p.kernel, &p.grid, rolling, text, size);
  };
  EXPECT_EQ(create(nullptr, &made, 0), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(text, "xxxxxxx");
  EXPECT_EQ(create(nullptr, &made, sizeof text), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(text, "materia");
  EXPECT_EQ(create(&p.material, nullptr, sizeof text), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(text, "rolling");
}

TEST(CErrors, ANullHandleIsABadInput) {
  double value = 0;
  int zone = 0;
  microslip_state state{};
  microslip_rolling* copy = nullptr;
  EXPECT_EQ(microslip_copy(nullptr, &copy), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_set_creepage(nullptr, 0), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_set_force(nullptr, 0), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_start_from_shift(nullptr, 0, &value), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_shift_to_force(nullptr, 0, nullptr), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_shift_by_distance(nullptr, 0, nullptr), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_set_contact(nullptr, 1, 1), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_advance(nullptr, 1), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_attempt(nullptr, 1, &state), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_get_state(nullptr, &state), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_get_elastic_energy(nullptr, &value), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_get_full_sliding(nullptr, &value), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_get_nodes(nullptr, &value, 1), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_get_zones(nullptr, &zone, 1), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_size(nullptr), 0u);
  EXPECT_STREQ(microslip_message(nullptr), "rolling = null: expected a handle");
  microslip_destroy(nullptr);
}

/// A call that fails with a message that begins so, and leaves a handle as it was: what it answers
/// now and later, to the bit.
void expect_refused(const std::string& expected,
                    const std::function<microslip_status(microslip_rolling*)>& call,
                    const Parts& parts = {}) {
  const Handle handle = created(parts), twin = created(parts);
  for (const Handle& h : {std::cref(handle), std::cref(twin)}) {
    roll(h, 12, 0.05);
    ASSERT_EQ(microslip_set_force(h.get(), -0.6), MICROSLIP_OK);
    ASSERT_STREQ(microslip_message(h.get()), "");
  }
  EXPECT_EQ(call(handle.get()), MICROSLIP_BAD_INPUT);
  EXPECT_TRUE(std::string(microslip_message(handle.get())).starts_with(expected))
      << microslip_message(handle.get());
  expect_same(answers(handle), answers(twin));
  EXPECT_EQ(microslip_advance(handle.get(), 0.07), MICROSLIP_OK);
  EXPECT_EQ(microslip_advance(twin.get(), 0.07), MICROSLIP_OK);
  expect_same(answers(handle), answers(twin));
}

TEST(CErrors, ARefusedCallChangesNothing) {
  using Rolling = microslip_rolling*;
  const std::string forces = ": expected an absolute value below full sliding, 1.5707963267";
  const std::string lengths =
      ": expected 0, or from 1e-15 to 1e+06 elements, one of which is 0.04878";
  expect_refused("force = 1.6" + forces, [](Rolling r) { return microslip_set_force(r, 1.6); });
  expect_refused("force = nan" + forces, [](Rolling r) { return microslip_set_force(r, nan); });
  expect_refused("force = -2" + forces,
                 [](Rolling r) { return microslip_start_from_shift(r, -2, nullptr); });
  for (const double force : {1.6, -2.0, nan, infinity}) {
    expect_refused("force = " + format_short(force) + forces,
                   [force](Rolling r) { return microslip_shift_to_force(r, force, nullptr); });
  }
  for (const double distance : {nan, infinity, -infinity}) {
    expect_refused(
        "distance = " + format_short(distance) + ": expected a finite number",
        [distance](Rolling r) { return microslip_shift_by_distance(r, distance, nullptr); });
  }
  expect_refused("creepage = inf: expected a finite number",
                 [](Rolling r) { return microslip_set_creepage(r, infinity); });
  for (const double dq : {-1e-17, nan, 1e-17, 1e9}) {
    expect_refused("dq = " + format_short(dq) + lengths,
                   [dq](Rolling r) { return microslip_advance(r, dq); });
  }
  expect_refused("state = null: expected a pointer",
                 [](Rolling r) { return microslip_attempt(r, 0.05, nullptr); });
  expect_refused("state = null: expected a pointer",
                 [](Rolling r) { return microslip_get_state(r, nullptr); });
  microslip_state state{};
  microslip_jacobian jacobian{};
  expect_refused("jacobian = null: expected a pointer", [&](Rolling r) {
    return microslip_attempt_with_jacobian(r, 0.05, &state, nullptr);
  });
  expect_refused(
      "scheme: expected 'remembered', which alone has derivatives of its steps",
      [&](Rolling r) { return microslip_attempt_with_jacobian(r, 0.05, &state, &jacobian); },
      {.grid = {41, MICROSLIP_DIRECT}});
  expect_refused("copy = null: expected a pointer",
                 [](Rolling r) { return microslip_copy(r, nullptr); });
  expect_refused("values = null: expected a pointer",
                 [](Rolling r) { return microslip_get_slip(r, nullptr, 100); });
}

TEST(CErrors, TooSmallAnArrayIsLeftAlone) {
  std::vector<double> values(40, 7);
  std::vector<int> zones(40, 7);
  expect_refused("length = 40: expected at least 41", [&](microslip_rolling* r) {
    return microslip_get_traction(r, values.data(), values.size());
  });
  expect_refused("length = 40: expected at least 41", [&](microslip_rolling* r) {
    return microslip_get_zones(r, zones.data(), zones.size());
  });
  EXPECT_EQ(values, std::vector<double>(40, 7));
  EXPECT_EQ(zones, std::vector<int>(40, 7));
}

TEST(CErrors, AStepNeedsALoad) {
  const Handle handle = created();
  EXPECT_EQ(microslip_advance(handle.get(), 0.05), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(microslip_message(handle.get()), "load: expected a creepage or a force to be set");
}

// A creepage that is so large for so stiff a material gives tractions that no number holds.
TEST(CErrors, AStepWithoutSolutionIsForgotten) {
  for (const int elements : {20, 150}) {
    SCOPED_TRACE(elements);
    const Parts parts{.material = {1e10, 0.28}, .grid = {elements, MICROSLIP_REMEMBERED}};
    const Handle handle = created(parts), twin = created(parts);
    const double dq = 2.7 / elements;
    const auto creep = [&](const Handle& h, double creepage) {
      EXPECT_EQ(microslip_set_creepage(h.get(), creepage), MICROSLIP_OK);
      return microslip_advance(h.get(), dq);
    };
    for (const Handle& h : {std::cref(handle), std::cref(twin)}) {
      ASSERT_EQ(creep(h, 0.1), MICROSLIP_OK) << microslip_message(h.get());
    }
    EXPECT_EQ(creep(handle, 1e303), MICROSLIP_NO_SOLUTION);
    EXPECT_TRUE(std::string(microslip_message(handle.get())).starts_with("active set: singular"));
    expect_same(answers(handle), answers(twin));
    EXPECT_EQ(creep(handle, 0.1), MICROSLIP_OK);
    EXPECT_EQ(creep(twin, 0.1), MICROSLIP_OK);
    const std::vector<double> later = answers(handle), without = answers(twin);
    ASSERT_EQ(later.size(), without.size());
    for (std::size_t i = 0; i < later.size(); ++i) EXPECT_NEAR(later[i], without[i], 1e-11);
  }
}

TEST(CErrors, EveryExceptionBecomesAStatus) {
  char text[64];
  const auto status_of = [&](const auto& thrown) {
    return capi::guarded({text, sizeof text}, [&] { throw thrown; });
  };
  EXPECT_EQ(status_of(std::invalid_argument("a")), MICROSLIP_BAD_INPUT);
  EXPECT_STREQ(text, "a");
  EXPECT_EQ(status_of(NotConverged("b", 3, 0.5)), MICROSLIP_NO_SOLUTION);
  EXPECT_STREQ(text, "b after 3 iterations; largest relative violation 0.5");
  EXPECT_EQ(status_of(std::bad_alloc()), MICROSLIP_OUT_OF_MEMORY);
  EXPECT_STREQ(text, "out of memory");
  EXPECT_EQ(status_of(std::runtime_error("c")), MICROSLIP_INTERNAL);
  EXPECT_STREQ(text, "c");
  EXPECT_EQ(status_of(1), MICROSLIP_INTERNAL);
  EXPECT_STREQ(text, "an exception of unknown type");
}

TEST(CErrors, OfFilesNameThemAndChangeNothing) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "microslip_errors";
  fs::create_directories(folder);
  const std::string file = folder / "a.state", none = folder / "none" / "a.state";
  const Parts parts{.grid = {41, MICROSLIP_REMEMBERED}};
  const Handle handle = created(parts), other = created({.grid = {42, MICROSLIP_REMEMBERED}});
  const Handle direct = created({.grid = {41, MICROSLIP_DIRECT}});
  const auto expect_refused = [](const Handle& of, microslip_status status,
                                 const std::string& message) {
    EXPECT_EQ(status, MICROSLIP_BAD_INPUT);
    EXPECT_EQ(std::string(microslip_message(of.get())).substr(0, message.size()), message);
  };
  expect_refused(handle, microslip_save(handle.get(), nullptr), "path = null: expected a pointer");
  expect_refused(handle, microslip_restore(handle.get(), nullptr),
                 "path = null: expected a pointer");
  expect_refused(handle, microslip_save(handle.get(), none.c_str()),
                 "path = '" + none + "': cannot write it: ");
  expect_refused(handle, microslip_save(handle.get(), folder.c_str()),
                 "path = '" + folder.string() + "': cannot write it: ");
  expect_refused(handle, microslip_restore(handle.get(), file.c_str()),
                 "path = '" + file + "': cannot read it: ");
  expect_refused(direct, microslip_save(direct.get(), file.c_str()),
                 "scheme: expected 'remembered'");
  EXPECT_TRUE(fs::is_empty(folder));
  ASSERT_EQ(microslip_save(handle.get(), file.c_str()), MICROSLIP_OK);
  expect_refused(other, microslip_restore(other.get(), file.c_str()),
                 "path = '" + file + "': grid.elements = 42: expected 41");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  roll(handle, 5, 0.04);
  const std::vector<double> before = answers(handle);
  fs::resize_file(file, fs::file_size(file) / 2);
  expect_refused(handle, microslip_restore(handle.get(), file.c_str()),
                 "path = '" + file + "': expected the whole state");
  expect_same(answers(handle), before);
  EXPECT_EQ(microslip_save(nullptr, file.c_str()), MICROSLIP_BAD_INPUT);
  EXPECT_EQ(microslip_restore(nullptr, file.c_str()), MICROSLIP_BAD_INPUT);
  fs::remove_all(folder);
}

TEST(CErrors, OnlyRegularFilesAreReplacedAndLinksStay) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "microslip_saves";
  fs::remove_all(folder);
  fs::create_directories(folder / "deep");
  const Handle handle = created();
  roll(handle, 5, 0.04);
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::vector<std::string> refused{"pipe", "deep"};
  // The null device by another name, which only root can make.
  if (mknod((folder / "device").c_str(), S_IFCHR | 0600, makedev(1, 3)) == 0) {
    refused.emplace_back("device");
  }
  for (const std::string& name : refused) {
    fs::create_symlink(name, folder / ("to-" + name));
    for (const fs::path& path : {folder / name, folder / ("to-" + name)}) {
      const fs::file_type before = fs::status(path).type();
      EXPECT_EQ(microslip_save(handle.get(), path.c_str()), MICROSLIP_BAD_INPUT);
      const std::string message = microslip_message(handle.get());
      EXPECT_TRUE(message.starts_with("path = '" + path.string() + "': cannot write it: "))
          << message;
      EXPECT_EQ(fs::status(path).type(), before);
    }
  }
  std::ofstream(folder / "deep" / "old.state") << "old";
  fs::create_symlink("deep/old.state", folder / "link");
  fs::create_symlink("link", folder / "chain");
  fs::create_symlink("deep/new.state", folder / "new");
  for (const auto& [link, file] :
       {std::pair("chain", "deep/old.state"), {"new", "deep/new.state"}}) {
    ASSERT_EQ(microslip_save(handle.get(), (folder / link).c_str()), MICROSLIP_OK);
    EXPECT_TRUE(fs::is_symlink(folder / link));
    const Handle other = created();
    ASSERT_EQ(microslip_restore(other.get(), (folder / file).c_str()), MICROSLIP_OK);
    expect_same(answers(other), answers(handle));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "deep"), {}), 2);
  fs::remove_all(folder);
}

}  // namespace microslip::errors_test
