#pragma once
#include <vector>

#include "contact/contacts/record.hpp"

namespace brunt {

/// What one contact leaves on its upper face.
template <int Dim>
struct TractionShare {
  ContactKey key;
  Real area;        ///< [m^2]
  Real force[Dim];  ///< [N]
};

/// Sums what each face carries (FaceTraction), from contacts of all ranks in the order of keys.
template <int Dim>
class TractionSum {
 public:
  /// entities  their tractions, out;  elsewhere  from other ranks, sorted by key
  TractionSum(Entities<Dim>& entities, std::vector<TractionShare<Dim>> elsewhere);
  /// A contact of this rank, in the order of keys.
  void add(const ContactRecord<Dim>& record, const Friction<Dim>& friction);
  /// Adds what is left, and finds how areas have grown.
  void finish();

 private:
  void add(std::size_t face, Real area, const Vec<Dim>& force);
  void add_next();

  Entities<Dim>& entities_;
  std::vector<TractionShare<Dim>> elsewhere_;
  std::size_t next_ = 0;
  std::vector<Real> area_before_;  // [m^2]
};

/// How the area of a face grew in the last step (FaceTraction); of those that did.
struct FaceGrowth {
  ContactKey key;   ///< of two faces, of which it is the first
  Real growth = 1;  ///< [1]
  static constexpr const char* kTable = "contact.growth";
  template <class Visitor, class Growth>
  static void visit(Visitor& visitor, Growth& one) {
    visitor.carry(one.growth);
  }
};
template <int Dim>
KeyedMemory<FaceGrowth> growths_of(const Entities<Dim>& entities);
/// Gives the faces their growths, and those without one none.
template <int Dim>
void take_growths(const KeyedMemory<FaceGrowth>& growths, Entities<Dim>& entities);

}  // namespace brunt
