#pragma once
/// Values one after another in a message, and out of it again.
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "core/errors.hpp"
#include "core/parallel/communicator.hpp"

namespace brunt {

class Packer {
 public:
  template <class T>
  Packer& operator<<(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof(T));
    return *this;
  }
  template <class T>
  Packer& operator<<(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    *this << static_cast<std::uint64_t>(values.size());
    append(values.data(), values.size() * sizeof(T));
    return *this;
  }
  Packer& operator<<(const std::string& text) {
    *this << static_cast<std::uint64_t>(text.size());
    append(text.data(), text.size());
    return *this;
  }
  Bytes take() { return std::move(bytes_); }
  bool empty() const { return bytes_.empty(); }

 private:
  void append(const void* from, std::size_t size) {
    if (size == 0) return;
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    std::memcpy(bytes_.data() + at, from, size);
  }
  Bytes bytes_;
};

/// Reads what a Packer wrote, in the same order. Throws MachineError where the message is short.
class Unpacker {
 public:
  explicit Unpacker(const Bytes& bytes) : bytes_(bytes) {}
  bool done() const { return at_ == bytes_.size(); }
  template <class T>
  Unpacker& operator>>(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    copy(&value, sizeof(T));
    return *this;
  }
  template <class T>
  Unpacker& operator>>(std::vector<T>& values) {
    std::uint64_t n = 0;
    *this >> n;
    if (n > (bytes_.size() - at_) / sizeof(T)) fail();
    values.resize(n);
    copy(values.data(), n * sizeof(T));
    return *this;
  }
  Unpacker& operator>>(std::string& text) {
    std::uint64_t n = 0;
    *this >> n;
    if (n > bytes_.size() - at_) fail();
    text.resize(n);
    copy(text.data(), n);
    return *this;
  }

 private:
  [[noreturn]] static void fail() { throw MachineError("a message between ranks is cut short"); }
  void copy(void* to, std::size_t size) {
    if (size > bytes_.size() - at_) fail();
    if (size != 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }
  const Bytes& bytes_;
  std::size_t at_ = 0;
};

}  // namespace brunt
