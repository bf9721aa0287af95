#include "app/loop/time_loop.hpp"

#include <sstream>

#include "app/loop/verlet.hpp"
#include "core/large_blocks.hpp"

namespace brunt {

namespace {
/// The smallest step limit of all ranks and what they are asked for, in one reduction.
template <int Dim>
StepHead agree(Scene<Dim>& scene, const Clock& clock, Observer<Dim>& observer) {
  const PhaseTimer timer(scene.phases, Phase::step_bound);
  const StepLimit of_heat = scene.heat_step();
  const StepLimit step_limit = scene.stable_step(clock.time(), of_heat);
  return over_ranks({step_limit, observer.requests(scene, clock), of_heat.step}, *scene.ranks);
}

template <int Dim>
Real choose_step(const StepLimit& step_limit, Scene<Dim>& scene, Clock& clock) {
  // A step limit that is not a number fails this comparison too.
  if (!(step_limit.step >= clock.least_step())) {
    scene.check(clock.time());  // knows better, where an element is inverted or a value no number
    std::ostringstream cause;
    cause << "the step collapsed below " << clock.real(clock.least_step()) << " s (time.min_step) "
          << "in step " << clock.step() << "; " << scene.advice(step_limit);
    throw PhysicsError({clock.time(),
                        scene.body_names.empty() ? "" : scene.body_names[step_limit.body],
                        std::string(step_limit.reason) + " " + std::to_string(step_limit.entity),
                        "stable step [s]", clock.real(step_limit.step), cause.str()});
  }
  return clock.limit(step_limit);
}

/// The step [s] that is taken, and whether it evaluates conduction.
template <int Dim>
Real begin_step(const StepHead& head, Scene<Dim>& scene, Clock& clock) {
  const Real dt = choose_step(head.step_limit, scene, clock);
  if (scene.conducts()) scene.begin_heat(clock.step(), clock.time(), dt, head.heat_step);
  return dt;
}

template <int Dim>
Phase phase_of(const Solid<Dim>& solid) {
  return solid.n_particles() > 0 ? Phase::particles : Phase::elements;
}

/// What stands before the first step: boundaries of time 0, lists, contacts, first row and frame.
template <int Dim>
void start(Scene<Dim>& scene, Clock& clock, Observer<Dim>& observer) {
  scene.rigid_motions.start();
  scene.boundaries.start();
  if (scene.rigid) scene.rigid->start();
  scene.refresh_motion();
  for (auto& solid : scene.solids) solid->begin_lists();
  if (scene.contact) scene.contact->rearrange();
  if (scene.contact && scene.contact->start()) {
    scene.rigid_motions.take_reactions(0);
    if (scene.rigid) scene.rigid->press(*scene.ranks);
  }
  gather_heap();
  observer.begin(scene, clock);
  keep_freed_blocks(false);
}

/// Points to x(n+1), with v(n+1/2).
template <int Dim>
void move(Scene<Dim>& scene, const Clock& clock, Real dt) {
  const PhaseTimer timer(scene.phases, Phase::points);
  const Real time = clock.time() + dt;
  for (auto& solid : scene.solids) predict(solid->points(), dt, clock.dt());
  scene.rigid_motions.impose(time, dt);
  scene.boundaries.impose(time, dt);
  if (scene.rigid) scene.rigid->predict(time, dt, clock.dt());
  scene.refresh_motion();
}
}  // namespace

template <int Dim>
void run_time_loop(Scene<Dim>& scene, Clock& clock, Observer<Dim>& observer,
                   Balance<Dim>* balance) {
  Phases& phases = scene.phases;
  start(scene, clock, observer);
  const WallTimer loop(scene.loop, *phases.ranks);
  while (!clock.finished()) {
    if (balance != nullptr) {
      const PhaseTimer timer(phases, Phase::balance);
      balance->look(scene, clock.time());
    }
    const StepHead head = agree(scene, clock, observer);
    observer.answer(head, scene, clock);
    if (clock.finished()) break;
    const Real dt = begin_step(head, scene, clock);
    move(scene, clock, dt);
    scene.erode(dt);
    for (auto& solid : scene.solids) {
      {
        const PhaseTimer timer(phases, Phase::search);
        solid->renew_lists();
      }
      const PhaseTimer timer(phases, phase_of(*solid));
      solid->update_state(dt);
      solid->refresh_state();
    }
    if (scene.contact) {
      {
        const PhaseTimer timer(phases, Phase::search);
        scene.contact->renew_lists(dt);
      }
      const PhaseTimer timer(phases, Phase::contact);
      scene.contact->add_forces(dt, clock.time() + dt);
    }
    // Before the internal forces, which take what acts across the axis of an axisymmetric scene.
    {
      const PhaseTimer timer(phases, Phase::points);
      if (!scene.loads.empty()) scene.loads.add_forces(clock.time() + dt, dt);
      scene.boundaries.add_forces(clock.time() + dt, dt);
    }
    for (std::size_t s = 0; s < scene.solids.size(); ++s) {
      auto& solid = *scene.solids[s];
      const PhaseTimer timer(phases, phase_of(solid));
      scene.sections.before_internal(s, solid.points());
      solid.add_internal_forces(dt);
      scene.sections.after_internal(s, solid.points());
    }
    if (scene.conducts()) scene.add_heat(clock.time() + dt, dt);
    {
      const PhaseTimer timer(scene.phases, Phase::points);
      if (scene.rigid) scene.rigid->collect_forces(*scene.ranks, clock.time() + dt, dt);
      scene.rigid_motions.take_reactions(dt);
      scene.boundaries.take_reactions(clock.time() + dt, dt);
      for (auto& solid : scene.solids) correct(solid->points(), dt);
      if (scene.rigid) scene.rigid->correct(dt);
    }
    clock.advance(dt);
    observer.step_done(scene, clock);
  }
}

template void run_time_loop<2>(Scene<2>&, Clock&, Observer<2>&, Balance<2>*);
template void run_time_loop<3>(Scene<3>&, Clock&, Observer<3>&, Balance<3>*);

}  // namespace brunt
