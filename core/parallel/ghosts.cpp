#include "core/parallel/ghosts.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/parallel/packing.hpp"

namespace brunt {

GhostPlan plan_ghosts(const Communicator& ranks, const std::vector<GlobalId>& id,
                      const std::vector<LocalIndex>& place, const std::vector<int>& owner,
                      std::span<const GlobalId> owned) {
  GhostPlan plan;
  if (ranks.alone()) return plan;
  const auto n = slot_of(ranks.size());
  std::vector<std::vector<GlobalId>> wanted(n);
  std::vector<std::vector<LocalIndex>> fill(n);
  for (std::size_t k = 0; k < id.size(); ++k) {
    const auto r = slot_of(owner[k]);
    wanted[r].push_back(id[k]);
    fill[r].push_back(place[k]);
  }
  std::vector<Bytes> requests(n);
  for (std::size_t r = 0; r < n; ++r) requests[r] = (Packer() << wanted[r]).take();
  const auto asked = ranks.exchange(requests);
  for (std::size_t r = 0; r < n; ++r) {
    std::vector<GlobalId> ids;
    Unpacker(asked[r]) >> ids;
    if (ids.empty() && fill[r].empty()) continue;
    GhostPlan::Peer peer{static_cast<int>(r), {}, std::move(fill[r])};
    for (const GlobalId one : ids) {
      const auto at = std::lower_bound(owned.begin(), owned.end(), one);
      if (at == owned.end() || *at != one) {
        throw std::logic_error("a rank was asked for point " + std::to_string(one) +
                               ", which it does not own");
      }
      peer.send.push_back(static_cast<LocalIndex>(at - owned.begin()));
    }
    plan.peers.push_back(std::move(peer));
  }
  return plan;
}

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
