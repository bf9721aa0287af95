/// Sums of corner forces and of the heat of elements by chunks.
/// - The association is that of the text: sums of each block and each kChunkIds ids by ascending
/// id,
///   then added in order. Forces of one plus noise, summed here by that rule, agree bit for bit,
///   and disagree in some with a plain sum: the test would see another order.
/// - A rank that has the elements about some nodes, its elements anywhere within tiles, finds the
///   same bits there as the whole.
#include "fe/force_chunks.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

/// Force on a node, and behind it its heat rate.
template <int Dim>
using Row = Eigen::Matrix<Real, Dim + 1, 1>;

/// Share of each corner of an element's heat, as kernels read it.
constexpr std::array<Real, kMostCorners * kGroup> make_shares() {
  std::array<Real, kMostCorners * kGroup> share{};
  for (std::size_t k = 0; k < share.size(); ++k) share[k] = 0.1 + 0.01 * static_cast<Real>(k);
  return share;
}
constexpr auto kShares = make_shares();

/// Force of a corner of an element and its part of the element's heat, by its id and its place.
template <int Dim>
Row<Dim> row_of_corner(GlobalId id, std::size_t e, std::size_t I) {
  std::mt19937_64 random(id * 16 + I);
  std::uniform_real_distribution<Real> uniform(0.5, 1.5);
  Row<Dim> row;
  for (int i = 0; i < Dim; ++i) row[i] = uniform(random);
  row[Dim] = static_cast<Real>(id) / 7 * kShares[I * kGroup + e % kGroup];
  return row;
}

template <int Dim>
std::vector<Row<Dim>> forces_by_chunks(std::vector<ElementBlock<Dim>>& blocks, LocalIndex n_owned,
                                       LocalIndex n_points) {
  ForceChunks<Dim> chunks(blocks, n_owned, n_points);
  const auto n = static_cast<std::size_t>(n_points);
  std::vector<Vec<Dim>> f(n, Vec<Dim>::Zero());
  std::vector<Real> heat_rate(n, 0.0);
  std::vector<std::vector<int>> seen;
  for (const auto& block : blocks) seen.emplace_back(static_cast<std::size_t>(block.n_tiles()), 0);
  chunks.add(
      [&](std::size_t b, int tile, const CornerSums& sums) {
        const ElementBlock<Dim>& block = blocks[b];
        ++seen[b][static_cast<std::size_t>(tile)];
        const auto per_tile = static_cast<std::size_t>(block.elements_per_tile());
        for (std::size_t k = 0; k < per_tile; k += kLanes) {
          const std::size_t e = static_cast<std::size_t>(tile) * per_tile + k;
          Pack node[Shape<Dim>::kCorners][Dim];
          SharedHeat<Pack> heat{{}, kShares.data() + e % kGroup};
          for (std::size_t lane = 0; lane < kLanes; ++lane) {
            heat.rate[lane] = static_cast<Real>(block.id[e + lane]) / 7;
          }
          for (std::size_t I = 0; I < Shape<Dim>::kCorners; ++I) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
              const auto force = row_of_corner<Dim>(block.id[e + lane], e + lane, I);
              for (int i = 0; i < Dim; ++i) node[I][i][lane] = force[i];
            }
          }
          add_to_nodes(node, heat, e, sums);
        }
      },
      f, heat_rate);
  for (const auto& tiles : seen) {
    for (const int times : tiles) EXPECT_EQ(times, 1);
  }
  std::vector<Row<Dim>> rows(n);
  for (std::size_t k = 0; k < n; ++k) rows[k] << f[k], heat_rate[k];
  return rows;
}

