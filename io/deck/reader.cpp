#include "io/deck/reader.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "io/deck/number.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

namespace {

constexpr std::size_t kLongestName = 100;  // of bodies, files are called; those have up to 255

/// What is wrong with the name of an entry; "": nothing.
std::string name_problem(const std::string& name) {
  const auto allowed = [](char c) {
    return c == '_' || c == '-' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z');
  };
  const std::string rule = "letters, digits, _ and - make names";
  if (!std::all_of(name.begin(), name.end(), allowed) || name.empty()) {
    return "'" + name + "' is not a name: " + rule;
  }
  if (name.front() == '-') return "'" + name + "' is not a name: " + rule + ", and no - begins one";
  if (name.size() <= kLongestName) return "";
  return "'" + name.substr(0, 20) + "...' has " + std::to_string(name.size()) +
         " characters; a name has at most " + std::to_string(kLongestName);
}

/// What may be wrong where --set gives keys of something that the deck does not have.
std::string made_anew(const Node& node, const std::string& path) {
  if (!node.place.file.starts_with("--set")) return "";
  return "; this is " + path + " as --set alone gives it: is its name right?";
}

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const Node& empty_map() {
  static const Node kEmpty = map_node();
  return kEmpty;
}

}  // namespace

Reader::Reader(const Node& root, Geometry geometry, const Units& units,
               const ParameterValues& parameters, ReadReport& report)
    : geometry_(geometry), units_(units), parameters_(parameters), report_(report) {
  open_scope(&root, "");
}

void Reader::finish(const std::vector<std::string>& taken) {
  assert(scopes_.size() == 1);
  scope().known.insert(scope().known.end(), taken.begin(), taken.end());
  close_scope();
}

void Reader::problem_at(const SourcePlace& place, const std::string& path,
                        const std::string& message) {
  report_.problems.push_back({place, path, message});
}

void Reader::problem(const Node& node, const std::string& path, const std::string& message) {
  problem_at(node.place, path, message);
}

void Reader::open_scope(const Node* node, const std::string& path) {
  Scope fresh;
  fresh.node = node;
  fresh.path = path;
  fresh.problems_before = report_.problems.size();
  scopes_.push_back(std::move(fresh));
}

void Reader::close_scope() {
  const Scope closed = std::move(scopes_.back());
  scopes_.pop_back();
  if (!closed.node->is_map()) {
    if (!closed.value_taken && !closed.node->is_null()) {
      const std::string keys = joined(closed.known);
      problem(*closed.node, closed.path,
              (keys.empty() ? "has no keys and takes no value" : "expects a map of " + keys) +
                  ", got " + what_stands(*closed.node));
      return;
    }
  }
  tell_unknown_and_missing(closed);
  // A key that is not known may be the one that was meant.
  const auto known = [&](const Entry& entry) { return contains(closed.known, entry.key); };
  if (!std::all_of(closed.node->entries.begin(), closed.node->entries.end(), known)) return;
  for (const DeckProblem& broken : closed.broken) report_.problems.push_back(broken);
}

void Reader::tell_unknown_and_missing(const Scope& closed) {
  std::vector<const Entry*> unknown;
  std::vector<std::string> meant;
  for (const Entry& entry : closed.node->entries) {
    if (contains(closed.known, entry.key)) continue;
    unknown.push_back(&entry);
    meant.push_back(nearest_word(entry.key, closed.known));
  }
  std::vector<const Key*> missing;
  for (const Key& key : closed.missing) {
    if (!contains(meant, key.name)) missing.push_back(&key);
  }
  // An unknown key may be the one that is missing, and then both are one mistake.
  auto next = missing.begin();
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    const Entry& entry = *unknown[i];
    std::string message = "unknown key '" + entry.key + "'" + suggestion(entry.key, closed.known);
    if (meant[i].empty() && next != missing.end()) {
      message += "; '" + std::string((*next++)->name) + "' is missing";
    }
    problem_at(entry.place, closed.path, message);
  }
  for (; next != missing.end(); ++next) {
    const std::string name = (*next)->name;
    problem_at(closed.node->place, closed.path.empty() ? name : closed.path + "." + name,
               "is missing: " + std::string((*next)->help) + made_anew(*closed.node, closed.path));
  }
  if (unknown.empty() && !closed.choice_missing.empty()) {
    problem(*closed.node, closed.path,
            closed.choice_missing + made_anew(*closed.node, closed.path));
  }
}

