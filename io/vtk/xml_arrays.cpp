#include "io/vtk/xml_arrays.hpp"

#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <charconv>
#include <cstring>
#include <map>
#include <stdexcept>

#include "io/mesh/mesh_text.hpp"
#include "io/vtk/messages.hpp"

namespace brunt {

namespace {
using Attributes = std::map<std::string, std::string>;
using Bytes = std::string;

/// A tag: "DataArray", "/Points", "?xml"; what it says; where its content begins.
struct XmlTag {
  std::string name;
  Attributes attributes;
  bool is_empty = false;  ///< <.../>
  std::size_t end = 0;
};

/// Numbers of bytes by VTK's names of types; 0: no type of numbers.
std::size_t bytes_of_type(const std::string& type) {
  static const std::map<std::string, std::size_t> kTypes = {
      {"Int8", 1},   {"UInt8", 1}, {"Int16", 2},  {"UInt16", 2},  {"Int32", 4},
      {"UInt32", 4}, {"Int64", 8}, {"UInt64", 8}, {"Float32", 4}, {"Float64", 8}};
  const auto found = kTypes.find(type);
  return found == kTypes.end() ? 0 : found->second;
}

template <class T>
void append_numbers(const Bytes& bytes, std::vector<Real>& values) {
  for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    values.push_back(static_cast<Real>(value));
  }
}

std::vector<Real> numbers_of(const std::string& type, const Bytes& bytes) {
  std::vector<Real> values;
  if (type == "Int8") append_numbers<std::int8_t>(bytes, values);
  if (type == "UInt8") append_numbers<std::uint8_t>(bytes, values);
  if (type == "Int16") append_numbers<std::int16_t>(bytes, values);
  if (type == "UInt16") append_numbers<std::uint16_t>(bytes, values);
  if (type == "Int32") append_numbers<std::int32_t>(bytes, values);
  if (type == "UInt32") append_numbers<std::uint32_t>(bytes, values);
  if (type == "Int64") append_numbers<std::int64_t>(bytes, values);
  if (type == "UInt64") append_numbers<std::uint64_t>(bytes, values);
  if (type == "Float32") append_numbers<float>(bytes, values);
  if (type == "Float64") append_numbers<double>(bytes, values);
  return values;
}

class XmlArrayReader {
 public:
  explicit XmlArrayReader(const std::string& path) : text_(path), all_(text_.all()) {}

  std::vector<XmlArray> read() {
    find_appended();
    std::string section;
    int pieces = 0;
    for (std::size_t at = 0; at < end_;) {
      const XmlTag tag = next_tag(at);
      if (tag.name.empty()) break;
      at = tag.end;
      if (tag.name == "VTKFile") take_head(tag.attributes);
      if (tag.name == "Piece" && ++pieces > 1) wrong("has more than one piece: merge them");
      for (const char* known : {"Points", "Cells", "CellData", "PointData"}) {
        if (tag.name == known && !tag.is_empty) section = known;
        if (tag.name == std::string("/") + known) section.clear();
      }
      if (tag.name == "DataArray" && !section.empty()) at = take_array(tag, section);
    }
    if (pieces == 0) wrong("has no <Piece>: no grid of VTK");
    return std::move(arrays_);
  }

 private:
  [[noreturn]] void wrong(const std::string& what) const {
    throw std::runtime_error(text_.path() + ": " + what);
  }

