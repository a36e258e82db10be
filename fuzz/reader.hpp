// SPDX-License-Identifier: GPL-3.0-or-later
// Requirements on readers that all targets check.
#pragma once

#include <boost/program_options/errors.hpp>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "microslip/support/not_converged.hpp"

/// Begins the function of a target, which takes an input: `data`, of `size` bytes. It is the entry of
/// libFuzzer, or one of the readers of the program that replays inputs.
#ifdef MICROSLIP_FUZZ
#define MICROSLIP_READER(name) \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
#else
#define MICROSLIP_READER(name)                                                           \
  static int read_##name(const std::uint8_t* data, std::size_t size);                    \
  static const bool name##_is_listed = microslip::fuzz::list_reader(#name, read_##name); \
  static int read_##name(const std::uint8_t* data, std::size_t size)
#endif

namespace microslip::fuzz {

using Reader = int(const std::uint8_t* data, std::size_t size);

/// Adds a reader to those that the program replays. \return true
bool list_reader(const char* name, Reader* reader);

inline void require_that(bool holds, std::string_view what, std::string_view found) {
  if (holds) return;
  std::cerr << "expected " << what << ", not: " << found << std::endl;
  std::abort();
}

/// A message is one short line; the longest are those that list all keys of a model.
inline void require_one_line(std::string_view message) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  bool plain = true;
  for (const char c : message) plain = plain && !is_control(c);
  require_that(plain && !message.empty(), "a message in one line", message);
  require_that(message.size() < 1000, "a message of less than 1000 bytes", message);
}

/// Runs a reader, which accepts its input or rejects it in one line; any other exception ends the
/// program, as a finding of the sanitizers does.
template <class Read>
void accepts_or_rejects(Read read) {
  try {
    read();
  } catch (const std::invalid_argument& error) {
    require_one_line(error.what());
  } catch (const NotConverged& error) {
    require_one_line(error.what());
  }
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {data, data + size};
}

}  // namespace microslip::fuzz
