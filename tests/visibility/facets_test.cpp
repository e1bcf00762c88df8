/// Facets: their tree, depths, covers of cells of the screen grid, and facets seen along lines.

#include "support/mesh_text.hpp"
#include "support/scenes.hpp"
#include "visibility/common/cell_cover.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/edges/nearest_along.hpp"
#include "visibility/penetration/facet_tree.hpp"
#include "visibility/penetration/intersections.hpp"
#include "visibility/penetration/joined_facets.hpp"
#include "visibility/penetration/parallel_extents.hpp"

namespace ligne::test {
namespace {

// Rounding of depths to float.

void expect_rounded(double v) {
  const float nearest = static_cast<float>(v);
  const float down = double(nearest) > v ? std::nextafter(nearest, -HUGE_VALF) : nearest;
  const float up = double(nearest) < v ? std::nextafter(nearest, HUGE_VALF) : nearest;
  EXPECT_EQ(std::bit_cast<std::uint32_t>(round_down(v)), std::bit_cast<std::uint32_t>(down)) << v;
  EXPECT_EQ(std::bit_cast<std::uint32_t>(round_up(v)), std::bit_cast<std::uint32_t>(up)) << v;
}

TEST(Facet, DepthsAreRoundedOutwards) {
  for (const double v : {0.0, 1.0, 1.1, 1e-40, 1e-50, 1.4e-45, 3.5e38, 1e300, 0x1p-126, 0x1.fffffffp-127}) {
    expect_rounded(v);
    expect_rounded(-v);
  }
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> exponent(-50, 40);
  for (int i = 0; i < 20'000; ++i) expect_rounded((i % 2 ? 1 : -1) * std::pow(10, exponent(random)));
}

// Covers of cells of the screen grid: patches of facets against points of the cell.

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
        const auto a = static_cast<std::uint32_t>(first + j * n + i), b = a + 1, c = a + static_cast<std::uint32_t>(n),
                   d = c + 1;
        const bool falls = unit(rng) < 0.5;
        add_facet(a, b, falls ? d : c);
        add_facet(falls ? a : b, d, c);
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
    std::ranges::stable_sort(sorted, {}, &CellFacet::z_near);
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

// Facets seen along lines, against every facet at many places.

TEST(NearestAlong, IsWhatAPlainSearchFinds) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&](int most) { return static_cast<std::int32_t>(random() % static_cast<unsigned>(most)); };
    Mesh mesh;
    for (int i = 0; i < 60; ++i) {
      const int size = i % 10 == 0 ? 60'000 : 9'000;  // a few cover whole lines
      const LatticePoint at{number(40'000) - 20'000, number(40'000) - 20'000};
      std::array<std::uint32_t, 3> v{};
      for (std::uint32_t& corner : v)
        corner = mesh.add_vertex(at.x + number(size) - size / 2, at.y + number(size) - size / 2, i);
      mesh.add_facet(v[0], v[1], v[2]);
    }
    std::vector<LineOnPage> lines;
    for (int i = 0; i < 40; ++i) {
      const LatticePoint from{number(40'000) - 20'000, number(40'000) - 20'000};
      lines.push_back({from, {from.x + number(12'000) - 6'000, from.y + number(12'000) - 6'000}});
    }
    const auto all = nearest_along(mesh.vertices, mesh.facets, lines, false);
    const auto any = nearest_along(mesh.vertices, mesh.facets, lines, true);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const auto* seen : {&all[i], &any[i]}) {
        double end = 0;
        for (const SeenStretch& s : *seen) {
          EXPECT_EQ(s.from, end);
          end = s.to;
          const double t = (s.from + s.to) / 2;
          const double nearest = mesh.nearest_depth(lines[i][0].x + t * (double(lines[i][1].x) - lines[i][0].x),
                                                    lines[i][0].y + t * (double(lines[i][1].y) - lines[i][0].y));
          EXPECT_EQ(s.facet == kNone, std::isinf(nearest)) << seed << ' ' << i;
          if (seen == &all[i] && s.facet != kNone) {
            EXPECT_EQ(mesh.facets[s.facet].z_near, std::round(nearest)) << seed << ' ' << i;
          }
        }
        EXPECT_EQ(end, 1);
      }
    }
  }
}

// The tree of facets tells apart what does not meet. That it reaches all that may meet shows in every line of penetration.

/// How many pairs of facets are in leaves below two nodes that may meet.
std::size_t pairs_below(const FacetTree& tree, std::uint32_t a, std::uint32_t b) {
  const FacetTree::Node &m = tree.node(a), &n = tree.node(b);
  if (a != b && !FacetTree::may_intersect(m, n)) return 0;
  if (a == b && m.face != kNone) return 0;
  if (tree.is_leaf(m) && tree.is_leaf(n)) {
    const std::size_t size = m.end - m.first;
    return a == b ? size * (size - 1) / 2 : size * (n.end - n.first);
  }
  const auto both = [&](std::uint32_t first, std::uint32_t second, std::uint32_t with) {
    return pairs_below(tree, first, with) + pairs_below(tree, second, with);
  };
  if (a == b) return both(m.children, m.children + 1, m.children + 1) + pairs_below(tree, m.children, m.children);
  return m.size() >= n.size() ? both(m.children, m.children + 1, b) : both(n.children, n.children + 1, a);
}

/// The skins of an onion, in the view along its axis: `n` halves of spheres of 8 x 16 cells, each cell of two facets.
std::size_t pairs_of_skins(int n) {
  std::string text = "exact";
  for (int skin = 0; skin < n; ++skin) {
    const std::string r = std::to_string(50 * (1 + double(skin) / n)), t = "pi/17*(v + 0.1)";
    text += "\nobject\ngrid 16 x 8 triangles round: " + r + "*sin(" + t + ")*cos(pi*u/8); " + r + "*sin(" + t +
            ")*sin(pi*u/8); " + r + "*cos(" + t + ")";
  }
  const Scene scene = mesh_of(text).scene();
  const ProjectedScene projected = project_on_a4(scene, along({0, 0, -1}));
  const FacetTree tree(projected, make_facets(projected, 1).facets);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < tree.roots().size(); ++i)
    for (std::size_t k = i; k < tree.roots().size(); ++k) pairs += pairs_below(tree, tree.roots()[i], tree.roots()[k]);
  return pairs;
}

TEST(FacetTree, TellsSkinsOfAnOnionApart) { EXPECT_LT(double(pairs_of_skins(64)), 2.7 * double(pairs_of_skins(32))); }

/// Where a facet lies across the diagonal of the page.
std::pair<double, double> across_diagonal(const PlacedFacet& f) {
  return std::minmax({f.y[0] - f.x[0], f.y[1] - f.x[1], f.y[2] - f.x[2]});
}

TEST(ParallelExtents, PartNeedlesAlongADiagonal) {
  std::vector<PlacedFacet> facets(200);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const double n = static_cast<double>(i), x = 37 * n, y = x + 5 * n, wide = i % 20 > 0 ? 2 : 300;
    facets[i].x = {x, x + 3000, x + wide}, facets[i].y = {y, y + 3000, y - wide};
  }
  std::vector<const PlacedFacet*> places;
  for (const PlacedFacet& f : facets) places.push_back(&f);
  ParallelExtents extents;
  ASSERT_TRUE(extents.set(places, {0, 0, 1000}, 0.5));
  std::vector<std::uint32_t> space;
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    const std::span<const std::uint32_t> others = extents.overlapping(i, 0, 200, space);
    EXPECT_LE(others.size(), i % 20 > 0 ? 24 : facets.size());
    const auto [from, to] = across_diagonal(facets[i]);
    for (std::uint32_t k = 0; k < facets.size(); ++k) {
      const auto [from_k, to_k] = across_diagonal(facets[k]);
      EXPECT_TRUE(from > to_k || from_k > to || std::ranges::count(others, k) == 1);
    }
  }
}

// Two rough sheets that cross in many places. Their corners move aside by up to `fold` squares.
TEST(JoinedFacets, HideNoPenetration) {
  // Two rough sheets that turn in one sense, and two smooth ones that turn in both.
  const std::string turned = "grid 24 x 24 triangles: u; v; 0\nobject\ngrid 24 x 24 triangles: v; u; 0.1*(v - 12.5)";
  for (const std::string fold : {"0", "0.2", "0.6", "1.5", "turned"}) {
    const std::string sheet =
        "grid 24 x 24 triangles: u + " + fold + "*sin(37*u + 91*v); v + " + fold + "*sin(53*u + 11*v); ";
    const std::string rough = "0.3*sin(71*u + 43*v)";
    const std::string alike = sheet + rough + "\nobject\n" + sheet + "0.1*(u - 12) - " + rough;
    const Scene scene = mesh_of(fold == "turned" ? turned : alike).scene();
    const ProjectedScene projected = project_on_a4(scene, along({0.1, 0.2, -1}));
    const std::vector<Facet> facets = make_facets(projected, 1).facets;
    const CellGrid grid(projected, facets, {.margin_steps = 2});
    const std::vector<std::uint8_t> joined = joined_facets(projected, build_topology(scene), facets);
    const auto all = find_intersections(projected, facets, grid, 2);
    const auto found = find_intersections(projected, facets, grid, 2, joined);
    EXPECT_GT(all.size(), 40u);
    ASSERT_EQ(all.size(), found.size()) << fold;
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].from.p, found[i].from.p);
    EXPECT_GT(std::ranges::count_if(joined, [](std::uint8_t sense) { return sense != 0; }), 50) << fold;
  }
}

}  // namespace
}  // namespace ligne::test
