#include "io/deck/parameters.hpp"

#include <algorithm>
#include <set>

#include "io/deck/number.hpp"
#include "io/deck/sources.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

namespace {

bool is_name(const std::string& text) {
  if (text.empty() || (text[0] >= '0' && text[0] <= '9')) return false;
  return names_in("$" + text) == std::vector<std::string>{text};
}

/// "139 m/s" in SI: what `-$speed` and derived parameters stand for.
std::string quantity_text(const ParameterValue& value) {
  const std::string number = shortest_text(value.value);
  return value.has_unit ? number + " " + value.dimension.unit() : number;
}

class Resolver {
 public:
  Resolver(const Units& units, const FormulaNames& formula_names,
           std::vector<DeckProblem>& problems)
      : units_(units), formula_names_(formula_names), problems_(problems) {}

  void declare(const Node& map) {
    for (const Entry& entry : map.entries) {
      const std::string path = "parameters." + entry.key;
      if (!is_name(entry.key)) {
        problems_.push_back({entry.place, path,
                             "a parameter's name has letters, digits and _, and no digit first"});
      } else if (entry.value.is_null()) {
        problems_.push_back({entry.place, path, "has no value"});
      } else {
        const std::string text = entry.value.is_scalar() ? entry.value.text : to_yaml(entry.value);
        Parameter parameter;
        parameter.name = entry.key;
        parameter.text = text;
        parameter.place = entry.place;
        parameter.node = entry.value;
        index_.emplace(entry.key, declared_.size());
        declared_.push_back({std::move(parameter), State::waiting});
      }
    }
    for (std::size_t i = 0; i < declared_.size(); ++i) resolve(i);
    all_resolved_ = true;
  }

  void substitute(Node& node, const std::string& path) {
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      substitute(node.items[i], join_path(path, std::to_string(i)));
    }
    for (Entry& entry : node.entries) substitute(entry.value, join_path(path, entry.key));
    if (!node.is_scalar() || node.text.find('$') == std::string::npos) return;
    if (const auto* own = formula_names_(path)) {
      substitute_formula(node, *own);
    } else {
      substitute_scalar(node, path);
    }
  }

  std::vector<Parameter> finish() {
    std::vector<Parameter> parameters;
    for (Declared& declared : declared_) {
      // One that nothing uses may be the one that is missed.
      if (!used_.contains(declared.parameter.name) && undeclared_.empty()) {
        problems_.push_back({declared.parameter.place, "parameters." + declared.parameter.name,
                             "is not used; write $" + declared.parameter.name +
                                 " where it belongs, or take it out"});
      }
      parameters.push_back(std::move(declared.parameter));
    }
    for (auto& [name, uses] : undeclared_) {
      if (uses.size() > 1) {
        problems_[warned_[name]].message +=
            "; it is used " + std::to_string(uses.size()) + " times";
      }
      Parameter parameter;
      parameter.name = name;
      parameter.place = uses.front();
      parameter.failed = true;
      parameter.declared = false;
      parameter.used_at = std::move(uses);
      parameters.push_back(std::move(parameter));
    }
    return parameters;
  }

 private:
  /// own  names that are no parameters here
  void substitute_formula(Node& node, const std::set<std::string>& own) {
    ParameterValues numbers;
    for (const std::string& name : names_in(node.text)) {
      const Declared* declared = find(name);
      if (declared == nullptr) continue;
      used_.insert(name);
      if (declared->parameter.value && !own.contains(name)) {
        numbers[name] = *declared->parameter.value;
      }
    }
    if (numbers.empty()) return;
    node.written = node.text;
    node.text = with_numbers(node.text, numbers);
  }

  enum class State { waiting, busy, done };
  struct Declared {
    Parameter parameter;
    State state;
  };

  Declared* find(const std::string& name) {
    const auto found = index_.find(name);
    return found == index_.end() ? nullptr : &declared_[found->second];
  }

