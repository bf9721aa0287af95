#include "app/trade/variants.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace brunt {

namespace {
DeckProblem vary_problem(std::size_t index, const std::string& path, const std::string& message) {
  return {{"--vary #" + std::to_string(index + 1), 0, 0}, path, message};
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Parts between separators that stand in no brackets and no quotes.
std::vector<std::string> split_outside(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{' || c == '(') {
      ++depth;
    } else if (c == ']' || c == '}' || c == ')') {
      --depth;
    }
    if (c == separator && depth == 0 && quote == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (auto& part : parts) part = trimmed(part);
  return parts;
}

/// The last `parts` parts of a key.
std::string tail_of(const std::string& key, int parts) {
  std::size_t dot = std::string::npos;
  for (int k = 0; k < parts; ++k) {
    dot = key.rfind('.', dot == std::string::npos ? dot : dot - 1);
    if (dot == std::string::npos || dot == 0) return key;
  }
  return key.substr(dot + 1);
}

/// The shortest ends of keys that tell them apart.
void set_labels(std::vector<Vary>& varies) {
  constexpr int kMostParts = 8;
  for (auto& vary : varies) {
    for (int parts = 1; parts <= kMostParts; ++parts) {
      vary.label = tail_of(vary.keys.front(), parts);
      const auto same = std::count_if(varies.begin(), varies.end(), [&](const Vary& other) {
        return tail_of(other.keys.front(), parts) == vary.label;
      });
      if (same == 1) break;
    }
  }
}

/// A name for a folder: blanks go, what a shell may take for its own becomes '_'.
std::string folder_of(const std::string& label) {
  std::string name;
  bool blank = false;
  for (const char c : label) {
    if (c == ' ') {
      blank = !name.empty();
      continue;
    }
    if (blank) name += '-';
    blank = false;
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' ||
                       c == '+' || c == '_' || (static_cast<unsigned char>(c) & 0x80) != 0;
    if (plain) {
      name += c;
    } else if (c != ',') {
      name += '_';
    }
  }
  return name.empty() || name.front() == '.' ? "variant" + name : name;
}

/// All combinations of a design, as choices.
std::vector<std::vector<int>> choices_of(const std::vector<Vary>& varies, Design design) {
  std::vector<std::vector<int>> all;
  if (design == Design::one_at_a_time) {
    all.emplace_back(varies.size(), -1);
    for (std::size_t k = 0; k < varies.size(); ++k) {
      for (std::size_t v = 0; v < varies[k].values.size(); ++v) {
        all.emplace_back(varies.size(), -1);
        all.back()[k] = static_cast<int>(v);
      }
    }
    return all;
  }
  all.emplace_back();
  for (const auto& vary : varies) {
    std::vector<std::vector<int>> longer;
    for (const auto& one : all) {
      for (std::size_t v = 0; v < vary.values.size(); ++v) {
        longer.push_back(one);
        longer.back().push_back(static_cast<int>(v));
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::string label_of_choices(const std::vector<Vary>& varies, const std::vector<int>& choices) {
  std::string label;
  for (std::size_t k = 0; k < varies.size(); ++k) {
    if (choices[k] < 0) continue;
    if (!label.empty()) label += ", ";
    label += varies[k].label + " " + varies[k].values[slot_of(choices[k])];
  }
  return label.empty() ? "as it stands" : label;
}

/// Size ratios along each axis of a body, where they differ.
void add_ratios(const deck::Body& body, const deck::Body& other, std::vector<Real>& ratios) {
  if (body.size && other.size && *body.size != *other.size) {
    for (std::size_t c = 0; c < std::min(body.size->size(), other.size->size()); ++c) {
      ratios.push_back((*body.size)[c] / (*other.size)[c]);
    }
  }
  if (!body.cells || !other.cells) return;
  for (std::size_t c = 0; c < std::min(body.cells->size(), other.cells->size()); ++c) {
    const Real own = (*body.cells)[c], its = (*other.cells)[c];
    if (own != its) ratios.push_back(its / own);
  }
}
}  // namespace

std::vector<Vary> read_varies(const std::vector<std::string>& texts) {
  std::vector<Vary> varies;
  std::vector<DeckProblem> problems;
  std::set<std::string> seen;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const auto equals = texts[k].find('=');
    if (equals == std::string::npos || equals == 0) {
      problems.push_back(vary_problem(k, texts[k], "expects KEY=VALUE,VALUE,..."));
      continue;
    }
    Vary vary;
    vary.keys = split_outside(texts[k].substr(0, equals), '+');
    vary.values = split_outside(texts[k].substr(equals + 1), ',');
    for (const auto& key : vary.keys) {
      if (!seen.insert(key).second) problems.push_back(vary_problem(k, key, "is varied twice"));
    }
    for (const auto& value : vary.values) {
      if (value.empty()) {
        problems.push_back(vary_problem(k, vary.keys.front(), "has an empty value"));
        break;
      }
    }
    varies.push_back(std::move(vary));
  }
  if (!problems.empty()) throw DeckError(std::move(problems));
  set_labels(varies);
  return varies;
}

std::vector<Variant> make_variants(const std::string& deck,
                                   const std::vector<std::string>& overrides,
                                   const std::vector<Vary>& varies, Design design) {
  std::vector<Variant> variants;
  std::vector<DeckProblem> problems;
  std::set<std::string> hashes, folders;
  for (const auto& choices : choices_of(varies, design)) {
    Variant variant;
    variant.choices = choices;
    variant.label = label_of_choices(varies, choices);
    variant.overrides = overrides;
    std::map<std::string, std::string> called;  // as the user gave it, by its place as an override
    for (std::size_t k = 0; k < varies.size(); ++k) {
      if (choices[k] < 0) continue;
      for (const auto& key : varies[k].keys) {
        variant.overrides.push_back(key + "=" + varies[k].values[slot_of(choices[k])]);
        called["--set #" + std::to_string(variant.overrides.size())] =
            "--vary #" + std::to_string(k + 1);
      }
    }
    std::vector<DeckProblem> found;
    variant.loaded = read_deck(deck, variant.overrides, found);
    for (auto& problem : found) {
      problem.message += " (" + variant.label + ")";
      const auto place = called.find(problem.place.file);
      if (place != called.end()) problem.place.file = place->second;
      problems.push_back(std::move(problem));
    }
    if (!found.empty() || !hashes.insert(variant.loaded.hash).second) continue;
    const std::string name = folder_of(variant.label);
    variant.folder = name;
    for (int n = 2; !folders.insert(variant.folder).second; ++n) {
      variant.folder = name + "_" + std::to_string(n);
    }
    variants.push_back(std::move(variant));
  }
  if (!problems.empty()) {
    sort_problems(problems);
    throw DeckError(std::move(problems));
  }
  return variants;
}

std::optional<Real> size_ratio(const Deck& deck, const Deck& other) {
  if (deck.bodies.size() != other.bodies.size()) return std::nullopt;
  std::vector<Real> ratios;
  for (std::size_t b = 0; b < deck.bodies.size(); ++b) {
    if (deck.bodies[b].value.rigid) continue;
    add_ratios(deck.bodies[b].value, other.bodies[b].value, ratios);
  }
  if (ratios.empty()) return std::nullopt;
  // Numbers of cells are whole: axes of one refinement differ by their rounding.
  constexpr Real kApart = 1.5;
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  if (*high > kApart * *low) return std::nullopt;
  Real sum = 0;
  for (const Real ratio : ratios) sum += std::log(ratio);
  return std::exp(sum / static_cast<Real>(ratios.size()));
}

std::vector<SizeSeries> size_series(const std::vector<Variant>& variants, std::size_t n_varies) {
  std::vector<SizeSeries> all;
  for (std::size_t k = 0; k < n_varies; ++k) {
    std::map<std::vector<int>, SizeSeries> groups;  // by the choices of the others
    for (std::size_t v = 0; v < variants.size(); ++v) {
      auto others = variants[v].choices;
      others[k] = 0;
      auto& series = groups[others];
      series.vary = k;
      if (series.variants.empty()) {
        series.variants.push_back(v), series.sizes.push_back(1);
        continue;
      }
      const Deck& first = variants[series.variants.front()].loaded.deck;
      const auto ratio = size_ratio(variants[v].loaded.deck, first);
      if (!ratio) continue;
      series.variants.push_back(v), series.sizes.push_back(*ratio);
    }
    for (auto& [others, series] : groups) {
      if (series.variants.size() > 1) all.push_back(std::move(series));
    }
  }
  return all;
}

}  // namespace brunt
