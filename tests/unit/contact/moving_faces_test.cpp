// Particles on faces that move, turn and deform. A particle of
// radius r and modulus M on faces of S = M/h has k = phi M (2 r)^(Dim - 2) in series with phi S (2
// r)^(Dim - 1); on faces that have a prescribed motion, its own alone. It overlaps a surface by r
// less its distance, in whatever frame and however the faces are shaped.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

constexpr Real kRadius = 0.25, kModulus = 2e4, kSide = 1e5;  // [m], [Pa], [Pa/m]

/// [N/m] of phi = 1, on faces of elements or on such that have a prescribed motion.
template <int Dim>
Real spring(bool elements) {
  const Real own = Dim == 3 ? kModulus * 2 * kRadius : kModulus;
  const Real face = kSide * std::pow(2 * kRadius, Dim - 1);
  return elements ? own * face / (own + face) : own;
}

template <int Dim>
ContactScene<Dim> scene_with(Real friction) {
  ContactScene<Dim> scene;
  Varying coefficient;
  coefficient.constant = friction;
  scene.options.fallback = {false, 1.0, 0, coefficient};
  scene.options.fallback.initial_overlap = InitialOverlap::press;
  scene.add_group();
  return scene;
}

/// Points and faces of body 0 as given, and a particle at x.
template <int Dim>
void build(ContactScene<Dim>& scene, const std::vector<Vec<Dim>>& nodes,
           const std::vector<std::vector<LocalIndex>>& faces, bool elements, const Vec<Dim>& x) {
  auto& group = scene.groups.front();
  for (const auto& node : nodes) scene.add_point(group, node, elements ? 1.0 : 0.0);
  for (const auto& corners : faces) {
    auto& facet = group.surface.facets.emplace_back();
    facet.node.fill(-1);
    std::copy(corners.begin(), corners.end(), facet.node.begin());
    scene.name(group, facet, elements ? kSide : 0, elements ? 1 : 0);
  }
  scene.add_particle(scene.add_group(), x, kRadius, kModulus, 1);
  scene.start();
}

/// A flat sheet of 8 faces (8 x 8 cells in space) about the origin, of random shape, facing up.
void build_sheet(ContactScene<3>& scene, bool quads, bool elements, const Vec3& x) {
  std::mt19937_64 random(quads ? 5 : 6);
  std::uniform_real_distribution<Real> shift(-0.2, 0.2);
  constexpr LocalIndex n = 8;
  std::vector<Vec3> nodes;
  std::vector<std::vector<LocalIndex>> faces;
  for (LocalIndex j = 0; j <= n; ++j) {
    for (LocalIndex i = 0; i <= n; ++i) {
      nodes.push_back({i - n / 2 + shift(random), j - n / 2 + shift(random), 0});
    }
  }
  for (LocalIndex j = 0; j < n; ++j) {
    for (LocalIndex i = 0; i < n; ++i) {
      const LocalIndex a = j * (n + 1) + i, b = a + n + 1;
      if (quads) {
        faces.push_back({a, a + 1, b + 1, b});
      } else if (random() % 2) {
        faces.push_back({a, a + 1, b + 1}), faces.push_back({a, b + 1, b});
      } else {
        faces.push_back({a, a + 1, b}), faces.push_back({a + 1, b + 1, b});
      }
    }
  }
  build<3>(scene, nodes, faces, elements, x);
}
void build_sheet(ContactScene<2>& scene, bool quads, bool elements, const Vec<2>& x) {
  std::mt19937_64 random(quads ? 5 : 6);
  std::uniform_real_distribution<Real> shift(-0.2, 0.2);
  std::vector<Vec<2>> nodes;
  std::vector<std::vector<LocalIndex>> faces;
  for (LocalIndex i = -4; i <= 4; ++i) nodes.push_back({i + shift(random), 0});
  for (LocalIndex i = 0; i < 8; ++i) faces.push_back({i + 1, i});
  build<2>(scene, nodes, faces, elements, x);
}

/// A motion of the whole: a turn, then a way.
template <int Dim>
struct Frame {
  Eigen::Matrix<Real, Dim, Dim> turn = Eigen::Matrix<Real, Dim, Dim>::Identity();
  Vec<Dim> way = Vec<Dim>::Zero();
  Vec<Dim> operator()(const Vec<Dim>& x) const { return turn * x + way; }
};
Eigen::Matrix<Real, 3, 3> turn_by(Real angle, Vec3) {
  return Eigen::AngleAxis<Real>(angle, Vec3(1, -2, 0.7).normalized()).toRotationMatrix();
}
Eigen::Matrix<Real, 2, 2> turn_by(Real angle, Vec<2>) {
  return Eigen::Rotation2D<Real>(angle).toRotationMatrix();
}

/// Takes all points to their next places in a step and evaluates contact there.
template <int Dim>
void move(ContactScene<Dim>& scene, Real dt,
          const std::function<Vec<Dim>(std::size_t group, std::size_t point)>& place) {
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    auto& p = scene.groups[g].points;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      const Vec<Dim> next = place(g, i);
      p.v[i] = dt > 0 ? Vec<Dim>((next - p.x[i]) / dt) : Vec<Dim>(Vec<Dim>::Zero());
      p.x[i] = next;
      p.f[i].setZero();
    }
  }
  scene.contact->add_forces(dt);
}

