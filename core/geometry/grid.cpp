#include "core/geometry/grid.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

template <int Dim>
Mesh<Dim> box_grid(const Vec<Dim>& min, const Vec<Dim>& max,
                   const std::array<Layers, Dim>& layers) {
  Mesh<Dim> mesh;
  std::array<int, Dim> n;
  for (std::size_t c = 0; c < Dim; ++c) n[c] = layers[c].n;
  const int nz = Dim == 3 ? n[Dim - 1] : 0;
  const auto index = [&](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };
  mesh.nodes.reserve(slot_of(n[0] + 1) * slot_of(n[1] + 1) * slot_of(nz + 1));
  mesh.elements.reserve(slot_of(n[0]) * slot_of(n[1]) * slot_of(std::max(nz, 1)));
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= n[1]; ++j) {
      for (int i = 0; i <= n[0]; ++i) {
        const int cell[3] = {i, j, k};
        Vec<Dim> x;
        for (int c = 0; c < Dim; ++c) {
          x[c] = layers[c].between(min[c], max[c], cell[c]);
        }
        mesh.nodes.push_back(x);
      }
    }
  }
  for (int k = 0; k < std::max(nz, 1); ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, Shape<Dim>::kCorners> corners;
        for (int layer = 0; layer < Dim - 1; ++layer) {
          const auto at = slot_of(4 * layer);
          corners[at] = index(i, j, k + layer), corners[at + 1] = index(i + 1, j, k + layer);
          corners[at + 2] = index(i + 1, j + 1, k + layer);
          corners[at + 3] = index(i, j + 1, k + layer);
        }
        mesh.elements.push_back(corners);
      }
    }
  }
  mesh.piece.assign(mesh.elements.size(), 0);
  return mesh;
}

namespace {
// Core half width over radius for n_core of n_radius cells: a little more than their share, since
// the ring's cells are compressed towards the rim.
Real core_radius(Real radius, int n_core, int n_radius) {
  return 1.05 * radius * n_core / n_radius;
}

/// Point (u, v) of [-1, 1]^2 on a square with rounded sides: half a square, half a disc.
Vec<2> rounded_square(Real u, Real v, Real r) {
  const Vec<2> square(0.8 * r * u, 0.8 * r * v);
  const Vec<2> disc(r * u * std::sqrt(1 - v * v / 2), r * v * std::sqrt(1 - u * u / 2));
  return 0.5 * (square + disc);
}

/// The same in three dimensions (Nowell's map of the cube to the ball).
Vec3 rounded_cube(const Vec3& u, Real r) {
  const Vec3 s = u.cwiseProduct(u);
  const Vec3 ball(u[0] * std::sqrt(1 - s[1] / 2 - s[2] / 2 + s[1] * s[2] / 3),
                  u[1] * std::sqrt(1 - s[2] / 2 - s[0] / 2 + s[2] * s[0] / 3),
                  u[2] * std::sqrt(1 - s[0] / 2 - s[1] / 2 + s[0] * s[1] / 3));
  return 0.5 * r * (0.7 * u + ball);
}
}  // namespace

Mesh<2> disc_grid(Real radius, int n_radius) {
  const int n_ring = std::max(1, n_radius / 2), n_core = std::max(1, n_radius - n_ring);
  const int m = 2 * n_core;
  const Real r = core_radius(radius, n_core, n_core + n_ring);
  KeyedMesh<2> keyed;
  const auto core = [&](int i, int j) {
    return keyed.node({i, j, 0, 0}, rounded_square(2.0 * i / m - 1, 2.0 * j / m - 1, r));
  };
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < m; ++i) {
      keyed.element({core(i, j), core(i + 1, j), core(i + 1, j + 1), core(i, j + 1)});
    }
  }
  // The rim of the core, counter-clockwise from its lower left corner.
  const auto rim = [&](int k) {
    k %= 4 * m;
    const int side = k / m, s = k % m;
    const int i = side == 0 ? s : side == 1 ? m : side == 2 ? m - s : 0;
    const int j = side == 0 ? 0 : side == 1 ? s : side == 2 ? m : m - s;
    return std::pair{i, j};
  };
  const auto ring = [&](int k, int layer) {
    const auto [i, j] = rim(k);
    if (layer == 0) return core(i, j);
    const Vec<2> inner = rounded_square(2.0 * i / m - 1, 2.0 * j / m - 1, r);
    const Real angle = kPi * (-0.75 + 0.5 * k / m);
    const Vec<2> outer(radius * std::cos(angle), radius * std::sin(angle));
    const Real t = static_cast<Real>(layer) / n_ring;
    return keyed.node({i, j, 0, layer}, (1 - t) * inner + t * outer);
  };
  for (int layer = 0; layer < n_ring; ++layer) {
    for (int k = 0; k < 4 * m; ++k) {
      keyed.element(
          {ring(k, layer), ring(k, layer + 1), ring(k + 1, layer + 1), ring(k + 1, layer)});
    }
  }
  return keyed.mesh;
}

