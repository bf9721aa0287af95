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
  for (const Case& one :
       {Case{"C3D8R", hex8, 8},      Case{"c3d8i", hex8, 8},      Case{"DC3D8", hex8, 8},
        Case{"C3D4", tet4, 4},       Case{"C3D4H", tet4, 4},      Case{"C3D6", wedge6, 6},
        Case{"C3D10M", higher3, 10}, Case{"C3D20R", higher3, 20}, Case{"CPE4R", quad4, 4},
        Case{"CAX4", quad4, 4},      Case{"CPS3", tri3, 3},       Case{"S4R", quad4, 4},
        Case{"STRI65", higher2, 6},  Case{"R3D4", quad4, 4},      Case{"B31", line2, 2},
        Case{"T3D2", line2, 2},      Case{"DC2D4", quad4, 4},     Case{"DS4", quad4, 4},
        Case{"SAX1", line2, 2},      Case{"DC1D2", line2, 2},     Case{"PIPE31H", line2, 2},
        Case{"AC2D4", quad4, 4},     Case{"MASS", point1, 1},     Case{"SPRINGA", point1, 2},
        Case{"CONN3D2", point1, 2},  Case{"COH3D8", other, 8},    Case{"SC8R", other, 8},
        Case{"U1", other, 3}}) {
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

// Eight nodes of a cube and one hexahedron, line 1 to 11; further lines follow.
std::string cube(const std::string& more) {
  return "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, "
         "1\n"
         "8, 0, 1, 1\n*ELEMENT, TYPE=C3D8R, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n" +
         more;
}
MeshFile cube_mesh(const std::string& more) {
  return read_abaqus(write_file("cube.inp", cube(more)));
}

TEST(Abaqus, TakesNamesInAnyCase) {
  const MeshFile mesh = cube_mesh(
      "*ELSET, ELSET=Both\ne\n*ELSET, ELSET=BOTH\n1\n*NSET, NSET=top\n5, 6\n*NSET, NSET=Top\n7\n"
      "*NSET, NSET=all\nTOP, 1\n*NSET, NSET=corners, ELSET=both\n*SURFACE, NAME=s\nboth, s1\n"
      "*SURFACE, NAME=S\n1, S4\n");
  EXPECT_EQ(mesh.find("Both")->cells, std::vector<int>{0});
  EXPECT_EQ(mesh.find("BOTH"), nullptr);  // is the set that was written Both first
  EXPECT_EQ(mesh.find("top")->nodes, (std::vector<int>{4, 5, 6}));
  EXPECT_EQ(mesh.find("all")->nodes, (std::vector<int>{0, 4, 5, 6}));
  EXPECT_EQ(mesh.find("corners")->nodes.size(), 8u);
  EXPECT_EQ(mesh.find("s")->nodes, (std::vector<int>{0, 1, 2, 3, 5, 6}));
}

// Between quotes blanks and commas are of a name, and so is the case of letters.
TEST(Abaqus, TakesNamesInQuotes) {
  const MeshFile mesh = cube_mesh(
      "*ELSET, ELSET=\"The plate, left\"\n1\n*ELSET, ELSET=\"Plate 1\"\n1\n"
      "*ELSET, ELSET=\"plate 1\"\n2\n*ELSET, ELSET=b\n\"Plate 1\"\n");
  EXPECT_EQ(mesh.find("b")->cells, std::vector<int>{0});
  EXPECT_NE(mesh.find("The plate, left"), nullptr);
  EXPECT_EQ(mesh.find("plate 1"), nullptr);  // has none of the file's elements
  expect_refused(&read_abaqus, "q.inp",
                 cube("*ELSET, ELSET=\"Plate 1\"\n1\n*ELSET, ELSET=b\n\"PLATE 1\"\n"),
                 {"q.inp:15: 'b' takes 'PLATE 1', and there is no *ELSET of that name"});
}

TEST(Abaqus, RefusesSetsThatAreNowhere) {
  const auto read = &read_abaqus;
  expect_refused(read, "a.inp", cube("*ELSET, ELSET=both\n1, MISSING\n"),
                 {"a.inp:13: 'both' takes 'MISSING', and there is no *ELSET",
                  "name in the file: write that set"});
  expect_refused(read, "b.inp", cube("*NSET, NSET=plates\n1\n*NSET, NSET=n\n2\nplate, 3\n"),
                 {"b.inp:16: 'n' takes 'plate'", "no *NSET", "did you mean 'plates'?"});
  expect_refused(read, "c.inp", cube("*NSET, NSET=n, ELSET=F\n"), {"c.inp:12", "'F'", "no *ELSET"});
  expect_refused(read, "d.inp", cube("*SURFACE, NAME=s\nF, S1\n"),
                 {"d.inp:13", "'F'", "no *ELSET"});
  expect_refused(read, "e.inp", cube("*SURFACE, NAME=s, TYPE=NODE\nF\n"), {"e.inp:13", "no *NSET"});
}

// A set of nodes takes nodes of elements by a parameter, not among its members.
TEST(Abaqus, SaysHowASetOfNodesTakesElements) {
  expect_refused(&read_abaqus, "g.inp", cube("*NSET, NSET=G\nE\n"),
                 {"g.inp:13: 'G' takes 'E'", "no *NSET", "*NSET, NSET=G, ELSET=E"});
}

TEST(Abaqus, ReadsSidesOfSurfacesOrRefusesThem) {
  const auto read = &read_abaqus;
  const std::string wedge = "*ELEMENT, TYPE=C3D6, ELSET=W\n2, 1, 2, 3, 5, 6, 7\n";
  const MeshFile mesh =
      cube_mesh(wedge + "*SURFACE, NAME=s\nW, S4\n*SURFACE, NAME=n, TYPE=NODE\n2\n" +
                "*ELEMENT, TYPE=S4, ELSET=shell\n3, 1, 2, 3, 4\n" +
                "*SURFACE, NAME=shells\nshell, SPOS\n*NSET, NSET=two\n1, 2\n" +
                "*SURFACE, TYPE=NODE, NAME=of_set\ntwo\n");
  EXPECT_EQ(mesh.find("s")->nodes, (std::vector<int>{1, 2, 5, 6}));
  EXPECT_EQ(mesh.find("n")->nodes, (std::vector<int>{1}));
  EXPECT_EQ(mesh.find("of_set")->nodes, (std::vector<int>{0, 1}));
  EXPECT_EQ(mesh.find("shells")->nodes.size(), 4u);
  // All free faces of E, of which not all nodes are on the outside.
  expect_refused(read, "a.inp", cube("*SURFACE, NAME=s\nE\n"), {"a.inp:13", "side ''", "S1 to S6"});
  expect_refused(read, "b.inp", cube("*SURFACE, NAME=s\n1, EDGE1\n"), {"b.inp:13", "'EDGE1'"});
  expect_refused(read, "c.inp", cube("*SURFACE, NAME=s\n, S1\n"), {"c.inp:13", "no elements"});
  expect_refused(read, "d.inp", cube(wedge + "*SURFACE, NAME=s\nW, S6\n"),
                 {"d.inp:15: 's' has face S6 of element 2 (", "wedges do not have"});
  const MeshFile others = cube_mesh(
      "*SURFACE, NAME=u, COMBINE=UNION\na, b\n*SURFACE, NAME=r, TYPE=REVOLUTION\nSTART, 1., 0.\n");
  EXPECT_EQ(others.unread_sets,
            (std::vector<std::string>{"*SURFACE of others (" + others.place(12) + ")",
                                      "*SURFACE, TYPE=REVOLUTION (" + others.place(14) + ")"}));
}

// r, theta in degrees, z.
TEST(Abaqus, ReadsCylindricalNodes) {
  const MeshFile mesh = read_abaqus(
      write_file("c.inp",
                 "*NODE, SYSTEM=C, NSET=all\n1, 2., 30., 5.\n2, 2, 90\n*NODE\n3, 2., 30., 5.\n"
                 "*NODE, SYSTEM=r\n4, 1, 2, 3\n*ELEMENT, TYPE=T3D2\n1, 1, 2\n"));
  EXPECT_LT((mesh.nodes[0] - Vec3(std::sqrt(3), 1, 5)).norm(), 1e-15);  // of rounding
  EXPECT_LT((mesh.nodes[1] - Vec3(0, 2, 0)).norm(), 1e-15);
  EXPECT_EQ(mesh.nodes[2], Vec3(2, 30, 5));
  EXPECT_EQ(mesh.nodes[3], Vec3(1, 2, 3));
  expect_refused(&read_abaqus, "s.inp", "*NODE, SYSTEM=S\n", {"s.inp:1", "SYSTEM=S", "(R) or "});
}

TEST(Abaqus, RefusesDataOfOtherFiles) {
  for (const char* keyword :
       {"*NODE", "*ELEMENT, TYPE=C3D8R", "*NSET, NSET=a", "*ELSET, ELSET=a", "*SURFACE, NAME=s"}) {
    expect_refused(&read_abaqus, "i.inp", cube(keyword + std::string(", INPUT=more.txt\n")),
                   {"i.inp:12", "INPUT=more.txt of ", "into this one"});
  }
  EXPECT_EQ(cube_mesh("*AMPLITUDE, NAME=a, INPUT=a.txt\n").n_cells(), 1u);
}

// Keywords may be cut short, and may stand behind blanks; parameters may be cut short.
TEST(Abaqus, ReadsOrRefusesKeywordsThatAreShort) {
  const auto read = &read_abaqus;
  const std::string text = cube("*ELSET, ELSET=a, GEN\n1, 3\n");
  EXPECT_EQ(read_abaqus(write_file("g.inp", with(text, "1, 3", "0, 5"))).find("a")->cells.size(),
            1u);
  const std::string more =
      "*MATERIAL, NAME=m\n  *Element, type=C3D8, elset=F\n2, 8,7,6,5,4,3,2,1\n";
  EXPECT_EQ(cube_mesh(more).n_cells(), 2u);
  expect_refused(read, "a.inp", cube("*ELEM, TYPE=C3D8\n"),
                 {"a.inp:12", "*ELEM ", "write *ELEMENT"});
  expect_refused(read, "b.inp", cube("*SURF, NAME=s\n"), {"b.inp:12", "write *SURFACE"});
  expect_refused(read, "c.inp", cube("*INCL, INPUT=a\n"), {"*INCL is not read", "in one file"});
  expect_refused(read, "d.inp", cube("*NODE, SYS=S\n"), {"SYSTEM=S"});
  EXPECT_EQ(cube_mesh("*ELEMENT OUTPUT\nS\n*NODE PRINT\nU\n*STEP\n").n_cells(), 1u);
}

TEST(Abaqus, RefusesKeywordsOfGeometryByTheirNames) {
  for (const std::string keyword : {"*INCLUDE", "*NGEN", "*NFILL", "*NCOPY", "*NMAP", "*ELGEN",
                                    "*ELCOPY", "*IMPORT", "*IMPERFECTION", "*SYSTEM"}) {
    expect_refused(&read_abaqus, "k.inp", cube(keyword + "\n"),
                   {"k.inp:12: " + keyword + " is not read: write the nodes"});
  }
  const std::string symmetric = "*Symmetric Model Generation, REVOLVE\n";
  expect_refused(&read_abaqus, "l.inp", cube(symmetric), {"*SYMMETRICMODELGENERATION"});
  expect_refused(&read_abaqus, "m.inp", cube("*INSTANCE, NAME=a\n*INSTANCE, NAME=b\n"),
                 {"m.inp:13: a second *INSTANCE"});
  expect_refused(&read_abaqus, "n.inp", cube("*INSTANCE, LIBRARY=job\n"), {"LIBRARY="});
}

TEST(Abaqus, ReadsSetsOfAPartAndItsAssembly) {
  const std::string assembly =
      "*ELSET, ELSET=Set-1\n1\n*NSET, NSET=n\n1\n*END PART\n*ASSEMBLY, NAME=A\n"
      "*INSTANCE, NAME=Plate-1, PART=Plate\n*END INSTANCE\n"
      "*NSET, NSET=set-1, INSTANCE=Plate-1\n7, 8\n*NSET, NSET=both\nSET-1, plate-1.n, Plate-1.2\n"
      "*SURFACE, NAME=s\nPlate-1.Set-1, S1\n*NSET, NSET=part\nn\n*END ASSEMBLY\n";
  const MeshFile mesh = read_abaqus(write_file("part.inp", "*PART, NAME=Plate\n" + cube(assembly)));
  EXPECT_EQ(mesh.find("Set-1")->cells, std::vector<int>{0});
  EXPECT_TRUE(mesh.find("Set-1")->nodes.empty());
  EXPECT_EQ(mesh.find("assembly set-1")->nodes, (std::vector<int>{6, 7}));
  EXPECT_EQ(mesh.find("both")->nodes, (std::vector<int>{0, 1, 6, 7}));
  EXPECT_EQ(mesh.find("s")->nodes, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(mesh.find("part")->nodes, std::vector<int>{0});
}

// Masses and springs are told of; a type that is not known may be a solid, and is kept as such.
TEST(Abaqus, ReadsElementsWithoutSolids) {
  const MeshFile mesh = cube_mesh(
      "*ELEMENT, TYPE=MASS, ELSET=m\n2, 1\n3, 2,\n4, 3\n*MASS, ELSET=m\n0.5\n"
      "*ELEMENT, TYPE=CONN3D2\n5, , 7\n6, Plate-1.3, 4\n*ELEMENT, TYPE=MASS\n7, 5\n"
      "*ELEMENT, TYPE=COH3D8, ELSET=glue\n8, 1, 2, 3, 4, 5,\n6, 7, 8\n9, 1, 2, 3, 4, 5, 6, 7, 8\n");
  EXPECT_EQ(set_list(mesh),
            "'E' (1 hexahedra), 'glue' (2 elements of no known kind), 'm' (3 points)");
  const auto note = [&](const char* type, int line, const char* count) {
    return std::string("elements of TYPE=") + type + " (" + mesh.place(line) + "), " + count +
           " in all, are passed over: they have no solids";
  };
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{note("CONN3D2", 18, "2"), note("MASS", 12, "4")}));
  EXPECT_EQ(mesh.cell_name(8), "element 9 (" + mesh.place(26) + ") of TYPE=COH3D8");
}

