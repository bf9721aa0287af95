#include "contact/geometry/four_planes.hpp"

namespace brunt {

namespace {
BRUNT_INLINE Place<Pack> keep(PackMask mask, const Place<Pack>& a) {
  const Pack none = broadcast<Pack>(0);
  return {select(mask, a.x, none), select(mask, a.y, none), select(mask, a.z, none)};
}
}  // namespace

FourMeans::FourMeans(const std::array<Place<Pack>, 4>& x) {
  const Place<Pack> twice = cross(x[2] - x[0], x[3] - x[1]);
  const Pack norm = vsqrt(dot(twice, twice));
  area = 0.5 * norm;
  normal = {twice.x / norm, twice.y / norm, twice.z / norm};
  // The corners of a quad lie at equal distances from its mean plane, alternately over and under.
  warp = 0.25 * vabs(dot((x[0] - x[1]) + (x[2] - x[3]), normal));
  there = (area > 0) & (dot(normal, normal) > 0.5);
  area = select(there, area, broadcast<Pack>(0));
  warp = select(there, warp, broadcast<Pack>(0));
  normal = keep(there, normal);
}

FourPlanes::FourPlanes(const std::array<Place<Pack>, 4>& x, Pack area_start) {
  center = broadcast<Pack>(0.25) * ((x[0] + x[1]) + (x[2] + x[3]));
  const FourMeans means(x);
  area = means.area, warp = means.warp, normal = means.normal;
  const Pack width = vsqrt(area), width_start = vsqrt(area_start);
  simple = warp <= kWarpLimit * width;
  flat = warp <= kFlatLimit * width;
  const Pack least = kConvexLimit * area;
  Place<Pack> edge = x[1] - x[0], first = edge;
  // It is convex where it turns left at each corner.
  for (std::size_t c = 1; c <= 4; ++c) {
    const Place<Pack> following = c == 4 ? first : x[(c + 1) % 4] - x[c];
    simple = simple & (dot(cross(edge, following), normal) >= least);
    edge = following;
  }
  flat = flat & simple;
  const PackMask there = means.there;
  const PackMask no_start = ~(area_start > 0);
  simple = (simple | ~there) & (no_start | (warp <= kWarpLimit * width_start));
  flat = (flat | ~there) & (no_start | (warp <= kFlatLimit * width_start));
  lo = hi = x[0];
  for (std::size_t c = 1; c < 4; ++c) {
    lo = {vmin(x[c].x, lo.x), vmin(x[c].y, lo.y), vmin(x[c].z, lo.z)};
    hi = {vmax(x[c].x, hi.x), vmax(x[c].y, hi.y), vmax(x[c].z, hi.z)};
  }
}

void FourPlanes::give(int lane, FacePlane<3>& face) const {
  face.center = Vec3(center.x[lane], center.y[lane], center.z[lane]);
  face.normal = Vec3(normal.x[lane], normal.y[lane], normal.z[lane]);
  face.area = area[lane];
  face.warp = warp[lane];
  face.simple = lane_of(simple, lane);
  face.flat = lane_of(flat, lane);
}

SearchBox<3> FourPlanes::box(int lane) const {
  return {{lo.x[lane], lo.y[lane], lo.z[lane]}, {hi.x[lane], hi.y[lane], hi.z[lane]}};
}

}  // namespace brunt
// Tested by tests/unit/contact/four_planes_test.cpp.
