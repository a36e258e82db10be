// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "command_line.hpp"

namespace microslip::program {

/// Folder of a sweep, unless --out says otherwise.
inline constexpr const char* default_sweep_out = "out/sweep";

/// Cases i, i + n, i + 2n ... of a sweep.
struct Shard {
  std::size_t number;  ///< i, 1 ... n
  std::size_t count;   ///< n, up to the most cases that a sweep may have
};

/// How work in parts is shared.
struct ParallelSettings {
  int threads;
  std::optional<Shard> shard;
  bool quiet;
};

/// By --threads, --shard and --quiet.
/// \throws std::invalid_argument for --threads and --shard out of their ranges
ParallelSettings parallel_settings(const Given& given);

/// The settings of a sweep, as its options give them.
struct SweepSettings : ParallelSettings {
  std::filesystem::path out;
  bool keeps_tables;
};

/// The options of a program, and --threads, --shard and --tables.
Options sweep_options(const Program& program);

/// \throws as parallel_settings
SweepSettings sweep_settings(const Given& given);

}  // namespace microslip::program
