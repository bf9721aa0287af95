#pragma once
#include <atomic>
#include <span>
#include <vector>

#include "core/points.hpp"
#include "sph/list_watch.hpp"
#include "sph/mirrors.hpp"

namespace brunt {

/// Which particles a step may leave out, since it would change no bit of them: those of zones that
/// touch none that is stirred. A zone is stirred once one of its particles has moved, or has
/// another volume or any stress for its neighbours to read, and is so until the lists are built
/// anew. Of what lies still, all sums over neighbours are those of the last step.
/// docs/theory/sph.md, section 11
template <int Dim>
class StillZones {
 public:
  /// Nothing is left out before a step has computed all particles with these lists.
  void start(const ListWatch<Dim>& watch, std::size_t n_owned);
  /// Notes that neighbours read something new of a particle, owned or a copy. By any thread.
  void stir(std::size_t particle) {
    std::atomic_ref(stirred_[slot_of(zone_of_[particle])]).store(1, std::memory_order_relaxed);
  }
  bool is_stirred(std::size_t particle) {
    const std::atomic_ref zone(stirred_[slot_of(zone_of_[particle])]);
    return zone.load(std::memory_order_relaxed) != 0;
  }
  /// True where nothing is left that might be left out.
  bool all_stirred() const { return n_stirred_ == stirred_.size(); }
  /// Once the points have their places and velocities of a step: finds zones that move.
  /// images  behind the points in the lists: they move as what they are of
  void look(const ListWatch<Dim>& watch, const Points<Dim>& points,
            std::span<const MirrorImage> images = {});
  /// Before forces, once all stresses of the step are known: leaves out fewer, never more.
  void look_again(const ListWatch<Dim>& watch);
  /// True where the step computes nothing of an owned particle.
  bool leaves_out(LocalIndex particle) const { return left_out_[slot_of(particle)] != 0; }
  /// Owned particles that the step leaves out.
  std::size_t count() const { return count_; }

 private:
  bool settle(const ListWatch<Dim>& watch);
  void find_left_out();

  std::vector<LocalIndex> zone_of_;  // of each particle, copies and images too
  std::vector<char> stirred_;        // of each zone
  std::vector<char> near_;           // whether it or one that touches it is stirred
  std::vector<char> left_out_;       // of each owned particle
  std::size_t n_stirred_ = 0, count_ = 0;
  bool computed_ = false;  // a step has computed all particles since the lists were built
  bool found_ = false;     // left_out_ has been found since
};

}  // namespace brunt
// Tested by tests/unit/sph/still_zones_test.cpp.
