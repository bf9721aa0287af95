#pragma once
/// Corners of quads as they lie in memory, and side by side.
#include "contact/geometry/place.hpp"
#include "core/transpose.hpp"

namespace brunt {

/// The corners of a quad, twelve numbers in a row, as three packs.
struct CornerRows {
  Pack row[3];
  CornerRows(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
      : row{{a[0], a[1], a[2], b[0]}, {b[1], b[2], c[0], c[1]}, {c[2], d[0], d[1], d[2]}} {}
  explicit CornerRows(const std::array<Vec3, 4>& x)
      : row{load(x[0].data()), load(x[0].data() + kLanes), load(x[0].data() + 2 * kLanes)} {}
};

/// Corner c of four quads, for c = 0 .. 3.
BRUNT_INLINE std::array<Place<Pack>, 4> side_by_side(const CornerRows& a, const CornerRows& b,
                                                     const CornerRows& c, const CornerRows& d) {
  Pack first[4], middle[4], last[4];
  transpose(a.row[0], b.row[0], c.row[0], d.row[0], first);
  transpose(a.row[1], b.row[1], c.row[1], d.row[1], middle);
  transpose(a.row[2], b.row[2], c.row[2], d.row[2], last);
  return {{{first[0], first[1], first[2]},
           {first[3], middle[0], middle[1]},
           {middle[2], middle[3], last[0]},
           {last[1], last[2], last[3]}}};
}

}  // namespace brunt
// Tested by tests/unit/contact/unlisted_faces_test.cpp.