Mesh<2> ring_grid(Real inner, Real outer, int n_radius, int n_around) {
  KeyedMesh<2> keyed;
  const auto node = [&](int k, int layer) {
    k %= n_around;
    const Real angle = 2 * kPi * k / n_around;
    const Real r = inner + (outer - inner) * layer / n_radius;
    return keyed.node({k, layer, 0, 0}, Vec<2>(r * std::cos(angle), r * std::sin(angle)));
  };
  for (int layer = 0; layer < n_radius; ++layer) {
    for (int k = 0; k < n_around; ++k) {
      keyed.element(
          {node(k, layer), node(k, layer + 1), node(k + 1, layer + 1), node(k + 1, layer)});
    }
  }
  return keyed.mesh;
}

Mesh<3> extrude(const Mesh<2>& plane, Real length, const Layers& layers) {
  Mesh<3> mesh;
  const int n = layers.n;
  const int layer = static_cast<int>(plane.nodes.size());
  for (int k = 0; k <= n; ++k) {
    const Real z = layers.between(0, length, k);
    for (const auto& x : plane.nodes) mesh.nodes.emplace_back(x[0], x[1], z);
  }
  for (int k = 0; k < n; ++k) {
    for (const auto& quad : plane.elements) {
      std::array<int, 8> corners;
      for (std::size_t c = 0; c < 4; ++c) {
        corners[c] = quad[c] + k * layer;
        corners[c + 4] = quad[c] + (k + 1) * layer;
      }
      mesh.elements.push_back(corners);
    }
  }
  mesh.piece.assign(mesh.elements.size(), 0);
  return mesh;
}

namespace {
/// Lattice points of one face of a cube of m cells: axis, side 0 or m, and two running indices so
/// that the face is counter-clockwise seen from outside.
std::array<int, 3> face_point(int axis, bool high, int m, int a, int b) {
  std::array<int, 3> p{};
  p[axis] = high ? m : 0;
  p[(axis + 1) % 3] = high ? a : b;
  p[(axis + 2) % 3] = high ? b : a;
  return p;
}
}  // namespace

