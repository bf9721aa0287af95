#pragma once
/// Which number colours a picture, and how it is named and scaled. Plain data, no VTK.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/view.hpp"

namespace brunt {

/// A scalar made of a field: the field itself, one component, or its magnitude.
struct Colouring {
  std::string field;      ///< "eps_p"
  std::string component;  ///< "", "x", "xx", ..., "magnitude"
  std::string name() const { return component.empty() ? field : field + "." + component; }
};

/// Reads "NAME" or "NAME.COMPONENT"; a vector without a component means its magnitude.
Colouring parse_colouring(const std::string& text);

/// Smallest and largest of what is finite: the last frame of a broken run may hold NaN.
struct Interval {
  Real low = kInfinity;
  Real high = -kInfinity;
  bool empty() const { return low > high; }
  void take(Real value) {
    if (!std::isfinite(value)) return;
    if (value < low) low = value;
    if (value > high) high = value;
  }
};

/// One number a cell or a point; empty where the body has no such field.
struct Scalars {
  bool on_cells = false;
  std::vector<Real> values;
};

/// The numbers of one body. von_mises is computed of "stress" where it is not there itself:
/// sqrt(3/2 s:s), s the deviator. Throws std::invalid_argument where the field is there but has no
/// such component.
Scalars scalars_of(const BodyView& view, const Colouring& colouring);

/// True where a frame shows that a body has state of its own (stress, density, ...): all but rigid
/// bodies.
bool deforms(const BodyView& view);

/// SI unit of a field of core/fields.hpp, "" for pure numbers and what is not known.
std::string unit_of(const std::string& field);

/// True where zero means that there is none of it. Zero kelvin is far from every scene: colours
/// from there on would hide how temperatures differ.
bool shows_from_zero(const std::string& field);

/// A unit with a prefix so that numbers up to `largest` are easy to read: value * factor is in
/// unit.
struct DisplayUnit {
  Real factor = 1;
  std::string unit;
};
DisplayUnit display_unit(Real largest, const std::string& unit);

/// About `count` round numbers (1, 2, 2.5 or 5 times a power of ten apart) within the range.
std::vector<Real> ticks(const Interval& range, int count);

}  // namespace brunt
// Tested by tests/unit/io/render_test.cpp.
