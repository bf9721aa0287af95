/// Conduction among particles: temperatures live at them.
#include <algorithm>
#include <cmath>

#include "core/wide_lanes.hpp"
#include "sph/conduction.hpp"
#include "sph/pair_passes.hpp"
#include "sph/parallel.hpp"
#include "sph/particles.hpp"

namespace brunt {

/// Temperatures at time 0 and heat capacities.
template <int Dim>
void SphParticles<Dim>::set_capacities() {
  points_.conduct(std::vector<Real>(points_.x.size(), 0.0));
  for (const auto& block : blocks_) {
    for (const LocalIndex point : block.set.particle) {
      const auto i = slot_of(point);
      points_.temperature[i] = points_.start_temperature[i] = start_temperature(block.set, i);
      points_.capacity[i] =
          points_.mass[i] * block.set.material->specific_heat.at(block.set.temperature);
      if (points_.mass[i] == 0) points_.capacity[i] = 1;  // its node takes the heat
    }
  }
  vary_capacities();
}

template <int Dim>
void SphParticles<Dim>::vary_capacities() {
  std::vector<const Material*> varying;
  for (const auto& block : blocks_) {
    const Material* one = block.set.material;
    if (!one->specific_heat.varies() || block.set.particle.empty()) continue;
    if (points_.mass[block.set.particle.front()] == 0) continue;
    if (std::find(varying.begin(), varying.end(), one) == varying.end()) varying.push_back(one);
  }
  if (varying.empty()) return;
  std::vector<SpecificHeat> heats;
  heats.reserve(varying.size());
  for (const Material* one : varying) heats.push_back(one->specific_heat);
  points_.vary_capacities(std::move(heats));
  for (const auto& block : blocks_) {
    const auto at = std::find(varying.begin(), varying.end(), block.set.material);
    if (at == varying.end()) continue;
    for (const LocalIndex point : block.set.particle) {
      const auto i = slot_of(point);
      points_.vary_capacity(i, static_cast<std::int32_t>(at - varying.begin()), points_.mass[i]);
    }
  }
}

/// Conductances of the start, which the first step limit needs.
template <int Dim>
void SphParticles<Dim>::start_conduction() {
  refresh_motion();
  refresh_gradients();
  std::fill(points_.conductance.begin(), points_.conductance.end(), 0.0);
  conduct(points_.heat_rate, points_.conductance);
  std::fill(points_.heat_rate.begin(), points_.heat_rate.end(), 0.0);
}

/// What laws see of the temperature.
template <int Dim>
void SphParticles<Dim>::take_temperatures() {
  for (auto& block : blocks_) {
    if (block.state.temperature.empty()) continue;
    for_each(block.set.particle.size(), [&](std::size_t slot) {
      const auto i = slot_of(block.set.particle[slot]);
      block.state.temperature[slot] = points_.temperature[i];
    });
  }
}

/// Publishes temperature, conductivity and 1/sqrt(lambda), to copies too.
template <int Dim>
void SphParticles<Dim>::refresh_heat() {
  heat_.resize(motion_.size());
  for (const auto& block : blocks_) {
    const Varying& k = block.set.material->conductivity;
    for_each(block.set.particle.size(), [&](std::size_t slot) {
      const auto i = slot_of(block.set.particle[slot]);
      Real* record = heat_[i].data;
      record[HeatRecord::kTemperature] = points_.temperature[i];
      record[HeatRecord::kConductivity] = k.at(points_.temperature[i]);
      record[HeatRecord::kSupplement] = 1.0 / std::sqrt(completeness_[i]);
      record[HeatRecord::kVolume] = motion_[i].data[MotionRecord<Dim>::kVolume];
    });
  }
  constexpr std::size_t width = HeatRecord::kCount;
  refresh_ghosts(
      *ranks_, ghosts_, width,
      [&](std::size_t i, Real* out) { std::copy_n(heat_[i].data, width, out); },
      [&](std::size_t i, const Real* in) {
        std::copy_n(in, width, heat_[i].data);
        heat_[i].data[HeatRecord::kVolume] = motion_[i].data[MotionRecord<Dim>::kVolume];
      });
  for (std::size_t k = 0; k < images_.size(); ++k) {
    heat_[points_.x.size() + k] = heat_[images_[k].of];
  }
}

/// rate, conductance  [W], [W/K] of owned points, accumulated
template <int Dim>
void SphParticles<Dim>::conduct(std::vector<Real>& rate, std::vector<Real>& conductance) {
  refresh_heat();
  const HeatRecords<Dim> records{heat_.data(), motion_.data()};
  const bool wide = wide_lanes();
  for (auto& block : blocks_) {
    with_kernel(block.set.options.kernel, [&]<class Kernel>(Kernel) {
      for_each(block.set.particle.size(), [&](std::size_t slot) {
        const LocalIndex point = block.set.particle[slot];
        const auto i = slot_of(point);
        const auto sum = [&]<class P>(P) {
          return heat_over<Dim, Kernel, P>(records, point, rows_.template row<P>(point),
                                           rows_.weights(point));
        };
        const PairHeat sums = wide ? sum(WidePairs{}) : sum(DoublePairs{});
        const Real volume = depth_ * motion_[i].data[MotionRecord<Dim>::kVolume];
        rate[i] += volume * sums.rate;
        conductance[i] += volume * sums.conductance;
      });
    });
  }
}

template <int Dim>
void SphParticles<Dim>::give_mechanical_heat(Real inverse_dt) {
  for (auto& block : blocks_) {
    if (block.heat_given.empty()) continue;
    for_each(block.set.particle.size(), [&](std::size_t slot) {
      const auto i = slot_of(block.set.particle[slot]);
      Real heat = 0;
      for (const auto* part : {&block.state.heat, &block.state.compression_heat}) {
        if (!part->empty()) heat += (*part)[slot] * state_[i].start_volume;
      }
      points_.heat_rate[i] += (heat - block.heat_given[slot]) * inverse_dt;
      block.heat_given[slot] = heat;
    });
  }
}

template <int Dim>
void SphParticles<Dim>::add_conduction(Real dt) {
  if (!points_.conducts) return;
  if (points_.conduction_steps == 1) {
    conduct(points_.heat_rate, points_.conductance);
  } else if (points_.evaluates_conduction) {  // else they began with what is kept
    for (auto* kept : {&points_.kept_rate, &points_.kept_conductance}) {
      std::fill(kept->begin(), kept->end(), 0.0);
    }
    conduct(points_.kept_rate, points_.kept_conductance);
    points_.add_kept_conduction();
  }
  give_mechanical_heat(1.0 / dt);
  if (rides()) give_heat_to_nodes();
}

template void SphParticles<2>::set_capacities();
template void SphParticles<3>::set_capacities();
template void SphParticles<2>::start_conduction();
template void SphParticles<3>::start_conduction();
template void SphParticles<2>::take_temperatures();
template void SphParticles<3>::take_temperatures();
template void SphParticles<2>::add_conduction(Real);
template void SphParticles<3>::add_conduction(Real);

}  // namespace brunt
// Tested by tests/unit/sph/conduction_test.cpp.
