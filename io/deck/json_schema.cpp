/// The JSON schema of decks (draft 7). What stands in a map, and what a map needs, are two trees:
/// a deck that includes another may leave out what that one has.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/deck/key_tree.hpp"
#include "io/deck/unit_pattern.hpp"

namespace brunt {

namespace {

using Json = nlohmann::ordered_json;

/// One of the definitions at the end of the schema.
Json reference(const std::string& name) { return {{"$ref", "#/definitions/" + name}}; }

Json any_of(std::initializer_list<Json> all) { return {{"anyOf", Json(all)}}; }

class SchemaWriter {
 public:
  Json write(const KeyInfo& root, const std::string& title) {
    Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
    schema.update(map_schema(root.children));
    schema["if"] = {{"not", {{"required", {"include"}}}}};
    schema["then"] = needs_of_map(root.children);
    definitions_["parameter"] = {{"type", "string"},
                                 {"pattern", "^(?:" + parameter_pattern() + ")$"}};
    definitions_["unit"] = {{"type", "string"}};
    schema["definitions"] = definitions_;
    return schema;
  }

 private:
  /// Keys of a map; an inline choice adds its alternatives. A parameter may stand for the map.
  Json map_schema(const std::vector<KeyInfo>& children) {
    Json properties = Json::object();
    for (const KeyInfo& child : children) {
      if (child.in_line) {
        for (const KeyInfo& alternative : child.children) {
          properties[alternative.name] = schema_of(alternative);
        }
      } else {
        properties[child.name] = schema_of(child);
      }
    }
    Json schema = object_schema(properties);
    // Of several alternatives one stands alone.
    for (const KeyInfo& child : children) {
      if (!child.in_line) continue;
      Json pairs = Json::array();
      for (std::size_t a = 0; a < child.children.size(); ++a) {
        for (std::size_t b = a + 1; b < child.children.size(); ++b) {
          pairs.push_back({{"required", {child.children[a].name, child.children[b].name}}});
        }
      }
      schema["not"] = {{"anyOf", pairs}};
    }
    return schema;
  }

  static Json object_schema(const Json& properties) {
    return {{"type", {"object", "string"}},
            {"pattern", "^\\$[A-Za-z_]"},
            {"additionalProperties", false},
            {"properties", properties}};
  }

  /// A number with or without a unit; its schema is shared by all keys of that unit and range.
  Json quantity(const std::string& unit, const Range& range) {
    std::string name = unit.empty() ? "number" : unit == "1" ? "pure number" : unit;
    Json schema{{"type", {"number", "string"}}};
    const auto bound = [&](Real value, bool excluded, const char* open, const char* closed) {
      if (std::abs(value) == kInfinity) return;
      schema[excluded ? open : closed] = value;
      name += std::string(" ") + (excluded ? open : closed) + " " + Json(value).dump();
    };
    bound(range.min, range.min_excluded, "exclusiveMinimum", "minimum");
    bound(range.max, range.max_excluded, "exclusiveMaximum", "maximum");
    schema["pattern"] = quantity_pattern(unit, range);
    for (char& c : name) {
      if (c == '/') c = '|';  // would divide a path
    }
    definitions_[name] = schema;
    // A reference is part of an address.
    std::string address;
    for (const char c : name) {
      address += c == ' ' ? "%20" : c == '|' ? "%7C" : c == '^' ? "%5E" : std::string(1, c);
    }
    return reference(address);
  }

  /// A list of so many; vectors have two or three components by the geometry.
  static Json list_of(const Json& items, int size) {
    Json schema{{"type", {"array", "string"}}, {"pattern", "^\\$[A-Za-z_]"}, {"items", items}};
    schema["minItems"] = size == Schema::kVector ? 2 : std::max(size, 1);
    if (size != 0) schema["maxItems"] = size == Schema::kVector ? 3 : size;
    return schema;
  }

  /// {unit: mm, value: [...]} in the place of a list.
  static Json with_unit_once(const Json& list) {
    const Json once{{"type", "object"},
                    {"additionalProperties", false},
                    {"properties", {{"unit", reference("unit")}, {"value", {{"type", "array"}}}}},
                    {"required", {"unit", "value"}}};
    return any_of({list, once});
  }

  static Json words_schema(const std::vector<std::string>& words) {
    Json all = Json::array();
    for (const std::string& synonyms : words) {
      for (std::size_t from = 0; from <= synonyms.size();) {
        const std::size_t bar = std::min(synonyms.find('|', from), synonyms.size());
        const std::string word = synonyms.substr(from, bar - from);
        all.push_back(word);
        if (word == "off") all.push_back(false);  // as YAML 1.1 reads it
        from = bar + 1;
      }
    }
    return any_of({Json{{"enum", all}}, reference("parameter")});
  }

