#pragma once
/// Bodies as the deck gives them.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/deck/shapes.hpp"
#include "core/geometry/grading.hpp"
#include "core/schema.hpp"
#include "fe/options.hpp"
#include "sph/options.hpp"

namespace brunt::deck {

enum class Method : int { fe, sph };
enum class Lattice : int { cubic, hexagonal };

/// Rotation of a body at a rate; in 2D about z, and the axis is not given.
struct Spin {
  std::vector<Real> axis{0, 0, 1};  ///< unit vector
  Real rate = 0;                    ///< [rad/s]
  std::vector<Real> about;          ///< [m] a point of the axis; empty: the origin
};

/// Rotation at a rate that may depend on time; `rate` is that of time 0.
struct DrivenSpin : Spin {
  std::optional<Varying> driven_rate;  ///< [rad/s] as read
};

/// The prescribed motion of a rigid body.
struct Motion {
  /// [m/s] as read: constants, tables over time or expressions of t; absent: it follows its forces
  std::optional<std::vector<std::optional<Varying>>> driven_velocity;
  std::vector<Real> velocity;  ///< [m/s] at time 0; NaN: this component is free; empty: none
  std::optional<DrivenSpin> spin;
  std::optional<Varying> temperature;  ///< [K] at which it is held, constant or over time
};

/// Cauchy stress of a body at time 0, tension positive.
struct Stress {
  /// [Pa] constants or expressions of x, y, z, SymmetricIndex; none: 0
  std::array<std::optional<Varying>, 6> component;
};

struct Body {
  Method method = Method::fe;
  bool rigid = false;
  std::string material;  ///< name in Deck::materials; empty: none (rigid only)
  Shape shape;           ///< of a body from a file: rotate and translate alone
  std::string file;      ///< of triangles or of a mesh, instead of a shape; from the deck's folder
  std::string part;      ///< named set of a mesh file; empty: all of its elements
  Real scale = 1;        ///< [m] that a unit of length of the file stands for
  std::optional<std::vector<Real>> size;  ///< [m] element size or particle spacing, along each axis
  std::optional<std::vector<int>> cells;  ///< number of cells along each axis; FE only
  std::vector<Grading> grading;           ///< of the elements' sizes, by axis; FE only
  /// [m/s] at time 0, as read: constants, or expressions of x, y, z; none: at rest
  std::optional<std::vector<std::optional<Varying>>> start_velocity;
  std::vector<Real> velocity;    ///< [m/s] its constants; empty: at rest
  std::optional<Spin> spin;      ///< at time 0
  std::optional<Stress> stress;  ///< at time 0; none: none
  /// [K] at time 0: a constant, or an expression of x, y, z; none: ambient
  std::optional<Varying> temperature;
  /// Rigid bodies only; none: held, or free where there is a material.
  std::optional<Motion> motion;
  ElementOptions element;            ///< FE that deforms
  Lattice lattice = Lattice::cubic;  ///< SPH
  SphOptions sph;                    ///< SPH
};

/// The smallest element size or spacing that the body is given [m]; 0 where it has `cells` or none.
Real smallest_size(const Body& body);

/// True where the body is taken from a mesh file; false: from a shape, or from a surface.
bool has_mesh_file(const Body& body);

/// True where the velocity at time 0 depends on the place.
bool has_velocity_field(const Body& body);

/// True where the temperature at time 0 depends on the place.
bool has_temperature_field(const Body& body);

/// Velocity [m/s] at time 0, as prescribed or as given, three components; at rest without. Of a
/// field of the place nothing.
std::array<Real, 3> first_velocity(const Body& body);

/// True for a rigid body of which something follows its forces.
bool follows_forces(const Body& body);

/// True where the motion of a rigid body is not that of time 0 for ever.
bool is_driven_over_time(const Motion& motion);

void describe(Schema& s, Spin& spin);
void describe(Schema& s, DrivenSpin& spin);
void describe(Schema& s, Motion& motion);
void describe(Schema& s, Stress& stress);
void describe(Schema& s, Body& body);

}  // namespace brunt::deck
