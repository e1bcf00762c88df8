/// Creases of free forms: whole rings of rims, whole ends of cut tubes, rims of bevels, and nothing inside roundings.

#include "patches/found_creases.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// The part of triangles below a plane, closed by a polygon for each loop of the cut.
std::vector<Corners> cut(const std::vector<Corners>& triangles, const Point3& normal, double most) {
  std::vector<Corners> kept;
  std::vector<std::array<Point3, 2>> sides;  // of the cut, against the direction of the triangles
  const auto crossing = [&](Point3 a, Point3 b) {
    if (std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z)) std::swap(a, b);  // alike from both of its triangles
    const double from = glm::dot(a, normal) - most, to = glm::dot(b, normal) - most;
    return a + from / (from - to) * (b - a);
  };
  for (const Corners& triangle : triangles) {
    Corners rest;
    std::array<Point3, 2> side;
    bool is_cut = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &a = triangle[k], &b = triangle[(k + 1) % 3];
      const bool from = glm::dot(a, normal) <= most, to = glm::dot(b, normal) <= most;
      if (from) rest.push_back(a);
      if (from == to) continue;
      rest.push_back(crossing(a, b));
      side[from ? 1 : 0] = rest.back();
      is_cut = true;
    }
    if (rest.size() > 2) kept.push_back(rest);
    if (is_cut) sides.push_back(side);
  }
  while (!sides.empty()) {
    Corners loop{sides.back()[0], sides.back()[1]};
    sides.pop_back();
    while (loop.front() != loop.back()) {
      const auto next = std::ranges::find_if(sides, [&](const auto& side) { return side[0] == loop.back(); });
      if (next == sides.end()) break;
      loop.push_back((*next)[1]);
      sides.erase(next);
    }
    loop.pop_back();
    if (loop.size() > 2) kept.push_back(loop);
  }
  return kept;
}

/// A coil of wire about z, of so many sides and steps a turn.
std::vector<Corners> coil(double turns, int sides, int steps) {
  constexpr double kRadius = 10, kWire = 2, kPitch = 6;
  const auto at = [&](int side, int step) {
    const double angle = 2 * kPi * step / steps, around = 2 * kPi * (side % sides) / sides;
    const Point3 out(std::cos(angle), std::sin(angle), 0);
    const Point3 along = glm::normalize(Point3(-kRadius * out.y, kRadius * out.x, kPitch / (2 * kPi)));
    const Point3 middle = kRadius * out + Point3(0, 0, kPitch * step / steps);
    return middle + kWire * (std::cos(around) * out + std::sin(around) * glm::cross(along, out));
  };
  const int rows = static_cast<int>(turns * steps);
  std::vector<Corners> polygons;
  add_grid(polygons, sides, rows, true, [&](int u, int v) { return at(u, v); });
  for (Corners& polygon : polygons) std::ranges::reverse(polygon);
  for (int k = 2; k < sides; ++k) {
    polygons.push_back({at(0, 0), at(k - 1, 0), at(k, 0)});
    polygons.push_back({at(0, rows), at(k, rows), at(k - 1, rows)});
  }
  return polygons;
}

TEST(WholeRings, OfARimBetween18And34Degrees) {
  constexpr int kSides = 96;
  const std::array<std::array<double, 3>, 3> rings{{{24, 18, 0}, {24, 18, 6}, {23, 16, 9}}};
  std::vector<Corners> polygons;
  const auto at = [&](int k, int ring) {
    const double angle = 2 * kPi * (k % kSides) / kSides;
    const auto& [a, b, z] = rings[static_cast<std::size_t>(ring)];
    return Point3(a * std::cos(angle), b * std::sin(angle), z);
  };
  add_grid(polygons, kSides, 2, true, at);
  Corners bottom, top;
  for (int k = 0; k < kSides; ++k) {
    top.push_back(at(k, 2));
    bottom.insert(bottom.begin(), at(k, 0));
  }
  polygons.push_back(bottom);
  polygons.push_back(top);
  const FoundCreases found(polygons);
  std::array<std::size_t, 3> counts{};
  for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
    const double from = found.end(e, false).z, to = found.end(e, true).z;
    if (!found.is_crease(e)) continue;
    ASSERT_EQ(from, to) << "a crease across the wall";
    ++counts[from == 0 ? 0 : from == 6 ? 1 : 2];
  }
  for (const std::size_t count : counts) EXPECT_EQ(count, std::size_t{kSides});
}

