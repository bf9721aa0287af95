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
};

/// A quad whose corners leave their mean plane by more than this times sqrt(area) is split. Under
/// pressure that changes what it holds at once: elements that are crushed shall hardly come there
/// (docs/decisions/212-warp-of-faces.md).
inline constexpr Real kWarpLimit = 0.12;

/// Fills all but `corner`, `n_corners`, `borders` and `sharpness`. A face without area or with a
/// NaN gets area 0.
template <int Dim>
void refresh(FacePlane<Dim>& face);

/// Box about the corners, wider by reach [m] on all sides.
template <int Dim>
SearchBox<Dim> box_of(const FacePlane<Dim>& face, Real reach);

/// A quad as two triangles, along the diagonal that leaves both with the quad's orientation, else
/// along that of corners 1 and 3 if it is much shorter. corners[i][c] is the quad's corner.
struct SplitFace {
  std::array<FacePlane<3>, 2> part;
  std::array<std::array<int, 3>, 2> corners;
};
SplitFace split(const FacePlane<3>& face);

}  // namespace brunt
