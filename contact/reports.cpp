/// What the manager shows: sums by pair of bodies, and the contacts of one instant.
#include <algorithm>
#include <map>
#include <span>

#include "contact/implementation.hpp"
#include "contact/slide.hpp"
#include "core/exact_sum.hpp"

namespace brunt {

namespace {
struct PairSums {
  std::array<ExactSum, 3> force;   // [N]
  std::array<ExactSum, 3> torque;  // [N m]
  ExactSum area;                   // [m^2]
  ExactSum heat;                   // [W] of friction
  ExactSum through;                // [W]
  Real max_penetration = 0;        // [m]
  std::int64_t planes = 0;
};

void merge(PairSums& into, const PairSums& from) {
  for (std::size_t c = 0; c < 3; ++c) {
    into.force[c].add(from.force[c]);
    into.torque[c].add(from.torque[c]);
  }
  into.area.add(from.area);
  into.heat.add(from.heat);
  into.through.add(from.through);
  into.max_penetration = std::max(into.max_penetration, from.max_penetration);
  into.planes += from.planes;
}

template <int Dim>
void append(std::vector<Real>& values, const Vec<Dim>& v) {
  for (int c = 0; c < 3; ++c) values.push_back(c < Dim ? v[c] : 0.0);
}

/// What a contact does to its upper side [N].
template <int Dim>
Vec<Dim> force_of(const ContactRecord<Dim>& record, const Friction<Dim>* friction) {
  Vec<Dim> force = (record.spring + record.damping) * record.normal;
  if (friction != nullptr) force += friction->resultant();
  return force;
}

Vec3 moment(const Vec3& arm, const Vec3& force) { return arm.cross(force); }
Vec3 moment(const Vec<2>& arm, const Vec<2>& force) { return {0, 0, cross(arm, force)}; }

/// Its moment about the origin of the coordinates [N m]: friction has a point of its own.
template <int Dim>
Vec3 torque_of(const ContactRecord<Dim>& record, const Friction<Dim>* friction,
               const Vec<Dim>& origin) {
  const Vec<Dim> push = (record.spring + record.damping) * record.normal;
  Vec3 torque = moment(Vec<Dim>(origin + record.point), push);
  if (friction != nullptr) {
    torque += moment(Vec<Dim>(origin + friction->point), friction->resultant());
  }
  return torque;
}

/// Corners of the polygon under a record: of the one common plane of its faces with its point.
template <int Dim>
void append_polygon(const Entities<Dim>& entities, const Section& section,
                    const ContactRecord<Dim>& record, ContactView& view) {
  const auto lower = entities.face_with(record.first), upper = entities.face_with(record.second);
  std::array<CommonPlane<Dim>, 4> planes;
  const int n = common_planes<Dim>(entities.planes[lower], entities.planes[upper], section, planes);
  for (int i = 0; i < n; ++i) {
    const auto& plane = planes[static_cast<std::size_t>(i)];
    if (plane.point != record.point) continue;
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
}  // namespace

template <int Dim>
std::vector<PairReport> ContactManager<Dim>::reports(const Vec<Dim>& origin) const {
  const auto& own = *implementation_;
  const auto& pairs = own.pairs.pairs();
  std::map<std::pair<Label, Label>, std::size_t> place;
  for (std::size_t p = 0; p < pairs.size(); ++p) place[pairs[p]] = p;
  std::vector<PairSums> sums(pairs.size());
  own.records.visit_with_friction(
      [&](const ContactRecord<Dim>& record, const Friction<Dim>* friction) {
        const Label first = std::min(record.lower_body, record.upper_body);
        const Label second = std::max(record.lower_body, record.upper_body);
        const auto known = place.find({first, second});
        if (known == place.end()) return;
        auto& sum = sums[known->second];
        // A body exerts no force on itself as a whole.
        const Real sign = first == second ? 0.0 : (record.upper_body == first ? 1.0 : -1.0);
        const Vec<Dim> force = force_of(record, friction);
        for (int c = 0; c < Dim; ++c) sum.force[static_cast<std::size_t>(c)].add(sign * force[c]);
        if (own.section.geometry != Geometry::axisymmetric) {
          const Vec3 torque = torque_of(record, friction, origin);
          for (int c = 0; c < 3; ++c) {
            sum.torque[static_cast<std::size_t>(c)].add(sign * torque[c]);
          }
        }
        if (friction != nullptr && own.dt_last > 0) sum.heat.add(friction->heat / own.dt_last);
        sum.area.add(record.area);
        sum.max_penetration = std::max(sum.max_penetration, record.penetration);
        ++sum.planes;
      });
  own.records.visit_heat([&](const HeatFlow<Dim>& flow) {
    const Label first = std::min(flow.lower_body, flow.upper_body);
    const Label second = std::max(flow.lower_body, flow.upper_body);
    const auto known = place.find({first, second});
    if (known == place.end() || first == second) return;
    sums[known->second].through.add(flow.upper_body == first ? flow.through : -flow.through);
  });
  own.ranks.all->reduce_all(std::span(sums), merge);
  std::vector<PairReport> reports;
  for (std::size_t p = 0; p < sums.size(); ++p) {
    auto& report = reports.emplace_back();
    report.name = own.pairs.names()[p];
    for (std::size_t c = 0; c < 3; ++c) {
      report.force[c] = sums[p].force[c].value();
      report.torque[c] = sums[p].torque[c].value();
    }
    report.area = sums[p].area.value();
    report.heat_rate = sums[p].through.value();
    report.friction_heat = sums[p].heat.value();
    report.max_penetration = sums[p].max_penetration;
    report.planes = sums[p].planes;
  }
  return reports;
}

template <int Dim>
ContactView ContactManager<Dim>::view() const {
  const auto& own = *implementation_;
  ContactView view;
  own.records.visit_with_friction(
      [&](const ContactRecord<Dim>& record, const Friction<Dim>* friction) {
        if (record.of_particle) {
          append<Dim>(view.position, record.point);
          view.polygon_size.push_back(1);
        } else {
          append_polygon(own.entities, own.section, record, view);
        }
        append<Dim>(view.normal, record.normal);
        append<Dim>(view.force, force_of(record, friction));
        view.pressure.push_back((record.spring + record.damping) / record.area);
        view.penetration.push_back(record.penetration);
        view.body_a.push_back(record.lower_body);
        view.body_b.push_back(record.upper_body);
        const auto key = key_of(record);
        view.key.push_back({key.of_particle, key.first, key.second, key.ordinal});
      });
  return view;
}

template std::vector<PairReport> ContactManager<2>::reports(const Vec<2>&) const;
template std::vector<PairReport> ContactManager<3>::reports(const Vec<3>&) const;
template ContactView ContactManager<2>::view() const;
template ContactView ContactManager<3>::view() const;

}  // namespace brunt
