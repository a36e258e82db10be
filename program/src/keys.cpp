// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/scene/keys.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "command_line.hpp"
#include "microslip/program/commands.hpp"
#include "process.hpp"

namespace microslip::program {

int keys(const std::string& name, int argc, const char* const* argv) {
  return run_process(name, [&] {
    Options known("Options of keys");
    known.add_options()("version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1);
    if (answers(given, known, name + " keys", "lists the keys of scenes")) return 0;
    std::size_t names = 0, units = 0;
    for (const Key& key : keys_of_scenes()) {
      names = std::max(names, key.name.size());
      units = std::max(units, key.unit.size());
    }
    for (const Key& key : keys_of_scenes()) {
      std::cout << std::left << std::setw(static_cast<int>(names)) << key.name << "  "
                << std::setw(static_cast<int>(units)) << (key.unit == "1" ? "" : key.unit) << "  "
                << key.meaning << ": " << key.accepted << (key.role.empty() ? "" : "; for ")
                << key.role << '\n';
    }
    return 0;
  });
}

}  // namespace microslip::program
