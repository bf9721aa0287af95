#pragma once
/// All kinds of elements. A kind is its traits (a struct as Hex8 is) and formulation(Hex8), which
/// is declared beside them; it is known to decks, frames and probes once it stands here.
#include "fe/elements/box.hpp"
#include "fe/elements/tet4.hpp"

namespace brunt {

template <class... Element>
struct ElementList {
  static constexpr std::array names = {Element::kName...};
  static constexpr std::array types = {&kElementType<Element>...};
  template <int Dim>
  static const Formulation<Dim>& formulation_at(std::size_t kind) {
    static const std::array<const Formulation<Dim>*, sizeof...(Element)> all = {
        &formulation(Element{})...};
    return *all.at(kind);
  }
};

template <int Dim>
struct ElementCatalog;
/// The first of each is what decks get that name none.
template <>
struct ElementCatalog<2> : ElementList<Quad4> {};
template <>
struct ElementCatalog<3> : ElementList<Hex8, Tet4> {};

/// kind  its place in the catalogue
template <int Dim>
const Formulation<Dim>& formulation_of(int kind) {
  return ElementCatalog<Dim>::template formulation_at<Dim>(slot_of(kind));
}

/// The kind of element with so many corners; null where there is none.
inline const ElementType* element_type(int dim, int corners) {
  const auto find = [&](const auto& types) -> const ElementType* {
    for (const ElementType* type : types) {
      if (type->corners == corners) return type;
    }
    return nullptr;
  };
  return dim == 2 ? find(ElementCatalog<2>::types) : find(ElementCatalog<3>::types);
}

}  // namespace brunt
// Tested by tests/unit/fe/tet4_test.cpp.
