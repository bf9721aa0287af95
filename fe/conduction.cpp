#include "fe/conduction.hpp"

#include <algorithm>

#include "fe/element_step.hpp"
#include "fe/gauss_point.hpp"

namespace brunt {
namespace {

template <int Dim>
inline constexpr int kCorners = Shape<Dim>::kCorners;

/// Values and slopes d N_I/d xi_j of the shape functions at the Gauss points, [g][I][j].
template <int Dim>
struct CornerTable {
  Real value[kGauss<Dim>][kCorners<Dim>];
  Real slope[kGauss<Dim>][kCorners<Dim>][Dim];
};
template <int Dim>
constexpr CornerTable<Dim> make_corner_table() {
  CornerTable<Dim> table{};
  for (int g = 0; g < kGauss<Dim>; ++g) {
    const auto at = gauss_place<Dim>(g);
    for (int I = 0; I < kCorners<Dim>; ++I) {
      const auto& sign = Shape<Dim>::kSign[I];
      table.value[g][I] = 1;
      for (int k = 0; k < Dim; ++k) table.value[g][I] *= 0.5 * (1 + sign[k] * at[k]);
      for (int j = 0; j < Dim; ++j) {
        table.slope[g][I][j] = 0.5 * sign[j];
        for (int k = 0; k < Dim; ++k) {
          if (k != j) table.slope[g][I][j] *= 0.5 * (1 + sign[k] * at[k]);
        }
      }
    }
  }
  return table;
}
template <int Dim>
inline constexpr CornerTable<Dim> kCornerTable = make_corner_table<Dim>();

/// int grad N_I . grad N_J dV of four elements [m], I < J.
template <int Dim>
BRUNT_INLINE void gradient_products(const Modal<Dim, Pack>& c, const Thickness& option,
                                    Pack (&K)[kCorners<Dim>][kCorners<Dim>]) {
  for (auto& row : K) {
    for (auto& value : row) value = broadcast<Pack>(0);
  }
  for (int g = 0; g < kGauss<Dim>; ++g) {
    Pack J[Dim][Dim], cof[Dim][Dim];
    slopes(c, g, J);
    cofactors(J, cof);
    Pack determinant = J[0][0] * cof[0][0];
    for (int j = 1; j < Dim; ++j) determinant += J[0][j] * cof[0][j];
    Pack weight = 1.0 / determinant;
    if constexpr (Dim == 2) {
      Pack r = c.m[3][0];
      for (int m = 0; m < 3; ++m) r += kGaussTable<2>.value[g][m] * c.m[m][0];
      weight = weight * (option.constant + option.radial * r);
    }
    Pack b[kCorners<Dim>][Dim];  // determinant times grad N_I
    for (int I = 0; I < kCorners<Dim>; ++I) {
      const auto& slope = kCornerTable<Dim>.slope[g][I];
      for (int j = 0; j < Dim; ++j) {
        b[I][j] = slope[0] * cof[j][0];
        for (int k = 1; k < Dim; ++k) b[I][j] += slope[k] * cof[j][k];
      }
    }
    for (int I = 0; I < kCorners<Dim>; ++I) {
      for (int L = I + 1; L < kCorners<Dim>; ++L) {
        Pack product = b[I][0] * b[L][0];
        for (int j = 1; j < Dim; ++j) product += b[I][j] * b[L][j];
        K[I][L] += weight * product;
      }
    }
  }
}

template <int Dim>
BRUNT_INLINE void gather_temperature(const LocalIndex* corner, const Real* temperature,
                                     Pack (&T)[kCorners<Dim>]) {
  constexpr int n = kCorners<Dim>;
  for (int I = 0; I < n; ++I) {
    T[I] = Pack{temperature[corner[I]], temperature[corner[n + I]], temperature[corner[2 * n + I]],
                temperature[corner[3 * n + I]]};
  }
}

/// Conductivity [W/m/K] at the mean temperature of the corners.
template <int Dim>
BRUNT_INLINE Pack conductivity(const Varying& k, const Pack (&T)[kCorners<Dim>]) {
  if (k.is_constant()) return broadcast<Pack>(k.constant);
  Pack mean = T[0];
  for (int I = 1; I < kCorners<Dim>; ++I) mean += T[I];
  mean = (1.0 / kCorners<Dim>)*mean;
  return Pack{k.at(mean[0]), k.at(mean[1]), k.at(mean[2]), k.at(mean[3])};
}

/// Rate [W] of the plastic and compression heat that the nodes of element k do not have yet; they
/// have it then.
template <int Dim>
BRUNT_INLINE Real take_mechanical_heat(ElementBlock<Dim>& block, std::size_t k, Real inverse_dt) {
  const auto e = static_cast<LocalIndex>(k);
  const Real heat = plastic_heat(block, e) + compression_heat(block, e);
  const Real rate = (heat - block.heat_given[k]) * inverse_dt;
  block.heat_given[k] = heat;
  return rate;
}

template <int Dim>
void add_mechanical_heat(ElementBlock<Dim>& block, std::size_t e, const ConductionStep<Dim>& step) {
  constexpr int n = kCorners<Dim>;
  for (std::size_t k = e; k < e + kLanes; ++k) {
    const Real rate = take_mechanical_heat(block, k, step.inverse_dt);
    if (rate == 0) continue;
    for (std::size_t I = k * n; I < (k + 1) * n; ++I) {
      step.corner_heat[2 * I] += rate * block.heat_share[I];
    }
  }
}

}  // namespace

template <int Dim>
void give_mechanical_heat(ElementBlock<Dim>& block, std::size_t e, Real inverse_dt,
                          Real* corner_heat) {
  constexpr int n = kCorners<Dim>;
  for (std::size_t k = e; k < e + kLanes; ++k) {
    const Real rate = take_mechanical_heat(block, k, inverse_dt);
    for (std::size_t I = k * n; I < (k + 1) * n; ++I) corner_heat[I] = rate * block.heat_share[I];
  }
}

template <int Dim>
void conduct(ElementBlock<Dim>& block, std::size_t e, const ConductionStep<Dim>& step) {
  constexpr int n = kCorners<Dim>;
  const LocalIndex* corner = block.corner.data() + e * n;
  Pack node[n][Dim], T[n], K[n][n], heat[n], sum[n], all[n];
  gather<Dim>(corner, step.x, node);
  gather_temperature<Dim>(corner, step.temperature, T);
  gradient_products<Dim>(modes_of<Dim>(node), step.thickness, K);
  const Pack k = conductivity<Dim>(block.material->conductivity, T);
  for (int I = 0; I < n; ++I) heat[I] = sum[I] = all[I] = broadcast<Pack>(0);
  for (int I = 0; I < n; ++I) {
    for (int J = I + 1; J < n; ++J) {
      const Pack coupling = k * K[I][J];
      const Pack flow = coupling * (T[I] - T[J]);  // from J to I where K_IJ < 0
      heat[I] += flow, heat[J] -= flow;
      sum[I] += coupling, sum[J] += coupling;
      all[I] += vabs(coupling), all[J] += vabs(coupling);
    }
  }
  for (int I = 0; I < n; ++I) {
    const Pack conductance = 0.5 * (all[I] + vabs(sum[I]));  // K_II = - sum of the others
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      Real* out = step.corner_heat + 2 * ((e + lane) * n + static_cast<std::size_t>(I));
      out[0] = heat[I][lane], out[1] = conductance[lane];
    }
  }
  if (step.inverse_dt > 0 && !block.heat_given.empty()) add_mechanical_heat(block, e, step);
}

