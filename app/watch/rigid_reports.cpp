#include "app/watch/rigid_reports.hpp"

#include <array>
#include <span>

#include "core/exact_sum.hpp"

namespace brunt {

template <int Dim>
std::optional<RigidPlace<Dim>> rigid_place(const Scene<Dim>& scene, Label body, Real time) {
  const auto center = scene.rigid_centers.find(body);
  if (center == scene.rigid_centers.end()) return std::nullopt;
  for (const auto& group : scene.rigid_motions.all()) {
    for (const auto& motion : group.motions) {
      const bool held = &motion == &group.motions.back();
      if (held || motion.body != body) continue;
      return RigidPlace<Dim>{motion.position(center->second, time),
                             motion.velocity_at(center->second, time)};
    }
  }
  return RigidPlace<Dim>{center->second, Vec<Dim>::Zero()};
}

namespace {
/// The pieces of each body together; torques about the centre of mass of all.
template <int Dim>
void report_free(const FreeBodies<Dim>& bodies, std::map<Label, RigidReport>& reports) {
  struct Whole {
    int pieces = 0;
    Real mass = 0;               // [kg]
    Vec3 moment = Vec3::Zero();  // [kg m]
  };
  std::map<Label, Whole> wholes;
  for (const auto& body : bodies.all()) {
    auto& whole = wholes[body.body];
    ++whole.pieces;
    whole.mass += body.state.mass;
    whole.moment += body.state.mass * body.state.x;
  }
  for (const auto& body : bodies.all()) {
    const Whole& whole = wholes.at(body.body);
    auto& report = reports[body.body];
    report.force += body.force;
    report.torque += body.torque;
    report.one_piece = whole.pieces == 1;
    report.rotation = rotation_vector(body.state.turn);
    report.spin = body.state.spin();
    if (report.one_piece) continue;
    report.torque += (body.state.x - whole.moment / whole.mass).cross(body.force);
  }
}

/// Resultants on what is held or has a prescribed motion, and how it lies.
template <int Dim>
void report_prescribed(const typename RigidMotions<Dim>::Group& rigid, const Scene<Dim>& scene,
                       Real time, std::map<Label, RigidReport>& reports) {
  struct Sums {
    std::array<ExactSum, 6> sum;
  };
  std::map<Label, std::size_t> number;
  std::map<Label, Vec3> about;
  for (const Label body : rigid.bodies) {
    number.try_emplace(body, number.size());
    about[body] = -in_space<Dim>(scene.origin);
    const auto place = rigid_place(scene, body, time);
    auto& report = reports[body] = {};
    report.position = in_space<Dim>(place->position);
    report.velocity = in_space<Dim>(place->velocity);
  }
  for (const auto& motion : rigid.motions) {
    const auto place = reports.find(motion.body);
    const bool held = &motion == &rigid.motions.back();
    if (held || place == reports.end()) continue;
    const Eigen::Quaternion<Real> turn(Eigen::AngleAxis<Real>(motion.spin * time, motion.axis));
    place->second.rotation = rotation_vector(turn);
    place->second.spin = motion.spin * motion.axis;
    about[motion.body] = in_space<Dim>(motion.center_at(time));
  }
  std::vector<Sums> sums(number.size());
  const auto& points = *rigid.points;
  for (std::size_t i = 0; i < points.owned(); ++i) {
    const auto found = number.find(points.body[i]);
    if (found == number.end() || points.f[i].squaredNorm() == 0) continue;
    const Vec3 force = in_space<Dim>(points.f[i]);
    const Vec3 torque = (in_space<Dim>(points.x[i]) - about[points.body[i]]).cross(force);
    for (int c = 0; c < 3; ++c) {
      const auto k = slot_of(c);
      sums[found->second].sum[k].add(force[c]);
      sums[found->second].sum[3 + k].add(torque[c]);
    }
  }
  scene.ranks->reduce_all(std::span(sums), [](Sums& a, const Sums& b) {
    for (std::size_t c = 0; c < a.sum.size(); ++c) a.sum[c].add(b.sum[c]);
  });
  for (const auto& [body, k] : number) {
    for (int c = 0; c < 3; ++c) {
      reports[body].force[c] = sums[k].sum[c].value();
      reports[body].torque[c] = sums[k].sum[3 + c].value();
    }
  }
}
}  // namespace

template <int Dim>
std::map<Label, RigidReport> rigid_reports(const Scene<Dim>& scene, Real time) {
  std::map<Label, RigidReport> reports;
  for (const auto& rigid : scene.rigid_motions.all()) {
    report_prescribed<Dim>(rigid, scene, time, reports);
  }
  if (scene.rigid) report_free(*scene.rigid, reports);
  return reports;
}

template std::optional<RigidPlace<2>> rigid_place<2>(const Scene<2>&, Label, Real);
template std::optional<RigidPlace<3>> rigid_place<3>(const Scene<3>&, Label, Real);
template std::map<Label, RigidReport> rigid_reports<2>(const Scene<2>&, Real);
template std::map<Label, RigidReport> rigid_reports<3>(const Scene<3>&, Real);

}  // namespace brunt
