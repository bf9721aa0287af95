#include "contact/manager/evaluation.hpp"

#include <cmath>
#include <map>

namespace brunt {

namespace {
/// Pairs of faces below which a team of threads costs more than it saves: one that is pressed takes
/// a microsecond.
constexpr std::size_t kPairsWorthThreads = 64;

/// [m/s^2]
Real gravity_of(const ContactOptions& options) {
  Real squared = 0;
  for (const Real g : options.gravity) squared += g * g;
  return std::sqrt(squared);
}
}  // namespace

template <int Dim>
void Evaluation<Dim>::run(const ContactSetup<Dim>& setup, ContactSearch<Dim>& search, Real dt,
                          const LookAhead& ahead, const TouchStep& touches,
                          FrictionHistory<Dim>* past) {
  auto& entities = search.entities();
  const auto& candidates = search.candidates();
  records_.clear();
  const EvaluationStep step{dt,
                            ahead.time,
                            touches,
                            entities.longest_step,
                            setup.rigid.step_limit.step,
                            candidates.speed(),
                            gravity_of(setup.options),
                            candidates.way_of_faces(entities) > 0};
  const auto on_faces = candidates.faces(entities);
  if (candidates.n_faces() > 0) entities.refresh_reaches();
  records_.for_parts(candidates.n_faces(), kPairsWorthThreads,
                     [&](std::size_t first, std::size_t last, auto& part) {
                       evaluate_faces<Dim>(entities, on_faces.part(first, last), setup.section,
                                           step, past, part);
                     });
  run_particles(setup, search, step, past);
  step_limit_ = ahead.longest;
  step_limit_.take(records_.step_limit());
}

template <int Dim>
void Evaluation<Dim>::run_particles(const ContactSetup<Dim>& setup,
                                    const ContactSearch<Dim>& search, const EvaluationStep& step,
                                    FrictionHistory<Dim>* past) {
  const auto& entities = search.entities();
  const auto& candidates = search.candidates();
  const auto rows = candidates.pair_starts();
  loads_.assign(rows.empty() ? 0 : entities.particles.size(), {});
  sides_.assign(entities.nodes.conduct ? candidates.pairs().size() : 0, {});
  const ParticleRows beside_faces = candidates.particle_rows(setup.pairs, step.longest);
  if (!beside_faces.row_clearances.empty()) {
    records_.for_parts(beside_faces.row_clearances.size(), kWorthThreads,
                       [&](std::size_t first, std::size_t last, auto& part) {
                         evaluate_particles<Dim>(entities, beside_faces.part(first, last),
                                                 setup.section, step, past, loads_, part);
                       });
  }
  if (rows.empty()) return;
  records_.for_parts(rows.size() - 1, kWorthThreads,
                     [&](std::size_t first, std::size_t last, auto& part) {
                       const PairRows chosen{candidates.pairs(),
                                             rows.subspan(first, last - first + 1), loads_, sides_};
                       evaluate_pairs<Dim>(entities, chosen, setup.section, step, past, part);
                     });
}

template <int Dim>
void Evaluation<Dim>::complete_pair_heat(const ContactSetup<Dim>& setup,
                                         const ContactSearch<Dim>& search) {
  if (!setup.pairs.particles_meet()) return;
  const auto& entities = search.entities();
  const auto rows = search.candidates().pairs();
  std::map<std::pair<GlobalId, GlobalId>, PairSide> elsewhere;
  search.imports().send_sides(entities, rows, sides_,
                              [&](GlobalId lower, GlobalId upper, const PairSide& side) {
                                elsewhere[{lower, upper}] = side;
                              });
  // Faces did not know what else takes the heat of their particle.
  const auto share = [&](HeatFlow<Dim>& flow) {
    if (flow.h_area == 0 || loads_.empty()) return;
    const ParticleLoad& load = loads_[entities.particle_with(flow.key.first)];
    flow.upper.capacity *= static_cast<Real>(load.on_faces) / load.heat_contacts;
  };
  records_.change_heat_of_particles(share, [&](PairHeatPath<Dim>& heat) {
    if (heat.per_area == 0) return;
    const auto& pair = rows[heat.candidate];
    const auto& key = heat.flow.key;
    heat.complete(sides_[heat.candidate], pair.mirror >= 0 ? sides_[slot_of(pair.mirror)]
                                                           : elsewhere.at({key.first, key.second}));
  });
}

template class Evaluation<2>;
template class Evaluation<3>;

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
