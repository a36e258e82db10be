// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_options.hpp"

#include <fmt/core.h>

#include <charconv>
#include <stdexcept>
#include <string>

#include "microslip/scene/sweep.hpp"
#include "microslip/support/parallel.hpp"
#include "microslip/support/shown.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;

constexpr int most_threads = 4096;

std::optional<std::size_t> positive(const std::string& text) {
  std::size_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value == 0) return std::nullopt;
  return value;
}

Shard shard_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto number = positive(text.substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : positive(text.substr(slash + 1));
  if (!number || !count || *number > *count || *count > Sweep::max_cases) {
    throw std::invalid_argument(
        fmt::format("--shard '{}': expected i/n with i from 1 to n, and n up to {}", shown(text),
                    Sweep::max_cases));
  }
  return {*number, *count};
}

int threads_of(const std::string& text) {
  const auto threads = positive(text);
  if (!threads || *threads > most_threads) {
    throw std::invalid_argument(fmt::format("--threads '{}': expected a whole number from 1 to {}",
                                            shown(text), most_threads));
  }
  return static_cast<int>(*threads);
}

}  // namespace

Options sweep_options(const Program& program) {
  Options all("Options of sweep");
  add_scene_options(all, program);
  all.add_options()("threads", options::value<std::string>(),
                    "cases at once (default: the number of cores)")(
      "shard", options::value<std::string>(),
      "i/n: only cases i, i + n, i + 2n ...; run merge when all shards are done")(
      "tables", "keep all tables of each case, in a folder of its own");
  add_common_options(all, default_sweep_out);
  return all;
}

ParallelSettings parallel_settings(const Given& given) {
  const auto has = [&](const char* name) { return given.count(name) != 0; };
  return {.threads =
              has("threads") ? threads_of(given["threads"].as<std::string>()) : available_cores(),
          .shard = has("shard") ? std::optional(shard_of(given["shard"].as<std::string>()))
                                : std::nullopt,
          .quiet = has("quiet")};
}

SweepSettings sweep_settings(const Given& given) {
  return {parallel_settings(given), given["out"].as<std::string>(), given.count("tables") != 0};
}

}  // namespace microslip::program
