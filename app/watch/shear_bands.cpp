#include "app/watch/shear_bands.hpp"

#include <algorithm>
#include <numeric>

namespace brunt {

namespace {
constexpr Real kStrainOfBand = 0.3, kRatioOfBand = 3;
constexpr std::size_t kCellsOfBand = 3;
/// [1] Of the largest flow stress: what rounding and the ripple of tables do not reach.
constexpr Real kSoftened = 0.95;

/// Which cells share corners.
class CellsAboutCorners {
 public:
  explicit CellsAboutCorners(const BodyView& view)
      : view_(view), begin_(view.position.size() / 3 + 1, 0), cells_(view.connectivity.size()) {
    for (const std::int64_t corner : view.connectivity) ++begin_[slot_of(corner) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::size_t> next = begin_;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      cells_[next[slot_of(view.connectivity[k])]++] = k / slot_of(view.corners);
    }
  }
  /// beside out: the cells that share a corner with cell c, each once, without it
  void find_beside(std::size_t c, std::vector<std::size_t>& beside) const {
    const auto corners = slot_of(view_.corners);
    beside.clear();
    for (std::size_t k = c * corners; k < (c + 1) * corners; ++k) {
      const auto corner = slot_of(view_.connectivity[k]);
      for (std::size_t n = begin_[corner]; n < begin_[corner + 1]; ++n) {
        if (cells_[n] != c) beside.push_back(cells_[n]);
      }
    }
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  }

 private:
  const BodyView& view_;
  std::vector<std::size_t> begin_, cells_;  // of the cells about each corner, and their end
};

/// [K] of each cell: its own, or the mean of its corners where nodes conduct; empty: none has one.
std::vector<Real> cell_temperatures(const BodyView& view) {
  if (const Field* own = field_named(view.cell_fields, "temperature")) return own->values;
  const Field* nodes = field_named(view.point_fields, "temperature");
  std::vector<Real> mean;
  for (std::size_t c = 0; nodes && c < view.n_cells(); ++c) {
    Real sum = 0;
    for (int k = 0; k < view.corners; ++k) {
      sum += nodes->values[slot_of(view.connectivity[c * slot_of(view.corners) + slot_of(k)])];
    }
    mean.push_back(sum / view.corners);
  }
  return mean;
}

/// How many of the localised cells have softened.
std::size_t cells_in_bands(const BodyView& view, const Material& material) {
  const std::vector<std::size_t> cells = localised_cells(view);
  const std::vector<Real> temperature = cell_temperatures(view);
  if (cells.size() < kCellsOfBand || temperature.empty()) return 0;
  const auto& strain = field_named(view.cell_fields, "eps_p")->values;
  const Real start = *std::min_element(temperature.begin(), temperature.end());
  const auto softened = [&](std::size_t c) {
    return has_softened(material, start, strain[c], temperature[c]);
  };
  return slot_of(std::count_if(cells.begin(), cells.end(), softened));
}
}  // namespace

std::vector<std::size_t> localised_cells(const BodyView& view) {
  const Field* strain = field_named(view.cell_fields, "eps_p");
  std::vector<std::size_t> cells;
  if (!strain || view.corners == 0) return cells;
  const CellsAboutCorners about(view);
  std::vector<std::size_t> beside;
  for (std::size_t c = 0; c < view.n_cells(); ++c) {
    if (!(strain->values[c] > kStrainOfBand)) continue;
    about.find_beside(c, beside);
    if (beside.empty()) continue;
    const auto low = beside.begin() + std::ssize(beside) / 4;
    std::nth_element(beside.begin(), low, beside.end(), [&](std::size_t i, std::size_t j) {
      return strain->values[i] < strain->values[j];
    });
    if (strain->values[c] > kRatioOfBand * strain->values[*low]) cells.push_back(c);
  }
  return cells;
}

bool has_softened(const Material& material, Real start, Real eps_p, Real temperature) {
  if (!material.strength->needs_temperature()) return false;
  constexpr int kSteps = 64;
  MaterialState state = material.initial_state(1, start, true);
  if (state.eps_p.empty() || state.temperature.empty()) return false;
  Real largest = 0, last = 0;
  for (int step = 0; step <= kSteps; ++step) {
    const Real way = static_cast<Real>(step) / kSteps;
    state.eps_p[0] = way * eps_p;
    state.temperature[0] = start + way * (temperature - start);
    last = material.strength->flow_stress(state, 0, start);
    largest = std::max(largest, last);
  }
  return last < kSoftened * largest;
}

template <int Dim>
std::vector<RunWarning> find_shear_bands(const Scene<Dim>& scene, const Deck& deck) {
  std::vector<RunWarning> warnings;
  const WantedFields wanted{std::vector<std::string>{"eps_p", "temperature"}};
  for (Label b = 0; b < deck.bodies.size(); ++b) {
    const std::string& name = deck.bodies[b].name;
    const deck::Body& body = deck.bodies[b].value;
    if (body.rigid || body.method != deck::Method::fe) continue;
    const auto material = std::find_if(scene.materials.begin(), scene.materials.end(),
                                       [&](const auto& one) { return one->name == body.material; });
    if (material == scene.materials.end() || !(*material)->thermal) continue;
    if (!(*material)->strength->needs_temperature()) continue;
    const BodyView view = scene.view(b, wanted);
    if (!scene.ranks->is_root()) continue;
    const std::size_t cells = cells_in_bands(view, **material);
    if (cells == 0) continue;
    warnings.push_back(
        {"bodies." + name + ".size",
         "strain has localised in " + std::to_string(cells) + " elements of '" + name +
             "' that heat has softened, to three times that of cells beside them: the band is as "
             "wide as an element, and what it carries depends on `size`; compare two sizes (brunt "
             "trade), or resolve the band with `heat: conduct`"});
  }
  return warnings;
}

template std::vector<RunWarning> find_shear_bands(const Scene<2>&, const Deck&);
template std::vector<RunWarning> find_shear_bands(const Scene<3>&, const Deck&);

}  // namespace brunt
// Tested by tests/verification/shear_band_test.cpp.
