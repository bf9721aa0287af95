#include "app/setup/suspicious.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/deck/findings.hpp"
#include "app/setup/heat.hpp"
#include "app/setup/planes.hpp"
#include "app/watch/thin_bodies.hpp"

namespace brunt {

namespace {
template <int Dim>
std::string vector_text(const Vec<Dim>& x) {
  std::string text;
  for (int c = 0; c < Dim; ++c) text += (c == 0 ? "[" : ", ") + deck::length_text(x[c]);
  return text + "]";
}

/// A size that is larger than all lengths of its body.
template <int Dim>
void warn_of_size(const std::string& path, const deck::Body& body, const BodyBox<Dim>& box,
                  const Warn& warn) {
  if (!body.size || body.size->empty() || box.empty()) return;
  constexpr Real kRounding = 1e-9;
  const Real size = *std::min_element(body.size->begin(), body.size->end());
  const Real longest = box.lengths().maxCoeff();
  if (body.method == deck::Method::sph || size <= (1 + kRounding) * longest) return;
  const Real in_mm = 1e-3 * size;  // a number without unit is in metres
  const Real meant = in_mm < 0.5 * longest && in_mm > 0.02 * longest ? in_mm : 0.1 * longest;
  warn(path + ".size", "an element is " + deck::length_text(size) + " long, and the whole body " +
                           deck::length_text(longest) + ": " + deck::length_text(meant) +
                           " was probably meant");
}

/// A surface of a file that is far larger than all else.
template <int Dim>
void warn_of_scale(const LoadedDeck& loaded, const std::vector<BodyBox<Dim>>& boxes, std::size_t at,
                   const Warn& warn) {
  const auto& [name, body] = loaded.deck.bodies[at];
  if (body.file.empty() || boxes[at].empty()) return;
  BodyBox<Dim> rest;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const bool plane = std::holds_alternative<Plane>(loaded.deck.bodies[b].value.shape.kind) &&
                       loaded.deck.bodies[b].value.file.empty();
    if (b != at && !plane) rest.add(boxes[b]);
  }
  if (rest.empty()) return;
  const bool given = loaded.places.has("bodies." + name + ".scale");
  const Real times = given ? 300 : 100;
  const Real length = boxes[at].lengths().maxCoeff(), other = rest.lengths().maxCoeff();
  if (length < times * other) return;
  warn("bodies." + name + (given ? ".scale" : ".file"),
       "is " + deck::length_text(length) + " long, and the rest of the scene " +
           deck::length_text(other) + ": the file is probably in mm, write scale: " +
           (given ? deck::length_text(1e-3 * body.scale) : std::string("1 mm")));
}

/// The length [m] within which some point of a body is near any place inside it.
template <int Dim>
Real nearness(const deck::Body& body, const BodyBox<Dim>& box) {
  constexpr Real kElements = 2;
  const Real longest = box.lengths().maxCoeff();
  if (body.size && !body.size->empty()) {
    return kElements * *std::max_element(body.size->begin(), body.size->end());
  }
  if (!body.cells || body.cells->empty()) return longest;
  return kElements * longest / *std::min_element(body.cells->begin(), body.cells->end());
}

/// A place that was to be in a body and is far from all of its points.
template <int Dim>
class Places {
 public:
  Places(const LoadedDeck& loaded, const Scene<Dim>& scene, const std::vector<BodyBox<Dim>>& boxes,
         const Warn& warn)
      : loaded_(loaded), scene_(scene), boxes_(boxes), warn_(warn) {}

  void look_at(const std::string& path, const std::string& name, const std::vector<Real>& place) {
    const auto label = label_of(loaded_.deck, name);
    if (!label || place.size() != Dim || boxes_[*label].empty()) return;
    const auto& body = loaded_.deck.bodies[*label].value;
    const auto& box = boxes_[*label];
    const Real near = nearness(body, box);
    Vec<Dim> at;
    for (int c = 0; c < Dim; ++c) at[c] = place[c];
    const Real far = distance(*label, at);
    if (far <= near) return;
    constexpr Real kFar = 100;  // metres that were to be millimetres
    const bool in_mm = far > kFar * box.lengths().maxCoeff() && distance(*label, 1e-3 * at) <= near;
    warn_(path, "is " + deck::length_text(far) + " from the nearest point of '" + name +
                    "', which reaches from " + vector_text<Dim>(box.low) + " to " +
                    vector_text<Dim>(box.high) + ": " +
                    (in_mm ? vector_text<Dim>(1e-3 * at) : "a place inside of it") +
                    " was probably meant");
  }

