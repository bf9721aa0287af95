#pragma once
/// The deck as a typed struct: what the rest of the program sees. SI, defaults in the initialisers,
/// nothing of YAML. describe() of each struct stands in the .cpp of the same subject.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/deck/bodies.hpp"
#include "app/deck/boundaries.hpp"
#include "app/deck/gravity.hpp"
#include "app/deck/materials.hpp"
#include "app/deck/measures.hpp"
#include "app/deck/probes.hpp"
#include "app/deck/quality.hpp"
#include "contact/law/options.hpp"
#include "core/errors.hpp"
#include "core/schema.hpp"

namespace brunt {

namespace deck {

/// Elements whose stable step would be shorter get mass for it at time 0.
struct MassScaling {
  Real step = 0;               ///< [s] that they are to allow, `safety` included
  Real max_added_mass = 0.05;  ///< [1] of a body's mass
};

struct Time {
  Real end = 0;                  ///< [s]
  Real safety = 0.9;             ///< fraction of the stable step
  std::optional<Real> max_step;  ///< [s]
  std::optional<Real> min_step;  ///< [s] a smaller step stops the run
  std::optional<MassScaling> mass_scaling;
  int check_step = 0;             ///< steps between two checks of the step limits; 0: never
  std::optional<int> heat_every;  ///< steps between two evaluations of conduction; none: auto
  Real max_drift = 0.05;          ///< energy drift over the largest energy at which the run stops
  Real max_created = 0.05;    ///< energy that nobody put in, over the largest, at which it stops
  std::optional<Real> until;  ///< [s] stops, with a checkpoint, at the first step that gets there
  Real process_speed = 1;     ///< seconds of the process in a second that is stepped
  /// A time of the process [s], of one of the deck that is stepped.
  Real real(Real stepped) const { return process_speed * stepped; }
};

enum class Heat : int { automatic, off, adiabatic, conduct };

/// A pair of bodies; its options already hold what `default` says where the pair is silent.
struct ContactPair {
  std::vector<std::string> between;  ///< two names of bodies; the second may be "any"
  PairOptions options;
};

struct Contact {
  PairOptions fallback;  ///< `default`
  std::vector<Named<ContactPair>> pairs;
  SearchMode search = SearchMode::grid;
  std::optional<Real> skin;  ///< [m]; none: auto
};

struct AtRest {
  std::string body;
  Real below = 0;     ///< [m/s] largest speed of a point of the body
  Real duration = 0;  ///< [s] key `for`
};
struct Beyond {
  std::string body;
  Axis axis = Axis::x;
  Real at = 0;  ///< [m] the body's centre passes this place
};
struct Stop {
  std::optional<AtRest> at_rest;
  std::optional<Beyond> beyond;
  std::string when;  ///< an expression over history columns [SI], with "="; empty: none
};

/// Planes that cut bodies in halves, of which one is there: nodes on them at time 0 move along
/// them, particles see their images beyond them.
struct Symmetry {
  std::optional<Real> x, y, z;  ///< [m] place of the plane across this axis
  const std::optional<Real>& across(int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

struct Output {
  std::optional<Real> every;        ///< [s] between frames; none: 20 to 80 frames
  std::optional<Real> history;      ///< [s] between rows; none: at most 2,000 rows, not too often
  std::optional<Real> from, to;     ///< [s] frames only in between; first and last always
  std::vector<std::string> fields;  ///< empty: all
  std::vector<std::string> bodies;  ///< empty: all
  bool pictures = false;
  std::optional<Real> checkpoint = 600;  ///< [s] of wall time between checkpoints; none: off
  int checkpoint_steps = 0;              ///< steps between checkpoints besides; 0: none
  bool state_hash = false;               ///< a hash of the state in every row of the history
};

struct Ranks {
  std::optional<Real> balance = 1.15;  ///< largest over mean work that is put up with; none: off
  int balance_steps = 100;             ///< steps between two looks at it
};

void describe(Schema& s, Time& time);
void describe(Schema& s, ContactPair& pair);
void describe(Schema& s, Contact& contact);
void describe(Schema& s, AtRest& rest);
void describe(Schema& s, Beyond& beyond);
void describe(Schema& s, Symmetry& planes);
void describe(Schema& s, Stop& stop);
void describe(Schema& s, Output& output);
void describe(Schema& s, Ranks& ranks);

}  // namespace deck

struct Deck {
  std::string title;
  Geometry geometry = Geometry::three_d;
  Real depth = 1;  ///< [m] plane strain: forces, masses and energies are for this depth
  deck::Time time;
  deck::Quality quality = deck::Quality::standard;
  deck::Heat heat = deck::Heat::automatic;
  Real ambient = 298;  ///< [K]
  std::vector<Named<deck::Material>> materials;
  std::vector<Named<deck::Body>> bodies;
  deck::Contact contact;
  std::vector<Named<deck::Boundary>> boundaries;
  std::optional<deck::Symmetry> symmetry;
  deck::Gravity gravity;
  std::optional<deck::Damping> damping;
  std::vector<Named<deck::Measure>> measures;
  std::vector<Named<deck::Probe>> probes;
  std::vector<Named<deck::Section>> sections;
  deck::Stop stop;
  deck::Output output;
  deck::Ranks ranks;
  int max_cells = 400'000;  ///< elements and particles together

