#include "contact/search/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/particle_face.hpp"
#include "core/parallel/threads.hpp"

namespace brunt {

namespace {
// Work in units of one rejected candidate, for the choice of the skin.
constexpr Real kWorkPerEntity = 15;
constexpr Real kWorkPerListed = 5;
// Bounds of a chosen skin, in sizes.
constexpr Real kThinnest = 0.02, kFirst = 0.2, kWidest = 0.5;

/// The bounds and a largest value over all ranks.
template <int Dim>
MotionBounds<Dim> over_ranks(const Communicator& ranks, const MotionBounds<Dim>& mine,
                             Real& largest) {
  if (ranks.alone()) return mine;
  std::array<Real, 4 * Dim + 1> extremes;
  for (int c = 0; c < Dim; ++c) {
    const std::array<Real, 4> one = {-mine.u_min[c], mine.u_max[c], -mine.v_min[c], mine.v_max[c]};
    std::copy(one.begin(), one.end(), extremes.begin() + 4 * c);
  }
  extremes.back() = largest;
  extremes = ranks.reduce(extremes, [](auto& a, const auto& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i] > a[i] ? b[i] : a[i];
  });
  MotionBounds<Dim> all;
  for (int c = 0; c < Dim; ++c) {
    const Real* one = extremes.data() + 4 * c;
    all.u_min[c] = -one[0], all.u_max[c] = one[1];
    all.v_min[c] = -one[2], all.v_max[c] = one[3];
  }
  largest = extremes.back();
  return all;
}

/// Particles whose boxes meet the box around all faces: no others are compared, with faces or with
/// each other. A body far from all walls costs one comparison a particle.
/// box_of  the box [m] of particle p of n;  faces  not empty
template <int Dim, class BoxOf>
std::vector<LocalIndex> particles_near(std::size_t n, BoxOf box_of,
                                       std::span<const SearchBox<Dim>> faces,
                                       std::vector<SearchBox<Dim>>& boxes) {
  SearchBox<Dim> all = faces[0];
  for (const auto& box : faces) all.enclose(box);
  std::vector<LocalIndex> near;
  for (std::size_t p = 0; p < n; ++p) {
    const SearchBox<Dim> box = box_of(p);
    if (!box.meets(all)) continue;
    near.push_back(static_cast<LocalIndex>(p));
    boxes.push_back(box);
  }
  return near;
}

}  // namespace

template <int Dim>
void Candidates<Dim>::build(Entities<Dim>& entities, const PairTable& pairs, Real longest,
                            ContactImports<Dim>& imports) {
  const auto& nodes = entities.nodes;
  const Communicator& ranks = imports.ranks();
  choose_skin(entities);
  skin_ = ranks.max(skin_);
  auto bounds = bounds_of<Dim>(nodes.size(), [&](std::size_t i, MotionBounds<Dim>& part) {
    part.take(Vec<Dim>::Zero(), nodes.v[i]);
  });
  Real none = 0;
  bounds = over_ranks(ranks, bounds, none);
  speed_ = bounds.relative_speed();
  // A tenth more, so that speeds and steps that grow a little need no new lists.
  speed_reach_ = entities.any_particles && std::isfinite(longest) ? 1.1 * speed_ * longest : 0.0;
  face_reach_ = 1.1 * way_of_faces(entities);
  if (!ranks.alone()) {
    ImportBoxes<Dim> boxes;
    for (std::size_t f = 0; f < entities.faces.size(); ++f) {
      boxes.offered.push_back(box_of_face(entities, f));
      // Faces that are held or have a prescribed motion have larger ids than those that are
      // partitioned and do not: they are the lower ones of faces that stand everywhere alone.
      const auto& face = entities.faces[f];
      if (face.owned && !face.rigid() && !face.everywhere)
        boxes.wanted.push_back(boxes.offered.back());
    }
    for (std::size_t p = 0; p < entities.particles.size(); ++p) {
      boxes.wanted.push_back(box_of_particle(entities, p));
      if (!pairs.particles_meet(entities.particles[p].body)) continue;
      boxes.particle.push_back(static_cast<LocalIndex>(p));
      boxes.of_particles.push_back(box_beside_particles(entities, p));
    }
    boxes.particles_meet = pairs.particles_meet();
    imports.renew(boxes, entities);
  }
  find_faces(entities, pairs);
  std::vector<LocalIndex> row_particles, row_faces;
  find_particles(entities, pairs, row_particles, row_faces);
  find_pairs(entities, pairs);
  std::vector<char> in_lists(entities.faces.size(), 0);
  for (const auto& pair : face_pairs_)
    in_lists[slot_of(pair.lower)] = in_lists[slot_of(pair.upper)] = 1;
  for (const LocalIndex f : row_faces) in_lists[slot_of(f)] = 1;
  entities.mark_planes(in_lists);
  find_clearances(entities, row_particles, row_faces);
  moved_ = warped_ = turned_ = 0;
  steps_ = 0;
  ++builds_;
}

