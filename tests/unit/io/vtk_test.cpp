// Frames as VTK files: what is written reads back through VTK's own readers bit for bit (appended
// raw numbers, fields in single precision, so no tolerance), and frames.pvd never names a file that
// is not whole.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/errors.hpp"
#include "core/view_fields.hpp"
#include "io/file.hpp"
#include "io/vtk/frame_reader.hpp"
#include "io/vtk/frame_writer.hpp"
#include "tests/unit/io/same_view.hpp"
#include "tests/unit/io/scratch_folder.hpp"

namespace brunt {
namespace {

using test::expect_same;
using test::FileSizeLimit;
using test::message_of;
using test::ScratchFolder;

BodyView hex_body(Real time) {
  BodyView view;
  view.body = "bar";
  view.time = time;
  view.position = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1.0 / 3};
  view.connectivity = {0, 1, 2, 3, 4, 5, 6, 7};
  view.corners = 8;
  view.point_fields = {{"velocity", 3, std::vector<Real>(24, 0.125)},
                       {"id", 1, {1e15, 2, 3, 4, 5, 6, 7, 8}}};
  view.cell_fields = {{"stress", 6, {1, 2, 3, 4, 5, -6e8}}, {"eps_p", 1, {0.25}}};
  return view;
}

BodyView quad_and_triangle() {
  BodyView view;
  view.body = "anvil & co";  // needs escapes in file names and in XML
  view.position = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0};
  view.connectivity = {0, 1, 2, 3, 1, 4, 2, -1};
  view.corners = 4;
  return view;
}

BodyView two_tetrahedra() {
  BodyView view;
  view.body = "tets";
  view.position = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
  view.connectivity = {0, 1, 2, 3, 1, 4, 2, 3};
  view.corners = 4, view.cell_dimension = 3;
  return view;
}

BodyView particles() {
  BodyView view;
  view.body = "sph";
  view.position = {0, 0, 0, 0.5, 0, 0};
  view.point_fields = {{"density", 1, {1000, 1000.5}}};
  view.point_radius = {0.25, 0.25};
  return view;
}

ContactView contacts() {
  // A plane of three corners, a plane of a 2D scene, a particle contact.
  ContactView view;
  view.position = {0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 9, 9, 9};
  view.polygon_size = {3, 2, 1};
  view.normal = {0, 0, 1, 0, 1, 0, 1, 0, 0};
  view.pressure = {10, 20, 30};
  view.penetration = {0.125, 0.25, 0.375};
  view.bonded = {0, 1, 0};
  view.max_closure = {0, 0.25, 0.5};
  view.force = {0, 0, 5, 0, 6, 0, 7, 0, 0};
  view.body_a = {0, 1, 2};
  view.body_b = {3, 4, 5};
  return view;
}

class VtkTest : public ScratchFolder {};

TEST_F(VtkTest, ReadsBackTheSame) {
  const std::vector<BodyView> bodies = {hex_body(2e-6), quad_and_triangle(), particles(),
                                        two_tetrahedra()};
  FrameWriter writer(folder_);
  writer.write(0, bodies, nullptr);
  writer.write(2e-6, bodies, nullptr);
  const auto index = read_frame_index(folder_);
  ASSERT_EQ(index.size(), 2u);
  EXPECT_EQ(index[1].time, 2e-6);
  const auto read = read_frame(folder_, index[1]);
  ASSERT_EQ(read.size(), bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) expect_same(read[b], bodies[b]);
  EXPECT_EQ(read[3].cell_dimension, 3);
}

/// Fields have 24 bits, places all of theirs: far from the origin a small body keeps its shape.
TEST_F(VtkTest, FieldsAreSinglePlacesAreDouble) {
  BodyView bar = hex_body(0.1);
  for (Real& x : bar.position) x = 1000 + 1e-9 * x;
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  bar.cell_fields = {{"stress", 6, {0.1, -1e300, nan, 1e-300, 1.0 / 3, -6e8}}};
  FrameWriter(folder_).write(bar.time, {bar}, nullptr);
  const auto read = read_frame(folder_, read_frame_index(folder_)[0])[0];
  EXPECT_EQ(read.position, bar.position);
  EXPECT_EQ(read.time, 0.1);
  const auto& stress = read.cell_fields.at(0).values;
  EXPECT_EQ(stress[0], static_cast<Real>(0.1F));
  EXPECT_EQ(stress[1], -std::numeric_limits<float>::max());
  EXPECT_TRUE(std::isnan(stress[2]));
  EXPECT_EQ(stress[3], 0);
  EXPECT_NEAR(stress[4], 1.0 / 3, std::ldexp(1.0 / 3, -24));
}

