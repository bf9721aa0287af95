/// What the particles show: totals, checks, fields.
#include <algorithm>
#include <string>

#include "core/errors.hpp"
#include "sph/correction.hpp"
#include "sph/particle_values.hpp"

namespace brunt {

namespace {

bool is_finite(Real value) { return value - value == 0; }

Real von_mises(const MaterialState& state, std::size_t slot) {
  Real sum = 0;
  for (std::size_t c = 0; c < 6; ++c) {
    const Real s = state.deviator[c][slot];
    sum += (c < 3 ? 1.0 : 2.0) * (s * s);
  }
  return std::sqrt(1.5 * sum);
}

/// Fields of one body while they fill, of those that are wanted.
class FieldList {
 public:
  /// most  entities that the fields may have
  FieldList(const WantedFields& wanted, std::size_t most) : wanted_(wanted), most_(most) {}
  /// Adds values to the field of this name; the first call of a name makes it.
  void add(const char* name, std::initializer_list<Real> values) {
    if (!wanted_.has(name)) return;
    auto field = std::find_if(fields_.begin(), fields_.end(),
                              [&](const Field& f) { return f.name == name; });
    if (field == fields_.end()) {
      fields_.push_back({name, static_cast<int>(values.size()), {}});
      field = fields_.end() - 1;
      field->values.reserve(values.size() * most_);
    }
    field->values.insert(field->values.end(), values);
  }
  template <int Dim>
  void add(const char* name, const Vec<Dim>& v) {
    if constexpr (Dim == 2) {
      add(name, {v[0], v[1], 0.0});
    } else {
      add(name, {v[0], v[1], v[2]});
    }
  }
  std::vector<Field> take() { return std::move(fields_); }
  /// The fields without their values.
  void empty() {
    for (auto& field : fields_) field.values.clear();
  }

 private:
  const WantedFields& wanted_;
  std::size_t most_;
  std::vector<Field> fields_;
};

void add_material(FieldList& fields, const MaterialState& state, std::size_t slot,
                  bool has_temperature) {
  const Real p = state.pressure[slot];
  const auto& s = state.deviator;
  fields.add("stress", {s[xx][slot] - p, s[yy][slot] - p, s[zz][slot] - p, s[xy][slot], s[yz][slot],
                        s[zx][slot]});
  fields.add("pressure", {p});
  fields.add("von_mises", {von_mises(state, slot)});
  if (!state.eps_p.empty()) fields.add("eps_p", {state.eps_p[slot]});
  if (!state.strain_rate.empty()) fields.add("strain_rate", {state.strain_rate[slot]});
  if (!state.opening.empty()) {
    fields.add("plastic_volume", {state.plastic_volume[slot]});
    fields.add("opening", {state.opening[slot]});
  }
  if (!state.damage.empty()) fields.add("damage", {state.damage[slot]});
  if (!state.porosity.empty()) fields.add("porosity", {state.porosity[slot]});
  if (!state.tensile_strength.empty()) {
    fields.add("tensile_strength", {state.tensile_strength[slot]});
  }
  if (has_temperature) return;
  if (!state.temperature.empty()) fields.add("temperature", {state.temperature[slot]});
}

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
  body.artificial_tension.add(-dot<Dim>(points_.x[i], state_[i].artificial_force));
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
  visit_particle(state_[i], add);
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
              state.stress_work + grown, state.viscous_work, state.artificial_work, grown});
    if (body && block.set.options.artificial_stress != 0) add_tension(block, i, *body);
    if (body && solid && is_in_layer(static_cast<LocalIndex>(i))) {
      body->thin_mass.add(points_.mass[i]);
    }
    if (totals.hashes) totals.state_hash += slot_hash(block, slot);
  }
  const auto give = [&](Column column, int from) {
    totals.columns[slot_of(column)].add(sums.sum(from));
  };
  give(Column::internal, internal), give(Column::plastic_heat, plastic);
  totals.columns[slot_of(Column::expansion)].subtract(sums.sum(expanded));
  give(Column::viscosity, viscous), give(Column::artificial_stress, artificial);
  if (points_.conducts) {
    totals.heat.plastic.add(sums.sum(plastic)), totals.heat.compression.add(sums.sum(compressed));
  }
  if (!body) return;
  body->internal.add(sums.sum(internal)), body->stress_work.add(sums.sum(stress_work));
  body->viscosity.add(sums.sum(viscous)), body->artificial_stress.add(sums.sum(artificial));
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

template <int Dim>
template <class Fields>
void SphParticles<Dim>::add_fields(const ParticleBlock& block, std::size_t slot,
                                   Fields& fields) const {
  const auto i = slot_of(block.set.particle[slot]);
  fields.template add<Dim>("displacement", points_.x[i] - points_.x_start[i]);
  fields.template add<Dim>("velocity", points_.v[i]);
  fields.template add<Dim>("acceleration", points_.a[i]);
  fields.template add<Dim>("force", points_.f[i]);
  add_material(fields, block.state, slot, points_.conducts);
  if (points_.conducts) fields.add("temperature", {points_.temperature[i]});
  fields.add("density", {block.set.material->density / state_[i].ratio});
  fields.add("id", {static_cast<Real>(points_.id[i])});
  fields.add("piece", {static_cast<Real>(points_.piece[i])});
}

/// Without particles that sleep; where all do, the fields are there, and empty.
template <int Dim>
BodyView SphParticles<Dim>::view(Label body, const WantedFields& wanted) const {
  BodyView view;
  const auto most = std::count(points_.body.begin(), points_.body.begin() + points_.n_owned, body);
  FieldList fields(wanted, slot_of(most));
  view.position.reserve(3 * slot_of(most));
  view.point_mass.reserve(slot_of(most));
  view.point_radius.reserve(slot_of(most));
  const auto visit = [&](const auto& show) {
    for (const auto& block : blocks_) {
      for (std::size_t slot = 0; slot < block.set.particle.size(); ++slot) {
        if (points_.body[block.set.particle[slot]] == body) show(block, slot);
      }
    }
  };
  visit([&](const ParticleBlock& block, std::size_t slot) {
    const auto i = slot_of(block.set.particle[slot]);
    if (sleeps(i)) return;
    for (int d = 0; d < 3; ++d) view.position.push_back(d < Dim ? points_.x[i][d] : 0.0);
    add_fields(block, slot, fields);
    view.point_mass.push_back(weighed_mass(i));
    view.point_radius.push_back(0.5 * state_[i].spacing);
  });
  if (view.position.empty()) {
    visit([&](const ParticleBlock& block, std::size_t slot) { add_fields(block, slot, fields); });
    fields.empty();
  }
  view.point_fields = fields.take();
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
