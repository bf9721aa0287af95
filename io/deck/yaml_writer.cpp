/// Node to YAML: block maps, flow lists; every text that YAML could take for something else is
/// quoted.
#include <algorithm>

#include "io/deck/node.hpp"

namespace brunt {

namespace {

bool is_plain(const std::string& text) {
  if (text.empty() || text.front() == ' ' || text.back() == ' ' || text == "null") return false;
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-+./ ()$^;").find(c) != std::string_view::npos;
  };
  if (!std::all_of(text.begin(), text.end(), plain)) return false;
  const char first = text.front();
  const bool number = (first == '-' || first == '.') && text.size() > 1 && text[1] != ' ';
  if (text.starts_with("---") || text.starts_with("...")) return false;
  return number || !(first == '-' || first == '.' || first == ' ');
}

std::string scalar(const std::string& text) {
  if (is_plain(text)) return text;
  std::string quoted = "\"";
  constexpr const char* kHex = "0123456789abcdef";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += "\\x";
      quoted += kHex[byte >> 4];
      quoted += kHex[byte & 15];
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string flow(const Node& node) {
  std::string text;
  switch (node.kind) {
    case Node::Kind::null:
      return "null";
    case Node::Kind::scalar:
      return scalar(node.text);
    case Node::Kind::list:
      for (const Node& item : node.items) text += (text.empty() ? "" : ", ") + flow(item);
      return "[" + text + "]";
    case Node::Kind::map:
      for (const Entry& entry : node.entries) {
        text += (text.empty() ? "" : ", ") + scalar(entry.key) + ": " + flow(entry.value);
      }
      return "{" + text + "}";
  }
  return text;
}

void block(const Node& map, const std::string& indent, std::string& out) {
  for (const Entry& entry : map.entries) {
    out += indent + scalar(entry.key) + ":";
    if (entry.value.is_map() && !entry.value.entries.empty()) {
      out += "\n";
      block(entry.value, indent + "  ", out);
    } else {
      out += " " + flow(entry.value) + "\n";
    }
  }
}

}  // namespace

std::string to_yaml(const Node& node) {
  if (!node.is_map() || node.entries.empty()) return flow(node) + "\n";
  std::string out;
  block(node, "", out);
  return out;
}

}  // namespace brunt
// Tested by tests/unit/app/deck_test.cpp.
