#include "fe/finite_elements.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/errors.hpp"
#include "core/parallel/threads.hpp"
#include "fe/conduction.hpp"
#include "fe/element_check.hpp"
#include "fe/element_values.hpp"
#include "fe/erosion.hpp"
#include "fe/mass_scaling.hpp"
#include "fe/outer_facets.hpp"
#include "fe/rest.hpp"

namespace brunt {
namespace {
[[maybe_unused]] constexpr int kTilesWorthThreads = 32;  // tiles; of some 3 us each

/// True where storage goes through all elements by ascending id.
template <int Dim>
bool ids_ascend(const std::vector<ElementBlock<Dim>>& blocks) {
  for (std::size_t b = 1; b < blocks.size(); ++b) {
    if (blocks[b].id.front() < blocks[b - 1].id.back()) return false;
  }
  return true;
}

/// Masses of the nodes that are owned: sums of those of their corners, by ascending id of elements.
template <int Dim>
void set_masses(const std::vector<ElementBlock<Dim>>& blocks, const Thickness& thickness,
                std::size_t n_corners, Points<Dim>& points) {
  if (!ids_ascend(blocks)) {
    std::vector<Real> share(n_corners, 0.0);
    for (const auto& block : blocks) {
      Real* to = share.data() + block.first_corner;
      for (LocalIndex e = 0; e < block.n; ++e, to += block.corners) {
        corner_masses(block, e, points, thickness, to);
      }
    }
    std::vector<Vec<1>> sum(points.x.size(), Vec<1>::Zero());
    make_corner_gather(blocks, points.n_owned).template add<1>(share.data(), sum);
    points.mass.resize(sum.size());
    for (std::size_t k = 0; k < sum.size(); ++k) points.mass[k] = sum[k][0];
    return;
  }
  points.mass.assign(points.x.size(), 0.0);
  for (const auto& block : blocks) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      std::array<Real, kMostCorners> share;
      corner_masses(block, e, points, thickness, share.data());
      const Real* of_corner = share.data();
      for (const LocalIndex node : block.corners_of(e)) {
        if (node < points.n_owned) points.mass[node] += *of_corner;
        ++of_corner;
      }
    }
  }
}

/// Bits of the state of one element.
template <int Dim>
std::uint64_t element_hash(const ElementBlock<Dim>& block, LocalIndex e) {
  EntityHash hash(block.id[e]);
  visit_element(block, slot_of(e), [&](Real value, FieldUse use) {
    if (use.hashed) hash.add(value);
  });
  return hash.value();
}

}  // namespace

template <int Dim>
FiniteElements<Dim>::FiniteElements(Points<Dim> points, std::vector<ElementSet<Dim>> sets,
                                    Geometry geometry, Real depth)
    : points_(std::move(points)), thickness_(thickness_of(geometry, depth)) {
  held_ =
      !sets.empty() && std::all_of(sets.begin(), sets.end(), [](const auto& s) { return s.held; });
  make_blocks(std::move(sets));
  set_masses(blocks_, thickness_, n_corners_, points_);
  points_.x_start = points_.x;
  surface_.axis = axis_nodes(points_, thickness_);
  surface_.points = &points_;
  surface_.held = held_;
  surface_.facets = outer_facets(blocks_, points_, surface_.axis);
  refresh_steps();
  start_erosion();
  const auto conducts = [](const auto& block) { return block.conducts; };
  if (erosion_) order_corners();
  if (!std::any_of(blocks_.begin(), blocks_.end(), conducts)) return;
  set_capacities();
  start_conduction();
  if (blocks_.front().rigid) make_rigid();
}

template <int Dim>
FiniteElements<Dim>::~FiniteElements() = default;

