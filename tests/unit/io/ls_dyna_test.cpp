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
  const MeshFile mesh = read_ls_dyna(
      write_file("w.k",
                 "*NODE %\n1234567890             1.5          -2.5e2            1d-1\n"
                 "*ELEMENT_BEAM %\n         1         112345678901234567890         0\n"));
  EXPECT_EQ(mesh.node_id[0], 1234567890);
  EXPECT_EQ(mesh.nodes[0], Vec3(1.5, -250, 0.1));
}

TEST(LsDyna, NamesWhatIsWrongWithFileAndLine) {
  const std::string text = test::dyna_text(BlockMesh(1));
  const auto read = &read_ls_dyna;
  expect_refused(read, "a.k", with(text, "*KEYWORD", "*KEYWORD LONG=Y"), {"long format", ":1:"});
  expect_refused(read, "b.k", with(text, "*TITLE", "*INCLUDE"), {"*INCLUDE", ":2:"});
  expect_refused(read, "c.k", with(text, "      77  ", "      78  "), {"element 1 (", "node 77"});
  expect_refused(read, "d.k", with(text, "      77  ", "      67  "), {"node 67", "another node"});
  expect_refused(read, "e.k", with(text, "      77  ", "      x7  "), {"e.k:16", "x7"});
  expect_refused(read, "f.k", with(text, "*ELEMENT_SOLID", "*ELEMENT_SOLID_ORTHO"),
                 {"*ELEMENT_SOLID_ORTHO is not known", "f.k:17"});
  expect_refused(read, "g.k", kNodes, {"no *ELEMENT_SOLID"});
  const std::string cut = kNodes + "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_SOLID\n2,1\n";
  expect_refused(read, "h.k", cut, {"element 2 has no line of nodes"});  // where the file ends
  expect_refused(read, "i.k", cut + "*PART\nsteel\n1\n", {"element 2 has no line of nodes"});
}

TEST(LsDyna, ReadsOrRefusesEveryMutation) {
  test::mutate("m.k", test::dyna_text(BlockMesh(2)), [](const std::string& path) {
    const MeshFile mesh = read_ls_dyna(path);
    for (const int node : mesh.corner) ASSERT_LT(static_cast<std::size_t>(node), mesh.nodes.size());
  });
}

}  // namespace
}  // namespace brunt
