/// Elements of a group that go, with what becomes of their nodes and of what they covered.
#include <algorithm>

#include "core/parallel/packing.hpp"
#include "fe/conduction.hpp"
#include "fe/erosion.hpp"
#include "fe/finite_elements.hpp"
#include "fe/last_work.hpp"
#include "fe/outer_facets.hpp"
#include "fe/part.hpp"

namespace brunt {
namespace {

/// What every rank has found, by ascending id, on every rank.
template <class One>
std::vector<One> of_every_rank(const std::vector<One>& mine, const Communicator* ranks) {
  std::vector<One> all;
  if (ranks == nullptr || ranks->alone()) {
    all = mine;
  } else {
    for (const Bytes& bytes : ranks->all_gather((Packer() << mine).take())) {
      std::vector<One> some;
      Unpacker(bytes) >> some;
      all.insert(all.end(), some.begin(), some.end());
    }
  }
  std::sort(all.begin(), all.end(), [](const One& a, const One& b) { return a.id < b.id; });
  return all;
}

template <class One>
void merge_by_id(const std::vector<One>& more, std::vector<One>& all) {
  all.insert(all.end(), more.begin(), more.end());
  std::sort(all.begin(), all.end(), [](const One& a, const One& b) { return a.id < b.id; });
}

/// Ids of the facets of the first that are not in the second; both ascend.
template <int Dim>
std::vector<GlobalId> missing_in(const std::vector<Facet<Dim>>& first,
                                 const std::vector<Facet<Dim>>& second) {
  std::vector<GlobalId> missing;
  auto at = second.begin();
  for (const auto& facet : first) {
    while (at != second.end() && at->id < facet.id) ++at;
    if (at == second.end() || at->id != facet.id) missing.push_back(facet.id);
  }
  return missing;
}

/// ids  of facets, ascending as they do
template <int Dim>
void mark_born(const std::vector<GlobalId>& ids, std::vector<Facet<Dim>>& facets) {
  for (auto& facet : facets) facet.born = std::binary_search(ids.begin(), ids.end(), facet.id);
}
}  // namespace

template <int Dim>
void FiniteElements<Dim>::start_erosion() {
  if (held_) return;
  erosion_ = erosion_at_start(blocks_, points_, surface_);
  if (!erosion_) return;
  surface_.erodes = true;
  for (const auto& [body, to] : erosion_->to) {
    if (to != ErodeTo::nothing) surface_.may_free.push_back(body);
  }
}

template <int Dim>
void FiniteElements<Dim>::erode(Real dt) {
  if (!erosion_) return;
  clear_born();
  converted_.clear();
  any_converted_ = false;
  auto mine = failed_elements();
  if (ranks_ != nullptr && !ranks_->any(!mine.empty())) return;
  const auto going = of_every_rank(mine, ranks_);
  if (going.empty()) return;
  std::vector<Vec<Dim>> x_before = points_.x;
  for (std::size_t i = 0; i < x_before.size(); ++i) x_before[i] -= dt * points_.v[i];
  surface_.gone = let_points_go(going, dt);
  find_last_work(x_before, dt, mine);
  merge_by_id(of_every_rank(mine, ranks_), erosion_->eroded);
  convert(going, x_before);
  const VolumesBefore volumes{gather_.offset, start_volume_, node_ratio_};
  rebuild(true);
  keep_ratios(volumes, x_before);
  free_points(true);
}

/// What came to the surface in the last step is like all else by now.
template <int Dim>
void FiniteElements<Dim>::clear_born() {
  if (!erosion_->any_born) return;
  for (auto* facets : {&surface_.facets, &erosion_->facets}) {
    for (auto& facet : *facets) facet.born = false;
  }
  for (auto& particle : surface_.particles) particle.born = false;
  surface_.died.clear();
  erosion_->any_born = false;
}

/// Of the elements that are counted here.
template <int Dim>
std::vector<ErodedElement> FiniteElements<Dim>::failed_elements() const {
  std::vector<ErodedElement> failed;
  for (const auto& block : blocks_) {
    if (!block.options.erosion) continue;
    const bool by_shape = block.options.erosion->when.inverted;
    unsigned sound = ~0U;  // one bit each of the four elements about e
    for (LocalIndex e = 0; e < block.n; ++e) {
      const int lane = e % kLanes;
      if (by_shape && lane == 0) {
        sound = block.formulation->have_volume(block, slot_of(e), points_, thickness_);
      }
      if (!block.owned[e]) continue;
      if ((sound >> lane & 1U) != 0 && !has_failed(block, e)) continue;
      auto& one = failed.emplace_back();
      one.id = block.id[e], one.body = block.body[e], one.conducts = block.conducts;
      one.mass = block.mass[e];
      one.heat = plastic_heat(block, e), one.compression = compression_heat(block, e);
      one.hourglass_work = block.hourglass_work[e], one.viscous_work = block.viscous_work[e];
      one.energy = block.stress_work[e] - one.heat;
    }
  }
  std::sort(failed.begin(), failed.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return failed;
}

/// Takes their mass and motion from points about which nothing is left, where the deck lets them
/// go: before the last work of elements is found, which does none on them. Returns the owned ones
/// of all that have gone so far.
template <int Dim>
std::vector<LocalIndex> FiniteElements<Dim>::let_points_go(const std::vector<ErodedElement>& going,
                                                           Real dt) {
  std::vector<std::int64_t> left(points_.owned());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = gather_.offset[i + 1] - gather_.offset[i];
  for (const auto& block : blocks_) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      if (!is_among(going, block.id[e])) continue;
      for (const LocalIndex node : block.corners_of(e)) {
        if (node < points_.n_owned) --left[node];
      }
    }
  }
  std::vector<GonePoint> mine;
  for (LocalIndex i = 0; i < points_.n_owned; ++i) {
    if (left[i] > 0 || points_.mass[i] == 0) continue;
    const auto to = erosion_->to.find(points_.body[i]);
    if (to == erosion_->to.end() || to->second != ErodeTo::nothing) continue;
    // m v(n-1/2) . v(n+1/2)/2, as the ledger has it, with v at n+1/2 by now; and what changes of
    // the step have left in it.
    const Vec<Dim> before_step = points_.v[i] - dt * points_.a[i];
    const Real kinetic = 0.5 * points_.mass[i] * before_step.dot(points_.v[i]);
    mine.push_back({points_.id[i], kinetic + points_.integration[i]});
    points_.mass[i] = points_.integration[i] = 0;
    points_.a[i].setZero(), points_.f[i].setZero();
  }
  merge_by_id(of_every_rank(mine, ranks_), erosion_->gone);
  std::vector<LocalIndex> owned;
  for (const auto& one : erosion_->gone) {
    const LocalIndex here = points_.find(one.id);
    if (here < 0) continue;
    points_.v[here].setZero();
    if (here < points_.n_owned) owned.push_back(here);
  }
  return owned;
}