  Json table_schema(const KeyInfo& key) {
    Json rows{{"type", "array"}, {"minItems", 2}};
    const Range range = key.unit == "K" ? Range{} : key.range;  // with unit: degC, any number
    rows["items"] = {{"type", "array"},
                     {"items", Json::array({quantity("any", {}), quantity(key.unit, range)})},
                     {"minItems", 2},
                     {"maxItems", 2}};
    return {{"type", "object"},
            {"additionalProperties", false},
            {"properties",
             {{"table", any_of({rows, reference("parameter")})},
              {"file", {{"type", "string"}}},
              {"over", words_schema(key.words)},
              {"unit", list_of(reference("unit"), 2)}}},
            {"required", {"over"}},
            {"oneOf", {Json{{"required", {"table"}}}, Json{{"required", {"file"}}}}}};
  }

  Json varying_schema(const KeyInfo& key) {
    Json value = any_of({quantity(key.unit, key.range), table_schema(key)});
    if (key.children.empty()) return value;
    Json law = map_schema(key.children);
    law["type"] = "object";
    return any_of({quantity(key.unit, key.range), table_schema(key), law});
  }

  Json one_of_schema(const KeyInfo& key) {
    Json any = Json::array(), words = Json::array(), properties = Json::object();
    for (const KeyInfo& alternative : key.children) {
      if (alternative.in_line) {
        any.push_back(map_schema(alternative.children));
        any.back()["type"] = "object";
        continue;
      }
      if (!is_bare(alternative)) words.push_back(alternative.name);
      properties[alternative.name] = schema_of(alternative);
    }
    any.push_back(Json{{"enum", words}});
    any.push_back(reference("parameter"));
    any.push_back(Json{{"type", "object"},
                       {"additionalProperties", false},
                       {"properties", properties},
                       {"minProperties", 1},
                       {"maxProperties", 1}});
    return {{"anyOf", any}};
  }

  /// An alternative that is written with a value: side: min-x.
  static bool is_bare(const KeyInfo& key) {
    return key.children.size() == 1 && key.children.front().bare;
  }

  Json whole_number(const Range& range) {
    return {{"allOf", {Json{{"type", "integer"}}, quantity("", range)}}};
  }

  /// Several numbers.
  Json list_schema(const KeyInfo& key) {
    using Type = KeyInfo::Type;
    const Json parameter = reference("parameter");
    switch (key.type) {
      case Type::list: {
        Json item = quantity(key.unit, key.range);
        if (key.free_allowed) item = any_of({item, Json{{"enum", {"free"}}}});
        return with_unit_once(list_of(item, key.size));
      }
      case Type::points:
        return with_unit_once(Json{{"type", {"array", "string"}},
                                   {"pattern", "^\\$[A-Za-z_]"},
                                   {"minItems", 3},
                                   {"items", list_of(quantity(key.unit, key.range), 2)}});
      case Type::integers:
        return list_of(any_of({whole_number(key.range), parameter}), key.size);
      case Type::components:
        return with_unit_once(
            list_of(any_of({Json{{"enum", {"free"}}}, varying_schema(key)}), key.size));
      default:  // per_axis
        return any_of({quantity(key.unit, key.range),
                       with_unit_once(list_of(quantity(key.unit, key.range), Schema::kVector))});
    }
  }

  /// A map; where the key takes them a list of maps, and words for flags.
  Json map_or_list_schema(const KeyInfo& key) {
    if (is_bare(key)) return schema_of(key.children.front());
    Json map = map_schema(key.children);
    if (!key.list_allowed) return map;
    const Json word{{"enum", key.words}};
    const Json item = key.words.empty() ? map : any_of({word, map});
    const Json list{{"type", "array"}, {"minItems", 1}, {"items", item}};
    return key.words.empty() ? any_of({map, list}) : any_of({word, map, list});
  }

  Json value_schema(const KeyInfo& key) {
    using Type = KeyInfo::Type;
    const Json parameter = reference("parameter");
    switch (key.type) {
      case Type::map:
        return map_or_list_schema(key);
      case Type::named: {
        const Json entry = map_schema(key.children);
        Json schema{{"type", "object"},
                    {"propertyNames", {{"pattern", "^[A-Za-z0-9_][A-Za-z0-9_-]{0,99}$"}}},
                    {"additionalProperties", entry}};
        if (!key.list_allowed) return any_of({schema, parameter});
        return any_of({schema, Json{{"type", "array"}, {"items", entry}}, parameter});
      }
      case Type::one_of:
        return one_of_schema(key);
      case Type::real:
        return quantity(key.unit, key.range);
      case Type::real_or_word:
        return any_of({quantity(key.unit, key.range), words_schema(key.words)});
      case Type::integer:
        return any_of({whole_number(key.range), parameter});
      case Type::integer_or_word:
        return any_of({whole_number(key.range), parameter, words_schema(key.words)});
      case Type::flag:
        return any_of({Json{{"enum", {true, false, "true", "false"}}}, parameter});
      case Type::text:
        return {{"type", {"string", "number", "boolean"}}};
      case Type::choice:
        return words_schema(key.words);
      case Type::words:
        return list_of(words_schema(key.words), 0);
      case Type::names:
        return list_of(Json{{"type", {"string", "number"}}}, key.size);
      case Type::list:
      case Type::points:
      case Type::integers:
      case Type::components:
      case Type::per_axis:
        return list_schema(key);
      case Type::direction:
        return any_of({Json{{"enum", {"x", "y", "z"}}}, parameter,
                       list_of(quantity("1", {}), Schema::kVector)});
      case Type::varying:
        return varying_schema(key);
      case Type::parameters:
        return {{"type", "object"}, {"propertyNames", {{"pattern", "^[A-Za-z_][A-Za-z0-9_]*$"}}}};
      case Type::empty:
        return {{"type", "object"}, {"maxProperties", 0}};
    }
    return Json::object();
  }

