#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// Part of a body's tension that its artificial stress may carry without a warning.
inline constexpr Real kLargestArtificialShare = 0.01;

/// bodies.NAME.artificial_stress
std::string artificial_stress_path(const std::string& body);

/// Warns of each body the first time that artificial stress carries over 1 % of its tension: its
/// modulus and all forces in tension are wrong by as much.
class ArtificialTensionWarnings {
 public:
  /// The bodies that are new, of the shares [1] by label at a time [s].
  std::vector<std::string> take(Real time, const std::vector<Real>& shares,
                                const std::vector<std::string>& names);
  /// One text a body.
  const std::map<std::string, std::string>& all() const { return warned_; }
  void restore(std::map<std::string, std::string> reported) { warned_ = std::move(reported); }

 private:
  std::map<std::string, std::string> warned_;
};

}  // namespace brunt
