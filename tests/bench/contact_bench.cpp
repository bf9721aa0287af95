/// Cost of contact on one core: two rough sheets of n x n quads, one turned, apart, pressed, and
/// rubbing; a block of particles on one of them; the same in a domain a million times as large, and
/// with three faces stretched a thousand times. Prints nanoseconds in time of the processor,
/// medians of five builds and of 25 steps. contact_bench [MOST FACES [PART OF A NAME]]
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>
#include <string_view>

#include "contact/manager/manager.hpp"

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
    for (auto* field : {&points.x_rest, &points.v, &points.a, &points.f}) {
      field->push_back(Vec3::Zero());
    }
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
        body.surface.add_particle(point, 0.5, {1e9});
      }
    }
  }
  body.surface.points = &body.points;
}

/// Of `work` alone; `prepare` runs before each.
template <class Prepare, class Work>
Real median_seconds(std::size_t runs, const Prepare& prepare, const Work& work) {
  std::vector<Real> times;
  while (times.size() < runs) {
    prepare();
    const std::clock_t start = std::clock();
    work();
    times.push_back(static_cast<Real>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  return times[runs / 2];
}

/// One face of a body of its own, far from all others.
void add_far_face(Real far, Body& body) {
  for (const auto& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}) {
    body.add_point(Vec3::Constant(far) + corner, 2);
  }
  auto& facet = body.surface.facets.emplace_back();
  facet.node = {0, 1, 2, 3};
  facet.id = GlobalId{2} << 40;
  facet.body = 2;
  facet.stiffness = 1e9, facet.areal_mass = 500, facet.depth = 1;
  body.surface.points = &body.points;
}

/// Pulls three corners of a sheet of n x n faces out a thousand times as far as a face is wide.
void stretch(int n, Body& sheet) {
  const auto last = sheet.points.x.size() - 1;
  for (const std::size_t k : {std::size_t{0}, static_cast<std::size_t>(n), last}) {
    const Vec3 out = 1000 * Vec3(sheet.points.x[k][0], sheet.points.x[k][1], 0).normalized();
    for (auto* x : {&sheet.points.x[k], &sheet.points.x_start[k]}) *x += out;
  }
}

struct Cost {
  Real build = 0, step = 0;  // [ns] an entity
};

/// A step of 1 s in which what lies above has moved by `slip` [m]: it keeps sliding.
Cost report(const char* name, const std::vector<Body*>& bodies, std::size_t entities, Real mu,
            Real slip) {
  ContactOptions options;
  options.fallback.initial_overlap = InitialOverlap::press;
  if (mu > 0) options.fallback.coulomb.friction.emplace().constant = mu;
  std::vector<Surface<3>*> surfaces;
  for (auto* body : bodies) surfaces.push_back(&body->surface);
  ContactManager<3> contact(options, Geometry::three_d, surfaces, {"a", "b", "far"});
  const auto move = [&] {
    auto& points = bodies[1]->points;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      points.v[i] = Vec3(slip, 0, 0);
      points.x[i] += points.v[i];
    }
  };
  const auto evaluate = [&] { contact.add_forces(1); };
  evaluate();  // from then on to rearrange is to make tables and lists, and nothing else
  const Real build = median_seconds(
      5, [] {}, [&] { contact.rearrange(); });
  move(), evaluate();
  const auto before = contact.work();
  const Real step = median_seconds(25, move, evaluate);
  const auto work = contact.work();
  // To and fro by more than any skin: lists alone are made anew, of what comes and goes nothing.
  Real way = 1;
  const auto jump = [&] {
    for (auto& x : bodies[1]->points.x) x[0] += way;
    way = -way;
  };
  const Real renewed = median_seconds(6, jump, evaluate);
  const Real n = static_cast<Real>(entities);
  std::printf(
      "%-22s %8zu entities %9zu candidates %8zu contacts | tables and lists %5.0f, lists %5.0f"
      " ns/entity | step"
      " %5.0f ns/contact %4.0f ns/candidate %5.0f ns/entity%s\n",
      name, entities, work.candidates, work.contacts, build / n * 1e9, (renewed - step) / n * 1e9,
      step / static_cast<Real>(std::max<std::size_t>(work.contacts, 1)) * 1e9,
      step / static_cast<Real>(work.candidates) * 1e9, step / n * 1e9,
      work.builds > before.builds ? ", lists included" : "");
  std::fflush(stdout);
  return {build / n * 1e9, step / n * 1e9};
}

enum class Change { none, domain, stretched };

/// What is measured: cases with a word in their name.
struct Chosen {
  std::string word;
  bool operator()(const char* name) const {
    return std::string_view(name).find(word) != std::string_view::npos;
  }
};

/// Two sheets of n x n faces, so far apart.
Cost sheets(const Chosen& chosen, const char* name, int n, Real gap, Real mu,
            Change change = Change::none) {
  if (!chosen(name)) return {};
  std::mt19937_64 random(3);
  Body lower, upper, far;
  make_sheet(n, 0, true, 0, 0, random, lower);
  make_sheet(n, gap, false, 0.3, 1, random, upper);
  std::vector<Body*> bodies{&lower, &upper};
  // A hundred times as long, wide and high as the sheets are.
  if (change == Change::domain) add_far_face(100.0 * n, far), bodies.push_back(&far);
  if (change == Change::stretched) stretch(n, lower);
  const auto faces = static_cast<std::size_t>(2 * n * n);
  return report(name, bodies, faces, mu, mu > 0 ? 1e-5 : 0);
}

void particles(const Chosen& chosen, const char* name, int n, Real height, Real mu) {
  if (!chosen(name)) return;
  std::mt19937_64 random(3);
  Body sheet, block;
  make_sheet(n, 0, true, 0, 0, random, sheet);
  make_particles(n, height, 1, block);
  report(name, {&sheet, &block}, static_cast<std::size_t>(5 * n * n), mu, mu > 0 ? 1e-5 : 0);
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  const int most = argc > 1 ? std::atoi(argv[1]) : 140000;
  const Chosen chosen{argc > 2 ? argv[2] : ""};
  for (const int n : {23, 71, 224, 708}) {
    if (2 * n * n > most) break;
    sheets(chosen, "apart: rejected", n, 0.3, 0);
    sheets(chosen, "pressed", n, -0.06, 0);
    const Cost plain = sheets(chosen, "rubbing", n, -0.06, 0.3);
    particles(chosen, "particles near a face", n, 0.55, 0);
    particles(chosen, "particles on faces", n, 0.45, 0);
    particles(chosen, "particles that rub", n, 0.45, 0.3);
    if (n < 100 || !chosen("rubbing, ")) continue;
    const Cost large = sheets(chosen, "rubbing, domain x 1e6", n, -0.06, 0.3, Change::domain);
    const Cost odd = sheets(chosen, "rubbing, 3 stretched", n, -0.06, 0.3, Change::stretched);
    std::printf("domain x 1e6: lists x %.2f, step x %.2f; 3 stretched: lists x %.2f, step x %.2f\n",
                large.build / plain.build, large.step / plain.step, odd.build / plain.build,
                odd.step / plain.step);
  }
  return 0;
}
