// The method against a plain search: every line against every triangle, with no grid, no covers and no early outs, in long
// double arithmetic on the projected scene. What is compared is the visible length of every edge.

#include "main/tier.hpp"
#include "support/scenes.hpp"
#include "support/test.hpp"
#include "visibility/edges/nearest_along.hpp"

namespace ligne::test {
namespace {

/// Visible share of every candidate edge by sampling the middles of all intervals between crossings: at each of them all
/// triangles are asked. Returns {surely visible, surely hidden} shares; the rest is within the tolerances.
std::pair<double, double> shares(const ProjectedScene& scene, const ProjectedEdge& edge) {
  using Real = long double;
  const ProjectedVertex &a = scene.vertices[edge.v0], &b = scene.vertices[edge.v1];
  std::vector<Real> cuts{0, 1};
  // Sides of other faces that rounding has put beside this line, not on it. Such a line is seen in the crack between them,
  // where it is one with the sides themselves.
  std::vector<std::pair<Real, Real>> cracks;
  struct Corner {
    Real x, y, z;
  };
  struct Plane {
    Corner c[3];
    Real area, gx, gy;  // of the depth
  };
  const auto plane = [&](const Triangle& t) {
    Plane p;
    for (int i = 0; i < 3; ++i) {
      const ProjectedVertex& v = scene.vertices[t.v[i]];
      p.c[i] = {Real(v.p.x), Real(v.p.y), Real(v.z)};
    }
    const auto& c = p.c;
    p.area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
    p.gx = ((c[1].z - c[0].z) * (c[2].y - c[0].y) - (c[2].z - c[0].z) * (c[1].y - c[0].y)) / p.area;
    p.gy = ((c[2].z - c[0].z) * (c[1].x - c[0].x) - (c[1].z - c[0].z) * (c[2].x - c[0].x)) / p.area;
    return p;
  };
  const Real dx = Real(b.p.x) - a.p.x, dy = Real(b.p.y) - a.p.y, dz = Real(b.z) - a.z;
  for (const Triangle& t : scene.triangles) {
    const auto [c, area, gx, gy] = plane(t);
    for (int i = 0; i < 3; ++i) {
      const Corner &p = c[i], &q = c[(i + 1) % 3];
      const Real e0 = (q.x - p.x) * (a.p.y - p.y) - (q.y - p.y) * (a.p.x - p.x);
      const Real e1 = (q.x - p.x) * (b.p.y - p.y) - (q.y - p.y) * (b.p.x - p.x);
      if (e0 != e1 && e0 / (e0 - e1) > 0 && e0 / (e0 - e1) < 1) cuts.push_back(e0 / (e0 - e1));
      const Real length2 = dx * dx + dy * dy, limit = 4 * std::sqrt(length2);
      const auto off = [&](const Corner& v) { return std::abs(dx * (v.y - a.p.y) - dy * (v.x - a.p.x)); };
      const auto along = [&](const Corner& v) { return (dx * (v.x - a.p.x) + dy * (v.y - a.p.y)) / length2; };
      if (off(p) <= limit && off(q) <= limit && off(p) + off(q) > 0) {
        cracks.emplace_back(std::min(along(p), along(q)), std::max(along(p), along(q)));
        for (const Real t : {along(p), along(q)})
          if (t > 0 && t < 1) cuts.push_back(t);
      }
    }
    if (area == 0) continue;
    const Real d0 = a.z - (c[0].z + gx * (a.p.x - c[0].x) + gy * (a.p.y - c[0].y));
    const Real d1 = d0 + dz - gx * dx - gy * dy;
    if (d0 != d1 && d0 / (d0 - d1) > 0 && d0 / (d0 - d1) < 1) cuts.push_back(d0 / (d0 - d1));
  }
  std::sort(cuts.begin(), cuts.end());
  double visible = 0, hidden = 0;
  const Real step = std::sqrt(dx * dx + dy * dy);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Real t = (cuts[i] + cuts[i + 1]) / 2;
    // A point a little to the left and one a little to the right of the line: the line is hidden when both are.
    bool covered[2] = {false, false}, doubtful = false;
    const bool crack = std::any_of(cracks.begin(), cracks.end(), [&](const auto& c) { return c.first < t && t < c.second; });
    for (int side = 0; side < 2; ++side) {
      const Real off = side ? 8 : -8;  // steps
      const Real x = a.p.x + t * dx - off * dy / step, y = a.p.y + t * dy + off * dx / step, z = a.z + t * dz;
      for (const Triangle& tri : scene.triangles) {
        if (tri.face == edge.face0 || tri.face == edge.face1) continue;
        const auto [c, area, gx, gy] = plane(tri);
        if (area == 0) continue;
        Real w[3];
        bool inside = true;
        for (int k = 0; k < 3; ++k) {
          const Corner &p = c[(k + 1) % 3], &q = c[(k + 2) % 3];
          w[k] = ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x)) / area;
          if (w[k] < 0) inside = false;
        }
        if (!inside) continue;
        const Real behind = z - (w[0] * c[0].z + w[1] * c[1].z + w[2] * c[2].z);
        const Real touch = 32 * (std::abs(gx) + std::abs(gy)) + 4 * scene.input_error_mm;
        if (behind > touch) covered[side] = true;
        if (std::abs(behind) <= touch) doubtful = true;
      }
    }
    const double share = static_cast<double>(cuts[i + 1] - cuts[i]);
    if (covered[0] && covered[1] && !crack) hidden += share;
    if (!covered[0] && !covered[1] && !doubtful && !crack) visible += share;
  }
  return {visible, hidden};
}

