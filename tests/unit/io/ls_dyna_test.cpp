// Keyword files of LS-DYNA: the block that all readers read, sets, solids with repeated corners,
// and what is refused.
#include "io/mesh/ls_dyna.hpp"

#include "io/mesh/catalog.hpp"
#include "tests/support/mesh_files.hpp"

namespace brunt {
namespace {
using test::BlockMesh;
using test::expect_refused;
using test::with;
using test::write_file;

TEST(LsDyna, ReadsABlockAndItsSets) {
  const BlockMesh block(3);
  const MeshFile mesh = read_ls_dyna(write_file("a.k", test::dyna_text(block)));
  test::expect_block(mesh, block);
  EXPECT_EQ(mesh.find("foot")->nodes.size(), 36u);  // of each segment its corners
  EXPECT_NE(mesh_reader("part.k"), nullptr);
  EXPECT_NE(mesh_reader("part.key"), nullptr);
}

const std::string kNodes =
    "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";

TEST(LsDyna, KnowsSolidsByTheCornersTheyRepeat) {
  const MeshFile mesh = read_ls_dyna(write_file("s.k", kNodes + "*ELEMENT_SOLID\n"
                                                                "1,1,1,2,3,4,5,6,7,8\n"
                                                                "2,1,1,2,3,5,5,5,5,5\n"
                                                                "3,1,1,2,3,4,5,5,5,5\n"
                                                                "4,1,1,2,3,4,5,5,8,8\n"
                                                                "5,1,1,2,3,5\n"
                                                                "*ELEMENT_SHELL\n"
                                                                "6,2,1,2,3,4\n7,2,1,2,3,3\n"
                                                                "*ELEMENT_BEAM\n8,3,1,2,3\n"));
  using enum CellKind;
  EXPECT_EQ(mesh.kind,
            (std::vector<CellKind>{hex8, tet4, pyramid5, wedge6, tet4, quad4, tri3, line2}));
  const auto tet = mesh.corners(1);
  EXPECT_EQ(std::vector<int>(tet.begin(), tet.end()), (std::vector<int>{0, 1, 2, 4}));
  EXPECT_EQ(set_list(mesh),
            "'part 1' (2 tetrahedra, 1 pyramids, 1 wedges, 1 hexahedra), 'part 2' (1 triangles, 1 "
            "quadrilaterals), 'part 3' (1 lines (beams))");
}

std::vector<int> corners_of(const MeshFile& mesh, std::size_t cell) {
  const auto corners = mesh.corners(cell);
  return {corners.begin(), corners.end()};
}

// What LS-PrePost writes: a hint behind the keyword, an element's number and part in one line, its
// nodes, 0 where there are none, in the next. The hint changes nothing: one line is read too.
TEST(LsDyna, ReadsSolidsOfTheTenNodesFormat) {
  const std::string solids =
      "       1       1       1       2       3       4       5       6       7       8\n"
      "       2       1\n"
      "       1       2       3       4       5       6       7       8       0       0\n"
      "       3       2\n"
      "       1       2       3       5       5       5       5       5       0       0\n"
      "       4       3\n"
      "       1       2       3       4       5       5       5       5       0       0\n"
      "       5       4\n"
      "       1       2       3       4       5       5       8       8       0       0\n"
      "       6       5\n"
      "       1       2       3       5       6       7       8       4       9      10\n";
  const std::string nodes = kNodes + "9,0,0,2\n10,0,0,3\n";
  for (const char* keyword : {"*ELEMENT_SOLID (ten nodes format)\n", "*ELEMENT_SOLID\n",
                              "*element_solid(ten nodes format)\n", "*ELEMENT_SOLID -\n"}) {
    const MeshFile mesh = read_ls_dyna(write_file("ten.k", nodes + keyword + solids));
    using enum CellKind;
    ASSERT_EQ(mesh.kind, (std::vector<CellKind>{hex8, hex8, tet4, pyramid5, wedge6, higher3}))
        << keyword;
    EXPECT_EQ(corners_of(mesh, 1), corners_of(mesh, 0));
    EXPECT_EQ(corners_of(mesh, 2), (std::vector<int>{0, 1, 2, 4}));
    EXPECT_EQ(corners_of(mesh, 3), (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_EQ(corners_of(mesh, 4), (std::vector<int>{0, 1, 4, 3, 2, 7}));
    EXPECT_EQ(mesh.find("part 5")->cells, std::vector<int>{5});
  }
}

TEST(LsDyna, ReadsShellsWithLinesOfTheirThickness) {
  const std::string after = "3,1,1,2,3,4\n0.1,0.1,0.1,0.1\n";
  const MeshFile mesh = read_ls_dyna(write_file(
      "thick.k", kNodes + "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3,4\n\n2,1,1,2,3,4,5,6,7,8\n1\n1\n" +
                     after + "*ELEMENT_SHELL_BETA_OFFSET\n4,1,5,6,7\n0\n1\n5,1,5,6,7,8\n\n\n"));
  using enum CellKind;
  EXPECT_EQ(mesh.kind, (std::vector<CellKind>{quad4, higher2, quad4, tri3, quad4}));
}

// Elements without solids are told of, and so are sets that would be looked for.
TEST(LsDyna, SaysWhatItPassesOver) {
  const MeshFile mesh = read_ls_dyna(
      write_file("over.k", kNodes + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n"
                                    "*ELEMENT_MASS\n1,2,0.5\n*ELEMENT_MASS\n2,3,0.5\n"
                                    "*ELEMENT_BEAM_PID\n1,1,1,2\n1,1\n"
                                    "*SET_NODE_ADD_TITLE\nboth\n3\n1,2\n*SET_BOX\n1\n"));
  ASSERT_EQ(mesh.notes.size(), 2u);
  EXPECT_NE(mesh.notes[0].find("over.k:12) is passed over: it has no solids"), std::string::npos);
  EXPECT_EQ(mesh.notes[1].find("*ELEMENT_BEAM_PID ("), 0u);
  EXPECT_NE(set_list(mesh).find("; not read: *SET_NODE_ADD_TITLE ("), std::string::npos);
  EXPECT_EQ(mesh.unread_sets.size(), 1u);
}

TEST(LsDyna, ReadsSetsOfAllKinds) {
  const MeshFile mesh = read_ls_dyna(write_file(
      "t.k", kNodes + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*ELEMENT_SHELL\n1,2,1,2,3,4\n"
                      "*PART\nsteel\n         1\nskin\n         2\n"
                      "*SET_NODE_LIST\n7,0.,0.\n1,2\n3\n"
                      "*SET_NODE_LIST_GENERATE_TITLE\ntop\n8\n5,8\n"
                      "*SET_SHELL_LIST\n9\n1\n*SET_SOLID\n10\n1\n*SET_PART_LIST\n11\n1,2\n"
                      "*SET_BEAM\n12\n1\n"));
  EXPECT_EQ(mesh.find("set_node 7")->nodes, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(mesh.find("top")->nodes, (std::vector<int>{4, 5, 6, 7}));
  EXPECT_EQ(mesh.find("set_shell 9")->cells, std::vector<int>{1});  // both have the number 1
  EXPECT_EQ(mesh.find("set_solid 10")->cells, std::vector<int>{0});
  EXPECT_EQ(mesh.find("set_part 11")->cells, (std::vector<int>{0, 1}));
  EXPECT_EQ(mesh.find("steel")->cells, std::vector<int>{0});
  EXPECT_EQ(mesh.find("skin")->cells, std::vector<int>{1});
  EXPECT_EQ(mesh.find("set_beam 12"), nullptr);
}

TEST(LsDyna, CallsPartsOfOneTitleByTheirNumbersToo) {
  const MeshFile mesh =
      read_ls_dyna(write_file("u.k", kNodes + "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n" +
                                         "*PART\nskin\n         1\n*PART\nskin\n         2\n"));
  EXPECT_NE(mesh.find("skin 1"), nullptr);
  EXPECT_NE(mesh.find("skin 2"), nullptr);
}

TEST(LsDyna, ReadsTheWideFormat) {
  const std::string node = "1234567890             1.5          -2.5e2            1d-1\n";
  const std::string beam = "         1         112345678901234567890         0\n";
  for (const std::string& text : {"*NODE %\n" + node + "*ELEMENT_BEAM %\n" + beam,
                                  "*NODE%\n" + node + "*ELEMENT_BEAM%\n" + beam,
                                  "*KEYWORD I10=Y\n*NODE\n" + node + "*ELEMENT_BEAM\n" + beam,
                                  "*keyword  i10 = y\n*NODE\n" + node + "*ELEMENT_BEAM\n" + beam}) {
    const MeshFile mesh = read_ls_dyna(write_file("w.k", text));
    EXPECT_EQ(mesh.node_id[0], 1234567890);
    EXPECT_EQ(mesh.nodes[0], Vec3(1.5, -250, 0.1));
  }
}

std::string columns(int width, const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) {
    line += std::string(static_cast<std::size_t>(width) - field.size(), ' ') + field;
  }
  return line + "\n";
}

// All fields have 20 columns; - behind a keyword goes back to the standard ones.
TEST(LsDyna, ReadsTheLongFormat) {
  std::string nodes;
  const char* corners[8][3] = {{"0", "0", "0"}, {"1", "0", "0"}, {"1", "1", "0"}, {"0", "1", "0"},
                               {"0", "0", "1"}, {"1", "0", "1"}, {"1", "1", "1"}, {"0", "1", "1"}};
  for (int i = 0; i < 8; ++i) {
    nodes += columns(20, {std::to_string(i + 1), corners[i][0], corners[i][1], corners[i][2]});
  }
  const std::string solid = columns(20, {"1", "7", "1", "2", "3", "4", "5", "6", "7", "8"});
  const std::string part = "*PART\nblock\n" + columns(20, {"7", "1"});
  const std::string set = "*SET_NODE_LIST\n" + columns(20, {"3"}) + columns(20, {"1", "8"});
  const std::string shell = "*ELEMENT_SHELL -\n" + columns(8, {"2", "8", "1", "2", "3", "4"});
  for (const char* head : {"*KEYWORD LONG=Y\n", "*KEYWORD long = k\n"}) {
    const MeshFile mesh = read_ls_dyna(write_file(
        "long.k", head + part + "*NODE\n" + nodes + "*ELEMENT_SOLID\n" + solid + set + shell));
    EXPECT_EQ(set_list(mesh),
              "'block' (1 hexahedra), 'part 8' (1 quadrilaterals), 'set_node 3' (2 nodes)");
    EXPECT_EQ(mesh.nodes[6], Vec3(1, 1, 1));
  }
  const MeshFile mesh = read_ls_dyna(
      write_file("plus.k", "*KEYWORD\n*NODE +\n" + nodes + "*ELEMENT_SOLID+\n" + solid + shell));
  EXPECT_EQ(mesh.n_cells(), 2u);
}

TEST(LsDyna, NamesWhatIsWrongWithFileAndLine) {
  const std::string text = test::dyna_text(BlockMesh(1));
  const auto read = &read_ls_dyna;
  expect_refused(read, "b.k", with(text, "*TITLE", "*INCLUDE"), {"*INCLUDE", ":2:"});
  expect_refused(read, "c.k", with(text, "      77  ", "      78  "), {"element 1 (", "node 77"});
  expect_refused(read, "d.k", with(text, "      77  ", "      67  "), {"node 67", "another node"});
  expect_refused(read, "e.k", with(text, "      77  ", "      x7  "), {"e.k:16", "x7"});
  expect_refused(read, "f.k", with(text, "*ELEMENT_SOLID", "*ELEMENT_SOLID_ORTHO"),
                 {"*ELEMENT_SOLID_ORTHO is not read", "f.k:17", "write *ELEMENT_SOLID"});
  expect_refused(read, "g.k", kNodes, {"no *ELEMENT_SOLID"});
  const std::string cut = kNodes + "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_SOLID\n2,1\n";
  expect_refused(read, "h.k", cut, {"element 2 has no line of nodes"});  // where the file ends
  expect_refused(read, "i.k", cut + "*PART\nsteel\n1\n", {"element 2 has no line of nodes"});
}

TEST(LsDyna, SaysWhichColumnsItReads) {
  const std::string text = test::dyna_text(BlockMesh(1));
  expect_refused(&read_ls_dyna, "long.k", with(text, "*KEYWORD", "*KEYWORD LONG=Y"),
                 {"long.k:6: expects the number of a part", "the long format (LONG=Y or +) has"});
  expect_refused(&read_ls_dyna, "i10.k", with(text, "*KEYWORD", "*KEYWORD I10=Y"),
                 {"the format I10 (I10=Y or %) has numbers of 10 columns"});
}

// Each makes, moves or changes nodes or elements.
TEST(LsDyna, RefusesKeywordsOfGeometryByTheirNames) {
  const std::string text = test::dyna_text(BlockMesh(1));
  for (const std::string keyword :
       {"*NODE_TRANSFORM", "*NODE_MERGE_SET", "*NODE_RIGID_SURFACE", "*NODE_UNHEARD_OF",
        "*INCLUDE_TRANSFORM", "*DEFINE_TRANSFORMATION", "*PART_DUPLICATE", "*PART_MOVE",
        "*ELEMENT_SOLID_ORTHO (ten nodes format)", "*ELEMENT_SOLID_H20", "*ELEMENT_TSHELL",
        "*ELEMENT_SHELL_COMPOSITE", "*ELEMENT_SHELL_NURBS_PATCH", "*ELEMENT_GENERALIZED_SOLID",
        "*ALE_STRUCTURED_MESH", "*MESH_VOLUME", "*IGA_SOLID", "*COMPONENT_HYBRIDIII"}) {
    const std::string name = keyword.substr(0, keyword.find(' '));
    expect_refused(&read_ls_dyna, "geometry.k", with(text, "*TITLE", keyword),
                   {name + " is not read: ", "geometry.k:2:"});
  }
  EXPECT_EQ(read_ls_dyna(write_file("s.k", with(text, "*TITLE", "*NODE_SCALAR"))).n_cells(), 1u);
  const std::string indented = with(text, "*ELEMENT_SOLID", "*MAT_NULL\n  *ELEMENT_SOLID");
  expect_refused(&read_ls_dyna, "blank.k", indented, {"first column", "blank.k:18"});
  EXPECT_EQ(read_ls_dyna(write_file("c.k", with(text, "*TITLE", "*COMMENT\n *NODE"))).n_cells(),
            1u);
}

TEST(LsDyna, ReadsOrRefusesEveryMutation) {
  const std::string more = kNodes +
                           "*ELEMENT_SOLID (ten nodes format)\n1,1\n1,2,3,4,5,6,7,8,0,0\n"
                           "*ELEMENT_SHELL_THICKNESS_OFFSET\n2,1,1,2,3,4,5,6,7,8\n\n\n\n"
                           "*ELEMENT_MASS\n1,2,0.5\n*SET_NODE_ADD\n3\n1\n*ELEMENT_BEAM +\n" +
                           columns(20, {"5", "3", "1", "2"});
  for (const std::string& text : {test::dyna_text(BlockMesh(2)), more}) {
    test::mutate("m.k", text, [](const std::string& path) {
      const MeshFile mesh = read_ls_dyna(path);
      for (const int node : mesh.corner) {
        ASSERT_LT(static_cast<std::size_t>(node), mesh.nodes.size());
      }
    });
  }
}

}  // namespace
}  // namespace brunt
