// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>

#include <exception>
#include <functional>
#include <memory>
#include <new>

/// \file
/// All calls of GSL go through this file. GSL reports an error to a handler that belongs to the
/// whole process, and the handler that it comes with ends the program. Here each call returns its
/// status instead, which is thrown, and the program that uses this library keeps its own handler.
namespace microslip::gsl {

/// While at least one of these lives in any thread, GSL's handler is off; the last one to go puts
/// back the handler that the first one found.
class HandlerOff {
 public:
  HandlerOff();
  ~HandlerOff();
  HandlerOff(const HandlerOff&) = delete;
  HandlerOff& operator=(const HandlerOff&) = delete;
};

/// \return what a call of GSL returns, made with the handler off
template <class Call>
auto quietly(const Call& call) {
  const HandlerOff off;
  return call();
}

/// \param what  the name of the function that called GSL, for the message
/// \throws std::bad_alloc if the status is GSL_ENOMEM, std::invalid_argument if it is another error
void require_success(int status, const char* what);

/// What GSL allocates, and frees.
template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

/// \param make  T*(), one of GSL's allocations
/// \throws std::bad_alloc if it returns null
template <class T, class Make>
Owned<T> owned(const Make& make, void (*free)(T*)) {
  Owned<T> made(quietly(make), free);
  if (!made) throw std::bad_alloc();
  return made;
}

/// A function of x that GSL calls. No exception passes through GSL: the first one is kept, values
/// are nan from then on, and the caller of GSL throws it again.
class Function {
 public:
  explicit Function(const std::function<double(double)>& function)
      : function_(function), for_gsl_{call, this} {}
  Function(const Function&) = delete;
  Function& operator=(const Function&) = delete;

  const gsl_function* get() const { return &for_gsl_; }

  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  static double call(double x, void* self) noexcept;

  const std::function<double(double)>& function_;
  gsl_function for_gsl_;
  std::exception_ptr thrown_;
};

}  // namespace microslip::gsl
