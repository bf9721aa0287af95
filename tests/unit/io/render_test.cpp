// Pictures. Colours are read back from the PNG at places that follow from the camera: a picture of
// 1280 x 800 leaves 1040 x 630 pixels between the margins 40 | 200 and 90 | 80, and a flat body is
// drawn without light, so its colours are those of the map. Tolerance 3 of 255: the table and the
// averaging of 2 x 2 pixels round.
#include "io/vtk/render.hpp"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cmath>

#include "core/errors.hpp"
#include "io/vtk/camera.hpp"
#include "io/vtk/colour_map.hpp"
#include "io/vtk/colouring.hpp"
#include "io/vtk/frame_writer.hpp"
#include "io/vtk/overlay.hpp"
#include "tests/unit/io/scratch_folder.hpp"

namespace brunt {
namespace {

/// Two square cells side by side on [0, 2] x [0, 1]; eps_p is 0 left and s right.
BodyView two_cells(Real s) {
  BodyView view;
  view.body = "plate";
  view.position = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
  view.connectivity = {0, 1, 4, 3, 1, 2, 5, 4};
  view.corners = 4;
  view.cell_fields = {{"eps_p", 1, {0, s}}, {"stress", 6, {0, 0, 0, 3, 0, 0, 2, 2, 2, 0, 4, 0}}};
  return view;
}

/// A ball of one particle of radius 1 about the origin, in 3D.
BodyView ball() {
  BodyView view;
  view.body = "ball";
  view.position = {0, 0, 0.25};
  view.point_fields = {{"density", 1, {1}}, {"velocity", 3, {3, 4, 0}}};
  view.point_radius = {1};
  return view;
}

FrameSource source_of(const std::vector<BodyView>& bodies) {
  return {{0.0}, [bodies](std::size_t) { return bodies; }};
}

class RenderTest : public test::ScratchFolder {
 protected:
  /// Colour of a pixel, from the lower left corner.
  static Colour pixel(const std::filesystem::path& path, int x, int y) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    Colour colour{};
    for (int c = 0; c < 3; ++c) {
      colour[static_cast<std::size_t>(c)] =
          static_cast<std::uint8_t>(reader->GetOutput()->GetScalarComponentAsDouble(x, y, 0, c));
    }
    return colour;
  }
  static void expect_near(Colour a, Colour b) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 3) << "component " << c;
  }
};

TEST_F(RenderTest, ColoursCellsWithOneRangeForAllFrames) {
  // A pixel is max(2/1040, 1/630) = 1/520 m: the cells span x = 40 .. 1080 about y = 90 + 315.
  FrameSource source{{0, 1e-6, 2e-6}, [](std::size_t f) {
                       return std::vector<BodyView>{two_cells(0.5 * static_cast<Real>(f))};
                     }};
  const auto paths = render_frames(source, folder_, {});
  ASSERT_EQ(paths.size(), 3u);
  EXPECT_EQ(paths[1], folder_ / "eps_p.00001.png");
  const auto map = colour_map(false);
  expect_near(pixel(paths[2], 300, 405), map[0]);
  expect_near(pixel(paths[2], 820, 405), map[255]);
  expect_near(pixel(paths[1], 820, 405), map[128]);
  expect_near(pixel(paths[0], 820, 405), map[0]);
  expect_near(pixel(paths[0], 20, 405), {255, 255, 255});
}

TEST_F(RenderTest, ColoursTemperaturesFromTheLowest) {
  BodyView view = two_cells(0);
  view.cell_fields.push_back({"temperature", 1, {293, 1200}});
  RenderOptions options;
  options.field = "temperature";
  const auto paths = render_frames(source_of({view}), folder_, options);
  const auto map = colour_map(false);
  expect_near(pixel(paths.at(0), 300, 405), map[0]);
  expect_near(pixel(paths.at(0), 820, 405), map[255]);
}

TEST_F(RenderTest, DrawsParticlesAsSpheres) {
  // One sphere of radius 1 fills the height: 315 pixels about (560, 405). The speed is the same all
  // over, |(3, 4, 0)| = 5, so the range is widened to 2.5 .. 7.5: the middle of the map, shaded.
  const auto paths = render_frames(source_of({ball()}), folder_, {});
  EXPECT_EQ(paths.at(0), folder_ / "velocity.magnitude.00000.png");
  const Colour middle = pixel(paths[0], 560, 405);
  EXPECT_GT(middle[0], 150);  // orange in the light
  EXPECT_GT(middle[0], middle[2] + 50);
  EXPECT_NE(pixel(paths[0], 560 + 305, 405), (Colour{255, 255, 255}));
  expect_near(pixel(paths[0], 560 + 325, 405), {255, 255, 255});
}

