#pragma once
#include <map>

#include "app/scene/scene.hpp"

namespace brunt {

/// What history.csv prints of one rigid body.
struct RigidReport {
  bool one_piece = true;  ///< several pieces have no rotation and no spin together
  /// [m], [m/s] of the centre of a body without mass; relative to the scene's origin
  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
  Vec3 rotation = Vec3::Zero();  ///< [rad] axis times angle since time 0, the angle in [0, pi]
  Vec3 spin = Vec3::Zero();      ///< [rad/s]
  Vec3 force = Vec3::Zero();     ///< [N] of all that acts on it, but what holds or moves it
  Vec3 torque = Vec3::Zero();    ///< [N m] about its centre of mass; a body without mass: about
                                 ///< the point of its motion, held: the deck's origin
};

/// Rigid bodies by label, at a whole step. time [s]. Collective where some are held or of
/// prescribed motion.
template <int Dim>
std::map<Label, RigidReport> rigid_reports(const Scene<Dim>& scene, Real time);

}  // namespace brunt