/// Forces on all points add up to nothing, and so do their moments about the origin: some
/// roundings of forces, at arms of `size` [m].
template <int Dim>
void expect_balance(const ContactScene<Dim>& scene, Real size) {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  Real sum = 0;
  for (const auto& group : scene.groups) {
    for (std::size_t i = 0; i < group.points.x.size(); ++i) {
      Vec3 x = Vec3::Zero(), f = Vec3::Zero();
      x.template head<Dim>() = group.points.x[i], f.template head<Dim>() = group.points.f[i];
      force += f, moment += x.cross(f), sum += f.norm();
    }
  }
  ASSERT_GT(sum, 0);
  ASSERT_LT(force.norm(), 1e-14 * sum);
  ASSERT_LT(moment.norm(), 1e-14 * sum * size);
}

// A particle 0.04 m deep crosses six cells of a sheet that turns by a degree, and is
// stretched and sheared along itself, in each of 400 steps: k d along the normal, in one contact,
// and nothing along the sheet. Places of up to 10 m in double precision are 1e-15 m off, 5e-14 of
// the depth.
template <int Dim>
void check_crossing(bool quads, bool elements) {
  auto scene = scene_with<Dim>(0);
  const Real depth = 0.04, push = spring<Dim>(elements) * depth;
  Vec<Dim> start = Vec<Dim>::Zero();
  start[0] = -3, start[Dim - 1] = kRadius - depth;
  build_sheet(scene, quads, elements, start);
  const auto nodes = scene.groups[0].points.x;
  for (int step = 0; step <= 400; ++step) {
    Frame<Dim> frame;
    frame.turn = turn_by(step * kPi / 180, Vec<Dim>());
    frame.way[0] = 0.01 * step, frame.way[Dim - 1] = -0.005 * step;
    const Real stretch = 1 + 0.3 * std::sin(0.1 * step), shear = 0.4 * std::sin(0.07 * step);
    move<Dim>(scene, 1e-3, [&](std::size_t group, std::size_t i) {
      Vec<Dim> x = group == 0 ? nodes[i] : start;
      if (group == 0) {
        x[0] *= stretch;
        if (Dim == 3) x[1] += shear * x[0];
      } else {
        x[0] += 6.0 * step / 400;
        if (Dim == 3) x[1] += 1.7 * step / 400;
      }
      return frame(x);
    });
    const Vec<Dim> force = frame.turn.transpose() * scene.force(1);
    ASSERT_EQ(scene.contact->work().contacts, 1u) << step;
    ASSERT_LT((force - push * Vec<Dim>::Unit(Dim - 1)).norm(), 1e-12 * push) << step;
    if (elements) expect_balance(scene, 10);
  }
}

TEST(MovingFaces, AFlatSheetThatDeformsPushesAlike) {
  for (const bool elements : {true, false}) {
    check_crossing<2>(true, elements);
    check_crossing<3>(true, elements);
    check_crossing<3>(false, elements);
  }
}

/// Corners of the unit cube or square, each in the bits of its place, and faces that look out.
std::vector<std::vector<LocalIndex>> box_faces(Vec3) {
  return {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
}
std::vector<std::vector<LocalIndex>> box_faces(Vec<2>) { return {{0, 1}, {1, 3}, {3, 2}, {2, 0}}; }
template <int Dim>
std::vector<Vec<Dim>> box_corners() {
  std::vector<Vec<Dim>> corners(std::size_t{1} << Dim);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    for (std::size_t c = 0; c < Dim; ++c) corners[k][static_cast<LocalIndex>(c)] = k >> c & 1;
  }
  return corners;
}

// About a box whose sides change between 1 and 1.6 m and that turns, a particle feels
// k (r - distance) away from the nearest point, at faces, edges and corners alike, in one contact:
// nowhere does it leak in.
template <int Dim>
void check_box(bool elements) {
  auto scene = scene_with<Dim>(0);
  const auto corners = box_corners<Dim>();
  build<Dim>(scene, corners, box_faces(Vec<Dim>()), elements, Vec<Dim>::Constant(3));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> part(0, 1);
  int touching = 0, at_edges = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Frame<Dim> frame;
    frame.turn = turn_by(6 * part(random), Vec<Dim>());
    Vec<Dim> sides, x;
    for (int c = 0; c < Dim; ++c) {
      frame.way[c] = part(random);
      sides[c] = 1 + 0.6 * part(random);
      x[c] = -kRadius + (sides[c] + 2 * kRadius) * part(random);
    }
    const Vec<Dim> nearest = x.cwiseMax(Vec<Dim>::Zero()).cwiseMin(sides), arm = x - nearest;
    const Real distance = arm.norm();
    if (distance == 0) continue;
    move<Dim>(scene, 0, [&](std::size_t group, std::size_t i) {
      return frame(group == 0 ? Vec<Dim>(corners[i].cwiseProduct(sides)) : x);
    });
    const bool touches = distance < kRadius;
    ASSERT_EQ(scene.contact->work().contacts, touches ? 1u : 0u) << trial;
    const Real push = spring<Dim>(elements) * std::max(kRadius - distance, 0.0);
    const Vec<Dim> force = frame.turn.transpose() * scene.force(1);
    ASSERT_LT((force - push * arm / distance).norm(), 1e-12 * spring<Dim>(elements) * kRadius);
    touching += touches;
    at_edges += touches && (arm.array() != 0).count() > 1;
  }
  EXPECT_GT(touching, 1000);
  EXPECT_GT(at_edges, 100);
}

