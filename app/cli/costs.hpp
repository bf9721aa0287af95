#pragma once
#include "app/loop/clock.hpp"
#include "app/scene/scene.hpp"
#include "io/summary.hpp"

namespace brunt {

/// The most memory [byte] that this process has used.
double peak_memory();

/// Times of phases and what an element and a particle cost, over so many steps.
template <int Dim>
void fill_costs(const Scene<Dim>& scene, std::int64_t steps, RunSummary& summary);

/// Pairs of particles in the present lists of all ranks. Collective.
template <int Dim>
void fill_pairs(const Scene<Dim>& scene, const Communicator& ranks, RunSummary& summary);

/// Parts of the steps of this process, by what bounded them.
template <int Dim>
void fill_step_bounds(const Scene<Dim>& scene, const Clock& clock, RunSummary& summary);

/// "steps bounded by element of bar 92 %, contact stiffness of ball 8 %"; parts below 1 % together.
std::string step_bounds_line(const std::vector<std::pair<std::string, Real>>& bounds);

/// Processor time, and what goes between ranks in a step, of all ranks together. Collective.
void fill_traffic(const Communicator& ranks, std::int64_t steps, RunSummary& summary);

}  // namespace brunt
