#include "contact/law/pair_table.hpp"

#include <algorithm>

namespace brunt {

namespace {
/// What a body shows to contact.
struct Shown {
  bool faces = false;
  bool soft_faces = false;
  bool particles = false;
  bool pieces = false;  ///< more than one
  Label piece = 0;
  bool seen = false;
  void take(Label of) {
    pieces = pieces || (seen && of != piece);
    piece = of;
    seen = true;
  }
};

/// No joint bounds the step as if it were softer: edges of bodies that meet have ordinary springs.
constexpr Real kLeastOfJoints = 0.5;

bool can_touch(const Shown& a, const Shown& b, bool bonded) {
  const bool faces = a.faces && b.faces && (a.soft_faces || b.soft_faces);
  if (a.particles && b.particles && !bonded) return true;
  return faces || (a.particles && b.faces) || (a.faces && b.particles);
}
/// What each body shows of itself.
template <int Dim>
std::map<Label, Shown> shown_bodies(const std::vector<Surface<Dim>*>& surfaces) {
  std::map<Label, Shown> bodies;
  for (const auto* surface : surfaces) {
    for (const auto& facet : surface->facets) {
      auto& shown = bodies[facet.body];
      shown.faces = true;
      shown.soft_faces = shown.soft_faces || !facet.rigid();
      shown.take(facet.piece);
    }
    for (const auto& particle : surface->particles) {
      const auto point = slot_of(particle.point);
      auto& shown = bodies[surface->points->body[point]];
      shown.particles = true;
      shown.take(surface->points->piece[point]);
    }
    for (const Label body : surface->may_free) bodies[body].particles = true;
  }
  return bodies;
}
}  // namespace

template <int Dim>
PairTable::PairTable(const ContactOptions& options, const std::vector<Surface<Dim>*>& surfaces,
                     std::vector<std::string> body_names)
    : fallback_(options.fallback),
      given_(options.pairs),
      pair_names_(options.pair_names),
      turned_(options.turned),
      body_names_(std::move(body_names)) {
  const auto bodies = shown_bodies<Dim>(surfaces);
  for (const auto* surface : surfaces) {
    for (const auto& facet : surface->facets) {
      if (facet.rigid()) continue;
      auto& softest = softest_.try_emplace(facet.body, facet.stiffness).first->second;
      softest = std::min(softest, facet.stiffness);
    }
  }
  for (const auto& [pair, name] : options.pair_names) {
    if (pair.first == pair.second) selves_.insert(pair.first);
  }
  for (auto first = bodies.begin(); first != bodies.end(); ++first) {
    for (auto second = first; second != bodies.end(); ++second) {
      const Label a = first->first, b = second->first;
      const bool apart = a != b || first->second.pieces || touches_itself(a);
      const PairOptions& pair = of(a, b);
      if (pair.ignore || !apart || !can_touch(first->second, second->second, pair.bonded)) continue;
      pairs_.emplace_back(a, b);
      has_friction_ = has_friction_ || pair.has_friction();
      holds_ = holds_ || pair.holds();
      passes_heat_ = passes_heat_ || pair.passes_heat();
      const Real phi = stiffness_of(pair, a, b);
      needs_material_ = needs_material_ || pair.needs_material();
      presses_ = presses_ || pair.initial_overlap == InitialOverlap::press;
      if (first->second.particles && second->second.particles && !pair.bonded) {
        meeting_.insert({a, b});
        particles_have_friction_ = particles_have_friction_ || pair.has_friction();
      }
      const Real gap = gap_of(pair.heat);
      if (gap > 0) gaps_.resize(std::max(gaps_.size(), std::size_t{b} + 1), 0.0);
      // Particles have no overlap whose area could be looked at.
      const bool watched = pair.watched() && !first->second.particles && !second->second.particles;
      const Real always = watched ? kFreeStiffness : phi;
      watched_ = watched_ || watched;
      for (const Label body : {a, b}) {
        always_[body] = std::max(always_[body], always);
        if (gap > 0) gaps_[body] = std::max(gaps_[body], gap);
        auto [it, is_new] = strongest_.try_emplace(body, pair);
        it->second.stiffness = std::max(it->second.stiffness, phi);
        it->second.damping = std::max(it->second.damping, pair.damping);
      }
    }
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const bool named = pair_names_.count(pairs_[k]) != 0;
    if (named || pairs_.size() <= kMostReportedPairs) reported_.push_back(k);
  }
}

/// A linear joint may be softer than anything else between them.
Real PairTable::stiffness_of(const PairOptions& pair, Label a, Label b) const {
  if (!pair.joint || pair.joint->closure().any()) return pair.stiffest();
  Real compliance = 0;  // [m/Pa] of both sides
  for (const Label body : {a, b}) {
    const auto it = softest_.find(body);
    if (it != softest_.end()) compliance += 1 / it->second;
  }
  const Real of_joint = std::max(pair.joint->normal, pair.joint->across()) * compliance;
  return std::max(std::min(of_joint, kTiedStiffness), kLeastOfJoints);
}

Real PairTable::stiffness(Label a, Label b) const { return stiffness_of(of(a, b), a, b); }

std::optional<std::size_t> PairTable::find(Label a, Label b) const {
  const std::pair<Label, Label> wanted = std::minmax(a, b);
  const auto at = std::lower_bound(pairs_.begin(), pairs_.end(), wanted);
  if (at == pairs_.end() || *at != wanted) return {};
  return slot_of(at - pairs_.begin());
}

std::string PairTable::name(std::size_t pair) const {
  const auto [a, b] = pairs_[pair];
  const auto given = pair_names_.find({a, b});
  return given != pair_names_.end() ? given->second : body_names_[a] + "-" + body_names_[b];
}

Label PairTable::reported_body(std::size_t pair) const {
  const auto [a, b] = pairs_[pair];
  return turned_.count({a, b}) != 0 ? b : a;
}

const PairOptions& PairTable::of(Label a, Label b) const {
  if (given_.empty()) return fallback_;
  const auto it = given_.find({std::min(a, b), std::max(a, b)});
  return it == given_.end() ? fallback_ : it->second;
}

void PairTable::lay(const std::map<Label, RestingBody>& bodies, Real gravity) {
  const auto body = [&](Label label) {
    const auto it = bodies.find(label);
    return it == bodies.end() ? RestingBody{} : it->second;
  };
  for (const auto& [a, b] : pairs_) {
    const PairOptions& pair = of(a, b);
    // What is to have no damping has none here either.
    const Real weights = pair.damping > 0 ? pair.resting_layer : 0.0;
    const RestingLayer layer = resting_layer(body(a), body(b), gravity, weights);
    if (!layer.acts()) continue;
    resting_[{a, b}] = layer;
    for (const Label label : {a, b}) {
      auto& most = strongest_[label].damping;
      most = std::max(most, RestingLayer::damping_of(pair.damping));
    }
  }
}

const RestingLayer& PairTable::resting(Label a, Label b) const {
  static const RestingLayer kNone;
  const auto it = resting_.find({std::min(a, b), std::max(a, b)});
  return it == resting_.end() ? kNone : it->second;
}

PairOptions PairTable::strongest(Label body) const {
  const auto it = strongest_.find(body);
  if (it != strongest_.end()) return it->second;
  PairOptions none;
  none.ignore = true;
  none.stiffness = none.damping = 0;
  return none;
}

Real PairTable::always(Label body) const {
  const auto it = always_.find(body);
  return it == always_.end() ? 0.0 : it->second;
}

template PairTable::PairTable(const ContactOptions&, const std::vector<Surface<2>*>&,
                              std::vector<std::string>);
template PairTable::PairTable(const ContactOptions&, const std::vector<Surface<3>*>&,
                              std::vector<std::string>);

}  // namespace brunt
