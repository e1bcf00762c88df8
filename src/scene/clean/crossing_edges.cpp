// Candidates are the edges at vertices that several objects share, or at which more faces meet than in one sheet. Their
// sides (an edge of a triangle, and the direction in which the triangle leaves it) are sorted by edge. At each edge the
// sides of an object are combined into sheets, and the sheets are compared.

#include "scene/clean/crossing_edges.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include "scene/clean/weld.hpp"

namespace ligne {
namespace {

/// Number of triangles at an inner vertex of a grid whose cells are cut by parallel diagonals.
constexpr std::uint8_t kTrianglesOfOneSheet = 6;

/// An edge of a triangle.
struct Side {
  std::uint32_t v0, v1;  ///< places (one vertex stands for all at a position), in ascending order
  std::uint32_t object;
  std::uint32_t corner;  ///< of the triangle, where the edge begins
  auto key() const { return std::tie(v0, v1); }
};

/// The direction in which a triangle leaves the edge, as an angle around it.
struct Direction {
  double angle;      ///< radians, in [-pi, pi]
  double tolerance;  ///< angle by which the error of the positions can turn it, in radians
};

struct Sheet {
  Direction a, b;
};

/// Angle from one direction to the other, in [0, 2 pi).
double turn(const Direction& from, const Direction& to) {
  const double angle = to.angle - from.angle;
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

bool equal(const Direction& a, const Direction& b) {
  const double angle = turn(a, b);
  return std::min(angle, 2 * std::numbers::pi - angle) <= a.tolerance + b.tolerance;
}

bool sheets_cross(const Sheet& s, const Sheet& t) {
  if (equal(s.a, t.a) || equal(s.a, t.b) || equal(s.b, t.a) || equal(s.b, t.b)) return false;
  const double end = turn(s.a, s.b);
  return (turn(s.a, t.a) < end) != (turn(s.a, t.b) < end);
}

/// Angle by which a sheet is bent, in radians; 0 if it is straight.
double bend(const Sheet& s) { return std::abs(turn(s.a, s.b) - std::numbers::pi); }

/// Adds the sheets of one object at an edge. Two directions make one sheet, and four make the two straightest sheets.
/// Coincident sheets count once. A single direction is a border, which crosses nothing. Other numbers of directions are
/// ambiguous and give no sheet.
void add_sheets(std::vector<Direction>& directions, std::vector<Sheet>& sheets) {
  std::ranges::sort(directions, [](const Direction& l, const Direction& r) { return l.angle < r.angle; });
  directions.erase(std::unique(directions.begin(), directions.end(), equal), directions.end());
  if (directions.size() > 1 && equal(directions.front(), directions.back())) directions.pop_back();
  const auto& d = directions;
  if (d.size() == 2) sheets.push_back({d[0], d[1]});
  if (d.size() != 4) return;
  const std::array<std::array<Sheet, 2>, 3> pairings{
      {{{{d[0], d[2]}, {d[1], d[3]}}}, {{{d[0], d[1]}, {d[2], d[3]}}}, {{{d[0], d[3]}, {d[1], d[2]}}}}};
  const auto& best = *std::ranges::min_element(
      pairings, [](const auto& l, const auto& r) { return bend(l[0]) + bend(l[1]) < bend(r[0]) + bend(r[1]); });
  sheets.insert(sheets.end(), best.begin(), best.end());
}

class CrossingSearch {
 public:
  CrossingSearch(Scene& scene, double distance) : scene_(scene), distance_(distance) { find_places(); }

  void run() {
    std::vector<Side> sides = candidates();
    std::ranges::sort(sides, [](const Side& l, const Side& r) {
      return std::tie(l.v0, l.v1, l.object, l.corner) < std::tie(r.v0, r.v1, r.object, r.corner);
    });
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].key() == sides[i].key()) ++end;
      if (end - i >= 4) judge({sides.data() + i, sides.data() + end});
      i = end;
    }
  }

 private:
  /// Sets place_[v], the vertex that stands for all at the position of v, and busy_[v]: sheets may cross at this place.
  void find_places() {
    const std::size_t n = scene_.vertices.size();
    Scene all;
    all.vertices = scene_.vertices;
    all.objects.emplace_back().vertex_end = static_cast<std::uint32_t>(n);
    if (distance_ > 0) weld_near_vertices(all, distance_);
    place_ = weld_vertices(all).first;
    std::vector<std::uint8_t> triangles(n, 0);
    busy_.assign(n, false);
    for (std::uint32_t v = 0; v < n; ++v) {
      if (place_[v] != v) busy_[place_[v]] = true;
    }
    for (const std::uint32_t v : scene_.faces.corners()) {
      std::uint8_t& count = triangles[place_[v]];
      if (count <= kTrianglesOfOneSheet) ++count;
      if (count > kTrianglesOfOneSheet) busy_[place_[v]] = true;
    }
  }

  std::vector<Side> candidates() const {
    std::vector<Side> sides;
    for (std::uint32_t o = 0; o < scene_.objects.size(); ++o) {
      for (std::uint32_t corner = 3 * scene_.objects[o].face_begin; corner < 3 * scene_.objects[o].face_end; ++corner) {
        const auto [v0, v1] = std::minmax(place_[at(corner)], place_[at(next(corner))]);
        if (v0 != v1 && (busy_[v0] || busy_[v1])) sides.push_back({v0, v1, o, corner});
      }
    }
    return sides;
  }

  std::uint32_t at(std::uint32_t corner) const { return scene_.faces.corners()[corner]; }
  static std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  void judge(std::span<const Side> sides) {
    const Point3 from = scene_.vertices[sides[0].v0], along = glm::normalize(scene_.vertices[sides[0].v1] - from);
    // The two axes across the edge: the model axis least parallel to the edge, and the remaining one.
    int least = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (std::abs(along[axis]) < std::abs(along[least])) least = axis;
    }
    Point3 axis_of_model{0, 0, 0};
    axis_of_model[least] = 1;
    const Point3 first = glm::normalize(glm::cross(along, axis_of_model)), second = glm::cross(along, first);

    sheets_.clear();
    directions_.clear();
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (i > 0 && sides[i].object != sides[i - 1].object) {
        add_sheets(directions_, sheets_);
        directions_.clear();
      }
      const Point3 out = scene_.vertices[at(next(next(sides[i].corner)))] - from;
      const double x = glm::dot(out, first), y = glm::dot(out, second), height = std::hypot(x, y);
      // Both the edge and the far corner may be wrong by the distance.
      if (height > 2 * distance_) directions_.push_back({std::atan2(y, x), 2 * distance_ / height});
    }
    add_sheets(directions_, sheets_);
    bool crosses = false;
    for (std::size_t i = 0; i < sheets_.size() && !crosses; ++i) {
      for (std::size_t k = i + 1; k < sheets_.size() && !crosses; ++k) crosses = sheets_cross(sheets_[i], sheets_[k]);
    }
    if (!crosses) return;
    scene_.corner_flags.resize(scene_.faces.corners().size(), 0);
    for (const Side& side : sides) scene_.corner_flags[side.corner] |= kCornerCrossing;
  }

  Scene& scene_;
  double distance_;
  std::vector<std::uint32_t> place_;
  std::vector<bool> busy_;
  std::vector<Sheet> sheets_;          ///< scratch
  std::vector<Direction> directions_;  ///< scratch
};

}  // namespace

void mark_crossing_edges(Scene& scene, double distance) {
  assert(scene.faces.all_triangles());
  if (!scene.faces.empty()) CrossingSearch(scene, distance).run();
}

}  // namespace ligne
