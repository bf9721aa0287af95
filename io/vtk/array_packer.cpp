#include "io/vtk/array_packer.hpp"

#include <vtkLZ4DataCompressor.h>
#include <vtkNew.h>

#include <algorithm>

#include "core/errors.hpp"
#include "core/parallel/threads.hpp"
#include "io/hash.hpp"

namespace brunt {

namespace {

constexpr std::size_t kBlock = 1 << 18;   // [byte] a multiple of all numbers
constexpr std::size_t kAtOnce = 8;        // blocks
constexpr std::size_t kSample = 1 << 12;  // [byte] of a block that are tried
constexpr double kWorthPacking = 0.5;     // of its bytes, at most
constexpr double kWorthKeeping = 0.75;    // the same of what is packed once for many frames
constexpr std::size_t kRoom = kBlock + kBlock / 255 + 16;  // [byte] a packed block at most

/// What LZ4 has before a block that says nothing but its bytes: how many (15 and what is beyond, in
/// bytes of at most 255). Returns its size.
std::size_t put_plain_head(std::size_t n_bytes, char* to) {
  constexpr std::size_t kInToken = 15, kMost = 255;
  char* const begin = to;
  *to++ = static_cast<char>(std::min(n_bytes, kInToken) << 4);
  if (n_bytes >= kInToken) {
    std::size_t rest = n_bytes - kInToken;
    for (; rest >= kMost; rest -= kMost) *to++ = static_cast<char>(kMost);
    *to++ = static_cast<char>(rest);
  }
  return static_cast<std::size_t>(to - begin);
}

std::size_t pack_block(vtkLZ4DataCompressor& lz4, std::string_view bytes, char* to) {
  return lz4.Compress(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                      reinterpret_cast<unsigned char*>(to), kRoom);
}

std::string_view bytes_of(const std::vector<std::uint64_t>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint64_t)};
}

/// A text as a file that can be appended to.
class Text {
 public:
  std::size_t size() const { return text_.size(); }
  void append(std::string_view bytes) { text_ += bytes; }
  void overwrite(std::size_t at, std::string_view bytes) { text_.replace(at, bytes.size(), bytes); }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace

/// Packs up to kAtOnce first blocks of the bytes, or makes what stands before plain ones.
/// worth  of a sample's bytes, at most, where they are packed
/// size   [byte] out, of each of them
void ArrayPacker::pack(std::string_view bytes, double worth, std::span<std::uint64_t> size) {
  const std::size_t n = size.size();
  if (packed_.size() < n * kRoom) packed_.resize(n * kRoom), head_.resize(kAtOnce);
  on_threads(n > 1, [&] {
    const vtkNew<vtkLZ4DataCompressor> lz4;
#pragma omp for schedule(static)
    for (std::size_t k = 0; k < n; ++k) {
      const std::string_view block = bytes.substr(k * kBlock, kBlock);
      const std::string_view sample = block.substr(0, kSample);
      char* const to = &packed_[k * kRoom];
      const auto packed = static_cast<double>(pack_block(*lz4, sample, to));
      const bool packs = packed < worth * static_cast<double>(sample.size());
      head_[k] = packs ? 0 : put_plain_head(block.size(), to);
      size[k] = packs ? pack_block(*lz4, block, to) : head_[k] + block.size();
    }
  });
}

template <class Sink>
void ArrayPacker::pack_into(std::string_view bytes, double worth, Sink& sink) {
  const std::size_t whole = bytes.size() / kBlock, last = bytes.size() % kBlock;
  std::vector<std::uint64_t> head{whole + (last > 0 ? 1 : 0), kBlock, last};
  const std::size_t at = sink.size(), n_blocks = head[0];
  head.resize(3 + n_blocks);
  sink.append(bytes_of(head));
  for (std::size_t b = 0; b < n_blocks; b += kAtOnce) {
    const std::size_t n = std::min(kAtOnce, n_blocks - b);
    pack(bytes.substr(b * kBlock), worth, {&head[3 + b], n});
    if (std::find(&head[3 + b], &head[3 + b] + n, 0) != &head[3 + b] + n) {
      throw MachineError("cannot write a frame: LZ4 does not pack an array");
    }
    for (std::size_t k = 0; k < n; ++k) {
      const bool plain = head_[k] > 0;
      const std::size_t size = plain ? head_[k] : head[3 + b + k];
      sink.append(std::string_view(packed_).substr(k * kRoom, size));
      if (plain) sink.append(bytes.substr((b + k) * kBlock, kBlock));
    }
  }
  sink.overwrite(at, bytes_of(head));
}

void ArrayPacker::append(std::string_view bytes, ReplacedFile& file) {
  pack_into(bytes, kWorthPacking, file);
}

void ArrayPacker::append_kept(const std::string& name, std::string_view bytes, KeptArrays& kept,
                              ReplacedFile& file) {
  const std::uint64_t hash = hash_long_bytes(bytes);
  KeptArrays::Array& array = kept.by_name[name];
  if (array.packed.empty() || array.size != bytes.size() || array.hash != hash) {
    Text text;
    pack_into(bytes, kWorthKeeping, text);
    array = {bytes.size(), hash, text.take()};
    array.packed.shrink_to_fit();  // it doubled as it grew, and stays
  }
  file.append(array.packed);
}

}  // namespace brunt
