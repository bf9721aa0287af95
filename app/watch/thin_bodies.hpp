#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// Part of a body's mass that may lie in sheets and rows of particles without a warning.
inline constexpr Real kLargestThinShare = 0.1;

/// bodies.NAME.size
std::string thin_body_path(const std::string& body);

/// "30 % of the particles lie"
std::string thin_share_text(Real share);

/// Warns of each body the first time that over a tenth of its particles have neighbours in a plane
/// or on a line alone: such a layer is a membrane (docs/theory/sph.md (S9a)), whatever it was when
/// the run began. Energy is kept in it, so that no other watch sees what it no longer resists.
/// Bodies that are thin at time 0 are not reported: the setup has warned of them.
class ThinBodyWarnings {
 public:
  /// The bodies that are new, of the shares [1] of their mass by label at a time [s].
  std::vector<std::string> take(Real time, const std::vector<Real>& shares,
                                const std::vector<std::string>& names);
  /// One text a body, empty where it was thin at time 0.
  const std::map<std::string, std::string>& all() const { return warned_; }
  void restore(std::map<std::string, std::string> reported) { warned_ = std::move(reported); }

 private:
  std::map<std::string, std::string> warned_;
};

}  // namespace brunt
// Tested by tests/extremes/thin_particles_test.cpp.