/// The forces at n of elements that go act in the first half of the step: what they take in it is
/// found by a step that is as much shorter as to reach no state in which a law has no answer, of
/// which the new forces' part is taken out again.
/// x_before  [m] by point, x(n);  mine  their energies, in and out
template <int Dim>
void FiniteElements<Dim>::find_last_work(const std::vector<Vec<Dim>>& x_before, Real dt,
                                         std::vector<ErodedElement>& mine) {
  constexpr Real kPart = 1.0 / 1024;
  const Real part = kPart * dt;
  std::vector<Vec<Dim>> x = x_before;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += part * points_.v[i];
  for (const auto& block : blocks_) {
    const auto set = set_of(block, mine);
    if (set.id.empty()) continue;
    points_.x.swap(points_.x_start);
    auto last = make_block(set, points_, thickness_);
    points_.x.swap(points_.x_start);
    copy_state(block, last);
    for (auto* books : {&last.stress_work, &last.hourglass_work, &last.viscous_work}) {
      std::fill(books->begin(), books->end(), 0.0);
    }
    ElementStep<Dim> step = element_step(part);
    step.x = x.data();
    const auto taken = taken_in_step(last, step);
    for (LocalIndex e = 0; e < last.n; ++e)
      place_among(mine, last.id[e])->energy += taken[e] / kPart;
  }
}

