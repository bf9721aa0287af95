// One mistake is reported once: a deck in which every part names others is broken at one place at a
// time, and nothing is reported that only depends on that place.
#include <gtest/gtest.h>

#include "app/deck/loader.hpp"
#include "app/setup/scene_builder.hpp"
#include "app/setup/sound_part.hpp"
#include "io/deck/sources.hpp"

namespace brunt {
namespace {

const std::string kDeck = R"yaml(parameters: {speed: 10 m/s, size: 1 mm, k: 50 W/m/K}
time: {end: 1 us}
heat: conduct
materials:
  steel:
    density: 7850
    elastic: {E: 200 GPa, nu: 0.3}
    strength: {j2: {yield: 300 MPa}}
    thermal: {cp: 460, k: $k}
  lead: {density: 11340, elastic: {E: 16 GPa, nu: 0.44}}
bodies:
  hammer:
    material: steel
    shape: {box: {min: [0, 0, 2 mm], max: [2 mm, 2 mm, 4 mm]}}
    size: $size
    velocity: [0, 0, -$speed]
  nail:
    material: steel
    shape: {box: {min: [0, 0, 0], max: [2 mm, 2 mm, 2 mm]}}
    size: $size
    velocity: [0, 0, "= $speed / 2"]
  block: {material: lead, size: $size, shape: {box: {min: [0, 0, -2 mm], max: [2 mm, 2 mm, 0]}}}
  inside: {material: lead, size: 1 mm, shape: {box: {min: [0, 0, -2 mm], max: [1 mm, 1 mm, 0]}}}
contact:
  default: {heat: perfect}
  pairs:
    stroke: {between: [hammer, nail], friction: 0.3}
    buried: {between: [block, inside], ignore: true}
boundaries:
  foot: {body: block, where: {side: min-z}, fix: [z]}
  warm: {body: nail, where: {side: max-x}, temperature: 400 K}
probes: {tip: {body: nail, at: [0, 0, 0], fields: [temperature]}}
sections: {neck: {body: nail, plane: {axis: z, at: 1 mm}}}
measures:
  force: {history: {column: contact.stroke.force.z, reduce: max}, reference: 1 kN}
  other: {history: {column: contact.nail-block.force.z, reduce: min}}
  hot: {history: {column: contact.stroke.temperature.max}}
  support: {history: {column: boundary.foot.reaction.z}}
  heating: {history: {column: boundary.warm.heat_rate}}
  neck: {history: {column: section.neck.force.z}}
  tip: {history: {column: probe.tip.temperature}}
  drift: {history: {column: heat.drift}}
  way: {history: {column: body.hammer.position.z}}
  length: {extent: {body: nail, axis: z}}
  warmest: {max: {body: nail, field: temperature}}
  ratio: {expression: "= $force / $other"}
)yaml";

std::vector<std::string> reported(const std::string& text) {
  std::vector<DeckProblem> problems;
  const LoadedDeck loaded = deck::DeckLoader().read(read_deck_source(text, "deck"), {}, problems);
  if (!problems.empty()) {
    add_build_problems(loaded, problems);
  } else {
    try {
      build_scene<3>(loaded);
    } catch (const DeckError& error) {
      problems = error.problems();
    }
  }
  sort_problems(problems);
  std::vector<std::string> texts;
  for (const auto& problem : problems) texts.push_back(problem.text());
  return texts;
}

struct Mistake {
  const char *right, *wrong;
  const char* reported;  ///< part of the one problem
};

const Mistake kMistakes[] = {
    // sections
    {"parameters:", "paramters:", "did you mean 'parameters'?"},
    {"parameters:", "values:", "unknown key 'values'"},
    {"time:", "duration:", "'time' is missing"},
    {"materials:", "stuff:", "unknown key 'stuff'"},
    {"bodies:", "bodys:", "unknown key 'bodys'"},
    {"contact:", "contct:", "did you mean 'contact'?"},
    {"boundaries:", "supports:", "unknown key 'supports'"},
    {"probes:", "gauges:", "unknown key 'gauges'"},
    {"sections:", "cuts:", "unknown key 'cuts'"},
    {"heat: conduct", "heat: condct", "did you mean 'conduct'?"},
    // parameters
    {"speed: 10 m/s", "sped: 10 m/s", "the parameter $speed is not declared"},
    {"speed: 10 m/s", "speed: fast", "$speed is not a number"},
    {"size: 1 mm,", "size: 1 kg,", "expects a length"},
    {"size: 1 mm,", "size: -1 mm,", "must be above 0"},
    {"size: 1 mm,", "size: = 1 mm +,", "parameters.size"},
    // entries
    {"  steel:", "  stel:", "there is no material 'steel'"},
    {"  lead: {", "  led: {", "there is no material 'lead'"},
    {"material: steel\n    shape: {box: {min: [0, 0, 2",
     "material: stel\n    shape: {box: {min: [0, 0, 2", "there is no material 'stel'"},
    {"density: 7850", "density: heavy", "materials.steel.density"},
    {"k: $k", "kk: $k", "unknown key 'kk'"},
    {"cp: 460", "capacity: 460", "'cp' is missing"},
    {"  nail:\n", "  nial:\n", "there is no body 'nail'"},
    {"  block: {", "  blok: {", "there is no body 'block'"},
    {"  nail:\n    material", "  nail:\n    form", "'material' is missing"},
    {"shape: {box: {min: [0, 0, 0]", "shape: {cube: {min: [0, 0, 0]", "unknown key 'cube'"},
    {"box: {min: [0, 0, 0]", "box: {low: [0, 0, 0]", "'min' is missing"},
    {"box: {min: [0, 0, 0]", "box: {min: [0, 0]", "expects a list of 3"},
    {"velocity: [0, 0, -$speed]", "velocity: [0, 0, -$speed m]", "bodies.hammer.velocity.2"},
    // contact
    {"default: {heat: perfect}", "default: {heat: perfct}", "did you mean 'perfect'?"},
    {"default: {heat: perfect}", "dflt: {heat: perfect}", "contact"},
    {"between: [hammer, nail]", "between: [hammer, nil]", "there is no body 'nil'"},
    {"between: [hammer, nail]", "betwen: [hammer, nail]", "did you mean 'between'?"},
    {"friction: 0.3", "friction: much", "contact.pairs.stroke.friction"},
    {"ignore: true", "ignore: maybe", "contact.pairs.buried.ignore"},
    // supports, probes, sections
    {"side: min-z", "side: bottom", "boundaries.foot.where.side"},
    {"fix: [z]", "fix: [w]", "boundaries.foot.fix"},
    {"foot: {body: block, where: {side: min-z}",
     "foot: {body: block, where: {plane: {axis: z, at: 9}}", "no point of 'block' lies there"},
    {"temperature: 400 K}", "temperature: 400 m}", "boundaries.warm.temperature"},
    {"at: [0, 0, 0], fields: [temperature]", "at: [0, 0, 0], fields: [temprature]",
     "'temprature' is not a number at a point; known are"},
    {"plane: {axis: z, at: 1 mm}", "plane: {axis: z, at: 1 m}", "does not cut 'nail'"},
    // measures
    {"force: {history:", "force: {history_of:", "unknown key 'history_of'"},
    {"force: {history:", "force: {peak:", "unknown key 'peak'"},
    {"force: {history: {column", "force: {history: {columm", "did you mean 'column'?"},
    {"contact.stroke.force.z", "contact.stroke.forse.z", "did you mean 'contact.stroke.force.z'?"},
    {"extent: {body: nail", "extent: {body: nil", "there is no body 'nil'"},
    {"field: temperature}", "field: temprature}", "known are displacement.x|y|z|magnitude"},
};

TEST(Consequences, OneMistakeIsToldOnce) {
  EXPECT_EQ(reported(kDeck), std::vector<std::string>{});
  for (const auto& [right, wrong, what] : kMistakes) {
    std::string text = kDeck;
    const auto at = text.find(right);
    ASSERT_NE(at, std::string::npos) << right;
    text.replace(at, std::string(right).size(), wrong);
    const auto found = reported(text);
    std::string all;
    for (const auto& one : found) all += one + "\n";
    EXPECT_EQ(found.size(), 1u) << wrong << "\n" << all;
    EXPECT_NE(all.find(what), std::string::npos) << wrong << "\n" << all;
  }
}

// Two mistakes that do not depend on each other are both reported, also where one is of a column.
TEST(Consequences, MistakesThatStandAloneAreAllTold) {
  std::string text = kDeck;
  const auto change = [&](const std::string& right, const std::string& wrong) {
    text.replace(text.find(right), right.size(), wrong);
  };
  change("density: 11340", "density: heavy");
  change("contact.stroke.force.z", "contact.stroke.forse.z");
  change("body.hammer.position.z", "body.hamer.position.z");
  EXPECT_EQ(reported(text).size(), 3u);
}

}  // namespace
}  // namespace brunt
