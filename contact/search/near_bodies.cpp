#include "contact/search/near_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/particle_face.hpp"

namespace brunt {

namespace {
// Of the way ahead, and of a usual face or particle: the farther bodies may come before the next
// look, the less it costs and the farther away they are near.
constexpr Real kWaysAhead = 8, kSizes = 0.5;

constexpr const char* kTable = "contact.near";
constexpr const char* kFarTable = "contact.far";

template <int Dim>
bool is_finite(const SearchBox<Dim>& box) {
  bool finite = true;
  for (std::size_t c = 0; c < Dim; ++c) {
    finite = finite && std::isfinite(box.lo[c]) && std::isfinite(box.hi[c]);
  }
  return finite;
}
}  // namespace

template <int Dim>
void NearBodies<Dim>::Reach::take(const Reach& other) {
  box.enclose(other.box);
  reach = std::max(reach, other.reach);
}

template <int Dim>
bool NearBodies<Dim>::needs_look(Real way, Real ahead) {
  come_ += way;
  return !(come_ + ahead <= allowance_);  // one that is not a number needs a look too
}

template <int Dim>
std::vector<typename NearBodies<Dim>::Reach> NearBodies<Dim>::reaches(
    const std::vector<Surface<Dim>*>& surfaces, const Entities<Dim>& entities, std::size_t n_bodies,
    const Communicator& ranks) {
  std::vector<Reach> of(n_bodies, {SearchBox<Dim>::empty(), 0});
  const auto& nodes = entities.nodes;
  // Those of other ranks are counted there.
  const auto enclose = [&](Label body, LocalIndex node) {
    const auto i = slot_of(node);
    if (nodes.point[i] < 0) return;
    const auto& points = *surfaces[slot_of(nodes.surface[i])]->points;
    const Vec<Dim>& x = points.x[slot_of(nodes.point[i])];
    of[body].box.enclose(SearchBox<Dim>::about(x, 0));
  };
  const auto widen = [&](Label body, Real by) {
    of[body].reach = std::max(of[body].reach, by + 0.5 * entities.gap(body));
  };
  for (const auto& face : entities.faces) {
    if (face.body >= n_bodies) continue;  // it may touch nothing
    for (int c = 0; c < face.n_nodes; ++c) {
      enclose(face.body, face.node[slot_of(c)]);
    }
    widen(face.body, face.rigid() ? 0.0 : face.depth);
  }
  for (const auto& one : entities.particles) {
    if (one.body >= n_bodies) continue;
    enclose(one.body, one.node);
    widen(one.body, kOpenDepthRadii * one.radius);
  }
  ranks.reduce_all(std::span(of), [](Reach& into, const Reach& from) { into.take(from); });
  return of;
}

template <int Dim>
bool NearBodies<Dim>::look(const std::vector<Surface<Dim>*>& surfaces,
                           const Entities<Dim>& entities, const PairTable& pairs, Real ahead,
                           const Communicator& ranks) {
  allowance_ = std::max(kWaysAhead * ahead, kSizes * entities.size);
  come_ = 0;
  std::size_t n_bodies = 0;
  for (const auto& [a, b] : pairs.pairs()) n_bodies = std::max<std::size_t>(n_bodies, b + 1);
  std::vector<char> near(n_bodies, 0);
  const auto of = reaches(surfaces, entities, n_bodies, ranks);
  std::vector<SearchBox<Dim>> boxes;
  std::vector<Label> body;
  bool all = !std::isfinite(allowance_);
  for (std::size_t b = 0; b < n_bodies; ++b) {
    SearchBox<Dim> box = of[b].box;
    if (box.lo[0] > box.hi[0]) continue;  // it shows nothing
    all = all || !is_finite(box);         // what is not a number has no place
    for (std::size_t c = 0; c < Dim; ++c) {
      box.lo[c] -= of[b].reach + 0.5 * allowance_, box.hi[c] += of[b].reach + 0.5 * allowance_;
    }
    boxes.push_back(box), body.push_back(static_cast<Label>(b));
    near[b] = pairs.find(body.back(), body.back()).has_value();
  }
  const auto touch = [&](LocalIndex i, LocalIndex j) {
    return pairs.find(body[slot_of(i)], body[slot_of(j)]).has_value();
  };
  if (all) {
    near.clear();
  } else {
    for (const auto& [i, j] : overlapping_pairs<Dim>(boxes, touch, SearchMode::grid)) {
      near[body[slot_of(i)]] = near[body[slot_of(j)]] = 1;
    }
  }
  if (std::find(near.begin(), near.end(), 0) == near.end()) near.clear();
  const bool changed = near != near_;
  near_ = std::move(near);
  return changed;
}

template <int Dim>
void NearBodies<Dim>::save_state(std::vector<StateTable>& tables) const {
  std::vector<GlobalId> far;
  for (std::size_t b = 0; b < near_.size(); ++b) {
    if (near_[b] == 0) far.push_back(b);
  }
  save_row(
      kTable, [&](auto& row) { row(allowance_), row(come_), row(near_.size()); }, tables);
  save_rows(
      kFarTable, far.size(), [&](std::size_t k) { return far[k]; },
      [&](auto& row, std::size_t k) { row(far[k]); }, tables);
}

template <int Dim>
void NearBodies<Dim>::load_state(const StateTables& tables) {
  std::size_t n_bodies = 0;
  load_row(
      kTable, [&](auto& row) { row(allowance_), row(come_), row(n_bodies); }, tables);
  near_.assign(n_bodies, 1);
  if (n_bodies == 0) return;
  const StateRows& far = tables.rows(kFarTable);
  for (std::size_t b = 0; b < n_bodies; ++b) near_[b] = far.has(b) ? 0 : 1;
}

template class NearBodies<2>;
template class NearBodies<3>;

}  // namespace brunt