/// Blocks, facets and sums of nodes anew, of the elements that are left.
/// with_state  elements keep theirs; else they are as at time 0, until a state is loaded
template <int Dim>
void FiniteElements<Dim>::rebuild(bool with_state) {
  const auto left = erosion_->left();
  erosion_->n_alive = 0;
  for (const auto& block : left) erosion_->n_alive += slot_of(block.n);
  erosion_->any_born = with_state;
  auto sets = elements_of(left, erosion_->owner, erosion_->rank);
  auto facets = outer_facets(left, erosion_->start, erosion_->axis);
  if (with_state) {
    surface_.died = missing_in(erosion_->facets, facets);
    mark_born(missing_in(facets, erosion_->facets), facets);
  }
  surface_.facets = facets_of(facets, sets, erosion_->place, points_.n_owned);
  erosion_->facets = std::move(facets);
  surface_.changed = true;
  renumber_corners(erosion_->place, sets);
  const auto old = std::move(blocks_);
  blocks_.clear();
  points_.x.swap(points_.x_start);
  make_blocks(std::move(sets));
  points_.x.swap(points_.x_start);
  if (!corner_heat_.empty()) corner_heat_.assign(n_corners_ * 2, 0.0);
  element_of_facet_.clear();
  if (!with_state) return;
  // Blocks without an element are left out: they come in the order of those that were there.
  auto from = old.begin();
  for (auto& block : blocks_) {
    while (!std::binary_search(from->id.begin(), from->id.begin() + from->n, block.id[0])) ++from;
    copy_state(*from, block);
  }
}

/// Owned points that no element holds any more, and that have not gone, go on as particles.
/// time_goes_on  false: they did so before, and a state is loaded
template <int Dim>
void FiniteElements<Dim>::free_points(bool time_goes_on) {
  std::vector<FreePoint> own(points_.owned());
  for (std::size_t i = 0; i < erosion_->place.size(); ++i) {
    const LocalIndex here = erosion_->place[i];
    if (here >= 0 && here < points_.n_owned) own[here] = erosion_->free[i];
  }
  const auto before = std::move(surface_.particles);
  surface_.particles.clear();
  surface_.particle_material.assign(points_.owned(), {});
  for (LocalIndex i = 0; i < points_.n_owned; ++i) {
    if (gather_.offset[i + 1] > gather_.offset[i] || points_.mass[i] == 0) continue;
    if (erosion_->to.count(points_.body[i]) == 0) continue;
    const auto at = std::lower_bound(
        before.begin(), before.end(), i,
        [](const SurfaceParticle& one, LocalIndex point) { return one.point < point; });
    const bool known = at != before.end() && at->point == i;
    surface_.add_particle(i, own[i].radius,
                          {own[i].modulus, own[i].conductivity, own[i].effusivity},
                          time_goes_on && !known);
    surface_.particle_material[i] = own[i].material;
  }
}

/// Plastic heat and work of hourglass control and viscosity stay where they were booked; the rest
/// is what has left.
template <int Dim>
void FiniteElements<Dim>::add_eroded(Totals<Dim>& totals) const {
  if (ranks_ != nullptr && !ranks_->is_root()) return;
  for (const auto& one : erosion_->eroded) {
    totals.add(Column::eroded, one.energy);
    totals.add(Column::plastic_heat, one.heat);
    totals.add(Column::hourglass, one.hourglass_work);
    totals.add(Column::viscosity, one.viscous_work);
    if (one.conducts) totals.heat.plastic.add(one.heat);
    if (one.conducts) totals.heat.compression.add(one.compression);
    EntityHash hash(one.id);
    hash.add(one.energy);
    totals.state_hash += hash.value();
    if (one.body >= totals.bodies.size()) continue;
    auto& body = totals.bodies[one.body];
    body.hourglass.add(one.hourglass_work), body.viscosity.add(one.viscous_work);
    body.stress_work.add(one.energy), body.stress_work.add(one.heat);
    body.eroded.add(1), body.eroded_mass.add(one.mass);
    if (!one.conducts) body.heat.add(one.heat), body.heat.add(one.compression);
  }
  for (const auto& one : erosion_->gone) totals.add(Column::eroded, one.energy);
}

