// Facets seen along lines, against every facet at many places.

#include "visibility/edges/nearest_along.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

struct Facing {
  std::vector<ProjectedVertex> vertices;
  std::vector<Facet> facets;

  void add(LatticePoint a, LatticePoint b, LatticePoint c, double z) {
    if (orientation(a, b, c) == 0) return;
    if (orientation(a, b, c) < 0) std::swap(b, c);
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const LatticePoint p : {a, b, c}) vertices.push_back({p, z});
    facets.push_back({{first, first + 1, first + 2},
                      static_cast<std::uint32_t>(facets.size()),
                      static_cast<float>(z),
                      static_cast<float>(z),
                      0,
                      0});
  }
  std::uint32_t nearest(double x, double y) const {
    std::uint32_t found = kNone;
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      bool inside = true;
      for (int i = 0; i < 3; ++i) {
        const LatticePoint a = vertices[facets[f].v[i]].p, b = vertices[facets[f].v[(i + 1) % 3]].p;
        inside = inside && (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x) >= 0;
      }
      if (inside && (found == kNone || facets[f].z_near < facets[found].z_near)) found = f;
    }
    return found;
  }
};

TEST(NearestAlong, IsWhatAPlainSearchFinds) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&](int most) { return static_cast<std::int32_t>(random() % static_cast<unsigned>(most)); };
    Facing scene;
    for (int i = 0; i < 60; ++i) {
      const int size = i % 10 == 0 ? 60'000 : 9'000;  // a few cover whole lines
      const LatticePoint at{number(40'000) - 20'000, number(40'000) - 20'000};
      const auto corner = [&] { return LatticePoint{at.x + number(size) - size / 2, at.y + number(size) - size / 2}; };
      scene.add(corner(), corner(), corner(), i);
    }
    std::vector<LineOnPage> lines;
    for (int i = 0; i < 40; ++i) {
      const LatticePoint from{number(40'000) - 20'000, number(40'000) - 20'000};
      lines.push_back({from, {from.x + number(12'000) - 6'000, from.y + number(12'000) - 6'000}});
    }
    const auto all = nearest_along(scene.vertices, scene.facets, lines, false);
    const auto any = nearest_along(scene.vertices, scene.facets, lines, true);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const auto* seen : {&all[i], &any[i]}) {
        double end = 0;
        for (const SeenStretch& s : *seen) {
          EXPECT_EQ(s.from, end);
          end = s.to;
          const double t = (s.from + s.to) / 2;
          const std::uint32_t nearest = scene.nearest(lines[i][0].x + t * (double(lines[i][1].x) - lines[i][0].x),
                                                      lines[i][0].y + t * (double(lines[i][1].y) - lines[i][0].y));
          if (seen == &all[i])
            EXPECT_EQ(s.facet, nearest) << seed << ' ' << i;
          else
            EXPECT_EQ(s.facet == kNone, nearest == kNone) << seed << ' ' << i;
        }
        EXPECT_EQ(end, 1);
      }
    }
  }
}

TEST(NearestAlong, ShowsNoSheetBetweenNeighbours) {
  Facing scene;
  scene.add({0, 0}, {1000, 7}, {333, 1000}, 1);
  scene.add({1000, 7}, {333, 1000}, {1200, 1300}, 1);
  const auto seen = nearest_along(scene.vertices, scene.facets, {{LatticePoint{300, 300}, LatticePoint{1000, 1000}}}, true);
  ASSERT_EQ(seen[0].size(), 1u);
  EXPECT_NE(seen[0][0].facet, kNone);
  EXPECT_TRUE(nearest_along(scene.vertices, scene.facets, {}, true).empty());
  const auto none = nearest_along(scene.vertices, {}, {{LatticePoint{0, 0}, LatticePoint{5, 5}}}, true);
  ASSERT_EQ(none[0].size(), 1u);
  EXPECT_EQ(none[0][0].facet, kNone);
}

}  // namespace
}  // namespace ligne::test
