/// What the particles show: totals, checks, fields.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "core/materials/state_fields.hpp"
#include "sph/correction.hpp"
#include "sph/parallel.hpp"
#include "sph/particle_values.hpp"

namespace brunt {

namespace {

bool is_finite(Real value) { return value - value == 0; }

}  // namespace

/// What of a body's tension its artificial stress carries; nothing where tension is rounding.
template <int Dim>
void SphParticles<Dim>::add_tension(const ParticleBlock& block, std::size_t i,
                                    BodySums<Dim>& body) const {
  constexpr Real rounding = 1e-6;  // of the modulus
  const Real epsilon = block.set.options.artificial_stress;
  Real trace = 0;
  for (int d = 0; d < Dim; ++d) trace -= artificial_[i].data[d] / epsilon;
  if (!(trace > rounding * block.set.material->modulus())) return;
  body.tension.add(trace * state_[i].volume);
  body.artificial_tension.add(-dot<Dim>(points_.x[i], channel_[i].force));
}

/// True where gradients are known along some axis and not along another: in sheets and rows.
template <int Dim>
bool SphParticles<Dim>::is_in_layer(LocalIndex i) const {
  constexpr Real half = 0.5;  // of a share, which fades fast about there
  const ThinMoment<Dim>* thin = thin_of(i);
  return thin != nullptr && thin->share.minCoeff() < half && thin->share.maxCoeff() > half;
}

template <int Dim>
std::uint64_t SphParticles<Dim>::slot_hash(const ParticleBlock& block, std::size_t slot) const {
  const auto i = slot_of(block.set.particle[slot]);
  EntityHash hash(points_.id[i]);
  const auto add = [&](const auto& value, FieldUse use) {
    if constexpr (std::is_same_v<decltype(value), const Real&>) {
      if (use.hashed) hash.add(value);
    }
  };
  visit_slot(block, slot, add);
  visit_particle(state_[i], spacing_[i], artificial_of(i), add);
  if (is_total(i)) visit_total(total_[i], add);
  return hash.value();
}

/// Slots first .. last are of one body: each of their energies is summed once, and then given to
/// the body and to the columns.
template <int Dim>
void SphParticles<Dim>::add_slots(const ParticleBlock& block, std::size_t first, std::size_t last,
                                  Totals<Dim>& totals) const {
  const auto &heat = block.state.heat, &compression = block.state.compression_heat;
  const auto& expansion = block.state.expansion_work;
  const Label label = points_.body[slot_of(block.set.particle[first])];
  BodySums<Dim>* body = label < totals.bodies.size() ? &totals.bodies[label] : nullptr;
  const bool solid = block.set.material->shear > 0;
  enum { internal, plastic, compressed, stress_work, viscous, artificial, expanded, kSums };
  ExactColumns<kSums> sums;
  for (std::size_t slot = first; slot < last; ++slot) {
    const auto i = slot_of(block.set.particle[slot]);
    const auto& state = state_[i];
    if (sleeps(i)) continue;
    const Real plastic_heat = heat.empty() ? 0.0 : heat[slot] * state.start_volume;
    const Real compression_heat =
        compression.empty() ? 0.0 : compression[slot] * state.start_volume;
    const Real grown = expansion.empty() ? 0.0 : expansion[slot] * state.start_volume;
    sums.add({state.stress_work + grown - plastic_heat, plastic_heat, compression_heat,
              state.stress_work + grown, state.viscous_work,
              channel_.empty() ? 0.0 : channel_[i].work, grown});
    if (body && is_gone(i)) body->eroded.add(1), body->eroded_mass.add(points_.mass[i]);
    if (body && block.set.options.artificial_stress != 0) add_tension(block, i, *body);
    if (body && solid && !is_gone(i) && is_in_layer(static_cast<LocalIndex>(i))) {
      body->thin_mass.add(points_.mass[i]);
    }
    if (totals.hashes) totals.state_hash += slot_hash(block, slot);
  }
  const auto give = [&](Column column, int from) {
    totals.columns[slot_of(column)].add(sums.sum(from));
  };
  give(Column::internal, internal), give(Column::plastic_heat, plastic);
  totals.columns[slot_of(Column::expansion)].subtract(sums.sum(expanded));
  const bool total = block.set.options.formulation == SphFormulation::total;
  give(Column::viscosity, viscous);
  give(total ? Column::hourglass : Column::artificial_stress, artificial);
  if (points_.conducts) {
    totals.heat.plastic.add(sums.sum(plastic)), totals.heat.compression.add(sums.sum(compressed));
  }
  if (!body) return;
  body->internal.add(sums.sum(internal)), body->stress_work.add(sums.sum(stress_work));
  body->viscosity.add(sums.sum(viscous));
  if (block.set.material->eos->needs_energy()) body->absorbed.add(sums.sum(viscous));
  (total ? body->hourglass : body->artificial_stress).add(sums.sum(artificial));
  if (!points_.conducts) body->heat.add(sums.sum(plastic)), body->heat.add(sums.sum(compressed));
}

template <int Dim>
void SphParticles<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const auto& block : blocks_) {
    const auto body_of = [&](std::size_t slot) { return points_.body[block.set.particle[slot]]; };
    const std::size_t n = block.set.particle.size();
    add_in_shares(n, totals, [&](std::size_t first, std::size_t last, Totals<Dim>& part) {
      while (first < last) {
        std::size_t end = first + 1;
        while (end < last && body_of(end) == body_of(first)) ++end;
        add_slots(block, first, end, part);
        first = end;
      }
    });
  }
}