TEST(MovingFaces, ABoxThatDeformsDoesNotLeakAtEdgesAndCorners) {
  for (const bool elements : {true, false}) {
    check_box<2>(elements);
    check_box<3>(elements);
  }
}

// In the corner of two walls at right angles, which move, a particle touches both.
template <int Dim>
void check_corner(bool elements) {
  auto scene = scene_with<Dim>(0);
  Vec<Dim> x = Vec<Dim>::Constant(1.2), wanted = Vec<Dim>::Zero();
  x[0] = kRadius - 0.03, x[Dim - 1] = kRadius - 0.05;
  wanted[0] = 0.03, wanted[Dim - 1] = 0.05;
  if constexpr (Dim == 2) {
    build<2>(scene, {{3, 0}, {0, 0}, {0, 3}}, {{0, 1}, {1, 2}}, elements, x);
  } else {
    build<3>(scene, {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 3}, {0, 3, 3}},
             {{0, 1, 2, 3}, {0, 3, 5, 4}}, elements, x);
  }
  const auto nodes = scene.groups[0].points.x;
  for (int step = 0; step <= 360; step += 5) {
    Frame<Dim> frame;
    frame.turn = turn_by(step * kPi / 180, Vec<Dim>());
    move<Dim>(scene, 1e-3,
              [&](std::size_t group, std::size_t i) { return frame(group == 0 ? nodes[i] : x); });
    ASSERT_EQ(scene.contact->work().contacts, 2u);
    const Vec<Dim> force = frame.turn.transpose() * scene.force(1) / spring<Dim>(elements);
    ASSERT_LT((force - wanted).norm(), 1e-12 * kRadius) << step;
  }
}

TEST(MovingFaces, ACornerOfTwoWallsTouchesTwice) {
  for (const bool elements : {true, false}) {
    check_corner<2>(elements);
    check_corner<3>(elements);
  }
}

// Pressed by 0.04 m on a sheet, and dragged by `drag` along it, a particle sticks with k s
// or slips with mu k d. Turned with the sheet about an oblique axis, a degree a step, and flown at
// 1e4 m/s, it keeps both forces in the frame of the bodies: to rounding, and in flight to that of
// 10 m a step, 2e-15 m, against 2e-3 m of drag.
template <int Dim>
void check_gripped(bool quads, bool elements, Real drag) {
  auto scene = scene_with<Dim>(0.5);
  const Real depth = 0.04, k = spring<Dim>(elements);
  Vec<Dim> x = Vec<Dim>::Constant(0.2), along = Vec<Dim>::Zero();
  x[Dim - 1] = kRadius - depth;
  along[0] = Dim == 3 ? 0.8 : 1;
  if (Dim == 3) along[1] = -0.6;
  build_sheet(scene, quads, elements, x);
  scene.evaluate();
  const auto nodes = scene.groups[0].points.x;
  const Vec<Dim> dragged = x + drag * along;
  Frame<Dim> frame;
  const auto place = [&](std::size_t group, std::size_t i) {
    return frame(group == 0 ? nodes[i] : dragged);
  };
  move<Dim>(scene, 1e-3, place);
  const Vec<Dim> before = scene.force(1);
  const Vec<Dim> wanted =
      k * depth * Vec<Dim>::Unit(Dim - 1) - std::min(k * drag, 0.5 * k * depth) * along;
  ASSERT_LT((before - wanted).norm(), 1e-12 * wanted.norm());
  for (int step = 1; step <= 360; ++step) {
    frame.turn = turn_by(step * kPi / 180, Vec<Dim>());
    move<Dim>(scene, 1e-3, place);
    const Vec<Dim> back = frame.turn.transpose() * scene.force(1);
    ASSERT_LT((back - before).norm(), 1e-9 * before.norm()) << step;
    if (elements) expect_balance(scene, 10);
  }
  for (int step = 1; step <= 100; ++step) {
    frame.way[0] += 10, frame.way[Dim - 1] -= 3;
    move<Dim>(scene, 1e-3, place);
    const Vec<Dim> back = frame.turn.transpose() * scene.force(1);
    ASSERT_LT((back - before).norm(), 1e-9 * before.norm()) << step;
  }
}

TEST(MovingFaces, AGrippedParticleTurnsAndFliesWithThem) {
  for (const bool elements : {true, false}) {
    for (const Real drag : {0.002, 0.05}) {
      check_gripped<2>(true, elements, drag);
      check_gripped<3>(true, elements, drag);
      check_gripped<3>(false, elements, drag);
    }
  }
}

}  // namespace
}  // namespace brunt
