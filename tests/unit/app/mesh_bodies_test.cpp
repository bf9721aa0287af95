// Bodies from mesh files: what is taken, and what is refused with the element's name and a way out.
#include "app/setup/mesh_bodies.hpp"

#include <algorithm>

#include "app/deck/loader.hpp"
#include "app/setup/scene_builder.hpp"
#include "io/mesh/catalog.hpp"
#include "tests/support/mesh_files.hpp"

namespace brunt {
namespace {
using test::BlockMesh;
using test::with;
using test::write_file;

deck::Body body_of(const std::string& path, const std::string& part = "") {
  deck::Body body;
  body.file = path, body.part = part, body.scale = 0.5;
  return body;
}

template <int Dim = 3>
BodyGeometry<Dim> taken(const deck::Body& body, std::vector<Label>& piece) {
  BodyGeometry<Dim> geometry;
  MeshFiles files;
  take_mesh_elements<Dim>(body, files.read(body.file), 1'000'000, geometry, piece);
  return geometry;
}

template <int Dim = 3>
void expect_refused(const deck::Body& body, const std::vector<std::string>& words) {
  try {
    std::vector<Label> piece;
    taken<Dim>(body, piece);
    FAIL() << "was taken: " << words.front();
  } catch (const std::invalid_argument& error) {
    for (const std::string& word : words) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << "'" << word << "' is not in: " << error.what();
    }
  }
}

std::string block_file(int n) {
  return write_file("block.msh", test::gmsh2_text(BlockMesh(n), false));
}

TEST(MeshBodies, TakeAPartScaled) {
  std::vector<Label> piece;
  for (const char* part : {"", "block"}) {
    const auto geometry = taken(body_of(block_file(2), part), piece);
    EXPECT_EQ(geometry.elements.size(), 8u);
    EXPECT_EQ(geometry.points.size(), 27u);
    EXPECT_EQ(geometry.points.back(), Vec3::Constant(1));
    EXPECT_EQ(geometry.shortest_edge, 0.5);
    EXPECT_EQ(geometry.piece_names, std::vector<std::string>{""});
    EXPECT_TRUE(geometry.notes.empty());
    ASSERT_EQ(geometry.sets.size(), 2u);
    EXPECT_EQ(geometry.sets[1].name, "foot");
    EXPECT_EQ(geometry.sets[1].points.size(), 9u);
  }
}

TEST(MeshBodies, CutHexahedraIntoTetrahedra) {
  deck::Body body = body_of(block_file(2));
  body.element.type = 1;
  std::vector<Label> piece;
  const auto geometry = taken(body, piece);
  EXPECT_EQ(geometry.elements.size(), 48u);
  EXPECT_EQ(geometry.elements.type->corners, 4);
  EXPECT_EQ(piece.size(), 48u);
}

const std::string kHead = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n";

/// Nodes of a unit cube, of its neighbour along x, and of the elements given.
std::string file_of(const std::string& elements, int count, const char* place = "2 2 0") {
  return kHead + "13\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n" +
         "9 2 0 0\n10 2 1 0\n11 2 0 1\n12 2 1 1\n13 " + place + "\n$EndNodes\n$Elements\n" +
         std::to_string(count) + "\n" + elements + "$EndElements\n";
}
const std::string kFirst = "1 5 2 1 1 1 2 3 4 5 6 7 8\n",
                  kSecond = "2 5 2 1 1 2 9 10 3 6 11 12 7\n";

deck::Body written(const std::string& bytes, const std::string& part = "") {
  return body_of(write_file("small.msh", bytes), part);
}

TEST(MeshBodies, RefuseWhatNoElementIsMadeOf) {
  expect_refused(written(file_of("7 6 2 1 1 1 2 3 5 6 7\n", 1)),
                 {"wedges", "element 7", "small.msh:22", "tetrahedra alone"});
  expect_refused(written(file_of("7 11 2 1 1 1 2 3 5 6 7 8 9 10 11\n", 1)),
                 {"higher order", "Mesh.ElementOrder"});
  expect_refused(written(file_of("7 2 2 1 1 1 2 3\n", 1)), {"triangles", "shells", "rigid: true"});
  expect_refused(written(file_of("7 1 2 1 1 1 2\n", 1)), {"lines", "beams"});
  expect_refused<2>(written(file_of("7 2 2 1 1 1 2 3\n", 1)), {"triangles", "recombine"});
  expect_refused<2>(written(file_of(kFirst, 1)), {"hexahedra", "geometry: 3d"});
  expect_refused(written(file_of(kFirst + "7 4 2 1 1 2 9 10 6\n", 2)),
                 {"hexahedra and tetrahedra", "two bodies"});
  expect_refused(body_of(block_file(1), "blok"), {"'blok'", "did you mean 'block'", "'foot' (1"});
}

// A type that no kind stands for may be a solid: it is refused, unless a part leaves it out.
TEST(MeshBodies, RefuseElementsOfNoKnownKind) {
  const std::string text =
      with(test::abaqus_text(BlockMesh(1)), "*Material",
           "*Element, type=COH3D8, elset=glue\n9, 7, 17, 27, 37, 7, 17, 27, 37\n"
           "*Element, type=MASS, elset=points\n10, 7\n*Material");
  const std::string path = write_file("glue.inp", text);
  expect_refused(body_of(path), {"glue.inp has elements of no known kind, as element 9 (",
                                 "of TYPE=COH3D8", "take a `part` without them"});
  expect_refused<2>(body_of(path), {"elements of no known kind"});
  expect_refused(body_of(path, "glue"), {"'glue' of ", "elements of no known kind"});
  expect_refused(body_of(path, "points"), {"points: beams and points are not in this version"});
  std::vector<Label> piece;
  EXPECT_EQ(taken(body_of(path, "block"), piece).elements.size(), 1u);
}

// A part says what it takes; of the whole file it is said what is not taken.
TEST(MeshBodies, SayWhatOfTheWholeFileIsPassedOver) {
  const std::string path = write_file("mass.inp", with(test::abaqus_text(BlockMesh(1)), "*Material",
                                                       "*Element, type=MASS\n10, 7\n*Material"));
  for (const std::string part : {"", ", part: block"}) {
    const auto scene = build_scene<3>(load_deck_text(
        "time: {end: 1 us}\nmaterials: {s: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}}}\n"
        "bodies: {a: {material: s, scale: 1 mm, file: " +
            path + part + "}}\n",
        "deck"));
    const auto told = std::count_if(scene->notes.begin(), scene->notes.end(), [](const auto& note) {
      return note.find("a: elements of TYPE=MASS (") == 0;
    });
    EXPECT_EQ(told, part.empty() ? 1 : 0);
  }
}

TEST(MeshBodies, NameWhatIsWrongWithElements) {
  expect_refused(written(file_of(kFirst + "2 5 2 1 1 2 9 10 3 6 11 7 7\n", 2)),
                 {"degenerate", "element 2 (", "small.msh:23"});
  expect_refused(written(file_of(kFirst + "2 5 2 1 1 6 11 12 7 2 9 10 3\n", 2)),
                 {"inverted", "element 2"});
  expect_refused(written(file_of("1 5 2 1 1 5 6 7 8 1 2 3 4\n", 1)), {"the other way round"});
  expect_refused(written(file_of(kFirst + "2 5 2 1 1 2 3 4 1 6 7 8 5\n", 2)),
                 {"duplicate", "element 1 (", " = element 2 ("});
  expect_refused<2>(written(file_of("1 3 2 1 1 1 2 3 4\n2 3 2 1 1 2 9 13 7\n", 2)),
                    {"node 7", "plane"});
}

TEST(MeshBodies, TurnQuadrilateralsThatRunClockwise) {
  std::vector<Label> piece;
  const auto geometry =
      taken<2>(written(file_of("1 3 2 1 1 4 3 2 1\n2 3 2 1 1 2 9 10 3\n", 2)), piece);
  EXPECT_EQ(geometry.elements.size(), 2u);
  EXPECT_EQ(geometry.points.size(), 6u);
}

TEST(MeshBodies, MakePiecesOfWhatIsApart) {
  std::vector<Label> piece;
  const std::string nodes =
      "9\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n7 2 2 0\n8 1 2 0\n9 5 5 0\n";
  const std::string elements = "$EndNodes\n$Elements\n2\n1 3 2 1 1 1 2 3 4\n";
  const auto apart =
      taken<2>(written(kHead + nodes + elements + "2 3 2 1 1 5 6 7 8\n$EndElements\n"), piece);
  EXPECT_EQ(apart.piece_names, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(piece, (std::vector<Label>{0, 1}));
  ASSERT_EQ(apart.notes.size(), 1u);
  EXPECT_NE(apart.notes[0].find("1 nodes lie in the places of others, as node 5"),
            std::string::npos);
  const auto joined =
      taken<2>(written(kHead + nodes + elements + "2 3 2 1 1 3 6 7 8\n$EndElements\n"), piece);
  EXPECT_EQ(joined.piece_names, std::vector<std::string>{""});
  ASSERT_EQ(joined.notes.size(), 1u);
  EXPECT_NE(joined.notes[0].find("turn about them: node 3"), std::string::npos);
}

// Cubes of 4 mm that share no node, 1 mm apart: as many pieces of the same names, whether they are
// elements or filled with 4^3 particles each.
TEST(MeshBodies, MakePiecesOfParticlesWhereShellsAreApart) {
  BlockMesh apart(4);
  const BlockMesh one(4);
  const int shift = static_cast<int>(one.nodes.size());
  for (const Vec3& x : one.nodes) apart.nodes.push_back(x + Vec3(0, 0, 5));
  for (auto hex : one.hexes) {
    for (int& node : hex) node += shift;
    apart.hexes.push_back(hex);
  }
  const std::string path = write_file("apart.msh", test::gmsh2_text(apart, false));
  for (const bool particles : {false, true}) {
    const auto scene = build_scene<3>(
        load_deck_text("time: {end: 1 us}\n"
                       "materials: {steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}}}\n"
                       "bodies: {blocks: {material: steel, scale: 1 mm, file: " +
                           path + (particles ? ", method: sph, size: 1 mm" : "") + "}}\n",
                       "deck.yaml"));
    ASSERT_EQ(scene->pieces.size(), 2u);
    EXPECT_EQ(scene->pieces[0].name, "blocks.1");
    EXPECT_EQ(scene->pieces[1].name, "blocks.2");
    for (int k = 0; k < 2; ++k) {
      const BodyView view = scene->part_view(scene->pieces[slot_of(k)].name);
      EXPECT_EQ(view.position.size(), 3u * (particles ? 64 : 125));
      for (std::size_t i = 2; i < view.position.size(); i += 3) {
        EXPECT_EQ(view.position[i] > 4.5e-3, k == 1) << view.position[i];
      }
    }
  }
}

TEST(MeshBodies, RigidOnesTakeSurfaces) {
  BodyGeometry<3> geometry;
  MeshFiles files;
  deck::Body body = body_of(block_file(2));
  body.rigid = true;
  take_mesh_facets<3>(body, files.read(body.file), geometry);
  EXPECT_EQ(geometry.facets.size(), 24u);
  EXPECT_EQ(geometry.points.size(), 26u);  // without the node inside
  BodyGeometry<3> foot;
  body.part = "foot";
  take_mesh_facets<3>(body, files.read(body.file), foot);
  EXPECT_EQ(foot.facets.size(), 4u);
  EXPECT_EQ(foot.points.size(), 9u);
  body.part.clear();
  const StlSurface surface = mesh_surface(body, files.read(body.file));
  EXPECT_EQ(surface.triangles.size(), 48u);
}

// From the file to elements: refused with what the deck's author reads, whatever was done to it.
TEST(MeshBodies, TakeOrRefuseEveryMutation) {
  const std::string bytes = test::gmsh2_text(BlockMesh(2), false);
  test::mutate("m.msh", bytes, [](const std::string& path) {
    std::vector<Label> piece;
    const auto geometry = taken(body_of(path), piece);
    ASSERT_EQ(piece.size(), geometry.elements.size());
  });
}

}  // namespace
}  // namespace brunt
