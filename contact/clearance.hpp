#pragma once
/// Proofs that most listed faces of a particle are out of its reach, at two comparisons each.
#include "contact/entities.hpp"

namespace brunt {

/// What kept a particle from touching a face or voting for its speed when the lists were built;
/// in single precision, on the safe side. Small: it is all that is read of most candidates.
struct Clearance {
  LocalIndex entity = 0;  ///< the face of the candidate; of a row its particle
  float apart = 0;        ///< [m] between its sphere and the face's box, in the widest component
  float before = 0;       ///< [m] of its centre before the mean plane and its warp
  float arm = 0;          ///< [m] from the face's centre to its own

  /// Makes it that of all faces of a row.
  void take(const Clearance& other) {
    apart = std::min(apart, other.apart);
    before = std::min(before, other.before);
    arm = std::max(arm, other.arm);
  }
};

/// What motion since then has taken of all clearances at most, and how far speeds look ahead:
/// `apart` [m], `before` [m], and of that a turn [1] of the normal for each metre of arm.
/// With u the largest relative displacement of any two nodes in any component, a box is apart by
/// no less than apart - u; and n'.(x' - c') = n.(x - c) + (n' - n).(x - c) + n'.(u_x - u_c), of
/// which the last is at least -sqrt(Dim) u.
struct ClearanceLoss {
  Real apart = kInfinity, before = kInfinity, turn = kInfinity;

  /// True only if the particle, before the face and beside its box, can neither touch it nor vote.
  bool leaves(const Clearance& clearance) const {
    return clearance.apart > apart && clearance.before > before + turn * clearance.arm;
  }
};

/// Clearance at nodes.x; none where the surface has two sides.
template <int Dim>
Clearance clearance_of(const Entities<Dim>& entities, const ContactParticle& particle,
                       std::size_t face);

}  // namespace brunt
