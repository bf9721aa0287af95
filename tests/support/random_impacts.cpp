#include "tests/support/random_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <vector>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// Numbers that are the same with every standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  Real between(Real low, Real high) {
    return low + (high - low) * static_cast<Real>(engine_() >> 11) * 0x1p-53;
  }
  Real log_between(Real low, Real high) { return std::exp(between(std::log(low), std::log(high))); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  Vec3 direction(bool flat) {
    if (flat) {
      const Real angle = between(0, 2 * kPi);
      return {std::cos(angle), std::sin(angle), 0};
    }
    const Real z = between(-1, 1), angle = between(0, 2 * kPi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  std::mt19937_64 engine_;
};

enum class Method : int { rigid, held, elements, particles };
enum class Form : int { knife, needle, chisel, wedge, box };

/// A polygon in x and y with a thickness along z, its point or edge at the origin, upwards.
struct Shape {
  Form form = Form::box;
  Method method = Method::rigid;
  std::vector<Vec<2>> outline;  ///< [m]
  Real thickness = 0;           ///< [m] from z = 0
  Real size = 0;                ///< [m] of elements and particles
  std::string words;
  Vec3 middle() const {
    Vec<2> sum = Vec<2>::Zero();
    for (const auto& p : outline) sum += p / static_cast<Real>(outline.size());
    return {sum[0], sum[1], 0.5 * thickness};
  }
};

Shape random_shape(Dice& dice, Method method, bool flat) {
  constexpr const char* kForms[] = {"knife", "needle", "chisel", "wedge", "box"};
  constexpr const char* kMethods[] = {"rigid", "held", "fe", "sph"};
  Shape shape;
  shape.method = method;
  shape.form = static_cast<Form>(dice.below(5));
  const bool pointed = shape.form != Form::box;
  Real angle = 0, height = dice.between(0.02, 0.06), tip = 0, width = 0;
  switch (shape.form) {
    case Form::knife:
      angle = dice.log_between(1, 40);
      break;
    case Form::needle:
      angle = dice.log_between(0.5, 6);
      break;
    case Form::chisel:
      angle = dice.between(4, 30);
      break;
    case Form::wedge:
      angle = dice.between(3, 30);
      break;
    case Form::box:
      width = height / dice.log_between(1, 20);
      break;
  }
  const bool deforms = method == Method::elements || method == Method::particles;
  if (pointed) width = 2 * height * std::tan(angle * kPi / 180);
  if (deforms) width = std::max(width, 0.1 * height);
  if (pointed && (deforms || shape.form == Form::wedge)) tip = dice.between(0.2, 0.5) * width;
  const Real w = 0.5 * width, t = 0.5 * tip;
  if (tip > 0 || !pointed) {
    const Real top = pointed ? t : w;
    shape.outline = {{-w, -height}, {w, -height}, {top, 0}, {-top, 0}};
  } else {
    shape.outline = {{-w, -height}, {w, -height}, {0, 0}};
  }
  if (!flat) {
    shape.thickness = shape.form == Form::knife || shape.form == Form::wedge
                          ? dice.between(0.5, 2) * height
                          : dice.between(0.5, 2) * width;
  }
  // Elements of 1:20 where the body is as thin as that; particles, four across at least.
  shape.size = std::max({width / 4, height / 40, shape.thickness / 12});
  std::ostringstream words;
  words << kMethods[static_cast<int>(method)] << ' ' << kForms[static_cast<int>(shape.form)];
  if (pointed) words << ' ' << std::round(10 * angle) / 10;
  if (!pointed) words << " 1:" << std::round(10 * height / width) / 10;
  shape.words = words.str();
  return shape;
}

struct Place {
  Eigen::AngleAxis<Real> turn{0, Vec3::UnitZ()};
  Vec3 shift = Vec3::Zero();  ///< [m]
};

std::vector<Vec3> corners(const Shape& shape, const Place& place) {
  std::vector<Vec3> all;
  for (const auto& p : shape.outline) {
    for (const Real z : {0.0, shape.thickness}) {
      all.push_back(place.turn * Vec3(p[0], p[1], z) + place.shift);
      if (shape.thickness == 0) break;
    }
  }
  return all;
}

/// True unless a plane parts both hulls (Gilbert 1966: the point of their difference nearest to
/// the origin, by steps towards its supports).
bool meet(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  const auto support = [](const std::vector<Vec3>& points, const Vec3& d) {
    return *std::max_element(points.begin(), points.end(),
                             [&](const Vec3& p, const Vec3& q) { return p.dot(d) < q.dot(d); });
  };
  Vec3 x = a[0] - b[0];
  constexpr Real kSmall = 1e-5;  // [m] so near are hulls that overlap, or all but do
  for (int i = 0; i < 20000; ++i) {
    const Vec3 s = support(a, -x) - support(b, x);
    if (s.dot(x) > 0) return false;
    const Vec3 way = s - x;
    x += std::clamp(-x.dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
    if (x.norm() < kSmall) return true;
  }
  return false;
}

Vec3 middle_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const auto& p : points) sum += p;
  return sum / static_cast<Real>(points.size());
}

std::vector<Vec3> scaled(std::vector<Vec3> points, Real factor) {
  const Vec3 middle = middle_of(points);
  for (auto& p : points) p = middle + factor * (p - middle);
  return points;
}

std::string text_of(const Vec3& v, bool flat) {
  std::ostringstream out;
  out.precision(17);
  out << '[' << v[0] << ", " << v[1];
  if (!flat) out << ", " << v[2];
  out << ']';
  return out.str();
}

void write_body(std::ostream& out, const std::string& name, const Shape& shape, const Place& place,
                const Vec3& velocity) {
  const bool flat = shape.thickness == 0;
  out << "  " << name << ":\n";
  if (shape.method == Method::rigid || shape.method == Method::held) out << "    rigid: true\n";
  if (shape.method == Method::particles) out << "    method: sph\n";
  if (shape.method != Method::held) {
    out << "    material: stuff\n    velocity: " << text_of(velocity, flat) << '\n';
  }
  if (shape.method == Method::elements || shape.method == Method::particles) {
    out << "    size: " << shape.size << '\n';
  }
  out << "    shape:\n      polygon:\n        points: [";
  for (std::size_t i = 0; i < shape.outline.size(); ++i) {
    out << (i > 0 ? ", " : "") << '[' << shape.outline[i][0] << ", " << shape.outline[i][1] << ']';
  }
  out << "]\n";
  if (shape.method == Method::elements) out << "        corners: [0, 1, 2, 3]\n";
  if (!flat) out << "        thickness: " << shape.thickness << '\n';
  out << "      rotate: {";
  if (!flat) out << "axis: " << text_of(place.turn.axis(), false) << ", ";
  const Real sign = flat && place.turn.axis()[2] < 0 ? -1 : 1;
  out << "angle: " << sign * place.turn.angle() << "}\n";
  out << "      translate: " << text_of(place.shift, flat) << '\n';
}

/// The turn that brings the point or edge towards `way`, by chance the whole body.
Eigen::AngleAxis<Real> random_turn(Dice& dice, const Vec3& way, bool flat, bool aimed) {
  using Turn = Eigen::Quaternion<Real>;
  const Vec3 lean = aimed ? Vec3(way + 0.2 * dice.direction(flat)) : dice.direction(flat);
  Turn turn = Turn::FromTwoVectors(Vec3::UnitY(), lean.normalized());
  if (flat) {
    const Real angle = std::atan2(-lean[0], lean[1]);
    return {angle, Vec3::UnitZ()};
  }
  turn = turn * Turn(Eigen::AngleAxis<Real>(dice.between(0, 2 * kPi), Vec3::UnitY()));
  return Eigen::AngleAxis<Real>(turn);
}
}  // namespace

