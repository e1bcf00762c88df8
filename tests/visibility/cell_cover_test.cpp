// Covers of cells of the screen grid: patches of facets against points of the cell.
#include "visibility/common/cell_cover.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

constexpr double kMargin = 2;
const auto kAnyFacet = [](const Facet&) { return true; };

/// Triangles over lattice points.
struct Mesh {
  ProjectedScene scene;
  std::vector<ProjectedVertex>& vertices = scene.vertices;
  std::vector<Facet> facets;
  std::vector<CellFacet> list;

  std::uint32_t add_vertex(int x, int y, double z) {
    vertices.push_back({{x, y}, z});
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }

  void add_facet(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const double area = orientation(vertices[a].p, vertices[b].p, vertices[c].p);
    if (area == 0) return;
    if (area < 0) std::swap(b, c);
    const auto [near, far] = std::minmax({vertices[a].z, vertices[b].z, vertices[c].z});
    const auto id = static_cast<std::uint32_t>(facets.size());
    facets.push_back({{a, b, c}, id, round_down(near), round_up(far), 1e-6f, 0});
    list.push_back({id, round_down(near), {}});
  }

  /// A square of n x n vertices `spacing` steps apart, its corner at (x, y), each square cut along a random diagonal.
  void add_sheet(int x, int y, int n, int spacing, double z, double roughness, double holes, std::mt19937& rng) {
    std::uniform_real_distribution<double> unit(0, 1);
    std::uniform_int_distribution<int> jitter(-spacing / 3, spacing / 3);
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        add_vertex(x + i * spacing + jitter(rng), y + j * spacing + jitter(rng), z + roughness * unit(rng));
    for (int j = 0; j + 1 < n; ++j)
      for (int i = 0; i + 1 < n; ++i) {
        if (unit(rng) < holes) continue;
        const std::uint32_t a = first + static_cast<std::uint32_t>(j * n + i), b = a + 1;
        const std::uint32_t c = a + static_cast<std::uint32_t>(n), d = c + 1;
        if (unit(rng) < 0.5) {
          add_facet(a, b, d);
          add_facet(a, d, c);
        } else {
          add_facet(a, b, c);
          add_facet(b, d, c);
        }
      }
  }

  bool contains(const Facet& f, double x, double y) const {
    const FacetFunctions g(f, vertices.data());
    return g.ex[0] * x + g.ey[0] * y + g.e[0] >= 0 && g.ex[1] * x + g.ey[1] * y + g.e[1] >= 0 &&
           g.ex[2] * x + g.ey[2] * y + g.e[2] >= 0;
  }

  double nearest_depth(double x, double y) const {
    double z = std::numeric_limits<double>::infinity();
    for (const Facet& f : facets)
      if (contains(f, x, y)) z = std::min(z, FacetFunctions(f, vertices.data()).depth(x, y));
    return z;
  }

  /// As the grid has it.
  std::vector<CellFacet> by_depth() const {
    std::vector<CellFacet> sorted = list;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const CellFacet& a, const CellFacet& b) { return a.z_near < b.z_near; });
    return sorted;
  }

  std::optional<float> cover(const CellSquare& cell) const {
    const std::vector<CellFacet> sorted = by_depth();
    return CellCover(scene, facets, kMargin).find(sorted.data(), sorted.size(), cell, kAnyFacet);
  }
};

TEST(CellCover, AFoldCoversNothing) {
  Mesh mesh;
  const auto a = mesh.add_vertex(0, 0, 1), b = mesh.add_vertex(1000, 1000, 1);
  mesh.add_facet(a, b, mesh.add_vertex(0, 1000, 1));
  mesh.add_facet(a, b, mesh.add_vertex(200, 900, 2));
  EXPECT_FALSE(mesh.cover({400, 400, 200}).has_value()) << "both facets lie on one side of their common side";
}

TEST(CellCover, WhatLiesBehindTheCoverChangesNothing) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 rng(seed);
    Mesh mesh;
    mesh.add_sheet(0, 0, 12, 100, 10, 1, 0, rng);
    const auto alone = mesh.cover({400, 400, 300});
    ASSERT_TRUE(alone.has_value());
    // Some begin before the cover ends, some behind it.
    mesh.add_sheet(0, 0, 12, 100, 10.5 + seed % 4, 3, 0, rng);
    mesh.add_sheet(0, 0, 12, 100, 12, 1, 0.2, rng);
    EXPECT_LE(*mesh.cover({400, 400, 300}), *alone);
    if (seed % 4 > 0) {
      EXPECT_EQ(*mesh.cover({400, 400, 300}), *alone);
    }
  }
}

TEST(CellCover, FacetsOfBodiesThatTouch) {
  Mesh mesh;
  const auto a = mesh.add_vertex(0, 0, 1), b = mesh.add_vertex(1000, 0, 1), c = mesh.add_vertex(1000, 1000, 1),
             d = mesh.add_vertex(0, 1000, 1);
  const auto a2 = mesh.add_vertex(0, 0, 1), c2 = mesh.add_vertex(1000, 1000, 1);
  mesh.add_facet(a, b, c);
  mesh.add_facet(a2, c2, d);
  EXPECT_FALSE(mesh.cover({400, 400, 200}).has_value()) << "nothing says that the sides are one";
  mesh.scene.first_at_place = {a, b, c, d, a, c};
  EXPECT_NEAR(mesh.cover({400, 400, 200}).value(), 1, 1e-5);
}

/// Whatever is taken for covered is covered, and whatever is taken for hidden lies behind the nearest facet.
TEST(CellCover, HoldsAtAllPoints) {
  std::mt19937 rng(2);
  std::uniform_real_distribution<double> unit(0, 1);
  int covered = 0, hidden = 0;
  for (int round = 0; round < 120; ++round) {
    Mesh mesh;
    for (int sheet = 0; sheet < 3; ++sheet) {
      const int spacing = 40 << static_cast<int>(unit(rng) * 4);
      mesh.add_sheet(-200, -200, 1600 / spacing + 1, spacing, 3 * unit(rng), round % 3, 0.3 * unit(rng) * unit(rng), rng);
    }
    const CellSquare cell{600 * unit(rng), 600 * unit(rng), 50 + 200 * unit(rng)};
    CellCover cover(mesh.scene, mesh.facets, kMargin);
    const std::vector<CellFacet> sorted = mesh.by_depth();
    const auto depth = cover.find(sorted.data(), sorted.size(), cell, kAnyFacet);
    if (!depth) continue;
    ++covered;
    std::vector<std::uint32_t> behind;
    for (const CellFacet& c : mesh.list)
      if (cover.hides(mesh.facets[c.facet])) behind.push_back(c.facet);
    hidden += static_cast<int>(behind.size());
    for (int k = 0; k < 100; ++k) {
      const double x = cell.x + unit(rng) * cell.size, y = cell.y + unit(rng) * cell.size;
      const double nearest = mesh.nearest_depth(x, y);
      ASSERT_LE(nearest, *depth) << round;
      for (const std::uint32_t f : behind) {
        if (!mesh.contains(mesh.facets[f], x, y)) continue;
        ASSERT_GT(FacetFunctions(mesh.facets[f], mesh.vertices.data()).depth(x, y), nearest) << round;
      }
    }
  }
  EXPECT_GT(covered, 20);
  EXPECT_GT(hidden, 50);
}

}  // namespace
}  // namespace ligne
