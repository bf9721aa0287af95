#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/elements/element_type.hpp"
#include "core/points.hpp"
#include "core/simd.hpp"

namespace brunt {

template <int Dim>
struct ElementBlock;
template <int Dim>
struct ElementStep;
template <int Dim>
struct ConductionStep;
struct ElementOptions;
struct Thickness;

/// Positions of the corners of one element [m].
template <int Dim>
using CornerPlaces = std::span<const Vec<Dim>>;

/// Volumes [m^3] of the parts of one element that its Gauss points stand for.
struct PartVolumes {
  std::array<Real, kMostCorners> part{};
  int n = 1;
  Real sum() const {
    Real sum = 0;
    for (int g = 0; g < n; ++g) sum += part[g];
    return sum;
  }
};

/// What one kind of element does. Steps call it for tiles of elements; what is asked of single
/// elements belongs to the start, to checks and to frames.
template <int Dim>
class Formulation {
 public:
  virtual ~Formulation() = default;
  virtual const ElementType& type() const = 0;
  /// Adds the elements into which a quad or hex of a mesh is cut: corners, one after another. Two
  /// boxes that share a face cut it alike.
  virtual void cut_box(std::span<const int> box, std::vector<int>& corners) const = 0;

  /// Material points of an element.
  virtual int material_points(const ElementOptions& options) const = 0;
  /// Exact, by Gauss points.
  virtual PartVolumes part_volumes(CornerPlaces<Dim> x, const Thickness& thickness) const = 0;
  /// The same of the four elements from e on.
  virtual std::array<PartVolumes, kLanes> parts_of_four(const ElementBlock<Dim>& block,
                                                        std::size_t e, const Points<Dim>& points,
                                                        const Thickness& thickness) const = 0;
  /// Volume [m^3] as elements of one material point, or of several, measure it.
  virtual Real volume(CornerPlaces<Dim> x, bool one_point, const Thickness& thickness) const = 0;
  /// That of one material point as steps compute it: to rounding the same.
  virtual Real step_volume(CornerPlaces<Dim> x, const Thickness& thickness) const = 0;
  /// The same of the four elements from e on.
  virtual std::array<Real, kLanes> step_volumes(const ElementBlock<Dim>& block, std::size_t e,
                                                const Points<Dim>& points,
                                                const Thickness& thickness) const = 0;
  /// Bits of the four elements from e on that have volume, as steps measure it, and all of whose
  /// parts do. What is not a number has none.
  virtual unsigned have_volume(const ElementBlock<Dim>& block, std::size_t e,
                               const Points<Dim>& points, const Thickness& thickness) const = 0;
  /// Adds `factor` int N_I dV to the sum of each corner I; returns int dV [m^3].
  virtual Real add_corner_volumes(CornerPlaces<Dim> x, const Thickness& thickness, Real factor,
                                  Real* sum) const = 0;
  /// Where material point g of `points` stands in an element.
  virtual Vec<Dim> material_place(CornerPlaces<Dim> x, int points, int g) const = 0;
  /// Gives a block whose elements are measured what its kernels keep besides.
  virtual void start(const Points<Dim>& points, ElementBlock<Dim>& block) const = 0;

  /// Advances the elements of a tile: stress, state, energies, stable step, corner forces.
  virtual void advance(ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step) const = 0;
  /// Sets the stable steps of a tile from x, v and the state as they are.
  virtual void refresh_stable_steps(ElementBlock<Dim>& block, int tile,
                                    const ElementStep<Dim>& step) const = 0;
  /// Heat rates of the kGroup elements from e on (fe/conduction.hpp).
  virtual void conduct(ElementBlock<Dim>& block, std::size_t e,
                       const ConductionStep<Dim>& step) const = 0;
  /// Nodal temperatures [K], interpolated to the material points of the four elements from e on.
  virtual void interpolate_temperature(ElementBlock<Dim>& block, std::size_t e,
                                       const Real* temperature) const = 0;
  /// True where pressure is of volumes about nodes: then steps know ElementStep::node_ratio.
  virtual bool averages_volumes() const { return false; }
  /// Where it does: writes the part of its volume [m^3] that each corner stands for, of a tile of
  /// elements, [element][corner].
  virtual void write_corner_volumes(const ElementBlock<Dim>&, int /*tile*/, const Vec<Dim>* /*x*/,
                                    Real* /*corner_volume*/) const {}
};

}  // namespace brunt
// Tested by tests/unit/fe/tet4_test.cpp.
