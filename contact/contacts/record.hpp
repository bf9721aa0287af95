#pragma once
#include <omp.h>

#include <vector>

#include "contact/contacts/first_touch.hpp"
#include "contact/contacts/heat.hpp"
#include "contact/contacts/lost.hpp"
#include "contact/contacts/particle_pair.hpp"
#include "core/parallel/threads.hpp"
#include "core/step_limit.hpp"

namespace brunt {

/// One contact that carries force now: a common plane, a particle on a face, or two particles. The
/// normal points from the lower side (the face of a particle on a face, else the smaller id) to the
/// upper; node i gets weight_i (spring + damping) normal, weights of the lower side are negative.
template <int Dim>
struct ContactRecord {
  static constexpr int kNodes = 2 * Facet<Dim>::kNodes;
  /// Written out: else emplace_back sets all bytes to 0 first, which costs more than the rest.
  ContactRecord() {}               // NOLINT(modernize-use-equals-default)
  GlobalId first = 0, second = 0;  ///< key: lower and upper face or particle, or particle and face
  LocalIndex first_place = 0, second_place = 0;  ///< among the faces or particles of the tables
  ContactKind kind = ContactKind::face_face;
  std::uint32_t ordinal = 0;  ///< of the planes between two faces
  Label lower_body = 0, upper_body = 0;
  Vec<Dim> normal;
  Vec<Dim> point;              ///< [m]
  Real spring = 0;             ///< [N] along normal on the upper side
  Real stored = 0;             ///< [J] that this spring holds
  Real damping = 0;            ///< [N]
  Real area = 0;               ///< [m^2]
  Real penetration = 0;        ///< [m] of what borders fade, that part (C14)
  Real opening = 0;            ///< [m] of PlaneNeeds: minus what is left of time 0
  bool bonded = false;         ///< it is held: its plane is the whole overlap
  std::int32_t friction = -1;  ///< its place among those of the same part; -1: it slides freely
  std::int32_t push = -1;      ///< the same of what its spring gives beside the normal; -1: nothing
  int n_nodes = 0;
  std::array<LocalIndex, kNodes> node{};
  std::array<Real, kNodes> weight{};

  void add(LocalIndex at, Real w) {
    node[slot_of(n_nodes)] = at;
    weight[slot_of(n_nodes++)] = w;
  }
};

/// What the spring between two faces at an angle gives to the nodes of its record beside their
/// share of the push along the normal. All sides together get no force and no moment.
template <int Dim>
struct PotentialPush {
  PotentialPush() {}  // NOLINT(modernize-use-equals-default): as that of a record
  std::array<Vec<Dim>, ContactRecord<Dim>::kNodes> force;  ///< [N]
  int n_lower = 0;                                         ///< nodes of the lower side come first
};

/// A record with what its part keeps beside it, or null.
template <int Dim>
struct WholeRecord {
  const ContactRecord<Dim>& record;
  const Friction<Dim>* friction;
  const PotentialPush<Dim>* push;