TEST(WholeRings, OfTheEndsOfACutCoil) {
  struct Cut {
    Point3 normal;
    double most;
    double least_drawn, most_inside;  ///< as parts of the length of the ends
  };
  // Along the axis the plane cuts obliquely, and few-sided pieces of facets beside the cut count as planes.
  for (const Cut& plane :
       {Cut{{1, 0, 0}, 3, 1, 0}, Cut{{0, 0, 1}, 18.3, 0.99, 0.06}, Cut{glm::normalize(Point3(1, 0.4, 0.2)), 4, 1, 0.03}}) {
    const Point3& normal = plane.normal;
    const double most = plane.most;
    SCOPED_TRACE(std::to_string(normal.x) + ", " + std::to_string(normal.y) + ", " + std::to_string(normal.z));
    const FoundCreases found(cut(coil(4, 16, 32), normal, most));
    const auto is_on_cut = [&](std::size_t e) {
      return std::abs(glm::dot(found.end(e, false), normal) - most) < 1e-5 &&
             std::abs(glm::dot(found.end(e, true), normal) - most) < 1e-5;
    };
    double whole = 0, drawn = 0, inside = 0;  // lengths: of the ends, of their creases, and of others
    for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
      const Edge& edge = found.topology.edges[e];
      ASSERT_NE(edge.face1, kNone);
      const double bend = glm::dot(face_normal(found.scene, edge.face0), face_normal(found.scene, edge.face1));
      const double length = glm::distance(found.end(e, false), found.end(e, true));
      if (is_on_cut(e) && bend < 0.999) {
        whole += length;
        if (found.is_crease(e)) drawn += length;
      } else if (bend > 0.8 && found.is_crease(e)) {
        inside += length;
      }
    }
    EXPECT_GT(whole, 40);
    EXPECT_GE(drawn, plane.least_drawn * whole);
    EXPECT_LE(inside, plane.most_inside * whole);
  }
}

/// A coarse bevel: two wide sides at an angle of 110 degrees, with four narrow strips between them. It bends along the five
/// rulings, most along the middle one: by middle_degrees(y) there, and evenly along the others. At y = 0 a wall closes it,
/// at an angle of 90 degrees.
std::vector<Corners> bevel(const std::function<double(double)>& middle_degrees) {
  constexpr int kLength = 24, kRulings = 5;
  constexpr double kTotalDegrees = 110, kSide = 12, kStrip = 2;
  const auto profile = [&](int y) {
    std::vector<Point3> points{{-kSide, y, 0}, {0, y, 0}};
    double direction = 0;  // degrees
    for (int k = 0; k < kRulings; ++k) {
      direction += k == kRulings / 2 ? middle_degrees(y) : (kTotalDegrees - middle_degrees(y)) / (kRulings - 1);
      const double width = k + 1 == kRulings ? kSide : kStrip, angle = direction * kPi / 180;
      points.push_back(points.back() + width * Point3(std::cos(angle), 0, -std::sin(angle)));
    }
    return points;
  };
  std::vector<Corners> polygons;
  add_grid(polygons, kRulings + 1, kLength, true, [&](int k, int y) { return profile(y)[static_cast<std::size_t>(k)]; });
  Corners wall = profile(0);
  wall.push_back({-kSide, 0, wall.back().z});
  polygons.push_back(wall);
  return polygons;
}

/// The length of the creases along the middle ruling of a bevel, which lies between these places on the x axis.
double middle_crease(const FoundCreases& found) {
  constexpr double kLow = 3, kHigh = 3.7;
  double length = 0;
  for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
    const Point3 &a = found.end(e, false), &b = found.end(e, true);
    const bool is_on_ruling = a.y != b.y && std::min(a.x, b.x) > kLow && std::max(a.x, b.x) < kHigh;
    if (is_on_ruling && found.is_crease(e)) length += glm::distance(a, b);
  }
  return length;
}

TEST(WholeRings, OfABevelKeepARimThatLeadsToAnotherCrease) {
  // The rim begins at the wall, and fades halfway.
  const FoundCreases found(bevel([](double y) { return 44 - y; }));
  EXPECT_NEAR(middle_crease(found), 12, 1.5);
}

TEST(WholeRings, OfABevelHaveNoLineThatMeetsNoOther) {
  const FoundCreases found(bevel([](double y) { return 42 - (y - 12) * (y - 12) / 4; }));
  EXPECT_EQ(middle_crease(found), 0);
}

TEST(WholeRings, NoneInsideACoarseEllipsoid) {
  std::vector<Corners> polygons;
  const auto at = [](int k, int ring) {
    const double down = kPi * ring / 12, around = 2 * kPi * (k % 24) / 24;
    const double out = ring % 12 == 0 ? 0 : std::sin(down);
    return Point3(16 * out * std::cos(around), 10 * out * std::sin(around), 7 * std::cos(down));
  };
  add_grid(polygons, 24, 12, true, at);
  std::erase_if(polygons, [](const Corners& c) {
    return glm::distance(c[0], c[1]) < 1e-9 || glm::distance(c[1], c[2]) < 1e-9 || glm::distance(c[2], c[0]) < 1e-9;
  });
  const FoundCreases found(outward(polygons));
  for (std::size_t e = 0; e < found.topology.edges.size(); ++e) EXPECT_FALSE(found.is_crease(e)) << e;
}

}  // namespace
}  // namespace ligne::test
