#pragma once
/// Sizes of elements that change along an axis of a shape.
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/schema.hpp"

namespace brunt {

enum class Toward : int { min, max, both, middle };

/// Finer elements towards an end of a shape, both ends or its middle, before it is turned and
/// moved.
struct Grading {
  int axis = 0;    ///< 0, 1, 2: x, y, z
  Real ratio = 1;  ///< largest over smallest element size
  Toward toward = Toward::min;

  /// True where both halves are alike.
  bool symmetric() const { return toward == Toward::both || toward == Toward::middle; }
};
void describe(Schema& s, Grading& grading);

/// A grading that has no meaning for its shape, with what would do.
struct GradingError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A grading as it is seen along its axis, or against it; none where it is null.
std::optional<Grading> turned(const Grading* grading, bool against);

/// Places of the n + 1 layers of nodes between n layers of elements, as fractions of the length:
/// 0 first, 1 last. Sizes are a geometric progression, h_i/h_0 = ratio^(i/(n-1)), from the fine
/// end; towards both ends they rise to the middle and fall again, towards the middle the other way.
/// Throws GradingError where there are too few layers for a smallest and a largest one: 2, or 3
/// where both halves are alike.
std::vector<Real> graded_layers(const Grading& grading, int n);

/// Smallest number of layers of which none is thicker than size [m], along a length [m].
int graded_count(const Grading& grading, Real length, Real size);

/// Grades a disc (2D) or a ball (3D) about the origin towards the end of a direction: the conformal
/// map of the ball to itself (Ahlfors 1981, Moebius transformations in several dimensions, II)
///   x -> ((1 + 2 a.x + x^2) a + (1 - a^2) x)/(1 + 2 a.x + a^2 x^2)
/// with lengths in radii. Its scale falls smoothly by `ratio` from one end to the other, and
/// elements keep their shapes: a = (sqrt(ratio) - 1)/(sqrt(ratio) + 1) along the direction.
/// direction  unit vector to the fine end;  nodes [m], in and out
template <int Dim>
void grade_ball(const Vec<Dim>& direction, Real ratio, Real radius, std::vector<Vec<Dim>>& nodes);

}  // namespace brunt
