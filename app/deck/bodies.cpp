#include "app/deck/bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/boundaries/function.hpp"
#include "io/mesh/catalog.hpp"

namespace brunt::deck {

namespace {
constexpr Quantity kVelocity{"m/s", {}, between(-1e5, 1e5)};
constexpr Quantity kStress{"Pa", {}, between(-1e11, 1e11)};
constexpr Quantity kPlace{"m", {}, between(-1e4, 1e4)};

void describe_finite_elements(Schema& s, Body& body) {
  s.integers({"cells", "number of cells along each axis of the shape, instead of size"}, body.cells,
             Schema::kVector, between(1, 1'000'000));
  s.one_or_more({"grading",
                 "element sizes in geometric progression along an axis, finer toward an end; size "
                 "is the largest of them. Round shapes are finer towards a point of their rim, "
                 "with elements that keep their shapes"},
                body.grading);
  s.require(std::none_of(body.grading.begin(), body.grading.end(),
                         [&](const Grading& one) {
                           return std::count_if(body.grading.begin(), body.grading.end(),
                                                [&](const Grading& other) {
                                                  return other.axis == one.axis;
                                                }) > 1;
                         }),
            "grading", "names an axis twice");
  s.section(!body.rigid, "only for bodies that deform", [&](Schema& deforming) {
    deforming.object({"element", "options of the elements"}, body.element);
    deforming.object({"erode", "when elements go that have failed; without it they stay"},
                     body.element.erosion);
  });
}

void describe_particles(Schema& s, Body& body) {
  static constexpr const char* kLattices[] = {"cubic", "hexagonal"};
  s.choice({"lattice", "how particles fill the shape"}, body.lattice, kLattices);
  describe(s, body.sph);
}
}  // namespace

Real smallest_size(const Body& body) {
  if (!body.size || body.size->empty()) return 0;
  Real ratio = 1;
  for (const Grading& grading : body.grading) ratio = std::max(ratio, grading.ratio);
  return *std::min_element(body.size->begin(), body.size->end()) / ratio;
}

std::array<Real, 3> first_velocity(const Body& body) {
  const bool prescribed = body.rigid && body.motion && !body.motion->velocity.empty();
  const auto& given = prescribed ? body.motion->velocity : body.velocity;
  std::array<Real, 3> velocity{};
  const std::size_t n = std::min(given.size(), velocity.size());  // of a wrong deck it may be more
  for (std::size_t c = 0; c < n; ++c) velocity[c] = std::isnan(given[c]) ? 0 : given[c];
  return velocity;
}

bool has_mesh_file(const Body& body) { return mesh_reader(body.file) != nullptr; }

bool has_velocity_field(const Body& body) {
  const auto& given = body.start_velocity;
  return given && std::any_of(given->begin(), given->end(),
                              [](const auto& v) { return v && v->is_expression(); });
}

bool has_temperature_field(const Body& body) {
  return body.temperature && body.temperature->is_expression();
}

bool follows_forces(const Body& body) {
  if (!body.rigid) return false;
  if (!body.motion) return !body.material.empty();
  return std::any_of(body.motion->velocity.begin(), body.motion->velocity.end(),
                     [](Real component) { return std::isnan(component); });
}

namespace {
constexpr Quantity kSpinRate{"rad/s", {}, between(-1e7, 1e7)};

void describe_axis(Schema& s, Spin& spin) {
  s.section(s.geometry() == Geometry::three_d, "only for geometry: 3d", [&](Schema& in3d) {
    in3d.direction({"axis", "axis of the spin", Need::required}, spin.axis);
  });
  s.list({"about", "a point of the axis; default: the origin"}, spin.about, kPlace,
         Schema::kVector);
}

/// Of a body that moves as a whole the place says nothing.
bool depends_on_place(const std::optional<Varying>& value) {
  return value && value->is_expression() &&
         (value->depends[1] || value->depends[2] || value->depends[3]);
}

/// What a value over time is at time 0; 0 where it could not be read.
Real at_start(const Varying& value) {
  const bool unread = value.is_expression() && !value.evaluate;
  return unread ? 0.0 : function_of(value)(0, Vec3::Zero());
}
}  // namespace

bool is_driven_over_time(const Motion& motion) {
  const auto varies = [](const std::optional<Varying>& value) {
    return value && !value->is_constant();
  };
  const auto& velocity = motion.driven_velocity;
  return (motion.spin && varies(motion.spin->driven_rate)) ||
         (velocity && std::any_of(velocity->begin(), velocity->end(), varies));
}

void describe(Schema& s, Spin& spin) {
  describe_axis(s, spin);
  s.real({"rate", "rate by the right-hand rule", Need::required}, spin.rate, kSpinRate);
}

void describe(Schema& s, DrivenSpin& spin) {
  describe_axis(s, spin);
  auto& rate = spin.driven_rate;
  s.varying({"rate", "rate by the right-hand rule", Need::required}, rate, kSpinRate, kTimeOrPlace);
  s.require(!depends_on_place(rate), "rate", "is one for the whole body: of t alone");
  if (rate) spin.rate = at_start(*rate);
}

void describe(Schema& s, Motion& motion) {
  static constexpr std::array kOver{Varying::Over::time};
  auto& velocity = motion.driven_velocity;
  s.components({"velocity", "velocity; a component that is free follows its forces"}, velocity,
               kVelocity, kTimeOrPlace);
  s.require(!velocity || std::none_of(velocity->begin(), velocity->end(), depends_on_place),
            "velocity", "is one for the whole body: of t alone");
  motion.velocity.clear();
  for (std::size_t c = 0; velocity && c < velocity->size(); ++c) {
    const auto& component = (*velocity)[c];
    motion.velocity.push_back(component ? at_start(*component)
                                        : std::numeric_limits<Real>::quiet_NaN());
  }
  s.object({"spin", "rotation; without it the body does not turn"}, motion.spin);
  s.varying({"temperature", "it is held at it, or its surface where it has no material"},
            motion.temperature, {"K", at_least(0), between(50, 5000)}, kOver);
  s.require(!motion.velocity.empty() || motion.spin || motion.temperature, "",
            "needs a velocity, a spin or a temperature");
}

void describe(Schema& s, Stress& stress) {
  static constexpr std::array kOver{Varying::Over::expression};
  const auto describe_component = [&](Schema& at, const Key& key, SymmetricIndex index) {
    auto& value = stress.component[slot_of(index)];
    at.varying(key, value, kStress, kOver);
    at.require(!value || !value->is_expression() || !value->depends[0], key.name,
               "is that at time 0: t has no place in it");
  };
  describe_component(s, {"xx", "along x; in axisymmetry the radial stress"}, xx);
  describe_component(s, {"yy", "along y; in axisymmetry the axial stress"}, yy);
  describe_component(s, {"zz", "along z: out of the plane; in axisymmetry the hoop stress"}, zz);
  describe_component(s, {"xy", "shear stress"}, xy);
  s.section(s.geometry() == Geometry::three_d, "only for geometry: 3d", [&](Schema& in3d) {
    describe_component(in3d, {"yz", "shear stress"}, yz);
    describe_component(in3d, {"zx", "shear stress"}, zx);
  });
  s.require(std::any_of(stress.component.begin(), stress.component.end(),
                        [](const auto& component) { return component.has_value(); }),
            "", "needs a component: xx, yy, zz, xy, yz or zx");
}

namespace {
/// Keys beside `file` that contradict it.
void require_consistent_file(Schema& s, const Body& body) {
  const bool is_sph = body.method == Method::sph, is_mesh = has_mesh_file(body);
  const bool is_stl = body.file.size() > 4 && body.file.substr(body.file.size() - 4) == ".stl";
  s.require(body.file.empty() || is_stl || is_mesh, "file",
            "is read as .stl, triangles of a surface, or as a mesh: " + mesh_formats());
  s.require(!is_stl || body.rigid || is_sph, "file",
            "triangles are the surface of a body with rigid: true, or what particles fill with "
            "method: sph; elements need a shape or a mesh");
  s.require(!is_stl || s.geometry() == Geometry::three_d, "file", "only for geometry: 3d");
  s.require(body.part.empty() || is_mesh, "part", "is a set of a mesh file; this is none");
  s.require(!is_mesh || is_sph || (!body.size && !body.cells), body.size ? "size" : "cells",
            "the elements are those of the file: take it out");
  s.require(!is_mesh || body.grading.empty(), "grading",
            "the elements are those of the file: take it out");
}

void describe_velocity(Schema& s, Body& body) {
  static constexpr std::array kOver{Varying::Over::expression};
  auto& given = body.start_velocity;
  s.components({"velocity", "velocity at time 0; components may be expressions of x, y, z"}, given,
               kVelocity, kOver);
  if (!given) return;
  body.velocity.clear();
  for (const auto& v : *given) {
    body.velocity.push_back(v && v->is_constant() ? v->constant : Real{0});
  }
}

void describe_temperature(Schema& s, Body& body) {
  static constexpr std::array kOver{Varying::Over::expression};
  s.varying(
      {"temperature", "temperature at time 0, or an expression of x, y, z, in K; default: ambient"},
      body.temperature, {"K", at_least(0), between(50, 5000)}, kOver);
}

bool depends_on_time(const std::optional<Varying>& value) {
  return value && value->is_expression() && value->depends[0];
}

/// What is true of values at time 0.
void require_consistent_start(Schema& s, const Body& body) {
  if (const auto& velocity = body.start_velocity) {
    const auto any = [&](const auto& is) {
      return std::any_of(velocity->begin(), velocity->end(), is);
    };
    s.require(
        !any([](const auto& v) { return !v.has_value(); }), "velocity",
        "a component at time 0 cannot be free: write 0, or take it into motion or a boundary");
    s.require(!any(depends_on_time), "velocity", "is that at time 0: t has no place in it");
    s.require(!body.rigid || !has_velocity_field(body), "velocity",
              "of a rigid body is one vector, and `spin` besides");
  }
  s.require(!depends_on_time(body.temperature), "temperature",
            "is that at time 0: t has no place in it");
}

/// Keys of a body that contradict each other.
void require_consistent(Schema& s, const Body& body) {
  const bool is_sph = body.method == Method::sph;
  require_consistent_file(s, body);
  require_consistent_start(s, body);
  s.require(!body.rigid || !body.stress, "stress",
            "a rigid body has none: take it out, or take rigid: true out");
  s.require(!body.rigid || !is_sph, "rigid",
            "a rigid body of particles is not in this version; take method: sph out");
  s.require(!follows_forces(body) || !body.material.empty(), "motion",
            "a component that is free follows its forces, and that takes a mass: name a material");
  s.require(!follows_forces(body) || !std::holds_alternative<Plane>(body.shape.kind), "shape",
            "a plane has no volume and no mass to move by: take the material out, and it is held");
  s.require(body.rigid || is_sph || has_mesh_file(body) ||
                body.size.has_value() != body.cells.has_value(),
            body.cells ? "cells" : "",
            body.cells ? "stands beside size: keep one of them"
                       : "needs size, the length of an element, or cells, their numbers");
  s.require(body.rigid || !std::holds_alternative<Plane>(body.shape.kind), "shape",
            "a plane is rigid: true");
  s.require(!is_sph || !body.size ||
                std::all_of(body.size->begin(), body.size->end(),
                            [&](Real size) { return size == body.size->front(); }),
            "size", "particles have one spacing along all axes");
}
}  // namespace

void describe(Schema& s, Body& body) {
  static constexpr const char* kMethods[] = {"fe", "sph"};
  s.choice({"method", "finite elements or particles"}, body.method, kMethods);
  s.flag({"rigid", "does not deform"}, body.rigid);
  const bool is_sph = body.method == Method::sph;
  s.text({"material", "name of a material", body.rigid ? Need::optional : Need::required},
         body.material);
  s.text({"file",
          "an STL file of triangles or a mesh file, from the deck's folder, instead of a shape"},
         body.file);
  s.section(body.file.empty(), "only without file", [&](Schema& shaped) {
    shaped.object({"shape", "where the body is at time 0", Need::required}, body.shape);
  });
  s.section(!body.file.empty(), "only beside file", [&](Schema& read) {
    read.real({"scale", "length that a unit of the file stands for"}, body.scale,
              {"m", positive(), between(1e-6, 1e3)});
    read.text({"part", "named set of a mesh file; default: all of its elements"}, body.part);
    read.object({"rotate", "turns what the file holds"}, body.shape.rotate);
    read.list({"translate", "moves it, after it was turned"}, body.shape.translate, kPlace,
              Schema::kVector);
  });
  s.per_axis({"size", "element size or particle spacing; the next whole number of cells",
              is_sph ? Need::required : Need::optional},
             body.size, {"m", positive(), between(1e-7, 0.2)});
  describe_velocity(s, body);
  s.object({"spin", "rotation at time 0"}, body.spin);
  s.object({"stress",
            "stress at time 0, tension positive; components may be expressions of x, y, z, and are "
            "0 without"},
           body.stress);
  describe_temperature(s, body);
  s.section(body.rigid, "only for rigid: true", [&](Schema& rigid) {
    rigid.object(
        {"motion",
         "the prescribed motion of a rigid body; without it is free where it has a material, "
         "and held where it has none"},
        body.motion);
  });
  s.section(!is_sph, "only for method: fe",
            [&](Schema& fe) { describe_finite_elements(fe, body); });
  s.section(is_sph, "only for method: sph", [&](Schema& sph) { describe_particles(sph, body); });
  require_consistent(s, body);
}

}  // namespace brunt::deck
