// SPDX-License-Identifier: GPL-3.0-or-later
#include "counted_malloc.hpp"

#include <cerrno>
#include <cstddef>

namespace {
long count = 0;
long failing = 0;

bool fails() { return ++count == failing; }
}  // namespace

long allocations() { return count; }
void fail_allocation(long number) { failing = number; }

extern "C" {

// By these names glibc offers what is replaced here.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  if (fails()) return nullptr;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  if (fails()) return nullptr;
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  if (fails()) return nullptr;
  return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  if (fails()) return nullptr;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}

int posix_memalign(void** place, std::size_t alignment, std::size_t size) noexcept {
  *place = memalign(alignment, size);
  return *place == nullptr ? ENOMEM : 0;
}
}
