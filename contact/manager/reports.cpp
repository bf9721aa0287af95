/// What the manager shows: sums by pair of bodies, and the contacts of one instant.
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "contact/law/spring_slider.hpp"
#include "contact/manager/implementation.hpp"
#include "core/exact_sum.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
/// Temperatures of both sides of contacts, where they keep one.
struct MeanTemperature {
  ExactSum area;              // [m^2] of both sides
  ExactSum area_temperature;  // [m^2 K]
  Real hottest = 0;           // [K]

  void add(const MeanTemperature& other) {
    area.add(other.area);
    area_temperature.add(other.area_temperature);
    hottest = std::max(hottest, other.hottest);
  }
};

struct PairSums {
  std::array<ExactSum, 3> force;      // [N]
  std::array<ExactSum, 3> torque;     // [N m]
  ExactSum area;                      // [m^2]
  ExactSum heat;                      // [W] of friction
  ExactSum through;                   // [W]
  MeanTemperature touching, passing;  // of contacts with force; of those through which heat passes
  Real max_penetration = 0;           // [m]
  std::int64_t planes = 0;
};

/// Keeps the first of two; what did not hold goes before what did.
void merge(LostReport& into, const LostReport& from) {
  const std::int64_t let_go = into.let_go + from.let_go;
  const std::int64_t from_behind = into.from_behind + from.from_behind;
  const std::int64_t crossed = into.crossed + from.crossed;
  const bool into_held = !into.any(), from_held = !from.any();
  if (std::tie(from_held, from.time, from.key) < std::tie(into_held, into.time, into.key)) {
    into = from;
  }
  into.let_go = let_go, into.from_behind = from_behind, into.crossed = crossed;
}

void merge(PairSums& into, const PairSums& from) {
  for (std::size_t c = 0; c < 3; ++c) {
    into.force[c].add(from.force[c]);
    into.torque[c].add(from.torque[c]);
  }
  into.area.add(from.area);
  into.heat.add(from.heat);
  into.through.add(from.through);
  into.touching.add(from.touching);
  into.passing.add(from.passing);
  into.max_penetration = std::max(into.max_penetration, from.max_penetration);
  into.planes += from.planes;
}

template <int Dim>
void append(std::vector<Real>& values, const Vec<Dim>& v) {
  for (int c = 0; c < 3; ++c) values.push_back(c < Dim ? v[c] : 0.0);
}

Vec3 moment(const Vec3& arm, const Vec3& force) { return arm.cross(force); }
Vec3 moment(const Vec<2>& arm, const Vec<2>& force) { return {0, 0, cross(arm, force)}; }

/// visit(x, force) of all that a contact does to its upper side [m], [N]: friction has a point of
/// its own, and so has each node of faces at an angle.
template <int Dim, class Visit>
void visit_forces(const ContactNodes<Dim>& nodes, const WholeRecord<Dim>& whole,
                  const Visit& visit) {
  const auto& record = whole.record;
  visit(record.point, Vec<Dim>((record.spring + record.damping) * record.normal));
  if (whole.push != nullptr) {
    // A particle is the upper side, and comes first.
    const bool faces = record.kind == ContactKind::face_face;
    for (auto k = faces ? whole.push->n_lower : 0; k < (faces ? record.n_nodes : 1); ++k) {
      const auto at = slot_of(record.node[slot_of(k)]);
      visit(nodes.x[at], whole.push->force[slot_of(k)]);
    }
  }
  if (whole.friction != nullptr) visit(whole.friction->point, whole.friction->resultant());
}

/// What a contact does to its upper side [N].
template <int Dim>
Vec<Dim> force_of(const ContactNodes<Dim>& nodes, const WholeRecord<Dim>& whole) {
  Vec<Dim> sum = Vec<Dim>::Zero();
  visit_forces(nodes, whole, [&](const Vec<Dim>&, const Vec<Dim>& force) { sum += force; });
  return sum;
}

/// Its moment about the origin of the coordinates [N m].
template <int Dim>
Vec3 torque_of(const ContactNodes<Dim>& nodes, const WholeRecord<Dim>& whole,
               const Vec<Dim>& origin) {
  Vec3 sum = Vec3::Zero();
  visit_forces(nodes, whole, [&](const Vec<Dim>& x, const Vec<Dim>& force) {
    sum += moment(Vec<Dim>(origin + x), force);
  });
  return sum;
}

