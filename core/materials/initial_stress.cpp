#include "core/materials/initial_stress.hpp"

#include <algorithm>

#include "core/materials/initial_text.hpp"
#include "core/simd.hpp"

namespace brunt {

namespace {

constexpr Real kShare = 1e-9;  // of a stress, by which a limit may be missed: what rounding takes

/// Equivalent stress [Pa] of von Mises.
Real equivalent(const PlacedStress& at) {
  const auto& s = at.value;
  const Real p = at.pressure();
  Real square = 0;
  for (const int c : {xx, yy, zz}) square += 1.5 * (s[slot_of(c)] + p) * (s[slot_of(c)] + p);
  for (const int c : {xy, yz, zx}) square += 3 * s[slot_of(c)] * s[slot_of(c)];
  return std::sqrt(square);
}

/// One pack of points of a state that nothing strains while their volumes go from `from` to `to`.
MaterialTile still_tile(MaterialState& state, Real from, Real to, Real temperature) {
  MaterialTile tile;
  tile.state = &state;
  tile.count = kLanes;
  tile.fixed_temperature = temperature;
  for (auto& component : tile.strain) std::fill_n(component, kLanes, 0.0);
  std::fill_n(tile.ratio_old, kLanes, from);
  std::fill_n(tile.ratio, kLanes, to);
  std::fill_n(tile.viscous_work, kLanes, 0.0);
  return tile;
}

}  // namespace

PlacedStress PlacedStress::with_pressure(Real wanted) const {
  PlacedStress shifted = *this;
  const Real more = pressure() - wanted;
  for (const int c : {xx, yy, zz}) shifted.value[slot_of(c)] += more;
  return shifted;
}

PlacedStress InitialStress::at(const Vec3& position) const {
  PlacedStress at{origin + position, {}};
  for (std::size_t c = 0; c < component.size(); ++c) {
    if (component[c]) at.value[c] = component[c](at.place);
    if (std::isfinite(at.value[c])) continue;
    throw InitialStressError(body, "is no number " + at_place(at.place));
  }
  return at;
}

std::string initial_stress_problem(const Material& material) {
  if (material.strength->gives_pressure()) {
    return "'" + material.name +
           "' crushes its pores, and its pressure is not one of the volume alone: take the stress "
           "out, and load the body slowly instead";
  }
  if (material.eos->initial_energy() > 0) {
    return "the pressure of '" + material.name +
           "' is that of its energy at time 0: take the stress out, and give the equation of state "
           "another energy or density";
  }
  return {};
}

StressedStart::StressedStart(const InitialStress& stress, const Material& material,
                             Real temperature, bool adiabatic)
    : stress_(stress),
      material_(material),
      temperature_(temperature),
      rest_(material.initial_state(1, temperature, adiabatic)),
      scratch_(rest_) {
  const std::string problem = initial_stress_problem(material);
  if (!problem.empty()) throw InitialStressError(stress.body, problem);
}

/// Pressure [Pa] at V/V0 = r of a point that was compressed at once, with the energy that it has
/// got: E = s:s/4G + (p0 + p)(1 - r)/2, third order in 1 - r away from the isentrope.
Real StressedStart::compress(Real r, Real deviatoric_energy) {
  for (auto field : {&MaterialState::pressure, &MaterialState::bulk, &MaterialState::energy}) {
    const auto& from = rest_.*field;
    std::copy_n(from.begin(), std::min<std::size_t>(from.size(), kLanes),
                (scratch_.*field).begin());
  }
  alignas(32) Real work[kLanes];
  std::fill_n(work, kLanes, deviatoric_energy);
  MaterialTile tile = still_tile(scratch_, 1, r, temperature_);
  material_.eos->update(tile, work);
  return scratch_.pressure[0];
}

/// [K] of the point that is asked for
void StressedStart::take_temperature(Real temperature) {
  temperature_ = temperature;
  auto& seen = scratch_.temperature;
  std::fill_n(seen.begin(), std::min<std::size_t>(seen.size(), kLanes), temperature);
}

Real StressedStart::deviatoric_energy(const PlacedStress& at) const {
  const Real q = equivalent(at);
  return material_.shear == 0 ? 0 : q * q / (6 * material_.shear);
}

/// Newton's method on p(r), which falls with r, between bounds that close in.
Real StressedStart::ratio(const PlacedStress& at) {
  require_bearable(at);
  const Real wanted = at.pressure(), of_deviator = deviatoric_energy(at);
  Real low = std::max(0.3, material_.eos->densest_ratio()), high = 3, r = 1;
  constexpr int kMost = 200;
  for (int i = 0; i < kMost; ++i) {
    const Real excess = compress(r, of_deviator) - wanted;
    if (std::abs(excess) <= 1e-16 * material_.bulk) return r;
    (excess > 0 ? low : high) = r;
    Real next = r + excess * r / scratch_.bulk[0];
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - r) <= 1e-16) break;
    r = next;
  }
  constexpr Real kRounding = 1e-12;  // of the bulk modulus, as volumes are rounded
  if (!(std::abs(compress(r, of_deviator) - wanted) <= kRounding * material_.bulk)) {
    refuse(at, "the equation of state of '" + material_.name + "' has no pressure of " +
                   short_number(wanted) + " Pa");
  }
  return r;
}

