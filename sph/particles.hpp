#pragma once
#include <span>
#include <utility>
#include <vector>

#include "core/conversion.hpp"
#include "core/materials/initial_stress.hpp"
#include "core/materials/initial_temperature.hpp"
#include "core/materials/material.hpp"
#include "core/search/search.hpp"
#include "core/solid.hpp"
#include "sph/conduction.hpp"
#include "sph/force_sums.hpp"
#include "sph/gradient_sums.hpp"
#include "sph/list_watch.hpp"
#include "sph/mirrors.hpp"
#include "sph/neighbour_rows.hpp"
#include "sph/options.hpp"
#include "sph/records.hpp"
#include "sph/spread.hpp"
#include "sph/still_zones.hpp"
#include "sph/thin_moment.hpp"
#include "sph/total.hpp"

namespace brunt {

/// Particles of one or more bodies with the same material and options.
struct ParticleSet {
  const Material* material = nullptr;  ///< outlives the particles
  SphOptions options;
  /// [K] at time 0, which laws see where the state has none; where it depends on the place, the
  /// mean
  Real temperature = 0;
  bool adiabatic = false;                 ///< mechanical work heats the particle
  bool conducts = false;                  ///< particles exchange heat; mechanical work heats them
  bool held = false;                      ///< none ever moves: only their heat is computed
  std::vector<LocalIndex> particle;       ///< ascending; a body lies in one set as a whole
  const InitialStress* stress = nullptr;  ///< at time 0; null: none. It outlives the particles
  /// At time 0, over the place; null: one for all. It outlives the particles.
  const InitialTemperature* temperature_field = nullptr;
};

/// A set with the state of its material points, in the order of `set.particle`.
struct ParticleBlock {
  ParticleSet set;
  MaterialState state;
  /// [J] plastic and compression heat that particles were given; empty where neither arises
  std::vector<Real> heat_given;
};

/// What one particle carries from phase to phase and from step to step. In space lines of the
/// cache are what a pass reads of it: gradients two, limits of the step one, forces one.
template <int Dim>
struct alignas(64) ParticleState {
  /// Where what gradients write ends, and the line begins from which on a pass of forces reads.
  static constexpr std::size_t kGradientBytes = Dim == 3 ? 128 : 64;
  static constexpr std::size_t kCorrectionByte = Dim == 3 ? 64 : 0;
  Real velocity_gradient[Dim * Dim] = {};     ///< [1/s] L at x(n+1) with v(n+1/2), by rows
  Real correction[kSymmetric<Dim>] = {};      ///< [1] B
  Real volume = 0;                            ///< [m^3] at n+1
  Real start_volume = 0;                      ///< [m^3] mass over reference density: V0
  Real ratio = 1;                             ///< [1] volume over start volume
  Real sound_speed = 0;                       ///< [m/s]
  Real speed = 0;                             ///< [m/s] max |v_ij| over neighbours
  Real mu = 0;                                ///< [m/s] max |mu_ij| over neighbours
  InverseSpread spread;                       ///< where gradients are steep; else 0
  Real viscous_power = 0;                     ///< [W] half of what its pairs dissipate
  Vec<Dim> stress_force = Vec<Dim>::Zero();   ///< [N] last added, by channel
  Vec<Dim> viscous_force = Vec<Dim>::Zero();  ///< [N]
  Real stress_work = 0;                       ///< [J] booked since time 0, by channel
  Real viscous_work = 0;                      ///< [J]
};

static_assert(sizeof(ParticleState<3>) == 256 && sizeof(ParticleState<2>) == 192);

/// The third channel of forces: of artificial stress, or of what keeps total-Lagrangian particles
/// from motions that strain nothing.
template <int Dim>
struct ArtificialChannel {
  Vec<Dim> force = Vec<Dim>::Zero();  ///< [N] last added
  Real work = 0;                      ///< [J] booked since time 0
};

template <int Dim>
struct TileStress;  // sph/tile_passes.hpp

template <int Dim>
struct ThinParticle {
  LocalIndex particle = 0;
  ThinMoment<Dim> moment;
};

/// Updated-Lagrangian SPH for solids, all particles of a scene: one group. Only particles of the
/// same piece of a body, or of bodies that are bonded, interact here; others touch through contact.
///   L_i = sum V_j (v_j - v_i) (x) B_i grad W        B_i = [sum V_j (x_j - x_i) (x) grad W]^-1
///   f_i = sum V_i V_j (sigma_i B_i + sigma_j B_j) grad W
/// docs/theory/sph.md (S7), (S8), (S12).
/// Randles & Libersky 1996; Bonet & Lok 1999. The two are conjugate: the neighbours' weights V_j
/// are those of the step's start in both, and each particle's own V_i is that of its stress, so
/// that the power of the forces is exactly minus the sum of V_i sigma_i : L_i.
template <int Dim>
class SphParticles final : public Solid<Dim> {
 public:
  /// points  with positions, velocities, masses, labels; ids ascending. The masses are those of the
  ///         reference density: stress at time 0 changes them
  /// spacing  dp of each particle [m]
  /// sets  each particle in exactly one of them
  /// depth  [m] of a 2D scene, contained in the masses; 1 in 3D
  /// sum_of_piece  by piece, a label of the sum that it shares with others; empty: that of its body
  /// mirrors  planes of symmetry and the sums that lie on them
  /// Throws InitialStressError or InitialTemperatureError where a material cannot begin with those
  /// of its set.
  SphParticles(Points<Dim> points, std::span<const Real> spacing, std::vector<ParticleSet> sets,
               Real depth = 1, std::vector<Label> sum_of_piece = {}, Mirrors<Dim> mirrors = {});
  /// The part of a whole, at time 0, whose particles this rank owns, with copies of those of other
  /// ranks within reach. partition and ranks outlive it. Collective; so are, from here on,
  /// rearrange, update_state and refresh_state.
  SphParticles(const SphParticles& whole, const Partition& partition, const Communicator& ranks);
  SphParticles(const SphParticles&) = delete;
  SphParticles& operator=(const SphParticles&) = delete;

