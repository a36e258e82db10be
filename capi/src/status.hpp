// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "microslip.h"
#include "microslip/support/not_converged.hpp"

namespace microslip::capi {

/// Where a call that fails says why; nowhere, if there is no text or no room. Allocates nothing, as
/// memory may be what is missing.
struct Message {
  char* text;
  std::size_t size;

  void say(std::string_view why) const noexcept {
    if (text == nullptr || size == 0) return;
    const std::size_t length = std::min(why.size(), size - 1);
    std::copy_n(why.data(), length, text);
    text[length] = '\0';
  }
};

/// The warning of a handle: of its last load, or, where that has none, of the units of its creation.
class Warning {
 public:
  void say(std::string_view why) noexcept { Message{text_, sizeof text_}.say(why); }

  void say_of_units(std::string_view why) noexcept {
    Message{units_, sizeof units_}.say(why);
    say(units_);
  }

  void forget_load() noexcept { say(units_); }

  const char* text() const noexcept { return text_; }

 private:
  char text_[512] = "", units_[512] = "";
};

/// Does the work of a function of the C interface. All exceptions end here.
template <class Work>
microslip_status guarded(const Message& message, const Work& work) noexcept {
  const auto failed = [&](microslip_status status, std::string_view why) {
    message.say(why);
    return status;
  };
  try {
    work();
    return MICROSLIP_OK;
  } catch (const NotConverged& error) {
    return failed(MICROSLIP_NO_SOLUTION, error.what());
  } catch (const std::invalid_argument& error) {
    return failed(MICROSLIP_BAD_INPUT, error.what());
  } catch (const std::bad_alloc&) {
    return failed(MICROSLIP_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(MICROSLIP_INTERNAL, error.what());
  } catch (...) {
    return failed(MICROSLIP_INTERNAL, "an exception of unknown type");
  }
}

/// \throws std::invalid_argument if a pointer that the caller gave is null
template <class Value>
Value& require_pointer(Value* pointer, std::string_view name) {
  if (pointer == nullptr) {
    throw std::invalid_argument(fmt::format("{} = null: expected a pointer", name));
  }
  return *pointer;
}

}  // namespace microslip::capi
