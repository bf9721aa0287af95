#include "app/deck/reference.hpp"

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

}  // namespace

KeyInfo deck_keys() {
  KeyInfo root = key_tree(Geometry::three_d, [](Schema& s) {
    Deck blank;
    describe(s, blank);
  });
  for (KeyInfo& key : root.children) {
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
