// Frames in pieces of several ranks: merged, they are what a lone rank writes, bit for bit
// (appended raw doubles, so no tolerance); and no frame is named whose pieces are not all there.
#include "io/vtk/pieces.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/errors.hpp"
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

/// Three quads in a row, 0 to 2, of points 10 to 13 below and 14 to 17 above.
BodyView whole_bar() {
  BodyView view;
  view.body = "bar";
  view.corners = 4;
  Field speed{"velocity", 3, {}}, id{"id", 1, {}};
  for (int i = 0; i < 8; ++i) {
    view.position.insert(view.position.end(), {i % 4 + 1.0 / 3, i / 4 + 0.1, 0});
    speed.values.insert(speed.values.end(), {0.125 * i, 0.25 * i, 0});
    id.values.push_back(10 + i);
  }
  view.connectivity = {0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6};
  view.point_fields = {speed, id};
  view.cell_fields = {{"eps_p", 1, {0.125, 0.25, 0.375}}, {"id", 1, {0, 1, 2}}};
  return view;
}

/// The part of it with some points, and some cells by their corners among them.
BodyView part_of_bar(const std::vector<std::size_t>& points, const std::vector<char>& owned,
                     const std::vector<std::size_t>& cells,
                     const std::vector<std::int64_t>& connectivity) {
  const BodyView whole = whole_bar();
  BodyView view;
  view.body = whole.body;
  view.corners = whole.corners;
  view.point_owned = owned;
  view.connectivity = connectivity;
  const auto take = [](const std::vector<Real>& from, const std::vector<std::size_t>& rows,
                       std::size_t width) {
    std::vector<Real> values;
    for (const std::size_t row : rows) {
      for (std::size_t c = 0; c < width; ++c) values.push_back(from[row * width + c]);
    }
    return values;
  };
  view.position = take(whole.position, points, 3);
  for (const auto& field : whole.point_fields) {
    const auto width = static_cast<std::size_t>(field.components);
    view.point_fields.push_back({field.name, field.components, take(field.values, points, width)});
  }
  for (const auto& field : whole.cell_fields) {
    view.cell_fields.push_back({field.name, 1, take(field.values, cells, 1)});
  }
  return view;
}

BodyView empty_part() {
  BodyView view;
  view.body = "bar";
  return view;
}

/// Rank 0 has nothing, rank 1 the right half, rank 2 the left one, rank 3 two points and no cell.
std::vector<BodyView> parts_of_bar() {
  return {empty_part(), part_of_bar({1, 2, 3, 5, 6}, {0, 1, 1, 0, 1}, {1}, {0, 1, 4, 3}),
          part_of_bar({0, 1, 2, 3, 4, 5, 6, 7}, {1, 1, 0, 0, 0, 1, 0, 0}, {0, 2},
                      {0, 1, 5, 4, 2, 3, 7, 6}),
          part_of_bar({4, 7}, {1, 1}, {}, {})};
}

ContactView contact(Real pressure, const std::vector<int>& sizes, GlobalId first) {
  ContactView view;
  view.polygon_size = sizes;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    for (int c = 0; c < sizes[i]; ++c) {
      view.position.insert(view.position.end(), {pressure, Real(i), Real(c)});
    }
    view.normal.insert(view.normal.end(), {0, 0, 1});
    view.force.insert(view.force.end(), {0, 0, pressure});
    view.pressure.push_back(pressure + static_cast<Real>(i));
    view.penetration.push_back(0.1);
    view.bonded.push_back(0);
    view.max_closure.push_back(0);
    view.body_a.push_back(0), view.body_b.push_back(1);
    view.key.push_back({sizes[i] == 1 ? 1u : 0u, first + i, 7, 0});
  }
  return view;
}

class PiecesTest : public ScratchFolder {
 protected:
  /// As several ranks write a frame of the bar.
  void write(FrameWriter& writer, Real time, const std::vector<BodyView>& parts,
             const std::vector<ContactView>& contacts = {}) {
    std::vector<std::vector<FramePiece>> pieces;
    for (std::size_t r = 0; r < parts.size(); ++r) {
      pieces.push_back(write_pieces(folder_, writer.next(), static_cast<int>(r), time, {parts[r]},
                                    contacts.empty() ? nullptr : &contacts[r], memory_[r]));
    }
    writer.join(time, {"bar"}, pieces);
  }

  std::map<std::size_t, VtkFileMemory> memory_;  // by rank

  bool there(const std::string& file) const {
    return std::filesystem::exists(folder_ / "frames" / file);
  }
};

void expect_whole_bar(const BodyView& view) { expect_same(view, whole_bar()); }

TEST_F(PiecesTest, MergeToTheWholeBody) {
  FrameWriter writer(folder_);
  write(writer, 2e-6, parts_of_bar());
  const auto index = read_frame_index(folder_);
  ASSERT_EQ(index.size(), 1u);
  EXPECT_EQ(index[0].parts.at(0).file, "frames/bar.00000.pvtu");
  const auto read = read_frame(folder_, index[0]);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].time, 2e-6);
  expect_whole_bar(read[0]);
}