  /// From here on each particle rides on a node of another group, on all ranks, by the ids of the
  /// nodes, in the order of the particles: it sleeps until the node takes over what an element was,
  /// and then has the place, velocity and temperature of the node, which takes its forces and heat.
  /// Particles of no mass sleep.
  void ride_on(ParticleCarrier<Dim>& carrier, std::vector<GlobalId> node);
  const ParticleCarrier<Dim>* carrier() const { return carrier_; }
  bool rides() const override { return carrier_ != nullptr; }
  /// The nodes of riders, by particle; empty where they ride on none.
  std::span<const GlobalId> nodes() const { return node_id_; }
  std::unique_ptr<Solid<Dim>> part(const Partition& partition,
                                   const Communicator& ranks) const override {
    return std::make_unique<SphParticles>(*this, partition, ranks);
  }
  Points<Dim>& points() override { return points_; }
  const Points<Dim>& points() const override { return points_; }
  Surface<Dim>& surface() override { return surface_; }
  void renew_lists() override;
  void update_state(Real dt) override;
  void refresh_state() override;
  void add_internal_forces(Real dt) override;
  void add_conduction(Real dt) override;
  StepLimit stable_step() const override;
  void rearrange() override;
  void begin_lists() override { renew_lists(); }
  void add_totals(Totals<Dim>& totals) const override;
  void check(Real time, const std::vector<std::string>& body_names) const override;
  using Solid<Dim>::view;
  BodyView view(Label body, const WantedFields& wanted) const override;
  std::size_t n_elements() const override { return 0; }
  std::size_t n_particles() const override { return n_owned(); }
  PairCount pair_count() const override { return rows_.count_all(); }
  const GhostPlan& ghosts() const override { return ghosts_; }
  /// A particle and each of its neighbours count one.
  std::vector<Real> point_work() const override;
  void save_state(std::vector<StateTable>& tables) const override;
  void load_state(const StateTables& tables) override;

  /// Skin of the neighbour lists, in units of the largest smoothing length of the group.
  /// docs/theory/sph.md (S26).
  void set_skin(Real skin);
  void set_search(SearchMode mode) { search_ = mode; }
  std::span<ParticleBlock> blocks() { return blocks_; }
  std::span<const ParticleState<Dim>> states() const { return state_; }
  /// A particle of formulation: total whose gradients are not known along all axes; -1: none. It
  /// would have to keep its shape without them for ever.
  LocalIndex thin_total() const;
  /// Of a particle; nothing where none has artificial stress.
  ArtificialChannel<Dim> artificial_of(std::size_t i) const {
    return channel_.empty() ? ArtificialChannel<Dim>{} : channel_[i];
  }
  /// The planes in which any own particle of a body is reflected.
  MirrorAxes mirrored(Label body) const;
  std::span<const Real> smoothing_lengths() const { return smoothing_length_; }  ///< [m] h
  Real skin() const { return watch_.skin(); }  ///< [m] of the lists
  std::int64_t n_searches() const { return n_searches_; }
  /// Own particles of which the last step computed nothing, since they and all near them lie still.
  std::size_t n_left_out() const { return still_.count(); }

