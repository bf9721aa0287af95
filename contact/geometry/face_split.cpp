#include "contact/geometry/face_split.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
/// Parts of the face's area that the parallelogram of a corner's edges has where the face begins
/// to be two triangles, and where it is no plane any more: it would be concave soon.
constexpr Real kTurnNone = 0.1, kTurnWhole = 0.02;
/// A diagonal is the shorter one where its square is less than this part of the other's.
constexpr Real kShorter = 0.5;

/// A smooth step over 0 .. 1 and its slope.
struct Step {
  explicit Step(Real at) {
    const Real s = std::clamp(at, 0.0, 1.0);
    value = s * s * (3 - 2 * s);
    slope = 6 * s * (1 - s);
  }
  Real value, slope;
};
Step step_of_warp(Real part) { return Step((part - kWarpNone) / (kWarpWhole - kWarpNone)); }
Step step_of_turn(Real part) { return Step((part - kTurnNone) / (kTurnWhole - kTurnNone)); }

/// [m^2] by which the warp of a face is measured.
Real least_area(const FacePlane<3>& face) {
  return face.area_start > 0 ? std::min(face.area, face.area_start) : face.area;
}
}  // namespace

Real split_of(const FacePlane<3>& face, const Pack& turns) {
  const bool flat = face.warp <= kWarpNone * std::sqrt(least_area(face));
  const unsigned round = mask_bits(turns >= broadcast<Pack>(kTurnNone * face.area));
  if (flat && round == 0b1111) return 0;
  const Step warp = step_of_warp(face.warp / std::sqrt(least_area(face)));
  const Real least = std::min({turns[0], turns[1], turns[2], turns[3]});
  const Step turn = step_of_turn(least / face.area);
  return 1 - (1 - warp.value) * (1 - turn.value);
}

void add_turn(const FacePlane<3>& face, const Vec3& d, std::array<Vec3, 4>& gradient) {
  const auto& x = face.corner;
  const Vec3 w = (d - face.normal.dot(d) * face.normal) / (2 * face.area);
  if (face.n_corners == 3) {  // D = (x1 - x0) x (x2 - x0)
    const Vec3 of_1 = (x[2] - x[0]).cross(w), of_2 = w.cross(x[1] - x[0]);
    gradient[0] -= of_1 + of_2;
    gradient[1] += of_1;
    gradient[2] += of_2;
    return;
  }
  const Vec3 of_02 = (x[3] - x[1]).cross(w);  // D = (x2 - x0) x (x3 - x1)
  const Vec3 of_13 = w.cross(x[2] - x[0]);
  gradient[0] -= of_02, gradient[2] += of_02;
  gradient[1] -= of_13, gradient[3] += of_13;
}

void add_turn(const FacePlane<2>& face, const Vec<2>& d, std::array<Vec<2>, 2>& gradient) {
  const Vec<2> w = (d - face.normal.dot(d) * face.normal) / face.area;
  const Vec<2> of_1(-w[1], w[0]);  // D = (e_y, -e_x), e = x1 - x0
  gradient[0] -= of_1;
  gradient[1] += of_1;
}