Impact random_impact(std::uint64_t seed) {
  Dice dice(seed);
  Impact impact;
  impact.flat = dice.below(2) == 0;
  const bool flat = impact.flat;
  // What is thrown, and what it hits: each kind on each, but particles on particles.
  constexpr std::pair<Method, Method> kPairs[] = {
      {Method::rigid, Method::held},         {Method::rigid, Method::rigid},
      {Method::elements, Method::held},      {Method::elements, Method::rigid},
      {Method::elements, Method::elements},  {Method::rigid, Method::elements},
      {Method::particles, Method::held},     {Method::particles, Method::rigid},
      {Method::particles, Method::elements},
  };
  const auto& [first, second] = kPairs[dice.below(9)];
  for (const Method method : {first, second}) {
    const bool deforms = method == Method::elements || method == Method::particles;
    impact.n_deforming += deforms ? 1 : 0;
  }
  const Shape a = random_shape(dice, first, flat), b = random_shape(dice, second, flat);
  const Vec3 way = dice.direction(flat);
  const bool aimed = dice.below(3) > 0;
  Place of_a, of_b;
  of_a.turn = random_turn(dice, way, flat, aimed);
  of_b.turn = random_turn(dice, -way, flat, aimed && dice.below(2) == 0);
  // Middles of what is aimed meet, but for a tenth of the smaller body.
  const Vec3 target = of_b.turn * Vec3(0, b.middle()[1], b.middle()[2]);
  Vec3 miss = 0.1 * std::min(a.middle().norm(), b.middle().norm()) * dice.direction(flat);
  miss -= miss.dot(way) * way;
  of_b.shift = -target;
  of_a.shift = miss - of_a.turn * Vec3(0, a.middle()[1], a.middle()[2]);
  // Back until they are apart by half a millimetre.
  const auto hull = corners(b, of_b);
  while (meet(corners(a, of_a), hull)) of_a.shift -= 0.0005 * way;
  of_a.shift -= 0.0005 * way;
  const Real speed = dice.log_between(2, 20);
  const Real longest = 2 * std::max(a.middle().norm(), b.middle().norm());
  std::ostringstream out;
  out.precision(17);
  out << "title: impact " << seed << "\ngeometry: " << (flat ? "plane-strain" : "3d")
      << "\ntime: {end: " << longest / speed << ", max_created: 1}\n"
      << "materials: {stuff: {density: 1000, elastic: {E: 1 GPa, nu: 0.3}}}\n"
      << "contact: {default: {friction: 0}}\noutput: {history: " << longest / speed / 100
      << "}\nbodies:\n";
  write_body(out, "a", a, of_a, speed * way);
  write_body(out, "b", b, of_b, Vec3::Zero());
  impact.text = out.str();
  impact.what = std::string(flat ? "2D " : "3D ") + a.words + " on " + b.words +
                (aimed ? " aimed, " : ", ") + std::to_string(std::lround(speed)) + " m/s";
  return impact;
}

