#include <algorithm>
#include <cmath>

#include "app/deck/checks.hpp"
#include "core/geometry/wedge.hpp"
#include "fe/elements/catalog.hpp"
#include "sph/pair_precision.hpp"

namespace brunt::deck {

namespace {

/// Lengths [m] of a shape's box along its own axes, as far as its keys say; a surface has one
/// length fewer.
struct Lengths {
  Geometry geometry;
  bool flat() const { return geometry != Geometry::three_d; }

  std::vector<Real> round(Real radius, Real length) const {
    if (geometry == Geometry::plane_strain) return {2 * radius, 2 * radius};
    if (geometry == Geometry::axisymmetric) return {radius, length};
    return {2 * radius, 2 * radius, length};
  }
  std::vector<Real> operator()(const Box& box) const {
    std::vector<Real> lengths;
    for (std::size_t c = 0; c < std::min(box.min.size(), box.max.size()); ++c) {
      lengths.push_back(box.max[c] - box.min[c]);
    }
    return lengths;
  }
  std::vector<Real> operator()(const Cylinder& c) const { return round(c.radius, c.length); }
  std::vector<Real> operator()(const Tube& t) const { return round(t.outer, t.length); }
  std::vector<Real> operator()(const Sphere& s) const { return round(s.radius, 2 * s.radius); }
  std::vector<Real> operator()(const Ogive& o) const { return round(o.radius, o.length); }
  std::vector<Real> operator()(const PolygonShape& polygon) const {
    Real low[2] = {kInfinity, kInfinity}, high[2] = {-kInfinity, -kInfinity};
    for (const auto& point : polygon.points) {
      for (std::size_t c = 0; c < 2; ++c) {
        low[c] = std::min(low[c], point[c]), high[c] = std::max(high[c], point[c]);
      }
    }
    std::vector<Real> lengths{high[0] - low[0], high[1] - low[1]};
    if (!flat()) lengths.push_back(polygon.thickness);
    return lengths;
  }
  std::vector<Real> operator()(const Wedge& wedge) const { return (*this)(polygon_of(wedge)); }
  std::vector<Real> operator()(const Plane& plane) const {
    return std::vector<Real>(flat() ? 1 : 2, plane.extent);
  }
  std::vector<Real> operator()(const BrickWall& wall) const {
    std::vector<Real> lengths;
    for (std::size_t c = 0; c < wall.brick.size() && wall.bricks; ++c) {
      lengths.push_back(wall.brick[c] * (*wall.bricks)[c]);
    }
    return lengths;
  }
};

/// A millimetre typed as a micrometre shall not fill the memory before it is reported: counted from
/// sizes alone. Adds what the body makes to `total`; the first that goes beyond the limit is
/// reported.
void check_count(const Deck& deck, const std::string& path, const Body& body, Real& total,
                 Findings& findings) {
  const std::vector<Real> lengths = std::visit(Lengths{deck.geometry}, body.shape.kind);
  Real count = 1, volume = 1, faces = 0;
  for (std::size_t c = 0; c < lengths.size(); ++c) {
    volume *= lengths[c];
    Real along = 1;
    if (body.cells) along *= (*body.cells)[std::min(c, body.cells->size() - 1)];
    if (body.size)
      along *= std::ceil(lengths[c] / (*body.size)[std::min(c, body.size->size() - 1)]);
    count *= along;
    faces += 2 / along;
  }
  if (body.rigid) count *= std::min(1.0, faces);  // of its surface alone
  if (!body.rigid && body.method == Method::fe && deck.geometry == Geometry::three_d) {
    const auto& kind = formulation_of<3>(body.element.type);
    std::vector<int> corners;
    kind.cut_box(std::array{0, 1, 2, 3, 4, 5, 6, 7}, corners);
    count *= static_cast<Real>(corners.size()) / kind.type().corners;
  }
  // The mean of sizes in geometric progression is (1 - 1/ratio)/ln(ratio) of the largest.
  for (const Grading& grading : body.grading) {
    const Real r = grading.ratio;
    if (body.size && r > 1) count *= std::log(r) / (1 - 1 / r);
  }
  constexpr Real kEnough = 1e5;
  const auto limit = static_cast<Real>(deck.max_cells);
  const Real before = total;
  total += count;
  if (!(total > limit)) return;
  const std::string key = path + (body.cells ? ".cells" : ".size");
  if (before > limit) return findings.also_wrong(key);  // and is not built
  const Real enough = std::pow(volume / kEnough, 1.0 / static_cast<Real>(lengths.size()));
  const std::string about = "makes about " + short_text(count) +
                            (body.method == Method::sph ? " particles" : " elements");
  const std::string remedy = "a size of " + length_text(enough) + " makes a hundred thousand";
  const std::string with = before > 0 ? ", " + short_text(total) + " with the bodies before" : "";
  findings.wrong(key, about + with + ", more than max_cells, " + std::to_string(deck.max_cells) +
                          "; " + remedy + "; where so many are meant, raise max_cells");
}

/// x is the radius and y the axis; a shape about an axis stands on it.
struct AxisymmetricShape {
  const std::string& path;
  Findings& findings;

