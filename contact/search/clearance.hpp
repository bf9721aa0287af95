#pragma once
/// Proofs that most listed faces of a particle are out of its reach, at two comparisons each.

#include "contact/surfaces/entities.hpp"
#include "core/simd_float.hpp"

namespace brunt {

/// What kept a particle from touching a face or bounding the step by its speed when the lists were
/// built; in single precision, on the safe side. Small: it is all that is read of most candidates.
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

  /// True only if the particle, before the face and beside its box, can neither touch it nor bound
  /// the step.
  bool leaves(const Clearance& clearance) const {
    return clearance.apart > apart && clearance.before > before + turn * clearance.arm;
  }
};

/// The clearances of many candidates, four side by side in a line of the cache.
class Clearances {
 public:
  void resize(std::size_t n) { blocks_.resize((n + kLanes - 1) / kLanes); }
  void set(std::size_t i, const Clearance& one) {
    auto& block = blocks_[i / kLanes];
    const std::size_t k = i % kLanes;
    block.entity[k] = one.entity, block.apart[k] = one.apart;
    block.before[k] = one.before, block.arm[k] = one.arm;
  }
  std::size_t entity(std::size_t i) const {
    return slot_of(blocks_[i / kLanes].entity[i % kLanes]);
  }
  /// Entities of first .. last, in their order, to `near`, which has room for four more: all that
  /// the loss does not leave out, and few more. Returns how many.
  std::size_t find_near(std::size_t first, std::size_t last, const ClearanceLoss& loss,
                        LocalIndex* near) const {
    const FloatPack apart = raised(loss.apart), before = raised(loss.before),
                    turn = raised(loss.turn);
    unsigned among = 0b1111U << (first % kLanes);
    std::size_t found = 0;
    for (std::size_t b = first / kLanes; b * kLanes < last; ++b) {
      const Block& block = blocks_[b];
      const FloatPack least = before + turn * load_floats(block.arm);
      const unsigned left =
          mask_bits((load_floats(block.apart) > apart) & (load_floats(block.before) > least));
      if (b * kLanes + kLanes > last) among &= 0b1111U >> (kLanes - last % kLanes);
      const unsigned kept = ~left & among & 0b1111U;
      among = 0b1111U;
      store_permuted(near + found, block.entity, kCompression.lane[kept]);
      found += slot_of(kCompression.count[kept]);
    }
    return found;
  }

 private:
  struct alignas(64) Block {
    LocalIndex entity[kLanes] = {};
    float apart[kLanes] = {}, before[kLanes] = {}, arm[kLanes] = {};
  };
  /// In single precision, and more by what its rounding may take from it and from sums with it.
  static FloatPack raised(Real loss) {
    return broadcast_float(static_cast<float>(loss * (1 + kRounding)));
  }
  static constexpr Real kRounding = 1e-6;

  std::vector<Block> blocks_;
};

/// Clearance at nodes.x; none where the surface has two sides.
template <int Dim>
Clearance clearance_of(const Entities<Dim>& entities, const ContactParticle& particle,
                       std::size_t face);

}  // namespace brunt
