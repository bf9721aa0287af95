#include "contact/surfaces/nodes.hpp"

#include <omp.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "contact/surfaces/moved_nodes.hpp"
#include "core/parallel/threads.hpp"

namespace brunt {

namespace {
template <class T>
void add_blank(std::vector<T>& field) {
  if constexpr (std::is_same_v<T, Vec3>) {
    field.push_back(Vec3::Zero());
  } else {
    field.emplace_back();
  }
}
}  // namespace

template <int Dim>
void ContactNodes<Dim>::reserve(std::size_t n) {
  surface.reserve(n), point.reserve(n), owned.reserve(n), id.reserve(n);
  mass.reserve(n), x.reserve(n), x_made.reserve(n);
  for_carried([&](auto field, FieldUse) { (this->*field).reserve(n); });
  for_renewed([&](auto field) { (this->*field).reserve(n); });
}

template <int Dim>
void ContactNodes<Dim>::shorten(std::size_t n) {
  surface.resize(n), point.resize(n), owned.resize(n), id.resize(n);
  mass.resize(n), x.resize(n), x_made.resize(n);
  for_carried([&](auto field, FieldUse) { (this->*field).resize(n); });
  for_renewed([&](auto field) { (this->*field).resize(n); });
}

template <int Dim>
LocalIndex ContactNodes<Dim>::add(LocalIndex on_surface, LocalIndex at_point,
                                  const Points<Dim>& points) {
  const auto p = slot_of(at_point);
  const LocalIndex place =
      add_remote(on_surface, points.id[p], points.mass[p], points.x[p], points.v[p]);
  point.back() = at_point;
  owned.back() = at_point < points.n_owned;
  return place;
}

template <int Dim>
LocalIndex ContactNodes<Dim>::add_remote(LocalIndex on_surface, GlobalId of, Real m,
                                         const Vec<Dim>& at, const Vec<Dim>& velocity) {
  surface.push_back(on_surface);
  point.push_back(-1);
  owned.push_back(0);
  id.push_back(of);
  mass.push_back(m);
  x.push_back(at);
  x_made.push_back(at);
  for_carried([&](auto field, FieldUse use) { fit_field(this->*field, use, size()); });
  for_renewed([&](auto field) { add_blank(this->*field); });
  v.back() = velocity;
  return static_cast<LocalIndex>(size()) - 1;
}

template <int Dim>
void ContactNodes<Dim>::begin_motion(const std::vector<Surface<Dim>*>& surfaces) {
  motion = {};
  for_each(size(), kWorthThreads, [&](std::size_t i) {
    if (point[i] < 0) return;
    x[i] = x_made[i] = surfaces[slot_of(surface[i])]->points->x[slot_of(point[i])];
  });
}

template <int Dim>
void ContactNodes<Dim>::choose(const std::vector<char>& is_near) {
  constexpr LocalIndex kLongest = 256;  // so that threads can share them
  near.clear(), far.clear(), near_runs.clear();
  for (std::size_t i = 0; i < size(); ++i) {
    if (point[i] < 0) continue;
    const auto node = static_cast<LocalIndex>(i);
    (is_near[i] != 0 ? near : far).push_back(node);
    if (is_near[i] == 0) continue;
    const NodeRun last = near_runs.empty() ? NodeRun{} : near_runs.back();
    const bool follows = last.n > 0 && last.n < kLongest && node == last.node + last.n &&
                         surface[i] == last.surface && point[i] == last.point + last.n;
    if (!follows) near_runs.push_back({node, surface[i], point[i], 0});
    ++near_runs.back().n;
  }
}

template <int Dim>
void ContactNodes<Dim>::read_motion(const std::vector<Surface<Dim>*>& surfaces) {
  struct Motion {
    const Vec<Dim>*x, *v;
    std::size_t n;
  };
  std::vector<Motion> of;
  of.reserve(surfaces.size());
  for (const auto* from : surfaces) {
    of.push_back({from->points->x.data(), from->points->v.data(), from->points->x.size()});
  }
  const LocalIndex *const place = point.data(), *const whose = surface.data();
  Vec<Dim>*const to_x = x.data(), *const to_v = v.data();
  const Vec<Dim>* const from_x = x_made.data();
  const NodeRun* const runs = near_runs.data();
  const std::size_t n_nodes = x_made.size(), n_runs = near_runs.size();
  motion = {};
  on_threads(near.size() > kWorthThreads, [&] {
    MovedNodes<Dim> part;
    const auto count = slot_of(omp_get_num_threads()), mine = slot_of(omp_get_thread_num());
    const NodeRun* run = runs + n_runs * mine / count;
    const NodeRun* const last = runs + n_runs * (mine + 1) / count;
    while (run != last) {
      const Motion& from = of[slot_of(run->surface)];
      const NodeRun* const next =
          part.read_each(run, last, from.x, from.v, from.n, n_nodes, from_x, to_x, to_v);
      if (next != run) {
        run = next;
        continue;
      }
      part.read(slot_of(run->n), from.x + run->point, from.v + run->point, from_x + run->node,
                to_x + run->node, to_v + run->node);
      ++run;
    }
#pragma omp critical(brunt_contact_bounds)
    motion.take(part.bounds());
  });
  motion.take(bounds_of<Dim>(far.size(), [&](std::size_t k, MotionBounds<Dim>& part) {
    const auto i = slot_of(far[k]);
    to_v[i] = of[slot_of(whose[i])].v[place[i]];
    part.take_velocity(to_v[i]);
  }));
  if (turns || needs_material || conduct) read_matter(surfaces);
}

template <int Dim>
void ContactNodes<Dim>::read_matter(const std::vector<Surface<Dim>*>& surfaces) {
  for_each(near.size(), kWorthThreads, [&](std::size_t k) {
    const auto i = slot_of(near[k]);
    const auto& from = *surfaces[slot_of(surface[i])];
    const auto p = slot_of(point[i]);
    if (turns && p < from.spin.size()) spin[i] = from.spin[p];
    if (needs_material && p < from.particle_material.size())
      material[i] = from.particle_material[p];
    const auto& points = *from.points;
    if (!conduct || !points.conducts) return;
    capacity[i] = points.capacity_varies(p) ? points.heated_mass[p] : points.capacity[p];
  });
}

template <int Dim>
void ContactNodes<Dim>::predict_temperatures(const std::vector<Surface<Dim>*>& surfaces, Real dt) {
  for_each(near.size(), kWorthThreads, [&](std::size_t k) {
    const auto i = slot_of(near[k]);
    if (!owned[i]) return;
    const auto& points = *surfaces[slot_of(surface[i])]->points;
    if (!points.conducts) return;
    const auto p = slot_of(point[i]);
    temperature[i] = points.capacity_varies(p)
                         ? points.temperature_with(p, points.heat[p] + dt * points.heat_rate[p])
                         : points.temperature[p] + dt * points.heat_rate[p] / points.capacity[p];
  });
}

template <int Dim>
void ContactNodes<Dim>::read_temperatures(const std::vector<Surface<Dim>*>& surfaces) {
  if (conduct) temperature = present_temperatures(surfaces);
}

template <int Dim>
std::vector<Real> ContactNodes<Dim>::present_temperatures(
    const std::vector<Surface<Dim>*>& surfaces) const {
  std::vector<Real> present(size(), 0.0);
  for (std::size_t i = 0; i < size(); ++i) {
    const auto& points = *surfaces[slot_of(surface[i])]->points;
    if (!owned[i] || !points.conducts) continue;
    present[i] = points.temperature[slot_of(point[i])];
  }
  return present;
}

template <int Dim>
void ContactNodes<Dim>::inherit(const ContactNodes& old) {
  const auto name_of = [](const ContactNodes& nodes, std::size_t i) {
    return std::pair(nodes.surface[i], nodes.id[i]);
  };
  std::vector<std::size_t> order(old.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return name_of(old, a) < name_of(old, b); });
  for (std::size_t i = 0; i < size(); ++i) {
    const auto name = name_of(*this, i);
    const auto it =
        std::lower_bound(order.begin(), order.end(), name,
                         [&](std::size_t k, const auto& of) { return name_of(old, k) < of; });
    if (it == order.end() || name_of(old, *it) != name) continue;
    for_carried([&](auto field, FieldUse) { (this->*field)[i] = (old.*field)[*it]; });
  }
}

template struct ContactNodes<2>;
template struct ContactNodes<3>;

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
