/// What contact carries from step to step, as tables: one a surface, by the ids of its points.
#include <algorithm>

#include "contact/manager/implementation.hpp"
#include "core/state_hash.hpp"

namespace brunt {
namespace {

template <class Row, class Nodes>
void visit_node(Row& row, Nodes& nodes, std::size_t i) {
  nodes.for_carried([&](auto field, FieldUse use) {
    using Value = std::remove_cvref_t<decltype((nodes.*field)[i])>;
    if constexpr (!std::is_integral_v<Value>) {
      if (use.saved) row((nodes.*field)[i]);
    }
  });
}

/// Numbers first, then the components of vectors one after the other.
template <int Dim>
std::uint64_t node_hash(const ContactNodes<Dim>& nodes, std::size_t i) {
  EntityHash hash(nodes.id[i]);
  hash.add(static_cast<std::uint64_t>(nodes.surface[i]));
  nodes.for_carried([&](auto field, FieldUse use) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype((nodes.*field)[i])>, Real>) {
      if (use.hashed) hash.add((nodes.*field)[i]);
    }
  });
  for (int c = 0; c < Dim; ++c) {
    nodes.for_carried([&](auto field, FieldUse use) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype((nodes.*field)[i])>, Vec<Dim>>) {
        if (use.hashed) hash.add((nodes.*field)[i][c]);
      }
    });
  }
  return hash.value();
}

/// Nodes of one surface that are points here: the owned ones, or copies too.
template <int Dim>
std::vector<std::size_t> nodes_of(const ContactNodes<Dim>& nodes, std::size_t surface,
                                  bool owned_only) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (slot_of(nodes.surface[i]) != surface || nodes.point[i] < 0) continue;
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
  const Common common{own.last.dt, own.last.started ? 1u : 0u};
  save_row(
      "contact", [&](auto& row) { visit_common(row, common); }, tables);
  const auto& entities = own.search.entities();
  const auto& nodes = entities.nodes;
  for (std::size_t s = 0; s < own.setup.surfaces.size(); ++s) {
    const auto chosen = nodes_of(nodes, s, true);
    save_rows(
        table_of(s), chosen.size(), [&](std::size_t k) { return nodes.id[chosen[k]]; },
        [&](auto& row, std::size_t k) { visit_node(row, nodes, chosen[k]); }, tables);
  }
  own.search.save_state(tables);
  own.memory.save(own.evaluation.records(), entities, tables);
}

template <int Dim>
void ContactManager<Dim>::load_state(const StateTables& tables) {
  auto& [setup, search, evaluation, memory, friction_check, last] = *implementation_;
  search.take_surfaces();
  auto& entities = search.entities();
  Common common;
  load_row(
      "contact", [&](auto& row) { visit_common(row, common); }, tables);
  auto& nodes = entities.nodes;
  for (std::size_t s = 0; s < setup.surfaces.size(); ++s) {
    const auto chosen = nodes_of(nodes, s, false);
    load_rows(
        table_of(s), chosen.size(), [&](std::size_t k) { return nodes.id[chosen[k]]; },
        [&](auto& row, std::size_t k) { visit_node(row, nodes, chosen[k]); }, tables);
  }
  std::fill(nodes.pressed.begin(), nodes.pressed.end(), char{1});  // it may be: forces are known
  last.dt = common.dt_last;
  last.started = common.started != 0;
  if (!last.started) return rearrange();
  search.load_state(tables);
  memory.load(entities, tables);
  rearrange();
  const LookAhead ahead = search.look_ahead(last.dt);
  last.ahead = ahead.time;
  search.renew(ahead.time, Tables::inherited, false);
  evaluation.run(setup, search, last.dt, ahead, memory.step(false, true), nullptr);
  memory.take_repeated(evaluation.records());
  if (!nodes.has_friction) return;
  load_friction(entities, tables, evaluation.records());
  search.sum_tractions(evaluation.records());
  KeyedMemory<FaceGrowth> growths;
  growths.load(entities, tables);
  take_growths(growths, entities);
}

template <int Dim>
void ContactManager<Dim>::add_totals(Totals<Dim>& totals) const {
  const auto& nodes = implementation_->search.entities().nodes;
  const auto add = [&](std::size_t first, std::size_t last, Totals<Dim>& part) {
    for (std::size_t i = first; i < last; ++i) {
      if (!nodes.owned[i]) continue;
      part.add(Column::contact_pairs, nodes.spring_work[i]);
      part.add(Column::contact_damping, nodes.damping_energy[i]);
      if (nodes.erodes) {
        part.add(Column::eroded, nodes.eroded_energy[i]);
        part.add(Column::contact_pairs, -nodes.eroded_energy[i]);
      }
      if (part.hashes) part.state_hash += node_hash(nodes, i);
      if (nodes.conduct) part.heat.friction.add(nodes.friction_given[i]);
      if (nodes.holds) {
        // Crushed asperities and broken bonds stay with what friction took.
        part.add(Column::contact_friction, nodes.joint_loss[i]);
        part.add(Column::contact_pairs, -nodes.joint_loss[i]);
      }
      if (!nodes.has_friction) continue;
      part.add(Column::contact_friction, nodes.friction_heat[i]);
      part.add(Column::contact_spring, nodes.friction_stored[i]);
      part.add(Column::contact_damping, nodes.friction_damped[i]);
      part.add(Column::contact_pairs, nodes.pair_energy[i]);
    }
  };
  add_in_shares(nodes.size(), totals, add);
  const auto& records = implementation_->evaluation.records();
  // Springs hold what their overlaps say. What their forces have taken from motion beyond that went
  // with contacts that began or ended in the middle of it, or changed in place, area or direction.
  records.visit([&](const ContactRecord<Dim>& record) {
    totals.add(Column::contact_spring, record.stored);
    totals.add(Column::contact_pairs, -record.stored);
  });
  if (totals.hashes) totals.state_hash += implementation_->memory.hash(records);
}

template void ContactManager<2>::add_totals(Totals<2>&) const;
template void ContactManager<3>::add_totals(Totals<3>&) const;
template void ContactManager<2>::save_state(std::vector<StateTable>&) const;
template void ContactManager<3>::save_state(std::vector<StateTable>&) const;
template void ContactManager<2>::load_state(const StateTables&);
template void ContactManager<3>::load_state(const StateTables&);

}  // namespace brunt
