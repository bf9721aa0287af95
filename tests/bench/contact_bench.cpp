/// Cost of contact on one core: two rough sheets of n x n quads, one turned, and a block of
/// particles on one of them. Prints nanoseconds a face, candidate, contact, in time of the
/// processor; medians of five runs.
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "contact/manager.hpp"

namespace {

using namespace brunt;

struct Body {
  Points<3> points;
  Surface<3> surface;

  void add_point(const Vec3& x, Label body) {
    points.id.push_back(points.id.size());
    points.body.push_back(body);
    points.piece.push_back(0);
    points.mass.push_back(1);
    points.x.push_back(x);
    points.x_start.push_back(x);
    for (auto* field : {&points.v, &points.a, &points.f}) field->push_back(Vec3::Zero());
    points.integration.push_back(0);
    ++points.n_owned;
  }
};

/// n x n quads of size 1 with noise, turned by an angle about z.
void make_sheet(int n, Real z, bool up, Real angle, Label label, std::mt19937_64& random,
                Body& body) {
  std::uniform_real_distribution<Real> noise(-0.1, 0.1);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const Real x = i - 0.5 * n + noise(random), y = j - 0.5 * n + noise(random);
      const Real c = std::cos(angle), s = std::sin(angle);
      body.add_point(Vec3(c * x - s * y, s * x + c * y, z + 0.2 * noise(random)), label);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const LocalIndex a = j * (n + 1) + i, b = a + n + 1;
      auto& facet = body.surface.facets.emplace_back();
      facet.node = {a, a + 1, b + 1, b};
      if (!up) std::swap(facet.node[1], facet.node[3]);
      facet.id = (GlobalId{label} << 40) | body.surface.facets.size() << 3;
      facet.body = label;
      facet.stiffness = 1e9, facet.areal_mass = 500, facet.depth = 1;
    }
  }
  body.surface.points = &body.points;
}

/// Four layers of n x n particles of spacing 1, the first at a height.
void make_particles(int n, Real height, Label label, Body& body) {
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const auto point = static_cast<LocalIndex>(body.points.x.size());
        body.add_point(Vec3(i - 0.5 * n + 0.3, j - 0.5 * n + 0.3, k + height), label);
        body.surface.particles.push_back({point, 0.5, 1e9});
      }
    }
  }
  body.surface.points = &body.points;
}

template <class Work>
Real median_seconds(const Work& work) {
  std::vector<Real> times;
  for (int run = 0; run < 5; ++run) {
    const std::clock_t start = std::clock();
    work();
    times.push_back(static_cast<Real>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  return times[2];
}

void report(const char* name, const std::vector<Surface<3>*>& surfaces, std::size_t entities) {
  ContactOptions options;
  ContactManager<3> contact(options, Geometry::three_d, surfaces, {"a", "b"});
  const Real build = median_seconds([&] { contact.rearrange(); });
  const Real step = median_seconds([&] { contact.add_forces(1e-9); });
  const auto work = contact.work();
  std::printf(
      "%-10s %8zu entities %9zu candidates %8zu contacts | tables and lists %6.0f ns/entity"
      " | step %6.0f ns/contact %5.0f ns/candidate %6.0f ns/entity\n",
      name, entities, work.candidates, work.contacts, build / static_cast<Real>(entities) * 1e9,
      step / static_cast<Real>(std::max<std::size_t>(work.contacts, 1)) * 1e9,
      step / static_cast<Real>(work.candidates) * 1e9, step / static_cast<Real>(entities) * 1e9);
}

}  // namespace

int main() {
  omp_set_num_threads(1);
  for (const int n : {32, 64, 128, 256}) {
    std::mt19937_64 random(3);
    const auto faces = static_cast<std::size_t>(2 * n * n);
    for (const Real gap : {-0.06, 0.3}) {
      Body lower, upper;
      make_sheet(n, 0, true, 0, 0, random, lower);
      make_sheet(n, gap, false, 0.3, 1, random, upper);
      report(gap < 0 ? "touching" : "open", {&lower.surface, &upper.surface}, faces);
    }
    for (const Real height : {0.45, 0.55}) {
      Body sheet, block;
      make_sheet(n, 0, true, 0, 0, random, sheet);
      make_particles(n, height, 1, block);
      report("particles", {&sheet.surface, &block.surface}, static_cast<std::size_t>(5 * n * n));
    }
  }
  return 0;
}
