#include "app/setup/bodies.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/deck/findings.hpp"
#include "app/setup/heat.hpp"
#include "app/setup/mesh_bodies.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/one_side.hpp"
#include "core/geometry/placement.hpp"
#include "fe/element_block.hpp"
#include "io/stl.hpp"

namespace brunt {

namespace {
/// Twice the area of a quad, or 64 times the Jacobian of a hex at its centre.
template <int Dim>
Real orientation(const std::array<Vec<Dim>, Shape<Dim>::kCorners>& x) {
  if constexpr (Dim == 2) {
    const Vec<2> a = x[2] - x[0], b = x[3] - x[1];
    return a[0] * b[1] - a[1] * b[0];
  } else {
    const Vec3 xi = (x[1] + x[2] + x[5] + x[6]) - (x[0] + x[3] + x[4] + x[7]);
    const Vec3 eta = (x[2] + x[3] + x[6] + x[7]) - (x[0] + x[1] + x[4] + x[5]);
    const Vec3 zeta = (x[4] + x[5] + x[6] + x[7]) - (x[0] + x[1] + x[2] + x[3]);
    return xi.dot(eta.cross(zeta));
  }
}

/// The elements of a mesh, cut into those of a kind. Throws std::invalid_argument where one folds
/// over.
template <int Dim>
void take_elements(const Mesh<Dim>& mesh, const Formulation<Dim>& kind, BodyElements& elements,
                   std::vector<Label>& piece) {
  const auto require = [&](bool sound, int node) {
    if (sound) return;
    const auto& x = mesh.nodes[node];
    throw std::invalid_argument(
        "its mesh folds over near (" + deck::short_text(x[0]) + ", " + deck::short_text(x[1]) +
        ") m: put `corners` where the outline turns, or fill it with particles (method: sph)");
  };
  elements.type = &kind.type();
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& box = mesh.elements[e];
    std::array<Vec<Dim>, Shape<Dim>::kCorners> x;
    for (std::size_t c = 0; c < x.size(); ++c) x[c] = mesh.nodes[box[c]];
    require(orientation<Dim>(x) > 0, box[0]);
    kind.cut_box(box, elements.corner);
    piece.resize(elements.size(), mesh.piece[e]);
    if (e > 0) continue;
    elements.corner.reserve(elements.corner.size() * mesh.elements.size());
    piece.reserve(piece.size() * mesh.elements.size());
  }
  if (elements.size() == mesh.elements.size()) return;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    std::vector<Vec<Dim>> x;
    for (const int node : elements[e]) x.push_back(mesh.nodes[node]);
    require(kind.volume(x, true, Thickness{}) > 0, elements[e][0]);
  }
}

/// Throws std::invalid_argument where a body crosses the axis.
template <int Dim>
void require_one_side_of_axis(const BodyGeometry<Dim>& body, Geometry geometry) {
  if (geometry != Geometry::axisymmetric) return;
  Real low = 0, high = 0;
  for (const auto& x : body.points) low = std::min(low, x[0]), high = std::max(high, x[0]);
  constexpr Real kRoundOff = 1e-9;
  if (low >= -kRoundOff * high) return;
  throw std::invalid_argument("reaches across the axis to x = " + deck::length_text(low) +
                              ": x is the radius and never negative; a full bar begins at x = 0");
}

/// A body's file, which is named from the deck's folder.
std::string file_of(const LoadedDeck& loaded, const Named<deck::Body>& named) {
  const std::filesystem::path deck_file =
      loaded.places.place("bodies." + named.name + ".file").file;
  return (deck_file.parent_path() / named.value.file).string();
}

/// The surface in an STL file, scaled.
StlSurface read_surface(const std::string& path, const deck::Body& body) {
  StlSurface surface = read_stl(path);
  for (Vec3& x : surface.nodes) x *= body.scale;
  return surface;
}

/// What a body takes from an STL file: the surface itself where it is rigid, else the particles
/// that fill it, in a lattice along the axes of the file.
void take_surface(const deck::Body& body, StlSurface surface, int max_cells,
                  BodyGeometry<3>& geometry, std::vector<Label>& piece) {
  geometry.left_out = surface.degenerate;
  std::vector<std::array<int, 4>> faces;
  for (const auto& [a, b, c] : surface.triangles) faces.push_back({a, b, c, -1});
  if (body.rigid) {
    require_one_side(surface.nodes, surface.triangles);
    face_outward(surface.nodes, faces, geometry.notes);
    geometry.points = std::move(surface.nodes);
    geometry.facets = std::move(faces);
    geometry.piece_names = {""};
    piece.assign(geometry.facets.size(), 0);
  } else {
    turn_outward(surface.nodes, faces);  // what is open, or badly turned, is refused next
    for (std::size_t f = 0; f < faces.size(); ++f) {
      std::copy_n(faces[f].begin(), 3, surface.triangles[f].begin());
    }
    const ClosedSurface closed(std::move(surface.nodes), std::move(surface.triangles),
                               body.size->front());
    Real count = closed.volume();
    for (std::size_t c = 0; c < 3; ++c) count /= (*body.size)[std::min(c, body.size->size() - 1)];
    if (count > max_cells) {
      throw std::invalid_argument("makes about " + deck::short_text(count) +
                                  " particles, more than max_cells, " + std::to_string(max_cells) +
                                  ": look at `scale`, the length of a unit of the file, and "
                                  "`size`; where so many are meant, raise max_cells");
    }
    auto filling = fill_surface(closed, *body.size, static_cast<LatticeKind>(body.lattice));
    geometry.points = std::move(filling.points);
    geometry.volume = filling.volume;
    geometry.spacing = *body.size;
    geometry.piece_names = std::move(filling.piece_names);
    piece = std::move(filling.piece);
    if (filling.empty > 0) {
      geometry.notes.push_back("closed surfaces left empty, as no particle fits in: " +
                               std::to_string(filling.empty) + "; a smaller `size` fills them");
    }
  }
  place_all<3>(body.shape, geometry.points);
}

