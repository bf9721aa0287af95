#include "partitioned_scene.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "core/parallel/boxes.hpp"
#include "fe/finite_elements.hpp"
#include "sph/particles.hpp"

namespace brunt {

namespace {
/// A point of `owner` that stands on `rank` too.
struct Copy {
  int rank, owner;
  GlobalId point;
  auto operator<=>(const Copy&) const = default;
};

void sort_unique(std::vector<Copy>& copies) {
  std::sort(copies.begin(), copies.end());
  copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
}

std::size_t at(int rank) { return static_cast<std::size_t>(rank); }

/// Messages that carry `bytes` of each copy from owner to rank, once. copies  sorted
void add_refresh(const std::vector<Copy>& copies, Real bytes, std::vector<RankLoad>& loads) {
  for (std::size_t i = 0; i < copies.size(); ++i) {
    auto& sent = loads[at(copies[i].owner)].step;
    const bool first =
        i == 0 || copies[i - 1].rank != copies[i].rank || copies[i - 1].owner != copies[i].owner;
    sent.messages += first ? 1 : 0;
    sent.bytes += bytes;
  }
}

template <int Dim>
class Counter {
 public:
  Counter(Scene<Dim>& scene, const Partition& partition, int parts)
      : scene_(scene), partition_(partition), parts_(parts), loads_(at(parts)) {}
  std::vector<RankLoad> count(std::span<const Real> weight) {
    for (const auto& solid : scene_.solids) {
      for (const GlobalId id : solid->points().id) {
        auto& load = loads_[at(partition_.of(id))];
        ++load.points;
        load.weight += weight[id];
      }
      if (auto* elements = dynamic_cast<FiniteElements<Dim>*>(solid.get())) count(*elements);
      if (auto* particles = dynamic_cast<SphParticles<Dim>*>(solid.get())) count(*particles);
    }
    if (scene_.contact) count_contact();
    return loads_;
  }

 private:
  void count(const FiniteElements<Dim>& elements);
  void count(const SphParticles<Dim>& particles);
  void count_contact();
  void add_imports(const ContactReaches<Dim>& reaches, const std::vector<int>& owner);
  void add_sizes(const ContactReaches<Dim>& reaches);
  void add_letters(const ContactReaches<Dim>& reaches, const std::vector<int>& owner);
  /// Every rank to every other, `bytes` each.
  void add_to_all(Sent& sent, Real bytes) const {
    sent.messages += parts_ - 1;
    sent.bytes += (parts_ - 1) * bytes;
  }
  /// Which of each rank's offered boxes each other rank imports: visit(from, to, index).
  template <class Visit>
  void for_each_import(const std::vector<std::vector<SearchBox<Dim>>>& offered,
                       const std::vector<std::vector<SearchBox<Dim>>>& wanted,
                       Sent RankLoad::*lists, Visit visit);

  Scene<Dim>& scene_;
  const Partition& partition_;
  int parts_;
  std::vector<RankLoad> loads_;
  std::vector<Copy> nodes_;                          // copies of nodes of elements, sorted
  std::vector<std::pair<int, int>> imported_;        // to whom faces go that have nodes of whom
  std::unordered_map<GlobalId, int> element_owner_;  // by element id
};

template <int Dim>
void Counter<Dim>::count(const FiniteElements<Dim>& elements) {
  constexpr int n = Shape<Dim>::kCorners;
  const auto& ids = elements.points().id;
  for (const auto& block : elements.blocks()) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      std::array<GlobalId, n> id;
      std::array<int, n> owner;
      for (std::size_t c = 0; c < n; ++c) {
        id[c] = ids[static_cast<std::size_t>(block.corner[static_cast<std::size_t>(e) * n + c])];
        owner[c] = partition_.of(id[c]);
      }
      ++loads_[at(owner[0])].elements;
      element_owner_[block.id[e]] = owner[0];
      auto ranks = owner;
      std::sort(ranks.begin(), ranks.end());
      const auto end = std::unique(ranks.begin(), ranks.end());
      for (auto rank = ranks.begin(); rank != end; ++rank) {
        ++loads_[at(*rank)].computed;
        for (std::size_t c = 0; c < n; ++c) {
          if (owner[c] != *rank) nodes_.push_back({*rank, owner[c], id[c]});
        }
      }
    }
  }
  sort_unique(nodes_);
  for (const Copy& copy : nodes_) ++loads_[at(copy.rank)].ghosts;
  add_refresh(nodes_, 2 * Dim * sizeof(Real), loads_);
}

