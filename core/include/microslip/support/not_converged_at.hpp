// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "microslip/support/not_converged.hpp"

namespace microslip {

/// One of several solutions that is missing: which one stands in front of the message.
class NotConvergedAt : public NotConverged {
 public:
  NotConvergedAt(const std::string& which, const NotConverged& error)
      : NotConverged(error), text_(which + ": " + error.what()) {}

  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

}  // namespace microslip
