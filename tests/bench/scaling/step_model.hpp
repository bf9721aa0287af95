#pragma once
/// A simple model of what a step costs on many ranks.
#include <algorithm>
#include <cmath>

#include "partitioned_scene.hpp"

namespace brunt {

/// What work and messages cost.
struct Machine {
  Real element = 330e-9;    ///< [s] an element-step
  Real particle = 1440e-9;  ///< [s] a particle-step
  Real candidate = 900e-9;  ///< [s] a candidate of contact
  Real surface = 0;         ///< [s] a face or particle of contact, whatever it may touch
  Real latency = 1.5e-6;    ///< [s] a message
  Real bandwidth = 10e9;    ///< [byte/s] of a rank
};

/// What all ranks do together in a step, on average.
struct Rates {
  Real particle_lists = 0;  ///< how often neighbour lists of particles are made
  Real contact_lists = 0;   ///< how often lists of contact are made
  Real reductions = 0;      ///< a value of all ranks to all ranks
  Real exchanges = 0;       ///< of sizes: every rank tells every other a number
  Real rows = 0;            ///< of history.csv
};

/// Seconds of a step of one rank.
struct StepCost {
  Real work = 0, neighbours = 0, lists = 0, all_ranks = 0;
  Real total() const { return work + neighbours + lists + all_ranks; }
};

inline Real work_of(const RankLoad& load, const Machine& machine) {
  return static_cast<Real>(load.computed) * machine.element +
         static_cast<Real>(load.particles) * machine.particle +
         static_cast<Real>(load.candidates) * machine.candidate +
         static_cast<Real>(load.surface) * machine.surface;
}

/// A message costs latency + bytes / bandwidth where it is sent; a reduction goes up and down a
/// binary tree; an exchange of sizes takes log2 n rounds with half of the numbers in each (Bruck et
/// al. 1997). Nothing overlaps.
inline StepCost step_cost(const RankLoad& load, const Machine& machine, const Rates& rates,
                          int n_ranks) {
  const auto of = [&](const Sent& sent) {
    return sent.messages * machine.latency + sent.bytes / machine.bandwidth;
  };
  const Real rounds = n_ranks > 1 ? std::ceil(std::log2(n_ranks)) : 0.0;
  StepCost cost;
  cost.work = work_of(load, machine);
  cost.neighbours = of(load.step);
  cost.lists =
      rates.particle_lists * of(load.particle_lists) + rates.contact_lists * of(load.contact_lists);
  cost.all_ranks = rates.reductions * 2 * rounds * machine.latency +
                   rates.exchanges * rounds * (machine.latency + 4.0 * n_ranks / machine.bandwidth);
  return cost;
}

}  // namespace brunt
