#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "contact/geometry/face_barrier.hpp"
#include "contact/geometry/face_plane.hpp"
#include "contact/geometry/polygon.hpp"

namespace brunt {

/// What a length in the plane of a 2D deck stands for: a strip of depth, or a ring of 2 pi r.
struct Section {
  Geometry geometry = Geometry::three_d;
  Real depth = 1;  ///< [m] plane strain

  /// Extent out of the plane at coordinate r [m]; 1 in 3D.
  Real breadth(Real r) const {
    if (geometry == Geometry::axisymmetric) return 2 * kPi * r;
    return geometry == Geometry::plane_strain ? depth : 1.0;
  }
  /// The same of a particle of radius a [m], a ring from r - a to r + a that ends at the axis, so
  /// that its area is 2 a breadth (docs/theory/contact.md, C57). Gone through the axis by r it is
  /// the ring at r.
  Real breadth_of_particle(Real r, Real a) const {
    if (geometry != Geometry::axisymmetric) return breadth(r);
    const Real out = std::fabs(r);
    return out < a ? kPi * (out + a) * (out + a) / (2 * a) : breadth(out);
  }
};

/// Cosines of the angle between two faces from which their pressure fades in, up to the whole of
/// it. Sides of boxes that lie flat on each other must be without force, and a point has no side
/// that opposes a floor better than sin(a/2), a its angle: so that, of the sharper body, is the
/// scale. Blades that cross oppose each other by the product of both; where the blunter has less
/// than 0.13 to 0.24 their edges carry them (contact/geometry/edge_contact.hpp).
template <int Dim>
struct FacingRamp {
  Real none, whole;

  FacingRamp(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper)
      : none(0.18 * kBoxSharpness * std::min(lower.sharpness, upper.sharpness)),
        whole(0.34 * kBoxSharpness * std::min(lower.sharpness, upper.sharpness)) {}
  /// Smooth at both ends: corners that dig in turn faces to and fro across them, and a force that
  /// jumps there makes energy.
  Real at(Real facing) const {
    const Real s = part(facing);
    return s * s * (3 - 2 * s);
  }
  /// Derivative of ln at(facing).
  Real growth(Real facing) const {
    const Real s = part(facing);
    return s < 1 ? 6 * (1 - s) / (s * (3 - 2 * s) * (whole - none)) : 0.0;
  }
  Real part(Real facing) const { return std::min((facing - none) / (whole - none), 1.0); }
};

/// One common plane between two faces (Vorobiev, simple common plane; docs/theory/contact.md (C4)
/// to (C8)). The pressure of a spring of k [Pa/m], and of its barrier where faces are deep, has the
/// resultant k volume along normal on the upper face, through `point`; weights share it among the
/// corners, each set sums to one.
template <int Dim>
struct CommonPlane {
  static constexpr int kCorners = Facet<Dim>::kNodes;
  Vec<Dim> normal;       ///< unit, from the lower to the upper face
  Vec<Dim> point;        ///< [m] centre of pressure, on the common plane
  Real facing = 0;       ///< cosine of the angle between the faces, 1 where they are parallel
  Real ramp = 0;         ///< 0 .. 1: fades where the faces stop opposing each other
  Real ramp_growth = 0;  ///< derivative of ln ramp by `facing`
  Real fade = 1;    ///< its part that fades between borders (contact/geometry/overlap_push.hpp)
  Real area = 0;    ///< [m^2] under pressure
  Real volume = 0;  ///< [m^3] integral of the penetration and barrier, times ramp
  /// What the spring holds, per k: ramp int (G^2/2 + barrier) dA [m^4], G = cos(th/2) g: along the
  /// plane's normal g grows by 1, but a corner that goes into a face goes along that face's normal,
  /// half the angle away (test 8: k d^3/(6 sin)).
  Real energy = 0;
  Real energy_by_fade = 0;    ///< [m^4] by ln fade: the barrier fades as its cube
  Real energy_by_facing = 0;  ///< [m^4] by `facing`, of what fades in with it
  Real penetration = 0;       ///< [m] at `point`
  Real deepest = 0;           ///< [m] largest penetration
  Real layered = 0;           ///< [m] mean penetration, where a soft layer lies over the spring
  Real mean_slope = 1;        ///< of the pressure, over k: its mean over the area; 1: no barrier
  std::uint32_t ordinal = 0;  ///< which parts of the faces: 4 i + j of split ones
  std::array<Real, kCorners> lower_weight{}, upper_weight{};
  /// The centre of the area under pressure with its weights, where asked for: friction acts there,
  /// since a place that followed the pressure would couple normal motion to friction, one way only.
  Vec<Dim> middle;  ///< [m]
  std::array<Real, kCorners> lower_at_middle{}, upper_at_middle{};
  /// What corners get beside k volume along normal, per k, where a share of the force follows the
  /// potential of the overlap (contact/geometry/overlap_push.hpp).
  Real share = 0;
  std::array<Vec<Dim>, kCorners> lower_push, upper_push;  ///< [m^3]
  FaceBarrier barrier;
  Polygon polygon;  ///< 3D: the area under pressure, about origin, along axis_1 and axis_2
  Vec<Dim> origin;  ///< [m]
  Vec<Dim> axis_1, axis_2;

  /// cos(th/2) of the angle th between the faces: G over g.
  Real half_cosine() const { return std::sqrt(0.5 * (1 + facing)); }
};

/// Cosine of faces that may come to oppose each other within a step.
inline constexpr Real kMayTurn = -0.5;

/// What is asked of common planes beside their pressure.
struct PlaneNeeds {
  bool middle = false;  ///< the centres of their areas
  Real opening = 0;  ///< [m] faces that are nearer than this count as touching, as far as they are
  /// The overlap of both faces as a whole, pressed or not: volume and penetration may be negative,
  /// and the force acts at the middle. A bond needs it.
  bool whole = false;
  /// They push: pressure fades between borders, and follows its potential (overlap_push.hpp). Else
  /// they are where the faces lie over each other, which is what heat needs.
  bool pushes = true;
  FaceBarrier barrier = {};
  Real limit = kInfinity;  ///< [m] depth at which they let go
  /// Their pressure is that at the middle of their overlap: as of the whole, where it penetrates.
  bool at_point = false;
  /// As if they opposed each other enough to push with the whole of their pressure: what they would
  /// hold once they have turned so.
  bool turned = false;
};

/// Up to four times four where both faces are split; edges in the plane are not.
template <int Dim>
using Planes = std::array<CommonPlane<Dim>, Dim == 3 ? 16 : 1>;

/// True where a face counts as four triangles beside a mate. Beside one that keeps its plane it
/// does so from nearly no warp on: else its corners may be deep in the mate while its plane hardly
/// touches it, and push all at once where it is split, again and again where it trembles there.
inline bool is_split(const FacePlane<3>& face, const FacePlane<3>& mate) {
  constexpr Real kBlunt = 0.99 * kBoxSharpness;  // edges and points dig into one plane, not in four
  return !face.simple || (mate.rigid && mate.sharpness > kBlunt && !face.rigid && !face.flat);
}

/// The planes between two faces, lower first by id: one, or more where warped or concave quads are
/// split. Returns how many of them carry pressure; `plane` holds these in fixed order.
template <int Dim>
int common_planes(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Section& section,
                  Planes<Dim>& plane, const PlaneNeeds& needs = {});
/// That of two edges in 2D; false if it carries no pressure.
bool common_line(const FacePlane<2>& lower, const FacePlane<2>& upper, const Section& section,
                 const PlaneNeeds& needs, CommonPlane<2>& plane);

}  // namespace brunt
