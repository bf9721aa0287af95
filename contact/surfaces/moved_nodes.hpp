#pragma once
/// Reads of nodes where they are and how fast, with the bounds of their motion. Nodes that follow
/// each other in a group as they do in the tables of contact are read four at a time.
#include <algorithm>

#include "contact/geometry/motion_bounds.hpp"
#include "core/simd.hpp"

namespace brunt {

/// Nodes node .. node + n - 1, which are points point .. point + n - 1 of a surface.
struct NodeRun {
  LocalIndex node = 0, surface = 0, point = 0, n = 0;
};

template <int Dim>
class MovedNodes {
 public:
  /// As of MotionBounds. What is no number bounds nothing.
  MotionBounds<Dim> bounds() const {
    MotionBounds<Dim> all = alone_;
    for (int i = 0; i < Dim * kLanes; ++i) {
      const int c = i % Dim, pack = i / kLanes, lane = i % kLanes;
      all.u_min[c] = std::min(all.u_min[c], u_min_[pack][lane]);
      all.u_max[c] = std::max(all.u_max[c], u_max_[pack][lane]);
      all.v_min[c] = std::min(all.v_min[c], v_min_[pack][lane]);
      all.v_max[c] = std::max(all.v_max[c], v_max_[pack][lane]);
    }
    return all;
  }
  /// Copies x and v of n nodes, which have moved from `made`. to_x, to_v  out
  void read(std::size_t n, const Vec<Dim>* x, const Vec<Dim>* v, const Vec<Dim>* made,
            Vec<Dim>* to_x, Vec<Dim>* to_v) {
    if (n >= kLanes) {
      read_fours(n, x->data(), v->data(), made->data(), to_x->data(), to_v->data());
      return;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Vec<Dim> now = x[i], velocity = v[i];
      to_x[i] = now, to_v[i] = velocity;
      alone_.take(now - made[i], velocity);
    }
  }

 private:
  /// Lane l of pack p is of component (4 p + l) % Dim: so four nodes lie in memory.
  using Lanes = std::array<Pack, Dim>;
  static Lanes all_lanes(Real s) {
    Lanes lanes;
    lanes.fill(broadcast<Pack>(s));
    return lanes;
  }
  void read_fours(std::size_t n, const Real* x, const Real* v, const Real* made, Real* to_x,
                  Real* to_v) {
    Lanes u_min = u_min_, u_max = u_max_, v_min = v_min_, v_max = v_max_;
    const std::size_t last = (n - kLanes) * Dim;
    // The last four overlap those before, which gives them what they have.
    for (std::size_t first = 0;; first = std::min(first + kLanes * Dim, last)) {
      for (std::size_t p = 0; p < Dim; ++p) {
        const std::size_t i = first + p * kLanes;
        const Pack now = load(x + i), velocity = load(v + i), u = now - load(made + i);
        store(to_x + i, now), store(to_v + i, velocity);
        u_min[p] = vmin(u, u_min[p]), u_max[p] = vmax(u, u_max[p]);
        v_min[p] = vmin(velocity, v_min[p]), v_max[p] = vmax(velocity, v_max[p]);
      }
      if (first == last) break;
    }
    u_min_ = u_min, u_max_ = u_max, v_min_ = v_min, v_max_ = v_max;
  }

  MotionBounds<Dim> alone_;
  Lanes u_min_ = all_lanes(kInfinity), u_max_ = all_lanes(-kInfinity);
  Lanes v_min_ = all_lanes(kInfinity), v_max_ = all_lanes(-kInfinity);
};

}  // namespace brunt
// Tested by tests/unit/contact/moved_nodes_test.cpp.
