#pragma once
/// What an array with a value per entity is for, said once, where the array is listed. An owner of
/// such arrays (points, elements, particles, rigid bodies, boundaries) lists them in one function,
///   visit_fields(owner, f)  calls f(field, use) for each array that is there, or
///   visit_entity(one, f)    calls f(value, use) for each value of one entity,
/// and room, rows of a checkpoint, hashes, copies on other ranks and parts of a whole follow.
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/state_hash.hpp"
#include "core/types.hpp"

namespace brunt {

/// Every field has a value for each entity and goes where the entity goes.
struct FieldUse {
  bool saved = false;   ///< goes on from step to step: a checkpoint has it
  bool hashed = false;  ///< a part of the state hash
  bool copied = false;  ///< copies on other ranks follow their owner's after every motion
  int blank = 0;        ///< what an entity has until somebody says so
};
inline constexpr FieldUse kSaved{.saved = true};
inline constexpr FieldUse kState{.saved = true, .hashed = true};

/// A value of a field before anybody has set it.
template <class T>
T blank_value(FieldUse use) {
  if constexpr (std::is_arithmetic_v<T>) {
    return static_cast<T>(use.blank);
  } else {
    return T::Zero();
  }
}

/// Gives a field n values: those that it has, then blanks.
template <class T>
void fit_field(std::vector<T>& field, FieldUse use, std::size_t n) {
  field.resize(n, blank_value<T>(use));
}

/// The values of a field at `places`, in that order, become the field.
template <class T, class Places>
void keep_places(std::vector<T>& field, const Places& places) {
  std::vector<T> kept;
  kept.reserve(places.size());
  for (const auto place : places) kept.push_back(field[place]);
  field = std::move(kept);
}

/// Hands the fields of which copies follow their owner to f(field); they are doubles or vectors.
template <class F>
auto copied_in(const F& f) {
  return [&f](auto& field, FieldUse use) {
    if constexpr (!std::is_integral_v<typename std::remove_cvref_t<decltype(field)>::value_type>) {
      if (use.copied) f(field);
    }
  };
}
/// How many doubles a value is; writes it to them, or reads it from them, and returns their end.
constexpr std::size_t width_of(Real) { return 1; }
template <int Dim>
constexpr std::size_t width_of(const Vec<Dim>&) {
  return slot_of(Dim);
}
inline Real* write_value(Real value, Real* out) {
  *out = value;
  return out + 1;
}
template <int Dim>
Real* write_value(const Vec<Dim>& value, Real* out) {
  for (int c = 0; c < Dim; ++c) *out++ = value[c];
  return out;
}
inline const Real* read_value(const Real* in, Real& value) {
  value = *in;
  return in + 1;
}
template <int Dim>
const Real* read_value(const Real* in, Vec<Dim>& value) {
  for (int c = 0; c < Dim; ++c) value[c] = *in++;
  return in;
}

/// Adds what is hashed of an entity: of its vectors of Dim the first components, then the second
/// ones and so on, then all else. visit(f) calls f(value, use) for each of its values.
template <int Dim, class Visit>
void hash_values(EntityHash& hash, const Visit& visit) {
  for (int c = 0; c < Dim; ++c) {
    visit([&](const auto& value, FieldUse use) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, Vec<Dim>>) {
        if (use.hashed) hash.add(value[c]);
      }
    });
  }
  visit([&](const auto& value, FieldUse use) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<T, Real>) {
      if (use.hashed) hash.add(value);
    } else if constexpr (!std::is_arithmetic_v<T> && !std::is_same_v<T, Vec<Dim>>) {
      for (int c = 0; use.hashed && c < T::SizeAtCompileTime; ++c) hash.add(value[c]);
    }
  });
}

}  // namespace brunt
// Tested by tests/unit/core/points_test.cpp.
