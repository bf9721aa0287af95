#include "contact/contacts/friction.hpp"

#include <algorithm>
#include <cassert>
#include <span>

#include "contact/contacts/record.hpp"
#include "contact/contacts/side_corners.hpp"
#include "contact/law/spring_slider.hpp"

namespace brunt {

namespace {
/// a . b of torques and turns.
Real product(Real a, Real b) { return a * b; }
Real product(const Vec3& a, const Vec3& b) { return a.dot(b); }

/// Shares a force at `at` among the corners of a side, with its couple where the side turns.
/// Returns the power of the shares [W] on the velocities of the corners.
template <int Dim>
Real share(const SideCorners<Dim>& side, const ContactSide& which, const Vec<Dim>& at,
           const Vec<Dim>& force, Friction<Dim>& friction) {
  using brunt::cross, brunt::turn;
  CornerVectors<Dim> on_corner;
  for (std::size_t c = 0; c < Dim; ++c) on_corner[c] = side.weight * force[c];
  Real power = force.dot(side.velocity);
  if (which.turns) {
    const Couple<Dim> couple = side.face.turn(cross(Vec<Dim>(at - side.point), force));
    const auto moved = turn(couple, side.face.arm);
    for (std::size_t c = 0; c < Dim; ++c) on_corner[c] += moved[c];
    power += product(couple, side.face.moment);
  }
  Vec<Dim>* const shares = &friction.force[slot_of(which.first)];
  const auto hand_over = [&](int n) {
    for (int k = 0; k < n; ++k) {
      for (std::size_t c = 0; c < Dim; ++c) shares[k][c] = on_corner[c][k];
    }
  };
  // Lanes that are known by number are moved; others are read back from memory.
  if (side.n == 2 * (Dim - 1)) {
    hand_over(2 * (Dim - 1));
  } else {
    hand_over(side.n);
  }
  return power;
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
BRUNT_INLINE Vec<Dim> in_plane(const Vec<Dim>& v, const Vec<Dim>& normal) {
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

/// What a contact brings into a step, turned with its plane.
template <int Dim>
struct Carried {
  Vec<Dim> slip;                       // [m] of the step, with a part along the normal
  Vec<Dim> traction;                   // [Pa] in the plane
  Vec<Dim> slider = Vec<Dim>::Zero();  // [N] in the plane
  Vec<Dim> drag = Vec<Dim>::Zero();    // [N]
  Real taken = 0, energy = 0;          // [J]
};

template <int Dim>
Carried<Dim> carry(const FrictionStep<Dim>& step, const SideCorners<Dim>& lower,
                   const SideCorners<Dim>& upper, const Vec<Dim>& normal) {
  const Vec<Dim> moved = step.dt * (upper.velocity - lower.velocity);
  const Vec<Dim> distance = upper.point - lower.point;
  const auto with_bodies = [&](const Vec<Dim>& v) { return step.turn ? (*step.turn)(v) : v; };
  Carried<Dim> carried;
  carried.slip = step.turn ? Vec<Dim>(distance - (*step.turn)(distance - moved)) : moved;
  carried.traction = in_plane<Dim>(step.inherited, normal);
  const auto* before = step.before;
  if (before == nullptr) return carried;
  carried.taken = before->taken;
  carried.energy = before->energy();
  carried.traction.setZero();
  PlaneTurn<Dim> turn(with_bodies(before->normal), normal);
  if (!(turn.cosine() > 0)) return carried;  // it is another contact between the same faces
  if (!step.turn) find_spin(lower, upper, normal, step.dt, turn);
  const auto [arm, traction, drag] = turn(std::array<Vec<Dim>, 3>{
      distance - moved, with_bodies(before->traction), with_bodies(before->drag)});
  if (!step.turn) carried.slip = distance - arm;
  const Vec<Dim> turned = in_plane<Dim>(traction, normal);
  carried.traction = step.kept * turned;
  carried.slider = before->area * turned;
  carried.drag = before->area * drag;
  return carried;
}

/// A side of a contact as its step knows it, else as its nodes are.
/// own  room for it
template <int Dim>
const FaceSide<Dim>& side_of(const ContactNodes<Dim>& nodes, const ContactRecord<Dim>& record,
                             const ContactSide& side, const FaceSide<Dim>* known,
                             FaceSide<Dim>& own) {
  if (known != nullptr) return *known;
  const auto n = slot_of(side.last - side.first);
  const auto nodes_of_side = std::span(record.node).subspan(slot_of(side.first), n);
  if (n == 1) {
    own.set(nodes, nodes_of_side[0]);
  } else {
    own.set(nodes, nodes_of_side);
  }
  return own;
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
  FaceSide<Dim> own_lower, own_upper;
  const SideCorners<Dim> lower(side_of(nodes, record, step.lower, step.lower_face, own_lower),
                               step.weight, step.lower);
  const SideCorners<Dim> upper(side_of(nodes, record, step.upper, step.upper_face, own_upper),
                               step.weight, step.upper);
  const Vec<Dim>& n = record.normal;
  const Vec<Dim> point = place_of(record, step, lower, upper);
  friction.point = point;

  const Vec<Dim> velocity = upper.velocity - lower.velocity;
  const auto carried = carry<Dim>(step, lower, upper, n);
  Vec<Dim> slip = in_plane<Dim>(carried.slip, n);
  const bool turns = step.turn && step.dt > 0;
  const Real speed = turns ? slip.norm() / step.dt : in_plane<Dim>(velocity, n).norm();
  const Real limit = sliding_limit(record, step, speed, friction);
  auto slid = slide<Dim>(carried.traction, step.stiffness, slip, limit / step.area);
  // What the forces take from the centres is heat:
  // docs/decisions/096-friction-between-particles.md.
  if (slid.slips && step.turn) {
    slip = in_plane<Dim>(step.dt * velocity, n);
    slid = slide<Dim>(carried.traction, step.stiffness, slip, limit / step.area);
  }
  friction.traction = slid.traction;
  friction.slips = slid.slips;
  if (!slid.slips && step.dt > 0) {
    friction.drag = sticking_drag(step, slid.traction, slip, limit / step.area);
  }
  const Real power = share(upper, step.upper, point, friction.resultant(), friction) +
                     share<Dim>(lower, step.lower, point, -friction.resultant(), friction);
  // The old force may be above the limit that there is now, and point along a slip that has turned
  // back: the mean of both would cool. What it gives then goes to pairs.
  friction.heat = std::max(-0.5 * (carried.slider + friction.slider()).dot(slid.slip), 0.0);
  friction.damped = -0.5 * (carried.drag + step.area * friction.drag).dot(slip);
  friction.stored = friction.energy() - carried.energy;
  friction.pairs =
      carried.taken - 0.5 * step.dt * power - friction.heat - friction.stored - friction.damped;
}

template class FrictionHistory<2>;
template class FrictionHistory<3>;
template void find_friction<2>(const ContactNodes<2>&, const ContactRecord<2>&,
                               const FrictionStep<2>&, Friction<2>&);
template void find_friction<3>(const ContactNodes<3>&, const ContactRecord<3>&,
                               const FrictionStep<3>&, Friction<3>&);

}  // namespace brunt
