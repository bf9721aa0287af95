#pragma once
#include "core/conversion.hpp"
#include "core/parallel/partition.hpp"
#include "core/solid.hpp"
#include "fe/corner_gather.hpp"
#include "fe/element_step.hpp"
#include "fe/force_chunks.hpp"

namespace brunt {

struct ErodedElement;
template <int Dim>
struct ErosionState;

/// A group of finite elements: hexahedra in 3D, quadrilaterals in plane strain and axisymmetry.
/// Nodes are material points; elements stand in blocks of one formulation and one law.
template <int Dim>
class FiniteElements final : public Solid<Dim>, public ParticleCarrier<Dim> {
 public:
  /// points  nodes with x, v, id and labels at time 0, x the radius in axisymmetry; their masses
  ///         and x_start are set here
  /// depth   [m] of a plane-strain scene; without meaning elsewhere
  /// Throws PhysicsError where an element has no positive volume.
  FiniteElements(Points<Dim> points, std::vector<ElementSet<Dim>> sets, Geometry geometry,
                 Real depth);
  /// The part of a whole, at time 0, that this rank computes: every element that touches a point
  /// it owns, with copies of the points of other ranks. Collective.
  FiniteElements(const FiniteElements& whole, const Partition& partition,
                 const Communicator& ranks);
  FiniteElements(const FiniteElements&) = delete;
  FiniteElements& operator=(const FiniteElements&) = delete;
  ~FiniteElements() override;

  std::unique_ptr<Solid<Dim>> part(const Partition& partition,
                                   const Communicator& ranks) const override {
    return std::make_unique<FiniteElements>(*this, partition, ranks);
  }
  Points<Dim>& points() override { return points_; }
  const Points<Dim>& points() const override { return points_; }
  Surface<Dim>& surface() override { return surface_; }
  /// Shows contact the materials behind the facets, where friction needs them.
  void update_state(Real) override;
  /// Brings the ratios of volumes about nodes to copies of the nodes.
  void refresh_state() override;
  void add_internal_forces(Real dt) override;
  void add_conduction(Real dt) override;
  StepLimit stable_step() const override;
  /// At time 0, once boundaries have given nodes their velocities, bounds the first step by these.
  void rearrange() override;
  void erode(Real dt) override;
  Points<Dim>& carrying_points() override { return points_; }
  const std::vector<ConvertedShare>& converted() const override { return converted_; }
  bool any_converted() const override { return any_converted_; }
  std::vector<SurfaceMaterial>* shown_materials() override {
    return surface_.needs_material ? &surface_.particle_material : nullptr;
  }
  void add_totals(Totals<Dim>& totals) const override;
  void check(Real time, const std::vector<std::string>& body_names) const override;
  std::string advice(GlobalId entity) const override;
  using Solid<Dim>::view;
  BodyView view(Label body, const WantedFields& wanted) const override;
  std::size_t n_elements() const override;
  AddedMass added_mass(Label body) const override;
  std::size_t n_particles() const override { return 0; }
  const GhostPlan& ghosts() const override { return ghosts_; }
  /// Every element's material points, shared by those of its nodes that are owned here.
  std::vector<Real> point_work() const override;
  void save_state(std::vector<StateTable>& tables) const override;
  void load_state(const StateTables& tables) override;

  const std::vector<ElementBlock<Dim>>& blocks() const { return blocks_; }
  /// For tests and restart: state of the elements.
  std::vector<ElementBlock<Dim>>& blocks() {
    for (auto& block : blocks_) block.wake();
    return blocks_;
  }

 private:
  void start_volumes();
  void update_volumes();
  void sum_volumes(const std::vector<Vec<Dim>>& x);
  /// Of nodes before elements about them go: how many corners, volumes free of stress, ratios.
  struct VolumesBefore {
    std::vector<std::int64_t> offset;
    std::vector<Real> start, ratio;
  };
  void keep_ratios(const VolumesBefore& before, const std::vector<Vec<Dim>>& x);
  void save_volumes(std::vector<StateTable>& tables) const;
  void load_volumes(const StateTables& tables);
  void make_blocks(std::vector<ElementSet<Dim>> sets);
  void refresh_steps();
  void set_capacities();
  void make_rigid();
  void start_conduction();
  void interpolate_temperatures();
  void vary_capacities();
  void sum_conduction();
  void conduct();
  void keep_conduction();
  void find_elements_of_facets();
  void start_erosion();
  std::vector<ErodedElement> failed_elements() const;
  std::vector<LocalIndex> let_points_go(const std::vector<ErodedElement>& going, Real dt);
  void find_last_work(const std::vector<Vec<Dim>>& x_before, Real dt,
                      std::vector<ErodedElement>& mine);
  void convert(const std::vector<ErodedElement>& going, const std::vector<Vec<Dim>>& x_before);
  void rebuild(bool with_state);
  void free_points(bool time_goes_on);
  void clear_born();
  void add_eroded(Totals<Dim>& totals) const;
  void save_eroded(std::vector<StateTable>& tables) const;
  void load_eroded(const StateTables& tables);
  void order_corners();
  ElementStep<Dim> element_step(Real dt);

  Points<Dim> points_;
  Thickness thickness_;
  std::vector<ElementBlock<Dim>> blocks_;
  CornerGather gather_;  ///< empty where nothing but forces is summed at nodes
  ForceChunks<Dim> force_chunks_;
  std::size_t n_corners_ = 0;      ///< of all blocks, padding included
  std::vector<Vec<2>> node_heat_;  ///< [W], [W/K] of each node, while they are summed
  std::vector<Real>
      corner_heat_;  ///< [W], [W/K] [element][corner][2]; empty: heat is not conducted
  /// Where elements average volumes, by node: volume [m^3] of those about it free of stress, and
  /// the ratio [1] of the present one to it; else empty.
  std::vector<Real> start_volume_, node_ratio_;
  bool averages_volumes_ = false;    ///< some elements do, on whichever rank
  std::vector<Real> corner_volume_;  ///< [m^3] [element][corner]
  std::vector<Vec<1>> node_volume_;  ///< [m^3] of each node, while they are summed
  bool stepped_ = false;             ///< steps are those of the last motion, or of a checkpoint
  bool held_ = false;                ///< nothing of it ever moves: only its heat is computed
  Surface<Dim> surface_;
  /// Block and element behind each facet; empty until contact needs their materials.
  std::vector<std::pair<std::size_t, LocalIndex>> element_of_facet_;
  std::unique_ptr<ErosionState<Dim>> erosion_;  ///< null: nothing of it erodes
  std::vector<ConvertedShare> converted_;       ///< of this step
  bool any_converted_ = false;                  ///< in this step, on any rank
  GhostPlan ghosts_;
  const Communicator* ranks_ = nullptr;  ///< null: this rank has the whole
};

}  // namespace brunt
