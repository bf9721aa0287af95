// Files of Gmsh: the same block of hexahedra from formats 2.2 and 4.1, ASCII and binary; what is
// wrong is named with file and line; no mutation of a file does more than be refused.
#include "io/mesh/gmsh.hpp"

#include "io/mesh/catalog.hpp"
#include "tests/support/mesh_files.hpp"

namespace brunt {
namespace {
using test::BlockMesh;
using test::expect_refused;
using test::with;
using test::write_file;

TEST(Gmsh, ReadsTheSameBlockFromAllItsFormats) {
  const BlockMesh block(3);
  for (const bool binary : {false, true}) {
    test::expect_block(read_gmsh(write_file("2.msh", test::gmsh2_text(block, binary))), block);
    test::expect_block(read_gmsh(write_file("4.msh", test::gmsh4_text(block, binary))), block);
  }
  const MeshFile mesh = read_gmsh(write_file("4.msh", test::gmsh4_text(block, false)));
  EXPECT_EQ(mesh.find("foot")->cells.size(), 9u);
  EXPECT_EQ(mesh.kind[static_cast<std::size_t>(mesh.find("foot")->cells[0])], CellKind::quad4);
  EXPECT_EQ(set_list(mesh), "'block' (27 hexahedra), 'foot' (9 quadrilaterals)");
}

// The example of Gmsh's manual, two quadrilaterals, has no names and no groups.
TEST(Gmsh, ReadsTheExampleOfItsManual) {
  const MeshFile mesh = read_gmsh(write_file("manual.msh",
                                             "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                                             "$Nodes\n1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n"
                                             "0. 0. 0.\n1. 0. 0.\n1. 1. 0.\n0. 1. 0.\n"
                                             "2. 0. 0.\n2. 1. 0.\n$EndNodes\n"
                                             "$Elements\n1 2 1 2\n2 1 3 2\n1 1 2 3 4\n2 2 5 6 3\n"
                                             "$EndElements\n"
                                             "$NodeData\n1\n\"A scalar view\"\n$EndNodeData\n"));
  ASSERT_EQ(mesh.n_cells(), 2u);
  EXPECT_EQ(mesh.corners(1)[1], 4);
  EXPECT_EQ(mesh.cell_name(1).substr(0, 10), "element 2 ");
  EXPECT_EQ(mesh.nodes[5], Vec3(2, 1, 0));
  EXPECT_TRUE(mesh.sets.empty());
}

TEST(Gmsh, CallsGroupsWithoutNamesByTheirNumbers) {
  const std::string text = test::gmsh2_text(BlockMesh(1), false);
  const std::size_t from = text.find("$PhysicalNames"), to = text.find("$Nodes");
  const std::string nameless = text.substr(0, from) + text.substr(to);
  const MeshFile mesh = read_gmsh(write_file("nameless.msh", nameless));
  EXPECT_EQ(set_list(mesh), "'volume 4' (1 hexahedra), 'surface 9' (1 quadrilaterals)");
}

TEST(Gmsh, NamesWhatIsWrongWithFileAndLine) {
  const std::string old = test::gmsh2_text(BlockMesh(1), false);
  const std::string text = test::gmsh4_text(BlockMesh(1), false);
  expect_refused(&read_gmsh, "a.msh", with(text, "4.1 0 8", "4 0 8"), {"4.1 or 2.2", "a.msh:2"});
  expect_refused(&read_gmsh, "b.msh", with(text, "4.1 0 8", "4.1 0 4"), {"4 bytes"});
  expect_refused(&read_gmsh, "c.msh", "solid part\n", {"no file of Gmsh"});
  expect_refused(&read_gmsh, "d.msh", with(text, "$EndNodes", "$EndNode"), {"no $EndNodes"});
  expect_refused(&read_gmsh, "e.msh", with(old, " 77 67 \n", " 78 67 \n"),
                 {"element 1 (", "e.msh:22)", "node 78, which is not among the nodes"});
  expect_refused(&read_gmsh, "f.msh", with(old, "\n77 ", "\n67 "),
                 {"node 67 (", "f.msh:18)", "number of another node"});
  expect_refused(&read_gmsh, "g.msh", with(old, "\n77 1", "\n77 one"),
                 {"g.msh:18", "a coordinate", "one"});
  expect_refused(&read_gmsh, "h.msh", with(old, "1 5 2 4", "1 500 2 4"), {"type 500", "h.msh:22"});
  expect_refused(&read_gmsh, "i.msh", with(old, "\n8\n", "\n99999999999\n"), {"bytes are left"});
  expect_refused(&read_gmsh, "j.msh", with(old, "\n77 1", "\n77 1e999"), {"node 77", "no number"});
  expect_refused(&read_gmsh, "k.msh", text.substr(0, text.size() / 2), {"k.msh:"});
  expect_refused(&read_gmsh, "m.msh", with(text, "$Nodes", "$PartitionedEntities\n1\n$Nodes"),
                 {"m.msh:", "partitions", "Unpartition"});
  expect_refused(&read_gmsh, "n.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n", {"format 1", "4.1"});
  expect_refused(&read_gmsh, "there_is_none/l.msh", "", {"there is no such file"});
}

TEST(Gmsh, ReadsOrRefusesEveryMutation) {
  const BlockMesh block(2);
  const auto read = [](const std::string& path) {
    const MeshFile mesh = read_gmsh(path);
    for (const int node : mesh.corner) ASSERT_LT(static_cast<std::size_t>(node), mesh.nodes.size());
  };
  for (const bool binary : {false, true}) {
    test::mutate("2.msh", test::gmsh2_text(block, binary), read);
    test::mutate("4.msh", test::gmsh4_text(block, binary), read);
  }
}

// Editors put the mark of UTF-8 before the first letter.
TEST(MeshReaders, PassOverTheMarkOfUtf8) {
  const BlockMesh block(2);
  const auto path = [](const char* name, const std::string& text) {
    return write_file(name, "\xEF\xBB\xBF" + text);
  };
  test::expect_block(read_gmsh(path("b.msh", test::gmsh2_text(block, false))), block);
  test::expect_block(read_gmsh(path("c.msh", test::gmsh4_text(block, true))), block);
  test::expect_block(mesh_reader("a.inp")->read(path("b.inp", test::abaqus_text(block))), block);
  test::expect_block(mesh_reader("a.k")->read(path("b.k", test::dyna_text(block))), block);
  // Without a first line that could be passed over.
  const std::string inp = test::abaqus_text(block);
  const std::string from_nodes = inp.substr(inp.find("*Node"));
  test::expect_block(mesh_reader("a.inp")->read(path("d.inp", from_nodes)), block);
  expect_refused(&read_gmsh, "e.msh", "\xFF\xFE$", {"UTF-16", "save it as UTF-8"});
}

TEST(MeshReaders, AreChosenByTheEndOfTheName) {
  ASSERT_NE(mesh_reader("folder.x/PART.MSH"), nullptr);
  EXPECT_EQ(mesh_reader("folder.x/PART.MSH")->extension, ".msh");
  EXPECT_EQ(mesh_reader("part.stl"), nullptr);
  EXPECT_EQ(mesh_reader(".msh"), nullptr);
  EXPECT_NE(mesh_formats().find(".msh (Gmsh 2.2 and 4.1)"), std::string::npos);
}

TEST(IdTable, FindsIdsThatAreDenseOrFarApart) {
  for (const std::int64_t apart : {std::int64_t{1}, std::int64_t{3}, std::int64_t{1} << 40}) {
    std::vector<std::int64_t> ids;
    for (int i = 0; i < 100; ++i) ids.push_back((i * 37 % 100 - 50) * apart);
    const IdTable table(ids);
    EXPECT_EQ(table.repeated(), -1);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(table[ids[static_cast<std::size_t>(i)]], i);
    EXPECT_EQ(table[50 * apart], -1);
    EXPECT_EQ(table[-51 * apart], -1);
    EXPECT_EQ(table[INT64_MIN], -1);
    ids[99] = ids[7];
    EXPECT_EQ(IdTable(ids).repeated(), 99);
  }
}

}  // namespace
}  // namespace brunt
