// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupts.hpp"

#include <pthread.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace microslip::program {

Interrupts::Interrupts(std::string message) : message_(std::move(message)) {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&signals_, signal);
  }
  // Wakes the watcher in the end.
  sigaddset(&signals_, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  watcher_ = std::thread([this] { wait(); });
}

Interrupts::~Interrupts() {
  last([] {});
  pthread_kill(watcher_.native_handle(), SIGUSR1);
  watcher_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupts::critical(const std::function<void()>& part) {
  const std::lock_guard lock(mutex_);
  part();
}

void Interrupts::last(const std::function<void()>& part) {
  critical([&] {
    part();
    over_ = true;
  });
}

void Interrupts::wait() {
  for (int signal = 0; sigwait(&signals_, &signal) == 0;) {
    const std::lock_guard lock(mutex_);
    if (over_) return;
    if (signal == SIGUSR1) continue;
    const bool behind_progress = isatty(STDERR_FILENO) != 0;
    std::cerr << (behind_progress ? "\n" : "") << message_ << std::endl;
    std::_Exit(128 + signal);
  }
}

}  // namespace microslip::program