TEST_F(PiecesTest, AreLeftOutWhereARankHasNothing) {
  FrameWriter writer(folder_);
  write(writer, 0, parts_of_bar());
  EXPECT_FALSE(there("bar.00000.0.vtu"));
  const std::string text = read_file(folder_ / "frames/bar.00000.pvtu");
  EXPECT_EQ(joined_files(text, ""),
            (std::vector<std::string>{"bar.00000.1.vtu", "bar.00000.2.vtu", "bar.00000.3.vtu"}));
  // The root has no part of it: the arrays of the others are listed.
  for (const char* name : {"velocity", "id", "vtkGhostType", "eps_p"}) {
    EXPECT_NE(text.find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
  }
}

TEST_F(PiecesTest, MayAllBeEmpty) {
  FrameWriter writer(folder_);
  write(writer, 0, {empty_part(), empty_part()}, {ContactView{}, ContactView{}});
  const auto index = read_frame_index(folder_);
  EXPECT_TRUE(read_frame(folder_, index.at(0)).at(0).position.empty());
  EXPECT_TRUE(read_contacts(folder_, index[0]).polygon_size.empty());
  EXPECT_NE(read_file(folder_ / "frames/contact.00000.pvtp").find("pressure"), std::string::npos);
}

TEST_F(PiecesTest, OfContactsMergeInTheOrderOfALoneRank) {
  const auto first = contact(10, {3, 1}, 5), second = contact(20, {4, 1}, 1);
  FrameWriter writer(folder_);
  write(writer, 0, {empty_part(), empty_part()}, {first, second});
  const ContactView read = read_contacts(folder_, read_frame_index(folder_).at(0));
  // Points before polygons, as VTK has it, then by keys.
  EXPECT_EQ(read.polygon_size, (std::vector<int>{1, 1, 4, 3}));
  EXPECT_EQ(read.pressure, (std::vector<Real>{21, 11, 20, 10}));
  EXPECT_EQ(read.position[0], 20);
  EXPECT_EQ(read.position.size(), 3u * 9);
  EXPECT_TRUE(read.key.empty());
}

TEST_F(PiecesTest, GoOnAndComeAlongAfterARestart) {
  std::string index;
  {
    FrameWriter writer(folder_);
    for (int i = 0; i < 3; ++i) write(writer, i, parts_of_bar());
    index = writer.index();
    write(writer, 3, parts_of_bar());
  }
  write_file_atomically(folder_ / "frames/bar.00003.0.vtu.tmp-Xy12Zz", "of a killed rank");
  FrameWriter again(folder_, index, folder_);
  EXPECT_EQ(again.n_frames(), 3u);
  for (const char* file :
       {"bar.00003.pvtu", "bar.00003.1.vtu", "bar.00003.2.vtu", "bar.00003.0.vtu.tmp-Xy12Zz"}) {
    EXPECT_FALSE(there(file)) << file;
  }
  again.write(3, {whole_bar()}, nullptr);  // on one rank now
  for (const auto& frame : read_frame_index(folder_)) {
    expect_whole_bar(read_frame(folder_, frame).at(0));
  }
  // In another folder: pieces come along; a frame that lacks one is left out with all of it.
  std::filesystem::remove(folder_ / "frames/bar.00001.2.vtu");
  FrameWriter elsewhere(folder_ / "other", index, folder_);
  const auto brought = read_frame_index(folder_ / "other");
  ASSERT_EQ(brought.size(), 2u);
  for (const auto& frame : brought) {
    expect_whole_bar(read_frame(folder_ / "other", frame).at(0));
  }
  EXPECT_FALSE(there("../other/frames/bar.00001.1.vtu"));
  FrameWriter anew(folder_);
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "frames"));
}

TEST_F(PiecesTest, SayWhichOfThemIsMissingOrBroken) {
  FrameWriter writer(folder_);
  write(writer, 0, parts_of_bar());
  const auto frame = read_frame_index(folder_).at(0);
  const auto message = [&] { return message_of([&] { read_frame(folder_, frame); }); };
  const auto piece = folder_ / "frames/bar.00000.2.vtu";
  const std::string bytes = read_file(piece);
  testing::internal::CaptureStderr();
  write_file_atomically(piece, bytes.substr(0, bytes.size() / 2));
  EXPECT_NE(message(), "");
  std::filesystem::remove(piece);
  EXPECT_NE(message().find("bar.00000.2.vtu': no such file"), std::string::npos) << message();
  write_file_atomically(folder_ / frame.parts[0].file, "<VTKFile");
  EXPECT_NE(message().find("bar.00000.pvtu"), std::string::npos) << message();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(PiecesTest, NameTheFileThatDoesNotFitOnTheDisk) {
  FrameWriter writer(folder_);
  std::string message;
  {
    FileSizeLimit limit(100);
    message = message_of(
        [&] { write_pieces(folder_, 0, 2, 0, {parts_of_bar()[2]}, nullptr, memory_[2]); });
  }
  EXPECT_NE(message.find("bar.00000.2.vtu"), std::string::npos) << message;
  EXPECT_TRUE(read_frame_index(folder_).empty());
}

}  // namespace
}  // namespace brunt
