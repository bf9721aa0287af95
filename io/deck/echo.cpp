#include "io/deck/echo.hpp"

#include <cmath>

#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"

namespace brunt {

namespace {

Node number(Real value) { return scalar_node(std::isnan(value) ? "free" : shortest_text(value)); }

Node numbers(const std::vector<Real>& values) {
  Node list = list_node();
  for (const Real value : values) list.items.push_back(number(value));
  return list;
}

/// A dollar in a text is written twice.
Node text_node(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '$' ? std::string("$$") : std::string(1, c);
  return scalar_node(escaped);
}

Node varying_node(const Varying& varying) {
  if (varying.is_constant()) return number(varying.constant);
  if (varying.is_expression()) return scalar_node(varying.expression);
  Node rows = list_node();
  for (std::size_t i = 0; i < varying.abscissa.size(); ++i) {
    rows.items.push_back(numbers({varying.abscissa[i], varying.ordinate[i]}));
  }
  Node table = map_node();
  add_entry(table, "table", rows);
  add_entry(table, "over", scalar_node(over_word(varying.over)));
  return table;
}

}  // namespace

Echo::Echo(Geometry geometry) : geometry_(geometry), stack_{map_node()} {}

void Echo::put(const std::string& key, Node value) {
  add_entry(stack_.back(), key, std::move(value));
}

Node Echo::members_of(const Members& members) {
  stack_.push_back(map_node());
  members(*this);
  Node node = std::move(stack_.back());
  stack_.pop_back();
  return node;
}

void Echo::real(const Key& key, Real& value, const Quantity&) {
  if (std::isfinite(value)) put(key.name, number(value));
}
void Echo::real(const Key& key, std::optional<Real>& value, const Quantity&) {
  if (value) put(key.name, number(*value));
}
void Echo::real_or_word(const Key& key, std::optional<Real>& value, const Quantity&,
                        const char* word) {
  put(key.name, value ? number(*value) : scalar_node(word));
}
void Echo::integer_or_word(const Key& key, std::optional<int>& value, const Range&,
                           const char* word) {
  put(key.name, scalar_node(value ? std::to_string(*value) : word));
}
void Echo::integer(const Key& key, int& value, const Range&) {
  put(key.name, scalar_node(std::to_string(value)));
}
void Echo::flag(const Key& key, bool& value) {
  put(key.name, scalar_node(value ? "true" : "false"));
}
void Echo::text(const Key& key, std::string& value) {
  if (!value.empty()) put(key.name, text_node(value));
}
void Echo::choice(const Key& key, int& index, std::span<const char* const> words) {
  put(key.name, scalar_node(main_word(words[index])));
}
void Echo::list(const Key& key, std::vector<Real>& value, const Quantity&, int, bool) {
  if (!value.empty()) put(key.name, numbers(value));
}
void Echo::list(const Key& key, std::optional<std::vector<Real>>& value, const Quantity&, int,
                bool) {
  if (value) put(key.name, numbers(*value));
}
void Echo::direction(const Key& key, std::vector<Real>& value) {
  if (!value.empty()) put(key.name, numbers(value));
}
void Echo::per_axis(const Key& key, std::optional<std::vector<Real>>& value, const Quantity&) {
  if (value) put(key.name, numbers(*value));
}
void Echo::points(const Key& key, std::vector<std::vector<Real>>& value, const Quantity&) {
  if (value.empty()) return;
  Node list = list_node();
  for (const auto& point : value) list.items.push_back(numbers(point));
  put(key.name, list);
}
void Echo::integers(const Key& key, std::optional<std::vector<int>>& value, int, const Range&) {
  if (!value) return;
  Node list = list_node();
  for (const int entry : *value) list.items.push_back(scalar_node(std::to_string(entry)));
  put(key.name, list);
}
void Echo::words(const Key& key, std::vector<std::string>& value, std::span<const char* const>) {
  if (value.empty()) return;
  Node list = list_node();
  for (const std::string& word : value) list.items.push_back(scalar_node(word));
  put(key.name, list);
}
void Echo::names(const Key& key, std::vector<std::string>& value, int) {
  if (value.empty()) return;
  Node list = list_node();
  for (const std::string& name : value) list.items.push_back(text_node(name));
  put(key.name, list);
}
void Echo::varying(const Key& key, std::optional<Varying>& value, const Quantity&,
                   std::span<const Varying::Over>) {
  if (value) put(key.name, varying_node(*value));
}
void Echo::components(const Key& key, std::optional<std::vector<std::optional<Varying>>>& value,
                      const Quantity&, std::span<const Varying::Over>) {
  if (!value) return;
  Node list = list_node();
  for (const auto& component : *value) {
    list.items.push_back(component ? varying_node(*component) : scalar_node("free"));
  }
  put(key.name, list);
}

void Echo::value(Real& value, const Quantity&, const char*) { stack_.back() = number(value); }
void Echo::value(int& index, std::span<const char* const> words, const char*) {
  stack_.back() = scalar_node(main_word(words[index]));
}
void Echo::value(std::string& text, const char*) { stack_.back() = scalar_node(text); }

void Echo::section(bool applies, const char*, std::function<void(Schema&)> members) {
  if (applies) members(*this);
}

void Echo::visit_object(const Key& key, std::function<bool()> present, std::function<void()>,
                        Members members) {
  if (!present()) return;
  Node node = members_of(members);
  if (!node.is_map() || !node.entries.empty()) put(key.name, std::move(node));
}

void Echo::visit_named(const Key& key, bool, std::function<std::size_t()> size,
                       std::function<std::string(std::size_t)> name,
                       std::function<void(const std::string&)>,
                       std::function<void(std::size_t, Schema&)> members, Members) {
  if (size() == 0) return;
  Node map = map_node();
  for (std::size_t i = 0; i < size(); ++i) {
    add_entry(map, name(i), members_of([&](Schema& s) { members(i, s); }));
  }
  put(key.name, std::move(map));
}

void Echo::visit_one_or_more(const Key& key, std::function<std::size_t()> size,
                             std::function<void()>,
                             std::function<void(std::size_t, Schema&)> members, Members) {
  Node list = list_node();
  for (std::size_t i = 0; i < size(); ++i) {
    list.items.push_back(members_of([&](Schema& s) { members(i, s); }));
  }
  if (size() == 1) put(key.name, std::move(list.items.front()));
  if (size() > 1) put(key.name, std::move(list));
}

/// As one map, which reads back as a list would.
void Echo::visit_any_of(const Key& key, Members members) { put(key.name, members_of(members)); }

void Echo::visit_one_of(const Key& key, std::span<const Alternative> alternatives,
                        std::function<std::size_t()> index, std::function<void(std::size_t)>,
                        Members members, std::function<void(std::size_t, Schema&)>) {
  const std::string name = alternatives[index()].name;
  Node node = members_of(members);
  if (alternatives[index()].open) {
    put(key.name, std::move(node));
    return;
  }
  const bool bare = node.is_map() && node.entries.empty();
  if (*key.name == '\0') {
    put(name, std::move(node));
  } else if (bare) {
    put(key.name, scalar_node(name));
  } else {
    Node map = map_node();
    add_entry(map, name, std::move(node));
    put(key.name, std::move(map));
  }
}

void Echo::visit_varying_or_law(const Key& key, std::optional<Varying>& value,
                                const Quantity& quantity, std::span<const Varying::Over> over,
                                std::function<bool()> is_law, std::function<void(bool)>,
                                Members members) {
  if (is_law()) {
    put(key.name, members_of(members));
  } else {
    varying(key, value, quantity, over);
  }
}

}  // namespace brunt
// Tested by tests/unit/app/deck_test.cpp.
