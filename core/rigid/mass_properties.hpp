#pragma once
#include <span>

#include "core/points.hpp"
#include "core/surface.hpp"

namespace brunt {

/// Mass, centre and inertia of a homogeneous body, and how large it is. In 2D the centre has z = 0,
/// and the inertia is that about z, in all three places of the diagonal.
struct MassProperties {
  Real mass = 0;                ///< [kg]
  Vec3 center = Vec3::Zero();   ///< [m] of mass; on the axis where the section is axisymmetric
  Mat3 inertia = Mat3::Zero();  ///< [kg m^2] about the centre; axisymmetric: none
  Real volume = 0;              ///< [m^3]
  Real area = 0;                ///< [m^2] of the surface, without the ends of a plane section
};

/// Exact integrals over the polyhedron (polygon in 2D) that closed facets bound, by the divergence
/// theorem: sums of signed tetrahedra (triangles) from a point to each facet; a quad is four
/// triangles about the mean of its corners, as contact takes it. Mirtich 1996 has the moments.
/// facets  of one closed surface, normals outward;  density [kg/m^3];  depth [m] of plane strain;
/// axisymmetric bodies are whole rings. cut  by facet, 1: it lies in a plane of symmetry, and its
/// area is none of the surface; empty: none does. Throws std::invalid_argument where they enclose
/// no volume.
template <int Dim>
MassProperties mass_properties(const Points<Dim>& points, std::span<const Facet<Dim>> facets,
                               Real density, Geometry geometry, Real depth,
                               std::span<const char> cut = {});

/// The centre [m] of a shape of which no density is known: of the volume that its facets enclose;
/// of their area where they are open, or enclose none. On the axis where the section is
/// axisymmetric.
template <int Dim>
Vec<Dim> center_of_shape(const Points<Dim>& points, std::span<const Facet<Dim>> facets,
                         Geometry geometry);

}  // namespace brunt
