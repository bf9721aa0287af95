#pragma once
#include <array>

#include "core/search/search.hpp"
#include "core/surface.hpp"

namespace brunt {

/// A face at one instant: its corners and its mean plane. What the contact kernels read.
template <int Dim>
struct FacePlane {
  static constexpr int kCorners = Facet<Dim>::kNodes;
  std::array<Vec<Dim>, kCorners> corner;  ///< [m]
  int n_corners = kCorners;
  std::uint8_t borders = 0;            ///< as of Facet
  Real sharpness = kBoxSharpness;      ///< as of Facet
  Vec<Dim> center = Vec<Dim>::Zero();  ///< [m] mean of the corners
  Vec<Dim> normal = Vec<Dim>::Zero();  ///< unit, out of the body (Newell); 0 if degenerate
  Real area = 0;                       ///< [m^2]; 2D: length [m]; 0 if degenerate
  Real warp = 0;                       ///< [m] distance of the corners from the mean plane
  bool simple = true;                  ///< one plane will do: convex, warp within kWarpLimit
  bool flat = true;                    ///< it is one plane: convex, warp within kFlatLimit
  bool rigid = false;                  ///< it keeps its shape: nothing behind it deforms
};

/// A quad whose corners leave their mean plane by more than this times sqrt(area) is split. Under
/// pressure that changes what it holds at once: elements that are crushed shall hardly come there
/// (docs/decisions/212-warp-of-faces.md).
inline constexpr Real kWarpLimit = 0.12;
/// The same beside a rigid face, which keeps its plane: what jumps where a face is split grows with
/// the square of its warp (docs/decisions/222-four-triangles-on-rigid-faces.md).
inline constexpr Real kFlatLimit = 0.005;

/// A corner counts as convex if its parallelogram has at least this part of the face's area.
inline constexpr Real kConvexLimit = 0.02;

/// Fills all but `corner`, `n_corners`, `borders` and `sharpness`. A face without area or with a
/// NaN gets area 0.
template <int Dim>
void refresh(FacePlane<Dim>& face);

/// Box about the corners, wider by reach [m] on all sides.
template <int Dim>
SearchBox<Dim> box_of(const FacePlane<Dim>& face, Real reach);

/// A quad as four triangles about its centre, as particles see it too: corners i and i + 1, then
/// the centre, which goes with a quarter of each corner. No choice of a diagonal, which would
/// change under pressure (docs/decisions/214-four-triangles.md). One that is turned over, where the
/// centre of a concave quad lies outside it, has no area.
std::array<FacePlane<3>, 4> split(const FacePlane<3>& face);

}  // namespace brunt