Real StressedStart::begin(const PlacedStress& at, Real r, MaterialState& state, std::size_t k) {
  const Real of_deviator = deviatoric_energy(at);
  const Real p = compress(r, of_deviator);
  const Real mean = at.pressure();
  if (!state.temperature.empty()) take_temperature(state.temperature[k]);
  for (std::size_t c = 0; c < 6; ++c) {
    const Real s = material_.shear == 0 ? 0 : at.value[c] + (c <= zz ? mean : 0);
    state.deviator[c][k] = s;
    std::fill_n(scratch_.deviator[c].begin(), kLanes, s);
  }
  state.pressure[k] = p;
  state.bulk[k] = scratch_.bulk[0];
  if (!state.energy.empty()) state.energy[k] = scratch_.energy[0];
  require_held(at, r);
  return of_deviator + 0.5 * (material_.eos->initial_pressure() + p) * (1 - r);
}

void StressedStart::require_bearable(const PlacedStress& at) const {
  const Real q = equivalent(at), p = at.pressure();
  if (material_.shear == 0 && q > kShare * std::abs(p)) {
    refuse(at, "'" + material_.name +
                   "' is a fluid and bears no shear: write one pressure, negative, as xx, yy and "
                   "zz, and take xy, yz and zx out");
  }
  if (p < -material_.tensile_cutoff * (1 + kShare)) {
    refuse(at, "'" + material_.name + "' bears a mean tension of " +
                   short_number(material_.tensile_cutoff) + " Pa, and not " + short_number(-p) +
                   " Pa");
  }
}

/// A stress that a material can hold is one that it keeps where nothing strains it.
void StressedStart::require_held(const PlacedStress& at, Real r) {
  if (material_.shear == 0) return;
  const Real q = equivalent(at), p = scratch_.pressure[0];
  const Real size = std::max(q, std::abs(p));
  const Real flow = material_.strength->flow_stress(scratch_, 0, temperature_);
  if (q > flow * (1 + kShare)) {
    refuse(at, "the equivalent stress of " + short_number(q) + " Pa is above the flow stress of '" +
                   material_.name + "', " + short_number(flow) + " Pa");
  }
  asked_ = scratch_;
  MaterialTile tile = still_tile(asked_, r, r, temperature_);
  constexpr Real kSlowly = 1;  // [s] so long that no rate makes it stronger
  material_.update(tile, kSlowly);
  Real lost = std::abs(asked_.pressure[0] - p);
  for (std::size_t c = 0; c < 6; ++c) {
    lost = std::max(lost, std::abs(asked_.deviator[c][0] - scratch_.deviator[c][0]));
  }
  if (lost <= 1e-6 * size + 1e-12 * material_.bulk) return;
  refuse(at,
         "'" + material_.name + "' does not hold it: " + short_number(lost) + " Pa of it are lost");
}

void StressedStart::refuse(const PlacedStress& at, const std::string& why) const {
  throw InitialStressError(stress_.body, at_place(at.place) + ": " + why);
}

}  // namespace brunt
// Tested by tests/verification/initial_stress_test.cpp.