namespace {
constexpr const char* kEroded = "eroded";
constexpr const char* kGone = "eroded.points";

template <class Row, class One>
void visit_eroded(Row& row, One& one) {
  row(one.mass), row(one.energy), row(one.heat), row(one.compression);
  row(one.hourglass_work), row(one.viscous_work);
}

}  // namespace

/// The root has what all have of those that are gone.
template <int Dim>
void FiniteElements<Dim>::save_eroded(std::vector<StateTable>& tables) const {
  if (ranks_ != nullptr && !ranks_->is_root()) return;
  const auto& eroded = erosion_->eroded;
  save_rows(
      kEroded, eroded.size(), [&](std::size_t k) { return eroded[k].id; },
      [&](auto& row, std::size_t k) { visit_eroded(row, eroded[k]); }, tables);
  const auto& gone = erosion_->gone;
  save_rows(
      kGone, gone.size(), [&](std::size_t k) { return gone[k].id; },
      [&](auto& row, std::size_t k) { row(gone[k].energy); }, tables);
}

/// Makes the group what it is without the elements that a state has lost. Points are loaded.
template <int Dim>
void FiniteElements<Dim>::load_eroded(const StateTables& tables) {
  const bool was_whole = erosion_->eroded.empty();
  erosion_->eroded.clear(), erosion_->gone.clear();
  converted_.clear();
  any_converted_ = false;
  clear_born();
  if (tables.has(kEroded)) {
    const auto& rows = tables.rows(kEroded);
    for (const auto& block : erosion_->blocks) {
      for (LocalIndex e = 0; e < block.n; ++e) {
        if (!rows.has(block.id[e])) continue;
        auto& one = erosion_->eroded.emplace_back();
        one.id = block.id[e], one.body = block.body[e], one.conducts = block.conducts;
        StateReader row(rows.row(one.id, slot_of(rows.width())));
        visit_eroded(row, one);
      }
    }
    std::sort(erosion_->eroded.begin(), erosion_->eroded.end(),
              [](const auto& a, const auto& b) { return a.id < b.id; });
  }
  if (was_whole && erosion_->eroded.empty()) return;
  if (tables.has(kGone)) {
    const auto& rows = tables.rows(kGone);
    for (const GlobalId id : erosion_->start.id) {
      if (!rows.has(id)) continue;
      auto& one = erosion_->gone.emplace_back();
      one.id = id;
      StateReader row(rows.row(id, 1));
      row(one.energy);
    }
    merge_by_id<GonePoint>({}, erosion_->gone);
  }
  surface_.gone.clear();
  for (const auto& one : erosion_->gone) {
    const LocalIndex here = points_.find(one.id);
    if (here >= 0 && here < points_.n_owned) surface_.gone.push_back(here);
  }
  rebuild(false);
  free_points(false);
}

template void FiniteElements<2>::start_erosion();
template void FiniteElements<3>::start_erosion();
template void FiniteElements<2>::erode(Real);
template void FiniteElements<3>::erode(Real);
template void FiniteElements<2>::add_eroded(Totals<2>&) const;
template void FiniteElements<3>::add_eroded(Totals<3>&) const;
template void FiniteElements<2>::save_eroded(std::vector<StateTable>&) const;
template void FiniteElements<3>::save_eroded(std::vector<StateTable>&) const;
template void FiniteElements<2>::load_eroded(const StateTables&);
template void FiniteElements<3>::load_eroded(const StateTables&);

}  // namespace brunt
// Tested by tests/unit/fe/erosion_test.cpp.
