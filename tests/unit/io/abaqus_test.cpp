// Input files of Abaqus: the block that all readers read, its element library, and what is refused.
#include "io/mesh/abaqus.hpp"

#include "io/mesh/catalog.hpp"
#include "tests/support/mesh_files.hpp"

namespace brunt {
namespace {
using test::BlockMesh;
using test::expect_refused;
using test::with;
using test::write_file;

TEST(Abaqus, ReadsABlockAndItsSets) {
  const BlockMesh block(3);
  const MeshFile mesh = read_abaqus(write_file("a.inp", test::abaqus_text(block)));
  test::expect_block(mesh, block);
  EXPECT_EQ(mesh.find("foot")->nodes.size(), 16u);
  EXPECT_EQ(mesh.find("base")->nodes, mesh.find("foot")->nodes);
  EXPECT_EQ(mesh.find("all")->nodes.size(), block.nodes.size());
  EXPECT_EQ(mesh.find("rest")->cells.size(), 27u);
  EXPECT_NE(mesh_reader("part.inp"), nullptr);
}

TEST(Abaqus, KnowsItsElementLibrary) {
  struct Case {
    const char* type;
    CellKind kind;
    int nodes;
  };
  using enum CellKind;
  for (const Case& one : {Case{"C3D8R", hex8, 8}, Case{"c3d8i", hex8, 8}, Case{"DC3D8", hex8, 8},
                          Case{"C3D4", tet4, 4}, Case{"C3D4H", tet4, 4}, Case{"C3D6", wedge6, 6},
                          Case{"C3D10M", higher3, 10}, Case{"C3D20R", higher3, 20},
                          Case{"CPE4R", quad4, 4}, Case{"CAX4", quad4, 4}, Case{"CPS3", tri3, 3},
                          Case{"S4R", quad4, 4}, Case{"STRI65", higher2, 6}, Case{"R3D4", quad4, 4},
                          Case{"B31", line2, 2}, Case{"T3D2", line2, 2}, Case{"DC2D4", quad4, 4}}) {
    std::string text = std::string("*NODE\n1, 0, 0, 0\n*ELEMENT, TYPE=") + one.type + "\n5";
    for (int i = 0; i < one.nodes; ++i) text += ", 1";
    const MeshFile mesh = read_abaqus(write_file("e.inp", text + "\n"));
    ASSERT_EQ(mesh.n_cells(), 1u) << one.type;
    EXPECT_EQ(mesh.kind[0], one.kind) << one.type;
  }
}

TEST(Abaqus, ReadsNumbersOfEveryKindAndLinesThatGoOn) {
  const MeshFile mesh = read_abaqus(write_file("n.inp",
                                               "*Node,\n nset=all\r\n"
                                               "  1 , 1.5D-3, -2.e+2\r\n2,+1,0\n"
                                               "*Element, type=T3D2\n7, 1, 2\n"
                                               "*Nset, nset=of_elements, elset=rods\n"
                                               "*Elset, elset=rods\n7\n,,7,\n"));
  EXPECT_EQ(mesh.nodes[0], Vec3(1.5e-3, -200, 0));
  EXPECT_EQ(mesh.nodes[1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.find("all")->nodes.size(), 2u);
  EXPECT_EQ(mesh.find("of_elements")->nodes.size(), 2u);
}

TEST(Abaqus, NamesWhatIsWrongWithFileAndLine) {
  const std::string text = test::abaqus_text(BlockMesh(1));
  const auto read = &read_abaqus;
  expect_refused(read, "a.inp", with(text, "C3D8R", "COH3D8"), {"TYPE=COH3D8", "a.inp:13"});
  expect_refused(read, "b.inp", with(text, "1, 7, ", "1, 8, "), {"element 1 (", "has node 8"});
  expect_refused(read, "c.inp", with(text, "\n77, 1.", "\n77, one"), {"c.inp:12", "one"});
  expect_refused(read, "d.inp", with(text, "\n77, 1.", "\n67, 1."), {"node 67", "another node"});
  expect_refused(read, "e.inp", with(text, ", 67\n", "\n"), {"element 1 has 7 nodes", "type 8"});
  const std::string cut = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n*ELEMENT, TYPE=T3D2\n1, 1, 2\n2, 1\n";
  expect_refused(read, "cut.inp", cut, {"element 2 has 1 nodes", "type 2"});  // where the file ends
  expect_refused(read, "f.inp", with(text, "*HEADING", "*INCLUDE, INPUT=b"), {"*INCLUDE", ":1:"});
  expect_refused(read, "g.inp", with(text, "*HEADING", "*PART, NAME=A\n*PART, NAME=B"),
                 {"second *PART", ":2:"});
  expect_refused(read, "h.inp", with(text, "generate\n1,", "generate\n7,"), {"range"});
  expect_refused(read, "i.inp", "*NODE\n1, 0, 0, 0\n", {"no *ELEMENT"});
  expect_refused(read, "j.inp", with(text, "elset=rest,", "nset=rest,"), {"*ELSET needs ELSET="});
  expect_refused(read, "k.inp", text + "*INSTANCE, NAME=A, PART=B\n1., 0., 0.\n", {"translate"});
}

TEST(Abaqus, SetsThatHoldEachOtherEnd) {
  const std::string text = test::abaqus_text(BlockMesh(1)) + "*Elset, elset=a\nb, b\n" +
                           "*Elset, elset=b\na, a, block\n";
  EXPECT_EQ(read_abaqus(write_file("s.inp", text)).find("a")->cells.size(), 1u);
}

TEST(Abaqus, ReadsOrRefusesEveryMutation) {
  test::mutate("m.inp", test::abaqus_text(BlockMesh(2)), [](const std::string& path) {
    const MeshFile mesh = read_abaqus(path);
    for (const int node : mesh.corner) ASSERT_LT(static_cast<std::size_t>(node), mesh.nodes.size());
  });
}

}  // namespace
}  // namespace brunt
