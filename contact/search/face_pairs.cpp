/// Faces beside faces.
#include <algorithm>
#include <map>

#include "contact/law/springs.hpp"
#include "contact/search/candidates.hpp"
#include "contact/search/near_pieces.hpp"
#include "core/parallel/threads.hpp"

namespace brunt {

namespace {
template <class A, class B>
bool is_same_piece(const A& a, const B& b) {
  return a.body == b.body && a.piece == b.piece;
}

/// So much sharper is a point or blade than what it digs into.
constexpr Real kSharper = 0.5;

template <int Dim>
FaceLaw law_of(const ContactFace<Dim>& a, const ContactFace<Dim>& b, const PairOptions& options,
               const RestingLayer& rests) {
  FaceLaw law;
  const Real both = contact_spring(a.stiffness, a.deforms(), b.stiffness, b.deforms());
  law.stiffness = options.stiffness * both;
  law.at_point = options.plane == PlaneRule::point;
  const Real mass = in_series(a.areal_mass, b.areal_mass);
  law.damping = damping_coefficient(options.damping, law.stiffness, mass);
  law.limit = std::min(a.rigid() ? b.depth : a.depth, b.rigid() ? a.depth : b.depth);
  // The flanks of a thin point or blade that digs into what is blunter go in deeper than it is
  // wide.
  const auto &blunt = a.sharpness < b.sharpness ? b : a, &sharp = a.sharpness < b.sharpness ? a : b;
  if (sharp.sharpness < kSharper * blunt.sharpness) law.leaning = blunt.depth;
  if (is_same_piece(a, b)) law.limit *= kDeepestInside, law.leaning = 0;
  if (options.joint) {
    law.stiffness = std::min(options.joint->normal, kTiedStiffness * both);
    law.damping = 0;
    return law;
  }
  if (!rests.acts()) return law;
  law.layer = rests.over(law.stiffness, law.limit);
  law.layer_damping =
      damping_coefficient(RestingLayer::damping_of(options.damping), law.stiffness, mass);
  return law;
}

/// All that is asked of a face before its box is compared: small, for it is read out of order.
template <int Dim>
struct FaceMask {
  std::array<LocalIndex, ContactFace<Dim>::kCorners> node;
  int n_nodes;
  LocalIndex surface;
  Label body, piece;
  bool owned, rigid, meets_its_piece;

  FaceMask(const ContactFace<Dim>& face, const PairTable& pairs)
      : node(face.node),
        n_nodes(face.n_nodes),
        surface(face.surface),
        body(face.body),
        piece(face.piece),
        owned(face.owned),
        rigid(face.rigid()),
        meets_its_piece(face.deforms() && pairs.touches_itself(face.body)) {}

  bool shares_a_node(const FaceMask& other) const {
    if (surface != other.surface) return false;
    for (int i = 0; i < n_nodes; ++i) {
      for (int j = 0; j < other.n_nodes; ++j) {
        if (node[slot_of(i)] == other.node[slot_of(j)]) return true;
      }
    }
    return false;
  }
};
}  // namespace

FaceOptions::FaceOptions(const PairTable& pairs, Label a, Label b)
    : options(&pairs.of(a, b)),
      rests(&pairs.resting(a, b)),
      acts_apart(options->watched() || options->holds()) {}

template <int Dim>
FaceCandidate FacePairs<Dim>::candidate(std::size_t k) const {
  const ListedFaces& pair = listed_[k];
  const FaceOptions& of = options_[pair.options];
  const auto &a = faces_[slot_of(pair.lower)], &b = faces_[slot_of(pair.upper)];
  return {pair.lower, pair.upper, law_of(a, b, *of.options, *of.rests),
          PairLaws(*of.options, a.capacity > 0 && b.capacity > 0),
          of.options->watched() ? of.options->stiffness : 0.0};
}

namespace {
/// Leaves faces that are far from all that their bodies may touch out, and their boxes.
template <int Dim>
void keep_near_pieces(const Entities<Dim>& entities, const PairTable& pairs, SearchMode mode,
                      std::vector<LocalIndex>& near, std::vector<SearchBox<Dim>>& boxes) {
  const auto& faces = entities.faces;
  const auto piece_of = [&](std::size_t k) {
    const auto& face = faces[slot_of(near[k])];
    return PieceKey{face.body, face.piece};
  };
  const auto may_meet = [&](const PieceKey& a, const PieceKey& b) {
    return a == b ? pairs.touches_itself(a.first) : !pairs.of(a.first, b.first).ignore;
  };
  const auto kept = near_pieces<Dim>(boxes, piece_of, may_meet, mode);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    near[k] = near[slot_of(kept[k])];
    boxes[k] = boxes[slot_of(kept[k])];
  }
  near.resize(kept.size());
  boxes.resize(kept.size());
}
}  // namespace

template <int Dim>
void Candidates<Dim>::find_faces(const Entities<Dim>& entities, const PairTable& pairs) {
  face_pairs_.clear();
  face_options_.clear();
  auto near = entities.near_faces;
  std::vector<SearchBox<Dim>> boxes(near.size());
  for_each(near.size(), kWorthThreads,
           [&](std::size_t k) { boxes[k] = box_of_face(entities, slot_of(near[k])); });
  keep_near_pieces(entities, pairs, mode_, near, boxes);
  std::vector<FaceMask<Dim>> faces;
  faces.reserve(near.size());
  for (const LocalIndex f : near) faces.emplace_back(entities.faces[slot_of(f)], pairs);
  const auto admits = [&](LocalIndex i, LocalIndex j) {
    const auto &a = faces[slot_of(i)], &b = faces[slot_of(j)];
    if (!a.owned || (a.rigid && b.rigid)) return false;
    if (is_same_piece(a, b) && !a.meets_its_piece) return false;
    return !a.shares_a_node(b) && !pairs.of(a.body, b.body).ignore;
  };
  std::map<std::pair<Label, Label>, std::uint32_t> known;
  std::pair<Label, Label> last{};
  std::uint32_t place = 0;
  const auto found = overlapping_pairs<Dim>(boxes, admits, mode_);
  face_pairs_.reserve(found.size());
  for (const auto& [i, j] : found) {
    const std::pair<Label, Label> bodies{faces[slot_of(i)].body, faces[slot_of(j)].body};
    if (face_options_.empty() || bodies != last) {
      const auto next = static_cast<std::uint32_t>(face_options_.size());
      const auto [it, is_new] = known.try_emplace(bodies, next);
      if (is_new) face_options_.emplace_back(pairs, bodies.first, bodies.second);
      place = it->second, last = bodies;
    }
    face_pairs_.push_back({near[slot_of(i)], near[slot_of(j)], place});
  }
}

template class FacePairs<2>;
template class FacePairs<3>;
template void Candidates<2>::find_faces(const Entities<2>&, const PairTable&);
template void Candidates<3>::find_faces(const Entities<3>&, const PairTable&);

}  // namespace brunt
// Tested by tests/unit/contact/rebuild_test.cpp.
