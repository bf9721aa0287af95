#include "app/deck/boundaries.hpp"

#include <array>

namespace brunt::deck {

namespace {
constexpr const char* kAxes[] = {"x", "y", "z"};
constexpr std::array kOverTime{Varying::Over::time, Varying::Over::expression};

std::span<const char* const> axes_of(const Schema& s) {
  return {kAxes, s.geometry() == Geometry::three_d ? 3u : 2u};
}
}  // namespace

void describe(Schema&, WhereAll&) {}
void describe(Schema&, WhereSurface&) {}

void describe(Schema& s, WherePlane& where) {
  s.choice({"axis", "axis that the plane cuts", Need::required}, where.axis, axes_of(s));
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

void describe(Schema& s, Boundary& boundary) {
  static constexpr const char* kLater[] = {"pressure", "nonreflecting", "temperature",
                                           "flux",     "convection",    "radiation"};
  s.text({"body", "name of a body", Need::required}, boundary.body);
  s.one_of({"where", "which of its points, at time 0", Need::required}, boundary.where);
  s.words({"fix", "components that do not move"}, boundary.fix, axes_of(s));
  s.components({"velocity", "prescribed velocity, each component or free"}, boundary.velocity,
               {"m/s", {}, between(-1e5, 1e5)}, kOverTime);
  s.components({"force", "force in total on all these points, shared by mass"}, boundary.force,
               {"N"}, kOverTime);
  s.real({"from", "acts from this time"}, boundary.from, {"s", at_least(0)});
  s.real({"to", "acts until this time; default: for ever"}, boundary.to, {"s", at_least(0)});
  s.later(kLater);
  s.require(!boundary.fix.empty() || boundary.velocity || boundary.force, "",
            "needs fix, velocity or force");
  s.require(boundary.from < boundary.to, "to", "must be after from");
}

void describe(Schema& s, Damping& damping) {
  s.real({"rate", "force is minus rate times mass times velocity", Need::required}, damping.rate,
         {"1/s", at_least(0)});
  s.real({"until", "acts until this time; default: for ever"}, damping.until, {"s", positive()});
}

}  // namespace brunt::deck
