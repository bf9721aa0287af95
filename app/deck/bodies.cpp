#include "app/deck/bodies.hpp"

#include <algorithm>
#include <array>

namespace brunt::deck {

namespace {
constexpr Quantity kVelocity{"m/s", {}, between(-1e5, 1e5)};
constexpr Quantity kPlace{"m", {}, between(-1e4, 1e4)};

void describe_finite_elements(Schema& s, Body& body) {
  s.integers({"cells", "number of cells along each axis of the shape, instead of size"}, body.cells,
             Schema::kVector, between(1, 1'000'000));
  s.section(!body.rigid, "only for bodies that deform", [&](Schema& deforming) {
    deforming.object({"element", "options of the elements"}, body.element);
  });
}

void describe_particles(Schema& s, Body& body) {
  static constexpr const char* kLattices[] = {"cubic", "hexagonal"};
  s.choice({"lattice", "how particles fill the shape"}, body.lattice, kLattices);
  describe(s, body.sph);
}
}  // namespace

void describe(Schema& s, Spin& spin) {
  s.section(s.geometry() == Geometry::three_d, "only for geometry: 3d", [&](Schema& in3d) {
    in3d.direction({"axis", "axis of the spin", Need::required}, spin.axis);
  });
  s.real({"rate", "rate by the right-hand rule", Need::required}, spin.rate,
         {"rad/s", {}, between(-1e7, 1e7)});
  s.list({"about", "a point of the axis; default: the origin"}, spin.about, kPlace,
         Schema::kVector);
}

void describe(Schema& s, Motion& motion) {
  static constexpr std::array kOver{Varying::Over::time};
  s.list({"velocity", "velocity, kept for ever"}, motion.velocity, kVelocity, Schema::kVector);
  s.object({"spin", "rotation, kept for ever"}, motion.spin);
  s.varying({"temperature", "it is held at it, or its surface where it has no material"},
            motion.temperature, {"K", at_least(0), between(50, 5000)}, kOver);
  s.require(!motion.velocity.empty() || motion.spin || motion.temperature, "",
            "needs a velocity, a spin or a temperature");
}

void describe(Schema& s, Body& body) {
  static constexpr const char* kMethods[] = {"fe", "sph"};
  static constexpr const char* kLater[] = {"file", "scale", "grading", "erode"};
  s.choice({"method", "finite elements or particles"}, body.method, kMethods);
  s.flag({"rigid", "does not deform"}, body.rigid);
  const bool is_sph = body.method == Method::sph;
  s.text({"material", "name of a material", body.rigid ? Need::optional : Need::required},
         body.material);
  s.object({"shape", "where the body is at time 0", Need::required}, body.shape);
  s.per_axis({"size", "element size or particle spacing; the next whole number of cells",
              is_sph ? Need::required : Need::optional},
             body.size, {"m", positive(), between(1e-7, 0.2)});
  s.list({"velocity", "velocity at time 0"}, body.velocity, kVelocity, Schema::kVector);
  s.object({"spin", "rotation at time 0"}, body.spin);
  s.real({"temperature", "temperature at time 0; default: ambient"}, body.temperature,
         {"K", at_least(0), between(50, 5000)});
  s.section(body.rigid, "only for rigid: true", [&](Schema& rigid) {
    rigid.object({"motion", "what a rigid body is told to do; without it is held"}, body.motion);
  });
  s.section(!is_sph, "only for method: fe",
            [&](Schema& fe) { describe_finite_elements(fe, body); });
  s.section(is_sph, "only for method: sph", [&](Schema& sph) { describe_particles(sph, body); });
  s.later(kLater);
  s.require(!body.rigid || !is_sph, "rigid",
            "a rigid body of particles is not in this version; take method: sph out");
  s.require(!body.rigid || body.material.empty() || body.motion, "material",
            "a rigid body that moves freely is not in this version: without motion and material "
            "it is held, with motion it moves as told");
  s.require(body.rigid || is_sph || body.size.has_value() != body.cells.has_value(),
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

}  // namespace brunt::deck