namespace {
constexpr Real kShrunkBody = 0.85, kShrunkElement = 0.5;

std::vector<Vec3> points_of(const BodyView& view) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 2 < view.position.size(); i += 3) {
    points.emplace_back(view.position[i], view.position[i + 1], view.position[i + 2]);
  }
  return points;
}

/// Convex parts that stay convex where the body bends: its elements, shrunk, its particles, or all
/// of what is rigid.
std::vector<std::vector<Vec3>> parts_of(const BodyView& view) {
  const std::vector<Vec3> points = points_of(view);
  std::vector<std::vector<Vec3>> parts;
  if (view.corners == 0) {
    for (const Vec3& point : points) parts.push_back({point});
  } else if (view.cell_dimension == 0) {
    parts.push_back(scaled(points, kShrunkBody));
  } else {
    const auto n = static_cast<std::size_t>(view.corners);
    for (std::size_t at = 0; at + n <= view.connectivity.size(); at += n) {
      std::vector<Vec3> corners;
      for (std::size_t c = 0; c < n; ++c) {
        corners.push_back(points[static_cast<std::size_t>(view.connectivity[at + c])]);
      }
      parts.push_back(scaled(std::move(corners), kShrunkElement));
    }
  }
  return parts;
}

bool boxes_meet(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  const auto box_of = [](const std::vector<Vec3>& points) {
    std::pair<Vec3, Vec3> box{points[0], points[0]};
    for (const Vec3& p : points) box = {box.first.cwiseMin(p), box.second.cwiseMax(p)};
    return box;
  };
  const auto of_a = box_of(a), of_b = box_of(b);
  return (of_a.first.array() <= of_b.second.array()).all() &&
         (of_b.first.array() <= of_a.second.array()).all();
}

/// True where bodies are in each other. Hulls of what bends may meet where the bodies do not.
bool have_crossed(const BodyView& a, const BodyView& b) {
  if (!meet(scaled(points_of(a), kShrunkBody), scaled(points_of(b), kShrunkBody))) return false;
  const auto parts_of_b = parts_of(b);
  for (const auto& one : parts_of(a)) {
    for (const auto& other : parts_of_b) {
      if (boxes_meet(one, other) && meet(one, other)) return true;
    }
  }
  return false;
}
}  // namespace

Outcome outcome_of(const Impact& impact, const std::vector<std::string>& overrides) {
  Outcome outcome;
  SceneHooks hooks;
  hooks.moved = [&](std::int64_t step, const std::function<BodyView(Label)>& view) {
    if (outcome.crossed || step % 50 != 0) return;
    outcome.crossed = have_crossed(view(0), view(1));
  };
  const Simulation run = simulate_text(impact.text, overrides, {.threads = 1}, hooks);
  outcome.failure = run.failure;
  outcome.steps = run.steps;
  outcome.created = run.created;
  outcome.lost = run.lost.size();
  const Real largest = run.largest_energy();
  for (const Real pairs : run.column("energy.contact.pairs")) {
    outcome.pairs = std::max(outcome.pairs, std::fabs(pairs) / largest);
  }
  return outcome;
}

}  // namespace brunt::test
