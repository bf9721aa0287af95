#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "contact/geometry/face_plane.hpp"
#include "contact/geometry/soft_layer.hpp"

namespace brunt {

/// What of a face is nearest to a particle. Ordered: a face wins over an edge over a vertex.
enum class Feature : std::uint8_t { face, edge, vertex };

/// The point of a face that is nearest to a particle.
template <int Dim>
struct NearestPoint {
  NearestPoint() {}  // NOLINT(modernize-use-equals-default): else all bytes are set to 0 first
  static constexpr int kCorners = Facet<Dim>::kNodes;
  Vec<Dim> point;                       ///< [m]
  Real distance = kInfinity;            ///< [m] to the particle, >= 0
  std::array<Real, kCorners> weight{};  ///< of the face's corners, >= 0, sum 1
  Feature feature = Feature::face;      ///< an edge or vertex of the whole face, or inside it
  std::array<int, 2> corner{};          ///< the edge's two corners, or the vertex twice
  Vec<Dim> normal;                      ///< unit, of the flat part that holds the point
  bool smooth = true;                   ///< the point lies inside a flat part, not on a crease
};

/// Nearest point of a face; a quad is four triangles about its centre, whose weight goes to the
/// corners by a quarter each.
template <int Dim>
NearestPoint<Dim> nearest_point(const FacePlane<Dim>& face, const Vec<Dim>& x);

/// A particle at x beside a face.
template <int Dim>
struct NearQuery {
  const FacePlane<Dim>* face;
  Vec<Dim> x;  ///< [m]
};

/// The same of many at once, in less time. nearest  out, of room for all
template <int Dim>
void nearest_points(std::span<const NearQuery<Dim>> of, NearestPoint<Dim>* nearest);

/// A face within reach of a particle, and what choose_hits makes of it.
template <int Dim>
struct ParticleHit {
  static constexpr int kCorners = Facet<Dim>::kNodes;
  ParticleHit() {}  // NOLINT(modernize-use-equals-default)
  ParticleHit(const FacePlane<Dim>& of_plane, const NearestPoint<Dim>& of_particle,
              const std::array<LocalIndex, kCorners>& nodes, Label of_body, Label of_piece,
              bool is_open, LocalIndex of_face)
      : plane(&of_plane),
        node(nodes),
        body(of_body),
        piece(of_piece),
        face(of_face),
        open(is_open),
        nearest(of_particle) {}
  /// Of a particle at x, its nearest point where it stands: it is not copied.
  ParticleHit(const FacePlane<Dim>& of_plane, const Vec<Dim>& x)
      : plane(&of_plane), nearest(nearest_point<Dim>(of_plane, x)) {}
  const FacePlane<Dim>* plane = nullptr;
  std::array<LocalIndex, kCorners> node{};  ///< names of the corners: faces that share them touch
  Label body = 0;
  Label piece = 0;
  Real limit = 0;       ///< [m] how far behind the face the particle is still held
  LocalIndex face = 0;  ///< the caller's
  bool open = false;    ///< the surface has a rim, and two sides
  /// Of an open surface: 1 before it, -1 behind it, where the particle belongs; 0: not known yet,
  /// or the particle is beside the rim. Given as it was, it goes out as it is.
  int side = 0;
  /// Where the particle last touched a thin plate: 1 on the side of this face, -1 on the other; 0:
  /// on neither.
  int entry = 0;
  NearestPoint<Dim> nearest;
  bool inside = false;   ///< the particle's centre lies behind the surface, or on its other side
  bool kept = true;      ///< one of the contacts of this particle, or it just touches
  bool pushes = true;    ///< it overlaps by more than what is left from time 0
  bool returns = false;  ///< no face held it before: the caller's
  Vec<Dim> direction;    ///< unit, of the force on the particle
  Real overlap = 0;      ///< [m] radius minus signed distance
  Real share = 1;        ///< of its spring, where several push the same way; 0: just touches
  Real damping = 0;      ///< [N s/m] of a share of 1; the caller's
};

/// Makes of the faces near a particle at x its contacts (docs/theory/contact.md (C19)): an edge or
/// vertex that several faces share counts once and only where it is nearest for all of them; the
/// side is that of the normals about the feature, each by its angle (Baerentzen & Aanaes 2005); a
/// centre behind the surface is held by the nearest face of its body alone. Faces of a concave edge
/// both push; those that push the same way, as two bricks side by side do, share: share_i = d_i /
/// sum_j d_j max(0, n_i . n_j), which is 1 alone or at right angles. A gap of a millionth of a
/// diameter counts as touching, for heat: it has no share. In a thin plate that gives way a centre
/// belongs to the side on which it was when it last touched. An open surface is touched from both
/// sides: a particle belongs to the one from which it came. hits  in order of face id; `plane`,
/// `node`, `body`, `piece`, `limit`, `nearest`, of open
///       surfaces `open` and `side`, of thin plates `entry` given.
template <int Dim>
void choose_hits(const Vec<Dim>& x, Real radius, std::vector<ParticleHit<Dim>>& hits);

/// At the axis of an axisymmetric scene, x = 0, no surface ends: a face that comes to it goes on
/// behind it, so that its end there is no vertex, and one that lies on it (the side of a rigid box)
/// is no surface. Before choose_hits. radius  [m] of the particle
template <int Dim>
void join_at_axis(Real radius, std::vector<ParticleHit<Dim>>& hits);

/// The spring of a particle, a function of its overlap d: k d, and b (d - r)^3 / r^2 more where the
/// centre is behind the surface, so that it turns back before a thin face lets it through. In a
/// soft layer s k d, beyond it s k d + (1 - s) k (d - d_s).
struct ParticleSpring {
  Real linear = 0;   ///< [N/m] k
  Real barrier = 0;  ///< [N/m] b
  Real radius = 0;   ///< [m] r
  SoftLayer layer{};
  /// What the whole spring has and the softer one lacks, of a force and of an energy, per k.
  Real lacking(Real d) const { return (1 - layer.softness) * std::min(d, layer.depth); }
  Real lacking_energy(Real d) const {
    const Real in = std::min(d, layer.depth);
    return (1 - layer.softness) * in * (d - 0.5 * in);
  }
  /// Most are in front, which spares divisions.
  Real force(Real d) const {
    const Real of_spring = linear * (d - lacking(d));
    if (!(d > radius)) return of_spring;
    const Real deep = d - radius;
    return of_spring + barrier * deep * (deep / radius) * (deep / radius);
  }
  Real energy(Real d) const {
    const Real of_spring = linear * (0.5 * d * d - lacking_energy(d));
    if (!(d > radius)) return of_spring;
    const Real deep = d - radius;
    return of_spring + 0.25 * barrier * (deep * deep) * (deep / radius) * (deep / radius);
  }
  Real tangent(Real d) const {
    if (!(d > radius)) return linear;
    const Real deep = d - radius;
    return linear + 3 * barrier * (deep / radius) * (deep / radius);
  }
};
/// b over the particle's own spring: a particle at five times the speed of sound comes to rest with
/// its centre less than 2.3 radii behind a rigid face (energy 25/2 m c^2 = b z^4 / (4 r^2)).
inline constexpr Real kBarrier = 16;
/// A gap of this part of a diameter still passes heat: rounding opens what just touches.
inline constexpr Real kTouchingGap = 1e-6;
/// Radii behind a face at which a particle is given up.
inline constexpr Real kDepthRadii = 3;
/// The same of open surfaces, which nothing else guards: at twenty times the speed of sound, 16
/// times the energy, a particle comes to rest 4.6 radii behind.
inline constexpr Real kOpenDepthRadii = 6;

}  // namespace brunt