TEST(Abaqus, SetsThatHoldEachOtherEnd) {
  const std::string text = test::abaqus_text(BlockMesh(1)) + "*Elset, elset=a\nb, b\n" +
                           "*Elset, elset=b\na, a, block\n";
  EXPECT_EQ(read_abaqus(write_file("s.inp", text)).find("a")->cells.size(), 1u);
}

TEST(Abaqus, ReadsOrRefusesEveryMutation) {
  const std::string more =
      "*ELEMENT, TYPE=COH3D8, ELSET=glue\n8, 1, 2, 3, 4, 5,\n6, 7, 8\n*ELEMENT, TYPE=MASS\n9, 1\n"
      "*NODE, SYSTEM=C\n10, 1, 2, 3\n*ELSET, ELSET=\"a, b\"\n1\n*END PART\n*ASSEMBLY\n"
      "*INSTANCE, NAME=P-1\n*END INSTANCE\n*NSET, NSET=e\n7, P-1.8\n*ELSET, ELSET=e\nP-1.E, \"a\n"
      "*NSET, NSET=n, ELSET=P-1.E\n*SURFACE, NAME=e\nP-1.E, S1\ne, S2\n1, S3\n";
  for (const std::string& text : {test::abaqus_text(BlockMesh(2)), "*PART\n" + cube(more)}) {
    test::mutate("m.inp", text, [](const std::string& path) {
      const MeshFile mesh = read_abaqus(path);
      for (const int node : mesh.corner) {
        ASSERT_LT(static_cast<std::size_t>(node), mesh.nodes.size());
      }
      for (std::size_t cell = 0; cell < mesh.n_cells(); ++cell) mesh.cell_name(cell);
    });
  }
}

}  // namespace
}  // namespace brunt