/// Many packed blocks an array, one of which is not full, of numbers that hardly pack and of such
/// that do.
TEST_F(VtkTest, ReadsBackLargeBodies) {
  BodyView quads = quad_and_triangle(), grains = particles();
  std::uint64_t bits = 1;
  const auto number = [&] {
    bits = bits * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<Real>(static_cast<std::int64_t>(bits)) * 1e-9;
  };
  constexpr std::size_t kMany = 40'001;
  quads.connectivity.clear();
  for (std::size_t k = 0; k < kMany; ++k) {
    const std::array<std::int64_t, 4> cell{0, 1, 2, k % 3 == 0 ? -1 : 3};
    quads.connectivity.insert(quads.connectivity.end(), cell.begin(), cell.end());
  }
  quads.cell_fields = {{"pressure", 1, std::vector<Real>(kMany)}};
  for (Real& value : quads.cell_fields[0].values) value = static_cast<float>(number());
  grains.position.resize(3 * kMany), grains.point_radius.assign(kMany, 0.25);
  for (Real& value : grains.position) value = number();
  grains.point_fields = {{"id", 1, std::vector<Real>(kMany)}};
  for (std::size_t k = 0; k < kMany; ++k) grains.point_fields[0].values[k] = static_cast<Real>(k);
  FrameWriter(folder_).write(0, {quads, grains}, nullptr);
  const auto read = read_frame(folder_, read_frame_index(folder_)[0]);
  ASSERT_EQ(read.size(), 2u);
  expect_same(read[0], quads);
  expect_same(read[1], grains);
}

/// Corners and numbers are packed once as long as they stay: frames of a body that loses a cell,
/// and of one that gets another number, have what each had.
TEST_F(VtkTest, FramesHaveTheCornersOfTheirTime) {
  std::vector<BodyView> views(4, two_tetrahedra());
  for (BodyView& view : views) view.cell_fields = {{"id", 1, {7, 8}}};
  views[2].connectivity.resize(4), views[2].cell_fields[0].values = {7};
  views[3].cell_fields[0].values = {7, 9};
  FrameWriter writer(folder_);
  for (std::size_t k = 0; k < views.size(); ++k) {
    views[k].time = static_cast<Real>(k);
    writer.write(views[k].time, {views[k]}, nullptr);
  }
  const auto index = read_frame_index(folder_);
  for (std::size_t k = 0; k < views.size(); ++k) {
    expect_same(read_frame(folder_, index.at(k)).at(0), views[k]);
  }
}

/// Fields that wait are written as if they had their values already.
TEST_F(VtkTest, WritesFieldsThatWait) {
  constexpr std::size_t kMany = 1'300;  // more than two parts
  BodyView grains = particles(), waiting;
  grains.position.assign(3 * kMany, 0.5), grains.point_radius.assign(kMany, 0.25);
  waiting = grains;
  const WantedFields at_once, later{{}, true};
  for (auto [view, wanted] : {std::pair{&grains, &at_once}, std::pair{&waiting, &later}}) {
    view->point_fields.clear();
    FieldAdder fields(*wanted, view->point_fields);
    fields.add("velocity", kMany, [](std::size_t k) -> Vec<2> { return {1.0 * k, 0.5}; });
    fields.add("id", kMany, [](std::size_t k) -> Real { return 3e9 + 2.0 * k; });
  }
  EXPECT_TRUE(waiting.point_fields[0].values.empty());
  FrameWriter(folder_).write(0, {waiting}, nullptr);
  expect_same(read_frame(folder_, read_frame_index(folder_)[0]).at(0), grains);
}

/// A view whose corners wait, as those of one that has them.
BodyView waiting_corners(BodyView view) {
  const std::vector<std::int64_t> all = std::move(view.connectivity);
  const auto corners = static_cast<std::size_t>(view.corners);
  view.connectivity.clear();
  view.n_waiting_cells = all.size() / corners;
  view.fill_corners = [all, corners](std::size_t first, std::size_t last, std::int64_t* to) {
    std::copy(&all[first * corners], all.data() + last * corners, to);
  };
  return view;
}

