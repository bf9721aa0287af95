#pragma once
#include "app/loop/clock.hpp"
#include "app/loop/step_head.hpp"
#include "app/ranks/balance.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// Watches a run: output, progress, checks. Sees the scene at whole steps only.
/// What ranks may be asked for one by one goes with the step limit for the step, in one reduction.
template <int Dim>
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void begin(Scene<Dim>& scene, Clock& clock) = 0;
  /// What this rank is asked for before a step. Not collective.
  virtual Requests requests(const Scene<Dim>&, const Clock&) { return {}; }
  /// Answers what ranks have agreed on before a step, at whole steps still; it may stop the clock.
  virtual void answer(const StepHead&, Scene<Dim>&, Clock&) {}
  virtual void step_done(Scene<Dim>& scene, Clock& clock) = 0;
};

/// Steps the scene to the end of its time: velocity Verlet, all of the physics in one loop
/// (docs/theory/integration.md (I1) to (I7)). Throws PhysicsError when the step collapses below
/// clock.least_step(). balance  none: points stay with the ranks that have them
template <int Dim>
void run_time_loop(Scene<Dim>& scene, Clock& clock, Observer<Dim>& observer,
                   Balance<Dim>* balance = nullptr);

}  // namespace brunt
