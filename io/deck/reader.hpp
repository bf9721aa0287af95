#pragma once
/// The visitor that fills a struct from a tree. It goes on after a problem, so that all of a deck
/// is reported at once, and remembers where each key stands.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/schema.hpp"
#include "io/deck/expression.hpp"
#include "io/deck/node.hpp"
#include "io/deck/units.hpp"

namespace brunt {

/// What a reader has found.
struct ReadReport {
  std::vector<DeckProblem> problems;
  std::vector<DeckProblem> warnings;          ///< values outside of a plausible band
  std::map<std::string, SourcePlace> places;  ///< of each key that stands in the deck
};

class Reader final : public Schema {
 public:
  /// All references outlive the reader.
  Reader(const Node& root, Geometry geometry, const Units& units, const ParameterValues& parameters,
         ReadReport& report);
  /// Call once, after describe(): unknown and missing keys of the outermost map.
  /// taken  keys of it that were read before and taken out
  void finish(const std::vector<std::string>& taken = {});

  Geometry geometry() const override { return geometry_; }
  void real(const Key& key, Real& value, const Quantity& quantity) override;
  void real(const Key& key, std::optional<Real>& value, const Quantity& quantity) override;
  void real_or_word(const Key& key, std::optional<Real>& value, const Quantity& quantity,
                    const char* word) override;
  void integer(const Key& key, int& value, const Range& range) override;
  void integer_or_word(const Key& key, std::optional<int>& value, const Range& range,
                       const char* word) override;
  void flag(const Key& key, bool& value) override;
  void text(const Key& key, std::string& value) override;
  void choice(const Key& key, int& index, std::span<const char* const> words) override;
  void list(const Key& key, std::vector<Real>& value, const Quantity& quantity, int size,
            bool allow_free) override;
  void list(const Key& key, std::optional<std::vector<Real>>& value, const Quantity& quantity,
            int size, bool allow_free) override;
  void direction(const Key& key, std::vector<Real>& value) override;
  void per_axis(const Key& key, std::optional<std::vector<Real>>& value,
                const Quantity& quantity) override;
  void points(const Key& key, std::vector<std::vector<Real>>& value,
              const Quantity& quantity) override;
  void integers(const Key& key, std::optional<std::vector<int>>& value, int size,
                const Range& range) override;
  void words(const Key& key, std::vector<std::string>& value,
             std::span<const char* const> words) override;
  void names(const Key& key, std::vector<std::string>& value, int size) override;
  void varying(const Key& key, std::optional<Varying>& value, const Quantity& quantity,
               std::span<const Varying::Over> over) override;
  void components(const Key& key, std::optional<std::vector<std::optional<Varying>>>& value,
                  const Quantity& quantity, std::span<const Varying::Over> over) override;
  void value(Real& value, const Quantity& quantity, const char* help) override;
  void value(int& index, std::span<const char* const> words, const char* help) override;
  void value(std::string& text, const char* help) override;
  void section(bool applies, const char* when, std::function<void(Schema&)> members) override;
  void require(bool holds, const char* at, const std::string& message) override;

 protected:
  void visit_object(const Key& key, std::function<bool()> present, std::function<void()> create,
                    Members members) override;
  void visit_named(const Key& key, bool list_allowed, std::function<std::size_t()> size,
                   std::function<std::string(std::size_t)> name,
                   std::function<void(const std::string&)> add,
                   std::function<void(std::size_t, Schema&)> members, Members blank) override;
  void visit_one_or_more(const Key& key, std::function<std::size_t()> size,
                         std::function<void()> add,
                         std::function<void(std::size_t, Schema&)> members, Members blank) override;
  void visit_any_of(const Key& key, Members members) override;
  void visit_one_of(const Key& key, std::span<const Alternative> alternatives,
                    std::function<std::size_t()> index, std::function<void(std::size_t)> choose,
                    Members members, std::function<void(std::size_t, Schema&)> blank) override;
  void visit_varying_or_law(const Key& key, std::optional<Varying>& value, const Quantity& quantity,
                            std::span<const Varying::Over> over, std::function<bool()> is_law,
                            std::function<void(bool)> choose, Members members) override;

