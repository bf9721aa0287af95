#include "app/deck/reference.hpp"

#include <algorithm>

#include "app/deck/deck.hpp"

namespace brunt::deck {

namespace {

KeyInfo early_key(const char* name, const char* help, KeyInfo::Type type) {
  KeyInfo key;
  key.name = name;
  key.help = help;
  key.type = type;
  return key;
}

KeyInfo keys_of(Geometry geometry) {
  return key_tree(geometry, [](Schema& s) {
    Deck blank;
    describe(s, blank);
  });
}

/// What one geometry does not need is not needed in general.
void keep_common_needs(KeyInfo& key, const KeyInfo& other) {
  if (!other.required) key.required = false;
  for (KeyInfo& child : key.children) {
    const auto same = std::find_if(other.children.begin(), other.children.end(),
                                   [&](const KeyInfo& one) { return one.name == child.name; });
    if (same != other.children.end()) keep_common_needs(child, *same);
  }
}

/// The needs of bodies that depend on what else stands there, as describe() has them.
void set_conditions(KeyInfo& bodies) {
  for (KeyInfo& key : bodies.children) {
    if (key.name == "material") key.needed_when = "!rigid: true";
    if (key.name == "shape") key.needed_when = "!file";
    if (key.name == "size") key.needed_when = "method: sph";
  }
}

/// A reference and an exact value have the unit of what is measured.
void free_the_reference(KeyInfo& measures) {
  for (KeyInfo& key : measures.children) {
    if (key.name == "reference" || key.name == "exact") key.unit = "any";
  }
}

}  // namespace

KeyInfo schema_keys() {
  KeyInfo root = deck_keys();
  keep_common_needs(root, keys_of(Geometry::plane_strain));
  return root;
}

KeyInfo deck_keys() {
  KeyInfo root = keys_of(Geometry::three_d);
  for (KeyInfo& key : root.children) {
    if (key.name == "bodies") set_conditions(key);
    if (key.name == "measures") free_the_reference(key);
    if (key.name != "materials") continue;
    key.children.insert(key.children.begin(),
                        early_key("library",
                                  "name of a material of the library, whose values hold "
                                  "where nothing stands beside",
                                  KeyInfo::Type::text));
  }
  root.children.insert(root.children.begin(),
                       early_key("parameters", "values by name; $name stands for the value",
                                 KeyInfo::Type::parameters));
  root.children.insert(root.children.begin(),
                       early_key("include", "decks that are read before this one; this one wins",
                                 KeyInfo::Type::names));
  return root;
}

}  // namespace brunt::deck