/// The rule, node by node.
template <int Dim>
std::vector<Row<Dim>> forces_by_rule(const std::vector<ElementBlock<Dim>>& blocks,
                                     std::size_t n_points, bool in_chunks) {
  std::vector<std::map<std::pair<std::size_t, GlobalId>, Row<Dim>>> parts(n_points);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (LocalIndex e = 0; e < blocks[b].n; ++e) {
      const GlobalId id = blocks[b].id[e];
      std::size_t I = 0;
      for (const LocalIndex node : blocks[b].corners_of(e)) {
        const GlobalId chunk = in_chunks ? id / ForceChunks<Dim>::kChunkIds : 0;
        auto [at, is_new] = parts[node].try_emplace({b, chunk}, Row<Dim>::Zero());
        at->second += row_of_corner<Dim>(id, slot_of(e), I++);
      }
    }
  }
  std::vector<Row<Dim>> f(n_points, Row<Dim>::Zero());
  for (std::size_t k = 0; k < n_points; ++k) {
    Row<Dim> sum = Row<Dim>::Zero();
    for (const auto& [key, part] : parts[k]) sum += part;
    f[k] += sum;
  }
  return f;
}

/// Two blocks, the second one's elements with every third id, such that chunks end within tiles.
template <int Dim>
std::vector<ElementBlock<Dim>> two_blocks(const Mesh<Dim>& mesh, const Material& material,
                                          Integration integration,
                                          const std::set<GlobalId>& only = {}) {
  std::vector<ElementBlock<Dim>> blocks;
  for (const std::size_t which : {0u, 1u}) {
    ElementSet<Dim> set = mesh.set;
    set.corners.clear(), set.id.clear(), set.body.clear(), set.piece.clear();
    set.material = &material;
    set.options.integration = integration;
    for (std::size_t e = 0; e < mesh.set.id.size(); ++e) {
      const GlobalId id = mesh.set.id[e];
      if ((id % 3 == 0 ? 1u : 0u) != which) continue;
      if (!only.empty() && only.count(id) == 0) continue;
      set.corners.push_back(mesh.set.corners[e]);
      set.id.push_back(id);
      set.body.push_back(0), set.piece.push_back(0);
    }
    blocks.push_back(make_block(set, mesh.points, Thickness{1, 0}));
  }
  return blocks;
}

template <int Dim>
void expect_the_rule(Integration integration) {
  const Material material = elastic(200e9, 0.3, 7850);
  std::array<int, Dim> cells;
  cells.fill(Dim == 3 ? 15 : 58);  // 3,375 and 3,364 elements: four chunks a block
  const Mesh<Dim> mesh = box_mesh<Dim>(cells, Vec<Dim>::Zero(), Vec<Dim>::Ones());
  const auto n = static_cast<LocalIndex>(mesh.points.x.size());
  auto whole = two_blocks(mesh, material, integration);
  const auto f = forces_by_chunks(whole, n, n);
  const auto rule = forces_by_rule(whole, mesh.points.x.size(), true);
  const auto plain = forces_by_rule(whole, mesh.points.x.size(), false);
  int differ = 0;
  for (std::size_t k = 0; k < f.size(); ++k) {
    EXPECT_EQ(f[k], rule[k]) << k;
    if (f[k] != plain[k]) ++differ;
  }
  EXPECT_GT(differ, 20);  // of some hundred nodes between chunks in 2D, of more in 3D

  const LocalIndex n_owned = n / 3;  // nodes are numbered as they are owned
  std::set<GlobalId> about;
  for (std::size_t e = 0; e < mesh.set.id.size(); ++e) {
    for (const LocalIndex node : mesh.set.corners[e]) {
      if (node < n_owned) about.insert(mesh.set.id[e]);
    }
  }
  about.insert(*about.rbegin() + 700);  // an element that none of them has
  auto part = two_blocks(mesh, material, integration, about);
  const auto f_part = forces_by_chunks(part, n_owned, n);
  for (LocalIndex k = 0; k < n_owned; ++k) EXPECT_EQ(f_part[k], f[k]) << k;
  for (LocalIndex k = n_owned; k < n; ++k) EXPECT_EQ(f_part[k], Row<Dim>::Zero()) << k;
}

TEST(force_chunks, sums_by_the_rule_on_any_rank_3d) { expect_the_rule<3>(Integration::one_point); }
TEST(force_chunks, sums_by_the_rule_on_any_rank_3d_gauss) { expect_the_rule<3>(Integration::full); }
TEST(force_chunks, sums_by_the_rule_on_any_rank_2d) { expect_the_rule<2>(Integration::one_point); }

}  // namespace
}  // namespace brunt
