#include "app/deck/process_speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace brunt::deck {

int time_power(std::string_view unit) {
  static constexpr std::array<std::string_view, 10> kOthers{"1",  "m", "kg",  "N",   "J",
                                                            "Pa", "K", "rad", "any", ""};
  int power = 0, sign = 1;
  while (true) {
    const auto end = unit.find_first_of(" /");
    const std::string_view factor = unit.substr(0, end);
    const auto hat = factor.find('^');
    const int exponent = hat == std::string_view::npos ? 1 : factor[hat + 1] - '0';
    const std::string_view symbol = factor.substr(0, hat);
    if (symbol == "s") {
      power += sign * exponent;
    } else if (symbol == "W") {
      power -= sign * exponent;
    } else if (std::find(kOthers.begin(), kOthers.end(), symbol) == kOthers.end()) {
      throw std::logic_error("the power of time in '" + std::string(symbol) + "' is not known");
    }
    if (end == std::string_view::npos) return power;
    sign = unit[end] == '/' ? -1 : 1;
    unit.remove_prefix(end + 1);
  }
}

namespace {
/// Visits a deck and makes of each value in real time that of the deck that is stepped.
class FasterDeck final : public Schema {
 public:
  FasterDeck(Geometry geometry, Real speed) : geometry_(geometry), speed_(speed) {}

  Geometry geometry() const override { return geometry_; }
  void real(const Key&, Real& value, const Quantity& of) override { scale(value, of); }
  void real(const Key&, std::optional<Real>& value, const Quantity& of) override {
    if (value) scale(*value, of);
  }
  void real_or_word(const Key&, std::optional<Real>& value, const Quantity& of,
                    const char*) override {
    if (value) scale(*value, of);
  }
  void list(const Key&, std::vector<Real>& value, const Quantity& of, int, bool) override {
    for (Real& one : value) scale(one, of);
  }
  void list(const Key&, std::optional<std::vector<Real>>& value, const Quantity& of, int,
            bool) override {
    if (!value) return;
    for (Real& one : *value) scale(one, of);
  }
  void per_axis(const Key& key, std::optional<std::vector<Real>>& value,
                const Quantity& of) override {
    list(key, value, of, 0, false);
  }
  void points(const Key&, std::vector<std::vector<Real>>& value, const Quantity& of) override {
    for (auto& point : value) {
      for (Real& one : point) scale(one, of);
    }
  }
  void varying(const Key&, std::optional<Varying>& value, const Quantity& of,
               std::span<const Varying::Over>) override {
    if (value) scale(*value, of);
  }
  void components(const Key&, std::optional<std::vector<std::optional<Varying>>>& value,
                  const Quantity& of, std::span<const Varying::Over>) override {
    if (!value) return;
    for (auto& component : *value) {
      if (component) scale(*component, of);
    }
  }
  void value(Real& value, const Quantity& of, const char*) override { scale(value, of); }
  void section(bool applies, const char*, std::function<void(Schema&)> members) override {
    if (applies) members(*this);
  }

  // What has no time in it.
  void integer(const Key&, int&, const Range&) override {}
  void integer_or_word(const Key&, std::optional<int>&, const Range&, const char*) override {}
  void flag(const Key&, bool&) override {}
  void text(const Key&, std::string&) override {}
  void choice(const Key&, int&, std::span<const char* const>) override {}
  void direction(const Key&, std::vector<Real>&) override {}
  void integers(const Key&, std::optional<std::vector<int>>&, int, const Range&) override {}
  void words(const Key&, std::vector<std::string>&, std::span<const char* const>) override {}
  void names(const Key&, std::vector<std::string>&, int) override {}
  void value(int&, std::span<const char* const>, const char*) override {}
  void value(std::string&, const char*) override {}
  void require(bool, const char*, const std::string&) override {}

