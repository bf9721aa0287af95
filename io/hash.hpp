#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace brunt {

/// Hash of bytes against damage, not against malice: h = (h ^ word) odd, h ^= h >> 29 over words of
/// eight bytes. Each step is one to one in h and in the word: a change within one word is seen for
/// certain, any other with a chance of 1 - 2^-64.
inline std::uint64_t hash_bytes(std::string_view bytes) {
  std::uint64_t hash = 0x9e3779b97f4a7c15ULL ^ bytes.size();
  const auto take = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * 0xbf58476d1ce4e5b9ULL;
    hash ^= hash >> 29;
  };
  std::uint64_t word = 0;
  while (bytes.size() >= sizeof word) {
    std::memcpy(&word, bytes.data(), sizeof word);
    take(word);
    bytes.remove_prefix(sizeof word);
  }
  word = 0;
  std::memcpy(&word, bytes.data(), bytes.size());
  take(word);
  return hash ^ (hash >> 32);
}

/// Another hash with the same promise: four parts of the bytes side by side, each word of which
/// does not wait for the products of the others.
inline std::uint64_t hash_long_bytes(std::string_view bytes) {
  constexpr std::size_t kParts = 4, kWord = sizeof(std::uint64_t);
  const std::size_t n_words = bytes.size() / (kParts * kWord);
  std::array<std::uint64_t, kParts> hash{1, 2, 3, 4};
  for (std::size_t k = 0; k < n_words; ++k) {
    for (std::size_t p = 0; p < kParts; ++p) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data() + (p * n_words + k) * kWord, kWord);
      hash[p] = (hash[p] ^ word) * 0xbf58476d1ce4e5b9ULL;
      hash[p] ^= hash[p] >> 29;
    }
  }
  std::string rest(bytes.substr(kParts * n_words * kWord));
  rest.append(reinterpret_cast<const char*>(hash.data()), sizeof hash);
  return hash_bytes(rest);
}

/// 16 hex digits.
inline std::string hex_digits(std::uint64_t number) {
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(number >> shift) & 15];
  return digits;
}

}  // namespace brunt