  /// The parameter, or null with a problem at `place`.
  Declared* use(const std::string& name, const SourcePlace& place, const std::string& path) {
    Declared* declared = find(name);
    if (!declared) {
      if (name.empty()) {
        problems_.push_back(
            {place, path,
             "'$' is followed by a name without braces, as in $speed; '$$' is a dollar"});
        return nullptr;
      }
      auto& uses = undeclared_[name];
      uses.push_back(place);
      if (uses.size() > 1) return nullptr;
      std::vector<std::string> known;
      for (const Declared& other : declared_) known.push_back(other.parameter.name);
      warned_[name] = problems_.size();
      problems_.push_back(
          {place, path, "the parameter $" + name + " is not declared" + suggestion(name, known)});
      return nullptr;
    }
    used_.insert(name);
    if (all_resolved_) declared->parameter.used_at.push_back(place);
    return declared;
  }

  /// Gives a parameter its node and value, after those that it is made of. Without recursion: a
  /// chain may be as long as a deck.
  void resolve(std::size_t first) {
    if (declared_[first].state != State::waiting) return;
    std::vector<std::vector<std::string>> needs;  // of each that is open, the next one last
    const auto begin = [&](std::size_t i) {
      declared_[i].state = State::busy;
      open_.push_back(i);
      const Node& node = declared_[i].parameter.node;
      auto names = node.is_scalar() ? names_in(node.text) : std::vector<std::string>{};
      std::reverse(names.begin(), names.end());
      needs.push_back(std::move(names));
    };
    begin(first);
    while (!open_.empty()) {
      const std::size_t i = open_.back();
      if (needs.back().empty()) {
        finish_one(declared_[i].parameter);
        declared_[i].state = State::done;
        open_.pop_back();
        needs.pop_back();
        continue;
      }
      Declared* other = find(needs.back().back());
      if (other != nullptr && other->state == State::waiting) {
        begin(slot_of(other - declared_.data()));
        continue;
      }
      needs.back().pop_back();
      if (other == nullptr) continue;
      used_.insert(other->parameter.name);
      if (other->state == State::busy) {
        refuse_circle(slot_of(other - declared_.data()));
      }
      // What is wrong with the other one is reported there.
      if (other->parameter.failed) declared_[i].parameter.failed = true;
    }
  }

  /// The node and value of a parameter, those that it is made of being known.
  void finish_one(Parameter& parameter) {
    if (parameter.failed) return;
    const std::string path = "parameters." + parameter.name;
    const std::size_t before = problems_.size();
    substitute(parameter.node, path);
    if (parameter.node.is_scalar()) evaluate(parameter, path);
    parameter.failed = problems_.size() > before;
  }

  /// The parameters that are open from `first` on are made of each other.
  void refuse_circle(std::size_t first) {
    const auto from = std::find(open_.begin(), open_.end(), first);
    std::string circle;
    for (auto i = from; i != open_.end(); ++i) {
      declared_[*i].parameter.failed = true;
      circle += "$" + declared_[*i].parameter.name + " needs ";
    }
    const Parameter& parameter = declared_[first].parameter;
    problems_.push_back(
        {parameter.node.place, "parameters." + parameter.name,
         "depends on itself: " + circle + "$" + parameter.name + "; give one of them a value"});
  }

  void evaluate(Parameter& parameter, const std::string& path) {
    Node& node = parameter.node;
    if (!is_expression(node.text)) {
      const QuantityValue quantity = units_.read(node.text);
      if (quantity.problem.empty()) {
        parameter.value = ParameterValue{quantity.value, quantity.dimension, quantity.has_unit};
      }
      return;
    }
    if (depends_on(node.text, kTimeAndPlace)) {
      problems_.push_back({node.place, path, "a parameter cannot depend on t, x, y or z"});
      return;
    }
    const std::vector<std::string> names = names_in(node.text);
    const auto undeclared = [&](const std::string& name) { return !find(name); };
    if (std::any_of(names.begin(), names.end(), undeclared)) return;
    const ExpressionResult result = evaluate_expression(node.text, values(names));
    if (!result.problem.empty()) {
      problems_.push_back({node.place, path, result.problem});
      return;
    }
    parameter.value = ParameterValue{result.value, result.dimension,
                                     !result.bare && !result.dimension.is_number()};
    node.written = node.text;
    node.text = quantity_text(*parameter.value);
  }

  ParameterValues values(const std::vector<std::string>& names) {
    ParameterValues known;
    for (const std::string& name : names) {
      const Declared* declared = find(name);
      if (declared != nullptr && declared->parameter.value)
        known[name] = *declared->parameter.value;
    }
    return known;
  }

