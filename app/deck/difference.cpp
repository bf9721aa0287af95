#include "app/deck/difference.hpp"

#include <algorithm>
#include <map>

#include "io/deck/node.hpp"
#include "io/deck/yaml_reader.hpp"

namespace brunt {

namespace {
bool may_differ(const std::string& path) {
  static constexpr const char* kFree[] = {"time.end", "time.until", "title", "max_cells"};
  return path.starts_with("output.") || path.starts_with("ranks.") ||
         std::any_of(std::begin(kFree), std::end(kFree),
                     [&](const char* key) { return path == key; });
}

using Leaves = std::map<std::string, std::string>;

/// Texts of all that is no map, by path; what is empty stands there too.
void collect(const Node& node, const std::string& path, Leaves& leaves) {
  const auto under = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
  if (node.is_map() && !node.entries.empty()) {
    for (const Entry& entry : node.entries) collect(entry.value, under(entry.key), leaves);
  } else if (node.is_list() && !node.items.empty()) {
    for (std::size_t k = 0; k < node.items.size(); ++k) {
      collect(node.items[k], under(std::to_string(k)), leaves);
    }
  } else if (!may_differ(path)) {
    leaves[path] = node.is_scalar() ? node.text : what_stands(node);
  }
}

std::string at(const Leaves& leaves, const std::string& path) {
  const auto found = leaves.find(path);
  return found == leaves.end() ? "nothing" : found->second;
}
}  // namespace

std::vector<std::string> deck_differences(const std::string& checkpoint, const std::string& deck,
                                          const std::string& where) {
  Leaves then, now;
  collect(read_yaml(checkpoint, "deck of the " + where), "", then);
  collect(read_yaml(deck, "deck"), "", now);
  Leaves all = then;
  all.insert(now.begin(), now.end());
  std::vector<std::string> differences;
  for (const auto& [path, unused] : all) {
    const auto before = at(then, path), after = at(now, path);
    if (before == after) continue;
    differences.push_back(path + ": " + before + " in the " + where + ", " + after +
                          " in the deck");
  }
  return differences;
}

}  // namespace brunt
