// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace microslip::program {

/// While an object lives, SIGINT, SIGTERM and SIGHUP end the process between two critical sections,
/// with exit status 128 + signal and one line on stderr. Construct the object before other threads
/// start: these then inherit the blocked signals. A signal that is ignored stays ignored.
class Interrupts {
 public:
  explicit Interrupts(std::string message);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  /// Runs a critical section, one at a time.
  void critical(const std::function<void()>& part);

  /// Runs the last critical section; a signal that arrives during it has no effect.
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