void compare(const Scene& scene, const PictureRequest& request, const std::string& name) {
  const auto scale = request.scale > 0 ? std::optional(request.scale) : std::nullopt;
  const ProjectedScene projected = project_on_a4(scene, request.camera, "all", scale);
  const StrokeModel model = *find_method(request.method)->compute_visibility(projected, {}).strokes;
  std::map<std::uint32_t, double> drawn;
  for (const Stroke& s : model.strokes)
    if (s.source < projected.source_count && s.visible)
      drawn[s.source] += glm::length(model.lattice.to_mm(s.to) - model.lattice.to_mm(s.from));
  constexpr double kTolerance = 0.002;  // mm: a micrometre at each end
  double checked = 0, total = 0;
  for (const ProjectedEdge& edge : projected.edges) {
    const double length = glm::length(projected.lattice.to_mm(projected.vertices[edge.v1].p) -
                                      projected.lattice.to_mm(projected.vertices[edge.v0].p));
    if (length == 0) continue;
    const auto [visible, hidden] = shares(projected, edge);
    total += length;
    checked += (visible + hidden) * length;
    EXPECT_GE(drawn[edge.source], visible * length - kTolerance) << name << ", edge " << edge.source << " lacks a part";
    EXPECT_LE(drawn[edge.source], (1 - hidden) * length + kTolerance)
        << name << ", edge " << edge.source << " is drawn hidden";
  }
  EXPECT_GT(checked, 0.4 * total) << name;
}

TEST(BruteForce, RandomTriangles) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-10, 10);
    Scene scene;
    for (int i = 0; i < 12; ++i) {
      const Point3 c{u(random), u(random), u(random)};
      const auto near = [&] { return c + Point3{u(random), u(random), u(random)} * 0.6; };
      add_face(scene, {{near(), near(), near()}});
    }
    compare(scene, {along({0.2, 0.9, -0.4})}, "parallel, seed " + std::to_string(seed));
    compare(scene, {from_eye({5, -40, 22}, {0, 0, 0})}, "perspective, seed " + std::to_string(seed));
  }
}

TEST(BruteForce, TrianglesOnASmallIntegerGrid) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> u(0, 3);
    Scene scene;
    for (int i = 0; i < 10; ++i) {
      const auto corner = [&] { return Point3{double(u(random)), double(u(random)), double(u(random))}; };
      const Point3 a = corner(), b = corner(), c = corner();
      if (a == b || b == c || a == c) continue;
      add_face(scene, {{a, b, c}});
    }
    // Along y, at 32 mm by unit, all corners lie on the lattice exactly, and so do their coincidences.
    compare(scene, {along({0, 1, 0}), "all", false, 32}, "exact, seed " + std::to_string(seed));
    for (const Point3& direction : {Point3{-1, 1, -1}, Point3{0.3, 0.8, -0.5}, Point3{0, 1, -1}})
      compare(scene, {along(direction)}, "seed " + std::to_string(seed) + " along " + std::to_string(direction.z));
  }
}

TEST(BruteForce, PenetratingBoxes) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    if (!is_chosen("boxes that penetrate", seed, 3)) continue;
    const Scene scene = random_boxes(9, seed, 4, {3, 2, 2.5});
    compare(scene, {along({-1, 2, -1})}, "boxes, seed " + std::to_string(seed));
    compare(scene, {from_eye({3, -14, 9}, {0, 0, 0}, 50)}, "boxes in perspective, seed " + std::to_string(seed));
  }
}

// Facets seen along lines, against every facet at many places.

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
