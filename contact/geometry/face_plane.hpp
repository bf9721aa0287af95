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
  Real area_start = 0;                 ///< [m^2] at time 0; 0: unknown
  Real split = 0;  ///< how far it is two triangles instead of one plane, 0 .. 1; 2D: 0
};

/// A quad passes from one plane to two triangles as its corners leave their mean plane, by these
/// parts of the root of its area now or at time 0, the smaller: faces that grow keep their depth
/// and their spring, and a corner that dips in by a part of what they have grown to would be far in
/// the barrier once they are split.
inline constexpr Real kWarpNone = 0.03, kWarpWhole = 0.09;

/// Fills all but `corner`, `n_corners`, `borders`, `sharpness` and `area_start`. A face without
/// area or with a NaN gets area 0.
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

/// Derivative of face.split by the corners of a quad [1/m], where it is within 0 .. 1; the warp and
/// the corners that turn least decide.
std::array<Vec3, 4> split_gradient(const FacePlane<3>& face);

/// Adds what a function of a face's normal has as gradient by its corners.
/// d  derivative by the normal
void add_turn(const FacePlane<3>& face, const Vec3& d, std::array<Vec3, 4>& gradient);
void add_turn(const FacePlane<2>& face, const Vec<2>& d, std::array<Vec<2>, 2>& gradient);

}  // namespace brunt
