#include "app/deck/deck.hpp"

#include <algorithm>
#include <array>

#include "core/fields.hpp"

namespace brunt {

namespace deck {

void describe(Schema& s, MassScaling& scaling) {
  s.real({"step", "that elements are to allow, `safety` included", Need::required}, scaling.step,
         {"s", positive()});
  s.real({"max_added_mass", "part of a body's own mass beyond which the deck is refused"},
         scaling.max_added_mass, {"1", positive(), between(0, 0.5)});
}

void describe(Schema& s, Time& time) {
  s.real({"end", "time at which the run ends", Need::required}, time.end,
         {"s", positive(), between(1e-9, 1e3)});
  s.real({"safety", "fraction of the stable step that is used"}, time.safety,
         {"1", {0, 1, true, false}, between(0.1, 1)});
  s.real({"max_step", "no step is longer"}, time.max_step, {"s", positive()});
  s.real({"min_step",
          "a shorter step stops the run; default: a thousandth of the first that elements or "
          "particles bound"},
         time.min_step, {"s", positive()});
  s.object({"mass_scaling",
            "elements whose step would be shorter get mass for it, once, at time 0; none without"},
           time.mass_scaling);
  s.integer({"check_step",
             "measures at step 0 and at every N-th how much longer than its own step limit "
             "the stable step of each body is; below 1 it warns; costs some 600 steps each time; "
             "0: never"},
            time.check_step, at_least(0));
  s.integer_or_word(
      {"heat_every",
       "conduction is evaluated at every N-th step and acts as it was in between: what fades with "
       "a time constant tau fades too fast by the part N dt/(2 tau); 1: at every step; auto: as "
       "many steps as 1 % of the longest stable step of heat holds, 16 at the most"},
      time.heat_every, at_least(1), "auto");
  s.real({"max_drift", "energy drift over the largest energy at which the run stops"},
         time.max_drift, {"1", positive(), between(0, 1)});
  s.real({"max_created",
          "energy that nobody put in (integration, artificial stress, contact.pairs, ...) over the "
          "largest energy at which the run stops; at 0.01 it warns"},
         time.max_created, {"1", positive(), between(0, 1)});
  s.real(
      {"until", "stops here with a checkpoint, at the first step that gets there; no bit changes"},
      time.until, {"s", positive()});
  s.real(
      {"process_speed",
       "steps a process of little inertia, cutting or forming, so many times faster; the deck and "
       "all results are in real time"},
      time.process_speed, {"1", at_least(1), between(1, 1e4)});
}

void describe(Schema& s, ContactPair& pair) {
  s.names({"between",
           "two bodies; [a, a] is a with itself: its pieces, and the faces of one piece that fold "
           "onto each other; [a, any] is a with all others",
           Need::required},
          pair.between, 2);
  describe(s, pair.options);
}

void describe(Schema& s, Contact& contact) {
  static constexpr const char* kSearches[] = {"grid", "brute"};
  s.object({"default", "what holds for all pairs that say nothing else"}, contact.fallback);
  ContactPair initial;
  initial.options = contact.fallback;
  s.named({"pairs",
           "options of pairs of bodies, by a name of their own; in scenes of over 1000 pairs these "
           "alone have columns in history.csv"},
          contact.pairs, false, initial);
  s.choice({"search", "how pairs are found; the answer is the same"}, contact.search, kSearches);
  s.real_or_word({"skin", "how far lists reach beyond contact; the answer is the same"},
                 contact.skin, {"m", at_least(0)}, "auto");
}

void describe(Schema& s, AtRest& rest) {
  s.text({"body", "name of a body", Need::required}, rest.body);
  s.real({"below", "largest speed of its points", Need::required}, rest.below, {"m/s", positive()});
  s.real({"for", "for this long"}, rest.duration, {"s", at_least(0)});
}

void describe(Schema& s, Beyond& beyond) {
  s.text({"body", "name of a body", Need::required}, beyond.body);
  s.choice({"axis", "axis along which its centre moves", Need::required}, beyond.axis, s.axes());
  s.real({"at", "the place that its centre passes", Need::required}, beyond.at, {"m"});
}

void describe(Schema& s, Stop& stop) {
  s.object({"at_rest", "ends the run when a body has come to rest"}, stop.at_rest);
  s.object({"beyond", "ends the run when a body has passed a place"}, stop.beyond);
  s.text({"when",
          "ends the run at the first row of history.csv in which an expression over its columns "
          "[SI] holds: \"= body.ball.velocity.z > 0 && time > 1e-5\""},
         stop.when);
  s.require(stop.when.empty() || stop.when.front() == '=', "when",
            "expects an expression over history columns, which begins with '=': \"= "
            "body.ball.velocity.z > 0\"");
}

void describe(Schema& s, Output& output) {
  static constexpr auto kNames = [] {
    std::array<const char*, kFields.size() + 1> names{};
    std::transform(kFields.begin(), kFields.end(), names.begin(),
                   [](const FieldInfo& field) { return field.name; });
    names.back() = kOwnerField.name;
    return names;
  }();
  s.real({"every",
          "time between frames; default: an eightieth of the end, or a fortieth or twentieth where "
          "frames would take long"},
         output.every, {"s", positive()});
  s.real({"history",
          "time between rows of history.csv; default: the end over 2000, or so many steps that "
          "rows take little of the time"},
         output.history, {"s", positive()});
  s.flag({"state_hash",
          "a hash of the whole state in every row of history.csv, not in the first, in those of "
          "frames and in that of the end alone: it costs more than the rest of the row"},
         output.state_hash);
  s.real({"from", "frames only from this time, besides the first and the last"}, output.from,
         {"s", at_least(0)});
  s.real({"to", "frames only until this time, besides the first and the last"}, output.to,
         {"s", at_least(0)});
  s.words(
      {"fields",
       "fields in frames; default: all but rank. Several ranks add id, which joins their pieces"},
      output.fields, kNames);
  s.names({"bodies", "bodies in frames; default: all"}, output.bodies, 0);
  s.flag({"pictures", "writes pictures at the end"}, output.pictures);
  s.real_or_word(
      {"checkpoint", "wall time between checkpoints; off: only on a signal and at time.until"},
      output.checkpoint, {"s", positive()}, "off");
  s.integer({"checkpoint_steps", "steps between checkpoints besides; 0: none"},
            output.checkpoint_steps, at_least(0));
}

void describe(Schema& s, Symmetry& planes) {
  constexpr Quantity kPlane{"m", {}, between(-1e4, 1e4)};
  s.real({"x", "place of a plane of symmetry across x"}, planes.x, kPlane);
  s.real({"y", "across y"}, planes.y, kPlane);
  s.section(s.geometry() == Geometry::three_d, "only for geometry: 3d", [&](Schema& in3d) {
    in3d.real({"z", "across z"}, planes.z, kPlane);
  });
}

void describe(Schema& s, Ranks& ranks) {
  s.real_or_word({"balance",
                  "largest over mean work of the ranks beyond which points are partitioned "
                  "again, once that pays; 1: at every look; the answer is the same"},
                 ranks.balance, {"1", at_least(1)}, "off");
  s.integer({"balance_steps", "steps between two looks at the balance"}, ranks.balance_steps,
            at_least(1));
}

}  // namespace deck

void describe(Schema& s, Deck& deck) {
  static constexpr const char* kGeometries[] = {"3d", "plane-strain", "axisymmetric"};
  static constexpr const char* kHeats[] = {"auto", "off|false", "adiabatic", "conduct"};
  s.text({"title", "a line for the log and the report"}, deck.title);
  s.choice({"geometry", "three dimensions, or two in x and y; axisymmetric: x is the radius"},
           deck.geometry, kGeometries);
  s.section(deck.geometry != Geometry::three_d, "only for geometry: plane-strain or axisymmetric",
            [&](Schema& in2d) {
              in2d.real({"depth", "plane strain: forces, masses and energies are for this depth"},
                        deck.depth, {"m", positive(), between(1e-6, 100)});
            });
  s.object({"time", "how long and in which steps", Need::required}, deck.time);
  s.choice({"quality",
            "accuracy for cost in keys that a deck leaves out: contact.default.stiffness, "
            "element.integration and smoothing of bodies; docs/trade.md has what each costs"},
           deck.quality, deck::kQualities);
  s.choice({"heat",
            "conduct: in materials with thermal k; adiabatic: plastic work stays where it is done; "
            "auto: conduct in bodies with k that a boundary heats or cools, else adiabatic"},
           deck.heat, kHeats);
  s.real({"ambient", "temperature of all that says nothing else"}, deck.ambient,
         {"K", at_least(0), between(200, 2000)});
  s.named({"materials", "materials by name"}, deck.materials);
  s.named({"bodies", "bodies by name", Need::required}, deck.bodies, false,
          deck::body_of(deck.quality));
  s.object({"contact", "all bodies may touch all others"}, deck.contact);
  s.named({"boundaries", "supports and loads by name"}, deck.boundaries, true);
  s.object(
      {"symmetry",
       "planes of symmetry: nodes on them at time 0 move along them, particles see their images"},
      deck.symmetry);
  deck::describe_gravity(s, deck.gravity);
  s.object({"damping", "mass-proportional, to settle"}, deck.damping);
  s.named({"measures", "numbers that the run is asked for, by name"}, deck.measures);
  s.named({"probes", "fields of one point or element in history.csv, by name"}, deck.probes);
  s.named({"sections", "forces through planes of a body in history.csv, by name"}, deck.sections);
  s.object({"stop", "what ends the run before its time"}, deck.stop);
  s.object({"output", "what is written, and when"}, deck.output);
  s.object({"ranks", "how work is spread over several processes"}, deck.ranks);
  s.integer({"max_cells",
             "elements and particles that a deck may make; more of them are refused before they "
             "fill the memory"},
            deck.max_cells, at_least(1));
}

std::string body_of_part(const std::string& name) {
  const auto dot = name.find('.');
  return dot == 0 ? name : name.substr(0, dot);
}

std::optional<Label> label_of(const Deck& deck, const std::string& body) {
  for (Label label = 0; label < deck.bodies.size(); ++label) {
    if (deck.bodies[label].name == body) return label;
  }
  return std::nullopt;
}

Integration integration_of(const Deck& deck, const deck::Body& body) {
  const auto flows = [&](const Named<deck::Material>& material) {
    if (material.name != body.material) return false;
    return std::visit([](const auto& law) { return FlowLaw<std::decay_t<decltype(law)>>; },
                      material.value.strength);
  };
  return resolved(body.element, std::any_of(deck.materials.begin(), deck.materials.end(), flows));
}

void DeckPlaces::set(const std::string& path, SourcePlace place) {
  places_[path] = std::move(place);
}

SourcePlace DeckPlaces::place(const std::string& path) const {
  for (std::string key = path;; key.resize(key.rfind('.'))) {
    if (const auto found = places_.find(key); found != places_.end()) return found->second;
    if (key.rfind('.') == std::string::npos) break;
  }
  const auto root = places_.find("");
  return root == places_.end() ? SourcePlace{} : root->second;
}

DeckProblem DeckPlaces::problem(const std::string& path, const std::string& message) const {
  return {place(path), path, message};
}

const deck::Material* Deck::material_named(const std::string& name) const {
  for (const auto& material : materials) {
    if (material.name == name) return &material.value;
  }
  return nullptr;
}

}  // namespace brunt
