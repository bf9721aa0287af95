/// Where memory stands. A step goes through a gigabyte in scores of streams, element by element:
///
/// - Blocks of a page or more begin cache lines, so that eight doubles of a field are one line.
/// - Those of some pages begin at different lines: where forty fields began pages, the same element
///   of each fell into the same eight places of the first cache.
/// - Large ones stand in large pages: a processor follows a stream to the end of a page only, and
///   looks up where the next one stands. Those that the others are cut from are gathered into large
///   ones once all are there. Some that are given back are kept (large_heap.hpp).
#include "core/large_blocks.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <string>
#include <type_traits>

#include "core/large_heap.hpp"

// The address sanitizer brings its own.
#ifndef __SANITIZE_ADDRESS__
// What new is made of:
// NOLINTBEGIN(cppcoreguidelines-no-malloc, cppcoreguidelines-owning-memory)
namespace {
constexpr std::size_t kLine = 64, kPage = brunt::LargeHeap::kPage;
/// What is smaller malloc keeps itself.
constexpr std::size_t kLarge = std::size_t{1} << 17;
/// Of which sixteen pages more do not matter to, either.
constexpr std::size_t kWide = std::size_t{1} << 22;
/// What two more pages do not matter to. Smaller ones stand anywhere in a page as it is.
constexpr std::size_t kStaggered = 16 * kPage;
/// What stands before each block: what it is part of, and how large that is if it is a large one.
struct Head {
  void* given;
  std::size_t bytes;  // 0: of malloc
};
/// What malloc aligns to.
constexpr std::size_t kHead = 16;
static_assert(kHead == sizeof(Head) && kHead >= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

/// Blocks are given back until the program has ended: it is never destroyed.
brunt::LargeHeap& large_heap() {
  static_assert(std::is_trivially_destructible_v<brunt::LargeHeap>);
  static constinit brunt::LargeHeap heap;
  return heap;
}

/// Lines from the begin of a page to that of a block: others for each in turn, over the lines of a
/// page, of large blocks over sixteen pages. Strides are odd: all come before one comes again.
std::size_t stagger(std::size_t bytes) {
  static std::atomic<std::size_t> turns{0};
  const std::size_t turn = turns.fetch_add(1, std::memory_order_relaxed);
  return bytes < kWide ? turn * 7 % 64 : turn * 37 % 1024;
}

Head allocate(std::size_t bytes) {
  std::size_t given = bytes;
  void* const at = bytes < kLarge ? nullptr : large_heap().take(given);
  return at != nullptr ? Head{at, given} : Head{std::malloc(bytes), 0};
}

/// align  [byte] a power of 2
void* block(std::size_t bytes, std::size_t align) {
  std::size_t lines = 0;
  std::size_t from = align;
  if (bytes >= kPage) align = from = std::max(align, kLine);
  if (bytes >= kStaggered) from = std::max(align, kPage), lines = stagger(bytes);
  const std::size_t before = lines * kLine / align * align, extra = kHead + from + before;
  constexpr std::size_t kMost = SIZE_MAX / 4;
  if (extra > kMost || bytes > kMost - extra) return nullptr;
  const Head head = allocate(bytes + extra);
  if (head.given == nullptr) return nullptr;
  char* const given = static_cast<char*>(head.given);
  const auto free = reinterpret_cast<std::uintptr_t>(given) + kHead;
  char* const at = given + kHead + (from - free % from) % from + before;
  reinterpret_cast<Head*>(at)[-1] = head;
  return at;
}

void give_back(void* at) noexcept {
  if (at == nullptr) return;
  const Head head = static_cast<Head*>(at)[-1];
  if (head.bytes == 0) {
    std::free(head.given);
  } else {
    large_heap().give_back(head.given, head.bytes);
  }
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
[[gnu::noinline]] void* operator new(std::size_t bytes) { return block_or_throw(bytes, kHead); }
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t align) {
  return block_or_throw(bytes, std::max(static_cast<std::size_t>(align), kHead));
}
[[gnu::noinline]] void operator delete(void* at) noexcept { give_back(at); }
[[gnu::noinline]] void operator delete(void* at, std::size_t) noexcept { give_back(at); }
[[gnu::noinline]] void operator delete(void* at, std::align_val_t) noexcept { give_back(at); }
[[gnu::noinline]] void operator delete(void* at, std::size_t, std::align_val_t) noexcept {
  give_back(at);
}
// NOLINTEND(cppcoreguidelines-no-malloc, cppcoreguidelines-owning-memory)
#endif

namespace brunt {

void keep_freed_blocks([[maybe_unused]] bool keeps) {
#ifndef __SANITIZE_ADDRESS__
  large_heap().keep(keeps);
#endif
}

void gather_heap() {
  constexpr int kCollapse = 25;  // MADV_COLLAPSE, which not all headers have
  constexpr std::size_t kLargePage = LargeHeap::kLargePage;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    void *begin = nullptr, *end = nullptr;
    if (!line.ends_with("[heap]")) continue;
    if (std::sscanf(line.c_str(), "%p-%p ", &begin, &end) != 2) continue;
    auto room = static_cast<std::size_t>(static_cast<char*>(end) - static_cast<char*>(begin));
    void* const from = std::align(kLargePage, kLargePage, begin, room);
    if (from != nullptr) madvise(from, room / kLargePage * kLargePage, kCollapse);
  }
}

}  // namespace brunt
// Tested by tests/unit/core/large_blocks_test.cpp.