/// Takes in the temperatures of both sides of a contact, a record or a flow of heat: weights of one
/// side are negative.
/// temperature  [K] by node
template <class Contact>
void add_temperatures(const Contact& contact, const std::vector<Real>& temperature,
                      MeanTemperature& mean) {
  Real side[2] = {0, 0};
  for (std::size_t k = 0; k < slot_of(contact.n_nodes); ++k) {
    const Real w = contact.weight[k];
    side[w < 0 ? 0 : 1] += std::fabs(w) * temperature[slot_of(contact.node[k])];
  }
  for (const Real T : side) {
    if (!(T > 0)) continue;
    mean.area.add(contact.area);
    mean.area_temperature.add(contact.area * T);
    mean.hottest = std::max(mean.hottest, T);
  }
}

/// Corners of the polygon under a record: of the one common plane of its faces with its point.
template <int Dim>
void append_polygon(const Entities<Dim>& entities, const Section& section,
                    const ContactRecord<Dim>& record, ContactView& view) {
  const auto lower = entities.face_with(record.first), upper = entities.face_with(record.second);
  Planes<Dim> planes;
  const int n = common_planes<Dim>(entities.planes[lower], entities.planes[upper], section, planes,
                                   {.opening = record.opening, .whole = record.bonded});
  for (int i = 0; i < n; ++i) {
    const auto& plane = planes[slot_of(i)];
    if (plane.ordinal != record.ordinal) continue;
    for (int c = 0; c < plane.polygon.size; ++c) {
      const Vec<2>& p = plane.polygon[c];
      append<Dim>(view.position, plane.origin + p[0] * plane.axis_1 + p[1] * plane.axis_2);
    }
    view.polygon_size.push_back(plane.polygon.size);
    return;
  }
  append<Dim>(view.position, record.point);
  view.polygon_size.push_back(1);
}

PairReport report_of(const PairSums& sums, const std::string& name) {
  PairReport report;
  report.name = name;
  for (std::size_t c = 0; c < 3; ++c) {
    report.force[c] = sums.force[c].value();
    report.torque[c] = sums.torque[c].value();
  }
  report.area = sums.area.value();
  report.heat_rate = sums.through.value();
  report.friction_heat = sums.heat.value();
  const bool passes = sums.passing.area.value() > 0;
  const MeanTemperature& mean = passes ? sums.passing : sums.touching;
  report.temperature_max = mean.hottest;
  if (const Real area = mean.area.value(); area > 0) {
    report.temperature_mean = mean.area_temperature.value() / area;
  }
  report.max_penetration = sums.max_penetration;
  report.planes = sums.planes;
  return report;
}
}  // namespace

template <int Dim>
std::vector<PairReport> ContactManager<Dim>::reports(const Vec<Dim>& origin) const {
  const auto& own = *implementation_;
  const auto& reported = own.setup.pairs.reported();
  std::map<std::pair<Label, Label>, std::size_t> place;
  for (std::size_t p = 0; p < reported.size(); ++p) place[own.setup.pairs.pairs()[reported[p]]] = p;
  std::vector<PairSums> sums(reported.size());
  std::vector<Real> temperature;
  if (own.search.entities().nodes.conduct) {
    temperature = own.search.entities().nodes.present_temperatures(own.setup.surfaces);
    own.search.imports().refresh_temperatures(temperature);
  }
  const auto& nodes = own.search.entities().nodes;
  own.evaluation.records().visit_whole([&](const WholeRecord<Dim>& whole) {
    const auto& record = whole.record;
    const Label first = std::min(record.lower_body, record.upper_body);
    const Label second = std::max(record.lower_body, record.upper_body);
    const auto known = place.find({first, second});
    if (known == place.end()) return;
    auto& sum = sums[known->second];
    // A body exerts no force on itself as a whole.
    const Label reported_on = own.setup.pairs.reported_body(reported[known->second]);
    const Real sign = first == second ? 0.0 : (record.upper_body == reported_on ? 1.0 : -1.0);
    const Vec<Dim> force = force_of(nodes, whole);
    for (int c = 0; c < Dim; ++c) sum.force[slot_of(c)].add(sign * force[c]);
    if (own.setup.section.geometry != Geometry::axisymmetric) {
      const Vec3 torque = torque_of(nodes, whole, origin);
      for (int c = 0; c < 3; ++c) {
        sum.torque[slot_of(c)].add(sign * torque[c]);
      }
    }
    if (whole.friction != nullptr && own.last.dt > 0) {
      sum.heat.add(whole.friction->heat / own.last.dt);
    }
    sum.area.add(record.area);
    sum.max_penetration = std::max(sum.max_penetration, record.penetration);
    ++sum.planes;
    if (!temperature.empty()) add_temperatures(record, temperature, sum.touching);
  });
  own.evaluation.records().visit_heat([&](const HeatFlow<Dim>& flow) {
    const Label first = std::min(flow.lower_body, flow.upper_body);
    const Label second = std::max(flow.lower_body, flow.upper_body);
    const auto known = place.find({first, second});
    if (known == place.end()) return;
    if (flow.h_area > 0) add_temperatures(flow, temperature, sums[known->second].passing);
    if (first == second) return;
    const Label reported_on = own.setup.pairs.reported_body(reported[known->second]);
    sums[known->second].through.add(flow.upper_body == reported_on ? flow.through : -flow.through);
  });
  own.setup.ranks.all->reduce_all(std::span(sums),
                                  [](PairSums& into, const PairSums& from) { merge(into, from); });
  std::vector<PairReport> reports;
  for (std::size_t p = 0; p < sums.size(); ++p) {
    reports.push_back(report_of(sums[p], own.setup.pairs.name(reported[p])));
  }
  return reports;
}