  void about_axis(const char* shape, const std::vector<Real>& base, const std::vector<Real>& axis) {
    const std::string key = path + ".shape." + shape;
    if (!base.empty() && base[0] != 0) {
      findings.wrong(key + ".base",
                     "stands beside the axis of symmetry, x = 0: write base: [0, y]");
    }
    if (axis.size() >= 2 && axis[0] != 0) {
      findings.wrong(key + ".axis", "the axis of symmetry is y: write axis: y, or leave it out");
    }
  }
  void operator()(const Cylinder& c) { about_axis("cylinder", c.base, c.axis); }
  void operator()(const Tube& t) { about_axis("tube", t.base, t.axis); }
  void operator()(const Ogive& o) { about_axis("ogive", o.base, o.axis); }
  void operator()(const Sphere& s) { about_axis("sphere", {}, {}), center(s.center); }
  template <class Other>
  void operator()(const Other&) {}
  void center(const std::vector<Real>& at) {
    if (at.empty() || at[0] == 0) return;
    findings.wrong(path + ".shape.sphere.center",
                   "lies beside the axis of symmetry, x = 0, and would be a ring: write "
                   "center: [0, y]");
  }
};

void check_axisymmetric(const std::string& path, const Body& body, Findings& findings) {
  if (body.method == Method::sph) {
    findings.wrong(path + ".method",
                   "particles are not axisymmetric: take method: fe, or geometry: 3d or "
                   "plane-strain");
  }
  if (body.spin) {
    findings.wrong(path + ".spin", "axisymmetric bodies do not spin: take it out, or geometry: 3d");
  }
  if (body.motion && body.motion->spin) {
    findings.wrong(path + ".motion.spin",
                   "axisymmetric bodies do not spin: take it out, or geometry: 3d");
  }
  std::visit(AxisymmetricShape{path, findings}, body.shape.kind);
}

void check_rigid(Geometry geometry, const std::string& path, const Body& body, Findings& findings) {
  const auto refuse = [&](const char* key, const std::string& instead) {
    const char* how = body.motion ? "" : "; with a `material` it is free, and starts so";
    findings.wrong(path + "." + key,
                   "a rigid body does not start, it is moved: write " + instead + how);
  };
  if (follows_forces(body) && geometry == Geometry::axisymmetric && !body.velocity.empty() &&
      body.velocity[0] != 0) {
    findings.wrong(path + ".velocity.0", "a rigid ring moves along its axis, y, alone: write 0");
  }
  if (follows_forces(body) && !body.motion) return;  // free altogether
  if (body.spin) refuse("spin", "motion: {spin: {...}}");
  if (!follows_forces(body)) {
    if (!body.velocity.empty()) refuse("velocity", "motion: {velocity: [...]}");
    return;
  }
  for (std::size_t c = 0; c < body.velocity.size(); ++c) {
    if (std::isnan(body.motion->velocity[c]) || body.velocity[c] == 0) continue;
    findings.wrong(path + ".velocity." + std::to_string(c),
                   "motion prescribes this component, and only a free one starts: write 0");
  }
}

/// Elements of a fluid resist no shear.
void check_fluid(const Deck& deck, const std::string& path, const Body& body, Findings& findings) {
  if (body.method != Method::fe) return;
  const auto* material = deck.material_named(body.material);
  if (material == nullptr || !findings.sound("materials." + body.material)) return;
  if (material->shear_modulus() > 0) return;
  const Hourglass& hourglass = body.element.hourglass;
  if (std::holds_alternative<StiffnessHourglass>(hourglass) ||
      std::holds_alternative<AssumedStrainHourglass>(hourglass)) {
    findings.wrong(path + ".element.hourglass", "takes a shear modulus, and '" + body.material +
                                                    "' is a fluid: take it out, or write viscous");
  }
  findings.warn(path + ".material",
                "is a fluid, and its elements resist no shear: they hold where it is pressed, and "
                "turn over where it flows; method: sph flows");
}

void check_element(const Deck& deck, const std::string& path, const Body& body,
                   Findings& findings) {
  check_fluid(deck, path, body, findings);
  const Hourglass& hourglass = body.element.hourglass;
  if (std::holds_alternative<AutomaticHourglass>(hourglass)) return;
  if (integration_of(deck, body) != Integration::one_point) {
    findings.wrong(path + ".element.hourglass",
                   "only one-point elements have hourglass modes: take it out, or write "
                   "integration: one-point");
    return;
  }
  const auto* material = deck.material_named(body.material);
  if (std::holds_alternative<ViscousHourglass>(hourglass) && material != nullptr &&
      findings.sound("materials." + body.material) &&
      std::holds_alternative<NoStrength>(material->strength)) {
    findings.warn(path + ".element.hourglass",
                  "'" + body.material +
                      "' does not yield, and hourglass modes of an elastic body "
                      "grow slowly under viscous control; assumed_strain: 1 is for elastic bodies");
  }
}

/// Elements that are to go by what never happens to their material.
void check_erosion(const Deck& deck, const std::string& path, const Body& body,
                   Findings& findings) {
  const auto& erosion = body.element.erosion;
  const auto* material = deck.material_named(body.material);
  if (erosion && erosion->to == ErodeTo::sph && deck.geometry == Geometry::axisymmetric) {
    findings.wrong(path + ".erode.to",
                   "there are no particles in axisymmetry: write points or "
                   "nothing instead");
  }
  if (!erosion || material == nullptr) return;
  if (!findings.sound("materials." + body.material)) return;
  if (erosion->when.damage && std::holds_alternative<NoDamage>(material->damage)) {
    const bool own = own_constants(material->strength).has_value();
    findings.wrong(path + ".erode.when.damage",
                   "'" + body.material +
                       (own ? "' has a strength whose cracks close again, and no `damage`: write "
                            : "' has no `damage`: add a law of failure to it, or write ") +
                       "strain or step instead");
  }
  if (erosion->when.strain && std::holds_alternative<NoStrength>(material->strength)) {
    findings.wrong(path + ".erode.when.strain", "is a plastic strain, and '" + body.material +
                                                    "' has no `strength`: add one, "
                                                    "or write step or inverted instead");
  }
}

/// Points of an outline that stand in one place make a side without length.
void check_polygon(const std::string& path, const Body& body, Findings& findings) {
  const auto* polygon = std::get_if<PolygonShape>(&body.shape.kind);
  if (!polygon || !body.file.empty()) return;
  const std::string key = path + ".shape.polygon.points";
  const std::size_t n = polygon->points.size();
  std::string repeats;
  for (std::size_t i = 1; i < n; ++i) {
    if (polygon->points[i] != polygon->points[i - 1]) continue;
    repeats += (repeats.empty() ? "point " : ", point ") + std::to_string(i) + " repeats point " +
               std::to_string(i - 1);
  }
  if (n > 1 && polygon->points.back() == polygon->points.front()) {
    repeats += (repeats.empty() ? "point " : ", point ") + std::to_string(n - 1) +
               " repeats point 0 (an outline closes by itself)";
  }
  if (repeats.empty()) return;
  findings.warn(key, repeats + ", counted from 0: each was probably meant once");
}

void check_gravity(const Deck& deck, Findings& findings) {
  if (!deck.gravity || !findings.sound("gravity") || !findings.sound("time")) return;
  for (const Real time : gravity_times(deck.gravity, deck.time.end)) {
    const auto now = gravity_at(deck.gravity, time);
    if (deck.geometry == Geometry::axisymmetric && now[0] != 0) {
      findings.wrong("gravity", "x is the radius: gravity acts along the axis, [0, g]");
      return;
    }
    for (std::size_t c = 0; c < now.size(); ++c) {
      if (std::isfinite(now[c])) continue;
      findings.wrong("gravity." + std::to_string(c),
                     (std::isnan(now[c]) ? "is not a number at t = " : "is infinite at t = ") +
                         time_text(time) + "; t is in s");
      return;
    }
  }
}

/// Lengths of all particles in single precision are in one unit.
void check_pair_precision(const Deck& deck, Findings& findings) {
  const Named<Body>*coarsest = nullptr, *finest = nullptr;
  for (const auto& body : deck.bodies) {
    const bool single = body.value.sph.pair_precision == PairPrecision::single_precision;
    if (body.value.method != Method::sph || !single || !findings.sound("bodies." + body.name))
      continue;
    const Real size = smallest_size(body.value);
    if (size == 0) continue;
    if (coarsest == nullptr || size > smallest_size(coarsest->value)) coarsest = &body;
    if (finest == nullptr || size < smallest_size(finest->value)) finest = &body;
  }
  if (coarsest == nullptr) return;
  const Real ratio = smallest_size(coarsest->value) / smallest_size(finest->value);
  if (ratio <= SinglePairs::kMostSpacings) return;
  findings.wrong("bodies." + coarsest->name + ".pair_precision",
                 "single takes lengths in the unit of the least spacing, that of '" + finest->name +
                     "': " + short_text(ratio) + " times as long is too much, " +
                     short_text(SinglePairs::kMostSpacings) +
                     " at most; take double for one of the two");
}

}  // namespace

void check_bodies(const Deck& deck, Findings& findings) {
  Real cells = 0;
  for (const auto& [name, body] : deck.bodies) {
    const std::string path = "bodies." + name;
    if (!findings.sound(path)) continue;
    if (deck.geometry == Geometry::axisymmetric) check_axisymmetric(path, body, findings);
    if (body.rigid) {
      check_rigid(deck.geometry, path, body, findings);
    } else {
      check_element(deck, path, body, findings);
      check_erosion(deck, path, body, findings);
    }
    check_count(deck, path, body, cells, findings);
    check_polygon(path, body, findings);
  }
  check_pair_precision(deck, findings);
  check_gravity(deck, findings);
  if (deck.geometry == Geometry::axisymmetric && deck.depth != 1) {
    findings.warn("depth", "is not used: axisymmetric forces and energies are for the whole turn");
  }
  if (!findings.sound("bodies") || !findings.stands("bodies")) return;
  if (deck.bodies.empty()) {
    findings.wrong("bodies", "there is no body: add one, with `shape`, `material` and `size`");
  }
}

}  // namespace brunt::deck
