#pragma once
#include "app/scene/scene.hpp"
#include "io/summary.hpp"

namespace brunt {

/// The most memory [byte] that this process has used.
double peak_memory();

/// Times of phases and what an element and a particle cost, over so many steps.
template <int Dim>
void fill_costs(const Scene<Dim>& scene, std::int64_t steps, RunSummary& summary);

/// Processor time, and what goes between ranks in a step, of all ranks together. Collective.
void fill_traffic(const Communicator& ranks, std::int64_t steps, RunSummary& summary);

}  // namespace brunt
