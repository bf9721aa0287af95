#pragma once
/// Fields of a view: how they are filled, at once or when they are read, and how they are read.
///
///   FieldAdder fields(wanted, view.point_fields);
///   fields.add("velocity", n, [=](std::size_t k) -> Vec<3> { return velocity_of(k); });
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "core/parallel/threads.hpp"
#include "core/view.hpp"

namespace brunt {

inline constexpr std::size_t kMostComponents = 6;
inline constexpr std::size_t kFieldPart = 512;  ///< entities at a time: they stay in the cache

/// True where all are finite numbers in single precision too, which files have.
inline bool are_singles(std::span<const Real> values) {
  constexpr Real kMost = std::numeric_limits<float>::max();
  bool all = true;  // without a way out in between, several at a time
  for (const Real value : values) all &= std::fabs(value) <= kMost;
  return all;
}

/// Calls take(at, values) with the values of a field in parts, side by side on all threads.
/// at  place of the first of them among all values
template <class Take>
void for_parts(const Field& field, const Take& take) {
  constexpr std::size_t kWorthThreads = 4;  // parts
  const auto components = slot_of(field.components);
  const std::size_t n = field.size() / components;
  const std::size_t n_parts = (n + kFieldPart - 1) / kFieldPart;
  for_each(n_parts, kWorthThreads, [&](std::size_t p) {
    const std::size_t first = p * kFieldPart, last = std::min(n, first + kFieldPart);
    const std::size_t at = first * components, size = (last - first) * components;
    if (!field.fill) {
      take(at, std::span<const Real>(field.values).subspan(at, size));
      return;
    }
    std::array<Real, kFieldPart * kMostComponents> part;
    field.fill(first, last, part.data());
    take(at, std::span<const Real>(part.data(), size));
  });
}

/// Gives a field that waits its values.
inline void make_values(Field& field) {
  if (!field.fill) return;
  std::vector<Real> values(field.size());
  for_parts(field, [&values](std::size_t at, std::span<const Real> part) {
    std::copy(part.begin(), part.end(), values.begin() + static_cast<std::ptrdiff_t>(at));
  });
  field.values = std::move(values);
  field.fill = nullptr, field.n_waiting = 0;
}

/// Values of one entity as a field has them: a number, a vector (in the plane z = 0), a tensor.
inline void put_values(Real value, Real* to) { *to = value; }
template <int Dim>
void put_values(const Vec<Dim>& value, Real* to) {
  for (int i = 0; i < 3; ++i) to[i] = i < Dim ? value[i] : 0.0;
}
inline void put_values(const std::array<Real, 6>& value, Real* to) {
  std::copy(value.begin(), value.end(), to);
}

/// Adds fields to a list, of those that are wanted.
class FieldAdder {
 public:
  FieldAdder(const WantedFields& wanted, std::vector<Field>& fields)
      : wanted_(wanted), fields_(fields) {}

  /// value(k)  of the k-th of n entities: Real, Vec<Dim> or std::array<Real, 6>; any thread may
  ///           call it. Where fields may wait it is kept, and has to hold what it reads.
  template <class Value>
  void add(const char* name, std::size_t n, Value value) {
    if (!wanted_.has(name)) return;
    using Of = std::decay_t<decltype(value(std::size_t{}))>;
    constexpr int components = std::is_same_v<Of, Real>                  ? 1
                               : std::is_same_v<Of, std::array<Real, 6>> ? 6
                                                                         : 3;
    Field& field = fields_.emplace_back(Field{name, components, {}});
    field.n_waiting = n;
    field.fill = [value = std::move(value)](std::size_t first, std::size_t last, Real* to) {
      for (std::size_t k = first; k < last; ++k, to += components) put_values(value(k), to);
    };
    if (!wanted_.may_wait) make_values(field);
  }

 private:
  const WantedFields& wanted_;
  std::vector<Field>& fields_;
};

}  // namespace brunt
// Tested by tests/unit/core/view_fields_test.cpp.