template <int Dim>
std::vector<LostPair> ContactManager<Dim>::lost_pairs(const Vec<Dim>& origin) const {
  const auto& own = *implementation_;
  std::map<std::size_t, LostReport> found;
  for (const auto& contact : own.memory.lost()) {
    const auto pair = own.setup.pairs.find(contact.lower_body, contact.upper_body);
    if (!pair) continue;
    const auto is = [&](std::uint32_t how) { return contact.key.ordinal == how ? 1 : 0; };
    LostReport one{is(kLetGo), is(kFromBehind), is(kCrossed), contact.time, contact.depth,
                   {},         contact.key};
    for (int c = 0; c < Dim; ++c) {
      one.point[slot_of(c)] = origin[c] + contact.point[c];
    }
    merge(found[*pair], one);
  }
  Packer mine;
  for (const auto& [pair, report] : found) mine << pair << report;
  std::map<std::size_t, LostReport> of_all;
  for (const Bytes& bytes : own.setup.ranks.all->all_gather(mine.take())) {
    Unpacker from(bytes);
    while (!from.done()) {
      std::size_t pair = 0;
      LostReport report;
      from >> pair >> report;
      merge(of_all[pair], report);
    }
  }
  std::vector<LostPair> lost;
  lost.reserve(of_all.size());
  for (const auto& [pair, report] : of_all) lost.push_back({own.setup.pairs.name(pair), report});
  return lost;
}

namespace {
/// [m] since time 0, of a joint with a largest closure; 0 for all else.
template <int Dim>
Real largest_closure(const ContactMemory<Dim>& memory, const ContactKey& key) {
  const auto* const known = memory.closures().find(key);
  Real closed = known == nullptr ? 0.0 : known->closed;
  ContactKey last = key;
  last.ordinal = ~std::uint32_t{0};
  for (const auto& tie : memory.ties().range(key, last)) closed = std::max(closed, tie.closed);
  return closed;
}
}  // namespace

template <int Dim>
ContactView ContactManager<Dim>::view() const {
  const auto& own = *implementation_;
  ContactView view;
  own.evaluation.records().visit_whole([&](const WholeRecord<Dim>& whole) {
    const auto& record = whole.record;
    const auto key = key_of(record);
    if (record.kind != ContactKind::face_face) {
      append<Dim>(view.position, record.point);
      view.polygon_size.push_back(1);
    } else {
      append_polygon(own.search.entities(), own.setup.section, record, view);
    }
    append<Dim>(view.normal, record.normal);
    append<Dim>(view.force, force_of(own.search.entities().nodes, whole));
    view.pressure.push_back((record.spring + record.damping) / record.area);
    view.penetration.push_back(record.penetration);
    view.bonded.push_back(record.bonded ? 1 : 0);
    view.max_closure.push_back(largest_closure(own.memory, key));
    view.body_a.push_back(record.lower_body);
    view.body_b.push_back(record.upper_body);
    view.key.push_back({static_cast<GlobalId>(key.kind), key.first, key.second, key.ordinal});
  });
  return view;
}

template std::vector<PairReport> ContactManager<2>::reports(const Vec<2>&) const;
template std::vector<PairReport> ContactManager<3>::reports(const Vec<3>&) const;
template std::vector<LostPair> ContactManager<2>::lost_pairs(const Vec<2>&) const;
template std::vector<LostPair> ContactManager<3>::lost_pairs(const Vec<3>&) const;
template ContactView ContactManager<2>::view() const;
template ContactView ContactManager<3>::view() const;

}  // namespace brunt
