/// Coil springs that a plane cuts have creases at the cut and at their ends alone, whichever pieces of facets it leaves.

#include "patches/found_creases.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// A wire of radius 2 wound about z by four turns, with a radius of 10 and a pitch of 6.
std::vector<Corners> spring(int facets, int sides, bool triangles) {
  const auto at = [&](int u, int v) {
    const double angle = 2 * kPi * v / facets, around = 2 * kPi * (u % sides) / sides;
    const Point3 along = glm::normalize(Point3(-10 * std::sin(angle), 10 * std::cos(angle), 3 / kPi));
    const Point3 out = on_circle(1, angle), up = glm::cross(along, out);
    return on_circle(10, angle, 6.0 * v / facets) + 2.0 * (std::cos(around) * out + std::sin(around) * up);
  };
  std::vector<Corners> polygons;
  add_grid(polygons, sides, 4 * facets, triangles, at);
  Corners first, last;
  for (int u = 0; u < sides; ++u) {
    first.push_back(at(u, 0));
    last.push_back(at(sides - u, 4 * facets));
  }
  polygons.push_back(first);
  polygons.push_back(last);
  return polygons;
}

/// The parts of polygons below a plane at `height` along `up`, closed by polygons in this plane.
std::vector<Corners> below(const std::vector<Corners>& polygons, const Point3& up, double height) {
  using Key = std::array<double, 3>;
  const auto key = [](const Point3& p) { return Key{p.x, p.y, p.z}; };
  const auto over = [&](const Point3& p) { return glm::dot(p, up) - height; };
  std::vector<Corners> kept;
  std::map<Key, Point3> next;  // along the border of the cut
  for (const Corners& polygon : polygons) {
    Corners part, ends(2);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      Point3 a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
      const bool is_up = over(a) < over(b);
      if (over(a) <= 0) part.push_back(a);
      if ((over(a) < 0) == (over(b) < 0)) continue;
      if (is_up) std::swap(a, b);  // both faces of an edge get one corner
      ends[is_up] = a + over(a) / (over(a) - over(b)) * (b - a);
      part.push_back(ends[is_up]);
    }
    if (part.size() < 3) continue;
    kept.push_back(part);
    if (ends[0] != ends[1]) next[key(ends[0])] = ends[1];
  }
  while (!next.empty()) {
    Corners cut;
    for (auto at = next.begin(); at != next.end(); at = next.find(key(cut.back()))) {
      cut.push_back(at->second);
      next.erase(at);
    }
    kept.push_back(cut);
  }
  return kept;
}

class CutSprings : public testing::TestWithParam<Point3> {};

TEST_P(CutSprings, HaveCreasesAtTheCutAlone) {
  const Point3 up = glm::normalize(GetParam());
  const double height = up.z > 0.9 ? 14 : 3;
  for (const auto& [facets, sides] : {std::pair{48, 16}, {72, 24}}) {
    for (const bool triangles : {false, true}) {
      SCOPED_TRACE(testing::Message() << sides << (triangles ? " triangles" : " quadrilaterals"));
      const FoundCreases found(below(spring(facets, sides, triangles), up, height));
      for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
        if (!found.is_crease(e)) continue;
        const Point3 middle = 0.5 * (found.end(e, false) + found.end(e, true));
        const bool is_at_end = std::abs(middle.y) < 0.6 && middle.x > 7 && (middle.z < 3 || middle.z > 21);
        const bool is_at_cut = std::max(std::abs(glm::dot(found.end(e, false), up) - height),
                                        std::abs(glm::dot(found.end(e, true), up) - height)) < 1e-4;
        EXPECT_TRUE(is_at_end || is_at_cut) << middle.x << ' ' << middle.y << ' ' << middle.z;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Directions, CutSprings,
                         testing::Values(Point3(1, 0, 0), Point3(0, 1, 0), Point3(1, 1, 0), Point3(1, 1, 1),
                                         Point3(1, 0.4, 0.3), Point3(0.3, 1, -0.5), Point3(0, 0.2, 1),
                                         Point3(0.8, -0.6, 0.1)));

TEST(CutSpring, HasWholeCreasesAtItsCut) {
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
    const FoundCreases found(below(spring(32, 16, true), normal, most));
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

}  // namespace
}  // namespace ligne::test