 private:
  /// A map that is being read.
  struct Scope {
    const Node* node = nullptr;
    std::string path;
    std::vector<std::string> known;  ///< keys of the schema so far
    std::vector<Key> missing;        ///< required and not there
    std::size_t problems_before = 0;
    std::vector<DeckProblem> broken;  ///< what does not hold, if all keys of the map are known
    std::string choice_missing;       ///< what to say where no alternative stands
    bool unsettled = false;           ///< which alternative is meant is not known, nor what it asks
    bool value_taken = false;         ///< a bare value was read
    bool words_are_flags = false;     ///< the name of a flag is its value too: [damage]
  };

  int dimensions() const { return geometry_ == Geometry::three_d ? 3 : 2; }
  Scope& scope() { return scopes_.back(); }
  std::string path_of(const std::string& key) {
    return scope().path.empty() ? key : scope().path + "." + key;
  }
  /// The value of a key, or null where it is not there, is empty, or does not apply.
  const Node* find(const Key& key);
  void open_scope(const Node* node, const std::string& path);
  void close_scope();
  /// Reports the keys of a map that are not known, and those that are missing.
  void tell_unknown_and_missing(const Scope& closed);
  /// The one alternative among the keys of a map, or null after a problem.
  const Entry* chosen_alternative(const Key& key, const Node& node, const std::string& path,
                                  const std::vector<std::string>& names);
  /// Reads members of `node` as one scope.
  void read_members(const Node& node, const std::string& path, const Members& members);
  void problem(const Node& node, const std::string& path, const std::string& message);
  void problem_at(const SourcePlace& place, const std::string& path, const std::string& message);

  /// SI value of a scalar; nothing after a problem. has_unit (out): it has one, or needs none.
  std::optional<Real> quantity_value(const Node& node, const std::string& path,
                                     const Quantity& quantity, bool* has_unit = nullptr);
  std::optional<Real> unchecked_value(const Node& node, const std::string& path,
                                      const std::string& unit, bool* has_unit);
  std::optional<Real> expression_value(const Node& node, const std::string& path,
                                       const std::string& unit);
  void check_range(const Node& node, const std::string& path, Real value, const Quantity& quantity);
  std::optional<int> integer_value(const Node& node, const std::string& path, const Range& range);
  std::optional<int> word_index(const Node& node, const std::string& path,
                                std::span<const char* const> words);
  /// A list of quantities, or {unit:, value:}; size 0: any; nothing after a problem.
  std::optional<std::vector<Real>> list_values(const Node& given, const std::string& path,
                                               const Quantity& quantity, int size,
                                               bool allow_free = false);
  /// Unfolds {unit: mm, value: [...]}: a copy with the unit behind each bare number.
  std::optional<Node> with_unit_once(const Node& node, const std::string& path);
  std::optional<Varying> compiled_value(const Node& node, const std::string& path,
                                        const Quantity& quantity, Varying::Over kind);
  std::optional<Varying> varying_value(const Node& node, const std::string& path,
                                       const Quantity& quantity,
                                       std::span<const Varying::Over> over);
  std::optional<Varying> table_value(const Node& node, const std::string& path,
                                     const Quantity& quantity, std::span<const Varying::Over> over);
  /// What a table is over; nothing after a problem with its keys.
  std::optional<Varying::Over> table_over(const Node& node, const std::string& path,
                                          std::span<const Varying::Over> over);
  std::optional<Node> table_rows(const Node& node, const std::string& path);

  Geometry geometry_;
  const Units& units_;
  const ParameterValues& parameters_;
  ReadReport& report_;
  std::uintmax_t table_bytes_ = 0;  ///< of all files of tables so far
  std::vector<Scope> scopes_;
  const char* not_applicable_ = nullptr;  ///< inside a section that does not apply: when it does
};

/// Adds `unit` behind each bare number below `node`; false where something else stands.
bool add_unit(Node& node, const std::string& unit);
/// "at least 0", "above 0", "from 0 to 1".
std::string range_text(const Range& range);
bool in_range(Real value, const Range& range);
/// "time", "temperature", ...: the word behind `over:`.
const char* over_word(Varying::Over over);
/// The SI unit of what a table is over.
const char* over_unit(Varying::Over over);
/// First spelling of a word with synonyms: "off" of "off|false".
std::string main_word(const char* words);
/// A text for "needs one of": "a, b or c" of the first spellings; refused words left out.
std::string word_list(std::span<const char* const> words);

}  // namespace brunt
// Tested by tests/unit/app/deck_test.cpp.