  /// The material of that name; null: there is none.
  const deck::Material* material_named(const std::string& name) const;
  bool has_gravity() const { return deck::pulls(gravity); }
};

void describe(Schema& s, Deck& deck);

/// The label of the body of that name; none where there is no such body.
std::optional<Label> label_of(const Deck& deck, const std::string& body);
/// The body in the name of a body or of a piece of one: "wall" of "wall.1.0".
std::string body_of_part(const std::string& name);

/// The integration of a body of elements, `auto` resolved by its material.
Integration integration_of(const Deck& deck, const deck::Body& body);

/// Where each key of a deck stands, for checks that come after reading.
class DeckPlaces {
 public:
  void set(const std::string& path, SourcePlace place);
  /// Place of the key, or of its nearest ancestor that stands in the deck.
  SourcePlace place(const std::string& path) const;
  DeckProblem problem(const std::string& path, const std::string& message) const;
  bool has(const std::string& path) const { return places_.count(path) > 0; }

 private:
  std::map<std::string, SourcePlace> places_;
};

/// A parameter: its text in the deck, and its value in SI.
struct DeckParameter {
  std::string name, text;
  Real value = 0;    ///< SI
  std::string unit;  ///< SI unit of its dimension, "1" for a number
};

struct LoadedDeck {
  Deck deck;  ///< as it is stepped: with time.process_speed, not in real time
  DeckPlaces places;
  std::vector<DeckProblem> warnings;
  std::vector<std::string> wrong;  ///< keys that are wrong; none in a deck that can run
  std::string hash;                ///< 16 hex digits of the resolved deck
  std::string resolved;  ///< the resolved deck as YAML, SI, real time; reads back to the same Deck
  std::vector<DeckParameter> parameters;
  std::vector<std::string> overrides;
};

/// Reads a deck, its includes and the library, then overrides "KEY=VALUE" in order.
/// problems (appended)  all that is wrong; the deck then holds what could be read.
/// Throws DeckError where nothing can be read: a file, YAML, the geometry.
LoadedDeck read_deck(const std::string& path, const std::vector<std::string>& overrides,
                     std::vector<DeckProblem>& problems);
/// The same; throws DeckError with all that is wrong.
LoadedDeck load_deck(const std::string& path, const std::vector<std::string>& overrides = {});
/// The same from text; `name` stands for the file in messages, includes are relative to it.
LoadedDeck load_deck_text(const std::string& text, const std::string& name,
                          const std::vector<std::string>& overrides = {});
/// Puts problems in the order of the files, each place and path once.
void sort_problems(std::vector<DeckProblem>& problems);
/// The resolved deck as YAML.
std::string echo(const Deck& deck);

}  // namespace brunt