// Corners that wait are made in parts: a strip of quads and triangles over several of them, hexes,
// tetrahedra. The second frame is written with what is kept of the first.
TEST_F(VtkTest, CornersMayWait) {
  constexpr int kCells = 3 * 512 + 7;
  BodyView strip = quad_and_triangle();
  strip.position.clear(), strip.connectivity.clear();
  for (int p = 0; p < 2 * kCells + 2; ++p) {
    strip.position.insert(strip.position.end(), {0.5 * (p / 2), 1.0 * (p % 2), 0});
  }
  for (std::int64_t c = 0; c < kCells; ++c) {
    const std::int64_t first = 2 * c, last = c % 3 == 1 ? -1 : first + 1;
    strip.connectivity.insert(strip.connectivity.end(), {first, first + 2, first + 3, last});
  }
  const std::vector<BodyView> bodies = {strip, hex_body(0), two_tetrahedra()};
  std::vector<BodyView> waiting;
  for (const auto& body : bodies) {
    EXPECT_EQ(waiting.emplace_back(waiting_corners(body)).n_cells(), body.n_cells());
  }
  FrameWriter writer(folder_);
  for (const Real time : {0.0, 1.0}) writer.write(time, waiting, nullptr);
  for (const auto& frame : read_frame_index(folder_)) {
    const auto read = read_frame(folder_, frame);
    ASSERT_EQ(read.size(), bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      EXPECT_EQ(read[b].connectivity, bodies[b].connectivity) << b;
      EXPECT_EQ(read[b].position, bodies[b].position) << b;
    }
  }
}

// Numbers are made single four at a time, the last one by one: fields of every length.
TEST_F(VtkTest, FieldsOfAnyLengthAreClampedToSingles) {
  constexpr Real kMost = std::numeric_limits<float>::max();
  for (const std::size_t n : {1U, 3U, 4U, 5U, 11U}) {
    BodyView grains = particles();
    grains.position.assign(3 * n, 0.5), grains.point_radius.assign(n, 0.25);
    std::vector<Real> values(n);
    for (std::size_t k = 0; k < n; ++k) values[k] = k % 3 == 0 ? -1e200 : k % 3 == 1 ? 1e39 : 0.25;
    grains.point_fields = {{"damage", 1, values}};
    FrameWriter(folder_).write(0, {grains}, nullptr);
    const auto read = read_frame(folder_, read_frame_index(folder_)[0])[0];
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_EQ(read.point_fields.at(0).values[k], std::clamp(values[k], -kMost, kMost)) << k;
    }
  }
}

TEST_F(VtkTest, LeavesNoFolderOfNoFrames) {
  { const FrameWriter writer(folder_); }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "frames"));
  FrameWriter(folder_).write(0, {particles()}, nullptr);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "frames"));
}

// Values that wait are seen but once, when they are written: nothing of that frame is left.
TEST_F(VtkTest, RefusesFieldsThatWaitAndAreNoNumbers) {
  FrameWriter writer(folder_);
  for (const Real value : {1e39, kInfinity, std::numeric_limits<Real>::quiet_NaN(), 1e30}) {
    std::vector<BodyView> views{particles(), hex_body(0)};
    WantedFields wanted;
    wanted.may_wait = true;
    FieldAdder(wanted, views[1].point_fields).add("force", 8, [value](std::size_t k) -> Vec<3> {
      return {0, k == 7 ? value : 0, 0};
    });
    std::string body, field;
    try {
      writer.write(0, views, nullptr);
    } catch (const NoNumberError& error) {
      body = error.body, field = error.field;
    }
    const bool whole = value == 1e30;
    EXPECT_EQ(body, whole ? "" : "bar") << value;
    EXPECT_EQ(field, whole ? "" : "force") << value;
    EXPECT_EQ(writer.n_frames(), whole ? 1 : 0);
    EXPECT_EQ(std::filesystem::is_empty(folder_ / "frames"), !whole) << value;
  }
}

