// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace microslip::program {

/// As long as it lives, SIGINT, SIGTERM and SIGHUP end the process between two critical parts, with
/// exit status 128 + signal and one line on stderr. Make it before other threads, which inherit
/// that they do not take these signals. A signal that is ignored stays so.
class Interrupts {
 public:
  explicit Interrupts(std::string message);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  /// Runs a critical part, one at a time.
  void critical(const std::function<void()>& part);

  /// The same for the part with which all is done: a signal that comes during it is too late.
  void last(const std::function<void()>& part);

 private:
  void wait();

  std::string message_;
  sigset_t signals_{};
  sigset_t before_{};
  bool over_ = false;
  std::mutex mutex_;
  std::thread watcher_;
};

}  // namespace microslip::program
