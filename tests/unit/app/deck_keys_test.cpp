// Wrong decks made from the schema: every key that a deck can have is misspelt, given a wrong
// dimension, put out of range, given a wrong type, and left out. Each must be reported at the line
// and the path of the key. The decks are two that hold every key, written one key a line by the
// echo.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "app/deck/deck.hpp"
#include "app/deck/loader.hpp"
#include "io/deck/key_tree.hpp"
#include "io/deck/number.hpp"

namespace brunt::deck {
namespace {

const char* const kFull = R"yaml(
title: all keys in 3D
time: {end: 1 ms, max_step: 1 us, min_step: 1 ps, heat_every: 4, until: 0.5 ms}
materials:
  jc:
    density: 8960
    elastic: {E: 124 GPa, nu: 0.34}
    strength: {johnson-cook: {A: 90 MPa, B: 292 MPa, n: 0.31, T_melt: 1356 K}}
    eos: {mie-gruneisen: {c0: 3940, s: 1.49, gamma0: 1.96}}
    tensile_cutoff: 1 GPa
    thermal: {cp: 383, k: 386}
  j2:
    {density: 2700, elastic: {K: 70 GPa, G: 26 GPa},
     strength: {j2: {yield: 300 MPa, hardening: {table: [[0, 0], [1, 1 MPa]], over: eps_p}}}}
  za:
    {density: 7870, elastic: {E: 207 GPa, nu: 0.29}, strength: {zerilli-armstrong:
      {C0: 9 MPa, C1: 1 GPa, C2: 1 MPa, C3: 0.007, C4: 4e-4, C5: 266 MPa, n: 0.3}}}
  dp:
    {density: 2000, elastic: {K: 1 GPa, G: 0.5 GPa}, strength: {drucker-prager:
      {cohesion: 1 MPa, friction_angle: 30 deg, dilation_angle: 9 deg}}}
  sg: {density: 8930, elastic: {K: 137 GPa, G: 47 GPa}, strength: {steinberg-guinan:
      {Y0: 120 MPa, Y_max: 640 MPa, beta: 36, n: 0.45, A: 28e-12, B: 3.8e-4}}}
bodies:
  a:
    material: jc
    shape: {box: {min: [0, 0, 0], max: [1, 1, 1]}, translate: [1, 1, 1]}
    size: 0.1
    grading: {axis: z, ratio: 5, toward: both}
    velocity: [1, 2, 3]
    spin: {axis: x, rate: 3 rad/s, about: [0, 0, 0]}
    temperature: 300
    element: {hourglass: {viscous: 0.1}}
  b:
    material: j2
    shape: {cylinder: {radius: 1, length: 2, base: [3, 3, 3], axis: z}}
    cells: [4, 4, 8]
    element: {hourglass: {stiffness: 0.05}}
  c:
    material: j2
    shape: {tube: {inner: 1, outer: 2, length: 2, base: [9, 3, 3], axis: x}}
    cells: [4, 4, 8]
    element: {hourglass: {assumed_strain: 1}}
  d:
    method: sph
    material: jc
    shape:
      sphere: {radius: 1, center: [5, 5, 5]}
      rotate: {axis: y, angle: 10 deg, about: [0, 0, 0]}
    size: 0.1
  e:
    rigid: true
    shape: {polygon: {points: [[0, 0], [1, 0], [0, 1]], thickness: 1}}
    motion:
      velocity: [0, 0, 1]
      spin: {axis: z, rate: 1 rpm, about: [0, 0, 0]}
      temperature: 300
  f: {rigid: true, shape: {plane: {origin: [0, 0, -9], normal: z, extent: 4}}}
  g:
    material: dp
    shape: {brick-wall: {bricks: [4, 1, 3], brick: [0.2, 0.1, 0.1], origin: [0, 20, 0]}}
    size: 0.05
  h:
    method: sph
    material: sg
    shape: {ogive: {radius: 1, length: 4, nose: 2, base: [0, -20, 0]}}
    size: 0.1
  j:
    rigid: true
    file: part.stl
    scale: 1 mm
    rotate: {axis: y, angle: 10 deg, about: [0, 0, 0]}
    translate: [30, 0, 0]
  i:
    material: za
    shape:
      polygon: {points: [[0, 0], [1, 0], [1, 1], [0, 1]], thickness: 1, corners: [0, 1, 2, 3]}
    size: 0.1
contact:
  default:
    friction: {static: 0.3, kinetic: 0.2, decay: 2 s/m}
    heat: {conductance: 1e4 W/m^2/K, gap: 1 mm}
    friction_heat: {fraction: 0.5, split: 0.3}
  pairs:
    ab:
      between: [a, b]
      friction: {table: [[0, 0.3], [1 m/s, 0.2]], over: slip_speed}
      heat: {conductance: 2e4 W/m^2/K}
    ac: {between: [a, c], friction: {static: 0.4, kinetic: 0.4, decay: 0}}
    ag: {between: [a, g], friction: "= 0.3 - v/1000 - T/1e5", shear_limit: true}
    ad: {between: [a, d], friction: 0.3, cohesion: 1 MPa, tension: 0.5 MPa, initial_overlap: press}
    dd: {between: [d, d], bonded: true, resting_layer: 5}
boundaries:
  all: {body: a, where: all, fix: [x]}
  surface: {body: a, where: surface, velocity: [0, free, "= t"], from: 1 us, to: 2 us}
  plane: {body: a, where: {plane: {axis: x, at: 1}}, force: [0, 0, 1]}
  box: {body: a, where: {box: {min: [0, 0, 0], max: [1, 1, 1]}}, fix: [x]}
  side: {body: a, where: {side: min-x}, fix: [x]}
  hot: {body: a, where: {side: max-x}, temperature: 400}
  warm: {body: a, where: {side: min-x}, flux: 1000, convection: {h: 10, T: 300},
         radiation: {emissivity: 0.8, T: 300}}
probes: {tip: {body: a, at: [0, 0, 0], fields: [temperature, stress.xx]}}
sections: {neck: {body: a, plane: {axis: x, at: 1.5}}}
gravity: [0, 0, -9.81]
damping: {rate: 100, until: 1 ms}
measures:
  m_extent: {extent: {body: a, axis: x}, reference: 1, at: 1 us}
  m_min: {min: {body: a, field: pressure}}
  m_max: {max: {body: a, field: stress.xx}}
  m_mean: {mean: {body: a, field: velocity.x}}
  m_point: {point: {body: a, field: temperature, at: [0, 0, 0]}}
  m_history: {history: {column: energy.total, from: 1 us, to: 2 us}}
  m_restitution: {restitution: {body: a}}
  m_expression: {expression: "= $m_min / $m_max"}
stop: {at_rest: {body: a, below: 1, for: 1 us}, beyond: {body: a, axis: z, at: 3}}
output: {every: 1 us, history: 1 us, from: 1 us, to: 2 us, fields: [stress], bodies: [a]}
)yaml";

const char* const kFlat = R"yaml(
geometry: plane-strain
depth: 10 mm
time: {end: 1 ms}
materials: {m: {density: 1000, elastic: {K: 1 GPa, G: 1 GPa}}}
bodies: {b: {material: m, cells: [4, 4], shape: {box: {min: [0, 0], max: [1, 1]}}}}
)yaml";