 private:
  Real distance(Label label, const Vec<Dim>& at) const {
    Real least = kInfinity;
    for (const auto& solid : scene_.solids) {
      const auto& points = solid->points();
      for (std::size_t i = 0; i < points.x_start.size(); ++i) {
        if (points.body[i] != label) continue;
        least = std::min(least, (points.x_start[i] + scene_.origin - at).squaredNorm());
      }
    }
    return std::sqrt(least);
  }

  const LoadedDeck& loaded_;
  const Scene<Dim>& scene_;
  const std::vector<BodyBox<Dim>>& boxes_;
  const Warn& warn_;
};

/// The least smoothing [spacings] with which a bar on a square lattice that is pulled by 8e-4 keeps
/// 0.99 of its modulus: docs/decisions/206-clumping-is-told.md.
Real least_smoothing(KernelKind kernel) {
  switch (kernel) {
    case KernelKind::wendland_c4:
      return 1.7;
    case KernelKind::wendland_c2:
    case KernelKind::hyperbolic:
      return 1.5;
    default:
      return 1.4;
  }
}

/// Particles of so few neighbours that they clump where they are pulled. Artificial stress says by
/// itself what it carries.
void warn_of_clumping(const LoadedDeck& loaded, const std::string& name, const deck::Body& body,
                      const Warn& warn) {
  const auto* material = loaded.deck.material_named(body.material);
  if (body.method != deck::Method::sph || body.rigid || material == nullptr) return;
  const Real least = least_smoothing(body.sph.kernel);
  if (body.lattice != deck::Lattice::cubic || body.sph.smoothing >= least) return;
  if (body.sph.artificial_stress != 0 || material->shear_modulus() == 0) return;
  if (body.sph.formulation == SphFormulation::total) return;
  if (is_held(loaded.deck, name)) return;
  warn("bodies." + name + ".smoothing",
       "particles clump where they are pulled, and carry less than their material: this kernel "
       "takes " +
           deck::short_text(least) +
           " spacings or more on a square lattice; try the "
           "default, 1.7, or `lattice: hexagonal`");
}

/// Bodies of particles that lie in one layer, flat or curved, or on one line: they are membranes.
template <int Dim>
void warn_of_sheets(const LoadedDeck& loaded, const Scene<Dim>& scene, const Warn& warn) {
  constexpr std::size_t kFew = 10;  // that hardly bend anyway
  const auto& bodies = loaded.deck.bodies;
  Totals<Dim> totals;
  totals.bodies.resize(bodies.size());
  std::vector<std::size_t> count(bodies.size());
  std::vector<Real> mass(bodies.size());
  for (const auto& solid : scene.solids) {
    if (solid->n_particles() == 0) continue;
    solid->add_totals(totals);
    const auto& points = solid->points();
    for (std::size_t i = 0; i < points.body.size(); ++i) {
      ++count[points.body[i]], mass[points.body[i]] += points.mass[i];
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& [name, body] = bodies[b];
    if (body.method != deck::Method::sph || body.rigid || is_held(loaded.deck, name)) continue;
    const Real thin = totals.bodies[b].thin_mass.value();
    if (count[b] < kFew || thin <= kLargestThinShare * mass[b]) continue;
    warn(thin_body_path(name),
         thin_share_text(thin / mass[b]) +
             " in one layer, which bends and folds without resistance and may clump where it is "
             "pulled: half the size gives two layers, and so may `lattice: hexagonal`");
  }
}

/// Fluids, whose neighbours change.
void warn_of_total_fluids(const LoadedDeck& loaded, const std::string& name, const deck::Body& body,
                          const Warn& warn) {
  const auto* material = loaded.deck.material_named(body.material);
  if (body.method != deck::Method::sph || material == nullptr) return;
  if (body.sph.formulation != SphFormulation::total || material->shear_modulus() > 0) return;
  warn("bodies." + name + ".formulation",
       "total keeps the neighbours of time 0, and '" + body.material +
           "' has no shear modulus and flows: it comes apart in lumps; take updated");
}

/// Bodies whose heat flows between the neighbours of time 0, however far they are apart.
void warn_of_total_conduction(const LoadedDeck& loaded, const std::string& name,
                              const deck::Body& body, const Warn& warn) {
  if (body.method != deck::Method::sph || body.sph.formulation != SphFormulation::total) return;
  if (heat_mode(loaded.deck, body, name) != HeatMode::conducts) return;
  warn(
      "bodies." + name + ".formulation",
      "total conducts heat between the places of time 0: where the body is stretched by a tenth, a "
      "fifth too much flows along it; `heat: adiabatic` conducts none");
}

/// Contact that is to pass heat between bodies none of which conducts.
void warn_of_heat(const LoadedDeck& loaded, const Warn& warn) {
  const Deck& deck = loaded.deck;
  if (deck.heat == deck::Heat::off || deck.heat == deck::Heat::adiabatic) return;  // it says so
  const auto conducts = [&](const std::string& name) {
    return std::any_of(deck.bodies.begin(), deck.bodies.end(), [&](const auto& body) {
      return (name == "any" || body.name == name) &&
             heat_mode(deck, body.value, body.name) == HeatMode::conducts;
    });
  };
  const auto look_at = [&](const std::string& path, const std::string& who) {
    if (!loaded.places.has(path)) return;
    warn(path, "passes no heat: " + who +
                   " conducts; `thermal: {cp: ..., k: ...}` in a material was probably meant, or "
                   "heat: off");
  };
  if (deck.contact.fallback.passes_heat() && !conducts("any")) {
    look_at("contact.default.heat", "no body");
  }
  for (const auto& [name, pair] : deck.contact.pairs) {
    if (!pair.options.passes_heat() || pair.between.size() != 2) continue;
    const bool any = pair.between[1] == "any";
    if (conducts(pair.between[0]) || conducts(pair.between[1])) continue;
    look_at("contact.pairs." + name + ".heat", any ? "no body" : "neither body");
  }
}

/// A rigid body whose temperature nothing reads.
void warn_of_cold_tools(const LoadedDeck& loaded, const Warn& warn) {
  const Deck& deck = loaded.deck;
  if (deck.heat == deck::Heat::off || deck.heat == deck::Heat::adiabatic) return;  // it says so
  for (const auto& [name, body] : deck.bodies) {
    const std::string path = "bodies." + name + ".temperature";
    if (!body.rigid || !loaded.places.has(path)) continue;
    if (heat_mode(deck, body, name) == HeatMode::conducts) continue;
    warn(path, "heats nothing: '" + name +
                   "' does not conduct; `motion: {temperature: ...}` holds its surface at one, and "
                   "a material with `thermal: {cp: ..., k: ...}` and `size` let it conduct");
  }
}
}  // namespace

template <int Dim>
std::vector<BodyBox<Dim>> boxes_of_bodies(const Scene<Dim>& scene) {
  std::vector<BodyBox<Dim>> boxes(scene.body_names.size());
  for (const auto& solid : scene.solids) {
    const auto& points = solid->points();
    for (std::size_t i = 0; i < points.x_start.size(); ++i) {
      const Vec<Dim> x = points.x_start[i] + scene.origin;
      boxes[points.body[i]].add({x, x});
    }
  }
  return boxes;
}

template <int Dim>
void warn_of_sizes(const LoadedDeck& loaded, const Scene<Dim>& scene, const Warn& warn) {
  const Deck& deck = loaded.deck;
  const auto boxes = boxes_of_bodies(scene);
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    warn_of_size("bodies." + deck.bodies[b].name, deck.bodies[b].value, boxes[b], warn);
    warn_of_scale(loaded, boxes, b, warn);
    warn_of_clumping(loaded, deck.bodies[b].name, deck.bodies[b].value, warn);
    warn_of_total_fluids(loaded, deck.bodies[b].name, deck.bodies[b].value, warn);
    warn_of_total_conduction(loaded, deck.bodies[b].name, deck.bodies[b].value, warn);
  }
  warn_of_sheets(loaded, scene, warn);
  Places<Dim> places(loaded, scene, boxes, warn);
  for (const auto& [name, probe] : deck.probes) {
    places.look_at("probes." + name + ".at", probe.body, probe.at);
  }
  for (const auto& [name, measure] : deck.measures) {
    if (const auto* point = std::get_if<deck::PointMeasure>(&measure.kind)) {
      places.look_at("measures." + name + ".point.at", point->body, point->at);
    }
  }
  warn_of_heat(loaded, warn);
  warn_of_cold_tools(loaded, warn);
  warn_of_planes(loaded, scene, boxes, warn);
}

template std::vector<BodyBox<2>> boxes_of_bodies<2>(const Scene<2>&);
template std::vector<BodyBox<3>> boxes_of_bodies<3>(const Scene<3>&);
template void warn_of_sizes<2>(const LoadedDeck&, const Scene<2>&, const Warn&);
template void warn_of_sizes<3>(const LoadedDeck&, const Scene<3>&, const Warn&);

}  // namespace brunt