template <int Dim>
void FiniteElements<Dim>::make_blocks(std::vector<ElementSet<Dim>> sets) {
  std::size_t corners = 0;
  for (ElementSet<Dim>& of_set : sets) {
    if (of_set.id.empty()) continue;
    const ElementSet<Dim> set = std::move(of_set);
    blocks_.push_back(make_block(set, points_, thickness_));
    blocks_.back().first_corner = corners;
    corners += blocks_.back().corner.size();
  }
  n_corners_ = corners;
  gather_ = {};
  if (erosion_) order_corners();
  force_chunks_ = ForceChunks<Dim>(blocks_, points_.n_owned, points_.size());
  start_volumes();
  const std::vector<Vec<Dim>> at_rest(points_.x.size(), Vec<Dim>::Zero());
  ElementStep<Dim> step = element_step(1.0);
  step.v = at_rest.data();
  for (auto& block : blocks_) scale_masses(block, step);
}

template <int Dim>
void FiniteElements<Dim>::order_corners() {
  if (gather_.offset.empty()) gather_ = make_corner_gather(blocks_, points_.n_owned);
}

template <int Dim>
AddedMass FiniteElements<Dim>::added_mass(Label body) const {
  return brunt::added_mass(blocks_, body);
}

template <int Dim>
void FiniteElements<Dim>::refresh_steps() {
  const ElementStep<Dim> step = element_step(1.0);
  for (auto& block : blocks_) {
    for_each(block.n_tiles(), kTilesWorthThreads,
             [&](int t) { block.formulation->refresh_stable_steps(block, t, step); });
  }
}

template <int Dim>
void FiniteElements<Dim>::rearrange() {
  if (!stepped_) refresh_steps();
}

template <int Dim>
ElementStep<Dim> FiniteElements<Dim>::element_step(Real dt) {
  return {points_.x.data(),  points_.v.data(), points_.x_start.data(), thickness_, dt, {},
          node_ratio_.data()};
}

template <int Dim>
void FiniteElements<Dim>::add_internal_forces(Real dt) {
  stepped_ = true;
  if (held_) return;
  if (points_.conducts) interpolate_temperatures();
  const ElementStep<Dim> common = element_step(dt);
  force_chunks_.add(
      [&](std::size_t b, int tile, const CornerSums& sums) {
        ElementBlock<Dim>& block = blocks_[b];
        ElementStep<Dim> step = common;
        if (rests(block, tile, step)) return;
        step.sums = sums;
        block.formulation->advance(block, tile, step);
        keep_rest(block, tile, step);
      },
      points_.f, points_.heat_rate);
  // Of whatever acts: contact and loads come first.
  for (const LocalIndex node : surface_.axis) points_.f[node][0] = 0;
}

template <int Dim>
StepLimit FiniteElements<Dim>::stable_step() const {
  StepLimit best;
  if (held_) return best;
  if (erosion_) best = erosion_->when_all_have_gone();
  for (const auto& block : blocks_) {
    const bool erodes = block.options.erosion.has_value();
    for (LocalIndex e = 0; e < block.n; ++e) {
      if (block.stable_step[e] > best.step) continue;
      if (erodes &&
          has_failed(block, e)) {  // it will not live to see the step; what it leaves will
        best.take(erosion_->start_step);
        continue;
      }
      // An inverted element has a step that is no number: it collapses the run at once.
      const Real step = block.stable_step[e] > 0 ? block.stable_step[e] : 0.0;
      best.take({step, "element", block.body[e], block.id[e]});
    }
  }
  return best;
}

namespace {
/// Energies [J] of elements of one body that stand one after another: each is summed once and then
/// given to the body and to the columns.
class ElementSums {
 public:
  template <int Dim>
  void add(const ElementBlock<Dim>& block, LocalIndex e) {
    sums_.add({block.stress_work[e], block.hourglass_work[e], block.viscous_work[e],
               block.state.heat.empty() ? 0.0 : plastic_heat(block, e),
               block.state.compression_heat.empty() ? 0.0 : compression_heat(block, e),
               block.state.expansion_work.empty() ? 0.0 : expansion_work(block, e)});
  }

