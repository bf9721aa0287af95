#pragma once
#include "app/balance.hpp"
#include "app/clock.hpp"
#include "app/scene.hpp"

namespace brunt {

/// Watches a run: output, progress, checks. Sees the scene at whole steps only.
template <int Dim>
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void begin(Scene<Dim>& scene, Clock& clock) = 0;
  virtual void step_done(Scene<Dim>& scene, Clock& clock) = 0;
};

/// Steps the scene to the end of its time: velocity Verlet, all of the physics in one loop
/// (architecture.md 4). Throws PhysicsError when the step collapses below min_step [s].
/// balance  none: points stay with the ranks that have them
template <int Dim>
void run_time_loop(Scene<Dim>& scene, Clock& clock, Real min_step, Observer<Dim>& observer,
                   Balance<Dim>* balance = nullptr);

}  // namespace brunt
