/// Large blocks of memory stand in large pages. A step of a scene with millions of points goes
/// through a gigabyte in a score of streams, each of which the processor follows to the end of a
/// page only, and looks up where the next one stands.
#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

// The address sanitizer brings its own.
#ifndef __SANITIZE_ADDRESS__
// What new is made of:
// NOLINTBEGIN(cppcoreguidelines-no-malloc, cppcoreguidelines-owning-memory)
namespace {
constexpr std::size_t kPage = std::size_t{1} << 21;
/// What is smaller may be rounded up by too much, and fits the caches.
constexpr std::size_t kLarge = 2 * kPage;

/// align  [byte] 0: that of malloc
void* block(std::size_t bytes, std::size_t align) {
  if (bytes < kLarge || align > kPage) {
    if (align == 0) return std::malloc(bytes != 0 ? bytes : 1);
    void* at = nullptr;
    return posix_memalign(&at, std::max(align, sizeof(void*)), bytes) == 0 ? at : nullptr;
  }
  if (bytes > SIZE_MAX - kPage) return nullptr;
  void* const at = std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage);
  // Where the system has none, ordinary pages do.
  if (at != nullptr) static_cast<void>(madvise(at, bytes, MADV_HUGEPAGE));
  return at;
}

void* block_or_throw(std::size_t bytes, std::size_t align) {
  for (;;) {
    if (void* const at = block(bytes, align)) return at;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}
}  // namespace

// Not inlined: the compiler would find that what a caller frees came from new.
[[gnu::noinline]] void* operator new(std::size_t bytes) { return block_or_throw(bytes, 0); }
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t align) {
  return block_or_throw(bytes, static_cast<std::size_t>(align));
}
[[gnu::noinline]] void operator delete(void* at) noexcept { std::free(at); }
[[gnu::noinline]] void operator delete(void* at, std::size_t) noexcept { std::free(at); }
[[gnu::noinline]] void operator delete(void* at, std::align_val_t) noexcept { std::free(at); }
[[gnu::noinline]] void operator delete(void* at, std::size_t, std::align_val_t) noexcept {
  std::free(at);
}
// NOLINTEND(cppcoreguidelines-no-malloc, cppcoreguidelines-owning-memory)
#endif
