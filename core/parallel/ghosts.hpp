#pragma once
/// Copies of other ranks' entities: who has which, and how their values are brought up to date.
#include <vector>

#include "core/parallel/communicator.hpp"

namespace brunt {

/// Which of this rank's entities other ranks hold copies of, and where this rank's copies stand.
/// The lists of two ranks for each other name the same entities in the same order.
struct GhostPlan {
  struct Peer {
    int rank = 0;
    std::vector<LocalIndex> send;  ///< places of what is owned here
    std::vector<LocalIndex> fill;  ///< places of the copies
  };
  std::vector<Peer> peers;  ///< ascending by rank
  bool empty() const { return peers.empty(); }
};

/// Sends `width` doubles of each entity from its owner to its copies: pack(i, out) reads those of
/// place i, unpack(i, in) writes them. Collective among peers.
template <class Pack, class Unpack>
void refresh_ghosts(const Communicator& ranks, const GhostPlan& plan, std::size_t width, Pack pack,
                    Unpack unpack) {
  if (plan.empty()) return;
  std::vector<std::vector<Real>> out(plan.peers.size()), in(plan.peers.size());
  std::vector<Message> messages;
  for (std::size_t p = 0; p < plan.peers.size(); ++p) {
    const auto& peer = plan.peers[p];
    out[p].resize(peer.send.size() * width);
    in[p].resize(peer.fill.size() * width);
    for (std::size_t k = 0; k < peer.send.size(); ++k) {
      pack(slot_of(peer.send[k]), out[p].data() + k * width);
    }
    messages.push_back({peer.rank, std::as_bytes(std::span<const Real>(out[p])),
                        std::as_writable_bytes(std::span<Real>(in[p]))});
  }
  ranks.trade(messages);
  for (std::size_t p = 0; p < plan.peers.size(); ++p) {
    const auto& fill = plan.peers[p].fill;
    for (std::size_t k = 0; k < fill.size(); ++k) {
      unpack(slot_of(fill[k]), in[p].data() + k * width);
    }
  }
}

/// The plan of copies that each rank asks for: ghost k, of global id id[k], stands at place[k] and
/// belongs to rank owner[k]. owned: ids of what is owned here, ascending, place = index.
/// Collective. Throws std::logic_error where a rank does not own what is asked of it.
GhostPlan plan_ghosts(const Communicator& ranks, const std::vector<GlobalId>& id,
                      const std::vector<LocalIndex>& place, const std::vector<int>& owner,
                      std::span<const GlobalId> owned);

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
