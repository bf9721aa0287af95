#pragma once
#include <map>
#include <optional>

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

/// Where the centre of a rigid body without mass is, and how it moves, relative to the scene's
/// origin.
template <int Dim>
struct RigidPlace {
  Vec<Dim> position, velocity;  ///< [m], [m/s]
};

/// Of a body that is held or has a prescribed motion, at a time [s]; none of others.
template <int Dim>
std::optional<RigidPlace<Dim>> rigid_place(const Scene<Dim>& scene, Label body, Real time);

/// Rigid bodies by label, at a whole step. time [s]. Collective where some are held or of
/// prescribed motion.
template <int Dim>
std::map<Label, RigidReport> rigid_reports(const Scene<Dim>& scene, Real time);

}  // namespace brunt
