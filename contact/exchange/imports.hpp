#pragma once
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "contact/contacts/face_tractions.hpp"
#include "contact/surfaces/entities.hpp"
#include "core/parallel/ghosts.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

/// What ranks show each other to find what they must import [m].
template <int Dim>
struct ImportBoxes {
  std::vector<SearchBox<Dim>> offered;  ///< one for each of entities.faces
  std::vector<SearchBox<Dim>> wanted;   ///< where faces of others matter
  bool particles_meet = false;          ///< the same on all ranks; false: what follows is not there
  std::vector<LocalIndex> particle;     ///< owned ones that may touch particles of other bodies
  std::vector<SearchBox<Dim>> of_particles;  ///< theirs
};

/// Faces and particles of other ranks that may touch what this rank evaluates, and the way of
/// forces back to the owners of their nodes (docs/theory/contact.md (C45)). Faces of rigid bodies
/// stand on every rank and are never imported.
template <int Dim>
class ContactImports {
 public:
  ContactImports(const ContactRanks& ranks, std::vector<Surface<Dim>*> surfaces)
      : ranks_(ranks), surfaces_(std::move(surfaces)) {}
  const Communicator& ranks() const { return *ranks_.all; }

  /// Imports into entities, which have those of this rank's surfaces alone, the faces of others
  /// whose `offered` boxes meet the `wanted` boxes of this rank, and the particles whose boxes meet
  /// those of its own. Collective.
  void renew(const ImportBoxes<Dim>& offers, Entities<Dim>& entities);
  /// Brings x, v, spin and material of the imported nodes up to date. Collective among neighbours.
  void refresh_motion(ContactNodes<Dim>& nodes) const;
  /// Sends what records give to nodes of other ranks home, unsummed; returns what others send here,
  /// sorted by key. Collective.
  std::vector<Contribution<Dim>> send_home(const Records<Dim>& records,
                                           const ContactNodes<Dim>& nodes) const;
  /// Sends what contacts evaluated here leave on faces of other ranks to their owners; returns what
  /// others send here, sorted by key. Collective among neighbours.
  std::vector<TractionShare<Dim>> send_tractions(const Records<Dim>& records,
                                                 const Entities<Dim>& entities) const;
  /// Sends heat to nodes of other ranks home, unsummed; returns what others send here, sorted by
  /// key. Collective among neighbours.
  /// ended  what this rank found; afterwards what its own points get, sorted by key
  std::vector<HeatShare> send_heat(const Records<Dim>& records, const ContactNodes<Dim>& nodes,
                                   std::vector<EndedHeat>& ended) const;
  /// Sends what stands behind particles of this rank to the evaluators of their contacts, and
  /// hands what others send here to take(lower id, upper id, side of the upper). Collective among
  /// neighbours. sides  by candidate
  void send_sides(const Entities<Dim>& entities, std::span<const PairCandidate> candidates,
                  std::span<const PairSide> sides,
                  const std::function<void(GlobalId, GlobalId, const PairSide&)>& take) const;
  /// Brings the temperatures [K] of nodes that others own up to date. Collective among neighbours.
  void refresh_temperatures(std::vector<Real>& temperature) const;
  /// Brings what friction needs to know of the materials behind faces that others own up to date.
  /// Collective among neighbours.
  void refresh_materials(std::vector<SurfaceMaterial>& materials) const;
  /// Brings the tractions of the faces that others own up to date. Collective among neighbours.
  void refresh_tractions(Entities<Dim>& entities) const;

 private:
  void import_particles(const ImportBoxes<Dim>& boxes, Entities<Dim>& entities);
  Bytes pack_faces(const std::vector<LocalIndex>& chosen, const Entities<Dim>& entities) const;
  void unpack_faces(const Bytes& bytes, Entities<Dim>& entities,
                    std::vector<ContactFace<Dim>>& faces);
  void name_nodes(const ContactNodes<Dim>& nodes);
  LocalIndex find_node(LocalIndex surface, GlobalId id) const;
  LocalIndex node_of_letter(LocalIndex surface, GlobalId id) const;
  LocalIndex node_of(LocalIndex surface, GlobalId id, Real mass, const Vec<Dim>& x,
                     const Vec<Dim>& v, Entities<Dim>& entities);
  void plan(const ContactNodes<Dim>& nodes);
  template <class Letter, class Take>
  void deliver(std::vector<Packer>& to, const Take& take) const;
  void plan_temperatures(const ContactNodes<Dim>& nodes);
  void plan_tractions(const Entities<Dim>& entities);
  int owner_of(const Entities<Dim>& entities, const ContactFace<Dim>& face) const;
  void find_peers(const ContactNodes<Dim>& nodes);

  using Name = std::pair<LocalIndex, GlobalId>;  // surface, point
  ContactRanks ranks_;
  std::vector<Surface<Dim>*> surfaces_;
  std::vector<std::vector<LocalIndex>> node_of_point_;  // by surface and point; -1: none
  std::map<Name, LocalIndex> imported_;                 // nodes that others showed
  std::vector<GhostPlan> plans_;  // by surface: points of owners to nodes here
  std::vector<int> neighbours_;   // ranks that own nodes here, and ranks with own ones
  std::vector<int> peers_;        // those, and those of the tables before: of what has ended
  struct Sent {
    GhostPlan plan;
    std::vector<LocalIndex> from;  // own nodes, by their place in the plan
  };
  std::vector<Sent> temperatures_;     // by surface: of nodes, from their owners
  GhostPlan tractions_;                // of faces, from their owners
  std::vector<LocalIndex> sent_from_;  // faces that tractions_ names, by their place there
};

/// Sends each peer its letters and hands those of the peers to take(letter), rank by rank.
/// to  by rank; packed one by one
template <int Dim>
template <class Letter, class Take>
void ContactImports<Dim>::deliver(std::vector<Packer>& to, const Take& take) const {
  std::vector<Bytes> bytes;
  bytes.reserve(peers_.size());
  for (const int peer : peers_) bytes.push_back(to[slot_of(peer)].take());
  for (const Bytes& from : ranks().exchange(peers_, bytes)) {
    Unpacker unpacker(from);
    while (!unpacker.done()) {
      Letter letter;
      unpacker >> letter;
      take(letter);
    }
  }
}

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
