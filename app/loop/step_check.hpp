#pragma once
#include <string>
#include <utility>
#include <vector>

#include "app/scene/scene.hpp"
#include "io/summary.hpp"

namespace brunt {

/// The longest stable step of a group of elements or particles over its own step limit.
struct StepMargin {
  std::string body;  ///< whose element or particle bounds the group's step
  Real margin = 0;   ///< [1] below 1: the group has a step limit at which it is unstable
};

/// Finds how long a step each group of a scene really takes, and leaves the scene as it was.
///
/// The forces that are coded are stepped as in the run, leapfrog with a fixed step, from tiny
/// random velocities and about the present state: their change alone moves the points, so that what
/// is linear is left. A frequency omega above 2/dt, less where viscosity acts, grows and changes
/// its sign at every step; smooth growth, as of a body that buckles, does not count. The longest
/// step without growth is found by bisection between a quarter and four times the step limit.
/// Contacts, supports and loads are left out. Costs some 1,000 steps of forces. Collective.
template <int Dim>
std::vector<StepMargin> find_step_margins(Scene<Dim>& scene);

/// The smallest margin of each body over all checks of a run.
class StepCheck {
 public:
  /// Warnings of what is below 1 for the first time.
  std::vector<RunWarning> take(const std::vector<StepMargin>& found);
  /// Of all that was below 1 at any check.
  std::vector<RunWarning> warnings() const;
  const std::vector<std::pair<std::string, Real>>& margins() const { return margins_; }

  /// For a checkpoint, one text.
  std::string saved() const;
  void restore(const std::string& text);

 private:
  std::vector<std::pair<std::string, Real>> margins_;
};

}  // namespace brunt
