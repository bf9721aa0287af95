#include "fe/gauss_kernel.hpp"

namespace brunt {

template <int Dim>
void refresh_box_steps(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  const std::size_t first = slot_of(index) * block.elements_per_tile();
  for (int k = 0; k < block.elements_per_tile(); k += kLanes) {
    const std::size_t e = first + k;
    const gauss::Group<Dim, Pack> group{block, step, e, block.point(static_cast<LocalIndex>(e), 0),
                                        0,     false};
    gauss::GaussWork<Dim, Pack> w;
    load_modes(group, w);
    Pack E[Shape<Dim>::kActive][Dim], G[Dim][Dim];
    volume_gradient(w.c, E);
    volume_times_gradient<Dim, Pack>(w.u, E, G);
    const Pack size = measure<Dim, Pack>(w.c, E);
    if (block.gauss > 1) {
      Pack square = broadcast<Pack>(0);
      for (int g = 0; g < kGauss<Dim>; ++g) {
        Pack J[Dim][Dim], cof[Dim][Dim];
        slopes(w.c, g, J);
        cofactors(J, cof);
        const Pack determinant = determinant_of<Dim>(J, cof);
        square += gauss::squared_cofactors(cof, determinant);
      }
      w.norm = gauss::gauss_norm(w.c, square, step.thickness);
    } else {
      Pack hoop = broadcast<Pack>(0);
      if constexpr (Dim == 2) {
        const Thickness& option = step.thickness;
        hoop = 0.5 * option.radial / (option.constant + option.radial * w.c.m[3][0]);
      }
      w.norm = operator_norm<Dim, Pack>(E, 1.0 / size, hoop);
    }
    w.rho = load(block.mass.data() + e) / load(block.element_volume.data() + e);
    const Pack bulk =
        block.gauss == 1 ? load(block.state.bulk.data() + e) : gauss::largest_bulk(group);
    store_stable_step<Shape<Dim>>(block, e, w.norm, w.norm.template height<Shape<Dim>>(), w.rho,
                                  bulk, (1.0 / step.dt) * trace(G) / size);
  }
}

template void advance_gauss<2, Pack>(ElementBlock<2>&, int, const ElementStep<2>&);
template void advance_gauss<3, Pack>(ElementBlock<3>&, int, const ElementStep<3>&);
template void refresh_box_steps(ElementBlock<2>&, int, const ElementStep<2>&);
template void refresh_box_steps(ElementBlock<3>&, int, const ElementStep<3>&);

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