 private:
  bool sleeps(std::size_t i) const { return state_[i].start_volume == 0; }
  bool tile_sleeps(const ParticleBlock& block, std::size_t first) const;
  bool is_left_out(const ParticleBlock& block, LocalIndex i) const;
  bool tile_is_left_out(const ParticleBlock& block, std::size_t first) const;
  Real weighed_mass(std::size_t i) const;
  bool take_over();
  void take_share(std::size_t i, const ConvertedShare& share);
  void follow_nodes();
  void give_forces_to_nodes();
  void give_heat_to_nodes();
  bool any_total() const { return !total_.empty(); }
  bool wants_total() const;
  std::vector<LocalIndex> total_particles() const;
  bool is_total(std::size_t i) const { return !total_.empty() && total_[i].volume > 0; }
  bool is_gone(std::size_t i) const { return is_total(i) && total_[i].seen == 0; }
  /// Where gradients are taken.
  std::span<const Vec<Dim>> places() const { return place_.empty() ? points_.x : place_; }
  void refresh_places();
  void start_total();
  void advance_total(Real dt);
  void set_total_volumes(const ParticleBlock& block, std::size_t first, TileStress<Dim>& stress,
                         MaterialTile& tile) const;
  void form_total_stress(const ParticleBlock& block, std::size_t first,
                         TileStress<Dim>& tile) const;
  void refresh_total_records();
  void refresh_total_ghosts();
  void place_total_records();
  ForceSums<Dim> total_forces(const ParticleBlock& block, LocalIndex i,
                              const MonaghanViscosity& viscosity);
  Real bound_of_total(std::size_t i, Real step) const;
  std::size_t n_owned() const { return points_.owned(); }
  void hold(std::size_t n_points, std::size_t n_all);
  void label_sums();
  void publish_spins();
  void publish_materials();
  void take_sets(std::vector<ParticleSet> sets, std::span<const Real> spacing);
  void compress_masses(const std::vector<ParticleSet>& sets);
  void begin_under_stress(ParticleBlock& block);
  Real start_temperature(const ParticleSet& set, std::size_t i) const;
  void begin_temperatures(ParticleBlock& block);
  Real depth_behind_mirrors() const;
  MirrorAxes mirrors_near(std::size_t i, Label sum, Real reach) const;
  void add_mirrored(std::vector<SearchBox<Dim>>& wanted, Real skin, Real reach) const;
  void renew_images(Real reach);
  std::vector<GlobalId> ids_in_rows() const;
  bool images_hold() const;
  void place_images();
  void reflect_motion();
  void reflect_stress();
  void renew_ghosts(Real skin, Real reach);
  void refresh_ghost_positions();
  bool sums_hold(bool mine_hold) const;
  bool lists_hold() const;
  void refresh_motion();
  bool any_single() const;
  bool any_artificial() const;
  Real least_single_spacing() const;
  void set_single_motion(std::size_t i);
  void refresh_single_stress();
  void refresh_gradients();
  void list_thin();
  template <class P>
  ForceRecords<Dim, P> pair_records() const;
  void take_gradients(const ParticleBlock& block, LocalIndex i, const GradientSums<Dim>& sums);
  /// Those of XSPH with what a step leaves out: what moves beside that is not known before.
  enum class Wanted { computed, of_xsph };
  void find_neighbours(Wanted wanted);
  template <class P>
  void find_gradients(const ParticleBlock& block);
  void add_directions(LocalIndex i, std::span<const LocalIndex> row, const Real* weights,
                      Real (&near)[kSymmetric<Dim>]) const;
  template <class P>
  void find_thin_gradient(const ParticleBlock& block, LocalIndex i, ThinMoment<Dim>& thin);
  const ThinMoment<Dim>* thin_of(LocalIndex i) const;
  template <class Take>
  void sum_block_forces(const ParticleBlock& block, const MonaghanViscosity& viscosity,
                        const Take& take);
  void take_forces(const ParticleBlock& block, LocalIndex i, const ForceSums<Dim>& sums, Real dt);
  void move_with_neighbours(Real dt);
  void update_tile(ParticleBlock& block, std::size_t first, Real dt);
  void begin_tile(const ParticleBlock& block, std::size_t first, Real dt, TileStress<Dim>& stress,
                  MaterialTile& tile);
  void turn_thin(const ParticleBlock& block, std::size_t first, Real dt,
                 TileStress<Dim>& tile) const;
  void form_thin_stress(const ParticleBlock& block, std::size_t first, Real dt,
                        TileStress<Dim>& tile) const;
  void publish(ParticleBlock& block, std::size_t first, const TileStress<Dim>& tile);
  void set_size(std::size_t i);
  std::uint64_t slot_hash(const ParticleBlock& block, std::size_t slot) const;
  void add_slots(const ParticleBlock& block, std::size_t first, std::size_t last,
                 Totals<Dim>& totals) const;
  void add_tension(const ParticleBlock& block, std::size_t i, BodySums<Dim>& body) const;
  bool is_in_layer(LocalIndex i) const;
  void seed_step_limits();
  void find_spread(const ParticleBlock& block, LocalIndex i);
  void set_capacities();
  void vary_capacities();
  void start_conduction();
  void take_temperatures();
  void refresh_heat();
  void conduct(std::vector<Real>& rate, std::vector<Real>& conductance);
  void give_mechanical_heat(Real inverse_dt);

