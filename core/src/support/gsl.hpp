// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>

#include <exception>
#include <functional>
#include <memory>
#include <new>

/// \file
/// Calls of GSL that may fail go through this file. GSL reports errors to a handler that belongs to
/// the whole process; GSL's default handler ends the program. Here each call returns a status
/// instead, and a program that uses this library keeps its own handler.
namespace microslip::gsl {

/// Switches GSL's handler off while at least one of these objects lives in any thread. The last
/// object to be destroyed restores the handler that the first one found.
class HandlerOff {
 public:
  HandlerOff();
  ~HandlerOff();
  HandlerOff(const HandlerOff&) = delete;
  HandlerOff& operator=(const HandlerOff&) = delete;
};

/// \return the result of a call of GSL, made with the handler off
template <class Call>
auto quietly(const Call& call) {
  const HandlerOff off;
  return call();
}

/// Owner of an object that GSL allocates and frees.
template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

/// \param make  T*(), one of GSL's allocations
/// \throws std::bad_alloc if make returns null
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
