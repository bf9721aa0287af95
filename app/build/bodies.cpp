#include "app/build/bodies.hpp"

#include <stdexcept>

#include "core/geometry/mesh.hpp"

namespace brunt {

namespace {
template <int Dim>
BodyGeometry<Dim> make_body(const Deck& deck, const deck::Body& body, Label& next_piece) {
  BodyGeometry<Dim> geometry;
  const Sizing sizing{body.size, body.cells};
  std::vector<Label> piece;
  if (body.rigid) {
    auto surface = surface_of_shape<Dim>(body.shape, sizing, deck.geometry);
    geometry.points = std::move(surface.nodes);
    geometry.facets = std::move(surface.facets);
    geometry.piece_names = {""};
    piece = {0};
  } else if (body.method == deck::Method::fe) {
    auto mesh = mesh_shape<Dim>(body.shape, sizing, deck.geometry);
    geometry.points = std::move(mesh.nodes);
    geometry.elements = std::move(mesh.elements);
    geometry.piece_names = std::move(mesh.piece_names);
    piece = std::move(mesh.piece);
  } else {
    if (!body.size) {
      throw std::invalid_argument("a body of particles needs `size`, their spacing");
    }
    auto filling = fill_shape<Dim>(body.shape, *body.size, static_cast<LatticeKind>(body.lattice));
    geometry.points = std::move(filling.points);
    geometry.piece_names = std::move(filling.piece_names);
    geometry.volume = filling.volume;
    geometry.spacing = *body.size;
    piece = std::move(filling.piece);
  }
  for (const Label local : piece) geometry.piece.push_back(next_piece + local);
  next_piece += static_cast<Label>(geometry.piece_names.size());
  return geometry;
}
}  // namespace

template <int Dim>
std::vector<BodyGeometry<Dim>> make_bodies(const LoadedDeck& loaded,
                                           std::vector<DeckProblem>& problems) {
  std::vector<BodyGeometry<Dim>> bodies;
  Label next_piece = 0;
  for (std::size_t b = 0; b < loaded.deck.bodies.size(); ++b) {
    const auto& [name, body] = loaded.deck.bodies[b];
    try {
      bodies.push_back(make_body<Dim>(loaded.deck, body, next_piece));
      bodies.back().label = static_cast<Label>(b);
    } catch (const std::invalid_argument& error) {
      problems.push_back(loaded.places.problem("bodies." + name + ".shape", error.what()));
    }
  }
  return bodies;
}

template std::vector<BodyGeometry<2>> make_bodies<2>(const LoadedDeck&, std::vector<DeckProblem>&);
template std::vector<BodyGeometry<3>> make_bodies<3>(const LoadedDeck&, std::vector<DeckProblem>&);

}  // namespace brunt
