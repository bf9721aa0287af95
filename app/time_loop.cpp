#include "app/time_loop.hpp"

#include "app/verlet.hpp"

namespace brunt {

namespace {
template <int Dim>
Real choose_step(Scene<Dim>& scene, Clock& clock, Real min_step) {
  const PhaseTimer timer(scene.phases, Phase::step_bound);
  const StepVote vote = scene.stable_step(clock.time(), clock.dt());
  // A vote that is not a number fails this comparison too.
  if (!(vote.step >= min_step)) {
    scene.check(clock.time());  // knows better, where an element is inverted or a value no number
    throw PhysicsError(
        {clock.time(), scene.body_names.empty() ? "" : scene.body_names[vote.body],
         std::string(vote.reason) + " " + std::to_string(vote.entity), "stable step [s]", vote.step,
         "the step collapsed below time.min_step: an element or particle is crushed; "
         "refine or soften the contact there, or change its formulation"});
  }
  return clock.limit(vote);
}

/// Rebuilds the lists that a step of dt could make incomplete, and no others: contact asks more
/// often than particles, whose lists are dear. No answer depends on when a list is rebuilt.
template <int Dim>
void rearrange_where_due(Scene<Dim>& scene, Real dt) {
  const PhaseTimer timer(scene.phases, Phase::search);
  for (auto& solid : scene.solids) {
    if (solid->must_rearrange(dt)) solid->rearrange();
  }
  if (scene.contact && scene.contact->must_rearrange(dt)) scene.contact->rearrange();
}
}  // namespace

template <int Dim>
void run_time_loop(Scene<Dim>& scene, Clock& clock, Real min_step, Observer<Dim>& observer,
                   Balance<Dim>* balance) {
  scene.supports.start();
  scene.heat.start();
  scene.refresh_motion();
  scene.rearrange();
  observer.begin(scene, clock);
  while (!clock.finished()) {
    if (balance != nullptr) {
      const PhaseTimer timer(scene.phases, Phase::balance);
      balance->look(scene, clock.time());
    }
    const Real dt = choose_step(scene, clock, min_step);
    rearrange_where_due(scene, dt);
    {
      const PhaseTimer timer(scene.phases, Phase::points);
      for (auto& solid : scene.solids) predict(solid->points(), dt, clock.dt());
      scene.supports.impose(clock.time() + dt, dt);
      scene.refresh_motion();
    }
    for (auto& solid : scene.solids) {
      const PhaseTimer timer(scene.phases,
                             solid->n_particles() ? Phase::particles : Phase::elements);
      solid->update_state(dt);
      solid->refresh_state();
    }
    if (scene.contact) {
      const PhaseTimer timer(scene.phases, Phase::contact);
      scene.contact->add_forces(dt);
    }
    for (auto& solid : scene.solids) {
      const PhaseTimer timer(scene.phases,
                             solid->n_particles() ? Phase::particles : Phase::elements);
      solid->add_internal_forces(dt);
    }
    {
      const PhaseTimer timer(scene.phases, Phase::points);
      if (!scene.loads.empty()) scene.loads.add_forces(clock.time() + dt, dt, scene.origin);
    }
    if (scene.conducts()) scene.add_heat(clock.time() + dt, dt);
    {
      const PhaseTimer timer(scene.phases, Phase::points);
      scene.supports.take_reactions(clock.time() + dt, dt);
      for (auto& solid : scene.solids) correct(solid->points(), dt);
    }
    clock.advance(dt);
    observer.step_done(scene, clock);
  }
}

template void run_time_loop<2>(Scene<2>&, Clock&, Real, Observer<2>&, Balance<2>*);
template void run_time_loop<3>(Scene<3>&, Clock&, Real, Observer<3>&, Balance<3>*);

}  // namespace brunt