  /// The next tag from `at` on, comments left out; an empty name: there is none.
  XmlTag next_tag(std::size_t at) const {
    XmlTag tag;
    for (;;) {
      at = all_.find('<', at);
      if (at >= end_) return tag;
      if (all_.substr(at, 4) != "<!--") break;
      at = all_.find("-->", at);
    }
    const std::size_t close = std::min(all_.find('>', at), end_);
    if (close == end_) wrong("ends inside a tag");
    std::string_view inside = all_.substr(at + 1, close - at - 1);
    tag.end = close + 1;
    tag.is_empty = !inside.empty() && inside.back() == '/';
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t name_end = std::min(inside.find_first_of(kBlanks), inside.size());
    tag.name = inside.substr(0, name_end);
    if (tag.is_empty && tag.name.back() == '/') tag.name.pop_back();
    inside.remove_prefix(name_end);
    for (;;) {
      const std::size_t equals = inside.find('=');
      if (equals == std::string_view::npos) break;
      const std::size_t from = inside.find('"', equals);
      const std::size_t to = from == std::string_view::npos ? from : inside.find('"', from + 1);
      if (to == std::string_view::npos) break;
      std::string_view key = inside.substr(0, equals);
      while (!key.empty() && kBlanks.find(key.front()) != std::string_view::npos) {
        key.remove_prefix(1);
      }
      while (!key.empty() && kBlanks.find(key.back()) != std::string_view::npos) {
        key.remove_suffix(1);
      }
      tag.attributes[std::string(key)] = inside.substr(from + 1, to - from - 1);
      inside.remove_prefix(to + 1);
    }
    if (tag.name.empty()) wrong("has a tag without a name");
    return tag;
  }

  static std::string value_of(const Attributes& attributes, const char* name,
                              const char* otherwise) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? otherwise : found->second;
  }

  /// What stands behind "_" of <AppendedData> may be any bytes: tags end before it.
  void find_appended() {
    const std::size_t tag = all_.find("<AppendedData");
    end_ = std::min(tag, all_.size());
    if (tag == std::string_view::npos) return;
    const std::size_t close = all_.find('>', tag), start = all_.find('_', close);
    if (start == std::string_view::npos) wrong("has no data in <AppendedData>");
    appended_is_base64_ = all_.substr(tag, close - tag).find("base64") != std::string_view::npos;
    appended_ = all_.substr(start + 1);
  }

  void take_head(const Attributes& attributes) {
    if (value_of(attributes, "type", "") != "UnstructuredGrid") {
      wrong("is of type " + value_of(attributes, "type", "none") + ", not UnstructuredGrid");
    }
    if (value_of(attributes, "byte_order", "LittleEndian") != "LittleEndian") {
      wrong("has another byte order: write it as ASCII");
    }
    header_ = value_of(attributes, "header_type", "UInt32") == "UInt64" ? 8 : 4;
    const std::string packed = value_of(attributes, "compressor", "");
    if (!packed.empty() && packed != "vtkZLibDataCompressor") {
      wrong("is packed by " + packed + ": write it with zlib, or plain");
    }
    is_packed_ = !packed.empty();
  }

