/// Manual, JSON schema and explanations from a tree of keys.
#include <nlohmann/json.hpp>

#include "io/deck/key_tree.hpp"
#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"

namespace brunt {

namespace {

using Json = nlohmann::ordered_json;

bool has_range(const Range& range) { return range.min > -kInfinity || range.max < kInfinity; }

std::string facts(const KeyInfo& key) {
  std::string text = type_text(key);
  if (has_range(key.range)) text += "; " + range_text(key.range);
  if (key.required) text += "; required";
  if (!key.fallback.empty()) text += "; default " + key.fallback;
  if (!key.when.empty()) text += "; " + key.when;
  return text;
}

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

Json schema_of(const KeyInfo& key);

/// Keys of a map; an inline choice adds its alternatives.
Json map_schema(const std::vector<KeyInfo>& children) {
  Json schema{{"type", "object"}, {"additionalProperties", false}};
  Json properties = Json::object(), required = Json::array();
  for (const KeyInfo& child : children) {
    if (child.in_line) {
      for (const KeyInfo& alternative : child.children) {
        properties[alternative.name] = schema_of(alternative);
      }
    } else {
      properties[child.name] = schema_of(child);
      if (child.required) required.push_back(child.name);
    }
  }
  schema["properties"] = properties;
  // What is required may also come from the library.
  if (!required.empty() && !properties.contains("library")) schema["required"] = required;
  return schema;
}

Json number_schema() { return {{"type", {"number", "string"}}}; }

Json one_of_schema(const KeyInfo& key) {
  Json any = Json::array(), words = Json::array(), properties = Json::object();
  for (const KeyInfo& alternative : key.children) {
    if (alternative.in_line) {
      any.push_back(map_schema(alternative.children));
      continue;
    }
    words.push_back(alternative.name);
    properties[alternative.name] = schema_of(alternative);
  }
  any.push_back(Json{{"enum", words}});
  any.push_back(Json{{"type", "object"},
                     {"additionalProperties", false},
                     {"properties", properties},
                     {"minProperties", 1},
                     {"maxProperties", 1}});
  return Json{{"anyOf", any}};
}

Json words_schema(const std::vector<std::string>& words) {
  Json all = Json::array();
  for (const std::string& synonyms : words) {
    for (std::size_t from = 0; from <= synonyms.size();) {
      const std::size_t bar = std::min(synonyms.find('|', from), synonyms.size());
      const std::string word = synonyms.substr(from, bar - from);
      all.push_back(word);
      if (word == "false") all.push_back(false);
      from = bar + 1;
    }
  }
  return Json{{"enum", all}};
}

Json varying_or_law_schema(const KeyInfo& key) {
  const Json text{{"type", "string"}}, list{{"type", "array"}};
  const Json table{
      {"type", "object"},
      {"additionalProperties", false},
      {"properties",
       {{"table", list}, {"file", text}, {"over", words_schema(key.words)}, {"unit", list}}},
      {"required", {"over"}}};
  return Json{{"anyOf", {number_schema(), table, map_schema(key.children)}}};
}

Json value_schema(const KeyInfo& key) {
  using Type = KeyInfo::Type;
  Json list{{"type", {"array", "object", "string"}}};
  switch (key.type) {
    case Type::map:
      if (key.children.size() == 1 && key.children.front().bare) {
        return schema_of(key.children.front());
      }
      if (key.list_allowed) {
        const Json one = map_schema(key.children);
        return Json{{"anyOf", {one, Json{{"type", "array"}, {"items", one}}}}};
      }
      return map_schema(key.children);
    case Type::named:
      return Json{{"type", key.list_allowed ? Json{"object", "array"} : Json("object")},
                  {"additionalProperties", map_schema(key.children)}};
    case Type::one_of:
      return one_of_schema(key);
    case Type::real:
    case Type::real_or_word:
      return number_schema();
    case Type::integer:
      return Json{{"type", {"integer", "string"}}};
    case Type::flag:
      return Json{{"enum", {true, false, "true", "false"}}};
    case Type::text:
      return Json{{"type", {"string", "number"}}};
    case Type::choice:
      return words_schema(key.words);
    case Type::words:
      return Json{{"type", "array"}, {"items", words_schema(key.words)}};
    case Type::names:
      return Json{{"type", "array"}, {"items", {{"type", "string"}}}};
    case Type::list:
    case Type::points:
    case Type::integers:
    case Type::components:
    case Type::direction:
      return list;
    case Type::varying:
      if (!key.children.empty()) return varying_or_law_schema(key);
      [[fallthrough]];
    case Type::per_axis:
      return Json{{"type", {"number", "string", "array", "object"}}};
    case Type::parameters:
      return Json{{"type", "object"}};
    case Type::empty:
      return Json{{"type", {"object", "null"}}};
  }
  return Json::object();
}

Json schema_of(const KeyInfo& key) {
  Json schema = value_schema(key);
  schema["description"] = key.help + " (" + facts(key) + ")";
  return schema;
}

}  // namespace

std::string manual_text(const KeyInfo& root, const std::string& title) {
  std::string out = "# " + title + "\n\n";
  for (const KeyInfo& section : root.children) {
    out += "## " + section.name + "\n\n" + section.help + ". Takes: " + facts(section) + ".\n\n";
    if (section.children.empty()) continue;
    out += "| key | takes | unit | range | default | meaning |\n|---|---|---|---|---|---|\n";
    const bool named = section.type == KeyInfo::Type::named;
    manual_rows(section, section.name + (named ? ".NAME" : ""), out);
    out += "\n";
  }
  return out;
}

std::string json_schema_text(const KeyInfo& root, const std::string& title) {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  schema.update(map_schema(root.children));
  return schema.dump(2) + "\n";
}

std::string explain_text(const KeyInfo& key, const std::string& path) {
  std::string out;
  if (!path.empty()) {
    out += path + "\n  " + key.help + "\n  takes: " + facts(key) + "\n";
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
           facts(*child) + ")\n";
  }
  return out;
}

}  // namespace brunt