template <int Dim>
template <class Visit>
void Counter<Dim>::for_each_import(const std::vector<std::vector<SearchBox<Dim>>>& offered,
                                   const std::vector<std::vector<SearchBox<Dim>>>& wanted,
                                   Sent RankLoad::*lists, Visit visit) {
  std::vector<std::vector<SearchBox<Dim>>> runs;
  std::vector<SearchBox<Dim>> bounds;  // of what is offered, then of what is wanted
  std::vector<int> whose;
  const auto add_bounds = [&](int rank, const std::vector<SearchBox<Dim>>& boxes) {
    if (boxes.empty()) return;
    auto all = boxes.front();
    for (const auto& box : boxes) {
      for (std::size_t c = 0; c < Dim; ++c) {
        all.lo[c] = std::min(all.lo[c], box.lo[c]), all.hi[c] = std::max(all.hi[c], box.hi[c]);
      }
    }
    bounds.push_back(all);
    whose.push_back(rank);
  };
  for (int r = 0; r < parts_; ++r) add_bounds(r, offered[at(r)]);
  const auto n_offered = static_cast<LocalIndex>(bounds.size());
  for (int r = 0; r < parts_; ++r) {
    runs.push_back(runs_of<Dim>(wanted[at(r)]));
    add_bounds(r, runs.back());
    add_to_all(loads_[at(r)].*lists,
               static_cast<Real>(8 + runs.back().size() * sizeof(SearchBox<Dim>)));
  }
  const auto admits = [&](LocalIndex i, LocalIndex j) {
    return i < n_offered && j >= n_offered &&
           whose[static_cast<std::size_t>(i)] != whose[static_cast<std::size_t>(j)];
  };
  for (const auto& [i, j] : overlapping_pairs<Dim>(bounds, admits, SearchMode::grid)) {
    const int from = whose[static_cast<std::size_t>(i)], to = whose[static_cast<std::size_t>(j)];
    for (const LocalIndex k : meeting<Dim>(offered[at(from)], runs[at(to)])) {
      visit(from, to, static_cast<std::size_t>(k));
    }
  }
}

template <int Dim>
void Counter<Dim>::count(const SphParticles<Dim>& particles) {
  const auto& points = particles.points();
  std::vector<std::vector<SearchBox<Dim>>> boxes(at(parts_));
  std::vector<std::vector<GlobalId>> ids(at(parts_));
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    const int owner = partition_.of(points.id[i]);
    const Real reach = particles.smoothing_lengths()[i] + 0.5 * particles.skin();
    SearchBox<Dim> box;
    for (std::size_t c = 0; c < Dim; ++c) {
      box.lo[c] = points.x[i][static_cast<int>(c)] - reach;
      box.hi[c] = points.x[i][static_cast<int>(c)] + reach;
    }
    boxes[at(owner)].push_back(box);
    ids[at(owner)].push_back(points.id[i]);
    ++loads_[at(owner)].particles;
  }
  // Id, labels, mass, smoothing length, volume; position and velocity.
  constexpr Real visitor = 8 + 8 + 3 * 8 + 2 * Dim * 8;
  std::vector<Copy> copies;
  for_each_import(boxes, boxes, &RankLoad::particle_lists, [&](int from, int to, std::size_t k) {
    copies.push_back({to, from, ids[at(from)][k]});
    loads_[at(from)].particle_lists.bytes += visitor;
  });
  sort_unique(copies);
  for (const Copy& copy : copies) ++loads_[at(copy.rank)].ghosts;
  for (auto& load : loads_) add_to_all(load.particle_lists, 8);
  constexpr std::size_t state =
      std::size(StressRecord<Dim>{}.data) + std::size(ArtificialRecord<Dim>{}.data) + 2;
  add_refresh(copies, 2 * Dim * sizeof(Real), loads_);
  add_refresh(copies, state * sizeof(Real), loads_);
}

template <int Dim>
void Counter<Dim>::count_contact() {
  const auto reaches = scene_.contact->reaches();
  std::vector<int> owner;  // of each face; a rigid one stands everywhere
  for (const auto& face : reaches.faces) {
    owner.push_back(face.rigid ? 0 : element_owner_.at(face.id >> 3));
    loads_[at(owner.back())].candidates += face.candidates;
    loads_[at(owner.back())].surface += face.rigid ? 0 : 1;
  }
  for (const auto& one : reaches.particles) {
    auto& load = loads_[at(partition_.of(one.node[0].point))];
    load.candidates += one.candidates;
    ++load.surface;
  }
  add_imports(reaches, owner);
  add_sizes(reaches);
  add_letters(reaches, owner);
}

