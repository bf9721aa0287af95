#include "app/cli/memory.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/watch/history_columns.hpp"
#include "contact/search/candidates.hpp"
#include "fe/element_block.hpp"
#include "sph/particles.hpp"

namespace brunt {

namespace {
// Deviator, pressure, bulk modulus, eps_p, strain rate, temperature, two heats, energy, and of few
// the plastic volume and the opening.
constexpr Real kMaterialPoint = 14 * sizeof(Real);
// What stepping and writing bring in of the program and its libraries: a run of a few elements
// peaks at 51 MB, with 38 MB when its scene stands (decks/bars, block-on-incline, spall).
constexpr Real kBroughtIn = 13e6;

template <int Dim>
constexpr Real point_bytes() {
  return sizeof(GlobalId) + 2 * sizeof(Label) + 2 * sizeof(Real) + 6 * sizeof(Vec<Dim>);
}

/// One element of `gauss` material points: its share of an ElementBlock, the buffer of corner
/// forces and the list by which nodes gather them.
template <int Dim>
Real element_bytes(int gauss) {
  using Block = ElementBlock<Dim>;
  const Real lists = Shape<Dim>::kCorners * (2 * sizeof(LocalIndex) + sizeof(Vec<Dim>));
  const Real labels = sizeof(GlobalId) + 2 * sizeof(Label);
  constexpr int kScalars = 8;  // volume, size, mass, viscosity, three works, step
  return lists + labels + gauss * (kMaterialPoint + sizeof(Real)) +
         (kScalars + Block::kHourglassValues) * sizeof(Real);
}

template <int Dim>
constexpr Real single_bytes() {
  return sizeof(MotionRecord<Dim, SinglePairs>) + sizeof(StressRecord<Dim, SinglePairs>) +
         sizeof(ArtificialRecord<Dim, SinglePairs>);
}

template <int Dim>
constexpr Real total_bytes() {
  return sizeof(TotalState<Dim>) + sizeof(TotalRecord<Dim>) + sizeof(Vec<Dim>);
}

template <int Dim>
constexpr Real particle_bytes() {
  // Where it was when the lists were made, its zone, its sum; completeness and whether it is thin.
  constexpr Real kWatched = sizeof(Vec<Dim>) + 2 * sizeof(Real) + 2 * sizeof(LocalIndex) + 1;
  return kWatched + sizeof(ParticleState<Dim>) + kMaterialPoint + sizeof(MotionRecord<Dim>) +
         sizeof(StressRecord<Dim>) + sizeof(ArtificialRecord<Dim>) +
         sizeof(ArtificialChannel<Dim>) + 2 * sizeof(Real) + sizeof(SurfaceParticle) +
         sizeof(LocalIndex) + sizeof(std::uint16_t);
}

/// How many lie within 2 h and the skin of a particle, or of one of those whose centres are up to
/// `wider` spacings from there.
template <int Dim>
Real candidates_of(Real smoothing, Real wider) {
  constexpr Real kSkin = 0.35;
  const Real ball = Dim == 3 ? 4.0 / 3 * kPi : kPi;
  return ball * std::pow((2 + kSkin) * smoothing + wider, Dim);
}

/// Members of a group that shares candidates, in the mean (tests/bench/particles.yaml: 6.5), and
/// how far they are from its middle, in spacings.
constexpr Real kMembers = 6.5, kApart = 0.55;

/// The candidates, and among them the true neighbours: in the plane their row and weights; in space
/// a bit of each candidate, which up to eight particles share.
template <int Dim>
Real neighbour_bytes(Real smoothing) {
  constexpr Real kOwn = sizeof(int) + 2 * sizeof(LocalIndex);
  if (Dim == 2) {
    const Real row = 3 * sizeof(std::int64_t) + sizeof(LocalIndex);
    return kOwn + row + (2 * sizeof(LocalIndex) + sizeof(Real)) * candidates_of<2>(smoothing, 0);
  }
  const Real group = 2 * sizeof(std::int64_t) + sizeof(LocalIndex) +
                     (sizeof(LocalIndex) + 1) * candidates_of<3>(smoothing, kApart);
  return kOwn + sizeof(std::uint8_t) + group / kMembers;
}

/// Candidates as they are found, before they are put in order: in tables that double as they grow.
template <int Dim>
Real search_bytes(Real smoothing) {
  const Real shared =
      Dim == 2 ? candidates_of<2>(smoothing, 0) : candidates_of<3>(smoothing, kApart) / kMembers;
  return sizeof(LocalIndex) * (1.5 * shared + 3);
}

template <int Dim>
constexpr Real contact_node_bytes() {
  return 2 * sizeof(LocalIndex) + sizeof(GlobalId) + 4 * sizeof(Real) + 8 * sizeof(Vec<Dim>);
}

/// Particles of contact: once more while a new table takes over from the old one.
template <int Dim>
constexpr Real contact_particle_bytes() {
  return sizeof(ContactParticle) + contact_node_bytes<Dim>();
}

/// Faces and their nodes, twice while a new table takes over from the old one.
template <int Dim>
Real contact_bytes(std::size_t facets, std::size_t particles, bool bricks) {
  constexpr Real kLists = 8;  // candidates of a face
  const Real node = contact_node_bytes<Dim>();
  const Real face = sizeof(Facet<Dim>) + sizeof(ContactFace<Dim>) + sizeof(FacePlane<Dim>) +
                    sizeof(Vec<Dim>) + 2 * sizeof(SearchBox<Dim>);
  // Records, pushes, friction and memory of contacts, where every face has some: what a wall of
  // 52,880 faces takes beside its lists.
  constexpr Real kTouching = 2.8e3;
  return static_cast<Real>(facets) *
             (2 * (face + node) + kLists * sizeof(ListedFaces) + (bricks ? kTouching : 0.0)) +
         static_cast<Real>(particles) * contact_particle_bytes<Dim>();
}

/// A frame of a lone rank holds places, corners, volumes and weights of all bodies, one array that
/// is written, and of the frame before packed corners and numbers.
Real frame_bytes(std::size_t points, std::size_t cells, int corners) {
  constexpr Real kPointValues = 10, kCellValues = 10;
  return static_cast<Real>(points) * kPointValues * sizeof(Real) +
         static_cast<Real>(cells) * (kCellValues * sizeof(Real) + corners * sizeof(std::int64_t));
}

/// A checkpoint holds the state of all entities as tables, and a part of it twice while it is
/// written, table by table: 1.2 and 1.3 times in runs of 152,400 hexes, 1.5 times in one of 131,544
/// particles, most of whose state is in one table.
template <int Dim>
Real checkpoint_bytes(const Scene<Dim>& scene, int gauss) {
  constexpr Real kPoint = 5 * Dim + 3, kContactNode = 3 * Dim + 3;
  constexpr Real kMaterial = 14;
  constexpr Real kElement = Shape<Dim>::kCorners * Dim + 6;
  constexpr std::size_t kStateValues =
      (sizeof(ParticleState<Dim>) + sizeof(ArtificialChannel<Dim>)) / sizeof(Real);
  constexpr Real kParticle = static_cast<Real>(kStateValues + 2) + kMaterial;
  constexpr Real kTwice = 1.25, kTwiceParticle = 1.5;
  const auto particles = static_cast<Real>(scene.n_particles());
  const Real of_elements = static_cast<Real>(scene.n_points()) * kPoint +
                           static_cast<Real>(scene.n_elements()) * (kElement + gauss * kMaterial);
  const Real of_particles = particles * (kParticle + (scene.contact ? kContactNode : 0));
  return sizeof(Real) * (kTwice * of_elements + kTwiceParticle * of_particles);
}
}  // namespace

Real resident_memory() {
  std::ifstream statm("/proc/self/statm");
  Real total = 0, resident = 0;
  statm >> total >> resident;
  return statm ? resident * static_cast<Real>(sysconf(_SC_PAGESIZE)) : 0;
}

template <int Dim>
MemoryInputs memory_inputs(const Deck& deck, const Scene<Dim>& scene, Real program) {
  MemoryInputs inputs;
  inputs.program = program;
  for (const auto& [name, body] : deck.bodies) {
    const bool full = integration_of(deck, body) != Integration::one_point;
    if (!body.rigid && body.method == deck::Method::fe && full) inputs.gauss = Shape<Dim>::kGauss;
    const auto& erosion = body.element.erosion;
    const bool particles =
        body.method == deck::Method::sph || (erosion && erosion->to == ErodeTo::sph);
    if (particles) inputs.smoothing = std::max(inputs.smoothing, body.sph.smoothing);
    inputs.bricks |= std::holds_alternative<BrickWall>(body.shape.kind);
    inputs.total |= body.sph.formulation == SphFormulation::total;
    inputs.single |= body.sph.pair_precision == PairPrecision::single_precision;
  }
  inputs.checkpoints = deck.output.checkpoint || deck.output.checkpoint_steps > 0;
  if (deck.output.history) inputs.rows = deck.time.end / *deck.output.history;
  inputs.columns = HistoryColumns<Dim>(scene).names().size();
  return inputs;
}

template <int Dim>
MemoryEstimate memory_of(const Scene<Dim>& scene, const MemoryInputs& inputs) {
  MemoryEstimate estimate;
  estimate.program = inputs.program + kBroughtIn;
  for (const auto& solid : scene.solids) {
    const auto points = static_cast<Real>(solid->points().x.size());
    const auto elements = static_cast<Real>(solid->n_elements());
    const auto particles = static_cast<Real>(solid->n_particles());
    const int heat = solid->points().keeps_conduction ? 8 : 6;  // fields of points that conduct
    const Real point = point_bytes<Dim>() + (solid->points().conducts ? heat * sizeof(Real) : 0.0);
    (particles > 0 ? estimate.particles : estimate.elements) += points * point;
    estimate.elements += elements * element_bytes<Dim>(inputs.gauss);
    estimate.particles += particles * particle_bytes<Dim>();
    if (inputs.total) estimate.particles += particles * total_bytes<Dim>();
    if (inputs.single) estimate.particles += particles * single_bytes<Dim>();
    (solid->rides() ? estimate.converted : estimate.neighbours) +=
        particles * neighbour_bytes<Dim>(inputs.smoothing);
  }
  if (scene.contact) {
    estimate.contact =
        contact_bytes<Dim>(scene.contact->n_facets(), scene.n_particles(), inputs.bricks);
  }
  const auto particles = static_cast<Real>(scene.n_particles());
  estimate.passing =
      std::max({particles * search_bytes<Dim>(inputs.smoothing),
                scene.contact ? particles * contact_particle_bytes<Dim>() : 0.0,
                frame_bytes(scene.n_points(), scene.n_elements(), Shape<Dim>::kCorners),
                inputs.checkpoints ? checkpoint_bytes(scene, inputs.gauss) : 0.0});
  // Beside its values a column has a name and exact sums (decks/masonry-arch: 2,181 columns).
  constexpr Real kColumn = 4e3;
  estimate.rows = (inputs.rows * sizeof(Real) + kColumn) * static_cast<Real>(inputs.columns);
  return estimate;
}

template MemoryInputs memory_inputs<2>(const Deck&, const Scene<2>&, Real);
template MemoryInputs memory_inputs<3>(const Deck&, const Scene<3>&, Real);
template MemoryEstimate memory_of<2>(const Scene<2>&, const MemoryInputs&);
template MemoryEstimate memory_of<3>(const Scene<3>&, const MemoryInputs&);

}  // namespace brunt
