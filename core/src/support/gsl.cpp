// SPDX-License-Identifier: GPL-3.0-or-later
#include "gsl.hpp"

#include <limits>
#include <mutex>

namespace microslip::gsl {

namespace {

std::mutex mutex;
int users = 0;
gsl_error_handler_t* found = nullptr;

}  // namespace

HandlerOff::HandlerOff() {
  const std::lock_guard lock(mutex);
  if (users++ == 0) found = gsl_set_error_handler_off();
}

HandlerOff::~HandlerOff() {
  const std::lock_guard lock(mutex);
  if (--users == 0) gsl_set_error_handler(found);
}

double Function::call(double x, void* self) noexcept {
  auto& function = *static_cast<Function*>(self);
  if (!function.thrown_) {
    try {
      return function.function_(x);
    } catch (...) {
      function.thrown_ = std::current_exception();
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace microslip::gsl
