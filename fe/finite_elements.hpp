#pragma once
#include "core/solid.hpp"
#include "fe/corner_gather.hpp"
#include "fe/element_step.hpp"

namespace brunt {

/// A group of finite elements: hexahedra in 3D, quadrilaterals in plane strain and axisymmetry.
/// Nodes are material points; elements stand in blocks of one formulation and one law.
template <int Dim>
class FiniteElements final : public Solid<Dim> {
 public:
  /// points  nodes with x, v, id and labels at time 0, x the radius in axisymmetry; their masses
  ///         and x_start are set here
  /// depth   [m] of a plane-strain scene; without meaning elsewhere
  /// Throws PhysicsError where an element has no positive volume.
  FiniteElements(Points<Dim> points, const std::vector<ElementSet<Dim>>& sets, Geometry geometry,
                 Real depth);
  FiniteElements(const FiniteElements&) = delete;
  FiniteElements& operator=(const FiniteElements&) = delete;

  Points<Dim>& points() override { return points_; }
  const Points<Dim>& points() const override { return points_; }
  Surface<Dim>& surface() override { return surface_; }
  void update_state(Real) override {}
  void add_internal_forces(Real dt) override;
  StepVote stable_step() const override;
  bool must_rearrange(Real) const override { return false; }
  void rearrange() override {}
  void add_totals(Totals<Dim>& totals) const override;
  void check(Real time, const std::vector<std::string>& body_names) const override;
  BodyView view(Label body) const override;
  std::size_t n_elements() const override;
  std::size_t n_particles() const override { return 0; }
  void save_state(std::vector<StateTable>& tables) const override;
  void load_state(const StateTables& tables) override;

  const std::vector<ElementBlock<Dim>>& blocks() const { return blocks_; }
  /// For tests and restart: state of the elements.
  std::vector<ElementBlock<Dim>>& blocks() { return blocks_; }

 private:
  ElementStep<Dim> element_step(const ElementBlock<Dim>& block, Real dt);

  Points<Dim> points_;
  Thickness thickness_;
  std::vector<ElementBlock<Dim>> blocks_;
  CornerGather gather_;
  std::vector<LocalIndex> axis_;    ///< nodes on the axis of an axisymmetric scene
  std::vector<Real> corner_force_;  ///< [N] [element][corner][Dim], blocks one after another
  Surface<Dim> surface_;
};

}  // namespace brunt
