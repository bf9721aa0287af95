#include "app/watch/artificial_tension.hpp"

#include "app/deck/findings.hpp"

namespace brunt {

std::string artificial_stress_path(const std::string& body) {
  return "bodies." + body + ".artificial_stress";
}

std::vector<std::string> ArtificialTensionWarnings::take(Real time, const std::vector<Real>& shares,
                                                         const std::vector<std::string>& names) {
  std::vector<std::string> taken;
  for (std::size_t b = 0; b < shares.size() && b < names.size(); ++b) {
    if (!(shares[b] > kLargestArtificialShare) || warned_.count(names[b]) != 0) continue;
    warned_[names[b]] = "artificial stress carries " + deck::short_text(100 * shares[b]) +
                        " % of the tension at t = " + deck::time_text(time) +
                        ": stiffness and force in tension are wrong by as much; try "
                        "`artificial_stress: 0` with `smoothing: 1.7`";
    taken.push_back(names[b]);
  }
  return taken;
}

}  // namespace brunt