Mesh<3> ball_grid(Real radius, int n_radius) {
  const int n_ring = std::max(1, n_radius / 2), n_core = std::max(1, n_radius - n_ring);
  const int m = 2 * n_core;
  const Real r = core_radius(radius, n_core, n_core + n_ring);
  KeyedMesh<3> keyed;
  const auto unit = [m](const std::array<int, 3>& p) {
    return Vec3(2.0 * p[0] / m - 1, 2.0 * p[1] / m - 1, 2.0 * p[2] / m - 1);
  };
  const auto node = [&](const std::array<int, 3>& p, int layer) {
    const Vec3 inner = rounded_cube(unit(p), r);
    Vec3 x = inner;
    if (layer > 0) {
      // Equal angles on the rim: the tangent map keeps its quads nearly square.
      Vec3 t;
      for (int c = 0; c < 3; ++c) t[c] = std::tan(kPi / 4 * unit(p)[c]);
      const Real s = static_cast<Real>(layer) / n_ring;
      x = (1 - s) * inner + s * radius * t.normalized();
    }
    return keyed.node({p[0], p[1], p[2], layer}, x);
  };
  for (int k = 0; k < m; ++k) {
    for (int j = 0; j < m; ++j) {
      for (int i = 0; i < m; ++i) {
        keyed.element({node({i, j, k}, 0), node({i + 1, j, k}, 0), node({i + 1, j + 1, k}, 0),
                       node({i, j + 1, k}, 0), node({i, j, k + 1}, 0), node({i + 1, j, k + 1}, 0),
                       node({i + 1, j + 1, k + 1}, 0), node({i, j + 1, k + 1}, 0)});
      }
    }
  }
  for (int face = 0; face < 6; ++face) {
    for (int layer = 0; layer < n_ring; ++layer) {
      for (int a = 0; a < m; ++a) {
        for (int b = 0; b < m; ++b) {
          std::array<int, 8> corners;
          const int da[] = {0, 1, 1, 0}, db[] = {0, 0, 1, 1};
          for (std::size_t c = 0; c < 4; ++c) {
            const auto p = face_point(face / 2, face % 2 == 1, m, a + da[c], b + db[c]);
            corners[c] = node(p, layer);
            corners[c + 4] = node(p, layer + 1);
          }
          keyed.element(corners);
        }
      }
    }
  }
  return keyed.mesh;
}

namespace {
/// The layers as they are counted from the other end.
Layers mirrored(const Layers& layers) {
  Layers other = layers;
  std::reverse(other.at.begin(), other.at.end());
  for (Real& at : other.at) at = 1 - at;
  return other;
}

/// A point for each layer, by arc length along a polyline.
std::vector<Vec<2>> divide(const std::vector<Vec<2>>& line, const Layers& layers) {
  std::vector<Real> length{0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    length.push_back(length.back() + (line[i] - line[i - 1]).norm());
  }
  std::vector<Vec<2>> points{line.front()};
  std::size_t segment = 1;
  for (int k = 1; k < layers.n; ++k) {
    const Real s = layers.between(0, length.back(), k);
    while (segment + 1 < line.size() && length[segment] < s) ++segment;
    const Real t = (s - length[segment - 1]) / (length[segment] - length[segment - 1]);
    points.push_back((1 - t) * line[segment - 1] + t * line[segment]);
  }
  points.push_back(line.back());
  return points;
}
}  // namespace

Mesh<2> transfinite_grid(const std::array<std::vector<Vec<2>>, 4>& sides,
                         const std::array<Layers, 2>& layers) {
  // Coons 1967: sides 0 and 2 run against each other, and so do 1 and 3.
  const auto bottom = divide(sides[0], layers[0]), right = divide(sides[1], layers[1]);
  auto top = divide(sides[2], mirrored(layers[0])), left = divide(sides[3], mirrored(layers[1]));
  std::reverse(top.begin(), top.end());
  std::reverse(left.begin(), left.end());
  const int n[2] = {layers[0].n, layers[1].n};
  Mesh<2> mesh = box_grid<2>(Vec<2>(0, 0), Vec<2>(1, 1), layers);
  std::size_t node = 0;
  for (int j = 0; j <= n[1]; ++j) {
    for (int i = 0; i <= n[0]; ++i) {
      const Real u = layers[0].between(0, 1, i), v = layers[1].between(0, 1, j);
      const auto a = slot_of(i), b = slot_of(j);
      const Vec<2> corners = (1 - u) * (1 - v) * bottom.front() + u * (1 - v) * bottom.back() +
                             u * v * top.back() + (1 - u) * v * top.front();
      Vec<2> x = (1 - v) * bottom[a] + v * top[a] + (1 - u) * left[b] + u * right[b] - corners;
      if (i == 0) x = left[b];
      if (i == n[0]) x = right[b];
      if (j == 0) x = bottom[a];
      if (j == n[1]) x = top[a];
      mesh.nodes[node++] = x;
    }
  }
  return mesh;
}

template Mesh<2> box_grid<2>(const Vec<2>&, const Vec<2>&, const std::array<Layers, 2>&);
template Mesh<3> box_grid<3>(const Vec<3>&, const Vec<3>&, const std::array<Layers, 3>&);

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