TEST_F(RenderTest, DrawsRigidBodiesGrey) {
  BodyView rigid = two_cells(1);
  rigid.cell_fields.clear();
  const auto paths = render_frames(source_of({rigid}), folder_, {});
  EXPECT_EQ(paths.at(0), folder_ / "frame.00000.png");
  const Colour colour = pixel(paths[0], 300, 405);
  EXPECT_LT(colour[2] - colour[0], 20);
  EXPECT_LT(colour[0], 240);
}

TEST_F(RenderTest, DrawsADotWhereAContactIs) {
  auto source = source_of({two_cells(1)});
  ContactView contacts;  // an edge about the middle of the plate, that of the margins
  contacts.polygon_size = {2};
  contacts.position = {0.5, 0.25, 0, 1.5, 0.75, 0};
  source.contacts = [&](std::size_t) { return contacts; };
  RenderOptions options;
  const auto without = render_frames(source, folder_ / "without", options);
  EXPECT_GT(pixel(without.front(), 570, 405)[0], 50);
  options.contacts = true;
  const auto with = render_frames(source, folder_ / "with", options);
  expect_near(pixel(with.front(), 559, 404), {0, 0, 0});
  expect_near(pixel(with.front(), 560, 405), {0, 0, 0});
  expect_near(pixel(with.front(), 570, 405), pixel(without.front(), 570, 405));
}

TEST_F(RenderTest, ReadsAFolderAndDrawsTheFramesAskedFor) {
  FrameWriter writer(folder_);
  for (int f = 0; f < 3; ++f) writer.write(1e-6 * f, {two_cells(f)}, nullptr);
  RenderOptions options;
  options.frames = "last";
  options.field = "stress.xy";
  EXPECT_EQ(render_folder(folder_, folder_, options).at(0), folder_ / "stress.xy.00002.png");
  options.frames = "0,2";
  EXPECT_EQ(render_folder(folder_, folder_, options).size(), 2u);
}

TEST_F(RenderTest, DrawsWhatIsLeftOfABrokenRun) {
  // A NaN in a field must spoil neither the colours of the rest nor the camera.
  BodyView broken = two_cells(1);
  broken.body = "broken";
  broken.cell_fields[0].values = {std::nan(""), kInfinity};
  const auto paths = render_frames(source_of({broken, two_cells(1)}), folder_, {});
  expect_near(pixel(paths.at(0), 820, 405), colour_map(false)[255]);
}

TEST_F(RenderTest, RefusesWrongOptions) {
  const auto source = source_of({two_cells(1)});
  const auto refused = [&](RenderOptions options, const std::string& text) {
    try {
      render_frames(source, folder_, options);
    } catch (const DeckError& error) {
      return std::string(error.what()).find(text) != std::string::npos;
    }
    return false;
  };
  RenderOptions options;
  options.field = "eps";
  EXPECT_TRUE(refused(options, "there are: eps_p stress"));
  options.field = "stress.x";
  EXPECT_TRUE(refused(options, "no component 'x'"));
  options = {};
  options.frames = "1";
  EXPECT_TRUE(refused(options, "numbers from 0 to 0, got '1'"));
  options = {};
  options.view = "left";
  EXPECT_TRUE(refused(options, "no view 'left'"));
  options = {};
  options.range = {1.0, 1.0};
  EXPECT_TRUE(refused(options, "range"));
  EXPECT_THROW(render_folder(folder_ / "none", folder_, {}), MachineError);
}

// Frames of `fields: [temperature]` have nothing that tells rigid bodies from those that deform:
// all are coloured, where with a stress beside it only the body that has one is.
TEST_F(RenderTest, ColoursAllBodiesWhereNoFieldTellsWhichDeform) {
  const auto frame_of = [](bool with_stress) {
    BodyView plate = two_cells(0), above = two_cells(0);
    for (auto* view : {&plate, &above}) view->cell_fields = {{"temperature", 1, {300, 400}}};
    above.body = "above";
    for (std::size_t i = 1; i < above.position.size(); i += 3) above.position[i] += 1;
    if (with_stress) plate.cell_fields.push_back({"stress", 6, std::vector<Real>(12, 0)});
    return std::vector<BodyView>{plate, above};
  };
  RenderOptions options;
  options.field = "temperature";
  const auto bare = render_frames(source_of(frame_of(false)), folder_ / "bare", options);
  const auto told = render_frames(source_of(frame_of(true)), folder_ / "told", options);
  ASSERT_EQ(bare.size(), 1u);
  // A pixel is 2/630 m: both span x = 245 .. 875 about y = 90 + 315.
  const auto map = colour_map(false);
  for (const int y : {250, 560}) {
    expect_near(pixel(bare[0], 400, y), map[0]);
    expect_near(pixel(bare[0], 720, y), map[255]);
  }
  expect_near(pixel(told[0], 720, 250), map[255]);
  const Colour above = pixel(told[0], 720, 560);
  EXPECT_EQ(above, pixel(told[0], 400, 560));
}

