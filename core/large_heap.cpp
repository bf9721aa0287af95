#include "core/large_heap.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>

namespace brunt {

namespace {
constexpr std::size_t kPage = LargeHeap::kPage, kLargePage = LargeHeap::kLargePage;
/// What is asked of the system at once: addresses only.
constexpr std::size_t kExtension = 4 * kLargePage;

std::size_t rounded_up(std::size_t n, std::size_t unit) { return (n + unit - 1) / unit * unit; }

/// From a place to where the next large page begins. [byte]
std::size_t to_large_page(const char* at) {
  const auto place = reinterpret_cast<std::uintptr_t>(at);
  return rounded_up(place, kLargePage) - place;
}

/// From where the large page of a place begins to that place. [byte]
std::size_t after_large_page(const char* at) {
  return reinterpret_cast<std::uintptr_t>(at) % kLargePage;
}

char* map_at(char* wanted, std::size_t bytes) {
  void* const given =
      mmap(wanted, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return given == MAP_FAILED ? nullptr : static_cast<char*>(given);
}

/// Whole large pages, those before `end` if nothing stands there; null where the system has none.
char* map_large_pages(char* end, std::size_t bytes) {
  if (end != nullptr && reinterpret_cast<std::uintptr_t>(end) > bytes) {
    char* const given = map_at(end - bytes, bytes);
    if (given != nullptr && to_large_page(given) == 0) return given;
    if (given != nullptr) munmap(given, bytes);
  }
  char* const given = map_at(nullptr, bytes + kLargePage);
  if (given == nullptr) return nullptr;
  const std::size_t before = to_large_page(given);
  if (before > 0) munmap(given, before);
  munmap(given + before + bytes, kLargePage - before);
  return given + before;
}
}  // namespace

/// The smallest range with room for as many bytes, of memory if there is one; n_: none.
std::size_t LargeHeap::find(std::size_t bytes) const {
  std::size_t best = n_;
  for (std::size_t k = 0; k < n_; ++k) {
    const Range& range = free_[k];
    if (range.bytes < bytes) continue;
    if (best == n_ || range.is_better(free_[best], bytes)) best = k;
  }
  return best;
}

void LargeHeap::erase(std::size_t k) {
  std::move(free_.data() + k + 1, free_.data() + n_, free_.data() + k);
  --n_;
}

/// Joins those that it touches; the number of what comes of it.
std::size_t LargeHeap::insert(Range range) {
  std::size_t k = 0;
  while (k < n_ && free_[k].begin < range.begin) ++k;
  if (k < n_ && free_[k].begin == range.end()) {
    range.bytes += free_[k].bytes, range.kept += free_[k].kept;
    erase(k);
  }
  if (k > 0 && free_[k - 1].end() == range.begin) {
    free_[k - 1].bytes += range.bytes, free_[k - 1].kept += range.kept;
    return k - 1;
  }
  std::move_backward(free_.data() + k, free_.data() + n_, free_.data() + n_ + 1);
  free_[k] = range;
  ++n_;
  return k;
}

/// Makes room for as many bytes.
bool LargeHeap::extend(std::size_t bytes) {
  if (n_ == free_.size()) return false;
  for (const std::size_t room : {std::max(bytes, kExtension), bytes}) {
    const std::size_t whole = rounded_up(room, kLargePage);
    char* const begin = map_large_pages(last_mapped_, whole);
    if (begin == nullptr) continue;
    // Where the system has no large pages, ordinary ones do.
    static_cast<void>(madvise(begin, whole, MADV_HUGEPAGE));
    last_mapped_ = begin;
    insert({begin, whole, 0});
    return true;
  }
  return false;
}

/// Gives the whole large pages of a range back that [begin, end) has a part of.
void LargeHeap::release(std::size_t k, char* begin, char* end) {
  Range& range = free_[k];
  begin = std::max(begin - after_large_page(begin), range.begin + to_large_page(range.begin));
  end = std::min(end + to_large_page(end), range.end() - after_large_page(range.end()));
  if (begin >= end) return;
  const auto whole = static_cast<std::size_t>(end - begin);
  madvise(begin, whole, MADV_DONTNEED);
  const std::size_t released = std::min(range.kept, whole);
  range.kept -= released;
  kept_ -= released;
}

void LargeHeap::release_until(std::size_t kept, std::size_t spared) {
  for (std::size_t k = 0; k < n_ && kept_ > kept; ++k) {
    if (k != spared && free_[k].kept > 0) release(k, free_[k].begin, free_[k].end());
  }
}

void* LargeHeap::take(std::size_t& bytes) noexcept {
  const std::lock_guard lock(mutex_);
  bytes = rounded_up(bytes, kPage);
  std::size_t k = find(bytes);
  if (k == n_) {
    if (!extend(bytes)) return nullptr;
    k = find(bytes);
  }
  Range& range = free_[k];
  const std::size_t used = in_use_ + bytes, of_memory = std::min(range.kept, bytes);
  if (of_memory < bytes) {
    const std::size_t others = most_in_use_ > used ? most_in_use_ - used : 0;
    release_until(others + of_memory, k);
  }
  range.bytes -= bytes;
  range.kept -= of_memory;
  kept_ -= of_memory;
  char* const at = range.end();
  // A large page of which some is in use is there as a whole.
  const std::size_t begun = std::min(range.bytes, after_large_page(at));
  if (range.kept < begun) {
    kept_ += begun - range.kept;
    range.kept = begun;
  }
  if (range.bytes == 0) erase(k);
  in_use_ = used;
  most_in_use_ = std::max(most_in_use_, in_use_);
  return at;
}

void LargeHeap::give_back(void* at, std::size_t bytes) noexcept {
  const std::lock_guard lock(mutex_);
  in_use_ -= bytes;
  if (n_ == free_.size()) {
    munmap(at, bytes);
    return;
  }
  kept_ += bytes;
  char* const begin = static_cast<char*>(at);
  const std::size_t k = insert({begin, bytes, bytes});
  if (!keeps_) release(k, begin, begin + bytes);
}

void LargeHeap::keep(bool keeps) noexcept {
  const std::lock_guard lock(mutex_);
  keeps_ = keeps;
  if (!keeps) release_until(0, n_);
}

std::size_t LargeHeap::kept() noexcept {
  const std::lock_guard lock(mutex_);
  return kept_;
}

}  // namespace brunt
