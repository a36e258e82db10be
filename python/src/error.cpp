// SPDX-License-Identifier: GPL-3.0-or-later
#include "error.hpp"

#include <algorithm>
#include <new>

#include "interface.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/require.hpp"

namespace microslip::python {

namespace {

struct Kept {
  int status = 0;
  char key[256] = "";
  char message[4096] = "";
};
thread_local Kept kept;

template <std::size_t size>
void copy_to(char (&to)[size], std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), size - 1);
  std::copy_n(text.data(), length, to);
  to[length] = '\0';
}

int keep(int status, std::string_view message, std::string_view key = "") noexcept {
  kept.status = status;
  copy_to(kept.message, message);
  copy_to(kept.key, key);
  return status;
}

}  // namespace

int keep_error() noexcept {
  try {
    throw;
  } catch (const BadParameter& error) {
    return keep(MICROSLIP_BAD_INPUT, error.what(), error.name());
  } catch (const NotConverged& error) {
    return keep(MICROSLIP_NO_SOLUTION, error.what());
  } catch (const std::invalid_argument& error) {
    return keep(MICROSLIP_BAD_INPUT, error.what());
  } catch (const std::bad_alloc&) {
    return keep(MICROSLIP_OUT_OF_MEMORY, "out of memory");
  } catch (const Stopped& error) {
    return keep(MICROSLIP_PY_STOPPED, error.what());
  } catch (const std::exception& error) {
    return keep(MICROSLIP_INTERNAL, error.what());
  } catch (...) {
    return keep(MICROSLIP_INTERNAL, "an exception of unknown type");
  }
}

}  // namespace microslip::python

using microslip::python::kept;

int microslip_py_error_status(void) { return kept.status; }
const char* microslip_py_error_key(void) { return kept.key; }
const char* microslip_py_error_message(void) { return kept.message; }