template <int Dim>
void Counter<Dim>::add_imports(const ContactReaches<Dim>& reaches, const std::vector<int>& owner) {
  std::vector<std::vector<SearchBox<Dim>>> offered(at(parts_)), wanted;
  std::vector<std::vector<std::size_t>> face(at(parts_));
  for (std::size_t f = 0; f < reaches.faces.size(); ++f) {
    if (reaches.faces[f].rigid) continue;
    offered[at(owner[f])].push_back(reaches.faces[f].box);
    face[at(owner[f])].push_back(f);
  }
  wanted = offered;
  for (const auto& one : reaches.particles) {
    const auto r = at(partition_.of(one.node[0].point));
    wanted[r].push_back(one.box);
  }
  constexpr Real head = 80, corner = 16 + 2 * Dim * 8;  // of a face on its way
  std::vector<Copy> copies;
  std::vector<std::pair<int, int>> pairs;
  for_each_import(offered, wanted, &RankLoad::contact_lists, [&](int from, int to, std::size_t k) {
    const auto& one = reaches.faces[face[at(from)][k]];
    loads_[at(from)].contact_lists.bytes += head + one.n_nodes * corner;
    pairs.emplace_back(from, to);
    for (int c = 0; c < one.n_nodes; ++c) {
      const Copy copy{to, partition_.of(one.node[at(c)].point), one.node[at(c)].point};
      imported_.emplace_back(to, copy.owner);
      if (copy.owner == to || std::binary_search(nodes_.begin(), nodes_.end(), copy)) continue;
      copies.push_back(copy);
    }
  });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& pair : pairs) ++loads_[at(pair.first)].contact_lists.messages;
  sort_unique(copies);
  add_refresh(copies, 2 * Dim * sizeof(Real), loads_);
  for (auto& load : loads_) {
    for (std::size_t s = 0; s < scene_.solids.size(); ++s) add_to_all(load.contact_lists, 8);
    if (load.particles > 0) add_to_all(load.contact_lists, 12);
  }
}

/// In every step ranks tell each other how many forces come, where one has nodes of the other in
/// its tables: of faces on both, of faces that were sent, and of rigid faces, which all ranks have.
template <int Dim>
void Counter<Dim>::add_sizes(const ContactReaches<Dim>& reaches) {
  auto& pairs = imported_;
  std::unordered_set<GlobalId> outer;
  for (const auto& face : reaches.faces) {
    for (int c = 0; c < face.n_nodes; ++c) {
      const GlobalId point = face.node[at(c)].point;
      if (!outer.insert(point).second || !face.rigid) continue;
      for (int r = 0; r < parts_; ++r) pairs.emplace_back(r, partition_.of(point));
    }
  }
  for (const Copy& copy : nodes_) {
    if (outer.count(copy.point) != 0) pairs.emplace_back(copy.rank, copy.owner);
  }
  for (std::size_t i = pairs.size(); i-- > 0;) pairs.emplace_back(pairs[i].second, pairs[i].first);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [from, to] : pairs) {
    if (from == to) continue;
    loads_[at(from)].step.messages += 1;
    loads_[at(from)].step.bytes += 8;
  }
}

template <int Dim>
void Counter<Dim>::add_letters(const ContactReaches<Dim>& reaches, const std::vector<int>& owner) {
  std::vector<std::pair<int, int>> letters;  // from, to
  for (const auto& touch : reaches.touches) {
    const int from = touch.kind == ContactKind::face_face
                         ? owner[touch.evaluator]
                         : partition_.of(reaches.particles[touch.evaluator].node[0].point);
    for (const auto& node : touch.node) {
      const int to = partition_.of(node.point);
      if (to != from) letters.emplace_back(from, to);
    }
  }
  std::sort(letters.begin(), letters.end());
  for (std::size_t i = 0; i < letters.size(); ++i) {
    auto& sent = loads_[at(letters[i].first)].step;
    sent.messages += i == 0 || letters[i - 1] != letters[i] ? 1 : 0;
    sent.bytes += static_cast<Real>(reaches.letter_bytes);
  }
}
}  // namespace

template <int Dim>
std::vector<RankLoad> rank_loads(Scene<Dim>& scene, const Partition& partition,
                                 std::span<const Real> weight, int parts) {
  return Counter<Dim>(scene, partition, parts).count(weight);
}

template std::vector<RankLoad> rank_loads(Scene<2>&, const Partition&, std::span<const Real>, int);
template std::vector<RankLoad> rank_loads(Scene<3>&, const Partition&, std::span<const Real>, int);

}  // namespace brunt
