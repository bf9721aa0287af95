#pragma once
#include <functional>
#include <memory>

#include "app/deck/deck.hpp"
#include "app/ranks/thread_choice.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// Watches how evenly the work of a run is spread over its ranks, and repartitions the points
/// where it has drifted apart. Which rank computes what changes no bit of the answer: a new
/// partition is a restart within the run, by the rows that a checkpoint would write. Beside that it
/// leaves threads out while other programs have their cores.
template <int Dim>
class Balance {
 public:
  using Build = std::function<std::unique_ptr<Scene<Dim>>()>;
  /// build  makes the whole scene at time 0
  /// cost  [s] of wall time that a partition takes, as far as is known
  Balance(const deck::Ranks& options, Build build, double cost);

  /// Between two steps: compares the ranks' work every so many steps, and repartitions it where
  /// that will pay and nothing has broken. time [s]. Collective.
  void look(Scene<Dim>& scene, Real time);

  Real ratio() const { return ratio_; }  ///< largest over mean work, since the last look but one
  int repartitions() const { return repartitions_; }  ///< since the start
  /// Steps of this rank on one thread, since other programs used the cores of the rest.
  std::int64_t steps_alone() const { return threads_.steps_alone(); }

 private:
  bool is_due(Scene<Dim>& scene);
  std::vector<Real> weights(const Scene<Dim>& scene) const;
  void repartition(Scene<Dim>& scene);

  ThreadTeam threads_;
  deck::Ranks options_;
  Build build_;
  double cost_;
  int steps_ = 0;  // since the last look
  Phases last_;    // at the last look
  Real ratio_ = 1;
  Real lost_ = 0;  // [s] that ranks have waited since the last partition
  int repartitions_ = 0;
};

}  // namespace brunt