  Points<Dim> points_;
  Surface<Dim> surface_;
  std::vector<ParticleBlock> blocks_;
  std::vector<std::uint16_t> block_of_;
  std::vector<ParticleState<Dim>> state_;
  std::vector<ArtificialChannel<Dim>> channel_;  // empty: none has artificial stress
  std::vector<Real> spacing_;                    // [m] dp at time 0, of owned ones
  std::vector<Real> smoothing_length_;           // [m] h, of the volume at n+1 where it adapts
  Real depth_;                                   // [m]
  std::vector<Label> sum_of_piece_;              // empty: a body is one sum
  std::vector<Label> sum_;                       // of each particle, copies and images too
  Mirrors<Dim> mirrors_;
  std::vector<MirrorImage> images_;  // behind all particles in the records that sums read

  std::vector<TotalState<Dim>> total_;          // empty: all are updated
  std::vector<TotalRecord<Dim>> total_record_;  // the same
  std::vector<Vec<Dim>> place_;                 // [m] where gradients are taken; empty: points_.x
  bool keeps_total_rows_ = false;               // their rows are of these lists

  std::vector<MotionRecord<Dim>> motion_;
  std::vector<StressRecord<Dim>> stress_;
  std::vector<ArtificialRecord<Dim>> artificial_;  // empty: none has artificial stress
  std::vector<PlainMoment<Dim>> plain_;  // of owned ones; empty: all gradients are corrected
  std::vector<char> is_thin_;            // of owned ones
  std::vector<ThinParticle<Dim>> thin_;  // those, ascending
  // What those of pair_precision: single read, of all particles; empty where there are none.
  std::vector<MotionRecord<Dim, SinglePairs>> single_motion_;
  std::vector<StressRecord<Dim, SinglePairs>> single_stress_;
  std::vector<ArtificialRecord<Dim, SinglePairs>> single_artificial_;
  SingleUnit unit_;                 // of their lengths: their least spacing in the whole
  std::vector<HeatRecord> heat_;    // empty: heat is not conducted
  std::vector<Real> completeness_;  // [1] of owned particles that conduct
  bool held_ = false;               // nothing of it ever moves: only its heat is computed
  bool settled_ = false;            // rows, weights and corrections of what is held are there

  ParticleCarrier<Dim>* carrier_ = nullptr;  // null: they ride on no nodes
  std::vector<GlobalId> node_id_;            // of each owned particle that rides
  std::vector<LocalIndex> node_;             // its place among the points of the carrier
  std::vector<std::uint32_t> slot_;          // of each owned particle that rides, in its block

  const Communicator* ranks_ = &lone_rank();
  GhostPlan ghosts_;         // copies within reach; made anew with the lists
  std::vector<Label> sums_;  // of the whole, ascending

  NeighbourRows<Dim> rows_;
  ListWatch<Dim> watch_;
  StillZones<Dim> still_;
  Real skin_ratio_ = 0.35;  // [1] of the largest smoothing length; flat optimum
  SearchMode search_ = SearchMode::grid;
  std::int64_t n_searches_ = 0;
};

}  // namespace brunt
