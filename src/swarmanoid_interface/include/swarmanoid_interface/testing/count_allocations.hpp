/// For tests of code that must not allocate: counts every malloc of the program, and so every new.
///
/// It replaces malloc and its relatives in the test's executable; several of its sources may include it.
#pragma once

#include <atomic>
#include <cerrno>
#include <cstddef>

// Sanitizers have their own malloc: allocations are not counted, and tests skip themselves.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SWARMANOID_COUNTS_ALLOCATIONS 0
#else
#define SWARMANOID_COUNTS_ALLOCATIONS 1
#endif

namespace swarmanoid {

/// Allocations since the program began, by all threads.
inline std::atomic<long> heap_allocations{0};

}  // namespace swarmanoid

#if SWARMANOID_COUNTS_ALLOCATIONS
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): glibc's own names
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

[[gnu::weak]] void* malloc(std::size_t size) noexcept {
  ++swarmanoid::heap_allocations;
  return __libc_malloc(size);
}

[[gnu::weak]] void* calloc(std::size_t count, std::size_t size) noexcept {
  ++swarmanoid::heap_allocations;
  return __libc_calloc(count, size);
}

[[gnu::weak]] void* realloc(void* memory, std::size_t size) noexcept {
  ++swarmanoid::heap_allocations;
  return __libc_realloc(memory, size);
}

[[gnu::weak]] void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++swarmanoid::heap_allocations;
  return __libc_memalign(alignment, size);
}

[[gnu::weak]] int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  ++swarmanoid::heap_allocations;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}
#endif
