#pragma once
/// Reads of nodes where they are and how fast, with the bounds of their motion. Nodes that follow
/// each other in a group as they do in the tables of contact are read four at a time, others with
/// all their components at once.
#include <algorithm>

#include "contact/geometry/motion_bounds.hpp"
#include "contact/surfaces/node_run.hpp"
#include "core/simd.hpp"

namespace brunt {

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
    for (int c = 0; c < Dim; ++c) {
      all.u_min[c] = std::min(all.u_min[c], each_[0][c]);
      all.u_max[c] = std::max(all.u_max[c], each_[1][c]);
      all.v_min[c] = std::min(all.v_min[c], each_[2][c]);
      all.v_max[c] = std::max(all.v_max[c], each_[3][c]);
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
  /// The same in 3D of nodes first, first + 1, .. of runs of one node each, of the same surface, as
  /// long as they go on and others stand behind both the node and its point. Returns where they
  /// end. On its own, or the bounds would not stay in registers.  n_points, n_nodes  how many there
  /// are in all;  made, to_x, to_v  of the first node of all
  __attribute__((noinline)) const NodeRun* read_each(const NodeRun* first, const NodeRun* last,
                                                     const Vec<Dim>* x, const Vec<Dim>* v,
                                                     std::size_t n_points, std::size_t n_nodes,
                                                     const Vec<Dim>* made, Vec<Dim>* to_x,
                                                     Vec<Dim>* to_v) {
    if constexpr (Dim == 2) return first;
    const LocalIndex surface = first->surface;
    // The last lane is of what stands behind, and of no use.
    Pack u_min = each_[0], u_max = each_[1], v_min = each_[2], v_max = each_[3];
    const auto goes_on = [&](const NodeRun& run) {
      return run.n == 1 && run.surface == surface && slot_of(run.point) + 1 < n_points &&
             slot_of(run.node) + 1 < n_nodes;
    };
    for (; first != last && goes_on(*first); ++first) {
      const std::size_t from = Dim * slot_of(first->point), to = Dim * slot_of(first->node);
      const Pack now = load(x->data() + from), velocity = load(v->data() + from);
      const Pack u = now - load(made->data() + to);
      store_node(now, to_x->data() + to), store_node(velocity, to_v->data() + to);
      u_min = vmin(u, u_min), u_max = vmax(u, u_max);
      v_min = vmin(velocity, v_min), v_max = vmax(velocity, v_max);
    }
    each_ = {u_min, u_max, v_min, v_max};
    return first;
  }

 private:
  /// Lane l of pack p is of component (4 p + l) % Dim: so four nodes lie in memory.
  using Lanes = std::array<Pack, Dim>;
  static Lanes all_lanes(Real s) {
    Lanes lanes;
    lanes.fill(broadcast<Pack>(s));
    return lanes;
  }
  static void store_node(Pack p, Real* to) {
    using Two = Real __attribute__((vector_size(16)));
    const Two two = __builtin_shufflevector(p, p, 0, 1);
    std::memcpy(to, &two, sizeof two);
    to[2] = p[2];
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
  /// Least and largest displacement and velocity of nodes by themselves: lane c is of component c.
  std::array<Pack, 4> each_ = {broadcast<Pack>(kInfinity), broadcast<Pack>(-kInfinity),
                               broadcast<Pack>(kInfinity), broadcast<Pack>(-kInfinity)};
};

}  // namespace brunt
// Tested by tests/unit/contact/moved_nodes_test.cpp.
