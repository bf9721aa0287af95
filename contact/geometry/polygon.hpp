#pragma once
#include <array>

#include "core/types.hpp"

namespace brunt {

/// A convex polygon in the plane of a contact [m], counter-clockwise, in fixed room: two quads
/// clipped by each other and by one line have at most nine corners.
struct Polygon {
  static constexpr int kRoom = 12;
  static constexpr std::uint8_t kCut = 255;     ///< a side where a field is 0
  static constexpr std::uint8_t kOfSecond = 4;  ///< and more: sides of the second of two quads
  std::array<Vec<2>, kRoom> corner;
  std::array<std::uint8_t, kRoom> side;  ///< whose side begins at a corner; of a face: that corner
  int size = 0;

  Polygon() {}  // NOLINT(modernize-use-equals-default): the room is not filled
  Polygon(const Polygon& other) { *this = other; }
  /// Of the corners that are there, which are a third of the room.
  Polygon& operator=(const Polygon& other) {
    if (this == &other) return *this;
    size = 0;
    for (int i = 0; i < other.size; ++i) push(other[i], other.side[slot_of(i)]);
    return *this;
  }

  void push(const Vec<2>& p, std::uint8_t of = kCut) {
    side[slot_of(size)] = of;
    corner[slot_of(size++)] = p;
  }
  const Vec<2>& operator[](int i) const { return corner[slot_of(i)]; }
};

/// A linear function over the plane: value + slope . p.
struct LinearField {
  Real value = 0;
  Vec<2> slope = Vec<2>::Zero();
  Real at(const Vec<2>& p) const { return value + slope[0] * p[0] + slope[1] * p[1]; }
};

/// The part of a convex polygon where the field is not negative (Sutherland & Hodgman 1974), to
/// another. Its sides keep their names, and where the field cuts it begins one named kCut.
void clip(const Polygon& polygon, const LinearField& keep, Polygon& kept);

/// The overlap of two convex counter-clockwise polygons. Sides of b are named kOfSecond and more in
/// it, those of a keep their names; where both coincide, a's name stays.
Polygon intersect(const Polygon& a, const Polygon& b);

/// Signed area [m^2]; positive if counter-clockwise.
Real area(const Polygon& polygon);

/// Exact integrals of a linear field g over a polygon, by a fan of triangles.
struct FieldIntegrals {
  Real area = 0;                   ///< [m^2]
  Real total = 0;                  ///< integral of g
  Vec<2> moment = Vec<2>::Zero();  ///< integral of g p
  Vec<2> first = Vec<2>::Zero();   ///< integral of p
};
FieldIntegrals integrate(const Polygon& polygon, const LinearField& g);

}  // namespace brunt