const Node* Reader::find(const Key& key) {
  Scope& here = scope();
  here.known.emplace_back(key.name);
  if (here.unsettled) return nullptr;
  const Entry* entry = here.node->find_entry(key.name);
  if (!entry) {
    if (key.need == Need::required && !not_applicable_) here.missing.push_back(key);
    return nullptr;
  }
  const std::string path = path_of(key.name);
  const bool has_keys = entry->value.is_map() || entry->value.is_null();
  report_.places[path] = has_keys ? entry->place : entry->value.place;
  if (not_applicable_) {
    problem_at(entry->place, path, std::string("this key is ") + not_applicable_);
    return nullptr;
  }
  if (entry->value.is_null()) {
    problem_at(entry->place, path, "has no value: " + std::string(key.help));
    return nullptr;
  }
  return &entry->value;
}

void Reader::read_members(const Node& node, const std::string& path, const Members& members) {
  open_scope(&node, path);
  members(*this);
  close_scope();
}

void Reader::section(bool applies, const char* when, std::function<void(Schema&)> members) {
  const char* outer = not_applicable_;
  if (!applies && !outer) not_applicable_ = when;
  members(*this);
  not_applicable_ = outer;
}

void Reader::require(bool holds, const char* at, const std::string& message) {
  if (holds || not_applicable_) return;
  const Scope& here = scope();
  if (report_.problems.size() > here.problems_before || !here.missing.empty()) return;
  if (here.unsettled || !here.choice_missing.empty() || !here.broken.empty()) return;
  const Entry* entry = here.node->find_entry(at);
  const bool itself = *at == '\0';
  scope().broken.push_back(
      {entry ? entry->place : here.node->place, itself ? here.path : path_of(at), message});
}

void Reader::visit_object(const Key& key, std::function<bool()> present,
                          std::function<void()> create, Members members) {
  const Node* node = find(key);
  if (!node) return;
  if (!present()) create();
  read_members(*node, path_of(key.name), members);
}

void Reader::visit_named(const Key& key, bool list_allowed, std::function<std::size_t()> size,
                         std::function<std::string(std::size_t)>,
                         std::function<void(const std::string&)> add,
                         std::function<void(std::size_t, Schema&)> members, Members) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  const auto read_entry = [&](const std::string& name, const SourcePlace& place,
                              const Node& value) {
    const std::string entry_path = path + "." + name;
    report_.places[entry_path] = place;
    add(name);
    const std::size_t i = size() - 1;
    read_members(value.is_null() ? empty_map() : value, entry_path,
                 [&](Schema& s) { members(i, s); });
  };
  if (node->is_list() && list_allowed) {
    for (std::size_t i = 0; i < node->items.size(); ++i) {
      read_entry(std::to_string(i), node->items[i].place, node->items[i]);
    }
  } else if (node->is_map()) {
    for (const Entry& entry : node->entries) {
      if (const auto wrong = name_problem(entry.key); !wrong.empty()) {
        problem_at(entry.place, path, wrong);
      } else if (entry.value.is_null()) {
        problem_at(entry.place, path + "." + entry.key, "has no keys");
      } else {
        read_entry(entry.key, entry.place, entry.value);
      }
    }
  } else {
    problem(*node, path, "expects a map of named entries, got " + what_stands(*node));
  }
}

const Entry* Reader::chosen_alternative(const Key& key, const Node& node, const std::string& path,
                                        const std::vector<std::string>& names) {
  const bool is_inline = *key.name == '\0';
  const auto is_alternative = [&](const Entry& entry) {
    return std::find(names.begin(), names.end(), entry.key) != names.end();
  };
  const Entry* chosen = nullptr;
  for (const Entry& entry : node.entries) {
    if (!is_alternative(entry)) {
      if (is_inline) continue;
      problem_at(entry.place, path,
                 "unknown key '" + entry.key + "'" + suggestion(entry.key, names));
      return nullptr;
    }
    if (chosen) {
      problem_at(entry.place, path,
                 "has both '" + chosen->key + "' and '" + entry.key + "': keep one");
      return nullptr;
    }
    chosen = &entry;
  }
  if (chosen || (is_inline && key.need == Need::optional)) return chosen;
  const std::string needed = "needs one of " + joined(names);
  if (is_inline) {
    scope().choice_missing = needed;  // reported unless an unknown key may be the one
  } else {
    problem(node, path, needed);
  }
  return nullptr;
}

