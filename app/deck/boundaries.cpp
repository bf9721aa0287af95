#include "app/deck/boundaries.hpp"

#include <array>

namespace brunt::deck {

namespace {
constexpr std::array kOverTime{Varying::Over::time, Varying::Over::expression};
}  // namespace

void describe(Schema&, WhereAll&) {}
void describe(Schema&, WhereSurface&) {}

void describe(Schema& s, WherePlane& where) {
  s.choice({"axis", "axis that the plane cuts", Need::required}, where.axis, s.axes());
  s.real({"at", "where it cuts the axis", Need::required}, where.at, {"m"});
}

void describe(Schema& s, WhereBox& where) {
  s.list({"min", "lowest corner", Need::required}, where.min, {"m"}, Schema::kVector);
  s.list({"max", "highest corner", Need::required}, where.max, {"m"}, Schema::kVector);
  bool ordered = true;  // a box without thickness may hold a plane of points
  for (std::size_t c = 0; c < where.min.size() && c < where.max.size(); ++c) {
    ordered = ordered && where.min[c] <= where.max[c];
  }
  s.require(ordered, "max", "must not be below min along any axis");
}

void describe(Schema& s, WhereSide& where) {
  static constexpr const char* kSides[] = {"min-x", "max-x", "min-y", "max-y", "min-z", "max-z"};
  const std::size_t count = s.geometry() == Geometry::three_d ? 6 : 4;
  s.value(where.side, std::span(kSides, count), "a side of the body");
}

void describe(Schema& s, WhereSet& where) {
  s.value(where.name, "name of a set of cells, faces or nodes");
}

namespace {
constexpr Quantity kTemperature{"K", at_least(0), between(50, 5000)};
}

void describe(Schema& s, Convection& convection) {
  s.varying({"h", "heat per area and degree", Need::required}, convection.h,
            {"W/m^2/K", at_least(0), between(0, 1e7)}, kOverTime);
  s.varying({"T", "temperature of the fluid", Need::required}, convection.T, kTemperature,
            kOverTime);
}

void describe(Schema& s, Radiation& radiation) {
  s.real({"emissivity", "share of what a black surface radiates"}, radiation.emissivity,
         {"1", between(0, 1)});
  s.varying({"T", "temperature of the surroundings", Need::required}, radiation.T, kTemperature,
            kOverTime);
}

void describe(Schema& s, Boundary& boundary) {
  static constexpr const char* kLater[] = {"pressure", "nonreflecting"};
  s.text({"body", "name of a body", Need::required}, boundary.body);
  s.one_of({"where", "which of its points, at time 0", Need::required}, boundary.where);
  s.words({"fix", "components that do not move"}, boundary.fix, s.axes());
  s.components({"velocity", "prescribed velocity, each component or free"}, boundary.velocity,
               {"m/s", {}, between(-1e5, 1e5)}, kOverTime);
  s.components({"force", "force in total on all these points, shared by mass"}, boundary.force,
               {"N"}, kOverTime);
  s.varying({"temperature", "these points are held at it; needs a material with thermal k"},
            boundary.temperature, kTemperature, kOverTime);
  s.varying({"flux", "heat per area into the body, on outer facets all of whose points are chosen"},
            boundary.flux, {"W/m^2", {}, between(-1e12, 1e12)}, kOverTime);
  s.object({"convection", "heat h (T - surface) per area, on such facets"}, boundary.convection);
  s.object({"radiation", "heat emissivity sigma (T^4 - surface^4) per area, on such facets"},
           boundary.radiation);
  s.real({"from", "acts from this time"}, boundary.from, {"s", at_least(0)});
  s.real({"to", "acts until this time; default: for ever"}, boundary.to, {"s", at_least(0)});
  s.later(kLater);
  const bool heats =
      boundary.temperature || boundary.flux || boundary.convection || boundary.radiation;
  s.require(!boundary.fix.empty() || boundary.velocity || boundary.force || heats, "",
            "needs fix, velocity, force, temperature, flux, convection or radiation");
  s.require(!boundary.temperature || !(boundary.flux || boundary.convection || boundary.radiation),
            "temperature", "holds these points: flux, convection and radiation act elsewhere");
  s.require(boundary.from < boundary.to, "to", "must be after from");
}

void describe(Schema& s, Damping& damping) {
  s.real({"rate", "force is minus rate times mass times velocity", Need::required}, damping.rate,
         {"1/s", at_least(0)});
  s.real({"until", "acts until this time; default: for ever"}, damping.until, {"s", positive()});
}

}  // namespace brunt::deck