TEST_F(VtkTest, WritesContactsWithTheirFields) {
  const ContactView view = contacts();
  FrameWriter writer(folder_);
  writer.write(0, {hex_body(0)}, &view);
  const auto index = read_frame_index(folder_);
  ASSERT_EQ(index[0].parts.size(), 2u);
  EXPECT_EQ(index[0].parts[1].name, "contact");
  const ContactView read = read_contacts(folder_, index[0]);
  // VTK keeps points before lines before polygons: the order of the contacts is turned round.
  EXPECT_EQ(read.polygon_size, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(read.pressure, (std::vector<Real>{30, 20, 10}));
  EXPECT_EQ(read.penetration, (std::vector<Real>{0.375, 0.25, 0.125}));
  EXPECT_EQ(read.bonded, (std::vector<Real>{0, 1, 0}));
  EXPECT_EQ(read.max_closure, (std::vector<Real>{0.5, 0.25, 0}));
  EXPECT_EQ(read.normal, (std::vector<Real>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(read.force, (std::vector<Real>{7, 0, 0, 0, 6, 0, 0, 0, 5}));
  EXPECT_EQ(read.body_a, (std::vector<Label>{2, 1, 0}));
  EXPECT_EQ(read.body_b, (std::vector<Label>{5, 4, 3}));
  EXPECT_EQ(read.position,
            (std::vector<Real>{9, 9, 9, 5, 0, 0, 6, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST_F(VtkTest, WritesEmptyBodiesAndContacts) {
  // All eroded, nothing in touch: the parts stay, so that ParaView finds the same blocks.
  BodyView gone;
  gone.body = "gone";
  gone.corners = 8;
  const ContactView none;
  FrameWriter writer(folder_);
  writer.write(0, {gone}, &none);
  const auto index = read_frame_index(folder_);
  EXPECT_TRUE(read_frame(folder_, index[0])[0].position.empty());
  EXPECT_TRUE(read_contacts(folder_, index[0]).polygon_size.empty());
}

TEST_F(VtkTest, NamesPartsForParaView) {
  FrameWriter writer(folder_);
  writer.write(1e-3, {quad_and_triangle()}, nullptr);
  EXPECT_EQ(read_file(folder_ / "frames.pvd"),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
            "  <Collection>\n"
            "    <DataSet timestep=\"0.001\" group=\"\" part=\"0\" name=\"anvil &amp; co\" "
            "file=\"frames/anvil%20%26%20co.00000.vtu\"/>\n"
            "  </Collection>\n"
            "</VTKFile>\n");
}

TEST_F(VtkTest, StartsAnewAndGoesOn) {
  std::string index;
  {
    FrameWriter writer(folder_);
    for (int i = 0; i < 2; ++i) writer.write(i, {hex_body(i)}, nullptr);
    index = writer.index();
    writer.write(2, {hex_body(2)}, nullptr);
  }
  FrameWriter again(folder_, index, folder_);
  EXPECT_EQ(again.n_frames(), 2u);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "frames/bar.00002.vtu"));
  again.write(1.5, {hex_body(1.5)}, nullptr);
  EXPECT_EQ(read_frame_index(folder_).back().parts[0].file, "frames/bar.00002.vtu");
  // In another folder: the frames come along; one that is gone is left out and its number not used.
  std::filesystem::remove(folder_ / "frames/bar.00000.vtu");
  FrameWriter elsewhere(folder_ / "other", index, folder_);
  elsewhere.write(1.7, {hex_body(1.7)}, nullptr);
  const auto brought = read_frame_index(folder_ / "other");
  ASSERT_EQ(brought.size(), 2u);
  EXPECT_EQ(brought[0].parts[0].file, "frames/bar.00001.vtu");
  EXPECT_EQ(brought[1].parts[0].file, "frames/bar.00002.vtu");
  EXPECT_EQ(read_file(folder_ / "other/frames/bar.00001.vtu"),
            read_file(folder_ / "frames/bar.00001.vtu"));
  FrameWriter anew(folder_);
  EXPECT_TRUE(read_frame_index(folder_).empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "frames"));
}

TEST_F(VtkTest, KeepsTheFramesBeforeOnAFullDisk) {
  // A frame of 10,000 points does not fit.
  BodyView big = particles();
  big.position.clear();
  for (int i = 0; i < 30000; ++i) big.position.push_back(1.0 / (i + 1));
  big.point_fields.clear();
  big.point_radius.clear();
  FrameWriter writer(folder_);
  writer.write(0, {particles()}, nullptr);
  std::string message;
  {
    FileSizeLimit limit(20000);
    message = message_of([&] { writer.write(1, {big}, nullptr); });
  }
  EXPECT_NE(message.find("sph.00001.vtu"), std::string::npos) << message;
  ASSERT_EQ(read_frame_index(folder_).size(), 1u);
  EXPECT_EQ(read_frame(folder_, read_frame_index(folder_)[0]).size(), 1u);
  writer.write(1, {particles()}, nullptr);
  EXPECT_EQ(read_frame_index(folder_).size(), 2u);
}

TEST_F(VtkTest, SaysWhatIsBrokenAndPrintsNothing) {
  FrameWriter writer(folder_);
  writer.write(0, {hex_body(0)}, nullptr);
  const auto index = read_frame_index(folder_);
  const auto path = folder_ / index[0].parts[0].file;
  const std::string whole = read_file(path);
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  write_file_atomically(path, whole.substr(0, whole.size() / 2));
  EXPECT_THROW(read_frame(folder_, index[0]), MachineError);
  std::filesystem::remove(path);
  EXPECT_THROW(read_frame(folder_, index[0]), MachineError);
  write_file_atomically(folder_ / "frames.pvd", "<VTKFile");
  EXPECT_THROW(read_frame_index(folder_), MachineError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(VtkTest, RefusesFieldsThatDoNotFit) {
  FrameWriter writer(folder_);
  BodyView view = hex_body(0);
  view.cell_fields[0].values.pop_back();
  EXPECT_THROW(writer.write(0, {view}, nullptr), std::invalid_argument);
  view = hex_body(0);
  view.connectivity[0] = 8;
  EXPECT_THROW(writer.write(0, {view}, nullptr), std::invalid_argument);
}

}  // namespace
}  // namespace brunt