void Reader::visit_one_or_more(const Key& key, std::function<std::size_t()> size,
                               std::function<void()> add,
                               std::function<void(std::size_t, Schema&)> members, Members) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  const auto read_entry = [&](const Node& value, const std::string& entry_path) {
    add();
    const std::size_t i = size() - 1;
    read_members(value.is_null() ? empty_map() : value, entry_path,
                 [&](Schema& s) { members(i, s); });
  };
  if (!node->is_list()) return read_entry(*node, path);
  if (node->items.empty())
    problem(*node, path, "expects a map or a list of maps, got an empty list");
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const std::string entry_path = path + "." + std::to_string(i);
    report_.places[entry_path] = node->items[i].place;
    read_entry(node->items[i], entry_path);
  }
}

void Reader::visit_any_of(const Key& key, Members members) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  Node all = map_node();
  all.place = node->place;
  const auto add = [&](const std::string& name, const SourcePlace& place, const Node& value) {
    if (all.find_entry(name)) return problem_at(place, path, "'" + name + "' is there twice");
    all.entries.push_back({name, place, value});
  };
  const auto take = [&](const Node& item) {
    if (item.is_scalar()) return add(item.text, item.place, item);
    for (const Entry& entry : item.entries) add(entry.key, entry.place, entry.value);
    if (!item.is_map()) problem(item, path, "expects a word or a map, got " + what_stands(item));
  };
  if (node->is_list()) {
    for (const Node& item : node->items) take(item);
  } else {
    take(*node);
  }
  open_scope(&all, path);
  scope().words_are_flags = true;
  members(*this);
  close_scope();
}

void Reader::visit_one_of(const Key& key, std::span<const Alternative> alternatives,
                          std::function<std::size_t()>, std::function<void(std::size_t)> choose,
                          Members members, std::function<void(std::size_t, Schema&)>) {
  const bool is_inline = *key.name == '\0';
  const Node* node = is_inline ? scope().node : find(key);
  if (!node) return;
  const std::string path = is_inline ? scope().path : path_of(key.name);
  std::vector<std::string> names;
  for (const Alternative& alternative : alternatives) names.emplace_back(alternative.name);
  const auto index_of = [&](const std::string& name) {
    return slot_of(std::find(names.begin(), names.end(), name) - names.begin());
  };
  if (is_inline) {
    scope().known.insert(scope().known.end(), names.begin(), names.end());
    if (!node->is_map()) return;  // reported when the scope closes
  } else if (node->is_scalar() && index_of(node->text) < names.size()) {
    const std::size_t index = index_of(node->text);
    choose(index);
    Node blank = map_node();
    blank.place = node->place;
    read_members(blank, path + "." + names[index], members);
    return;
  } else if (!node->is_map()) {
    const std::string near = node->is_scalar() ? nearest_word(node->text, names) : "";
    problem(*node, path,
            "expects one of " + joined(names) + ", got " + what_stands(*node) +
                (near.empty() ? "" : "; did you mean '" + near + "'?"));
    return;
  }
  const auto opens = [&](const Alternative& one) { return one.open && node->find(one.name); };
  const auto open = std::find_if(alternatives.begin(), alternatives.end(), opens);
  if (open != alternatives.end()) {
    choose(index_of(open->name));
    read_members(*node, path, members);
    return;
  }
  const Entry* chosen = chosen_alternative(key, *node, path, names);
  if (!chosen && is_inline && key.need == Need::required) scope().unsettled = true;
  if (!chosen || (is_inline && not_applicable_)) return;
  choose(index_of(chosen->key));
  const std::string chosen_path = path.empty() ? chosen->key : path + "." + chosen->key;
  report_.places[chosen_path] = chosen->place;
  if (chosen->value.is_null()) {
    problem_at(chosen->place, chosen_path, "has no value");
    return;
  }
  read_members(chosen->value, chosen_path, members);
}

}  // namespace brunt
// Tested by tests/unit/app/deck_test.cpp.
