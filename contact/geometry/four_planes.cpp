#include "contact/geometry/four_planes.hpp"
#include "core/transpose.hpp"

namespace brunt {

namespace {
BRUNT_INLINE Place<Pack> keep(PackMask mask, const Place<Pack>& a) {
  const Pack none = broadcast<Pack>(0);
  return {select(mask, a.x, none), select(mask, a.y, none), select(mask, a.z, none)};
}

BRUNT_INLINE void find_means(const std::array<Place<Pack>, 4>& x, FourMeans& means) {
  const Place<Pack> twice = cross(x[2] - x[0], x[3] - x[1]);
  const Pack norm = vsqrt(dot(twice, twice));
  const Pack area = 0.5 * norm;
  const Place<Pack> normal = {twice.x / norm, twice.y / norm, twice.z / norm};
  // The corners of a quad lie at equal distances from its mean plane, alternately over and under.
  const Pack warp = 0.25 * vabs(dot((x[0] - x[1]) + (x[2] - x[3]), normal));
  means.there = (area > 0) & (dot(normal, normal) > 0.5);
  means.area = select(means.there, area, broadcast<Pack>(0));
  means.warp = select(means.there, warp, broadcast<Pack>(0));
  means.normal = keep(means.there, normal);
}
}  // namespace

FourMeans::FourMeans(const std::array<Place<Pack>, 4>& x) { find_means(x, *this); }

FourPlanes::FourPlanes(const std::array<Place<Pack>, 4>& x, Pack area_start) {
  center = broadcast<Pack>(0.25) * ((x[0] + x[1]) + (x[2] + x[3]));
  FourMeans means;
  find_means(x, means);
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
  // From component to component: a copy of a place goes by halves of packs, and is waited for.
  const auto bound = [&](Pack Place<Pack>::*of) {
    Pack least = x[0].*of, most = least;
    for (std::size_t c = 1; c < 4; ++c) least = vmin(x[c].*of, least), most = vmax(x[c].*of, most);
    lo.*of = least, hi.*of = most;
  };
  bound(&Place<Pack>::x), bound(&Place<Pack>::y), bound(&Place<Pack>::z);
}

void FourPlanes::give(int lane, FacePlane<3>& face) const {
  face.center = Vec3(center.x[lane], center.y[lane], center.z[lane]);
  face.normal = Vec3(normal.x[lane], normal.y[lane], normal.z[lane]);
  face.area = area[lane];
  face.warp = warp[lane];
  face.simple = lane_of(simple, lane);
  face.flat = lane_of(flat, lane);
}

void FourPlanes::give(FacePlane<3>* const (&face)[4], SearchBox<3>* const (&box)[4]) const {
  Pack first[4], last[4], low[4], high[4];
  transpose(center.x, center.y, center.z, normal.x, first);
  transpose(normal.y, normal.z, area, warp, last);
  transpose(lo.x, lo.y, lo.z, hi.x, low);
  transpose(hi.y, hi.z, hi.y, hi.z, high);
  for (int lane = 0; lane < kLanes; ++lane) {
    // Numbers in a row, as they stand in a plane.
    FacePlane<3>& plane = *face[lane];
    Real* at = plane.center.data();
    store(at, first[lane]), store(at + kLanes, last[lane]);
    plane.simple = lane_of(simple, lane);
    plane.flat = lane_of(flat, lane);
    static_assert(sizeof(SearchBox<3>) == 6 * sizeof(Real));
    char* const sides = reinterpret_cast<char*>(box[lane]);
    std::memcpy(sides, &low[lane], sizeof(Pack));
    std::memcpy(sides + sizeof(Pack), &high[lane], 2 * sizeof(Real));
  }
}

SearchBox<3> FourPlanes::box(int lane) const {
  return {{lo.x[lane], lo.y[lane], lo.z[lane]}, {hi.x[lane], hi.y[lane], hi.z[lane]}};
}

}  // namespace brunt
// Tested by tests/unit/contact/four_planes_test.cpp.
