/// Manual and explanations from a tree of keys.
#include "io/deck/key_tree.hpp"
#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"

namespace brunt {

namespace {

bool has_range(const Range& range) { return range.min > -kInfinity || range.max < kInfinity; }

/// A bar would end a cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

void manual_rows(const KeyInfo& key, const std::string& path, std::string& out) {
  for (const KeyInfo& child : key.children) {
    std::string child_path = path;
    if (!child.in_line && !child.bare) child_path += (path.empty() ? "" : ".") + child.name;
    const std::string unit = child.unit.empty() || child.unit == "any" ? "" : child.unit;
    if (!child.in_line) {
      out += "| `" + child_path + "` | " + cell(type_text(child)) + " | " + cell(unit) + " | " +
             (has_range(child.range) ? range_text(child.range) : "") + " | " +
             (child.required ? "required" : cell(child.fallback)) + " | " +
             cell(child.help + (child.when.empty() ? "" : " (" + child.when + ")")) + " |\n";
    }
    manual_rows(child, child.type == KeyInfo::Type::named ? child_path + ".NAME" : child_path, out);
  }
}

}  // namespace

std::string facts_text(const KeyInfo& key) {
  std::string text = type_text(key);
  if (has_range(key.range)) text += "; " + range_text(key.range);
  if (key.required) text += "; required";
  if (!key.fallback.empty()) text += "; default " + key.fallback;
  if (!key.when.empty()) text += "; " + key.when;
  return text;
}

std::string manual_text(const KeyInfo& root, const std::string& title) {
  std::string out = "# " + title + "\n\n";
  for (const KeyInfo& section : root.children) {
    out +=
        "## " + section.name + "\n\n" + section.help + ". Takes: " + facts_text(section) + ".\n\n";
    if (section.children.empty()) continue;
    out += "| key | takes | unit | range | default | meaning |\n|---|---|---|---|---|---|\n";
    const bool named = section.type == KeyInfo::Type::named;
    manual_rows(section, section.name + (named ? ".NAME" : ""), out);
    out += "\n";
  }
  return out;
}

std::string explain_text(const KeyInfo& key, const std::string& path) {
  std::string out;
  if (!path.empty()) {
    out += path + "\n  " + key.help + "\n  takes: " + facts_text(key) + "\n";
    if (has_range(key.plausible)) out += "  usual: " + range_text(key.plausible) + "\n";
  }
  std::size_t widest = 0;
  std::vector<const KeyInfo*> shown;
  for (const KeyInfo& child : key.children) {
    if (child.in_line) {
      for (const KeyInfo& alternative : child.children) shown.push_back(&alternative);
    } else {
      shown.push_back(&child);
    }
  }
  for (const KeyInfo* child : shown) widest = std::max(widest, child->name.size());
  for (const KeyInfo* child : shown) {
    const std::string name = child->bare ? "" : child->name;
    out += "  " + name + std::string(widest - name.size() + 2, ' ') + child->help + " (" +
           facts_text(*child) + ")\n";
  }
  return out;
}

}  // namespace brunt
// Tested by tests/unit/io/sources_test.cpp.
