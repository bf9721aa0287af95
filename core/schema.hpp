#pragma once
/// One description of each deck struct, six uses. Beside each struct stands
///   void describe(Schema& s, JohnsonCook& law) {
///     s.real({"A", "static yield stress at no plastic strain", Need::required}, law.A, {"Pa",
///     at_least(0)});
///   }
/// Visitors make of it: the reader with its errors, the manual, the JSON schema, the echo of the
/// resolved deck, `explain`, and the generated wrong decks. The default is the struct's
/// initialiser.
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/types.hpp"

namespace brunt {

enum class Need { optional, required };

/// A key: its name in the deck, one line of help, and whether it must be there.
struct Key {
  const char* name;
  const char* help;
  Need need = Need::optional;
};

struct Range {
  Real min = -kInfinity, max = kInfinity;
  bool min_excluded = false, max_excluded = false;
};
constexpr Range positive() { return {0, kInfinity, true, false}; }
constexpr Range at_least(Real min) { return {min, kInfinity, false, false}; }
constexpr Range between(Real min, Real max) { return {min, max, false, false}; }

/// unit: the SI unit whose dimension the value must have ("1" for a number, "rad" for an angle,
/// "any" where the dimension follows from elsewhere);
/// plausible: outside of it the value is accepted with a warning.
struct Quantity {
  const char* unit = "1";
  Range range{};
  Range plausible{};
};

/// A value that may depend on something: a constant, a table or an expression.
struct Varying {
  /// expression: of t, x, y, z; sliding: an expression of T, yield, p, v where two bodies slide
  enum class Over { nothing, time, temperature, slip_speed, pressure, eps_p, expression, sliding };
  Over over = Over::nothing;
  Real constant = 0;
  std::vector<Real> abscissa, ordinate;  ///< table: linear between, held outside; SI
  std::string expression;                ///< SI numbers in, SI number out
  /// Compiled expression, made by the reader, of its four arguments in SI, in the order above. May
  /// be called by many threads at once.
  std::function<Real(const std::array<Real, 4>&)> evaluate;
  std::array<bool, 4> depends{};  ///< which of the arguments stand in it
  bool is_constant() const { return over == Over::nothing; }
  bool is_expression() const { return over == Over::expression || over == Over::sliding; }
  /// Value of a constant or of a table at argument s.
  Real at(Real s) const;
};

/// A map that users name: {bar: {...}, anvil: {...}}; order is the deck's.
template <class T>
struct Named {
  std::string name;
  T value;
};

/// One of several maps, distinguished by their key: strength: {j2: {...}}. An alternative type T
/// has
///   static constexpr const char* deck_name, deck_help;
/// and describe(Schema&, T&). An alternative without keys is written as its bare name. One with
///   static constexpr bool deck_open = true;
/// is recognised by the first of its own keys, which has its name: heat: {conductance: 1e4, gap: 1
/// mm}.
struct Alternative {
  const char* name;
  const char* help;
  bool open = false;  ///< its keys stand where its name would
};
class Schema;
/// What has describe(Schema&, T&) beside it.
template <class T>
concept Described = requires(Schema& s, T& value) {
  describe(s, value);
};
template <class T>
constexpr Alternative alternative_of() {
  static_assert(Described<T>, "this alternative lacks describe(Schema&, T&) beside it");
  if constexpr (requires { T::deck_open; }) return {T::deck_name, T::deck_help, T::deck_open};
  return {T::deck_name, T::deck_help, false};
}

class Schema {
 public:
  virtual ~Schema() = default;

  /// The geometry of the deck, on which numbers of components and some needs depend.
  virtual Geometry geometry() const { return Geometry::three_d; }
  /// Its axes: x, y, and z in 3D.
  std::span<const char* const> axes() const {
    return {kAxes, geometry() == Geometry::three_d ? 3u : 2u};
  }

