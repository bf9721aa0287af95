/// What contact carries from step to step, as tables: one a surface, by the ids of its points.
#include <algorithm>

#include "contact/manager/implementation.hpp"

namespace brunt {
namespace {

template <class Row, class Nodes>
void visit_node(Row& row, Nodes& nodes, std::size_t i) {
  row(nodes.v[i]);
  row(nodes.spring[i]);
  row(nodes.damping[i]);
  row(nodes.spring_work[i]);
  row(nodes.damping_energy[i]);
  if (nodes.conduct) row(nodes.friction_given[i]);
  if (!nodes.has_friction) return;
  row(nodes.friction[i]);
  row(nodes.friction_heat[i]);
  row(nodes.friction_stored[i]);
  row(nodes.friction_damped[i]);
  row(nodes.pair_energy[i]);
}

/// Nodes of one surface that are points here: the owned ones, or copies too.
template <int Dim>
std::vector<std::size_t> nodes_of(const ContactNodes<Dim>& nodes, std::size_t surface,
                                  bool owned_only) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (static_cast<std::size_t>(nodes.surface[i]) != surface || nodes.point[i] < 0) continue;
    if (nodes.owned[i] || !owned_only) chosen.push_back(i);
  }
  return chosen;
}

std::string table_of(std::size_t surface) { return "contact." + std::to_string(surface); }

/// The one row of the table "contact".
struct Common {
  Real dt_last = 0;
  std::uint64_t started = 0;
};
template <class Row, class AnyCommon>
void visit_common(Row& row, AnyCommon& common) {
  row(common.dt_last);
  row(common.started);
}

}  // namespace

template <int Dim>
void ContactManager<Dim>::save_state(std::vector<StateTable>& tables) const {
  const auto& own = *implementation_;
  const Common common{own.dt_last, own.started ? 1u : 0u};
  save_row(
      "contact", [&](auto& row) { visit_common(row, common); }, tables);
  const auto& nodes = own.entities.nodes;
  for (std::size_t s = 0; s < own.surfaces.size(); ++s) {
    const auto chosen = nodes_of(nodes, s, true);
    save_rows(
        table_of(s), chosen.size(), [&](std::size_t k) { return nodes.id[chosen[k]]; },
        [&](auto& row, std::size_t k) { visit_node(row, nodes, chosen[k]); }, tables);
  }
  own.near.save_state(tables);
  own.memory.save(own.records, own.entities, tables);
}

template <int Dim>
void ContactManager<Dim>::load_state(const StateTables& tables) {
  auto& own = *implementation_;
  Common common;
  load_row(
      "contact", [&](auto& row) { visit_common(row, common); }, tables);
  auto& nodes = own.entities.nodes;
  for (std::size_t s = 0; s < own.surfaces.size(); ++s) {
    const auto chosen = nodes_of(nodes, s, false);
    load_rows(
        table_of(s), chosen.size(), [&](std::size_t k) { return nodes.id[chosen[k]]; },
        [&](auto& row, std::size_t k) { visit_node(row, nodes, chosen[k]); }, tables);
  }
  std::fill(nodes.pressed.begin(), nodes.pressed.end(), char{1});  // it may be: forces are known
  own.dt_last = common.dt_last;
  own.started = common.started != 0;
  if (!own.started) return rearrange();
  own.near.load_state(tables);
  own.memory.load(own.entities, tables);
  rearrange();
  const StepLimit longest = own.longest_after(own.dt_last);
  own.ahead_last = own.look_ahead(own.dt_last, longest);
  own.renew(own.ahead_last, false);
  own.evaluate(own.dt_last, longest, own.ahead_last, nullptr);
  own.memory.keep_deep(own.records);
  if (!nodes.has_friction) return;
  load_friction(own.entities, tables, own.records);
  own.sum_tractions();
  KeyedMemory<FaceGrowth> growths;
  growths.load(own.entities, tables);
  take_growths(growths, own.entities);
}

template void ContactManager<2>::save_state(std::vector<StateTable>&) const;
template void ContactManager<3>::save_state(std::vector<StateTable>&) const;
template void ContactManager<2>::load_state(const StateTables&);
template void ContactManager<3>::load_state(const StateTables&);

}  // namespace brunt