/// One line of an echoed deck: "  key: value".
struct Line {
  std::size_t indent = 0;
  std::string key, value, path;
  std::size_t end = 0;  ///< first line after what is nested below it
};

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> lines;
  std::istringstream stream(text);
  for (std::string row; std::getline(stream, row);) {
    Line line;
    line.indent = row.find_first_not_of(' ');
    const std::size_t colon = row.find(':');
    line.key = row.substr(line.indent, colon - line.indent);
    line.value = colon + 2 < row.size() ? row.substr(colon + 2) : "";
    line.path = line.key;
    for (std::size_t i = lines.size(); i-- > 0;) {
      if (lines[i].indent < line.indent) {
        line.path = lines[i].path + "." + line.key;
        break;
      }
    }
    lines.push_back(line);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::size_t end = i + 1;
    while (end < lines.size() && lines[end].indent > lines[i].indent) ++end;
    lines[i].end = end;
  }
  return lines;
}

class WrongDecks {
 public:
  explicit WrongDecks(const std::string& text, Geometry geometry)
      : root_(key_tree(geometry,
                       [](Schema& s) {
                         Deck blank;
                         describe(s, blank);
                       })),
        resolved_(loader_.load_text(text, "deck").resolved),
        lines_(lines_of(resolved_)) {}