TEST(Colouring, TakesComponentsMagnitudesAndVonMises) {
  const BodyView view = two_cells(1);
  EXPECT_EQ(scalars_of(view, parse_colouring("stress.xy")).values, (std::vector<Real>{3, 0}));
  // von Mises of pure shear tau is sqrt(3) tau; a pressure adds nothing.
  const auto mises = scalars_of(view, parse_colouring("von_mises"));
  EXPECT_TRUE(mises.on_cells);
  EXPECT_DOUBLE_EQ(mises.values[0], std::sqrt(3.0) * 3);
  EXPECT_DOUBLE_EQ(mises.values[1], std::sqrt(3.0) * 4);
  EXPECT_EQ(scalars_of(ball(), parse_colouring("velocity")).values, (std::vector<Real>{5}));
  EXPECT_TRUE(scalars_of(ball(), parse_colouring("stress")).values.empty());
}

TEST(Colouring, ChoosesUnitsAndTicks) {
  EXPECT_EQ(display_unit(3.5e8, "Pa").unit, "MPa");
  EXPECT_DOUBLE_EQ(3.5e8 * display_unit(3.5e8, "Pa").factor, 350);
  EXPECT_EQ(display_unit(2e-3, "m").unit, "mm");
  EXPECT_EQ(display_unit(5e4, "m").unit, "m");
  EXPECT_EQ(display_unit(190, "m/s").unit, "m/s");
  EXPECT_EQ(ticks({0, 1}, 5), (std::vector<Real>{0, 0.2, 0.4, 3 * 0.2, 0.8, 1}));
  EXPECT_EQ(ticks({-3, 3}, 6), (std::vector<Real>{-3, -2, -1, 0, 1, 2, 3}));
  EXPECT_EQ(ticks({2, 2}, 6), (std::vector<Real>{2}));
}

TEST(ColourMap, SpansZeroWhereItShould) {
  EXPECT_TRUE(is_diverging({-1, 2}));
  EXPECT_FALSE(is_diverging({-0.01, 2}));
  EXPECT_EQ(colour_range({-1, 2}, true).low, -2);
  EXPECT_EQ(colour_range({0.1, 2}, true).low, 0);
  EXPECT_EQ(colour_range({0.1, 2}, false).low, 0.1);
  EXPECT_EQ(colour_range({1.9, 2}, true).low, 1.9);
  for (const Real value : {5.0, 0.0}) {
    const Interval wide = colour_range({value, value}, true);
    EXPECT_LT(wide.low, wide.high);
  }
}

TEST(Camera, LooksFromWhereTheViewSays) {
  for (const char* name : {"oblique", "front", "side", "top"}) {
    const ViewAxes axes = view_axes(name, false);
    // Right-handed and orthonormal up to a few roundings.
    EXPECT_NEAR((axes.right.cross(axes.up) - axes.toward).norm(), 0, 1e-15) << name;
    EXPECT_NEAR(axes.right.dot(axes.up), 0, 1e-15) << name;
  }
  EXPECT_EQ(view_axes("front", false).up, Vec3::UnitZ());
  EXPECT_EQ(view_axes("auto", true).up, Vec3::UnitY());
}

TEST(Camera, KeepsHugeRigidBodiesFromHidingTheRest) {
  BodyView rigid = two_cells(1);
  rigid.cell_fields.clear();
  for (Real& x : rigid.position) x *= 1000;
  Coverage coverage(view_axes("auto", true));
  coverage.take(two_cells(1));
  coverage.take(rigid);
  EXPECT_LT(coverage.frame().width(), 5);  // the cells are 2 wide
  EXPECT_GT(coverage.frame().width(), 2);
}

}  // namespace
}  // namespace brunt