  void substitute_scalar(Node& node, const std::string& path) {
    const std::string text = node.text;
    if (text.size() > kLongestText) {
      problems_.push_back({node.place, path, "is too long for a text with parameters in it"});
      return;
    }
    const std::vector<std::string> names = names_in(text);
    std::vector<const Declared*> used;
    used.reserve(names.size());
    for (const std::string& name : names) used.push_back(use(name, node.place, path));
    if (is_expression(text)) return;
    if (std::find(used.begin(), used.end(), nullptr) != used.end()) return;
    if (names.size() == 1 && text == "$" + names[0]) {
      replace_whole(node, used[0]->parameter.node, path);
    } else if (names.size() == 1 && text == "-$" + names[0]) {
      negate(node, used[0]->parameter, path);
    } else {
      put_into_text(node, path);
    }
  }

  void replace_whole(Node& node, const Node& value, const std::string& path) {
    n_nodes_ += count_nodes(value);
    if (n_nodes_ > kMaxNodes) {
      problems_.push_back({node.place, path, "parameters make the deck too large"});
      return;
    }
    const SourcePlace place = node.place;
    const std::string written = node.text;
    node = value;
    node.place = place;
    if (node.is_scalar()) node.written = written + " = " + value.text;
  }

  void negate(Node& node, const Parameter& parameter, const std::string& path) {
    if (parameter.failed) return;  // reported already
    if (!parameter.value) {
      problems_.push_back({node.place, path,
                           "$" + parameter.name +
                               " is not a number, and has no "
                               "negative"});
      return;
    }
    ParameterValue negative = *parameter.value;
    negative.value = 0 - negative.value;
    node.written = node.text + " = " + quantity_text(negative);
    node.text = quantity_text(negative);
  }

  /// Puts the texts of parameters into a text; `$$` becomes a dollar.
  void put_into_text(Node& node, const std::string& path) {
    const std::string& text = node.text;
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
      if (text[i] != '$') {
        result += text[i++];
      } else if (i + 1 < text.size() && text[i + 1] == '$') {
        result += '$';
        i += 2;
      } else {
        const std::string name = names_in(text.substr(i)).front();
        const Node& value = find(name)->parameter.node;
        result += value.is_scalar() ? value.text : to_yaml(value);
        i += 1 + name.size();
      }
      if (result.size() > kLongestText) {
        problems_.push_back({node.place, path, "parameters make the text too long"});
        return;
      }
    }
    node.pieced = true;
    node.written = text;
    node.text = result;
  }

  const Units& units_;
  const FormulaNames& formula_names_;
  std::vector<DeckProblem>& problems_;
  std::vector<Declared> declared_;
  std::map<std::string, std::size_t> index_;  ///< of a name in declared_
  std::set<std::string> used_;
  std::map<std::string, std::vector<SourcePlace>> undeclared_;  ///< where each is used
  std::map<std::string, std::size_t> warned_;  ///< the problem of each that is undeclared
  std::vector<std::size_t> open_;              ///< that are being resolved, outermost first
  bool all_resolved_ = false;
  static constexpr std::size_t kMaxNodes = 1'000'000, kLongestText = 10'000;
  std::size_t n_nodes_ = 0;  ///< that parameters have put in
};

}  // namespace

std::vector<Parameter> resolve_parameters(Node& root, const Units& units,
                                          const FormulaNames& formula_names,
                                          std::vector<DeckProblem>& problems) {
  Resolver resolver(units, formula_names, problems);
  if (const Node* map = root.find("parameters")) {
    if (map->is_map()) {
      resolver.declare(*map);
    } else {
      problems.push_back(
          {map->place, "parameters", "expects a map: {speed: 139 m/s}, got " + what_stands(*map)});
    }
  }
  root.erase("parameters");
  resolver.substitute(root, "");
  return resolver.finish();
}

ParameterValues values_of(const std::vector<Parameter>& parameters) {
  ParameterValues values;
  for (const Parameter& parameter : parameters) {
    if (parameter.value) values[parameter.name] = *parameter.value;
  }
  return values;
}

}  // namespace brunt
