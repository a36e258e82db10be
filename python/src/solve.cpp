// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <sstream>
#include <thread>
#include <utility>

#include "error.hpp"
#include "interface.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/sweep.hpp"
#include "microslip/support/not_converged.hpp"
#include "scene.hpp"
#include "solver.hpp"

namespace {

using namespace microslip;
using namespace microslip::python;

struct Case {
  Scene scene;
  program::Work work;
  std::string warnings;  ///< a line each
};

/// Reads a case. If it fails to converge while it is read, it fails when it is solved: others may
/// have solutions.
Case read_case(Scene scene, bool is_curve) {
  const program::Work work = placed(scene, [&]() -> program::Work {
    try {
      const program::Work prepared = is_curve ? patch_curve_of(scene) : solver_of(scene);
      scene.reject_unread();
      return prepared;
    } catch (const NotConverged& error) {
      return [error](const Progress&) -> std::vector<Table> { throw error; };
    }
  });
  return {scene, work, lines_of(scene.warnings())};
}

std::string label(const Sweep& sweep, std::size_t index) {
  const std::vector<std::string> values = sweep.values(index);
  std::string swept;
  for (std::size_t k = 0; k < values.size(); ++k) {
    swept += fmt::format("{}{} = {}", k == 0 ? "" : ", ", sweep.keys()[k].key, values[k]);
  }
  return fmt::format("case {} of {} ({}): ", index + 1, sweep.size(), swept);
}

/// Calls back every 50 ms at most, so that it costs no time. Work ends by an exception, which only
/// the thread that works may throw: of steady rolling another one tells.
Progress progress_by(microslip_py_progress call) {
  using Clock = std::chrono::steady_clock;
  const std::thread::id working = std::this_thread::get_id();
  return [call, working, last = Clock::now()](std::size_t done, std::size_t total) mutable {
    const Clock::time_point now = Clock::now();
    if (call == nullptr || now - last < std::chrono::milliseconds(50)) return;
    last = now;
    if (call(done, total) != 0 && std::this_thread::get_id() == working) throw Stopped();
  };
}

}  // namespace

struct microslip_py_cases {
  std::vector<Case> all = {};
  std::string swept = "\x1e\x1e";  ///< see microslip_py_swept(); no keys, and one case
};

struct microslip_py_tables {
  std::vector<std::pair<std::string, std::string>> all;  ///< names and texts
};

namespace {

bool has_sweep(const Scene& scene) {
  const std::vector<std::string> keys = scene.keys();
  return std::ranges::any_of(keys,
                             [](const std::string& key) { return key.starts_with("sweep."); });
}

microslip_py_cases read_sweep(const Scene& scene, bool is_curve) {
  if (is_curve) placed(scene, [&] { reject_sweep_of_varied(scene); });
  const Sweep sweep = placed(scene, [&] { return Sweep(scene); });
  microslip_py_cases cases{.swept = ""};
  for (const SweptKey& key : sweep.keys()) cases.swept += key.key + '\x1f';
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    cases.swept += '\x1e';
    for (const std::string& value : sweep.values(i)) cases.swept += value + '\x1f';
    try {
      cases.all.push_back(read_case(sweep.scene(i), is_curve));
    } catch (const BadParameter& error) {
      throw BadParameter(error.name(), label(sweep, i) + error.what());
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(label(sweep, i) + error.what());
    }
  }
  cases.swept += '\x1e';
  return cases;
}

}  // namespace

microslip_py_cases* microslip_py_read(const microslip_py_scene* scene, int is_swept, int is_curve) {
  return or_null([&] {
    Scene read = scene_of(*scene);
    if (is_curve != 0) leave_out_steps(read);
    if (is_swept != 0 && (is_curve == 0 || has_sweep(read)))
      return new microslip_py_cases(read_sweep(read, is_curve != 0));
    placed(read, [&] { reject_sweep(read, "for many there is microslip.sweep"); });
    return new microslip_py_cases{.all = {read_case(read, is_curve != 0)}};
  });
}

void microslip_py_cases_destroy(microslip_py_cases* cases) { delete cases; }

const char* microslip_py_swept(const microslip_py_cases* cases) { return cases->swept.c_str(); }

const char* microslip_py_warnings(const microslip_py_cases* cases, std::size_t at) {
  return cases->all[at].warnings.c_str();
}

microslip_py_tables* microslip_py_solve(const microslip_py_cases* cases, std::size_t at,
                                        microslip_py_progress progress) {
  return or_null([&] {
    const Case& one = cases->all[at];
    microslip_py_tables written;
    const auto tables = placed(one.scene, [&] { return one.work(progress_by(progress)); });
    for (const Table& table : tables) {
      std::ostringstream text;
      table.write(text, "microslip", one.scene.origin());
      written.all.emplace_back(table.name(), text.str());
    }
    return new microslip_py_tables(std::move(written));
  });
}

void microslip_py_tables_destroy(microslip_py_tables* tables) { delete tables; }

std::size_t microslip_py_table_count(const microslip_py_tables* tables) {
  return tables->all.size();
}

const char* microslip_py_table_name(const microslip_py_tables* tables, std::size_t table) {
  return tables->all[table].first.c_str();
}

const char* microslip_py_table_text(const microslip_py_tables* tables, std::size_t table) {
  return tables->all[table].second.c_str();
}

const char* microslip_py_keys(void) {
  static const std::string lines = [] {
    constexpr const char* types[] = {"word", "number", "whole", "list", "wholes", "file", "text"};
    std::string text;
    for (const Key& key : keys_of_scenes()) {
      text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\n", key.name,
                          types[static_cast<std::size_t>(key.type)], key.unit, key.meaning,
                          accepted_by(key, ""), default_of(key), key.role);
    }
    return text;
  }();
  return lines.c_str();
}
