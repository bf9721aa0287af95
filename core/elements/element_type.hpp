#pragma once
/// A kind of element as data, for all that treats elements of any kind alike.
#include <span>
#include <vector>

#include "core/elements/product_shape.hpp"

namespace brunt {

/// What one kind of element is. Its traits are a struct (Quad4, Hex8, ...) with the same in
/// constants, for kernels that are compiled for it.
struct ElementType {
  const char* name;  ///< as decks write it
  int dim, corners, faces;
  /// Corners of each face such that its normal points outwards (see Facet); -1: it has no more.
  std::array<std::array<int, 4>, kMostFaces> face{};
  std::array<int, kMostFaces> opposite{};  ///< the face across from each; -1: a corner is there
  /// Height over a face, over volume/area of the face [1].
  Real depth;
  LocalPlace center;
  void (*shape)(const LocalPlace& at, ShapeValues& out);
  /// False where a place lies outside by more than slack [1]; what lies within slack of a face is
  /// moved onto it.
  bool (*snap)(LocalPlace& at, Real slack);
};

template <class Element>
constexpr ElementType make_element_type() {
  ElementType type{Element::kName,
                   Element::kDim,
                   Element::kCorners,
                   static_cast<int>(Element::kFace.size()),
                   {},
                   {},
                   Element::kDepth,
                   Element::kCenter,
                   &Element::shape,
                   &Element::snap};
  for (std::size_t k = 0; k < Element::kFace.size(); ++k) {
    type.face[k] = {-1, -1, -1, -1};
    for (std::size_t i = 0; i < Element::kFace[k].size(); ++i) {
      type.face[k][i] = Element::kFace[k][i];
    }
    type.opposite[k] = Element::kOpposite[k];
  }
  return type;
}
template <class Element>
inline constexpr ElementType kElementType = make_element_type<Element>();

}  // namespace brunt
// Tested by tests/unit/fe/tet4_test.cpp.