  /// Breaks every key in every way; returns the number of wrong decks.
  int try_all() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const KeyInfo* key = find_key(root_, lines_[i].path);
      const KeyInfo* outer = find_key(root_, parent(i));
      if (!key && outer && outer->type == KeyInfo::Type::varying) continue;  // parts of a table
      if (!key) {
        ADD_FAILURE() << "no key at " << lines_[i].path;
        continue;
      }
      visit(*key);
      const bool entry = key->type == KeyInfo::Type::named && lines_[i].key != key->name;
      if (entry) continue;
      misspell(i);
      wrong_type(i, *key);
      if (has_unit(*key)) wrong_dimension(i, *key);
      if (has_range(*key)) out_of_range(i, *key);
      if (key->required) leave_out(i);
    }
    return count_;
  }

  /// Paths of keys that no line has.
  std::vector<std::string> not_visited() const {
    std::vector<std::string> paths;
    collect(root_, "", paths);
    return paths;
  }

 private:
  static bool has_unit(const KeyInfo& key) { return !value_key(key).unit.empty(); }
  static bool has_range(const KeyInfo& key) {
    const Range& range = value_key(key).range;
    return range.min > -kInfinity || range.max < kInfinity;
  }
  /// The bare value of an alternative stands for it.
  static const KeyInfo& value_key(const KeyInfo& key) {
    return key.children.size() == 1 && key.children[0].bare ? key.children[0] : key;
  }

  void visit(const KeyInfo& key) {
    visited_.insert(&key);
    if (&value_key(key) != &key) visited_.insert(&value_key(key));
    // A bare word such as `where: all` is the visit of an alternative without keys.
    for (const KeyInfo& child : key.children) {
      if (key.type == KeyInfo::Type::one_of && child.type == KeyInfo::Type::empty) {
        visited_.insert(&child);
      }
    }
  }

  void collect(const KeyInfo& key, const std::string& path, std::vector<std::string>& out) const {
    for (const KeyInfo& child : key.children) {
      const std::string child_path = path + "." + child.name;
      if (!child.in_line && !visited_.contains(&child)) out.push_back(child_path);
      collect(child, child_path, out);
    }
  }

  /// The deck with line i and what is below it replaced by `rows`.
  std::string with(std::size_t i, const std::string& rows) const {
    std::istringstream stream(resolved_);
    std::string out, row;
    for (std::size_t k = 0; std::getline(stream, row); ++k) {
      if (k == i) out += rows;
      if (k < i || k >= lines_[i].end) out += row + "\n";
    }
    return out;
  }

  std::string row(std::size_t i, const std::string& key, const std::string& value) const {
    return std::string(lines_[i].indent, ' ') + key + ": " + value + "\n";
  }

  /// Loads a wrong deck; there must be a problem at the line whose path begins with `path`.
  void expect(const std::string& text, std::size_t i, const std::string& path,
              const std::string& part, bool same_line = true) {
    ++count_;
    try {
      loader_.load_text(text, "deck");
      ADD_FAILURE() << "loaded, and should not: " << path << " " << part << "\n" << text;
    } catch (const DeckError& error) {
      const auto fits = [&](const DeckProblem& problem) {
        const bool line = !same_line || problem.place.line == static_cast<int>(i) + 1;
        return line && problem.path.starts_with(path) &&
               problem.message.find(part) != std::string::npos;
      };
      const auto& problems = error.problems();
      EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), fits))
          << "wanted line " << i + 1 << ", " << path << ", " << part << "; got\n"
          << error.what();
    }
  }

  std::string parent(std::size_t i) const {
    const std::size_t dot = lines_[i].path.rfind('.');
    return dot == std::string::npos ? "" : lines_[i].path.substr(0, dot);
  }

  void misspell(std::size_t i) {
    std::string rows = row(i, lines_[i].key + "q", lines_[i].value);
    const std::vector<Line>& lines = lines_;
    for (std::size_t k = i + 1; k < lines[i].end; ++k) rows += row(k, lines[k].key, lines[k].value);
    expect(with(i, rows), i, parent(i), "unknown key '" + lines_[i].key + "q'");
  }

  void wrong_type(std::size_t i, const KeyInfo& key) {
    using Type = KeyInfo::Type;
    const bool is_map =
        key.type == Type::map || key.type == Type::named || key.type == Type::one_of;
    const bool bare = &value_key(key) != &key;
    expect(with(i, row(i, lines_[i].key, is_map && !bare ? "17" : "{a: b}")), i, lines_[i].path,
           "");
  }

  void wrong_dimension(std::size_t i, const KeyInfo& key) {
    expect(with(i, row(i, lines_[i].key, value_text(key, lines_[i].value, "3 cd"))), i,
           lines_[i].path, "expects");
  }

  void out_of_range(std::size_t i, const KeyInfo& key) {
    const Range& range = value_key(key).range;
    const Real wrong = range.min > -kInfinity ? range.min - 1 : range.max + 1;
    expect(with(i, row(i, lines_[i].key, value_text(key, lines_[i].value, shortest_text(wrong)))),
           i, lines_[i].path, "must be");
  }

  void leave_out(std::size_t i) {
    const bool alone = lines_[i].end - i + 1 == lines_.size();
    ASSERT_FALSE(alone);
    expect(with(i, ""), i, parent(i), "", false);
  }

  /// A list of as many components as before, or a number.
  static std::string value_text(const KeyInfo& key, const std::string& before,
                                const std::string& number) {
    using Type = KeyInfo::Type;
    if (key.type == Type::points) {
      return "[[" + number + ", " + number + "], [0, 0], [1, 1]]";
    }
    if (before.empty() || before.front() != '[') return number;
    std::string list;
    const auto count = 1 + std::count(before.begin(), before.end(), ',');
    for (long n = 0; n < count; ++n) list += (n ? ", " : "") + number;
    return "[" + list + "]";
  }

  DeckLoader loader_;
  KeyInfo root_;
  std::string resolved_;
  std::vector<Line> lines_;
  std::set<const KeyInfo*> visited_;
  int count_ = 0;
};

