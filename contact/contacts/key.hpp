#pragma once
#include <cstdint>
#include <tuple>

#include "core/types.hpp"

namespace brunt {

/// Between what a contact is, in the order in which sums take them. Values stand in checkpoints'
/// tables, in hashes and in frames.
enum class ContactKind : std::uint32_t { face_face, particle_face, particle_particle };
inline constexpr std::size_t kContactKinds = 3;

/// The place of a contact in every sum.
struct ContactKey {
  ContactKind kind = ContactKind::face_face;
  std::uint32_t ordinal = 0;
  GlobalId first = 0,
           second = 0;  ///< lower and upper face or particle, or particle and face
  bool operator<(const ContactKey& other) const {
    return std::tie(kind, first, second, ordinal) <
           std::tie(other.kind, other.first, other.second, other.ordinal);
  }
  bool operator==(const ContactKey&) const = default;
};

}  // namespace brunt
// Tested by tests/unit/contact/keyed_memory_test.cpp.