template <int Dim>
std::vector<const Material*> materials_that_vary(const std::vector<ElementBlock<Dim>>& blocks) {
  std::vector<const Material*> materials;
  for (const auto& block : blocks) {
    if (!block.conducts || !block.material->specific_heat.varies()) continue;
    if (std::find(materials.begin(), materials.end(), block.material) == materials.end()) {
      materials.push_back(block.material);
    }
  }
  return materials;
}

template <int Dim>
void interpolate_temperature(ElementBlock<Dim>& block, std::size_t e, const Real* temperature) {
  constexpr int n = kCorners<Dim>;
  Real* out = block.state.temperature.data() + e * static_cast<std::size_t>(block.gauss);
  const LocalIndex* corner = block.corner.data() + e * n;
  Pack T[n];
  gather_temperature<Dim>(corner, temperature, T);
  for (int g = 0; g < block.gauss; ++g) {
    Pack sum = broadcast<Pack>(0);
    for (int I = 0; I < n; ++I) {
      if (block.gauss == 1) {
        const Real* share = block.heat_share.data() + e * n + I;
        sum += Pack{share[0], share[n], share[2 * n], share[3 * n]} * T[I];
      } else {
        sum += kCornerTable<Dim>.value[g][I] * T[I];
      }
    }
    store(out + kLanes * g, sum);
  }
}

template std::vector<const Material*> materials_that_vary(const std::vector<ElementBlock<2>>&);
template std::vector<const Material*> materials_that_vary(const std::vector<ElementBlock<3>>&);
template void conduct(ElementBlock<2>&, std::size_t, const ConductionStep<2>&);
template void conduct(ElementBlock<3>&, std::size_t, const ConductionStep<3>&);
template void give_mechanical_heat(ElementBlock<2>&, std::size_t, Real, Real*);
template void give_mechanical_heat(ElementBlock<3>&, std::size_t, Real, Real*);
template void interpolate_temperature(ElementBlock<2>&, std::size_t, const Real*);
template void interpolate_temperature(ElementBlock<3>&, std::size_t, const Real*);

}  // namespace brunt
