#include "app/watch/thin_bodies.hpp"

#include "app/deck/findings.hpp"

namespace brunt {

std::string thin_body_path(const std::string& body) { return "bodies." + body + ".size"; }

std::string thin_share_text(Real share) {
  if (share > 0.999) return "all particles lie";
  return deck::short_text(100 * share) + " % of the particles lie";
}

std::vector<std::string> ThinBodyWarnings::take(Real time, const std::vector<Real>& shares,
                                                const std::vector<std::string>& names) {
  std::vector<std::string> taken;
  for (std::size_t b = 0; b < shares.size() && b < names.size(); ++b) {
    if (!(shares[b] > kLargestThinShare) || warned_.count(names[b]) != 0) continue;
    std::string& text = warned_[names[b]];
    if (time == 0) continue;
    text = thin_share_text(shares[b]) + " in one layer at t = " + deck::time_text(time) +
           ": it resists neither bending nor strains across it, and forces on it are wrong; try a "
           "smaller size, so that more layers stay, or `method: fe`";
    taken.push_back(names[b]);
  }
  return taken;
}

}  // namespace brunt