 protected:
  void visit_object(const Key&, std::function<bool()> present, std::function<void()>,
                    Members members) override {
    if (present()) members(*this);
  }
  void visit_named(const Key&, bool, std::function<std::size_t()> size,
                   std::function<std::string(std::size_t)>, std::function<void(const std::string&)>,
                   std::function<void(std::size_t, Schema&)> members, Members) override {
    for (std::size_t i = 0; i < size(); ++i) members(i, *this);
  }
  void visit_one_or_more(const Key&, std::function<std::size_t()> size, std::function<void()>,
                         std::function<void(std::size_t, Schema&)> members, Members) override {
    for (std::size_t i = 0; i < size(); ++i) members(i, *this);
  }
  void visit_any_of(const Key&, Members members) override { members(*this); }
  void visit_one_of(const Key&, std::span<const Alternative>, std::function<std::size_t()>,
                    std::function<void(std::size_t)>, Members members,
                    std::function<void(std::size_t, Schema&)>) override {
    members(*this);
  }
  void visit_varying_or_law(const Key& key, std::optional<Varying>& value, const Quantity& of,
                            std::span<const Varying::Over> over, std::function<bool()> is_law,
                            std::function<void(bool)>, Members members) override {
    is_law() ? members(*this) : varying(key, value, of, over);
  }

 private:
  /// What a real value of this power of time is multiplied by.
  Real factor(int power) const { return std::pow(speed_, -power); }
  void scale(Real& value, const Quantity& of) const {
    const int power = time_power(of.unit);
    if (power != 0) value = power > 0 ? value / factor(-power) : value * factor(power);
  }
  void scale(Varying& varying, const Quantity& of) const;

  Geometry geometry_;
  Real speed_;
};

void FasterDeck::scale(Varying& varying, const Quantity& of) const {
  scale(varying.constant, of);
  for (Real& one : varying.ordinate) scale(one, of);
  const bool over_time = varying.over == Varying::Over::time;
  const bool over_speed = varying.over == Varying::Over::slip_speed;
  for (Real& one : varying.abscissa) {
    if (over_time) one /= speed_;
    if (over_speed) one *= speed_;
  }
  if (!varying.is_expression()) return;
  const bool sliding = varying.over == Varying::Over::sliding;
  varying.evaluate = [evaluate = varying.evaluate, speed = speed_, sliding,
                      values = factor(time_power(of.unit))](std::array<Real, 4> at) {
    sliding ? at[3] /= speed : at[0] *= speed;  // v of T, yield, p, v; t of t, x, y, z
    return values * evaluate(at);
  };
}

/// Lets a model change what has time in it, and no unit that says so.
template <class Model>
void speed_up(Model& model, Real speed) {
  if constexpr (requires { model.speed_up(speed); }) model.speed_up(speed);
}

/// Results are real: of measures, only `at` is a time of the run. `from` and `to` are rounded as
/// the times of rows are.
void keep_measures(const std::vector<Named<Measure>>& given, Real speed,
                   std::vector<Named<Measure>>& measures) {
  measures = given;
  for (auto& [name, measure] : measures) {
    if (measure.at) *measure.at /= speed;
    auto* history = std::get_if<HistoryMeasure>(&measure.kind);
    if (history == nullptr) continue;
    for (auto* time : {&history->from, &history->to}) {
      if (*time) **time = **time / speed * speed;
    }
  }
}
}  // namespace

Deck stepped_deck(const Deck& given) {
  const Real speed = given.time.process_speed;
  Deck deck = given;
  if (!(speed > 1)) return deck;  // of half a deck it may be anything
  FasterDeck visitor(given.geometry, speed);
  describe(visitor, deck);
  deck.gravity = given.gravity;  // its own values, sooner
  visitor.components({"gravity", ""}, deck.gravity, {"1"}, {});
  deck.output.checkpoint = given.output.checkpoint;  // wall time
  for (std::size_t m = 0; m < deck.materials.size(); ++m) {
    deck.materials[m].value.eos = given.materials[m].value.eos;  // sound speeds are stiffness
    std::visit([&](auto& law) { speed_up(law, speed); }, deck.materials[m].value.strength);
    std::visit([&](auto& law) { speed_up(law, speed); }, deck.materials[m].value.damage);
  }
  for (auto& [name, boundary] : deck.boundaries) {
    std::apply([&](auto&... kind) { (speed_up(kind, speed), ...); }, boundary.kinds);
  }
  keep_measures(given.measures, speed, deck.measures);
  return deck;
}

}  // namespace brunt::deck
// Tested by tests/unit/app/process_speed_test.cpp.