template <int Dim>
void SphParticles<Dim>::check(Real time, const std::vector<std::string>& body_names) const {
  std::optional<PhysicsFailure> first;
  const auto fail = [&](std::size_t i, const char* quantity, Real value, const char* cause) {
    if (first && first->id <= points_.id[i]) return;
    const Label body = points_.body[i];
    first = {time,
             body < body_names.size() ? body_names[body] : std::to_string(body),
             "particle " + std::to_string(points_.id[i]),
             quantity,
             value,
             cause};
    first->id = points_.id[i];
  };
  const bool single = any_single();
  for (const auto& block : blocks_) {
    for (std::size_t slot = 0; slot < block.set.particle.size(); ++slot) {
      const auto i = slot_of(block.set.particle[slot]);
      if (single && smoothing_length_[i] > SinglePairs::kLongest * unit_.length) {
        fail(i, "smoothing length [m]", smoothing_length_[i],
             "it has grown beyond what pair_precision: single tells apart: take double");
      }
      const Real density = block.set.material->density / state_[i].ratio;
      if (!(density > 0) || !is_finite(density)) {
        fail(i, "density [kg/m^3]", density,
             "the particle turned inside out within one step: its neighbours move too fast; try a "
             "smaller time.safety or a smaller spacing");
      }
      const Real stress = von_mises(block.state, slot) + block.state.pressure[slot];
      if (!is_finite(stress)) {
        fail(i, "stress [Pa]", stress,
             "look at the last frame for particles that left the body or were crushed, and try a "
             "smaller time.safety");
      }
    }
  }
  if (first) throw PhysicsError(*first);
}

/// Without particles that sleep; where all do, the fields are there, and empty.
template <int Dim>
BodyView SphParticles<Dim>::view(Label body, const WantedFields& wanted) const {
  using Shown = std::vector<std::pair<const ParticleBlock*, std::size_t>>;
  const auto shown = std::make_shared<Shown>();
  std::vector<const ParticleBlock*> blocks;  // that have any of the body
  for (const auto& block : blocks_) {
    for (std::size_t slot = 0; slot < block.set.particle.size(); ++slot) {
      if (points_.body[block.set.particle[slot]] != body) continue;
      if (blocks.empty() || blocks.back() != &block) blocks.push_back(&block);
      if (!sleeps(slot_of(block.set.particle[slot]))) shown->emplace_back(&block, slot);
    }
  }
  if (shown->size() > wanted.most) shown->resize(wanted.most);
  BodyView view;
  const std::size_t n = shown->size();
  const std::shared_ptr<const Shown> of = shown;
  const auto particle = [of](std::size_t k) {
    return slot_of((*of)[k].first->set.particle[(*of)[k].second]);
  };
  view.position.resize(3 * n), view.point_mass.resize(n), view.point_radius.resize(n);
  for_each(n, [&](std::size_t k) {
    const auto i = particle(k);
    put_values<Dim>(points_.x[i], &view.position[3 * k]);
    view.point_mass[k] = weighed_mass(i);
    view.point_radius[k] = 0.5 * spacing_[i];
  });
  if (blocks.empty()) return view;

  FieldAdder fields(wanted, view.point_fields);
  const auto add = [&](const char* name, const auto& value) {
    fields.add(name, n,
               [this, particle, value](std::size_t k) { return value(points_, particle(k)); });
  };
  using Of = const Points<Dim>&;
  add("displacement", [](Of p, std::size_t i) -> Vec<Dim> { return p.x[i] - p.x_start[i]; });
  add("velocity", [](Of p, std::size_t i) { return p.v[i]; });
  add("acceleration", [](Of p, std::size_t i) { return p.a[i]; });
  add("force", [](Of p, std::size_t i) { return p.f[i]; });
  add_state_fields(
      fields, n,
      [of](std::size_t k, const auto& value) {
        return value((*of)[k].first->state, (*of)[k].second);
      },
      [&blocks](auto member) {
        return std::none_of(blocks.begin(), blocks.end(), [member](const ParticleBlock* block) {
          return (block->state.*member).empty();
        });
      },
      !points_.conducts);
  if (points_.conducts) add("temperature", [](Of p, std::size_t i) { return p.temperature[i]; });
  fields.add("density", n, [this, of, particle](std::size_t k) {
    return (*of)[k].first->set.material->density / state_[particle(k)].ratio;
  });
  add("id", [](Of p, std::size_t i) { return static_cast<Real>(p.id[i]); });
  add("piece", [](Of p, std::size_t i) { return static_cast<Real>(p.piece[i]); });
  return view;
}

template void SphParticles<2>::add_totals(Totals<2>&) const;
template void SphParticles<3>::add_totals(Totals<3>&) const;
template void SphParticles<2>::check(Real, const std::vector<std::string>&) const;
template void SphParticles<3>::check(Real, const std::vector<std::string>&) const;
template BodyView SphParticles<2>::view(Label, const WantedFields&) const;
template BodyView SphParticles<3>::view(Label, const WantedFields&) const;

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