template <int Dim>
Real Candidates<Dim>::way_of_faces(const Entities<Dim>& entities) const {
  const Real way = speed_ * entities.longest_step;
  // Nearer than that nothing bounds the step; what has no bound limits nothing.
  const Real least = FaceBarrier::before(entities.least_limit).least_way();
  return std::isfinite(way) && way > least ? way : 0.0;
}

template <int Dim>
SearchBox<Dim> Candidates<Dim>::box_of_face(const Entities<Dim>& entities, std::size_t face) const {
  if (!entities.is_near(entities.faces[face].body)) return SearchBox<Dim>::empty();
  const auto& plane = entities.planes[face];
  const Real depth = entities.faces[face].rigid() ? entities.deepest : entities.faces[face].depth;
  const Real gap = entities.gap(entities.faces[face].body);
  // All that an evaluation may look at (Entities::reaches), and what bounds the step by its speed.
  const Real reach = std::max(kReachPerDepth * depth, 0.5 * (depth + face_reach_));
  return finite_box<Dim>(
      box_of(plane, reach + 0.5 * gap + kReachPerWarp * plane.warp + 0.5 * skin_));
}

template <int Dim>
SearchBox<Dim> Candidates<Dim>::box_of_particle(const Entities<Dim>& entities,
                                                std::size_t particle) const {
  const auto& one = entities.particles[particle];
  if (!entities.is_near(one.body)) return SearchBox<Dim>::empty();
  const Vec<Dim>& x = entities.nodes.x[slot_of(one.node)];
  const Real ahead = std::max(speed_reach_, entities.gap(one.body));
  const Real deepest = entities.any_open ? kOpenDepthRadii : kDepthRadii;
  const Real reach = std::max(deepest * one.radius, one.radius + ahead);
  return finite_box<Dim>(SearchBox<Dim>::about(x, reach + 0.5 * skin_));
}

/// Beginnings of rows; the particle of each, and the faces of all.
template <int Dim>
void Candidates<Dim>::find_particles(const Entities<Dim>& entities, const PairTable& pairs,
                                     std::vector<LocalIndex>& row_particles,
                                     std::vector<LocalIndex>& row_faces) {
  const auto& near_faces = entities.near_faces;
  const auto& particles = entities.particles;
  starts_.clear();
  if (particles.empty() || near_faces.empty()) return;
  std::vector<SearchBox<Dim>> face_boxes(near_faces.size()), boxes;
  for (std::size_t k = 0; k < near_faces.size(); ++k) {
    const auto& plane = entities.planes[slot_of(near_faces[k])];
    face_boxes[k] = finite_box<Dim>(box_of(plane, kReachPerWarp * plane.warp + 0.5 * skin_));
  }
  const auto particle_box = [&](std::size_t p) {
    // Its owner looks at faces: it meets none.
    return particles[p].owned ? box_of_particle(entities, p) : SearchBox<Dim>::empty();
  };
  const auto near = particles_near<Dim>(particles.size(), particle_box, face_boxes, boxes);
  const std::size_t n = near.size();
  boxes.insert(boxes.end(), face_boxes.begin(), face_boxes.end());
  const auto admits = [&](LocalIndex i, LocalIndex j) {
    const auto p = slot_of(i), f = slot_of(j);
    if (p >= n || f < n) return false;
    const auto& face = entities.faces[slot_of(near_faces[f - n])];
    const auto& particle = particles[slot_of(near[p])];
    return !(particle.body == face.body && particle.piece == face.piece) &&
           !pairs.of(particle.body, face.body).ignore;
  };
  for (const auto& [k, j] : overlapping_pairs<Dim>(boxes, admits, mode_)) {
    const LocalIndex i = near[slot_of(k)];
    if (row_particles.empty() || row_particles.back() != i) {
      starts_.push_back(row_faces.size());
      row_particles.push_back(i);
    }
    row_faces.push_back(near_faces[slot_of(j) - n]);
  }
  starts_.push_back(row_faces.size());
}

