// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <sched.h>

#include <fstream>
#include <string>

#include "microslip/support/format.hpp"

namespace microslip::bench {

namespace {

/// The first such entry in /proc/cpuinfo.
std::string processor(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.rfind(key, 0) == 0 && line.find_first_not_of("\t :", key.size()) == colon + 2) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

}  // namespace

void stay_on_one_core() {
  cpu_set_t core;
  CPU_ZERO(&core);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &core);
  sched_setaffinity(0, sizeof core, &core);
}

Table machine_table() {
  Table table("machine", "what the times were measured with; one core of it",
              {{"quantity", "1", "what is known"}, {"value", "1", "as the system tells it"}});
  const benchmark::CPUInfo& cpu = benchmark::CPUInfo::Get();
  table.add({"processor", processor("model name")});
  table.add({"family, model", fmt::format("{} {} {}", processor("vendor_id"),
                                          processor("cpu family"), processor("model"))});
  table.add({"cores", std::to_string(cpu.num_cpus)});
  table.add({"clock", format_short(cpu.cycles_per_second / 1e9) + " GHz"});
  for (const auto& cache : cpu.caches) {
    table.add({fmt::format("cache L{} {}", cache.level, cache.type),
               fmt::format("{} kB for {} core{}", cache.size / 1024, cache.num_sharing,
                           cache.num_sharing == 1 ? "" : "s")});
  }
  table.add({"compiler", MICROSLIP_COMPILER});
  table.add({"flags", MICROSLIP_FLAGS});
  return table;
}

}  // namespace microslip::bench
