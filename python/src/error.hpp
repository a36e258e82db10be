// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace microslip::python {

/// Work was told to end.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

/// Keeps what is being thrown for microslip_py_error_*(), and returns its status.
int keep_error() noexcept;

/// Does the work of a function that returns a pointer: null if it throws.
template <class Work>
auto or_null(const Work& work) noexcept -> decltype(work()) {
  try {
    return work();
  } catch (...) {
    keep_error();
    return nullptr;
  }
}

/// Likewise of one that returns a text, which is valid until its thread does the same work again.
template <class Work>
const char* text_or_null(const Work& work) noexcept {
  static thread_local std::string text;
  return or_null([&] {
    text = work();
    return text.c_str();
  });
}

/// Likewise of one that returns a status.
template <class Work>
int status_of(const Work& work) noexcept {
  try {
    work();
    return 0;
  } catch (...) {
    return keep_error();
  }
}

}  // namespace microslip::python
