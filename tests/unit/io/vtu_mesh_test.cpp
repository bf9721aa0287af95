// Grids of VTK: the block that all readers read, pixels and voxels, and what is refused.
#include "io/vtk/vtu_mesh.hpp"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkHexahedron.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "io/mesh/catalog.hpp"
#include "tests/support/mesh_files.hpp"

namespace brunt {
namespace {
using test::BlockMesh;
using test::expect_refused;
using test::with;
using test::write_file;

/// Hexahedra of part 4 and quadrilaterals of part 9.
std::string vtu_text(const BlockMesh& block) {
  std::ostringstream out;
  const std::size_t cells = block.hexes.size() + block.quads.size();
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n"
      << "<UnstructuredGrid><Piece NumberOfPoints=\"" << block.nodes.size() << "\" NumberOfCells=\""
      << cells << "\">\n<CellData>\n"
      << "<DataArray type=\"Int32\" Name=\"part\" format=\"ascii\">\n";
  for (std::size_t e = 0; e < cells; ++e) out << (e < block.hexes.size() ? 4 : 9) << "\n";
  out << "</DataArray>\n<DataArray type=\"Float64\" Name=\"stress\" format=\"ascii\">\n";
  for (std::size_t e = 0; e < cells; ++e) out << 0.5 + static_cast<Real>(e) << "\n";
  out << "</DataArray>\n</CellData>\n<Points>\n"
      << "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Vec3& x : block.nodes) out << x.transpose() << "\n";
  out << "</DataArray>\n</Points>\n<Cells>\n"
      << "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (const auto& hex : block.hexes) {
    for (const int corner : hex) out << corner << " ";
    out << "\n";
  }
  for (const auto& quad : block.quads) {
    for (const int corner : quad) out << corner << " ";
    out << "\n";
  }
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t end = 0;
  for (std::size_t e = 0; e < cells; ++e) out << (end += e < block.hexes.size() ? 8 : 4) << "\n";
  out << "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for (std::size_t e = 0; e < cells; ++e) out << (e < block.hexes.size() ? 12 : 9) << "\n";
  out << "</DataArray>\n</Cells>\n</Piece></UnstructuredGrid>\n</VTKFile>\n";
  return out.str();
}

TEST(VtuMesh, ReadsABlockAndItsParts) {
  const BlockMesh block(3);
  MeshFile mesh = read_vtu(write_file("a.vtu", vtu_text(block)));
  ASSERT_EQ(set_list(mesh), "'part 4' (27 hexahedra), 'part 9' (9 quadrilaterals)");
  for (std::size_t i = 0; i < mesh.node_id.size(); ++i) {
    EXPECT_EQ(mesh.node_id[i], static_cast<std::int64_t>(i));
    mesh.node_id[i] = BlockMesh::id(static_cast<int>(i));  // the others number as they like
  }
  mesh.sets[0].name = "block", mesh.sets[1].name = "foot";
  test::expect_block(mesh, block);
  EXPECT_NE(mesh_reader("part.vtu"), nullptr);
}

/// The hexahedra of a block as VTK itself writes them.
std::string written_by_vtk(const BlockMesh& block, const std::string& name, int mode, bool packed,
                           bool base64) {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& x : block.nodes) points->InsertNextPoint(x[0], x[1], x[2]);
  grid->SetPoints(points);
  vtkNew<vtkIntArray> part;
  part->SetName("part");
  for (const auto& hex : block.hexes) {
    vtkIdType ids[8];
    std::copy(hex.begin(), hex.end(), ids);
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
    part->InsertNextValue(4);
  }
  grid->GetCellData()->AddArray(part);
  const std::string path = test::own_file(name);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(path.c_str());
  writer->SetDataMode(mode);
  writer->SetEncodeAppendedData(base64 ? 1 : 0);
  if (packed) {
    writer->SetCompressorTypeToZLib();
  } else {
    writer->SetCompressorTypeToNone();
  }
  writer->Write();
  return path;
}

TEST(VtuMesh, ReadsAllThatVtkWrites) {
  const BlockMesh block(6);
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
    for (const bool packed : {false, true}) {
      for (const bool base64 : {false, true}) {
        const MeshFile mesh = read_vtu(written_by_vtk(block, "w.vtu", mode, packed, base64));
        ASSERT_EQ(set_list(mesh), "'part 4' (216 hexahedra)");
        ASSERT_EQ(mesh.nodes, block.nodes);
        for (std::size_t e = 0; e < block.hexes.size(); ++e) {
          const auto corners = mesh.corners(e);
          ASSERT_TRUE(std::equal(corners.begin(), corners.end(), block.hexes[e].begin()));
        }
      }
    }
  }
}

TEST(VtuMesh, TurnsVoxelsAndPixels) {
  const BlockMesh block(1);
  std::string text = with(vtu_text(block), "\n12\n9\n", "\n11\n8\n");
  const MeshFile mesh = read_vtu(write_file("v.vtu", text));
  const auto corners = mesh.corners(0);
  for (const auto& [at, from] : {std::pair{2, 3}, {3, 2}, {6, 7}, {7, 6}, {1, 1}, {5, 5}}) {
    EXPECT_EQ(corners[static_cast<std::size_t>(at)],
              block.hexes[0][static_cast<std::size_t>(from)]);
  }
  EXPECT_EQ(mesh.corners(1)[2], block.quads[0][3]);
}

TEST(VtuMesh, RefusesWhatIsWrong) {
  const std::string text = vtu_text(BlockMesh(1));
  expect_refused(&read_vtu, "a.vtu", with(text, "\n12\n9\n", "\n41\n9\n"), {"cell 0", "type 41"});
  expect_refused(&read_vtu, "b.vtu", with(text, "\n12\n9\n", "\n10\n9\n"), {"8 corners", "4"});
  expect_refused(&read_vtu, "c.vtu", with(text, "0 1 3 2", "0 1 3 9"), {"point 9", "there are 8"});
  expect_refused(&read_vtu, "d.vtu", text.substr(0, text.size() / 2), {"d.vtu: "});
  expect_refused(&read_vtu, "there_is_none/e.vtu", "", {"no such file"});
}

TEST(VtuMesh, ReadsOrRefusesEveryMutation) {
  const auto read = [](const std::string& path) {
    const MeshFile mesh = read_vtu(path);
    for (const int node : mesh.corner) ASSERT_LT(static_cast<std::size_t>(node), mesh.nodes.size());
  };
  test::mutate("m.vtu", vtu_text(BlockMesh(2)), read);
  const std::string path =
      written_by_vtk(BlockMesh(2), "p.vtu", vtkXMLWriter::Appended, true, false);
  std::ifstream file(path, std::ios::binary);
  test::mutate("p.vtu", std::string{std::istreambuf_iterator<char>(file), {}}, read);
}

}  // namespace
}  // namespace brunt
