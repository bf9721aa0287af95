#pragma once
#include <functional>
#include <vector>

#include "core/geometry/shape.hpp"
#include "core/types.hpp"

namespace brunt {

/// Radius of a body of revolution along its axis, from 0 to length.
struct Profile {
  Real length = 0;                     ///< [m]
  std::vector<Real> breaks;            ///< [m] ends of its smooth parts
  std::function<Real(Real s)> radius;  ///< [m]
  Real largest() const;                ///< [m]
  Real volume() const;                 ///< [m^3] pi int r^2 ds
  Real area() const;                   ///< [m^2] 2 int r ds: its section
};

Profile cylinder_profile(Real radius, Real length);

/// Shank and tangent ogive: the nose is an arc of radius (R^2 + N^2)/(2 R), tangent to the shank.
Profile ogive_profile(const Ogive& ogive);

/// True where x lies inside a simple polygon (crossing number; the rim counts by half-open edges).
bool inside_polygon(const std::vector<Vec<2>>& points, const Vec<2>& x);

/// Throws std::invalid_argument where two sides of a polygon cross.
void require_simple(const std::vector<Vec<2>>& points);

}  // namespace brunt
