#include "app/watch/energy_watch.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
/// What a body holds [J] below this part of the scene's largest energy does not matter.
constexpr Real kWorthTelling = 1e-2;
/// A body's energy is measured against this part of the scene's at least.
constexpr Real kPartOfScene = 0.1;

/// Columns of the scene that hold nothing: what they give is made.
constexpr std::array<std::pair<Column, EnergySource>, 4> kTakers = {{
    {Column::contact_pairs, EnergySource::contact_pairs},
    {Column::contact_damping, EnergySource::contact_damping},
    {Column::contact_friction, EnergySource::contact_friction},
    {Column::damping, EnergySource::damping},
}};

constexpr std::array<Column, 7> kPhysical = {
    Column::kinetic,          Column::internal, Column::plastic_heat, Column::contact_spring,
    Column::contact_friction, Column::damping,  Column::boundary,
};
}  // namespace

std::string_view source_name(EnergySource source) {
  static constexpr std::array<std::string_view, kEnergySources> names = {
      "artificial_stress", "integration",     "hourglass",        "viscosity", "stress_work",
      "contact.pairs",     "contact.damping", "contact.friction", "damping"};
  return names[slot_of(source)];
}

template <int Dim>
EnergyLook energy_look(const Totals<Dim>& totals, const std::vector<Label>& sum_of_body) {
  EnergyLook look;
  for (std::size_t c = 0; c < look.columns.size(); ++c) look.columns[c] = totals.columns[c].value();
  look.bodies.resize(totals.bodies.size());
  for (std::size_t b = 0; b < totals.bodies.size(); ++b) {
    const auto& body = totals.bodies[b];
    auto& all = look.bodies[sum_of_body.empty() ? b : sum_of_body[b]];
    all.kinetic += body.kinetic.value(), all.stress_work += body.stress_work.value();
    all.hourglass += body.hourglass.value(), all.viscosity += body.viscosity.value();
    all.artificial_stress += body.artificial_stress.value();
    all.integration += body.integration.value(), all.absorbed += body.absorbed.value();
  }
  return look;
}

Real EnergyWatch::largest(const EnergyLook& look) const {
  Real largest = largest_;
  for (const Column column : kPhysical) largest = std::max(largest, std::fabs(look.column(column)));
  return largest;
}

void EnergyWatch::keep(const EnergyLook& look) {
  largest_ = largest(look);
  for (std::size_t k = 0; k < kTakers.size(); ++k) {
    taken_[k] = std::max(taken_[k], look.column(kTakers[k].first));
  }
  for (std::size_t b = 0; b < most_.size(); ++b) {
    const auto& now = look.bodies[b];
    most_[b].viscosity = std::max(most_[b].viscosity, now.viscosity);
    most_[b].integration = std::max(most_[b].integration, now.integration);
    most_[b].stress_work = std::max(most_[b].stress_work, now.stress_work);
    most_[b].kinetic = std::max(most_[b].kinetic, now.kinetic);
  }
}

std::vector<CreatedEnergy> EnergyWatch::created(const EnergyLook& look) const {
  std::vector<CreatedEnergy> all;
  const auto add = [&](EnergySource source, std::optional<Label> body, Real energy) {
    if (energy > 0) all.push_back({source, body, energy});
  };
  for (std::size_t b = 0; b < most_.size(); ++b) {
    const auto label = static_cast<Label>(b);
    const auto& body = look.bodies[b];
    add(EnergySource::artificial_stress, label, -body.artificial_stress);
    add(EnergySource::integration, label, most_[b].integration - body.integration);
    add(EnergySource::hourglass, label, -body.hourglass);
    add(EnergySource::viscosity, label, most_[b].viscosity - body.viscosity);
    add(EnergySource::stress_work, label, -(body.stress_work + std::max(body.absorbed, 0.0)));
  }
  for (std::size_t k = 0; k < kTakers.size(); ++k) {
    add(kTakers[k].second, {}, taken_[k] - look.column(kTakers[k].first));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.energy > b.energy; });
  return all;
}

CreatedShare EnergyWatch::share(const EnergyLook& look,
                                const std::vector<CreatedEnergy>& created) const {
  const Real all = largest(look);
  if (!(all > 0)) return {};
  CreatedShare worst{sum(created) / all, {}};
  std::vector<Real> of_body(most_.size(), 0.0);
  for (const auto& one : created) {
    if (one.body) of_body[*one.body] += one.energy;
  }
  for (std::size_t b = 0; b < most_.size(); ++b) {
    const auto& now = look.bodies[b];
    const Real own = std::max(
        {most_[b].kinetic, most_[b].stress_work, now.kinetic, now.stress_work, kPartOfScene * all});
    if (of_body[b] / own > worst.share) worst = {of_body[b] / own, static_cast<Label>(b)};
  }
  return worst;
}

Real EnergyWatch::hourglass_share(const EnergyLook& look, Label body) const {
  const auto& own = look.bodies[body];
  if (!(own.hourglass > kWorthTelling * largest(look))) return 0;
  const Real work = std::max(most_[body].stress_work, own.stress_work);
  return work > 0 ? own.hourglass / work : kInfinity;
}

Real sum(const std::vector<CreatedEnergy>& created) {
  Real all = 0;
  for (const auto& one : created) all += one.energy;
  return all;
}

template EnergyLook energy_look(const Totals<2>&, const std::vector<Label>&);
template EnergyLook energy_look(const Totals<3>&, const std::vector<Label>&);

}  // namespace brunt
