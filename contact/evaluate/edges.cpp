#include "contact/evaluate/edges.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/edge_contact.hpp"

namespace brunt {

namespace {
/// Ordinals of planes come before those of edges.
constexpr std::uint32_t kFirstOrdinal = 16;

/// How much of the mass behind a face gives way to a force on its corners [1/kg].
Real inverse_mass(const Entities<3>& entities, const ContactFace<3>& face,
                  std::span<const Real> weight) {
  if (!face.deforms()) return face.compliance;
  Real sum = 0;
  for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
    const Real mass = entities.nodes.mass[slot_of(face.node[c])];
    if (mass > 0) sum += weight[c] * weight[c] / mass;
  }
  return sum;
}

/// The most of it: that of the lightest corner [1/kg].
Real most_inverse_mass(const Entities<3>& entities, const ContactFace<3>& face) {
  if (!face.deforms()) return face.compliance;
  Real most = 0;
  for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
    const Real mass = entities.nodes.mass[slot_of(face.node[c])];
    if (mass > 0) most = std::max(most, 1 / mass);
  }
  return most;
}

/// Bound of a spring on both sides, of elements together with their own, and of what its fades do
/// as faces turn and blades slide: half of it where faces are deep errs a quarter as much
/// (contact/evaluate/face_step_limits.cpp).
/// stiffness  [N/m] k D^2
void take_step_limit(const Entities<3>& entities, const FaceCandidate& candidate,
                     const EdgeContact& contact, Real stiffening, Real stiffness,
                     StepLimit& step_limit) {
  const auto& lower = entities.faces[slot_of(candidate.lower)];
  const auto& upper = entities.faces[slot_of(candidate.upper)];
  const auto weights = std::span(contact.weight);
  const Real depth = contact.penetration / stiffening, square = depth * depth;
  const Real gives = inverse_mass(entities, lower, weights.first(4)) +
                     inverse_mass(entities, upper, weights.last(4));
  const Real turns = most_inverse_mass(entities, lower) + most_inverse_mass(entities, upper);
  const Real energy = square * (0.5 + 0.25 * square) * stiffening * stiffening;
  Real squared = stiffness * ((1 + 3 * square) * gives + energy * contact.fade_curvature * turns);
  for (const auto* face : {&lower, &upper}) {
    if (face->deforms() && face->element_step > 0) squared += 1 / std::pow(face->element_step, 2);
  }
  if (squared > 0)
    step_limit.take({1 / std::sqrt(squared), "contact stiffness", lower.body, lower.id});
}

void add_record(const Entities<3>& entities, const FaceCandidate& candidate,
                const EdgeContact& contact, std::uint32_t ordinal, Records<3>::Part& part) {
  const auto& lower = entities.faces[slot_of(candidate.lower)];
  const auto& upper = entities.faces[slot_of(candidate.upper)];
  const Real area = candidate.normal.limit * candidate.normal.limit,
             stiffness = candidate.normal.stiffness * area;
  auto& record = part.face_on_face.emplace_back();
  record.first = lower.id, record.second = upper.id;
  record.first_place = candidate.lower, record.second_place = candidate.upper;
  record.lower_body = lower.body, record.upper_body = upper.body;
  record.ordinal = ordinal;
  record.normal = contact.normal;
  record.point = contact.point;
  record.area = contact.share * area;
  record.penetration = contact.penetration;
  record.spring = stiffness * contact.force;
  record.stored = stiffness * contact.energy;
  record.push = static_cast<std::int32_t>(part.pushes.size());
  auto& pushes = part.pushes.emplace_back();
  pushes.n_lower = lower.n_nodes;
  Real closing = 0;
  const auto add = [&](const ContactFace<3>& face, std::size_t first) {
    for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
      const Real weight = contact.weight[first + c];
      pushes.force[slot_of(record.n_nodes)] = stiffness * contact.push[first + c];
      record.add(face.node[c], weight);
      const auto& v = entities.nodes.v[slot_of(face.node[c])];
      closing -= weight * v.dot(contact.normal);
    }
  };
  add(lower, 0);
  add(upper, Facet<3>::kNodes);
  record.damping = std::max(candidate.normal.damping * record.area * closing, -record.spring);
}
/// The most that contact takes no notice of [m]: of blades that cross when they begin all that they
/// overlap, later what was left of it in the last evaluation.
Real overlap_before(const FaceCandidate& candidate, const EvaluationStep& step, bool born,
                    const ContactKey& key) {
  if (step.touches.time_zero) return candidate.laws.presses_at_once() ? 0 : kInfinity;
  if (born) return kInfinity;
  const auto* before = step.touches.before->find(key);
  return before == nullptr ? 0 : before->overlap;
}
}  // namespace

void add_blades(const Entities<3>& entities, const FaceCandidate& candidate,
                const EvaluationStep& step, bool born, Records<3>::Part& part) {
  const auto& lower = entities.planes[slot_of(candidate.lower)];
  const auto& upper = entities.planes[slot_of(candidate.upper)];
  if (lower.borders >> kBladeBits == 0 || upper.borders >> kBladeBits == 0) return;
  // Thin ones go three times as deep as faces; at ten times they hold 1e4 times what those do.
  const BladeDepths depths{0.5 * candidate.normal.limit, 10 * candidate.normal.limit};
  const Real stiffness =
      candidate.normal.stiffness * candidate.normal.limit * candidate.normal.limit;
  EdgeContact contact;
  for (int i = 0; i < lower.n_corners; ++i) {
    if ((lower.borders >> (kBladeBits + static_cast<unsigned>(i)) & 1U) == 0) continue;
    for (int j = 0; j < upper.n_corners; ++j) {
      if ((upper.borders >> (kBladeBits + static_cast<unsigned>(j)) & 1U) == 0) continue;
      const auto ordinal = kFirstOrdinal + static_cast<std::uint32_t>(4 * i + j);
      FirstTouch touch;
      touch.key = {ContactKind::face_face, ordinal, entities.faces[slot_of(candidate.lower)].id,
                   entities.faces[slot_of(candidate.upper)].id};
      touch.overlap = overlap_before(candidate, step, born, touch.key);
      const bool pushes = find_edge_contact(lower, i, upper, j, depths, touch.overlap, contact);
      if ((step.touches.time_zero || born) && touch.overlap <= meeting_distance(lower, upper)) {
        touch.overlap = 0;  // a rounding
      }
      if (touch.matters()) part.face_touches.push_back(touch);
      if (!pushes) continue;
      add_record(entities, candidate, contact, ordinal, part);
      take_step_limit(entities, candidate, contact, depths.stiffening, stiffness, part.step_limit);
    }
  }
}

}  // namespace brunt
// Tested by tests/unit/contact/edge_contact_test.cpp.
