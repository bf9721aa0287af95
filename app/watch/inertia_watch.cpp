#include "app/watch/inertia_watch.hpp"

#include <algorithm>

#include "app/deck/findings.hpp"

namespace brunt {

namespace {
constexpr const char* kTable = "inertia";

std::string percent(Real share) { return deck::short_text(100 * share) + " %"; }

std::string both_texts(const InertiaShare& share) {
  return percent(share.end) + " at the end, " + percent(share.mean) + " as a mean over time";
}
}  // namespace

void InertiaWatch::look(const EnergyLook& energies, Real time) {
  const Real passed = time - last_time_;
  last_time_ = time;
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    sums_[b].kinetic += passed * energies.bodies[b].kinetic;
    sums_[b].work += passed * energies.bodies[b].stress_work;
  }
}

std::vector<InertiaShare> InertiaWatch::shares(const std::vector<std::string>& bodies,
                                               const EnergyLook& end) const {
  const auto over = [](Real kinetic, Real work) { return work > 0 ? kinetic / work : 0; };
  std::vector<InertiaShare> shares;
  Sums all, all_end;
  for (std::size_t b = 0; b < sums_.size() && b < end.bodies.size(); ++b) {
    const Sums& own = sums_[b];
    const auto& last = end.bodies[b];
    if (!(own.work > 0 || last.stress_work > 0)) continue;
    all.kinetic += own.kinetic, all.work += own.work;
    all_end.kinetic += last.kinetic, all_end.work += last.stress_work;
    shares.push_back(
        {bodies[b], over(last.kinetic, last.stress_work), over(own.kinetic, own.work)});
  }
  if (shares.size() > 1) {
    shares.push_back({"all", over(all_end.kinetic, all_end.work), over(all.kinetic, all.work)});
  }
  return shares;
}

void InertiaWatch::save_state(std::vector<StateTable>& tables) const {
  save_row(
      kTable, [&](auto& row) { visit(row, *this); }, tables);
}

void InertiaWatch::load_state(const StateTables& tables) {
  load_row(
      kTable, [&](auto& row) { visit(row, *this); }, tables);
}

std::vector<RunWarning> inertia_warnings(const std::vector<InertiaShare>& shares, Real speed) {
  std::vector<RunWarning> warnings;
  if (speed == 1) return warnings;
  for (const auto& share : shares) {
    if (!(std::max(share.end, share.mean) > InertiaWatch::kMuchInertia)) continue;
    warnings.push_back({"time.process_speed",
                        share.body + ": kinetic energy is " + both_texts(share) +
                            " of the work of its stresses: inertia takes part in what it does, "
                            "unless it only moves as a whole; try a lower time.process_speed"});
  }
  return warnings;
}

std::string inertia_line(const std::vector<InertiaShare>& shares) {
  std::string text;
  for (const auto& share : shares) {
    text += (text.empty() ? "" : "; ") + share.body + " " + both_texts(share);
  }
  return "kinetic energy over the work of stresses: " + text;
}

std::string distortion_text(Real speed) {
  if (speed == 1) return "";
  const std::string s = deck::short_text(speed), square = deck::short_text(speed * speed);
  return "stepped " + s + " times faster: forces of inertia and kinetic energies are " + square +
         " times those of the process, waves cross bodies " + s +
         " times more slowly beside it, artificial viscosity, viscous hourglass control and "
         "dampers of contact resist " +
         s + " times as much; gravity is as it is";
}

}  // namespace brunt