std::array<Vec3, 4> split_gradient(const FacePlane<3>& face) {
  const auto& x = face.corner;
  std::array<Vec3, 4> gradient;
  gradient.fill(Vec3::Zero());
  // By the area: A = |D|/2, D = (x2 - x0) x (x3 - x1).
  const auto add_area = [&](Real by_area) {
    const Vec3 of_2 = 0.5 * by_area * (x[3] - x[1]).cross(face.normal);
    const Vec3 of_3 = 0.5 * by_area * face.normal.cross(x[2] - x[0]);
    gradient[0] -= of_2, gradient[2] += of_2;
    gradient[1] -= of_3, gradient[3] += of_3;
  };
  const Real area = least_area(face), width = std::sqrt(area);
  const Step warp = step_of_warp(face.warp / width);

  std::size_t sharpest = 0;  // the corner behind edge `sharpest`
  std::array<Vec3, 4> edge, turn;
  for (std::size_t i = 0; i < 4; ++i) edge[i] = x[(i + 1) % 4] - x[i];
  for (std::size_t i = 0; i < 4; ++i) {
    turn[i] = edge[i].cross(edge[(i + 1) % 4]);
    if (turn[i].dot(face.normal) < turn[sharpest].dot(face.normal)) sharpest = i;
  }
  const Real least = turn[sharpest].dot(face.normal);
  const Step of_turn = step_of_turn(least / face.area);

  const Real by_warp =
      (1 - of_turn.value) * warp.slope / ((kWarpWhole - kWarpNone) * width);  // [1/m]
  if (by_warp != 0) {
    const Vec3 across = (x[0] - x[1]) + (x[2] - x[3]);
    const Real sign = across.dot(face.normal) < 0 ? -0.25 : 0.25;
    for (std::size_t i = 0; i < 4; ++i) {
      gradient[i] += (i % 2 == 0 ? 1 : -1) * sign * by_warp * face.normal;
    }
    add_turn(face, sign * by_warp * across, gradient);
    if (area == face.area) add_area(-0.5 * by_warp * face.warp / area);
  }
  const Real by_turn =
      (1 - warp.value) * of_turn.slope / ((kTurnWhole - kTurnNone) * face.area);  // [1/m^2]
  if (by_turn != 0) {
    const std::size_t a = sharpest, b = (a + 1) % 4, c = (a + 2) % 4;
    const Vec3 of_first = by_turn * edge[b].cross(face.normal);
    const Vec3 of_second = by_turn * face.normal.cross(edge[a]);
    gradient[a] -= of_first;
    gradient[b] += of_first - of_second;
    gradient[c] += of_second;
    add_turn(face, by_turn * turn[a], gradient);
    add_area(-by_turn * least / face.area);
  }
  return gradient;
}

SplitFace split(const FacePlane<3>& face) {
  const auto& x = face.corner;
  const auto twice = [&](int a, int b, int c) {
    const auto at = [&](int k) { return x[slot_of(k)]; };
    return (at(b) - at(a)).cross(at(c) - at(a)).dot(face.normal);
  };
  const bool first_fits = twice(0, 1, 2) >= 0 && twice(0, 2, 3) >= 0;
  const bool second_fits = twice(1, 2, 3) >= 0 && twice(1, 3, 0) >= 0;
  // Of diagonals nearly alike, as those of a square are, always the same: under pressure its
  // surface would jump with every rounding.
  const bool second_shorter = (x[3] - x[1]).squaredNorm() < kShorter * (x[2] - x[0]).squaredNorm();
  const bool first = first_fits == second_fits ? !second_shorter : first_fits;
  SplitFace halves;
  halves.corners = first ? std::array<std::array<int, 3>, 2>{{{0, 1, 2}, {0, 2, 3}}}
                         : std::array<std::array<int, 3>, 2>{{{1, 2, 3}, {1, 3, 0}}};
  for (std::size_t p = 0; p < 2; ++p) {
    auto& part = halves.part[p];
    part.n_corners = 3;
    part.sharpness = face.sharpness;
    for (std::size_t c = 0; c < 3; ++c) {
      part.corner[c] = x[slot_of(halves.corners[p][c])];
    }
    part.corner[3].setZero();
    // Edges that are the face's keep their borders; the diagonal is none.
    for (std::size_t c = 0; c < 3; ++c) {
      const int from = halves.corners[p][c], to = halves.corners[p][(c + 1) % 3];
      const bool of_face = (from + 1) % 4 == to && (face.borders >> from & 1U) != 0;
      part.borders = static_cast<std::uint8_t>(part.borders | (of_face ? 1U << c : 0U));
    }
    refresh(part);
  }
  return halves;
}

}  // namespace brunt
// Tested by tests/unit/contact/face_split_test.cpp.
