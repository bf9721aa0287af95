#include "app/cli/reference.hpp"

#include <cstdio>

#include "app/cli/columns_page.hpp"
#include "app/cli/run_arguments.hpp"
#include "app/deck/deck.hpp"
#include "app/deck/library.hpp"
#include "app/deck/reference.hpp"
#include "io/deck/key_tree.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

namespace {

int explain_library() {
  const Node library = deck::library();
  for (const Entry& entry : library.entries) {
    std::printf("%s: %s\n", entry.key.c_str(), entry.value.find("summary")->text.c_str());
    for (const Node& source : entry.value.find("sources")->items) {
      std::printf("  %s\n", source.text.c_str());
    }
    std::printf("%s\n", to_yaml(*entry.value.find("values")).c_str());
  }
  return kDone;
}

}  // namespace

namespace {
/// Keys that end in what was asked for, a line each with what they take, or in full where there is
/// one alone.
void print_keys(const KeyInfo& root, const std::vector<std::string>& paths) {
  for (const auto& path : paths) {
    const KeyInfo& key = *find_key(root, path);
    const std::string text =
        paths.size() == 1 ? explain_text(key, path)
                          : path + "\n  " + key.help + "\n  takes: " + facts_text(key) + "\n";
    std::fputs(text.c_str(), stdout);
  }
}
}  // namespace

int explain_command(const std::string& key) {
  if (key == "library") return explain_library();
  const KeyInfo root = deck::deck_keys();
  auto elsewhere = paths_ending_in(root, key);
  if (const KeyInfo* found = find_key(root, key)) {
    std::fputs(explain_text(*found, key).c_str(), stdout);
    std::erase_if(elsewhere, [&](const auto& path) { return find_key(root, path) == found; });
    std::string list;
    for (const auto& path : elsewhere) list += (list.empty() ? "" : ", ") + path;
    if (!key.empty() && !list.empty()) std::printf("see also %s\n", list.c_str());
    return kDone;
  }
  if (!elsewhere.empty()) {
    print_keys(root, elsewhere);
    return kDone;
  }
  const std::string first = key.substr(0, key.find('.'));
  const bool first_known = find_key(root, first) != nullptr;
  std::vector<std::string> known;
  for (const KeyInfo& child : root.children) known.push_back(child.name);
  std::fprintf(
      stderr, "brunt: there is no key '%s'%s\n", key.c_str(),
      first_known ? ("; see brunt explain " + first).c_str() : suggestion(first, known).c_str());
  return kDeckWrong;
}

namespace {
std::string page_text(SchemaPage page) {
  switch (page) {
    case SchemaPage::keys:
      return manual_text(deck::deck_keys(), "The keys of a deck");
    case SchemaPage::columns:
      return columns_page();
    default:
      return json_schema_text(deck::schema_keys(), "A deck of brunt");
  }
}
}  // namespace

int schema_command(SchemaPage page) {
  std::fputs(page_text(page).c_str(), stdout);
  return kDone;
}

}  // namespace brunt
