// A drawing as SVG text and as the pixels of a PNG.
#include "io/drawing.hpp"

#include <gtest/gtest.h>
#ifdef BRUNT_VTK
#include "io/vtk/drawing_png.hpp"
#endif

namespace brunt {
namespace {

Drawing small_drawing() {
  Drawing drawing;
  drawing.width = 60, drawing.height = 40;
  drawing.lines.push_back({0, 10, 60, 10, 2, {255, 0, 0}});
  drawing.marks.push_back({30, 25, 5, {0, 0, 255}, false});
  drawing.texts.push_back({5, 30, "a < b & \"c\"", 10, 0.5, true, false, {0, 0, 0}});
  return drawing;
}

TEST(Drawing, SvgHoldsShapesAndEscapedTexts) {
  const std::string svg = to_svg(small_drawing());
  EXPECT_NE(svg.find("width=\"60\" height=\"40\""), std::string::npos);
  EXPECT_NE(svg.find("<line x1=\"0\" y1=\"10\" x2=\"60\" y2=\"10\""), std::string::npos);
  EXPECT_NE(svg.find("stroke=\"#ff0000\""), std::string::npos);
  EXPECT_NE(svg.find("<circle cx=\"30\" cy=\"25\" r=\"5\" fill=\"#ffffff\" stroke=\"#0000ff\""),
            std::string::npos);
  EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_NE(svg.find("text-anchor=\"middle\""), std::string::npos);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(Drawing, WidthsOfTextsGrowWithTheirLetters) {
  EXPECT_GT(text_width("wide words", 10), text_width("words", 10));
  EXPECT_DOUBLE_EQ(text_width("ab", 20), 2 * text_width("ab", 10));
  EXPECT_DOUBLE_EQ(text_width("µ", 10), text_width("u", 10));  // one letter of two bytes
}

#ifdef BRUNT_VTK
TEST(Drawing, PngIsTwiceAsLarge) {
  const std::string png = to_png(small_drawing());
  ASSERT_GT(png.size(), 33u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value = 256 * value + static_cast<unsigned char>(png[at + k]);
    return value;
  };
  EXPECT_EQ(number(16), 120);  // width and height stand at bytes 16 and 20 of a PNG file
  EXPECT_EQ(number(20), 80);
}
#endif

}  // namespace
}  // namespace brunt
