#include "contact/contacts/friction.hpp"

#include <algorithm>
#include <cassert>

#include "contact/contacts/record.hpp"
#include "contact/contacts/side_corners.hpp"
#include "contact/law/spring_slider.hpp"

namespace brunt {

namespace {
/// Shares a force at `at` among the corners of a side, with its couple where the side turns.
template <int Dim>
void share(const SideCorners<Dim>& side, const ContactSide& which, const Vec<Dim>& at,
           const Vec<Dim>& force, Friction<Dim>& friction) {
  using brunt::cross, brunt::turn;
  CornerVectors<Dim> on_corner;
  for (std::size_t c = 0; c < Dim; ++c) on_corner[c] = side.weight * force[c];
  if (which.turns) {
    const auto couple = turn_of(side, cross(Vec<Dim>(at - side.point), force));
    const auto moved = turn(couple, side.arm);
    for (std::size_t c = 0; c < Dim; ++c) on_corner[c] += moved[c];
  }
  for (int k = 0; k < side.n; ++k) {
    for (std::size_t c = 0; c < Dim; ++c) {
      friction.force[slot_of(which.first + k)][c] = on_corner[c][k];
    }
  }
}

void find_spin(const SideCorners<3>& lower, const SideCorners<3>& upper, const Vec3& normal,
               Real dt, PlaneTurn<3>& turn) {
  Real cosine = 0, sine = 0;
  for (const auto* side : {&lower, &upper}) {
    if (side->n > 1) add_spin(*side, turn, normal, dt, cosine, sine);
  }
  turn.spin(cosine, sine);
}
void find_spin(const SideCorners<2>&, const SideCorners<2>&, const Vec<2>&, Real, PlaneTurn<2>&) {}

template <int Dim>
Vec<Dim> in_plane(const Vec<Dim>& v, const Vec<Dim>& normal) {
  return v - normal.dot(v) * normal;
}

/// [J] half of what forces take from the motion of a step of dt.
template <int Dim>
Real half_taken(const Friction<Dim>& friction, const ContactNodes<Dim>& nodes, Real dt) {
  Real power = 0;
  for (std::size_t k = 0; k < slot_of(friction.n_nodes); ++k) {
    power += friction.force[k].dot(nodes.v[slot_of(friction.node[k])]);
  }
  return -0.5 * dt * power;
}
}  // namespace

template <int Dim>
void FrictionHistory<Dim>::add(const Friction<Dim>& friction, const ContactNodes<Dim>& nodes,
                               Real dt) {
  past_.push_back(friction);
  past_.back().taken = half_taken(friction, nodes, dt);
  const auto book = slot_of(friction.node[0]);
  past_.back().book_surface = nodes.surface[book], past_.back().book_point = nodes.id[book];
  used_.push_back(0);
  first_heated_.push_back(heated_.size());
  if (!friction.slips || friction.heat_share == 0) return;
  for (std::size_t k = 0; k < slot_of(friction.n_nodes); ++k) {
    if (friction.heat_shares[k] == 0) continue;
    const auto node = slot_of(friction.node[k]);
    heated_.push_back({nodes.surface[node], nodes.id[node], friction.heat_shares[k]});
  }
}

template <int Dim>
std::vector<EndedHeat> FrictionHistory<Dim>::ended_heat() const {
  std::vector<EndedHeat> ended;
  for (std::size_t i = 0; i < past_.size(); ++i) {
    if (used_[i]) continue;
    const std::size_t end = i + 1 < past_.size() ? first_heated_[i + 1] : heated_.size();
    for (std::size_t k = first_heated_[i]; k < end; ++k) {
      const auto& [surface, point, share] = heated_[k];
      ended.push_back({past_[i].key, surface, point, share * past_[i].last_heat()});
    }
  }
  return ended;
}

template <int Dim>
std::size_t FrictionHistory<Dim>::place_of(const ContactKey& key, std::size_t from) const {
  assert(from == 0 || past_[from - 1].key < key);
  // Most often it is the next one, or one of the next: steps that double pass by what ended.
  std::size_t to = from;
  for (std::size_t step = 1; to < past_.size() && past_[to].key < key; step *= 2) {
    from = to + 1;
    to += step;
  }
  const auto begin = past_.begin() + static_cast<std::ptrdiff_t>(from);
  const auto end = past_.begin() + static_cast<std::ptrdiff_t>(std::min(to, past_.size()));
  const auto at = std::lower_bound(
      begin, end, key,
      [](const FrictionMemory<Dim>& one, const ContactKey& wanted) { return one.key < wanted; });
  return slot_of(at - past_.begin());
}

template <int Dim>
const FrictionMemory<Dim>* FrictionHistory<Dim>::of_faces(const ContactKey& key,
                                                          std::size_t& from) {
  from = place_of(key, from);
  if (from == past_.size() || !(past_[from].key == key)) return nullptr;
  used_[from] = 1;
  return &past_[from];
}

template <int Dim>
const FrictionMemory<Dim>* FrictionHistory<Dim>::of_particle(const ContactKey& key, Label body,
                                                             Label piece, const Vec<Dim>& normal,
                                                             std::size_t& from) {
  from = place_of({ContactKind::particle_face, 0, key.first, 0}, from);
  std::size_t found = past_.size();
  Real nearest = 0;  // only normals less than a right angle apart are the same surface
  for (std::size_t i = from; i < past_.size(); ++i) {
    const auto& one = past_[i];
    if (one.key.kind != ContactKind::particle_face || one.key.first != key.first) break;
    if (used_[i] || one.body != body || one.piece != piece) continue;
    const Real along = one.normal.dot(normal);
    const bool same_face = one.key.second == key.second;
    if (same_face ? along > 0 : along > nearest) {
      found = i;
      nearest = same_face ? 2.0 : along;
    }
  }
  if (found == past_.size()) return nullptr;
  used_[found] = 1;
  return &past_[found];
}

namespace {
/// What a contact is and what its tangential spring acts on, as the record and the step say.
template <int Dim>
void begin(const ContactRecord<Dim>& record, const FrictionStep<Dim>& step,
           Friction<Dim>& friction) {
  friction.key = key_of(record);
  friction.normal = record.normal;
  friction.n_nodes = record.n_nodes;
  friction.node = record.node;
  friction.area = step.area;
  friction.stiffness = step.stiffness;
}

/// The force [N] at which the contact slips. friction: state and coefficient out. speed [m/s]
template <int Dim>
Real sliding_limit(const ContactRecord<Dim>& record, const FrictionStep<Dim>& step, Real speed,
                   Friction<Dim>& friction) {
  const Real push = record.spring + record.damping;
  const Real pressure = std::max(push, 0.0) / step.pressed;
  friction.state = {
      step.material.temperature, step.material.flow_stress, pressure, speed, push, step.pressed};
  friction.state.bonded = step.bonded;
  return step.laws->slip_limit(friction.state, friction.coefficient);
}

/// The traction [Pa] of the damper where friction sticks; with the spring's no more than the limit
/// [Pa]. slip [m]
template <int Dim>
Vec<Dim> sticking_drag(const FrictionStep<Dim>& step, const Vec<Dim>& traction,
                       const Vec<Dim>& slip, Real limit) {
  return within_limit<Dim>(traction, -step.damping / step.dt * slip, limit);
}

/// The place [m] where friction acts. The common plane of large tilted faces lies off both: it acts
/// where they are.
template <int Dim>
Vec<Dim> place_of(const ContactRecord<Dim>& record, const FrictionStep<Dim>& step,
                  const SideCorners<Dim>& lower, const SideCorners<Dim>& upper) {
  return record.kind != ContactKind::face_face ? step.point
                                               : Vec<Dim>(0.5 * (lower.point + upper.point));
}
}  // namespace

template <int Dim>
void find_friction(const ContactNodes<Dim>& nodes, const ContactRecord<Dim>& record,
                   const FrictionStep<Dim>& step, Friction<Dim>& friction) {
  begin(record, step, friction);
  const SideCorners<Dim> lower(nodes, record, step.weight, step.lower);
  const SideCorners<Dim> upper(nodes, record, step.weight, step.upper);
  const Vec<Dim>& n = record.normal;
  const Vec<Dim> point = place_of(record, step, lower, upper);
  friction.point = point;

  const Vec<Dim> velocity = upper.velocity - lower.velocity;
  Vec<Dim> slip = step.dt * velocity;
  Vec<Dim> traction = in_plane<Dim>(step.inherited, n);
  Vec<Dim> slider_before = Vec<Dim>::Zero(), drag_before = Vec<Dim>::Zero();
  Real taken_before = 0, energy_before = 0;
  const Vec<Dim> distance = upper.point - lower.point;
  const auto with_bodies = [&](const Vec<Dim>& v) { return step.turn ? (*step.turn)(v) : v; };
  const Vec<Dim> between_centres = step.turn ? in_plane<Dim>(slip, n) : slip;
  if (step.turn) slip = distance - (*step.turn)(distance - slip);
  if (const auto* before = step.before) {
    taken_before = before->taken;
    energy_before = before->energy();
    PlaneTurn<Dim> turn(with_bodies(before->normal), n);
    traction.setZero();
    if (turn.cosine() > 0) {  // else it is another contact between the same faces
      if (!step.turn) {
        find_spin(lower, upper, n, step.dt, turn);
        slip = distance - turn(distance - step.dt * velocity);
      }
      const Vec<Dim> turned = in_plane<Dim>(turn(with_bodies(before->traction)), n);
      traction = step.kept * turned;
      slider_before = before->area * turned;
      drag_before = before->area * turn(with_bodies(before->drag));
    }
  }
  slip = in_plane<Dim>(slip, n);
  const bool turns = step.turn && step.dt > 0;
  const Real speed = turns ? slip.norm() / step.dt : in_plane<Dim>(velocity, n).norm();
  const Real limit = sliding_limit(record, step, speed, friction);
  auto slid = slide<Dim>(traction, step.stiffness, slip, limit / step.area);
  // What the forces take from the centres is heat:
  // docs/decisions/096-friction-between-particles.md.
  if (slid.slips && step.turn) {
    slip = between_centres;
    slid = slide<Dim>(traction, step.stiffness, slip, limit / step.area);
  }
  friction.traction = slid.traction;
  friction.slips = slid.slips;
  if (!slid.slips && step.dt > 0) {
    friction.drag = sticking_drag(step, slid.traction, slip, limit / step.area);
  }
  share(upper, step.upper, point, friction.resultant(), friction);
  share<Dim>(lower, step.lower, point, -friction.resultant(), friction);
  // The old force may be above the limit that there is now, and point along a slip that has turned
  // back: the mean of both would cool. What it gives then goes to pairs.
  friction.heat = std::max(-0.5 * (slider_before + friction.slider()).dot(slid.slip), 0.0);
  friction.damped = -0.5 * (drag_before + step.area * friction.drag).dot(slip);
  friction.stored = friction.energy() - energy_before;
  friction.pairs = taken_before + half_taken(friction, nodes, step.dt) - friction.heat -
                   friction.stored - friction.damped;
}

template class FrictionHistory<2>;
template class FrictionHistory<3>;
template void find_friction<2>(const ContactNodes<2>&, const ContactRecord<2>&,
                               const FrictionStep<2>&, Friction<2>&);
template void find_friction<3>(const ContactNodes<3>&, const ContactRecord<3>&,
                               const FrictionStep<3>&, Friction<3>&);

}  // namespace brunt