  template <int Dim>
  void give(Label body, bool conducts, bool absorbs, Totals<Dim>& totals) {
    const ExactSum &stress_work = sums_.sum(0), &hourglass = sums_.sum(1), &viscous = sums_.sum(2);
    const ExactSum &heat = sums_.sum(3), &compression = sums_.sum(4), &expansion = sums_.sum(5);
    const auto column = [&](Column which) -> ExactSum& { return totals.columns[slot_of(which)]; };
    const auto add_to = [&](ExactSum& internal, ExactSum& of_hourglass) {
      internal.add(stress_work), internal.subtract(heat), internal.add(expansion);
      of_hourglass.add(hourglass);
    };
    add_to(column(Column::internal), column(Column::hourglass));
    column(Column::plastic_heat).add(heat);
    column(Column::viscosity).add(viscous);
    column(Column::expansion).subtract(expansion);
    if (conducts) totals.heat.plastic.add(heat), totals.heat.compression.add(compression);
    if (body >= totals.bodies.size()) return;
    BodySums<Dim>& own = totals.bodies[body];
    add_to(own.internal, own.hourglass);
    own.stress_work.add(stress_work), own.stress_work.add(expansion);
    own.viscosity.add(viscous);
    if (absorbs) own.absorbed.add(viscous);
    if (!conducts)
      own.heat.add(heat),
          own.heat.add(compression);  // else its points carry it, and what is conducted
  }

 private:
  ExactColumns<6> sums_;
};

template <int Dim>
void add_elements(const ElementBlock<Dim>& block, std::size_t first, std::size_t last,
                  Totals<Dim>& totals) {
  for (std::size_t e = first; e < last;) {
    const Label body = block.body[e];
    ElementSums sums;
    for (; e < last && block.body[e] == body; ++e) {
      if (!block.owned[e]) continue;
      sums.add(block, static_cast<LocalIndex>(e));
      if (totals.hashes) totals.state_hash += element_hash(block, static_cast<LocalIndex>(e));
    }
    sums.give(body, block.conducts, block.material->eos->needs_energy(), totals);
  }
}
}  // namespace

template <int Dim>
void FiniteElements<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const auto& block : blocks_) {
    const auto n = slot_of(block.n);
    add_in_shares(n, totals, [&](std::size_t first, std::size_t last, Totals<Dim>& part) {
      add_elements(block, first, last, part);
    });
  }
  if (erosion_) add_eroded(totals);
}

/// Elements below which a team of threads costs more than it saves.
constexpr LocalIndex kCheckWorthThreads = 2000;

template <int Dim>
void FiniteElements<Dim>::check(Real time, const std::vector<std::string>& body_names) const {
  const ElementBlock<Dim>* where = nullptr;
  LocalIndex element = 0;
  for (const auto& block : blocks_) {
    const LocalIndex n_groups = (block.n + kLanes - 1) / kLanes;
    for_each(n_groups, kCheckWorthThreads / kLanes, [&](LocalIndex group) {
      const LocalIndex first = group * kLanes;
      const unsigned sound =
          block.formulation->have_volume(block, slot_of(first), points_, thickness_);
      for (LocalIndex e = first; e < std::min(first + kLanes, block.n); ++e) {
        if ((sound >> (e - first) & 1U) != 0 && has_finite_stress(block, e)) continue;
#pragma omp critical(brunt_element_failure)
        if (where == nullptr || block.id[e] < where->id[element]) where = &block, element = e;
      }
    });
  }
  if (where == nullptr) return;
  PhysicsFailure failure = element_failure(*where, element, points_, thickness_).value();
  failure.time = time;
  failure.id = where->id[element];
  const Label body = where->body[element];
  if (body < body_names.size()) failure.body = body_names[body];
  throw PhysicsError(failure);
}

template <int Dim>
std::string FiniteElements<Dim>::advice(GlobalId entity) const {
  for (const auto& block : blocks_) {
    const auto begin = block.id.begin(), end = begin + block.n;
    const auto at = std::lower_bound(begin, end, entity);
    if (at != end && *at == entity) return distortion_advice(block);
  }
  return {};
}

template <int Dim>
std::size_t FiniteElements<Dim>::n_elements() const {
  std::size_t n = 0;
  for (const auto& block : blocks_) {
    n += slot_of(std::count(block.owned.begin(), block.owned.end(), 1));
  }
  return n;
}

template class FiniteElements<2>;
template class FiniteElements<3>;

}  // namespace brunt