/// A body from a file: elements of a mesh, or a surface.
template <int Dim>
void take_file(const LoadedDeck& loaded, const Named<deck::Body>& named, bool conducts,
               MeshFiles& files, BodyGeometry<Dim>& geometry, std::vector<Label>& piece) {
  const deck::Body& body = named.value;
  const int max_cells = loaded.deck.max_cells;
  const std::string path = file_of(loaded, named);
  const bool is_mesh = deck::has_mesh_file(body), is_surface = body.rigid && !conducts;
  // A part says what it takes; of the whole file it is said what is not taken.
  if (is_mesh && body.part.empty()) geometry.notes = files.read(path).notes;
  if (is_mesh && !is_surface && body.method == deck::Method::fe) {
    take_mesh_elements<Dim>(body, files.read(path), max_cells, geometry, piece);
    return;
  }
  if (!is_mesh && body.rigid && conducts) {
    throw std::invalid_argument(
        "is a surface, and has no elements inside that could conduct heat: take k out of the "
        "material, or fill a `shape` instead");
  }
  if (is_mesh && is_surface) {
    take_mesh_facets<Dim>(body, files.read(path), geometry);
    piece.assign(geometry.facets.size(), 0);
  } else if constexpr (Dim == 3) {
    take_surface(body, is_mesh ? mesh_surface(body, files.read(path)) : read_surface(path, body),
                 max_cells, geometry, piece);
  } else {
    throw std::invalid_argument("particles fill a file in geometry: 3d alone: write a `shape`");
  }
}

template <int Dim>
BodyGeometry<Dim> make_body(const LoadedDeck& loaded, const Named<deck::Body>& named, bool conducts,
                            MeshFiles& files, Label& next_piece) {
  const Deck& deck = loaded.deck;
  const deck::Body& body = named.value;
  BodyGeometry<Dim> geometry;
  const Sizing sizing{body.size, body.cells, body.grading};
  std::vector<Label> piece;
  if (!body.file.empty()) {
    take_file<Dim>(loaded, named, conducts, files, geometry, piece);
  } else if (body.rigid && !conducts) {
    auto surface = surface_of_shape<Dim>(body.shape, sizing, deck.geometry);
    geometry.points = std::move(surface.nodes);
    geometry.facets = std::move(surface.facets);
    // What is held or has a prescribed motion is one surface, whatever it is made of.
    const bool by_piece = deck::follows_forces(body);
    geometry.piece_names = by_piece ? std::move(surface.piece_names) : std::vector<std::string>{""};
    piece = by_piece ? std::move(surface.piece) : std::vector<Label>(geometry.facets.size(), 0);
  } else if (body.method == deck::Method::fe) {
    if (!body.size && !body.cells) {
      throw std::invalid_argument("conducts heat, and needs `size` or `cells` for its elements");
    }
    auto mesh = mesh_shape<Dim>(body.shape, sizing, deck.geometry);
    take_elements(mesh, formulation_of<Dim>(body.element.type), geometry.elements, piece);
    geometry.points = std::move(mesh.nodes);
    geometry.piece_names = std::move(mesh.piece_names);
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
  require_one_side_of_axis(geometry, deck.geometry);
  for (Label& local : piece) local += next_piece;
  geometry.piece = std::move(piece);
  next_piece += static_cast<Label>(geometry.piece_names.size());
  return geometry;
}
}  // namespace

template <int Dim>
std::vector<BodyGeometry<Dim>> make_bodies(const LoadedDeck& loaded,
                                           std::vector<DeckProblem>& problems) {
  std::vector<BodyGeometry<Dim>> bodies;
  Label next_piece = 0;
  MeshFiles files;
  for (std::size_t b = 0; b < loaded.deck.bodies.size(); ++b) {
    const auto& [name, body] = loaded.deck.bodies[b];
    if (const auto wrong = heat_problem(body, name); !wrong.empty()) {
      problems.push_back(loaded.places.problem("bodies." + name + ".material", wrong));
      continue;
    }
    try {
      const bool conducts = heat_mode(loaded.deck, body, name) == HeatMode::conducts;
      bodies.push_back(make_body<Dim>(loaded, loaded.deck.bodies[b], conducts, files, next_piece));
      bodies.back().label = static_cast<Label>(b);
    } catch (const GradingError& error) {
      problems.push_back(loaded.places.problem("bodies." + name + ".grading", error.what()));
    } catch (const std::invalid_argument& error) {
      const char* key = body.file.empty() ? ".shape" : ".file";
      problems.push_back(loaded.places.problem("bodies." + name + key, error.what()));
    } catch (const std::runtime_error& error) {
      problems.push_back(loaded.places.problem("bodies." + name + ".file", error.what()));
    }
  }
  return bodies;
}

template std::vector<BodyGeometry<2>> make_bodies<2>(const LoadedDeck&, std::vector<DeckProblem>&);
template std::vector<BodyGeometry<3>> make_bodies<3>(const LoadedDeck&, std::vector<DeckProblem>&);

}  // namespace brunt