  virtual void real(const Key& key, Real& value, const Quantity& quantity) = 0;
  virtual void real(const Key& key, std::optional<Real>& value, const Quantity& quantity) = 0;
  virtual void integer(const Key& key, int& value, const Range& range) = 0;
  virtual void flag(const Key& key, bool& value) = 0;
  virtual void text(const Key& key, std::string& value) = 0;
  /// A quantity, or `word` where there is none: skin: auto.
  virtual void real_or_word(const Key& key, std::optional<Real>& value, const Quantity& quantity,
                            const char* word) = 0;
  /// A whole number, or `word` where there is none: heat_every: auto.
  virtual void integer_or_word(const Key& key, std::optional<int>& value, const Range& range,
                               const char* word) = 0;
  /// A word out of `words`; index into them. Words may have synonyms: "off|false". A word that
  /// begins with "!" is known and refused: "!conduct|heat is not conducted yet".
  virtual void choice(const Key& key, int& index, std::span<const char* const> words) = 0;
  template <class E>
  requires std::is_enum_v<E>
  void choice(const Key& key, E& value, std::span<const char* const> words) {
    int index = static_cast<int>(value);
    choice(key, index, words);
    value = static_cast<E>(index);
  }
  /// A list of quantities of one dimension. size: 0 any; components: 2 in a 2D deck and 3 in a 3D
  /// one where size is kVector; a component may be the word `free` (NaN) where allow_free.
  static constexpr int kVector = -1;
  virtual void list(const Key& key, std::vector<Real>& value, const Quantity& quantity, int size,
                    bool allow_free = false) = 0;
  virtual void list(const Key& key, std::optional<std::vector<Real>>& value,
                    const Quantity& quantity, int size, bool allow_free = false) = 0;
  /// A letter x, y, z or a vector; read as a unit vector. In 2D z is the axis out of the plane.
  virtual void direction(const Key& key, std::vector<Real>& value) = 0;
  /// One quantity for all axes, or one an axis: size: 1 mm or [1 mm, 1 mm, 2 mm].
  virtual void per_axis(const Key& key, std::optional<std::vector<Real>>& value,
                        const Quantity& quantity) = 0;
  /// Points of a polygon: a list of lists, or {unit: mm, value: [[...]]}.
  virtual void points(const Key& key, std::vector<std::vector<Real>>& value,
                      const Quantity& quantity) = 0;
  /// Whole numbers: corners, cells.
  virtual void integers(const Key& key, std::optional<std::vector<int>>& value, int size,
                        const Range& range) = 0;
  /// A list of words out of `words`: fix: [x, y]; order and doubles do not matter.
  virtual void words(const Key& key, std::vector<std::string>& value,
                     std::span<const char* const> words) = 0;
  /// A list of free words: between: [a, b].
  virtual void names(const Key& key, std::vector<std::string>& value, int size) = 0;
  virtual void varying(const Key& key, std::optional<Varying>& value, const Quantity& quantity,
                       std::span<const Varying::Over> over) = 0;
  /// A value that may vary, or a law with keys of its own in its place, distinguished by their
  /// keys: friction: {static: 0.3, kinetic: 0.2, decay: 2 s/m}. What is read takes the other's
  /// place.
  template <class Law>
  void varying_or_law(const Key& key, std::optional<Varying>& value, std::optional<Law>& law,
                      const Quantity& quantity, std::span<const Varying::Over> over) {
    visit_varying_or_law(
        key, value, quantity, over, [&] { return law.has_value(); },
        [&](bool is_law) {
          value.reset();
          law.reset();
          if (is_law) law.emplace();
        },
        [&](Schema& s) {
          Law blank{};
          describe(s, law ? *law : blank);
        });
  }
  /// A vector whose components may vary; an absent component is `free`.
  virtual void components(const Key& key, std::optional<std::vector<std::optional<Varying>>>& value,
                          const Quantity& quantity, std::span<const Varying::Over> over) = 0;

