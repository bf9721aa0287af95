#include "io/drawing.hpp"

#include "io/number.hpp"

namespace brunt {

namespace {
std::string hex_of(const Ink& ink) {
  static constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : ink) text += {kDigits[part >> 4], kDigits[part & 15]};
  return text;
}

/// name="value", to a hundredth of a pixel.
std::string pixel(const char* name, Real value) {
  return std::string(" ") + name + "=\"" + rounded(std::round(100 * value) / 100, 8) + "\"";
}

const char* anchor_word(Real anchor) {
  if (anchor < 0.25) return "start";
  return anchor > 0.75 ? "end" : "middle";
}

std::string svg_text(const Drawing::Text& text) {
  // Half of a capital letter lies below the middle of the line.
  constexpr Real kBaseline = 0.35;
  std::string out = "<text" + pixel("x", text.x) + pixel("y", text.y + kBaseline * text.size) +
                    pixel("font-size", text.size) + " text-anchor=\"" + anchor_word(text.anchor) +
                    "\" fill=\"" + hex_of(text.ink) + "\"";
  if (text.bold) out += " font-weight=\"bold\"";
  if (text.upright) {
    out += " transform=\"rotate(-90 " + rounded(text.x, 8) + " " + rounded(text.y, 8) + ")\"";
  }
  return out + ">" + escaped_xml(text.text) + "</text>\n";
}
}  // namespace

std::string escaped_xml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (static_cast<unsigned char>(c) >= 32 || c == '\n') {
      out += c;
    }
  }
  return out;
}

std::string to_svg(const Drawing& drawing) {
  const std::string size =
      std::to_string(drawing.width) + "\" height=\"" + std::to_string(drawing.height);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size +
                    "\" viewBox=\"0 0 " + std::to_string(drawing.width) + " " +
                    std::to_string(drawing.height) +
                    "\" font-family=\"Arial, Helvetica, sans-serif\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const auto& line : drawing.lines) {
    out += "<line" + pixel("x1", line.x0) + pixel("y1", line.y0) + pixel("x2", line.x1) +
           pixel("y2", line.y1) + pixel("stroke-width", line.width) + " stroke=\"" +
           hex_of(line.ink) + "\" stroke-linecap=\"round\"/>\n";
  }
  for (const auto& mark : drawing.marks) {
    const std::string ink = hex_of(mark.ink);
    out += "<circle" + pixel("cx", mark.x) + pixel("cy", mark.y) + pixel("r", mark.radius) +
           " fill=\"" + (mark.filled ? ink : "#ffffff") + "\" stroke=\"" + ink +
           "\" stroke-width=\"2\"/>\n";
  }
  for (const auto& text : drawing.texts) out += svg_text(text);
  return out + "</svg>\n";
}

Real text_width(const std::string& text, int size) {
  Real width = 0;  // in sizes of a letter
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    const bool narrow = std::string_view(" .,:;'|!il()[]/").find(c) != std::string_view::npos;
    if (!continues) width += narrow ? 0.3 : 0.58;
  }
  return width * size;
}

}  // namespace brunt