  Json schema_of(const KeyInfo& key) {
    Json schema = value_schema(key);
    if (schema.contains("$ref")) schema = Json{{"allOf", {schema}}};  // hides what stands beside it
    schema["description"] = key.help + " (" + facts_text(key) + ")";
    return schema;
  }

  /// What the values of a key need; null where nothing. Says nothing of values that are no maps.
  Json needs_of(const KeyInfo& key) {
    using Type = KeyInfo::Type;
    if (key.bare || is_bare(key)) return nullptr;
    switch (key.type) {
      case Type::map: {
        Json one = needs_of_map(key.children);
        if (!key.list_allowed || one.is_null()) return one;
        Json both = one;
        both["items"] = one;
        return both;
      }
      case Type::named: {
        const Json entry = needs_of_map(key.children);
        if (entry.is_null()) return nullptr;
        Json schema{{"additionalProperties", entry}};
        if (key.required) schema["minProperties"] = 1;
        if (key.list_allowed) schema["items"] = entry;
        return schema;
      }
      case Type::one_of: {
        Json properties = Json::object();
        add_needs_of_alternatives(key, properties);
        return properties.empty() ? Json(nullptr) : Json{{"properties", properties}};
      }
      case Type::varying: {
        const Json law = needs_of_map(key.children);
        if (law.is_null()) return nullptr;
        const Json table{{"anyOf",
                          {Json{{"required", {"over"}}}, Json{{"required", {"table"}}},
                           Json{{"required", {"file"}}}}}};
        return {{"if", {{"not", table}}}, {"then", law}};
      }
      default:
        return nullptr;
    }
  }

  void add_needs_of_alternatives(const KeyInfo& key, Json& properties) {
    for (const KeyInfo& alternative : key.children) {
      if (alternative.in_line) continue;
      const Json needs = needs_of(alternative);
      if (!needs.is_null()) properties[alternative.name] = needs;
    }
  }

  /// A condition of one key on another of its map: "rigid: true", "!rigid: true", "!file".
  static Json condition(const std::string& when) {
    const bool negated = when.front() == '!';
    const std::string text = when.substr(negated ? 1 : 0);
    const auto colon = text.find(": ");
    Json holds{{"required", {text.substr(0, colon)}}};
    if (colon != std::string::npos) {
      const std::string value = text.substr(colon + 2);
      Json values = Json::array({value});
      if (value == "true") values.push_back(true);
      holds["properties"] = {{text.substr(0, colon), {{"enum", values}}}};
    }
    return negated ? Json{{"not", holds}} : holds;
  }

  Json needs_of_map(const std::vector<KeyInfo>& children) {
    Json schema = Json::object(), properties = Json::object(), required = Json::array();
    Json all = Json::array();
    bool library = false;
    for (const KeyInfo& child : children) {
      library = library || child.name == "library";
      if (child.in_line) {
        add_needs_of_alternatives(child, properties);
        if (!child.required) continue;
        Json any = Json::array();
        for (const KeyInfo& one : child.children) any.push_back({{"required", {one.name}}});
        all.push_back({{"anyOf", any}});
        continue;
      }
      const Json needs = needs_of(child);
      if (!needs.is_null()) properties[child.name] = needs;
      if (!child.needed_when.empty()) {
        all.push_back(
            {{"if", condition(child.needed_when)}, {"then", {{"required", {child.name}}}}});
      } else if (child.required && child.when.empty()) {
        required.push_back(child.name);
      }
    }
    if (!required.empty()) schema["required"] = required;
    if (!properties.empty()) schema["properties"] = properties;
    if (!all.empty()) schema["allOf"] = all;
    if (schema.empty()) return nullptr;
    // A parameter may stand for a map, and values of the library under it.
    Json filter{{"type", "object"}};
    if (library) filter["not"] = {{"required", {"library"}}};
    return {{"if", filter}, {"then", schema}};
  }

  Json definitions_ = Json::object();
};

}  // namespace

std::string json_schema_text(const KeyInfo& root, const std::string& title) {
  return SchemaWriter().write(root, title).dump(2) + "\n";
}

}  // namespace brunt
// Tested by tests/cli/schema.sh.