  template <class T>
  void object(const Key& key, T& value) {
    visit_object(
        key, [] { return true; }, [] {}, [&](Schema& s) { describe(s, value); });
  }
  template <class T>
  void object(const Key& key, std::optional<T>& value) {
    visit_object(
        key, [&] { return value.has_value(); }, [&] { value.emplace(); },
        [&](Schema& s) {
          T blank{};
          describe(s, value ? *value : blank);
        });
  }
  /// A map whose flags may stand as words, by themselves or in a list with maps of other keys:
  /// when: damage, or when: [damage, strain: 1.5].
  template <class T>
  void any_of(const Key& key, T& value) {
    visit_any_of(key, [&](Schema& s) { describe(s, value); });
  }
  /// Entries begin as copies of `initial`.
  template <class T>
  void named(const Key& key, std::vector<Named<T>>& entries, bool list_allowed = false,
             const T& initial = T{}) {
    visit_named(
        key, list_allowed, [&] { return entries.size(); },
        [&](std::size_t i) { return entries[i].name; },
        [&](const std::string& name) {
          entries.push_back({name, initial});
        },
        [&](std::size_t i, Schema& s) { describe(s, entries[i].value); },
        [&](Schema& s) {
          T blank = initial;
          describe(s, blank);
        });
  }
  /// One map, or a list of them: grading: {axis: z, ratio: 5}, or [{axis: x, ...}, {axis: z, ...}].
  template <class T>
  void one_or_more(const Key& key, std::vector<T>& entries) {
    visit_one_or_more(
        key, [&] { return entries.size(); }, [&] { entries.emplace_back(); },
        [&](std::size_t i, Schema& s) { describe(s, entries[i]); },
        [](Schema& s) {
          T blank{};
          describe(s, blank);
        });
  }
  /// A key with an empty name: the alternative stands among the keys of the map itself,
  /// shape: {box: {...}, translate: [...]}.
  template <class... Ts>
  void one_of(const Key& key, std::variant<Ts...>& value) {
    static constexpr Alternative alternatives[] = {alternative_of<Ts>()...};
    visit_one_of(
        key, alternatives, [&] { return value.index(); },
        [&](std::size_t index) {
          std::size_t i = 0;
          ((i++ == index ? void(value = Ts{}) : void()), ...);
        },
        [&](Schema& s) { std::visit([&](auto& v) { describe(s, v); }, value); },
        [](std::size_t index, Schema& s) {
          std::size_t i = 0;
          const auto blank = [&](auto alternative) {
            if (i++ == index) describe(s, alternative);
          };
          (blank(Ts{}), ...);
        });
  }
  /// The bare value of an alternative: hourglass: {viscous: 0.1}, side: min-x; a text is taken as
  /// it stands, without its parameters: expression: "= $a / $b".
  virtual void value(Real& value, const Quantity& quantity, const char* help) = 0;
  virtual void value(int& index, std::span<const char* const> words, const char* help) = 0;
  virtual void value(std::string& text, const char* help) = 0;
  template <class E>
  requires std::is_enum_v<E>
  void value(E& value, std::span<const char* const> words, const char* help) {
    int index = static_cast<int>(value);
    this->value(index, words, help);
    value = static_cast<E>(index);
  }
  /// Keys that mean something only where `applies`: elsewhere they are refused with `when`,
  /// as in "only with method: sph".
  virtual void section(bool applies, const char* when, std::function<void(Schema&)> members) = 0;
  /// A rule across keys, tested once they are read: message when it does not hold. `at` is the
  /// key to which the message points.
  virtual void require(bool holds, const char* at, const std::string& message) = 0;

 protected:
  using Members = std::function<void(Schema&)>;
  virtual void visit_object(const Key& key, std::function<bool()> present,
                            std::function<void()> create, Members members) = 0;
  virtual void visit_named(const Key& key, bool list_allowed, std::function<std::size_t()> size,
                           std::function<std::string(std::size_t)> name,
                           std::function<void(const std::string&)> add,
                           std::function<void(std::size_t, Schema&)> members, Members blank) = 0;
  virtual void visit_one_or_more(const Key& key, std::function<std::size_t()> size,
                                 std::function<void()> add,
                                 std::function<void(std::size_t, Schema&)> members,
                                 Members blank) = 0;
  virtual void visit_any_of(const Key& key, Members members) = 0;
  virtual void visit_one_of(const Key& key, std::span<const Alternative> alternatives,
                            std::function<std::size_t()> index,
                            std::function<void(std::size_t)> choose, Members members,
                            std::function<void(std::size_t, Schema&)> blank) = 0;
  /// choose(is_law) makes room for what is read.
  virtual void visit_varying_or_law(const Key& key, std::optional<Varying>& value,
                                    const Quantity& quantity, std::span<const Varying::Over> over,
                                    std::function<bool()> is_law, std::function<void(bool)> choose,
                                    Members members) = 0;
};

}  // namespace brunt
// Tested by tests/unit/app/deck_keys_test.cpp.