template <int Dim>
void Candidates<Dim>::find_clearances(const Entities<Dim>& entities,
                                      const std::vector<LocalIndex>& row_particles,
                                      const std::vector<LocalIndex>& row_faces) {
  clearances_.resize(row_faces.size());
  row_clearances_.resize(row_particles.size());
  for_each(row_clearances_.size(), kWorthThreads, [&](std::size_t row) {
    const auto& particle = entities.particles[slot_of(row_particles[row])];
    for (std::size_t i = starts_[row]; i < starts_[row + 1]; ++i) {
      const Clearance one = clearance_of(entities, particle, slot_of(row_faces[i]));
      clearances_.set(i, one);
      if (i == starts_[row]) row_clearances_[row] = one;
      row_clearances_[row].take(one);
    }
    row_clearances_[row].entity = row_particles[row];
  });
}

template <int Dim>
ParticleRows Candidates<Dim>::particle_rows(const PairTable& pairs, Real longest) const {
  const ClearanceLoss loss{moved_ + speed_ * longest, std::sqrt(Real{Dim}) * moved_ + warped_,
                           turned_};
  return {pairs, clearances_, starts_, row_clearances_, loss, speed_};
}

template <int Dim>
bool Candidates<Dim>::complete(const Entities<Dim>& entities, Real longest,
                               const Communicator& ranks) {
  // What is imported moves among the points of its owner.
  Real warp = entities.warped;
  warped_ = warp;
  turned_ = entities.turned;
  const auto bounds = over_ranks(ranks, entities.nodes.motion, warp);
  speed_ = bounds.relative_speed();
  Real growth = 2 * kReachPerWarp * warp;  // of reaches since the lists were built
  Real farther = std::max(0.0, way_of_faces(entities) - face_reach_);
  if (entities.any_particles) farther = std::max(farther, speed_ * longest - speed_reach_);
  growth += farther;
  ++steps_;
  moved_ = bounds.relative_displacement();
  return moved_ + growth <= skin_;
}

/// Cost of a step: c(s) + (work of a build) (motion a step) / s, the candidates c growing with s.
template <int Dim>
void Candidates<Dim>::choose_skin(const Entities<Dim>& entities) {
  if (given_skin_) {
    skin_ = *given_skin_;
    return;
  }
  if (builds_ == 0) {
    skin_ = kFirst * entities.size;
    return;
  }
  const auto listed = static_cast<Real>(face_pairs_.size() + n_particles() + pairs_.size());
  if (steps_ == 0) return;
  const auto boxes = static_cast<Real>(entities.near_faces.size() + entities.particles.size());
  const Real build = kWorkPerEntity * boxes + kWorkPerListed * listed;
  const Real motion = std::max(moved_, 0.0) / static_cast<Real>(steps_);
  // Boxes of four sizes: their number grows by Dim / (4 sizes) a metre.
  const Real growth = std::max(listed, 1.0) * Dim / (4 * entities.size);
  const Real best = std::sqrt(build * motion / growth);
  skin_ = std::max(kThinnest * entities.size, std::min(kWidest * entities.size, best));
}

template class Candidates<2>;
template class Candidates<3>;

}  // namespace brunt
// Tested by tests/unit/contact/rebuild_test.cpp.