  /// What the spring gives to the node k of the record [N].
  Vec<Dim> spring_on(std::size_t k) const {
    const Vec<Dim> along = record.weight[k] * record.spring * record.normal;
    return push == nullptr ? along : Vec<Dim>(along + push->force[k]);
  }
};

/// The records of an evaluation, by the contiguous parts in which the threads found them: reading
/// part after part is reading in key order, whatever the number of parts.
template <int Dim>
class Records {
 public:
  struct Part {
    std::vector<ContactRecord<Dim>> face_on_face, particle_on_face, two_particles;
    std::vector<Friction<Dim>> frictions;
    std::vector<PotentialPush<Dim>> pushes;
    std::vector<HeatFlow<Dim>> face_heat, particle_heat;
    std::vector<FirstTouch> face_touches, particle_touches, pair_touches;
    std::vector<TiePoint> face_ties, particle_ties;  ///< that hold now
    std::vector<JointClosure> closures;              ///< of joints that touch now
    std::vector<JointLoss> losses;                   ///< of faces, in the order of keys
    std::vector<JointLoss> particle_losses;
    std::vector<PairHeatPath<Dim>> pair_heat;
    std::vector<ParticleHit<Dim>> hits, near_hits;  ///< room to work
    std::vector<LocalIndex> near;                   ///< room to work: faces
    std::vector<NearQuery<Dim>> queries;            ///< the same
    std::vector<NearestPoint<Dim>> nearest;
    std::vector<LostContact<Dim>> lost;          ///< without their times; nearly always empty
    std::vector<DeepParticle<Dim>> deep;         ///< the same
    std::vector<ParticleMeeting<Dim>> meetings;  ///< room to work
    std::size_t past = 0;                        ///< where its frictions look for theirs
    StepLimit step_limit;
  };
  void clear();
  /// Cuts 0 .. n in parts by thread and runs work(first, last, part) on each.
  template <class Work>
  void for_parts(std::size_t n, std::size_t worth_threads, const Work& work);
  template <class Visit>
  void visit(const Visit& visit) const {
    visit_whole([&](const WholeRecord<Dim>& whole) { visit(whole.record); });
  }
  /// visit(record, friction): a contact that slides freely has none.
  template <class Visit>
  void visit_with_friction(const Visit& visit) const {
    visit_whole([&](const WholeRecord<Dim>& whole) { visit(whole.record, whole.friction); });
  }
  /// visit(friction) of each contact that has some.
  template <class Visit>
  void visit_frictions(const Visit& visit) const {
    visit_whole([&](const WholeRecord<Dim>& whole) {
      if (whole.friction != nullptr) visit(*whole.friction);
    });
  }
  /// visit(whole record).
  template <class Visit>
  void visit_whole(const Visit& visit) const {
    const auto show = [&](const Part& part, const std::vector<ContactRecord<Dim>>& records) {
      for (const auto& record : records) {
        const auto in = [](const auto& all, std::int32_t at) {
          return at < 0 ? nullptr : &all[slot_of(at)];
        };
        visit(WholeRecord<Dim>{record, in(part.frictions, record.friction),
                               in(part.pushes, record.push)});
      }
    };
    for (const auto& part : parts_) show(part, part.face_on_face);
    for (const auto& part : parts_) show(part, part.particle_on_face);
    for (const auto& part : parts_) show(part, part.two_particles);
  }
  /// In the order of keys.
  template <class Visit>
  void visit_heat(const Visit& visit) const {
    for (const auto& part : parts_) {
      for (const auto& flow : part.face_heat) visit(flow);
    }
    for (const auto& part : parts_) {
      for (const auto& flow : part.particle_heat) visit(flow);
    }
    for (const auto& part : parts_) {
      for (const auto& pair : part.pair_heat) visit(pair.flow);
    }
  }
  template <class Change>
  void change_heat(const Change& change) {
    for (auto& part : parts_) {
      for (auto* flows : {&part.face_heat, &part.particle_heat}) {
        for (auto& flow : *flows) change(flow);
      }
      for (auto& pair : part.pair_heat) change(pair.flow);
    }
  }
  /// change(heat) of particles on faces, then change(heat) of two particles.
  template <class ChangeFlow, class ChangePair>
  void change_heat_of_particles(const ChangeFlow& change_flow, const ChangePair& change_pair) {
    for (auto& part : parts_) {
      for (auto& flow : part.particle_heat) change_flow(flow);
      for (auto& pair : part.pair_heat) change_pair(pair);
    }
  }
  /// visit(contact) for each lost contact that the evaluation itself has noted.
  template <class Visit>
  void visit_lost(const Visit& visit) const {
    for (const auto& part : parts_) {
      for (const auto& contact : part.lost) visit(contact);
    }
  }
  void collect_deep(std::vector<DeepParticle<Dim>>& deep) const;
  /// What pairs keep from time 0, in the order of keys.
  void collect_touches(FirstTouches& touches) const;
  void collect_ties(TiePoints& ties) const;
  void collect_closures(JointClosures& closures) const;
  /// visit(loss) of what joints have used up in this evaluation, in the order of keys.
  template <class Visit>
  void visit_losses(const Visit& visit) const {
    for (const auto& part : parts_) {
      for (const auto& loss : part.losses) visit(loss);
    }
    for (const auto& part : parts_) {
      for (const auto& loss : part.particle_losses) visit(loss);
    }
  }
  /// Names the nodes and places of each contact anew, as they stand in tables that are new.
  void name_nodes(const Entities<Dim>& entities);
  /// Gives every contact whose friction find(key) knows that friction, as it stands.
  template <class Find>
  void attach(const Find& find);
  std::size_t size() const;
  StepLimit step_limit() const;

 private:
  std::vector<Part> parts_;
};

template <int Dim>
ContactKey key_of(const ContactRecord<Dim>& record) {
  return {record.kind, record.ordinal, record.first, record.second};
}

/// The node to which the energies of a contact are booked; its evaluator owns it.
template <int Dim>
std::size_t book_of(const Entities<Dim>& entities, const ContactKey& key) {
  const LocalIndex node = key.kind == ContactKind::face_face
                              ? entities.faces[entities.face_with(key.first)].node[0]
                              : entities.particles[entities.particle_with(key.first)].node;
  return slot_of(node);
}

/// What a contact that another rank evaluated gives to one node of this rank.
template <int Dim>
struct Contribution {
  ContactKey key;
  LocalIndex node;
  Real spring[Dim], damping[Dim], friction[Dim];  ///< [N]
};

/// Sums the forces of all records, and of contributions from elsewhere (sorted by key), at each
/// owned node in key order, books -1/2 (f(n) + f(n+1)) . dt v of the spring and the damper to the
/// node, and adds the forces, friction too, to the points of the groups.
template <int Dim>
void apply(const Records<Dim>& records, std::span<const Contribution<Dim>> elsewhere, Real dt,
           const std::vector<Surface<Dim>*>& surfaces, ContactNodes<Dim>& nodes);

/// Sums the heat of all contacts, and of shares from elsewhere (sorted by key), at each node in
/// key order, and adds it to the points of the groups.
template <int Dim>
void apply_heat(const Records<Dim>& records, std::span<const HeatShare> elsewhere,
                const std::vector<Surface<Dim>*>& surfaces, ContactNodes<Dim>& nodes);

template <int Dim>
template <class Find>
void Records<Dim>::attach(const Find& find) {
  for (auto& part : parts_) {
    for (auto* records : {&part.face_on_face, &part.particle_on_face, &part.two_particles}) {
      for (auto& record : *records) {
        const Friction<Dim>* friction = find(key_of(record));
        if (friction == nullptr) continue;
        record.friction = static_cast<std::int32_t>(part.frictions.size());
        part.frictions.push_back(*friction);
        part.frictions.back().node = record.node;
      }
    }
  }
}

template <int Dim>
template <class Work>
void Records<Dim>::for_parts(std::size_t n, std::size_t worth_threads, const Work& work) {
  const auto most = slot_of(omp_get_max_threads());
  if (parts_.size() < most) parts_.resize(most);
  on_threads(n > worth_threads, [&] {
    const auto count = slot_of(omp_get_num_threads());
    const auto k = slot_of(omp_get_thread_num());
    work(n * k / count, n * (k + 1) / count, parts_[k]);
  });
}

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
