// SPDX-License-Identifier: GPL-3.0-or-later
#include "process.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <stdexcept>

#include "command_line.hpp"

namespace microslip::program {

namespace {

void flush_standard_output() {
  if (!std::cout.flush()) {
    throw std::runtime_error(
        fmt::format("cannot write to standard output: {}", std::strerror(errno)));
  }
}

}  // namespace

int run_process(const std::string& name, const std::function<int()>& action) {
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  return status_of(name, [&] {
    const int status = action();
    flush_standard_output();
    return status;
  });
}

}  // namespace microslip::program