  /// Returns where the next tag may begin.
  std::size_t take_array(const XmlTag& tag, const std::string& section) {
    XmlArray& array = arrays_.emplace_back();
    array.section = section;
    array.name = value_of(tag.attributes, "Name", "");
    array.components = std::atoi(value_of(tag.attributes, "NumberOfComponents", "1").c_str());
    const std::string type = value_of(tag.attributes, "type", "");
    const std::string format = value_of(tag.attributes, "format", "ascii");
    const std::size_t end = tag.is_empty ? tag.end : std::min(all_.find('<', tag.end), end_);
    if (bytes_of_type(type) == 0) {
      arrays_.pop_back();  // of texts
      return end;
    }
    if (format == "appended") {
      std::size_t offset = 0;
      const std::string text = value_of(tag.attributes, "offset", "");
      const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), offset);
      if (error != std::errc{} || offset > appended_.size()) {
        wrong("the array '" + array.name + "' begins behind the end");
      }
      array.values = numbers_of(type, unpacked(appended_.substr(offset), appended_is_base64_));
    } else if (format == "binary") {
      array.values = numbers_of(type, unpacked(all_.substr(tag.end, end - tag.end), true));
    } else {
      array.values = ascii(all_.substr(tag.end, end - tag.end), array.name);
    }
    return end;
  }

  std::vector<Real> ascii(std::string_view text, const std::string& name) const {
    std::vector<Real> values;
    const char *at = text.data(), *end = at + text.size();
    for (;;) {
      while (at != end && (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r')) ++at;
      if (at == end) return values;
      Real value = 0;
      const auto [stop, error] = std::from_chars(at, end, value);
      if (error == std::errc::invalid_argument) {
        wrong("the array '" + name + "' has '" +
              std::string(at, std::min<std::size_t>(20, slot_of(end - at))) +
              "' where a number should be");
      }
      values.push_back(value);
      at = stop;
    }
  }

  /// `size` bytes of a stream, decoded; `taken` counts the characters that they took.
  Bytes decoded(std::string_view stream, std::size_t size, bool base64, std::size_t& taken) const {
    if (!base64) {
      if (size > stream.size()) wrong("is cut off");
      taken = size;
      return Bytes(stream.substr(0, size));
    }
    if (size / 3 > stream.size() / 4 + 1) wrong("is cut off");
    Bytes bytes;
    std::uint32_t group = 0;
    int count = 0;
    taken = 0;
    for (; taken < stream.size() && bytes.size() < size; ++taken) {
      const char c = stream[taken];
      std::uint32_t bits = 0;
      if (c >= 'A' && c <= 'Z')
        bits = static_cast<std::uint32_t>(c - 'A');
      else if (c >= 'a' && c <= 'z')
        bits = static_cast<std::uint32_t>(c - 'a' + 26);
      else if (c >= '0' && c <= '9')
        bits = static_cast<std::uint32_t>(c - '0' + 52);
      else if (c == '+')
        bits = 62;
      else if (c == '/')
        bits = 63;
      else if (c == '=')
        bits = 0;
      else if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
        continue;
      else
        wrong("has a character in its data that is none of base64");
      group = group << 6 | bits;
      if (++count % 4 != 0) continue;
      for (int shift = 16; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(group >> shift & 0xff);
      }
      group = 0;
    }
    if (bytes.size() < size) wrong("is cut off");
    bytes.resize(size);
    return bytes;
  }

  std::size_t head_number(const Bytes& bytes, std::size_t i) const {
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data() + i * header_, header_);
    return slot_of(value);
  }

  /// The bytes of an array that begins at the start of a stream.
  Bytes unpacked(std::string_view stream, bool base64) const {
    std::size_t taken = 0;
    if (!is_packed_) {
      const std::size_t size = head_number(decoded(stream, header_, base64, taken), 0);
      if (size > stream.size()) wrong("has an array that is longer than the file");
      return decoded(stream, header_ + size, base64, taken).substr(header_);
    }
    const std::size_t blocks = head_number(decoded(stream, header_, base64, taken), 0);
    if (blocks > stream.size()) wrong("has an array that is longer than the file");
    const Bytes head = decoded(stream, (3 + blocks) * header_, base64, taken);
    const std::size_t block = head_number(head, 1), last = head_number(head, 2);
    std::size_t packed = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::size_t one = head_number(head, 3 + b);
      if (one > stream.size() || packed > stream.size()) wrong("is cut off");
      packed += one;
    }
    const Bytes data = decoded(stream.substr(taken), packed, base64, taken);
    constexpr std::size_t kMostRatio = 1100;  // of zlib
    Bytes bytes;
    vtkNew<vtkZLibDataCompressor> zlib;
    const VtkMessages messages;
    for (std::size_t b = 0, at = 0; b < blocks; ++b) {
      const std::size_t from = head_number(head, 3 + b);
      const std::size_t to = b + 1 == blocks && last > 0 ? last : block;
      if (to > kMostRatio * (from + 64)) wrong("has a packed block of an impossible size");
      const std::size_t old = bytes.size();
      bytes.resize(old + to);
      const std::size_t made =
          zlib->Uncompress(reinterpret_cast<const unsigned char*>(data.data() + at), from,
                           reinterpret_cast<unsigned char*>(bytes.data() + old), to);
      if (messages.any() || made != to) wrong("has a packed block that does not open");
      at += from;
    }
    return bytes;
  }

  MeshText text_;
  std::string_view all_, appended_;
  std::size_t end_ = 0;  // of the tags
  bool appended_is_base64_ = false, is_packed_ = false;
  std::size_t header_ = 4;  // [byte] of a number before data
  std::vector<XmlArray> arrays_;
};
}  // namespace

std::vector<XmlArray> read_xml_arrays(const std::string& path) {
  return XmlArrayReader(path).read();
}

}  // namespace brunt
// Tested by tests/unit/io/vtu_mesh_test.cpp.