TEST(DeckKeys, EveryWrongKeyIsToldAtItsPlace) {
  WrongDecks decks(kFull, Geometry::three_d);
  EXPECT_GT(decks.try_all(), 600);
  // `depth` is a key of two dimensions.
  EXPECT_EQ(decks.not_visited(), std::vector<std::string>{".depth"});
}

TEST(DeckKeys, InTwoDimensionsToo) {
  WrongDecks decks(kFlat, Geometry::plane_strain);
  EXPECT_GT(decks.try_all(), 40);
}

TEST(DeckKeys, MutatedDecksEndWithAMessageOrADeck) {
  // A fixed generator changes, drops, doubles and swaps bytes of the full deck.
  const DeckLoader loader;
  unsigned state = 12345;
  const auto next = [&](std::size_t n) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % n;
  };
  const std::string alphabet = "{}[]:,-.$=#'\"& \n0123456789eabcxyz/%^*()|";
  int refused = 0;
  constexpr int kDecks = 1500;
  for (int i = 0; i < kDecks; ++i) {
    std::string text = i % 2 ? kFull : kFlat;
    const std::size_t changes = 1 + next(4);
    for (std::size_t k = 0; k < changes; ++k) {
      const std::size_t at = next(text.size());
      switch (next(4)) {
        case 0:
          text[at] = alphabet[next(alphabet.size())];
          break;
        case 1:
          text.erase(at, 1 + next(6));
          break;
        case 2:
          text.insert(at, text.substr(next(text.size()), next(12)));
          break;
        default:
          text.insert(at, 1, alphabet[next(alphabet.size())]);
      }
    }
    try {
      const LoadedDeck loaded = loader.load_text(text, "deck");
      EXPECT_EQ(loader.load_text(loaded.resolved, "echo").resolved, loaded.resolved) << text;
    } catch (const DeckError& error) {
      ++refused;
      for (const DeckProblem& problem : error.problems()) {
        EXPECT_FALSE(problem.message.empty());
        EXPECT_FALSE(problem.place.file.empty()) << problem.text();
      }
    }
  }
  EXPECT_GT(refused, kDecks / 2);
  EXPECT_LT(refused, kDecks);
}

}  // namespace
}  // namespace brunt::deck
